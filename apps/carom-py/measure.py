"""How fast the package is beside the command and beside a loop of Rust, in one run; and how much memory it takes."""

from __future__ import annotations

import os
import resource
import subprocess
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import carom
import numpy as np

ROOT = Path(__file__).parents[2]
RELEASE = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "release"
CASE = str(ROOT / "examples/case_2.toml")


def least(work: Callable[[], object], times: int = 5) -> float:
    """The least time of several [s]."""
    taken = []
    for _ in range(times):
        begun = time.perf_counter()
        work()
        taken.append(time.perf_counter() - begun)
    return min(taken)


def drops() -> None:
    """10⁵ drops in one call, beside a sweep of the same designs by the command."""
    frictions = np.linspace(0.01, 0.17, 100_000)
    with tempfile.TemporaryDirectory() as folder:
        designs = Path(folder) / "designs.csv"
        designs.write_text("contact.friction\n" + "\n".join(map(repr, frictions.tolist())) + "\n")

        def sweep() -> None:
            words = ["sweep", CASE, "--list", str(designs), "--out", folder, "--force"]
            subprocess.run([RELEASE / "carom", *words], check=True, capture_output=True)

        command = least(sweep, 3)
    own = least(lambda: carom.drops(CASE, {"contact.friction": frictions}), 3)
    print(f"measured: 100000 drops in one call {own:.2f} s, by the command's sweep {command:.2f} s: {own / command:.2f} times")


def impacts() -> None:
    """10⁶ impacts in one call, beside a loop of Rust."""
    i = np.arange(1_000_000)

    def between(low: float, high: float, k: int) -> np.ndarray:
        return low + (high - low) * (((i * k + 1) * 0.618_033_988_749_894_9) % 1.0)

    given = {
        "mass": between(0.1, 5.0, 3),
        "inertia": between(0.05, 2.0, 5),
        "arm": np.stack([between(-1.0, 1.0, 7), between(-1.0, 0.0, 11)], axis=1),
        "friction": between(0.0, 1.5, 13),
        "restitution": between(0.0, 1.0, 17),
        "velocity": np.stack([between(-3.0, 3.0, 19), between(-3.0, -1.0, 23)], axis=1),
        "spin": between(-1.0, 1.0, 29),
    }
    own = least(lambda: carom.impacts(**given), 15)
    said = subprocess.run([RELEASE / "examples/impacts"], check=True, capture_output=True, text=True).stdout.split()
    loop, struck = float(said[0]), int(said[1])
    assert int((carom.impacts(**given)["normal_impulse_N_s"] > 0).sum()) == struck, "the same impacts"
    print(f"measured: 1000000 impacts in one call {own:.3f} s, in a loop of Rust {loop:.3f} s: {own / loop:.2f} times")


def memory() -> None:
    """Calls one after another take no more than the first ones."""
    columns = {"contact.friction": np.linspace(0.01, 0.17, 20_000)}
    peak = lambda: resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024  # noqa: E731
    for _ in range(3):
        carom.drops(CASE, columns)
    before = peak()
    for _ in range(20):
        carom.drops(CASE, columns)
    print(f"measured: peak memory {before:.0f} MB after 3 calls of 20000 drops, {peak():.0f} MB after 23")


if __name__ == "__main__":
    drops()
    impacts()
    memory()

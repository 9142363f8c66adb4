"""Every derived formula beside the engine: how far they differ at 10⁴ random impacts each (or as many as are asked for).

``python apps/carom-py/measure_derive.py [DRAWS] [WORD]``: only formulas whose name begins with the word.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from typing import Any

import carom
import numpy as np
from carom.symbolic.check import against_engine, all_found
from carom.symbolic.derivation import Derivation
from carom.symbolic.paper import cylinder, prism, rod, space

Draw = Callable[[np.random.Generator, int], dict[str, Any]]
#: Masses, lengths and speeds that every paper problem draws.
SIZES = {"m": (0.2, 3.0), "a": (0.2, 2.0), "omega0": (0.2, 3.0), "f": (0.0, 2.0), "R": (0.05, 0.95)}


def between(**ranges: tuple[float, float]) -> Draw:
    """Draws every symbol evenly from its range."""
    return lambda random, count: {name: random.uniform(low, high, count) for name, (low, high) in {**SIZES, **ranges}.items()}


def regular(random: np.random.Generator, count: int) -> dict[str, Any]:
    """Regular prisms of 3 to 12 sides; inertia up to that of a ring."""
    drawn = between(share=(0.02, 1.0))(random, count)
    return drawn | {"n": random.integers(3, 13, count), "Jc": drawn["share"] * drawn["m"] * drawn["a"] ** 2}


def pyramids(random: np.random.Generator, count: int) -> dict[str, Any]:
    """Pyramids of 4 to 12 sides, short and long."""
    return between(h=(0.1, 3.0), w=(0.2, 3.0))(random, count) | {"n": random.integers(4, 13, count)}


def stools(random: np.random.Generator, count: int) -> dict[str, Any]:
    """Bodies on three supports; K comes down."""
    drawn = between(c=(0.02, 1), Jt=(0.01, 1), share=(0.05, 1.95), delta=(-0.5, 0.5), omega_xi=(-2, 2), omega_eta=(-2, 2), omega_zeta=(-2, 2))(random, count)
    return drawn | {"Jz": drawn["share"] * drawn["Jt"]}


BOX: dict[str, Any] = {
    "body": {"mass": "m", "inertia": "J", "velocity": ["u", "-v"], "spin": "omega1"},
    "contact": [{"name": name, "point": [x, "-h"], "normal": [0, 1], "friction": "f", "restitution": 0} for name, x in (("left", "-w"), ("right", "w"))],
}
TWO: dict[str, Any] = {
    "body": [
        {"name": "first", "mass": "m", "inertia": "J", "centre": [0, 0], "velocity": ["-u", "v"], "spin": "omega1"},
        {"name": "second", "mass": "M", "inertia": "K", "centre": ["-2*a", 0], "velocity": ["u", 0]},
        {"name": "floor", "kind": "fixed"},
    ],
    "contact": [
        {"name": "A", "between": ["first", "second"], "point": ["-a", 0], "normal": [1, 0], "friction": "f"},
        {"name": "B", "between": ["first", "floor"], "point": [0, "-a"], "normal": [0, 1], "friction": "g"},
    ],
}
BOXES = between(J=(0.05, 2), u=(-2, 2), v=(0.1, 2), omega1=(-3, 3), w=(0.1, 1), h=(0.1, 1))
BODIES = between(M=(0.2, 3), J=(0.05, 2), K=(0.05, 2), u=(0.1, 2), v=(-2, 0.5), omega1=(-3, 3), g=(0, 1))
ROLLING = between(b=(0.1, 1.5), gamma=(0.02, 1.55))
RODS = between(b=(0.2, 2), l=(0.3, 8))
#: Hypotheses of restitution after each state of the cylinder.
ELASTIC = ((1, "A separates, K separates (sticks)"), (1, "A slips-, K separates (sticks)"), (2, "A separates, K separates (slips-)"), (2, "A separates, K separates (sticks)"), (3, "A slips-, K separates (slips-)"), (3, "A slips-, K separates (sticks)"))


def formulas() -> Iterator[tuple[str, Derivation, Draw, bool]]:
    """What is compared: name, derivation, draws, and whether by the law under which nothing slides."""
    for k in (1, 2, 3, 4):
        yield f"cylinder, state {k}", cylinder.plastic(k), ROLLING, False
    for state, end in ELASTIC:
        yield f"cylinder, after state {state}: {end}", cylinder.elastic(state, end), ROLLING, False
    for k in (1, 2, 3, 4):
        yield f"prism, item {k}", prism.state(k), regular, False
    for k in prism.ELASTIC:
        yield f"prism, item {k}", prism.item(k), regular, False
    for k in (1, 2, 3, 4):
        yield f"rod, variant {k}", rod.plastic(k) if k <= 2 else rod.elastic(k), RODS, False
    for names in ("OK", "K"):
        yield f"pyramid, {names} keep", space.kept(names), pyramids, True
    for names in ("OAK", "AK"):
        yield f"pyramid of three sides, {names} keep", space.kept(names, 3), pyramids, True
    for names in ("OK", "K"):
        yield f"three supports, {names} keep", space.on_supports(names, 3), stools, True
    for one in carom.derive(BOX, assume=["v > 0", "w > 0", "h > 0"]):
        yield f"box on two corners: {one.title}", one, BOXES, False
    for one in carom.derive(TWO, assume=["a > 0", "u > 0"], discard=False):
        yield f"two bodies and a floor: {one.title}", one, BODIES, False


def main(draws: int, word: str) -> int:
    """Compares all of them; 1 where one differs or is not found."""
    begun, total, worst, bad = time.perf_counter(), 0, [0.0, 0.0], 0
    for name, derivation, draw, non_sliding in (one for one in formulas() if one[0].startswith(word)):
        found = against_engine(derivation, draw, draws, non_sliding=non_sliding, at_most=60)
        total += found.draws
        bad += found.draws - found.found
        worst = [max(worst[0], found.velocity), max(worst[1], found.impulse)]
        print(f"{name}: {found.found} of {found.draws}, velocities to {found.velocity:.1e}, impulses to {found.impulse:.1e}", flush=True)
        for one in found.missed:
            print(f"   not found at {one}")
    whole = [("cylinder", cylinder.problem(), cylinder.ASSUME, ROLLING), ("box", BOX, ("v > 0", "w > 0", "h > 0"), BOXES)]
    for name, problem, assume, draw in (one for one in whole if one[0].startswith(word)):
        matched, missed = all_found(carom.derive(problem, assume=assume), draw, draws)
        bad += len(missed)
        print(f"{name}: a formula for {matched} of {matched + len(missed)} end states of the engine")
    print(f"measured: {total} random impacts by formulas and by the engine, {bad} differ; velocities to {worst[0]:.1e} of the largest, impulses to {worst[1]:.1e}; {time.perf_counter() - begun:.0f} s")
    return int(bad > 0)


if __name__ == "__main__":
    raise SystemExit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 10_000, sys.argv[2] if len(sys.argv) > 2 else ""))

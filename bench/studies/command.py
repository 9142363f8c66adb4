"""The command `carom`, and what one call of it took."""

import json
import os
import shutil
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
EXAMPLES = ROOT / "examples"
WORK = ROOT / "target" / "studies"


@dataclass
class Call:
    """What a call said, and what it took."""

    said: dict
    seconds: float
    cpu_seconds: float
    peak_bytes: int


def build():
    """Builds the command as the README does; returns the way to it."""
    subprocess.run(["cargo", "build", "--release", "--package", "carom-cli"], cwd=ROOT, check=True)
    text = subprocess.run(
        ["cargo", "metadata", "--no-deps", "--format-version", "1"], cwd=ROOT, check=True, stdout=subprocess.PIPE
    ).stdout
    return Path(json.loads(text)["target_directory"]) / "release" / "carom"


def given(path):
    """The command at this place, or one that is built."""
    return Path(path).resolve() if path else build()


def call(carom, *words, out):
    """Runs a study with its results in a folder below `target/studies`; raises where it fails."""
    place = WORK / out
    place.mkdir(parents=True, exist_ok=True)
    answer = place / "answer.json"
    begun = time.perf_counter()
    with open(answer, "wb") as file:
        command = [str(carom), *map(str, words), "--format", "json", "--out", str(place)]
        child = subprocess.Popen(command, stdout=file, stderr=subprocess.PIPE)
        told = child.stderr.read()
        # Peak memory of this child alone, which only waiting for it by number tells.
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
    seconds = time.perf_counter() - begun
    if child.returncode != 0:
        raise SystemExit(f"{' '.join(command)}: exit {child.returncode}\n{told.decode(errors='replace')}")
    said = json.loads(answer.read_text())
    # Linux counts in kibibytes, macOS in bytes.
    unit = 1 if os.uname().sysname == "Darwin" else 1024
    return Call(said, seconds, usage.ru_utime + usage.ru_stime, usage.ru_maxrss * unit)


def size(folder):
    """Bytes of all files in a folder."""
    return sum(path.stat().st_size for path in Path(folder).rglob("*") if path.is_file())


def forget(out):
    """Removes the results of calls."""
    shutil.rmtree(WORK / out, ignore_errors=True)


def percent(estimate):
    """A share and its 95 % interval."""
    share, low, high = (100 * estimate[key] for key in ("share", "low", "high"))
    return f"{share:.3f} % ({low:.3f} to {high:.3f})"


def overlap(a, b):
    """True where two intervals have a point in common."""
    return a["low"] <= b["high"] and b["low"] <= a["high"]

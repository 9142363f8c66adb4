#!/usr/bin/env python3
"""Time and memory of sweeps of 10³ to 10⁷ designs: `python3 bench/studies/scaling.py`. What they write is removed."""

import argparse

from command import EXAMPLES, WORK, call, forget, given, size

# Slopes times drops of the two plates as a designer draws them.
GRIDS = [(25, 40), (100, 100), (250, 400), (1000, 1000), (2500, 4000)]


def main():
    parser = argparse.ArgumentParser(description="Time and memory of sweeps, by their size.")
    parser.add_argument("--carom", help="the command, where it is built already")
    parser.add_argument("--most", type=int, default=10**7, help="designs of the largest sweep")
    arguments = parser.parse_args()
    carom = given(arguments.carom)
    print("| designs | s | s of cores | designs/s | peak MB | MB on disk |")
    print("|---|---|---|---|---|---|")
    for slopes, drops in GRIDS:
        designs = slopes * drops
        if designs > arguments.most:
            break
        forget("scaling")
        axes = [f"plate.lower.slope=5..40 deg:{slopes}", f"plate.lower.drop=120..260 mm:{drops}"]
        words = ["sweep", EXAMPLES / "designer.toml", "--grid", axes[0], "--grid", axes[1]]
        done = call(carom, *words, out="scaling")
        assert done.said["rows"] == designs
        disk = size(WORK / "scaling" / "designer" / "sweep")
        print(
            f"| {designs} | {done.seconds:.2f} | {done.cpu_seconds:.2f} | {designs / done.seconds:.0f} |"
            f" {done.peak_bytes / 1e6:.0f} | {disk / 1e6:.1f} |",
            flush=True,
        )
    forget("scaling")


if __name__ == "__main__":
    main()

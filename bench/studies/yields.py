#!/usr/bin/env python3
"""Yields of few scrambled points against many plain random ones: `python3 bench/studies/yields.py`."""

import argparse
import sys

from command import EXAMPLES, HERE, call, given, overlap, percent

SCENES = [EXAMPLES / "designer.toml", HERE / "yields" / "near_boundary.toml", HERE / "yields" / "zigzag.toml"]


def main():
    parser = argparse.ArgumentParser(description="Yields of scrambled points against plain random numbers.")
    parser.add_argument("--carom", help="the command, where it is built already")
    parser.add_argument("--samples", type=int, default=1_000_000, help="plain drops of each scene")
    parser.add_argument("--seed", type=int, default=4711, help="of the plain drops")
    arguments = parser.parse_args()
    carom = given(arguments.carom)
    agree = True
    for scene in SCENES:
        few = call(carom, "yield", scene, out="yield")
        words = ["--plain", "--samples", arguments.samples, "--seed", arguments.seed]
        many = call(carom, "yield", scene, *words, out="plain")
        print(f"{scene.stem}")
        for name, study in (("Sobol", few), ("plain", many)):
            drops = f"{study.said['samples']} drops, {study.seconds:.1f} s ({study.cpu_seconds:.1f} s of cores)"
            print(f"    {name}  {percent(study.said['yield'])}, {drops}, {study.peak_bytes / 1e6:.0f} MB")
        same = overlap(few.said["yield"], many.said["yield"])
        agree &= same
        apart = 100 * abs(few.said["yield"]["share"] - many.said["yield"]["share"])
        print(f"    {apart:.3f} % apart: {'agree' if same else 'DISAGREE'}", flush=True)
    sys.exit(0 if agree else 1)


if __name__ == "__main__":
    main()

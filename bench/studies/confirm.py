#!/usr/bin/env python3
"""Designs, each judged again by plain random numbers: `python3 bench/studies/confirm.py`.

Asks every scene with a `[design]` below `examples/` (design_*.toml) and in `bench/studies/designs`. Of what is found `carom yield --plain`
drops 10⁶ parts with a seed of its own: the share that ends as wanted within the limits must agree with what `carom design` says.
"""

import argparse
import sys
from pathlib import Path

from command import EXAMPLES, HERE, WORK, call, given, overlap, percent


def scenes():
    """Every question, by name."""
    return sorted([*EXAMPLES.glob("design_*.toml"), *(HERE / "designs").glob("*.toml")], key=lambda path: path.name)


def forbidden(answer):
    """What stands in the way, in words."""
    if answer["met"]:
        return f"{answer['met']} of {answer['scanned']} layouts meet every demand, none with yield enough"
    told = []
    for demand in answer["forbidden"]:
        near = f" (nearest {demand['nearest']:.4f}, limit {demand['limit']})" if demand["nearest"] is not None else ""
        told.append(f"{demand['demand']}: {demand['failed']} fail it, {demand['alone']} nothing else{near}")
    return f"of {answer['scanned']} layouts " + "; ".join(told)


def ask(carom, scene, arguments):
    """One question: its line, and whether both yields agree."""
    words = ["design", scene, "--samples", 16384]
    if arguments.scan:
        words += ["--scan", arguments.scan]
    found = call(carom, *words, out="design")
    answer = found.said
    took = f"{answer['run']['drops']} drops, {found.seconds:.1f} s ({found.cpu_seconds:.1f} s of cores)"
    print(f"{scene.stem}: {answer['outcome']}, {took}", flush=True)
    if answer["winner"] is None:
        print(f"    {forbidden(answer)}", flush=True)
        return True
    winner = answer["winner"]
    design = WORK / "design" / answer["scene"] / "design" / "design.toml"
    words = ["--plain", "--samples", arguments.samples, "--seed", arguments.seed]
    plain = call(carom, "yield", design, *words, out="confirm")
    again = plain.said["yield_within_limits"] or plain.said["yield"]
    agrees = overlap(winner["yield"], again)
    print(f"    {', '.join(answer['delivered'])}; {winner['height_m']:.4f} m, {winner['impact_speed_m_s']:.3f} m/s")
    print(f"    design   {percent(winner['yield'])}, doubled {percent(winner['yield_doubled'])}")
    print(f"    plain    {percent(again)}, {plain.said['samples']} drops, seed {arguments.seed}, {plain.seconds:.1f} s")
    print(f"    {'agree' if agrees else 'DISAGREE'}", flush=True)
    return agrees


def main():
    parser = argparse.ArgumentParser(description="Designs, each judged again by plain random numbers.")
    parser.add_argument("--carom", help="the command, where it is built already")
    parser.add_argument("--samples", type=int, default=1_000_000, help="plain drops of each design")
    parser.add_argument("--seed", type=int, default=4711, help="of the plain drops")
    parser.add_argument("--scan", type=int, help="layouts of the first look; as `carom design` has it where left out")
    parser.add_argument("scene", nargs="*", type=Path, help="scenes; all where left out")
    arguments = parser.parse_args()
    carom = given(arguments.carom)
    answers = [ask(carom, scene, arguments) for scene in arguments.scene or scenes()]
    sys.exit(0 if all(answers) else 1)


if __name__ == "__main__":
    main()

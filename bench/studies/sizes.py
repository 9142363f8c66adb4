#!/usr/bin/env python3
"""What one answer takes by the size of what is asked: plates, corners of the part, parts that follow each other, contacts that strike at once.

`python3 bench/studies/sizes.py [--carom COMMAND]` prints a table: the shortest of three calls, report and all, and with which power of the size the
time grows from the size before. What is written is removed.
"""

import argparse
import math
from pathlib import Path

from command import WORK, call, forget, given

SIZES = {
    "plates": [2, 4, 8, 16, 32, 64],
    "corners": [4, 8, 16, 32, 64, 128, 256, 512],
    "parts": [2, 4, 8, 16, 32],
    "contacts": [1, 2, 3, 4, 5, 6, 12, 24],
}
CALLS = 3

CONTACT = "[contact]\nfriction = 0.2\nrestitution = 0.1\n"
BOX = '[part]\nshape = "box"\nlength = "60 mm"\nheight = "20 mm"\nmass = "0.1 kg"\n'


def plates(count):
    """A box down a zig-zag."""
    zigzag = f'[zigzag]\nplates = {count}\ndrop = "110 mm"\nslope = "22 deg"\ngap = "80 mm"\n'
    start = '[start]\nto_edge = "60 mm"\n[channel]\nwidth = "220 mm"\n'
    return "run", f'stop = "delivered"\n{BOX}{CONTACT}{start}{zigzag}'


def corners(count):
    """A regular polygon that tips over an edge and rolls down the next plate."""
    angles = [2 * math.pi * k / count for k in range(count)]
    drawn = ", ".join(f'["{30 * math.cos(a):.6f} mm", "{30 * math.sin(a):.6f} mm"]' for a in angles)
    part = f'[part]\nshape = "polygon"\nvertices = [{drawn}]\nmass = "0.1 kg"\n'
    layout = '[[plate]]\nslope = "10 deg"\n[[plate]]\ndownhill = "left"\nline = { along = "428 mm", normal = "300 mm" }\n'
    return "run", f'{part}{CONTACT}[start]\nto_edge = "100 mm"\n{layout}'


def parts(count):
    """Boxes that strike and push each other on the lower plate."""
    layout = '[[plate]]\nslope = "30 deg"\nlength = "200 mm"\n[[plate]]\ndownhill = "left"\nedge = ["-180 mm", "-190 mm"]\nslope = "14 deg"\nlength = "440 mm"\n'
    feed = f'[feed]\nparts = {count}\ninterval = "0.9 s"\n'
    return "run", f'stop = "delivered"\n{BOX}{CONTACT}{feed}[start]\nto_edge = "120 mm"\n{layout}'


def contacts(count):
    """A body on feet of one level that lean a little, each its own way."""
    feet = []
    for k in range(count):
        x, lean = (2 * k + 1) / count - 1, 0.3 * math.sin(5 * k + 1)
        feet.append(f"[[contact]]\npoint = [{x:.6f}, -0.5]\nnormal = [{math.sin(lean):.9f}, {math.cos(lean):.9f}]\nfriction = {0.2 + 0.05 * (k % 5):.2f}\nrestitution = 0.4\n")
    return "impact", "[body]\nmass = 1\ninertia = 0.3\nvelocity = [0.3, -1]\nspin = 0.4\n" + "".join(feet)


def main():
    parser = argparse.ArgumentParser(description="Time of one answer, by the size of what is asked.")
    parser.add_argument("--carom", help="the command, where it is built already")
    carom = given(parser.parse_args().carom)
    print("| what | size | ms | power |")
    print("|---|---|---|---|")
    for name, sizes in SIZES.items():
        before = None
        for count in sizes:
            verb, text = globals()[name](count)
            file = Path(WORK) / "sizes.toml"
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
            seconds = min(call(carom, verb, file, out="sizes").seconds for _ in range(CALLS))
            power = "–" if before is None else f"{math.log(seconds / before[1]) / math.log(count / before[0]):.1f}"
            print(f"| {name} | {count} | {1e3 * seconds:.1f} | {power} |", flush=True)
            before = (count, seconds)
    forget("sizes")


if __name__ == "__main__":
    main()

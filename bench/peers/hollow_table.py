"""The part of the page of results that is about parts with hollows."""

import datetime
import os
from statistics import median

import hollow
from parts import PARTS

HEADING = "## Parts with hollows"
FACES = {
    "L": ["long leg", "long leg's end", "across the hollow", "short leg's end", "short leg"],
    "T": ["bar", "bar's end", "across a hollow", "stem's end", "across the other hollow", "bar's other end"],
}
ENGINES = {"box2d": "Box2D", "mujoco": "MuJoCo"}
NEAR_TIE = 1.0  # mm or per cent: what turns Carom's own answer
ALIKE = 0.01  # of the spin before the first touch: below it the way there was the same


def section(names, runs, carom, engines):
    """The section, as Markdown. `runs` holds engine, setting and name; `engines` every answer by the first two."""
    scenes = hollow.grid()
    head = [
        HEADING,
        "",
        f"Measured on {datetime.date.today()} by `python3 bench/peers/run.py --hollows` on a machine with {os.cpu_count()} cores."
        f" Versions: {', '.join(names)}.",
        "",
        _scenes(scenes),
        "",
    ]
    parts = [
        _agreement(scenes, runs, carom, engines),
        _disagreements(scenes, runs, carom, engines),
        [_notes(carom)],
        _all(scenes, runs, carom, engines),
    ]
    return "\n".join(head + [line for part in parts for line in part]) + "\n"


def _scenes(scenes):
    l_mm = "legs of 47 and 34 mm, 6 mm thick"
    t_mm = "a bar of 40 × 6 mm on a stem of 6 × 24 mm"
    plates = ", ".join(f"{slope:g}° and {1000 * normal:g} mm below" for slope, normal in hollow.LOWER_PLATES)
    return (
        f"An L ({l_mm}) and a T ({t_mm}), of 20 g, lie on the upper plate on their longest face or across a hollow, and are let go."
        f" {len(scenes)} scenes: all combinations of these four starts, upper slopes of {_listed(hollow.UPPER_SLOPES)}°,"
        f" {_listed([1000 * d for d in hollow.TO_EDGE])} mm from the mass centre to the edge, lower plates ({plates}; they rise to the"
        f" right) and friction {_listed(hollow.FRICTIONS)}; e = 0. None was left out."
        " The upper plate stays where it is, as the parts hook onto its edge."
        " Carom is given the outline; the others two boxes that abut, with the outline's exact mass, centre and inertia."
    )


def _listed(values):
    return " and ".join(f"{value:g}" for value in values)


def _agreement(scenes, runs, carom, engines):
    is_l = [scene[0][0] == "L" for scene in scenes]
    hooked = [drop["hooks"] > 0 for drop in carom]
    lines = [
        "### Agreement with Carom as the step shrinks",
        "",
        f"| engine, setting | same face, of {is_l.count(True)} L | of {is_l.count(False)} T | first touch, median (largest) |"
        f" the same for the {hooked.count(True)} that strike the first plate's edge | comes to lie, median (largest): no slip reverses |"
        " slip reverses in a strike |",
        "|---|---|---|---|---|---|---|",
    ]
    for engine, setting, name in runs:
        drops = engines[engine, setting]
        same = [_same(a, b) for a, b in zip(drops, carom, strict=True)]
        count = [sum(s and chosen for s, chosen in zip(same, which)) for which in (is_l, [not i for i in is_l])]
        touch = [_off(a, b, "touch") for a, b in zip(drops, carom)]
        lies = [_off(a, b, "lies") if s else None for a, b, s in zip(drops, carom, same)]
        lies_of = [[t for t, c in zip(lies, carom) if (c["reversals"] > 0) is wanted] for wanted in (False, True)]
        at_edge = [t for t, h in zip(touch, hooked) if h]
        cells = [_spread(times) for times in (touch, at_edge, *lies_of)]
        lines.append(f"| {name} | {count[0]} | {count[1]} | {' | '.join(cells)} |")
    return lines + ["", "Times are distances from Carom's; of coming to lie only where the face is the same.", ""]


def _same(a, b):
    return a["face"] == b["face"]


def _off(a, b, what):
    """How far a time is from Carom's [ms]; None where there is none."""
    return None if a[what] is None or b[what] is None else 1000 * (a[what] - b[what])


def _spread(times):
    sizes = [abs(time) for time in times if time is not None]
    return f"{_ms(median(sizes))} ({_ms(max(sizes))}) ms" if sizes else "-"


def _ms(time):
    return f"{time:.2g}" if abs(time) < 99 else f"{time:.0f}"


def _disagreements(scenes, runs, carom, engines):
    lines = [
        "### Where a face differs",
        "",
        f"A near tie: Carom's own face changes when the start or the lower plate is moved by {NEAR_TIE:g} mm or less, or friction by"
        f" as many per cent. Apart already before the first touch: a spin that differs by more than {100 * ALIKE:g} %.",
        "",
        "| scene | Carom | others, where they differ | Carom's own face changes with | spin before the first touch, each at its finest, 1/s | what the numbers say |",
        "|---|---|---|---|---|---|",
    ]
    for i, own in enumerate(carom):
        differing = [run for run in runs if not _same(engines[run[0], run[1]][i], own)]
        if not differing:
            continue
        part = scenes[i][0][0]
        others = "; ".join(f"{run[2]}: {_face(part, engines[run[0], run[1]][i])}" for run in differing)
        spins = _spins(i, runs, own, engines)
        shown = ", ".join(f"{label} {spin:.2f}" for label, spin in spins)
        why = "; ".join(_why(own, differing, i, engines))
        lines.append(f"| {i + 1} | {_face(part, own)} | {others} | {_flips(own)} | {shown} | {why} |")
    return lines + [""]


def _spins(i, runs, own, engines):
    """The spin before the first touch: of Carom, and of each engine at its last setting."""
    last = {engine: engines[engine, setting][i] for engine, setting, _ in runs}
    found = [("Carom", own["spins"][0])] if own["spins"] else []
    return found + [(ENGINES[engine], drop["spins"][0]) for engine, drop in last.items() if drop["spins"]]


def _face(part, drop):
    return "none" if drop["face"] is None else FACES[part][drop["face"]]


def _flips(own):
    if own["flips_by"] is None:
        return f"nothing up to {hollow.MOVED:g} mm or %"
    what = {"plate": "mm of the lower plate", "start": "mm of the start", "friction": "% of friction"}[own["flips_what"]]
    return f"{own['flips_by']:g} {what}"


def _why(own, differing, i, engines):
    """What can be read from the numbers, of each engine's finest run that differs; the notes say what was looked at."""
    found = []
    if own["flips_by"] is not None and own["flips_by"] <= NEAR_TIE:
        found.append("near tie")
    finest = {engine: engines[engine, setting][i]["spins"] for engine, setting, _ in differing}
    exact = own["spins"][0]
    for engine, spins in finest.items():
        earlier = not spins or abs(spins[0] - exact) > ALIKE * abs(exact)
        place = "at the first plate's edge" if own["hooks"] else "on the first plate"
        found.append(f"{ENGINES[engine]}: {'apart already ' + place if earlier else 'apart after the first touch'}")
    if own["reversals"]:
        found.append(f"slip reverses in {own['reversals']} of {own['strikes'] + own['hooks']} strikes")
    return found


def _all(scenes, runs, carom, engines):
    finest = list({engine: (engine, setting, name) for engine, setting, name in runs}.values())
    heads = " | ".join(f"{name}: face, touch, lies" for _, _, name in finest)
    lines = [
        "### Every scene",
        "",
        "Columns of the other engines: their face where it differs, and by how many ms they touch and lie later than Carom.",
        "",
        "| | part, start | upper | lower | to edge | friction | Carom: face | touch | lies | strikes (edge) | margin | " + heads + " |",
        "|---" * (11 + len(finest)) + "|",
    ]
    for i, (((part, start), upper, (lower, normal), to_edge, friction), own) in enumerate(zip(scenes, carom)):
        cells = [
            f"{i + 1}",
            f"{part}, {FACES[part][start]}",
            f"{upper:g}°",
            f"{lower:g}°, {1000 * normal:g} mm",
            f"{1000 * to_edge:g} mm",
            f"{friction:g}",
            _face(part, own),
            _seconds(own["touch"]),
            _seconds(own["lies"]),
            f"{own['strikes']} ({own['hooks']})",
            f"{own['margin']:.1g}",
        ]
        for engine, setting, _ in finest:
            drop = engines[engine, setting][i]
            face = "=" if _same(drop, own) else _face(part, drop)
            times = [_off(drop, own, what) for what in ("touch", "lies")]
            cells.append(", ".join([face, *("-" if time is None else f"{time:+.2f}" for time in times)]))
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def _seconds(time):
    return "-" if time is None else f"{time:.5f} s"


def inertia_differs(carom):
    """How far Carom's inertias are from those that the others are given, as a share."""
    pairs = [(drop["inertia"], PARTS[scene[0][0]].inertia) for drop, scene in zip(carom, hollow.grid())]
    return max(abs(a / b - 1) for a, b in pairs)


def _notes(carom):
    reversing = sum(drop["reversals"] > 0 for drop in carom)
    return f"""### What was looked at, and what it does not say

- **Hollows.** Carom walks round one outline; the others know two boxes and no hollow. That a hollow's two corners strike the plate's edge, that a leg hangs on it and leaves it, comes out alike: Box2D's first touch of the lower plate approaches Carom's as the step shrinks, after strikes of the edge as well. Inertias, computed on both sides, agree to {inertia_differs(carom):.0e}. Boxes that overlap at the inner corner instead of abutting changed no face of Box2D at ×1000, 1/20000 s, and three of MuJoCo at 1/20000 s.
- **Near ties** (scenes 17, 20, 80, and 34 at the coarsest step). In 17 and 20 the L balances on a corner of its long leg for 0.3 to 0.4 s before it falls to one side; in 80 the T rocks over its stem's end, on which Box2D at its coarsest leaves it standing. Box2D goes either way there as the step and the lengths change. Carom's own answer turns as well, by 0.1 % of friction (80), 0.2 mm (17) and 0.5 mm (20) of the start, 1 % of friction (34).
- **The law of impact.** In {reversing} scenes the slip of a corner reverses within a strike. Engines that solve one problem of contact a step cannot see that, however fine the step; hence the times of coming to lie that do not converge. Scene 56, second strike: Routh's walk, worked out apart from Carom from the state before, gives a spin of −1.09 1/s after it, and Carom has −1.09; one problem of contact gives 7.24, and Box2D has 6.74 from nearly the same state. Scene 5, third strike: −4.85 and −4.85 (reverses), −7.48 and −7.55 (sticks). No face of Box2D at its finest differs because of it; this says nothing of scenes that are not listed. Which law real parts follow is not decided here.
- **MuJoCo's contacts** are soft, and at 1/100000 s they throw back: e = 0 is only approached. No setting that was tried agreed on more faces than 92 of 96. In scene 23 the first strike brings a change of spin of 41.0 1/s, against 36.95 of Carom, as e = 0.11 would; in scene 42 the strike of the plate's edge takes it from −16.1 to −26.4 1/s, against −23.64 of both Carom and Box2D, and the others that strike the edge leave it with 2 to 12 % more spin as well. After that the times of coming to lie are others too, and in scenes 42 and 65 the face. In scenes 14 and 51 it is apart before, by 7 and 2 % of the spin: it chatters as it slides to the first plate's edge and tips. Contacts this damped give way and come back over tens of steps: at coarse steps the part lies down late. Sixteen settings (time constants of 8 to 100 steps, damping 1 to 10, impedance, impratio, steps of 1/5000 and 1/20000 s) agreed on 81 to 92; the one shown, 40 steps and 3, is the finest one of the tables above.
- **Box2D at ×100** keeps 0.15 mm between faces, of a part 6 mm thick; at ×1000 it is 0.015 mm. Scene 65, where two of its runs at ×100 differ, changes with 2 mm of the start.
- Times of coming to lie of the other engines are taken where the tilt last exceeds {hollow.LYING_ANGLE:g} rad, and counted on from there at the spin of that moment. A part counts as lying when it has been flat for {1000 * hollow.FLAT_TIME:g} ms.
- MuJoCo's upper plate is a sheet 2 mm thick below the line, Carom's and Box2D's have no thickness; sheets of 1 and 4 mm changed one face of MuJoCo each at 1/20000 s. That is little: a part that slides chatters there, and a start that differs in its last digit changes one or two faces at each step as well.
- Only e = 0, sharp edges, straight plates; only two engines.
"""



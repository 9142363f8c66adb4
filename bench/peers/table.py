"""The page of results."""

import datetime
import os
from statistics import median


def page(runs, results, wanted, exact, versions, missing, rounds):
    """The whole page, as Markdown."""
    head = [
        "# The same drops on other engines",
        "",
        f"Measured on {datetime.date.today()} by `python3 bench/peers/run.py`: {rounds} rounds, all engines in turn,"
        f" one thread each, on a machine with {os.cpu_count()} cores.",
        f"Versions: {', '.join(text for name, text in versions.items() if name != 'build')}; {versions['build']}.",
        "",
    ]
    # The reasons may name the machine, so they are only printed.
    gone = [f"Not measured, as they could not be had or failed: {', '.join(missing)}.", ""] if missing else []
    parts = [_verdicts(runs, results, wanted), _maps(runs, results, wanted), _impacts(runs, results, exact), [_notes(wanted)]]
    return "\n".join(head + gone + [line for part in parts for line in part])


def _verdicts(runs, results, wanted):
    sizes = {name: len(wanted[name]["box"]) for name in wanted}
    lines = [
        "## Verdicts and speed",
        "",
        f"| engine, setting | part | A of {sizes['grid']} | B of {sizes['boundary']} | drops/s per core, median (least to most) |"
        " Carom at its default, with the box, is faster by |",
        "|---|---|---|---|---|---|",
    ]
    carom = results.get(("carom", "box-default"))
    for engine, setting, part, name in runs:
        result = results[engine, setting]
        rates = [sizes["grid"] / seconds for seconds in result["seconds"]]
        scores = [_agreeing(result[list_name], wanted[list_name][part]) for list_name in ("grid", "boundary")]
        # Seconds of one round belong together: what else the machine did slowed both.
        ratio = "-"
        if carom:
            ratio = "× " + _digits(median(s / c for c, s in zip(carom["seconds"], result["seconds"])))
        lines.append(
            f"| {name} | {part} | {scores[0]} | {scores[1]} |"
            f" {_digits(median(rates))} ({_digits(min(rates))} to {_digits(max(rates))}) | {ratio} |"
        )
    never = [_agreeing(["same"] * sizes[name], wanted[name]["box"]) for name in ("grid", "boundary")]
    lines.append(f"| for comparison: \"never turns\" | box | {never[0]} | {never[1]} | - | - |")
    return lines + [""]


def _maps(runs, results, wanted):
    """How long a map of verdicts takes: Carom follows boundaries, the others make a drop a cell."""
    own = {setting: results[engine, setting]["maps"] for engine, setting, *_ in runs if engine == "carom"}
    if "box-default" not in own:
        return []
    of = own["box-default"]
    cells, designs = of[0]["cells"], len(wanted["grid"]["box"])
    lines = [
        "## A map",
        "",
        f"The verdicts of {cells} designs (300 × 300: where the lower plate's line meets the upper one's axis and its normal), on one core."
        " Carom follows the boundaries between verdicts and makes only the drops beside them; then each cell is compared with its own drop."
        " The others make a drop a cell, at the rate above: that time is computed, not measured.",
        "",
        "| engine, setting | part | drops | cells that are not what their own drop says | seconds, median | Carom at its default, with the box, is faster by |",
        "|---|---|---|---|---|---|",
    ]
    for engine, setting, part, name in runs:
        if engine == "carom":
            maps = own[setting]
            seconds = [one["seconds"] for one in maps]
            drops, wrong = maps[0]["drops"], str(maps[0]["wrong"])
        else:
            seconds = [cells * one / designs for one in results[engine, setting]["seconds"]]
            drops, wrong = cells, "-"
        ratio = median(other / ours["seconds"] for ours, other in zip(of, seconds))
        lines.append(f"| {name} | {part} | {drops} | {wrong} | {_digits(median(seconds))} | × {_digits(ratio)} |")
    return lines + [""]


def _agreeing(found, wanted):
    return sum(a == b for a, b in zip(found, wanted, strict=True))


def _digits(number):
    """Two digits, all before the point."""
    return f"{number:.2g}" if number < 100 else f"{float(f'{number:.2g}'):.0f}"


def _impacts(runs, results, exact):
    lines = [
        "## The isolated impact, e = 0",
        "",
        "Error of the spin after the impact, in the paper's two cases; without gravity, lengths and options as above,"
        " the step 0.01 ms for every engine that has one.",
        "",
        "| engine, setting | part | case 1 | case 2 |",
        "|---|---|---|---|",
    ]
    for engine, setting, part, name in runs:
        spins = results[engine, setting]["spins"]
        errors = [_error(spin, right) for spin, right in zip(spins, exact[part], strict=True)]
        lines.append(f"| {name} | {part} | {errors[0]} | {errors[1]} |")
    return lines + [""]


def _error(spin, right):
    """A relative error in per cent, as far as the exact number's nine digits can tell."""
    error = 100 * abs(spin / right - 1)
    return "< 1e-7 %" if error < 1e-7 else f"{error:.2g} %"


def _notes(wanted):
    differing = sum(rod != box for rod, box in zip(wanted["boundary"]["rod"], wanted["boundary"]["box"]))
    return f"""## What this says, and what it does not

- **A**: {len(wanted['grid']['box'])} designs, judged against an independent event-driven solution. **B**: {len(wanted['boundary']['box'])} designs within ±15 mm of the boundary between both verdicts for the box (counted along the line's `normal`), half on each side.
- B's boundary and its verdicts are Carom's own, at tolerance 1e-12. Carom's scores on B say only that the settings shown agree with that; they are no evidence for Carom. Its scores on A are.
- Engines that need volume are given a box 1 mm thick, and judged against the exact solution for that box. Thickness matters: rod and box differ on {differing} designs of B.
- A drop is the whole of it: setting up, sliding 0.1 m, tipping, falling, striking, coming to lie flat. Engines with steps are looked at every 5 ms. Box2D and MuJoCo are called from Python; MuJoCo steps many times a call, Box2D once a call, so a program without Python would run Box2D faster.
- Rates depend on the machine and on what else it does; ratios, taken round by round, less so.
- The impact: engines with steps solve one problem of contact per step. In case 1, where the slip reverses within the impact, that leads to another spin than Routh's walk through it, however fine the step. At e = 0 this gap changed none of the verdicts for which it was examined (924 designs): nothing here says that an engine gets verdicts wrong because of its law of impact. What a finer step or a stiffer contact mends is not the law's.
- Carom's impacts are the first ones of whole runs; the other engines start at the exact state of the box at the first touch.
- Settings are the best that were found, not the best there are; they were chosen by their scores on A and B, which favours the other engines. Each engine's file states its own. Near the boundary agreement scatters with the setting: one of 100 more or less says little.
"""

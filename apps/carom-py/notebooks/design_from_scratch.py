# ---
# jupyter:
#   jupytext:
#     text_representation:
#       extension: .py
#       format_name: percent
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [markdown]
# # A feeder from scratch
#
# You learn how to describe a part of your own, how to find what it can lie on, how to let Carom look for a feeder that turns it, how sure that feeder is, and which files you get for the workshop.
# The part is a steel block with one slanted corner; change its corners in the first cells, and the rest follows.
# You need `pip install "./apps/carom-py[notebooks]"`; the search takes some seconds.

# %%
import os
import tempfile
from pathlib import Path

import carom
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from IPython.display import SVG, display

# How many layouts the search looks at first, and how many drops the winner must stand. The defaults of `carom.design`, 4096 and 16384, are better and take longer.
SCAN, SAMPLES = int(os.environ.get("CAROM_SCAN", "32")), int(os.environ.get("CAROM_SAMPLES", "32"))

# %% [markdown]
# ## The part
#
# A list of corners, counter-clockwise, in mm. The density and the depth give mass, mass centre and moment of inertia.

# %%
corners = [(0, 0), (40, 0), (40, 8), (14, 18), (0, 18)]
part = {
    "shape": "polygon",
    "vertices": [[f"{x} mm", f"{y} mm"] for x, y in corners],
    "density": "7.85 g/cm^3",
    "depth": "20 mm",
}

# %% [markdown]
# ## What it can lie on
#
# A *face* is what the part can lie on. Here each side is one. (In a part with hollows a line from tip to tip is a face too.) The part stays on a face if its mass centre is above it.
# The faces count counter-clockwise from the one that starts at the lowest corner. Carom uses these numbers in its verdicts.


# %%
def centre_of(points: list[tuple[int, int]]) -> tuple[float, float]:
    """The middle of the area of a polygon."""
    x, y = np.array(points, dtype=float).T
    cross = x * np.roll(y, -1) - np.roll(x, -1) * y
    return float(((x + np.roll(x, -1)) * cross).sum() / (3 * cross.sum())), float(
        ((y + np.roll(y, -1)) * cross).sum() / (3 * cross.sum())
    )


centre = centre_of(corners)
sides = list(zip(corners, corners[1:] + corners[:1], strict=True))
faces = []
for k, (a, b) in enumerate(sides):
    side = np.subtract(b, a)
    length = float(np.hypot(*side))
    ahead = float(np.subtract(centre, a) @ side) / length
    height = float(side[0] * (centre[1] - a[1]) - side[1] * (centre[0] - a[0])) / length
    tips = np.degrees(np.arctan2([ahead, length - ahead], height))
    faces.append(
        {
            "face": k,
            "length [mm]": length,
            "centre from its ends [mm]": f"{ahead:.1f}, {length - ahead:.1f}",
            "tips after [deg]": f"{tips[0]:.0f}, {tips[1]:.0f}",
            "stays": bool(tips.min() > 0),
        }
    )
display(pd.DataFrame(faces).style.hide(axis="index").format(precision=1))

# %%
_, axes = plt.subplots(figsize=(6, 3.2), layout="constrained")
axes.fill(*np.array(corners, dtype=float).T, facecolor="#56B4E9", alpha=0.6)
axes.plot(*centre, "k+", ms=12, label="mass centre")
for one, ends in zip(faces, sides, strict=True):
    axes.plot(
        *np.array(ends, dtype=float).T,
        color="black" if one["stays"] else "#D55E00",
        ls="-" if one["stays"] else "--",
    )
    axes.annotate(
        str(one["face"]),
        np.mean(ends, axis=0),
        weight="bold",
        ha="center",
        va="center",
        bbox={"boxstyle": "circle", "facecolor": "white"},
    )
axes.set(aspect="equal", xlabel="x [mm]", ylabel="y [mm]", title="faces; it does not stay on a dashed one")
axes.margins(0.15)
axes.legend(frameon=False, loc="upper right")
plt.show()

# %% [markdown]
# ## A first feeder
#
# Two plates in a channel. The part starts on face 0, and we want it on face 2. The tolerances are those of a cheap feeder.

# %%
WANTED = 2
scene = carom.Scene(
    {
        "part": part,
        "contact": {"friction": "0.2 ± 0.08", "restitution": 0.0},
        "start": {"to_edge": "60 ± 5 mm", "face": 0},
        "channel": {"width": "260 mm"},
        "plate": [
            {"name": "upper", "wall": "left", "height": "0 mm", "slope": "20 ± 1.5 deg", "gap": "120 ± 2 mm"},
            {
                "name": "lower",
                "wall": "right",
                "drop": "120 ± 3 mm",
                "slope": "25 ± 1.5 deg",
                "gap": "40 ± 2 mm",
                "want": WANTED,
            },
        ],
        "design": {
            "free": {"plate.upper.slope": "15..35 deg", "plate.lower.drop": "80..200 mm"},
            "max_impact_speed": "2 m/s",
        },
    },
    name="slanted",
)
first = carom.run(scene)
print(f"one drop: {first.outcome}, it lies on face {first.plates[-1].face}")
before = carom.yield_(scene, samples=4096)
print(
    f"wanted: {before.wanted}; {100 * before.yield_.share:.1f} % of {before.samples} drops ({100 * before.yield_.low:.1f} to {100 * before.yield_.high:.1f} %)"
)
display(scene)

# %% [markdown]
# ## Why does the first feeder fail?
#
# Carom keeps drops that somebody should look at: of every wrong ending the drop that is most probable, and the hardest strike. Each is a scene that you can run again.

# %%
worst = {
    one.file: carom.Scene(before.files[one.file], name=one.file.removesuffix(".toml")) for one in before.worst
}
again = {file: carom.run(bad) for file, bad in worst.items()}
for one in before.worst:
    changed = ", ".join(
        f"{path} {worst[one.file][path].value:.4g}" for path in ("contact.friction", "plate.upper.slope")
    )
    print(
        f"{one.why:<8} {one.file:<20} ends: {one.ending:<8} run again: {again[one.file].outcome}, {changed}"
    )
again[before.worst[0].file]

# %% [markdown]
# ## Let Carom look for a better one
#
# `[design]` in the scene says which quantities may be chosen, in which range, and which limits hold. Here a strike may not be faster than 2 m/s.

# %%
design = carom.design(scene, scan=SCAN, samples=SAMPLES)
print(
    f"{design.outcome}: {design.met} of {design.scanned} layouts of the first look meet every demand; {design.run.drops} drops in {design.run.seconds:.1f} s"
)
winner = design.winner
assert winner is not None, "no layout meets every demand"
for path, value in winner.chosen.items():
    unit = scene[path].usual_unit
    print(
        f"    {path:<20} {np.degrees(value) if unit == 'deg' else 1000 * value:7.2f} {'deg' if unit == 'deg' else 'mm'}"
    )
print(
    f"height {1000 * winner.height_m:.0f} mm, hardest strike {winner.impact_speed_m_s:.2f} m/s, it lies after {winner.time_s:.2f} s"
)
pd.DataFrame(
    [(one.demand, one.failed, one.alone) for one in design.forbidden],
    columns=["demand", "layouts that fail it", "and no other demand"],
)

# %% [markdown]
# ## How sure is it?
#
# The search tried few drops for each layout. Now the winner must stand many, and it must stand them with tolerances twice as wide.

# %%
better = carom.Scene(design.files["design.toml"], name="winner")
after = carom.yield_(better, samples=4096)
print(
    f"before {100 * before.yield_.share:.1f} %, now {100 * after.yield_.share:.2f} % ({100 * after.yield_.low:.2f} to {100 * after.yield_.high:.2f} %) of {after.samples} drops"
)
print(f"tolerances twice as wide, by the search: {100 * winner.yield_doubled.share:.1f} %")
for ending in after.endings:
    print(f"    {ending.ending:<10} {100 * ending.probability.share:6.2f} %")
strikes = next(plate for plate in after.plates if plate.plate == "lower").impact_speed_m_s
assert strikes is not None
edges = np.array(strikes.histogram.edges)
_, axes = plt.subplots(figsize=(6, 2.6), layout="constrained")
axes.bar(edges[:-1], strikes.histogram.counts, width=np.diff(edges), align="edge", color="#0072B2")
axes.set(xlabel="speed of the first strike on the lower plate [m/s]", ylabel="drops [number]")
plt.show()

# %% [markdown]
# ## The files
#
# `save` writes what the command would write: the scene, a drawing as DXF and SVG, a report as a web page.

# %%
folder = Path(tempfile.mkdtemp(prefix="carom-"))
written = [*design.save(folder / "design"), *after.save(folder / "yield")]
for path in written:
    print(f"{path.relative_to(folder)!s:<28} {path.stat().st_size / 1000:8.1f} kB")
display(SVG(design.files["drawing.svg"]))

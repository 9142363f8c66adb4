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
# # Friction and restitution from measured impacts
#
# You learn how to find the friction and the restitution of a part from impacts that a camera saw, with an interval for each, and how to test the result on impacts that were held out.
# As it stands the notebook makes its own measurements, so that you know the truth; with a folder in the environment variable `CAROM_DATA` it takes two public data sets in place of them (an ellipse, a cube), and downloads them into that folder once.
# You need `pip install "./apps/carom-py[notebooks]"` (SciPy, matplotlib).

# %%
import os
from pathlib import Path

import carom
import carom.data
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from carom.measured import MeasuredImpacts, fit_impacts

# The project's folder: this one, or the nearest above it that has the examples.
FOLDERS = (Path.cwd(), *Path.cwd().parents)
ROOT = next((folder for folder in FOLDERS if (folder / "examples/case_2.toml").is_file()), Path.cwd())
DATA = os.environ.get("CAROM_DATA")
#: What makes our own measurements: friction, restitution, and the error of the camera as a share of the motion.
TRUTH, ERROR, ROWS = {"friction": 0.2, "restitution": 0.55}, 0.03, 400

# %% [markdown]
# ## The measurements
#
# `MeasuredImpacts` holds one impact a row: the arm from the mass centre to the contact, the normal, and the velocity and the spin before and after.


# %%
def own_measurements(rows: int, error: float, seed: int = 1) -> MeasuredImpacts:
    """Impacts of a falling ellipse as the engine resolves them, with errors of the measurement."""
    random = np.random.default_rng(seed)
    mass, inertia = 0.0364, 0.0364 * 0.0192**2
    arm = np.column_stack([random.uniform(-0.02, 0.02, rows), random.uniform(-0.035, -0.025, rows)])
    velocity, spin = (
        np.column_stack([random.uniform(-1, 1, rows), random.uniform(-3, -2, rows)]),
        random.uniform(-20, 20, rows),
    )
    after = carom.impacts(
        mass=mass,
        inertia=inertia,
        arm=arm,
        velocity=velocity,
        spin=spin,
        friction=TRUTH["friction"],
        restitution=TRUTH["restitution"],
    )
    weights = np.sqrt([mass, mass, inertia])
    before = np.linalg.norm(np.column_stack([velocity, spin]) * weights, axis=1)
    seen = (
        np.column_stack([after["velocity_x_m_s"], after["velocity_y_m_s"], after["spin_rad_s"]])
        + random.normal(0, error, (rows, 3)) * before[:, None] / weights
    )
    return MeasuredImpacts(
        mass, inertia, arm, velocity, spin, seen[:, :2], seen[:, 2], np.tile([0.0, 1.0], (rows, 1))
    )


if DATA:
    print(f"{carom.data.SETS['planar-ellipse'].about}\n{carom.data.SETS['planar-ellipse'].source}")
    measured = carom.data.planar_ellipse(carom.data.fetch("planar-ellipse", DATA))
else:
    measured = own_measurements(ROWS, ERROR)
half = np.random.default_rng(0).permutation(len(measured)) < len(measured) // 2
print(f"{len(measured)} impacts; {half.sum()} are fitted, {(~half).sum()} are held out")

# %% [markdown]
# First a question that needs no law: how much of the change of motion can *any* impulse at the contact explain? What is left is the error of the camera, or a part that is not rigid. No law can do better than this.
#
# All errors are a share of the motion before, in the metric of the kinetic energy.

# %%
floor = measured.unexplained()
print(f"any impulse at the contact leaves {100 * floor:.1f} %")

# %% [markdown]
# ## Two constants
#
# `fit_impacts` finds the friction and the restitution that agree best. The interval of 95 % comes from the profile likelihood: the other parameter is free to move along.

# %%
fit = fit_impacts(measured[half])
intervals = {one.name: (one.low, one.best, one.high) for one in fit.parameters}
for name, (low, best, high) in intervals.items():
    known = "" if DATA else f"   the truth: {TRUTH[name]:g}"
    print(f"{name:<12} {best:.4f}   95 % interval {low:.4f} to {high:.4f}{known}")
held_out = fit.error_of(measured[~half])
print(
    f"error on the fitted half {100 * fit.error:.2f} %, on the half that was held out {100 * held_out:.2f} %"
)

# %% [markdown]
# The picture shows the same: how the error grows away from the best pair. The cross has the intervals.

# %%
frictions, restitutions = np.linspace(0.05, 0.4, 36), np.linspace(0.3, 0.8, 36)
errors = np.array(
    [
        [np.linalg.norm(measured[half].differences(f, e), axis=1).mean() for f in frictions]
        for e in restitutions
    ]
)
_, axes = plt.subplots(figsize=(7, 4.6), layout="constrained")
levels = axes.contourf(frictions, restitutions, 100 * errors, levels=14, cmap="viridis")
plt.colorbar(levels, ax=axes, label="error on the fitted half [% of the motion before]")
(fl, fb, fh), (el, eb, eh) = intervals["friction"], intervals["restitution"]
axes.errorbar(
    fb,
    eb,
    xerr=[[fb - fl], [fh - fb]],
    yerr=[[eb - el], [eh - eb]],
    color="white",
    capsize=4,
    label="fit, 95 % intervals",
)
if not DATA:
    axes.plot(*TRUTH.values(), "r+", markersize=12, label="the truth")
axes.set(xlabel="friction [1]", ylabel="restitution [1]")
axes.legend()
plt.show()

# %% [markdown]
# ## Do friction and restitution depend on the impact?
#
# They may be linear in what the motion before says: the angle of `incidence`, the speed of `approach`, the speed of `slip`, the `lever`. A model with more parameters fits its own half at least as well. The half that was held out decides whether it is better.

# %%
MODELS = {
    "constants": ((), ()),
    "restitution by incidence": ((), ("incidence",)),
    "and friction by lever": (("lever",), ("incidence",)),
}
fits = {
    name: fit_impacts(measured[half], friction_by=friction_by, restitution_by=restitution_by)
    for name, (friction_by, restitution_by) in MODELS.items()
}
models = pd.DataFrame(
    [
        {
            "model": name,
            "parameters": len(one.parameters),
            "fitted half [%]": 100 * one.error,
            "held out [%]": 100 * one.error_of(measured[~half]),
        }
        for name, one in fits.items()
    ]
)
models.round(2)

# %%
for one in fits["and friction by lever"].parameters[2:]:
    says = "nothing is seen: 0 is inside" if one.low <= 0 <= one.high else "it is seen: 0 is outside"
    print(f"{one.name:<26} {one.best:+.3f}   {one.low:+.3f} to {one.high:+.3f}   {says}")

# %% [markdown]
# ## Which law?
#
# Poisson, Stronge and Newton define restitution in three ways. They differ where slip stops or turns round in the impact. Again the half that was held out decides.

# %%
laws = {
    law: fit_impacts(measured[half], law=law).error_of(measured[~half])
    for law in ("poisson", "stronge", "newton")
}
for law, error in laws.items():
    print(f"{law:<8} {100 * error:.2f} % held out")

# %% [markdown]
# ## A body in space: tosses of a cube
#
# A toss is a whole motion: many impacts, in space. `MeasuredTosses` follows each toss by the engine from its first state, and says how far the engine is from the film. Three tosses are with the project; all 570 come with `CAROM_DATA`.
# For a fit of the tosses see `carom.measured.fit_tosses`; it takes minutes.

# %%
folder = carom.data.fetch("cube-tosses", DATA) if DATA else ROOT / "apps/carom-py/tests/data/cube-tosses"
tosses = carom.data.cube_tosses(folder)
published = tosses.errors(0.18, 0.125)
print(f"{len(tosses)} tosses, constants as published with the data: {published}")

# %%
_, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
toss = tosses.states[0]
times = tosses.interval * np.arange(len(toss))
followed = carom.tosses(
    tosses.body,
    position=toss[:1, :3],
    attitude=toss[:1, 3:7],
    velocity=toss[:1, 7:10],
    spin=toss[:1, 10:],
    friction=0.18,
    restitution=0.125,
    interval=tosses.interval,
    count=len(toss),
)
axes.plot(times, 1000 * toss[:, 2], ".", color="#D55E00", label="film")
axes.plot(times, 1000 * followed.position[0, :, 2], color="#0072B2", label="engine")
axes.set(xlabel="time [s]", ylabel="height of the centre [mm]", title="Toss 1")
axes.legend(frameon=False)
plt.show()

# %% [markdown]
# Try it: put your own measurements into `MeasuredImpacts`; every array is SI, one impact a row. The book's page *Measured data decide* has the numbers of the full data sets.

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
# # How physics engines differ
#
# You learn how to ask other physics engines cases whose answers are known, how a judge compares them, and why two good engines give the same part another spin.
# The cases and the judge are in `carom.referee`; each engine is asked through its own interface.
# You need `pip install "./apps/carom-py[notebooks]"`, which brings Box2D, pymunk and MuJoCo; Drake and PyBullet are asked too where they are installed.

# %%
import os
import time
from collections import Counter
from typing import Any

import carom
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from carom import referee

# Ask every case (1), or every fourth (4): MuJoCo takes small steps, and all cases cost it about ten seconds. One group is asked whole.
EVERY = int(os.environ.get("CAROM_EVERY", "1"))
# How far an answer may be off and still agree: engines step through time. A share of the motion before.
WITHIN = 1e-3

# %%
cases = [
    case
    for k, case in enumerate(referee.cases())
    if k % EVERY == 0 or case["group"] == "one contact, poisson"
]
print(f"{len(cases)} cases are asked; engines here: {', '.join(referee.installed())}")
pd.Series(Counter(case["group"] for case in cases), name="cases").to_frame()

# %% [markdown]
# ## The judge
#
# *agree*: the law of the case allows the answer. *other*: another law of restitution, or another convention, gives it. *differ*: no law gives it.

# %%
answers: dict[str, list[dict[str, Any]]] = {}
for engine in referee.installed():
    begun = time.perf_counter()
    answers[engine] = referee.ask(engine, cases)
    print(f"{engine}: {time.perf_counter() - begun:.1f} s")
judged = referee.judge(answers, cases, within=WITHIN)
print(judged)

# %% [markdown]
# ## Which law does each engine follow?
#
# Poisson's law asks for a share of the normal *impulse*, Newton's law for a share of the normal *velocity*, Stronge's law for a share of the *work*. All three give the same answer where the slip does not stop. So an engine agrees with Poisson's law in many cases although it does not have that law.

# %%
poisson = [case for case in cases if case["group"] == "one contact, poisson"]
words = {
    name: {one["case"]: one for one in engine.judged}
    for name, engine in zip(answers, judged.engines, strict=True)
}
follows = {
    engine: Counter(
        "agrees"
        if (one := words[engine][case["case"]])["verdict"] == "agrees"
        else f"follows {one['nearest']}"
        if one["verdict"] == "other_convention"
        else "no law"
        for case in poisson
    )
    for engine in words
}
pd.DataFrame(follows).fillna(0).astype(int)

# %% [markdown]
# Carom's walk says what the contact does in each case, by the types of Wang and Mason. Now the pattern is clear: see which types agree.

# %%
kinds = {case["case"]: carom.impact(case["impact"]).staged for case in poisson}
rows = [
    {
        "what the contact does": f"type {kinds[case['case']].type}: {kinds[case['case']].class_}",
        "engine": engine,
        "agrees": words[engine][case["case"]]["verdict"] == "agrees",
    }
    for engine in words
    for case in poisson
]
by_type = pd.DataFrame(rows).groupby(["what the contact does", "engine"])["agrees"].agg(["sum", "count"])
(by_type["sum"].astype(str) + " of " + by_type["count"].astype(str)).unstack()

# %% [markdown]
# ## One case taken apart
#
# Many engines solve *one complementarity problem for each step*. It knows only the end of the impact: the normal velocity after is −e times that before, and friction acts against the slip *after* the impact. If the slip turns round, friction has the last direction for the whole impulse.
#
# Routh's walk goes *through* the impact: the normal impulse grows, friction acts against the slip of that moment, and it turns when the slip turns.
#
# The function below solves the one problem by hand, by trying the three possible ends.


# %%
def contact_of(impact: dict[str, Any]) -> tuple[Any, Any, Any]:
    """Inverse mass of the contact, its velocity before (tangent, normal), and what an impulse does to the body."""
    body, contact = impact["body"], impact["contact"][0]
    n = np.array(contact["normal"]) / np.linalg.norm(contact["normal"])
    t, r = np.array([n[1], -n[0]]), np.array(contact["point"])
    # Rows: x, y, spin; columns: tangential and normal impulse.
    jacobian = np.array([[t[0], n[0]], [t[1], n[1]], [r[0] * t[1] - r[1] * t[0], r[0] * n[1] - r[1] * n[0]]])
    response = jacobian / np.array([[body["mass"]], [body["mass"]], [body["inertia"]]])
    before = jacobian.T @ np.array([*body["velocity"], body["spin"]])
    return jacobian.T @ response, before, response


def one_step(impact: dict[str, Any]) -> Any:
    """The impulse (tangent, normal) of one complementarity problem with Newton's restitution."""
    w, before, _ = contact_of(impact)
    friction, restitution = impact["contact"][0]["friction"], impact["contact"][0]["restitution"]
    # It sticks in the end: both velocities are known.
    p = np.linalg.solve(w, np.array([0.0, -restitution * before[1]]) - before)
    if abs(p[0]) <= friction * p[1]:
        return p
    for way in (1.0, -1.0):
        # It slips this way in the end: friction is against it, all of the time.
        line = np.array([-way * friction, 1.0])
        p = line * (-(1 + restitution) * before[1] / (w[1] @ line))
        if way * (before + w @ p)[0] >= 0 and p[1] >= 0:
            return p
    raise ValueError("no end is consistent")


def spin_after(impact: dict[str, Any], impulse: Any) -> float:
    """The spin after an impulse."""
    return float(impact["body"]["spin"] + contact_of(impact)[2][2] @ impulse)


# %%
def off(impact: dict[str, Any], answer: dict[str, Any]) -> float:
    """How far an engine's spin is from that of one complementarity problem, as a share of the larger one [1]."""
    mine, theirs = spin_after(impact, one_step(impact)), answer["bodies"][0]["spin_rad_s"]
    return float(abs(mine - theirs) / max(abs(mine), abs(theirs)))


# Drake has no restitution, and refuses these cases.
given = {engine: {answer["case"]: answer for answer in said if "bodies" in answer} for engine, said in answers.items()}
given = {engine: said for engine, said in given.items() if all(case["case"] in said for case in poisson)}
like_one_step = {
    engine: float(np.mean([off(case["impact"], given[engine][case["case"]]) < 1e-2 for case in poisson]))
    for engine in given
}
for engine, share in like_one_step.items():
    print(
        f"{engine}: the spin of one complementarity problem, to 1 %, in {100 * share:.0f} % of {len(poisson)} cases"
    )

# %% [markdown]
# The picture is the plane of impulses. Routh's walk is the line with corners: first friction acts one way, and where the slip is zero it turns. On the two grey lines friction had one direction all of the time. The one problem ends on such a line, because it does not know that the slip was ever the other way.


# %%
def apart(case: dict[str, Any]) -> float:
    """How far the spin of the one problem is from that of the walk [rad/s]."""
    return abs(spin_after(case["impact"], one_step(case["impact"])) - kinds[case["case"]].spin_rad_s)


turned = max((case for case in poisson if kinds[case["case"]].class_ == "C-reversed"), key=apart)
impact, walk = turned["impact"], kinds[turned["case"]]
path = [(0.0, 0.0)] + [
    (stage.contacts[0].tangential_impulse_N_s[1], stage.contacts[0].normal_impulse_N_s[1])
    for stage in walk.stages
]
step = one_step(impact)


def impulse_of(answer: dict[str, Any]) -> Any:
    """The impulse that an engine's answer means, as near as can be."""
    body, after = impact["body"], answer["bodies"][0]
    change = np.array([*after["velocity_m_s"], after["spin_rad_s"]]) - np.array(
        [*body["velocity"], body["spin"]]
    )
    return np.linalg.lstsq(contact_of(impact)[2], change, rcond=None)[0]


_, axes = plt.subplots(figsize=(7.5, 5.2), layout="constrained")
top = 1.15 * max(path[-1][1], step[1])
for way in (1, -1):
    axes.plot(
        [0, way * impact["contact"][0]["friction"] * top],
        [0, top],
        color="0.6",
        lw=1,
        label="full friction" if way == 1 else None,
    )
w, before, _ = contact_of(impact)
across = np.array(axes.get_xlim())
axes.plot(
    across, -(before[0] + w[0, 0] * across) / w[0, 1], color="#009E73", ls="--", label="the slip is zero"
)
axes.plot(
    across, -(before[1] + w[1, 0] * across) / w[1, 1], color="#CC79A7", ls=":", label="compression ends"
)
axes.plot(*np.array(path).T, "o-", color="#0072B2", label="Routh's walk (Carom)")
axes.plot(*step, "s", color="black", ms=9, mfc="none", label="one complementarity problem")
for (engine, said), marker in zip(given.items(), "x+1*2", strict=False):
    if "bodies" in said[turned["case"]]:
        axes.plot(
            *impulse_of(said[turned["case"]]), marker, color="#D55E00", ms=11, mew=2, ls="none", label=engine
        )
axes.set(
    xlim=across,
    ylim=(0, top),
    xlabel="tangential impulse [N s]",
    ylabel="normal impulse [N s]",
    title=f"{turned['case']}: the slip turns round in compression",
)
axes.legend(frameon=False, loc="center left", bbox_to_anchor=(1.0, 0.5))
plt.show()

# %%
spins = {
    "before": impact["body"]["spin"],
    "Routh's walk, in closed form": turned["expected"]["answers"][0]["bodies"][0]["spin_rad_s"],
    "Carom": walk.spin_rad_s,
    "one complementarity problem": spin_after(impact, step),
}
spins |= {
    engine: said[turned["case"]]["bodies"][0]["spin_rad_s"]
    for engine, said in given.items()
    if "bodies" in said[turned["case"]]
}
for name, spin in spins.items():
    print(f"{name:<30} {spin:+9.4f} rad/s")

# %% [markdown]
# ## Restitution: asked and seen
#
# Balls, and bodies by Newton's law: here the coefficient that is asked is what the normal velocity must show. A point on the line is right. MuJoCo has no coefficient of restitution; a damped spring stands for it.

# %%
asked = [case for case in cases if case["group"] in ("ball", "one contact, newton")]
figure, every = plt.subplots(
    1,
    len(words),
    figsize=(3.6 * len(words), 3.6),
    layout="constrained",
    sharex=True,
    sharey=True,
    squeeze=False,
)
restitution_error = {}
for axes, (engine, said) in zip(every[0], words.items()):
    pairs = np.array(
        [
            (case["impact"]["contact"][0]["restitution"], said[case["case"]]["restitution"])
            for case in asked
            if said[case["case"]]["restitution"] is not None
        ]
    )
    restitution_error[engine] = float(np.abs(pairs[:, 1] - pairs[:, 0]).max())
    axes.plot([0, 1], [0, 1], color="0.6", lw=1)
    axes.plot(*pairs.T, "o", ms=4, color="#0072B2", mfc="none")
    axes.set(xlabel="restitution asked [1]", title=engine)
every[0][0].set(ylabel="restitution seen [1]")
plt.show()
for engine, error in restitution_error.items():
    print(f"{engine}: off by {error:.2g} at most")

# %% [markdown]
# Try it: an engine of your own needs one JSON object a line. `referee.ask("mine=COMMAND", cases)` asks it, or read `python -m carom.referee --help`.

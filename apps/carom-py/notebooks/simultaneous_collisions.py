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
# # Two points at once: a paper's formulas, derived again
#
# You learn how Carom derives an impact with two contacts in closed form, and how a printed formula is judged by derivation.
# The paper is by Polukoshko, Viba and others, *Simultaneous collisions of rigid bodies in more than one point*; at the end you have a table of every formula and statement that it prints, with a verdict for each.
# You need `pip install "./apps/carom-py[notebooks]"` (SymPy, Z3, matplotlib); the whole table takes about two minutes of one core.

# %%
import time
from collections import Counter

import carom
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import sympy as sp
from carom.symbolic import paper
from IPython.display import Latex, Markdown, display

# The sections of the paper that are derived in the table below. Take some out and it is faster: ("4",) needs seconds.
SECTIONS = ("1", "3", "4", "5.1", "5.2")

# %% [markdown]
# ## One problem in symbols
#
# A cylinder rolls on a plane and touches it at A. Then it strikes a second surface at K. γ is half of the angle between the two contacts, b is J/(m a²), f is the friction.
# The dictionary has the keys of an impact file, but its numbers are symbols.

# %%
cylinder = {
    "body": {"mass": "m", "inertia": "m*a**2*b", "velocity": ["omega0*a", 0], "spin": "-omega0"},
    "contact": [
        {"name": "A", "point": [0, "-a"], "normal": [0, 1], "friction": "f"},
        {
            "name": "K",
            "point": ["a*sin(2*gamma)", "-a*cos(2*gamma)"],
            "normal": ["-sin(2*gamma)", "cos(2*gamma)"],
            "friction": "f",
        },
    ],
}
assumed = ("0 < gamma < pi/2", "a > 0", "b > 0", "omega0 > 0")
ways = carom.derive(cylinder, assume=assumed)
print(f"{len(ways)} of {len(ways) + len(ways.discarded)} hypotheses can hold:")
for way in ways:
    print(f"    {way.hypothesis}")

# %% [markdown]
# A *hypothesis* says what each contact does: it separates, it sticks, or it slips one way or the other. Two contacts have 4 × 4 hypotheses.
# Carom derives all of them. Z3 then looks for numbers at which all conditions of a hypothesis hold. Where there are none, the hypothesis is discarded, and the reason is told. *border* means: it holds only where one of its inequalities is an equality, and there another hypothesis mostly says the same.


# %%
def shown(frame: pd.DataFrame) -> None:
    """A table with all of its text."""
    left = [{"selector": "th, td", "props": [("text-align", "left !important")]}]
    display(frame.style.hide(axis="index").set_table_styles(left))


why = [(one.title, one.existence.verdict, one.existence.why) for one in ways.discarded]
shown(pd.DataFrame(why, columns=["discarded hypothesis", "it is", "why"]))

# %% [markdown]
# ## One derivation, step by step
#
# Here both contacts slip. The unknowns are the velocity after, the spin after, and two impulses at each contact.

# %%
both_slip = ways["A slips-, K slips-"]
display(Markdown(both_slip._repr_markdown_()))

# %% [markdown]
# The paper prints the normal impulse at A. Is it the same? Exact arithmetic answers: the difference is zero, and not only small.

# %%
printed = "-m*omega0*a*(cos(2*gamma) + f*sin(2*gamma))/(sin(2*gamma)*(f**2 + 1))"
derived = both_slip.contact("A").normal_impulse
difference = both_slip.simplify(both_slip.problem.names.read(printed) - derived)
display(Latex(f"$\\displaystyle N_A = {sp.latex(derived)}$"))
print(f"printed less derived: {difference}")

# %% [markdown]
# ## Where each hypothesis holds
#
# The picture shows which end state belongs to which angle and friction. Where two colours lie over each other, the law allows several end states, and the law alone does not say which one happens. The counts below tell how many there are.

# %%
figure, both = plt.subplots(1, 2, figsize=(11, 5.2), layout="constrained", sharey=True)
for axes, (b, body) in zip(both, ((0.5, "a full cylinder"), (1.0, "a thin tube")), strict=True):
    ways.draw(
        x=("gamma", 0.01, 1.56),
        y=("f", 0.0, 2.0),
        values={"m": 1, "a": 1, "omega0": 1, "b": b},
        points=161,
        axes=axes,
    )
    axes.set(
        xlabel="γ, half of the angle between A and K [rad]",
        ylabel="friction f [1]" if b == 0.5 else "",
        title=f"b = {b:g}: {body}",
    )
plt.show()
gamma, friction = (
    axis.ravel() for axis in np.meshgrid(np.linspace(0.01, 1.56, 161), np.linspace(0.0, 2.0, 161))
)
for b in (0.5, 1.0):
    numbers = {"m": 1, "a": 1, "omega0": 1, "b": b, "gamma": gamma, "f": friction}
    states = np.sum([way.at(numbers).holds for way in ways], axis=0)
    print(
        f"b = {b:g}: {states.min()} to {states.max()} end states; several in {100 * (states > 1).mean():.0f} % of the picture"
    )

# %% [markdown]
# ## A misprint, found in three ways
#
# In section 4 a rod turns about its support A and falls on its support B. The paper prints the impulse at A.
# We compare the printed formula, the derived formula, and the engine, which knows nothing of formulas.

# %%
rod = {
    "body": {"mass": "m", "inertia": "m*l**2/12", "velocity": [0, "-omega0*a"], "spin": "-omega0"},
    "contact": [
        {"name": "A", "point": ["-a", 0], "normal": [0, 1], "friction": 0},
        {"name": "B", "point": ["b", 0], "normal": [0, 1], "friction": 0},
    ],
}
stays = carom.derive(rod, "A slips, B slips", assume=["a > 0", "b > 0", "l > 0", "omega0 > 0"])
numbers = {"m": 1.0, "l": 1.0, "a": 0.4, "b": 0.4, "omega0": 1.0}
names = stays.problem.names
values = {names.symbol(name): value for name, value in numbers.items()}
claim = next(one for one in paper.claims("4") if one.key == "SYA")
engine = carom.impact(
    {
        "body": {"mass": 1.0, "inertia": 1 / 12, "velocity": [0, -0.4], "spin": -1.0},
        "contact": [
            {"name": "A", "point": [-0.4, 0], "normal": [0, 1], "friction": 0},
            {"name": "B", "point": [0.4, 0], "normal": [0, 1], "friction": 0},
        ],
    }
)
assert isinstance(engine, carom.PlanarImpact)
impulse_at_a = {
    "as printed": float(names.read(claim.printed).subs(values)),
    "derived": float(stays.contact("A").normal_impulse.subs(values)),
    "engine": engine.end_states[0].contacts[0].normal_impulse_N_s,
}
print(f"printed: {claim.printed}\nverdict: {claim.verdict}\nright:   {claim.right}\n")
for name, value in impulse_at_a.items():
    print(f"{name:<11} {value:+.10f} N s")

# %% [markdown]
# As printed the impulse is negative: the support would have to pull the rod. So the printed formula cannot be right.
#
# ## The whole table
#
# A verdict is never written down. It is derived here, now:
#
# - **agrees**: the printed formula is the derived one.
# - **misprint**: the printed formula is not right, but the formula that is obviously meant is right.
# - **wrong in print**: the printed formula or statement is not right. The column *right* shows the right formula, or numbers that contradict the statement.

# %%
begun, rows = time.perf_counter(), []
for section in SECTIONS:
    claims = paper.claims(section)
    rows += [(one.section, one.key, one.what, one.printed, one.verdict, one.right) for one in claims]
    print(
        f"section {section}: {len(claims)} formulas and statements, {time.perf_counter() - begun:.0f} s so far"
    )
table = pd.DataFrame(rows, columns=["section", "name", "of what", "printed", "verdict", "right"])
counts = dict(Counter(table["verdict"]))
print(
    f"{len(table)} formulas and statements: {', '.join(f'{count} {verdict}' for verdict, count in counts.items())}"
)

# %%
shown(table)

# %% [markdown]
# ## The errata

# %%
errata = table[table["verdict"] != "agrees"]
shares = table.groupby(["section", "verdict"]).size().unstack(fill_value=0)
axes = shares.plot.barh(
    stacked=True, figsize=(8, 3), color=["#0072B2", "#E69F00", "#D55E00"][: shares.shape[1]]
)
axes.set(xlabel="formulas and statements [number]", ylabel="section of the paper")
axes.invert_yaxis()
axes.legend(frameon=False, loc="lower right")
plt.show()
shown(errata[["section", "name", "printed", "verdict", "right"]])
print(f"{len(errata)} of {len(table)} are not right as they are printed")

# %% [markdown]
# Try it: write an impact of your own as a dictionary with symbols, and give it to `carom.derive`. `python -m carom.symbolic.paper` prints the same table in a terminal.

"""Section 1: a cylinder that rolls on A until K strikes a second surface; 2γ is the central angle between them."""

from __future__ import annotations

from functools import cache, partial
from typing import Any

from carom.symbolic import derive
from carom.symbolic.derivation import Derivation
from carom.symbolic.emptiness import Asked, exists
from carom.symbolic.paper.judging import Claim, Outcome, all_of, broken, does_not_occur, formula, may_hold, never, occurs, statement, told

ASSUME = ("0 < gamma < pi/2", "b > 0", "a > 0", "omega0 > 0")
#: The four states of the paper, in its order; K slips backward before the impact.
STATES = ("A separates, K sticks", "A separates, K slips-", "A slips-, K slips-", "A sticks, K sticks")
SECTION = "1"


def problem(restitution: Any = 0, ratio: Any = "b") -> dict[str, Any]:
    """The impact file: mass m, radius a, J = m a² b."""
    more = {"friction": "f", "restitution": restitution}
    return {
        "body": {"mass": "m", "inertia": f"m*a**2*({ratio})", "velocity": ["omega0*a", 0], "spin": "-omega0"},
        "contact": [
            {"name": "A", "point": [0, "-a"], "normal": [0, 1], **more},
            {"name": "K", "point": ["a*sin(2*gamma)", "-a*cos(2*gamma)"], "normal": ["-sin(2*gamma)", "cos(2*gamma)"], **more},
        ],
    }


@cache
def plastic(state: int, ratio: Any = "b") -> Derivation:
    """One of the four states, in the first phase."""
    return derive(problem(ratio=ratio), STATES[state - 1], assume=ASSUME, seconds=5)


@cache
def elastic(state: int, end: str) -> Derivation:
    """A hypothesis of restitution after one of the four states."""
    return derive(problem("R"), STATES[state - 1], restitution=end, assume=(*ASSUME, "0 < R", "R <= 1"), seconds=20)


def _impulse(name: str) -> tuple[Derivation, Any]:
    return plastic(3), plastic(3).contact(name).normal_impulse


def _equation(left: str, right: str) -> Outcome:
    """Whether the derived impulses and the derived spin of state 3 meet a printed equation."""
    derivation = plastic(3)
    names = derivation.problem.names
    values = {"SNA": _impulse("A")[1], "SNK": _impulse("K")[1], "omega1": -derivation.spin, "Jc": derivation.problem.bodies[0].inertia[0]}
    difference = (names.read(left) - names.read(right)).subs({names.symbol(name): value for name, value in values.items()})
    off = derivation.simplify(difference)
    return Outcome(off == 0, f"left less right is {off}")


def _signs_of_a() -> Outcome:
    algebra, (condition,) = plastic(3).mechanics.algebra, [one for one in plastic(3).conditions if one.contact == "A" and one.kind == "normal_impulse"]
    both = [exists(algebra, [Asked(sign * condition.number, "")], seconds=5) for sign in (1, -1)]
    return all_of([occurs(one) for one in both])


def _k_never_pulls() -> Outcome:
    found = derive(problem(), assume=ASSUME, seconds=5)
    open_ones = [one for one in (*found.kept, *found.discarded) if one.compression[1].slip == "open"]
    absent = [never(one.existence) for one in open_ones]
    return Outcome(None if None in absent else all(absent), f"K can separate: {', '.join(one.title for one in open_ones if not never(one.existence))}")


def _four_states() -> Outcome:
    """For b = 1: which end states there are."""
    found = derive(problem(ratio=1), assume=ASSUME, seconds=5)
    return Outcome({one.title for one in found} == set(STATES), f"the end states are {'; '.join(one.title for one in found)}")


def a_leaves(ratio: Any) -> Outcome:
    """Where the printed S_NA is negative A separates: there state 1 or 2 holds."""
    push = next(one for one in plastic(3, ratio).conditions if one.contact == "A" and one.kind == "normal_impulse")
    first, second = plastic(1, ratio), plastic(2, ratio)
    for one in first.conditions:
        for two in second.conditions:
            # Each derivation has a field of its own.
            asked = [Asked(_moved(first, -push.slack), ""), broken(one), Asked(_moved(first, -two.slack), "")]
            found = exists(first.mechanics.algebra, asked, seconds=5)
            if found.verdict == "holds":
                ends = derive(problem(ratio=ratio), assume=ASSUME, seconds=5).at(found.example or {})
                return Outcome(False, f"at {told(found)} it is {' or '.join(one.title for one, _ in ends)}")
            if found.verdict == "unknown":
                return Outcome(None)
    return Outcome(True)


def _moved(derivation: Derivation, expression: Any) -> Any:
    return derivation.mechanics.algebra.element(expression)


def _slip_after(state: int, end: str, what: str) -> Outcome:
    return does_not_occur(elastic(state, end).existence, what)


def _free_motion() -> Outcome:
    """After states 1 and 2: whether A always stays open."""
    outcomes = []
    for state, end in ((1, "A separates, K separates (sticks)"), (2, "A separates, K separates (slips-)"), (2, "A separates, K separates (sticks)")):
        free = elastic(state, end)
        lifts = next(one for one in free.conditions if one.phase == "restitution" and one.contact == "A")
        found = may_hold(free, beside=[broken(lifts)], without=[lifts])
        outcomes.append(does_not_occur(found, f"after state {state} A is struck again unless {lifts.reduced} >= 0, as at"))
    return all_of(outcomes)


def _turning_about_a(state: int) -> Outcome:
    """Whether the cylinder can end turning about A, which sticks, while K rebounds."""
    ends = [elastic(state, f"A sticks, K separates ({word})") for word in ("sticks", "slips+", "slips-")]
    turning = [one for one in ends if one.spin != 0]
    absent = [never(one.existence) for one in turning]
    if any(one is False for one in absent):
        return Outcome(True)
    if None in absent:
        return Outcome(None, "Z3 did not decide")
    others = [f"A slips-, K separates ({word})" for word in ("sticks", "slips+", "slips-")] + ["A sticks, K sticks"]
    instead = [one for one in (elastic(state, end) for end in others) if one.existence.verdict == "holds"]
    said = [f"{one.hypothesis}" + (f" with the slip {one.contact('A').slip} at A" if not one.free and one.contact("A").slip != 0 and one.restitution == elastic(3, others[2]).restitution else "") for one in instead]
    return Outcome(False, f"no such end state; there are {'; '.join(said)}")


def claims() -> list[Claim]:
    """Everything that section 1 prints."""
    row = "(-f + f*cos(2*gamma) + f**2*sin(2*gamma) + b*sin(2*gamma)*f**2 + b*sin(2*gamma))/(b*sin(2*gamma)*(f**2 + 1))"
    equations = [
        ("m*omega0*a*cos(2*gamma)", "-SNK*f - SNA*f*cos(2*gamma) - SNA*sin(2*gamma)", "momentum along the second surface"),
        ("m*omega0*a*sin(2*gamma)", "SNK + SNA*cos(2*gamma) - SNA*f*sin(2*gamma)", "momentum along its normal"),
        ("Jc*omega0 - Jc*omega1", "SNK*f*a + SNA*f*a", "angular momentum"),
    ]
    out = [statement(f"equation.{k + 1}", SECTION, f"state 3, {what}", f"{left} = {right}", partial(_equation, left, right)) for k, (left, right, what) in enumerate(equations)]
    out += [
        formula("SNA", SECTION, "state 3, row 1: normal impulse at A", "-m*omega0*a*(cos(2*gamma) + f*sin(2*gamma))/(sin(2*gamma)*(f**2 + 1))", lambda: _impulse("A")),
        formula("SNK", SECTION, "state 3, row 2: normal impulse at K", "m*omega0*a*(sin(2*gamma)**2 + cos(2*gamma)**2)/(sin(2*gamma)*(f**2 + 1))", lambda: _impulse("K")),
        formula("row_3", SECTION, "state 3, row 3: of the unknowns of the system it can only be the spin", f"m*omega0*a*{row}", lambda: (plastic(3), -plastic(3).spin), meant=f"omega0*{row}"),
        formula("rate", SECTION, "state 3, row 4: roll rate after", f"omega0*{row}", lambda: (plastic(3), -plastic(3).spin)),
        formula("row_5", SECTION, "state 3, row 5: moment of inertia", "m*a**2*b", lambda: (plastic(3), plastic(3).problem.bodies[0].inertia[0])),
        statement("signs.K", SECTION, "normal impulse at K", "always positive: K cannot separate", _k_never_pulls),
        statement("signs.A", SECTION, "normal impulse at A in state 3", "can be positive and negative", _signs_of_a),
        statement("state", SECTION, "b = 1, no restitution: end states", "the four states, and no others", _four_states),
        statement("a_leaves.b=1", SECTION, "b = 1: where the printed S_NA is negative", "A separates", lambda: a_leaves(1)),
        statement("a_leaves", SECTION, "any b: where the printed S_NA is negative", "A separates", lambda: a_leaves("b")),
        statement("stop.slip", SECTION, "with restitution: K slips in compression", "it goes on to slip: sliding throughout, or it stops in the first phase", lambda: _slip_after(2, "A separates, K separates (sticks)", "the slip at K stops in restitution, as at")),
        statement("reversal.slip", SECTION, "with restitution: both slip in compression", "none slips the other way in the end", lambda: _slip_after(3, "A slips-, K separates (slips+)", "the slip at K reverses in restitution, as at")),
        statement("state_5.a", SECTION, "state 5, after states 1 and 2", "free motion: A stays open", _free_motion),
        statement("state_6.slip", SECTION, "state 6, after state 3", "rotation round A without sliding", lambda: _turning_about_a(3)),
        statement("state_7.slip", SECTION, "state 7, after state 4", "rotation round A without sliding", lambda: _turning_about_a(4)),
    ]
    return out


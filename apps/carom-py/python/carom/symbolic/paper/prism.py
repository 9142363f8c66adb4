"""Section 3: a prism that rolls over its edge A until its next edge K strikes the floor."""

from __future__ import annotations

from functools import cache, partial
from typing import Any

import sympy as sp

from carom.symbolic import derive
from carom.symbolic.derivation import Derivation
from carom.symbolic.emptiness import Asked
from carom.symbolic.paper.judging import Claim, Outcome, all_of, broken, does_not_occur, formula, may_hold, never, occurs, statement

SECTION = "3"
#: Of a homogeneous regular prism of n sides.
HOMOGENEOUS = "m*a**2*(2 + cos(2*pi/n))/6"
STATES = ("A sticks, K sticks", "A slips+, K slips+", "A separates, K sticks", "A separates, K slips+")
#: Items 5 to 8 of the list: state of the first phase, and restitution.
ELASTIC = {5: (3, "A separates, K separates (sticks)"), 6: (4, "A separates, K separates (slips+)"), 7: (2, "A separates (slips+), K separates (slips+)"), 8: (1, "A sticks, K separates (sticks)")}


def regular(sides: Any = "n", inertia: str = "Jc", restitution: Any = 0) -> dict[str, Any]:
    """A regular prism: circumradius a, pi/n half of the angle between its edges."""
    at = f"pi/({sides})"
    return _file(f"a*sin({at})", f"a*sin({at})", f"a*cos({at})", inertia.replace("n)", f"({sides}))"), restitution)


def irregular() -> dict[str, Any]:
    """Any prism: a and b from the mass centre to A and K, gamma the angle between them."""
    length = "sqrt(a**2 + b**2 - 2*a*b*cos(gamma))"
    return _file(f"(a**2 - a*b*cos(gamma))/{length}", f"(b**2 - a*b*cos(gamma))/{length}", f"a*b*sin(gamma)/{length}", "Jc", 0)


def _file(to_a: str, to_k: str, height: str, inertia: str, restitution: Any) -> dict[str, Any]:
    more = {"normal": [0, 1], "friction": "f", "restitution": restitution}
    return {
        "body": {"mass": "m", "inertia": inertia, "velocity": [f"omega0*({height})", f"-omega0*({to_a})"], "spin": "-omega0"},
        "contact": [{"name": "A", "point": [f"-({to_a})", f"-({height})"], **more}, {"name": "K", "point": [to_k, f"-({height})"], **more}],
    }


def assume(sides: Any = "n", least: int = 3) -> tuple[str, ...]:
    """What is assumed of a regular prism."""
    return ("a > 0", "omega0 > 0", "Jc > 0", *((f"n >= {least}",) if sides == "n" else ()))


@cache
def state(number: int, sides: Any = "n", inertia: str = "Jc", least: int = 3) -> Derivation:
    """One of the first four items of the list."""
    return derive(regular(sides, inertia), STATES[number - 1], assume=assume(sides, least), seconds=5)


@cache
def item(number: int) -> Derivation:
    """One of the others."""
    first, end = ELASTIC[number]
    return derive(regular(restitution="R"), STATES[first - 1], restitution=end, assume=(*assume(), "0 < R", "R <= 1"), seconds=5)


def _item(number: int) -> Outcome:
    return occurs((state(number) if number <= 4 else item(number)).existence)


def _impulse(name: str, number: int = 1) -> tuple[Derivation, Any]:
    return state(number), state(number).contact(name).normal_impulse


@cache
def sticking(sides: Any) -> tuple[Derivation, Any]:
    """Friction from which a prism whose A separates sticks at K, as its inequality says."""
    sticks = state(3, sides, HOMOGENEOUS)
    f = sticks.problem.names.symbol("f")
    bounds = [one.reduced for one in sticks.conditions if one.kind == "friction_cone" and one.reduced.has(f)]
    return sticks, max((root for bound in bounds for root in sp.solve(bound, f)), key=float)


def threshold(sides: int) -> Outcome:
    """Whether an impact is non-sliding from f = 1/tan(pi/n) on, and sliding below."""
    found, stays = [], False
    for number in (1, 2, 3, 4):
        of = state(number, sides, HOMOGENEOUS)
        names = of.problem.names
        bound, f = names.read(f"cot(pi/{sides})"), names.symbol("f")
        found.append(does_not_occur(may_hold(of, relations=[f < bound if number in (1, 3) else f > bound])))
        stays = stays or (number == 1 and of.existence.verdict == "holds")
    outcome = all_of(found)
    if outcome.holds is not False:
        return outcome
    derivation, least = sticking(sides)
    return Outcome(False, f"f >= {sp.sstr(sp.radsimp(sp.simplify(least)))} = {float(least):.10g}")


def _never_stays(number: int, sides: Any, least: int) -> Outcome:
    """Whether A stays in none of the homogeneous prisms in this state."""
    of = state(number, sides, HOMOGENEOUS, least)
    return does_not_occur(of.existence, f"A stays, with the impulse {of.contact('A').normal_impulse}, as at")


def _a_separates(sides: int) -> Outcome:
    return all_of([does_not_occur(state(number, sides, HOMOGENEOUS).existence) for number in (3, 4)])


@cache
def _irregular() -> Derivation:
    return derive(irregular(), STATES[0], assume=("a > 0", "b > 0", "omega0 > 0", "Jc > 0", "0 < gamma < pi"), seconds=5)


def _bound(text: str) -> Outcome:
    """Whether A pushes where Jc is below this, and would pull where it is above."""
    derivation = _irregular()
    names = derivation.problem.names
    printed, inertia = names.read(text), names.symbol("Jc")
    (push,) = [one for one in derivation.conditions if one.contact == "A" and one.kind == "normal_impulse"]
    against = [([Asked(push.number, "A pushes")], inertia > printed), ([broken(push)], inertia < printed)]
    found = [does_not_occur(may_hold(derivation, beside=beside, relations=[relation], without=derivation.conditions)) for beside, relation in against]
    (largest,) = sp.solve(push.slack, inertia)
    return Outcome(all_of(found).holds, f"Jc <= {derivation.simplify(largest)}")


def _obtuse() -> Outcome:
    derivation = _irregular()
    (push,) = [one for one in derivation.conditions if one.contact == "A" and one.kind == "normal_impulse"]
    cosine = derivation.mechanics.algebra.element(derivation.problem.names.read("cos(gamma)"))
    return does_not_occur(may_hold(derivation, beside=[Asked(cosine, "the angle is acute"), Asked(push.number, "A pushes")], without=derivation.conditions))


def _k_slips(slips: bool) -> Outcome:
    slip = item(5).contact("K").slip
    return Outcome((slip != 0) == slips, f"the slip at K is {slip}")


def _k_never_separates() -> Outcome:
    found = derive(regular(), assume=assume(), seconds=5)
    open_ones = [one for one in (*found.kept, *found.discarded) if one.compression[1].slip == "open"]
    absent = [never(one.existence) for one in open_ones]
    return Outcome(None if None in absent else all(absent))


def claims() -> list[Claim]:
    """Everything that section 3 prints."""
    words = ["no point separates, non-sliding: it stops", "no point separates, it slides on", "A separates, K sticks: rotation round K", "A separates, K slips"]
    out = [statement(f"item.{k + 1}", SECTION, f"item {k + 1} of the list", f"{word}; it may be", partial(_item, k + 1)) for k, word in enumerate(words)]
    elastic = {5: "A separates, non-sliding, K rebounds", 6: "A separates, sliding, K rebounds", 7: "A does not separate, sliding, K rebounds", 8: "A does not separate, non-sliding: rotation round A"}
    out += [statement(f"item.{k}", SECTION, f"item {k} of the list", f"{word}; it may be", partial(_item, k)) for k, word in elastic.items()]
    out += [
        statement("item_5", SECTION, "item 5 of the list, a non-sliding impact", "K slips", lambda: _k_slips(True), meant="K sticks", judged_as_meant=lambda: _k_slips(False)),
        formula("SNK", SECTION, "both stay, non-sliding: normal impulse at K", "omega0*(Jc + m*a**2)/(2*a*sin(pi/n))", lambda: _impulse("K")),
        formula("SNA", SECTION, "both stay, non-sliding: normal impulse at A", "omega0*(2*m*a**2*sin(pi/n)**2 - (Jc + m*a**2))/(2*a*sin(pi/n))", lambda: _impulse("A")),
        formula("omega1", SECTION, "both stay: roll rate after", "0", lambda: (state(1), -state(1).spin)),
    ]
    out += [statement(f"sticking.{n}", SECTION, f"n = {n}: friction from which the impact is non-sliding", "f >= 1/tan(pi/n)", partial(threshold, n)) for n in (3, 4, 6, 8, 12)]
    out += [
        statement("stays.3", SECTION, "n = 3, sliding or not", "A does not separate", lambda: _a_separates(3)),
        statement("stays", SECTION, "n of 4 and more, non-sliding", "A separates", lambda: _never_stays(1, "n", 4)),
        statement("stays.4.sliding", SECTION, "n = 4, sliding", "A separates", lambda: _never_stays(2, 4, 4)),
        formula("SNA.4.sliding", SECTION, "n = 4, sliding: normal impulse at A, which is said to separate", "0", lambda: (state(2, 4, HOMOGENEOUS), state(2, 4, HOMOGENEOUS).contact("A").normal_impulse)),
        statement("irregular", SECTION, "irregular prism: A does not separate where", "Jc <= m*a*b*cos(gamma)", lambda: _bound("m*a*b*cos(gamma)"), meant="Jc <= -m*a*b*cos(gamma)", judged_as_meant=lambda: _bound("-m*a*b*cos(gamma)")),
        statement("irregular.obtuse", SECTION, "irregular prism: A does not separate", "only where the central angle is obtuse", _obtuse),
        statement("k_separates", SECTION, "K in the beginning of the impact", "never separates", _k_never_separates),
    ]
    return out

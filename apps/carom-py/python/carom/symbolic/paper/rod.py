"""Section 4: a thin rod that turns about its support A and falls on its support B; no friction."""

from __future__ import annotations

from functools import cache, partial
from typing import Any

import sympy as sp

from carom.symbolic import derive
from carom.symbolic.derivation import Derivation
from carom.symbolic.paper.judging import Claim, Outcome, all_of, does_not_occur, equal, formula, may_hold, never, occurs, same_at_random, statement

SECTION = "4"
ASSUME = ("a > 0", "b > 0", "l > 0", "omega0 > 0")
STATES = ("A slips, B slips", "A separates, B slips")


def problem(restitution: Any = 0, inertia: str = "m*l**2/12") -> dict[str, Any]:
    """The impact file: a rod of length l, its supports at a and b from its middle."""
    more = {"normal": [0, 1], "friction": 0, "restitution": restitution}
    return {
        "body": {"mass": "m", "inertia": inertia, "velocity": [0, "-omega0*a"], "spin": "-omega0"},
        "contact": [{"name": "A", "point": ["-a", 0], **more}, {"name": "B", "point": ["b", 0], **more}],
    }


@cache
def plastic(variant: int) -> Derivation:
    """Variants 1 and 2: without restitution."""
    return derive(problem(), STATES[variant - 1], assume=ASSUME, seconds=5)


@cache
def elastic(variant: int) -> Derivation:
    """Variants 3 and 4: with restitution."""
    end = ("A separates (slips), B separates (slips)", "A separates, B separates (slips)")[variant - 3]
    return derive(problem("R"), STATES[variant - 3], restitution=end, assume=(*ASSUME, "0 < R", "R <= 1"), seconds=5)


def _inertia(text: str) -> Outcome:
    """The moment of a thin rod about its middle."""
    names = plastic(1).problem.names
    x, m, length = sp.Dummy("x"), names.symbol("m"), names.symbol("l")
    right = sp.integrate(m / length * x**2, (x, -length / 2, length / 2))
    return Outcome(equal(plastic(1), text, right), str(right))


def _release(text: str) -> Outcome:
    """The rate at the strike, from the balance of energy of a rod let go at rest."""
    names = plastic(1).problem.names
    m, g, a, length, alpha = (names.symbol(name) for name in ("m", "g", "a", "l", "alpha"))
    rate = sp.Dummy("omega", positive=True)
    about_a = plastic(1).problem.bodies[0].inertia[0] + m * a**2
    square = sp.solve(sp.Eq(m * g * a * sp.sin(alpha), about_a * rate**2 / 2), rate**2)[0]
    printed = names.read(text.replace("Jc", "(m*l**2/12)"))
    return Outcome(same_at_random(printed**2, square), f"sqrt({sp.factor(square)})")


def _momentum() -> Outcome:
    """m Vcy1 − (−m Vcy0) = SYA + SYB with Vcy0 = ω0 a."""
    of = plastic(1)
    names = of.problem.names
    left = names.symbol("m") * (of.velocity[1] + names.symbol("omega0") * names.symbol("a"))
    off = of.simplify(left - sum(one.normal_impulse for one in of.contacts))
    return Outcome(off == 0, f"left less right is {off}")


def _border() -> Outcome:
    """12ab > l² decides whether A stays."""
    stays, leaves = plastic(1), plastic(2)
    names = stays.problem.names
    printed = names.read("12*a*b") - names.read("l**2")
    out = [does_not_occur(may_hold(one, relations=[printed < 0 if one is stays else printed > 0])) for one in (stays, leaves)]
    return all_of([*out, occurs(stays.existence), occurs(leaves.existence)])


def _equal_arms() -> Outcome:
    """a = b: the least a over l, to three digits."""
    names = plastic(1).problem.names
    a, length = names.symbol("a"), names.symbol("l")
    push = plastic(1).contact("A").normal_impulse.subs(names.symbol("b"), a)
    least = [one for one in sp.solve(sp.numer(sp.together(push)), a) if one.is_positive]
    share = float(least[0] / length)
    return Outcome(round(share, 3) == 0.289, f"a > {share:.6f} l")


def _b_never_separates() -> Outcome:
    found = derive(problem(), assume=ASSUME, seconds=5)
    absent = [never(one.existence) for one in (*found.kept, *found.discarded) if one.compression[1].slip == "open"]
    return Outcome(None if None in absent else all(absent))


def _without_mass_and_speed() -> Outcome:
    """Neither the condition nor k depends on mass and speed."""
    names = plastic(1).problem.names
    k = plastic(2).spin / plastic(2).problem.bodies[0].spin[0]
    border = [one.reduced for one in plastic(1).conditions if one.contact == "A"]
    moved = [plastic(2).simplify(sp.diff(one, names.symbol(name))) for one in (k, *border) for name in ("m", "omega0")]
    return Outcome(all(one == 0 for one in moved))


def _variant(number: int) -> Outcome:
    of = plastic(number) if number <= 2 else elastic(number)
    return occurs(of.existence)


def _turns_about(name: str, variant: int) -> Outcome:
    """After the impact the support does not move."""
    contact = (plastic(variant) if variant <= 2 else elastic(variant)).contact(name)
    return Outcome(contact.normal_velocity == 0, f"it moves with {contact.normal_velocity}")


def _ratio() -> tuple[Derivation, Any]:
    return plastic(2), plastic(2).spin / plastic(2).problem.bodies[0].spin[0]


def claims() -> list[Claim]:
    """Everything that section 4 prints."""
    root = "sqrt(24*g*a/(l**2 + 12*a**2))*sin(alpha)"
    under = "sqrt(24*g*a*sin(alpha)/(l**2 + 12*a**2))"
    first, first_under = "sqrt(2*m*g*a/(Jc + m*a**2))*sin(alpha)", "sqrt(2*m*g*a*sin(alpha)/(Jc + m*a**2))"
    k = "(l**2 - 12*a*b)/(l**2 + 12*b**2)"
    denominator = "12*(a + b)"
    return [
        statement("release.1", SECTION, "rate at the strike, first form", first, lambda: _release(first), meant=first_under, judged_as_meant=lambda: _release(first_under)),
        statement("release", SECTION, "rate at the strike, second form", root, lambda: _release(root), meant=under, judged_as_meant=lambda: _release(under)),
        statement("Jc", SECTION, "moment of inertia, in the text", "m*t**2/12", lambda: _inertia("m*t**2/12"), meant="m*l**2/12", judged_as_meant=lambda: _inertia("m*l**2/12")),
        statement("momentum", SECTION, "momentum along y", "m*Vcy1 - (-m*Vcy0) = SYA + SYB, Vcy0 = omega0*a", _momentum),
        formula("Vcy1", SECTION, "A stays: velocity of the middle after", "0", lambda: (plastic(1), plastic(1).velocity[1])),
        formula("SYA", SECTION, "A stays: impulse at A", f"m*omega0*(l**2*a*b - l**2)/({denominator})", lambda: (plastic(1), plastic(1).contact("A").normal_impulse), meant=f"m*omega0*(12*a*b - l**2)/({denominator})"),
        formula("SYB", SECTION, "A stays: impulse at B", f"m*omega0*(l**2 + 12*a**2)/({denominator})", lambda: (plastic(1), plastic(1).contact("B").normal_impulse)),
        formula("omega1.stays", SECTION, "A stays: spin after", "0", lambda: (plastic(1), -plastic(1).spin)),
        statement("border", SECTION, "A does not separate", "only subject to 12*a*b > l**2", _border),
        statement("border.equal", SECTION, "a = b: A does not separate", "a > 0.289*l", _equal_arms),
        statement("b_separates", SECTION, "B in the beginning of the impact", "cannot rebound", _b_never_separates),
        formula("omega1", SECTION, "A separates: spin after", f"omega0*{k}", lambda: (plastic(2), -plastic(2).spin)),
        formula("k", SECTION, "A separates: spin after by before", k, _ratio),
        formula("Vcy1.leaves", SECTION, "A separates: velocity of the middle after", f"omega0*{k}*b", lambda: (plastic(2), plastic(2).velocity[1])),
        statement("mass", SECTION, "mass and speed", "do not influence the condition and k", _without_mass_and_speed),
        *[statement(f"variant.{n}", SECTION, f"variant {n} of the rod's behaviour", "it may be", partial(_variant, n)) for n in (1, 2, 3, 4)],
        statement("variant.2.axis", SECTION, "variant 2: further rotation", "round B", lambda: _turns_about("B", 2)),
        statement("variant.3.axis", SECTION, "variant 3: further rotation", "round A", lambda: _turns_about("A", 3)),
    ]

"""Section 5: a pyramid that rolls over a lateral edge, and a body on n supports; plastic, and nothing slides."""

from __future__ import annotations

from functools import cache, partial
from typing import Any

import sympy as sp

from carom.symbolic import derive
from carom.symbolic.derivation import Derivation, Derivations
from carom.symbolic.emptiness import Asked
from carom.symbolic.paper.judging import Claim, Outcome, all_of, broken, does_not_occur, equal, formula, may_hold, occurs, statement

SECTION = "5.1"
SUPPORTS = "5.2"
#: The printed border between short and long pyramids.
BORDER = "a*sqrt(1 - 2*sin(pi/n)**2/3)"


def pyramid(sides: Any = "n") -> dict[str, Any]:
    """A homogeneous regular pyramid of height h on a base of circumradius a, O its apex; it turns about OA, and K comes down beside A.

    Axes: from the apex along the axis to the base is z, the face OAK lies symmetric about x. The mass centre is at 3h/4 from the apex; the spin
    is w times the vector from A to O, so that the edge's length stays out of the formulas.
    """
    s, c = f"sin(pi/({sides}))", f"cos(pi/({sides}))"
    q = f"(1 - 2*{s}**2/3)"
    across = f"3*m*a**2*{q}/20 + 3*m*h**2/80"
    more = {"normal": ["-h", 0, f"a*{c}"], "friction": 0}
    return {
        "body": {"mass": "m", "inertia": [across, across, f"3*m*a**2*{q}/10"], "velocity": [f"3*w*h*a*{s}/4", f"3*w*h*a*{c}/4", 0], "spin": [f"-w*a*{c}", f"w*a*{s}", "-w*h"]},
        "contact": [
            {"name": "O", "point": [0, 0, "-3*h/4"], **more},
            {"name": "A", "point": [f"a*{c}", f"-a*{s}", "h/4"], **more},
            {"name": "K", "point": [f"a*{c}", f"a*{s}", "h/4"], **more},
        ],
    }


def _assume(sides: Any) -> tuple[str, ...]:
    return ("a > 0", "h > 0", "w > 0", *(("n >= 4",) if sides == "n" else ()))


@cache
def kept(names: str, sides: Any = "n") -> Derivation:
    """The state in which these contacts keep; of n sides from four on, or of a number of them."""
    hypothesis = {name: "keeps" if name in names else "separates" for name in "OAK"}
    return derive(pyramid(sides), hypothesis, assume=_assume(sides), non_sliding=True, seconds=10)


@cache
def every(sides: Any) -> Derivations:
    """All eight states."""
    return derive(pyramid(sides), assume=_assume(sides), non_sliding=True, seconds=10)


def _long(derivation: Derivation, sides: Any, long: bool) -> Any:
    names = derivation.problem.names
    border, h = names.read(BORDER.replace("pi/n", f"pi/({sides})")), names.symbol("h")
    # Both are positive: their squares have no root.
    return h**2 > border**2 if long else h**2 < border**2


def _border() -> Outcome:
    """Whether the impulse at O, with O and K keeping, is positive above the printed height and negative below."""
    of = kept("OK")
    (push,) = [one for one in of.conditions if one.contact == "O" and one.kind == "normal_impulse"]
    asked = [(broken(push), True), (Asked(push.number, push.meaning), False)]
    found = [does_not_occur(may_hold(of, beside=[one], relations=[_long(of, "n", long)], without=of.conditions, seconds=10)) for one, long in asked]
    return Outcome(all_of(found).holds, f"{push.reduced} > 0")


def _always(names: str, sides: Any, long: bool) -> Outcome:
    """Whether a state holds for all long, or all short, pyramids."""
    of = kept(names, sides)
    found = []
    for condition in of.conditions:
        against = may_hold(of, beside=[broken(condition)], relations=[_long(of, sides, long)], without=of.conditions, seconds=10)
        found.append(does_not_occur(against, f"not {condition.meaning}, as at"))
    outcome = all_of(found)
    if outcome.holds is not False:
        return outcome
    others = [one for one in every(sides) if may_hold(one, relations=[_long(one, sides, long)], seconds=10).verdict == "holds"]
    return Outcome(False, f"of the eight states there is {' or '.join(one.hypothesis for one in others)}")


def _only_two(sides: Any) -> Outcome:
    titles = {one.hypothesis for one in every(sides)}
    two = {"O keeps, A separates, K keeps", "O separates, A separates, K keeps"}
    return Outcome(titles == two, f"{'; '.join(sorted(titles))}")


def _also(separates: str) -> Outcome:
    """Of a short pyramid: exactly these vertices separate."""
    return _always("".join(name for name in "OAK" if name not in separates), "n", False)


def supports(sides: Any = "n") -> dict[str, Any]:
    """A symmetric body on n supports on a circle of radius a, its mass centre c above them; it turns about O, and K comes down.

    Axes as in the paper: at O, eta to the foot of the body's axis, zeta along it, xi along the circle; K lies on the side of −xi. The floor may be
    turned about OK by any angle delta.
    """
    s, co = f"sin(pi/({sides}))", f"cos(pi/({sides}))"
    more = {"normal": [f"{s}*sin(delta)", f"{co}*sin(delta)", "cos(delta)"], "friction": 0}
    velocity = ["omega_eta*c - omega_zeta*a", "-omega_xi*c", "omega_xi*a"]
    return {
        "body": {"mass": "m", "inertia": ["Jt", "Jt", "Jz"], "velocity": velocity, "spin": ["omega_xi", "omega_eta", "omega_zeta"]},
        "contact": [{"name": "O", "point": [0, "-a", "-c"], **more}, {"name": "K", "point": [f"-2*a*{s}*{co}", f"-a + 2*a*{s}**2", "-c"], **more}],
    }


@cache
def on_supports(names: str, sides: Any = "n") -> Derivation:
    """The state in which these supports keep."""
    hypothesis = {name: "keeps" if name in names else "separates" for name in "OK"}
    assume = ("a > 0", "c > 0", "-pi/2 < delta < pi/2", *(("n >= 3",) if sides == "n" else ()))
    # The formula needs no example: for any n Z3 is not asked.
    return derive(supports(sides), hypothesis, assume=(*assume, _approach(sides)), non_sliding=True, discard=sides != "n", seconds=20)


def _approach(sides: Any) -> str:
    """K approaches the floor: its velocity along the normal is negative."""
    s, co = f"sin(pi/({sides}))", f"cos(pi/({sides}))"
    return f"sin(delta)*{s}*(-2*a*{s}**2*omega_zeta) + sin(delta)*{co}*(-2*a*{s}*{co}*omega_zeta) + cos(delta)*(2*a*{s}**2*omega_xi + 2*a*{s}*{co}*omega_eta) < 0"


def _omega() -> tuple[Derivation, Any]:
    """The spin along OK."""
    of = on_supports("OK")
    names = of.problem.names
    s, c = names.read("sin(pi/n)"), names.read("cos(pi/n)")
    return of, -c * of.bodies[0].spin[0] + s * of.bodies[0].spin[1]


def printed_omega(xi: str, eta: str, eta_zeta: str) -> str:
    """The printed formula with these moments."""
    s, c = "sin(pi/n)", "cos(pi/n)"
    return f"(-({xi})*{c}*omega_xi + ({eta})*{s}*omega_eta - ({eta_zeta})*{s}*omega_zeta)/(({eta})*{s}**2 + ({xi})*{c}**2)"


def _is_along_ok() -> Outcome:
    of = on_supports("OK")
    spin, names = of.bodies[0].spin, of.problem.names
    across = of.simplify(spin[0] * names.read("sin(pi/n)") + spin[1] * names.read("cos(pi/n)"))
    return Outcome(across == 0 and spin[2] == 0, f"{across} across it")


def _possible(names: str) -> Outcome:
    return occurs(on_supports(names, 3).existence, f"that {' and '.join(names)} keep{'s' if len(names) == 1 else ''} never holds")


def claims() -> list[Claim]:
    """Everything that section 5 prints."""
    about_o = printed_omega("Jt + m*(a**2 + c**2)", "Jt + m*c**2", "m*a*c")
    out = [statement("border", SECTION, "from four sides on: O keeps where", f"h > {BORDER}", _border)]
    for sides in ("n", 3):
        of = "from four sides on" if sides == "n" else "three sides"
        key = "" if sides == "n" else ".3"
        out += [
            statement(f"two{key}", SECTION, f"{of}: possible of the eight states", "K keeps, or K and O; no others", partial(_only_two, sides)),
            statement(f"kept{key}.long", SECTION, f"{of}, a long pyramid", "O and K keep, A separates", partial(_always, "OK", sides, True)),
            statement(f"kept{key}.short", SECTION, f"{of}, a short pyramid", "K keeps, spherical motion about it", partial(_always, "K", sides, False)),
        ]
    out += [
        statement("also", SECTION, "from four sides on, a short pyramid: what separates", "the vertex A (\"is also separated\")", lambda: _also("A"), meant="the apex O beside A", judged_as_meant=lambda: _also("OA")),
        formula("spin", SUPPORTS, "both supports stay: spin after, moments about the support O", about_o, _omega),
        statement("spin.axis", SUPPORTS, "both supports stay: spin after", "is directed along OK", _is_along_ok),
        statement("stays", SUPPORTS, "three supports: non-separation of both", "possible", lambda: _possible("OK")),
        statement("separates.O", SUPPORTS, "separation of O only", "possible", lambda: _possible("K")),
        statement("separates.K", SUPPORTS, "separation of K only", "possible", lambda: _possible("O")),
    ]
    return out


def read_as(xi: str, eta: str, eta_zeta: str) -> Outcome:
    """Whether the printed spin is right with these moments and this product of inertia."""
    of, right = _omega()
    return Outcome(equal(of, printed_omega(xi, eta, eta_zeta), right), sp.sstr(right))


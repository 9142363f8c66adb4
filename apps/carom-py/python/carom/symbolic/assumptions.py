"""What is assumed of the symbols: relations of the caller, what the problem itself says, and the ranges of angles that follow."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import sympy as sp
from sympy.core.relational import Relational

from carom.errors import CaromError, Problem
from carom.symbolic.expressions import Names
from carom.symbolic.problem import SymbolicProblem

#: A relation of SymPy, or a text such as ``"0 < gamma < pi/2"``.
Assumed = str | Any


def _problem(text: str, why: str) -> CaromError:
    return CaromError(f"assume: {why}", [Problem(why, kind="wrong_value", path="assume", key="assume", value=text)])


def relations(assume: Iterable[Assumed], names: Names) -> list[Any]:
    """All relations, one by one.

    Raises :class:`carom.CaromError` for what is no relation.
    """
    out: list[Any] = []
    for one in assume:
        found = one
        if isinstance(one, str):
            try:
                found = names.read(one)
            except ValueError as why:
                raise _problem(one, str(why)) from None
        for relation in found if isinstance(found, list) else found.args if isinstance(found, sp.And) else [found]:
            if relation is sp.true or relation is True:
                continue
            if not isinstance(relation, Relational):
                raise _problem(str(one), f"{one} is no relation that can hold")
            out.append(relation)
    return out


def properties_of(assume: Sequence[Assumed]) -> dict[str, dict[str, bool]]:
    """What texts say of single names: ``"a > 0"`` makes a positive wherever it stands."""
    out: dict[str, dict[str, bool]] = {}
    for relation in relations([one for one in assume if isinstance(one, str)], Names()):
        for low, high in ((relation.lts, relation.gts),) if isinstance(relation, sp.Lt | sp.Le | sp.Gt | sp.Ge) else ():
            strict = isinstance(relation, sp.Lt | sp.Gt)
            if isinstance(high, sp.Symbol) and low.is_number and low.is_nonnegative:
                out.setdefault(high.name, {})["positive" if strict or low.is_positive else "nonnegative"] = True
            if isinstance(low, sp.Symbol) and high.is_number and high.is_nonpositive and strict:
                out.setdefault(low.name, {})["negative"] = True
    # Positive says not negative too.
    return {name: {"positive": True} if "positive" in what else what for name, what in out.items()}


class Assumptions:
    """All that is assumed of the symbols of a problem."""

    def __init__(self, problem: SymbolicProblem, assume: Sequence[Assumed] = ()) -> None:
        #: As the caller says it.
        self.said = [str(one) for one in assume]
        own = relations(assume, problem.names)
        known = {symbol.name for symbol in problem.symbols}
        for one in own:
            strange = sorted(symbol.name for symbol in one.free_symbols if symbol.name not in known)
            if strange:
                raise _problem(str(one), f"{one}: the problem has no {', '.join(strange)}; it has {', '.join(sorted(known))}")
        self.relations = [*own, *_of_problem(problem)]
        self._ranges: dict[Any, Any] = {}

    def range_of(self, angle: Any) -> Any:
        """The interval in which an angle of one symbol lies."""
        if angle not in self._ranges:
            self._ranges[angle] = self._range(angle)
        return self._ranges[angle]

    def _range(self, angle: Any) -> Any:
        symbols = list(angle.free_symbols)
        if len(symbols) != 1:
            return sp.S.Reals
        (symbol,) = symbols
        plain = sp.Dummy("x", real=True)
        domain: Any = sp.Interval.open(0, sp.oo) if symbol.is_positive else sp.Interval(0, sp.oo) if symbol.is_nonnegative else sp.S.Reals
        for relation in self.relations:
            if relation.free_symbols == {symbol} and not isinstance(relation, sp.Ne):
                try:
                    domain = domain.intersect(sp.solve_univariate_inequality(relation.xreplace({symbol: plain}), plain, relational=False, domain=domain))
                except (NotImplementedError, ValueError, TypeError):
                    continue
        if isinstance(domain, sp.FiniteSet):
            return sp.FiniteSet(*[angle.subs(symbol, one) for one in domain])
        if not isinstance(domain, sp.Interval):
            return sp.S.Reals
        return _image(angle, symbol, domain)


def _image(angle: Any, symbol: Any, domain: Any) -> Any:
    """The range of an angle that rises or falls with its symbol all the way."""
    # A plain positive symbol lets SymPy see the sign of the slope.
    stand_in = sp.Dummy("x", positive=True) if domain.inf.is_nonnegative else sp.Dummy("x", real=True)
    slope = sp.diff(angle.xreplace({symbol: stand_in}), stand_in)
    if not (slope.is_positive or slope.is_negative):
        return sp.S.Reals
    try:
        ends = [sp.limit(angle, symbol, end, "-" if end == domain.sup else "+") for end in (domain.inf, domain.sup)]
    except (NotImplementedError, ValueError):
        return sp.S.Reals
    opened = [domain.left_open or domain.inf.is_infinite, domain.right_open or domain.sup.is_infinite]
    if slope.is_negative:
        ends, opened = ends[::-1], opened[::-1]
    return sp.Interval(ends[0], ends[1], bool(opened[0]), bool(opened[1]))


def _of_problem(problem: SymbolicProblem) -> list[Any]:
    """Masses are positive, of three moments of inertia none is larger than the two others together, frictions are not negative, restitutions from 0 to 1."""
    moving = [body for body in problem.bodies if not body.fixed]
    out = [value > 0 for body in moving for value in (body.mass, *body.inertia)]
    if problem.space:
        out += [sp.Ge(sum(body.inertia), 2 * one) for body in moving for one in body.inertia]
    for contact in problem.contacts:
        out += [contact.friction >= 0, contact.restitution >= 0, contact.restitution <= 1]
    return [one for one in out if isinstance(one, Relational)]

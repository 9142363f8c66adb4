"""Whether a hypothesis can hold at all: its inequalities as polynomials, asked of Z3."""

from __future__ import annotations

import importlib
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import sympy as sp

from carom.symbolic.algebra import Algebra
from carom.symbolic.tidy import reduced

#: How far off, as a share of its terms, a condition may be at an example that Z3 gives and that is rounded to doubles.
_ROUNDING = 1e-9

Verdict = Literal["holds", "border", "empty", "unknown"]


@dataclass(frozen=True)
class Existence:
    """Whether conditions can hold together."""

    verdict: Verdict
    """``holds`` somewhere; only on a ``border``, where an inequality is an equality; ``empty``; ``unknown`` where Z3 did not answer in time."""
    why: str = ""
    """In a sentence."""
    example: dict[Any, float] | None = None
    """Values at which all of them hold, where some were found."""


@dataclass(frozen=True)
class Asked:
    """A number that must be positive (or zero, where :attr:`zero`; not negative, where :attr:`weak`)."""

    number: Any
    what: str
    zero: bool = False
    weak: bool = False


def exists(algebra: Algebra, asked: Sequence[Asked], relations: Sequence[Any] = (), *, seconds: float = 2.0) -> Existence:
    """Asks whether all of this can hold at once, within what is assumed; every ``relations`` beside it too."""
    signs = [(one, *reduced(algebra, one.number)) for one in asked]
    for one, sign, factors in signs:
        if one.zero and sign != 0 and not factors:
            return Existence("empty", f"{one.what}: it would have to be zero, and never is")
        if not one.zero and sign < 0 and not factors:
            return Existence("empty", f"{one.what}: it never holds")
    # A slack that vanishes everywhere is met as an equality.
    open_ones = [(one, sign, factors) for one, sign, factors in signs if factors]
    found = _ask(algebra, open_ones, relations, strict=True, seconds=seconds)
    if found.verdict != "empty":
        return found
    if all(one.zero or one.weak for one, _, _ in open_ones):
        return Existence("empty", _together(open_ones))
    weak = _ask(algebra, open_ones, relations, strict=False, seconds=seconds)
    if weak.verdict == "holds":
        return Existence("border", "it holds only where an inequality is an equality, on the border of another hypothesis")
    if weak.verdict == "unknown":
        return Existence("border", "it holds at most where an inequality is an equality")
    return Existence("empty", _together(open_ones))


def _together(asked: Sequence[tuple[Asked, int, list[Any]]]) -> str:
    names = list(dict.fromkeys(one.what for one, _, _ in asked))
    return "these do not go together: " + "; ".join(names) if names else "what is assumed contradicts itself"


class _Translator:
    """Polynomials in tangents of half angles as terms of Z3."""

    def __init__(self, algebra: Algebra) -> None:
        self.z3: Any = importlib.import_module("z3")
        self.algebra, self.halves = algebra, algebra.halves
        self.variables = [self.z3.Real(f"x{k}") for k in range(len(self.halves.ring.gens))]
        self.place = {symbol: k for k, symbol in enumerate(self.halves.ring.symbols)}
        self.constants: list[Any] = []

    def term(self, polynomial: Any) -> Any:
        total: Any = self.z3.RealVal(0)
        for monomial, coefficient in polynomial.terms():
            product: Any = self.z3.RealVal(str(coefficient))
            for variable, power in zip(self.variables, monomial):
                for _ in range(power):
                    product = product * variable
            total = total + product
        return total

    def product(self, sign: int, factors: list[Any]) -> Any:
        out: Any = self.z3.RealVal(sign)
        for factor in factors:
            out = out * self.term(factor)
        return out

    def relation(self, relation: Any) -> Any | None:
        """A relation as Z3 has it; None where it is about angles themselves, which their ranges tell."""
        inside = {symbol for angle in self.algebra.angles.values() for symbol in angle.angle.free_symbols}
        difference = relation.lhs - relation.rhs
        plain = difference.free_symbols and not difference.has(sp.sin, sp.cos, sp.tan, sp.cot)
        if plain and difference.free_symbols <= inside and not difference.free_symbols <= set(self.place):
            return None
        try:
            number = self.halves.number(self.algebra.element(difference))
        except ValueError:
            return None
        # The sign of a quotient is that of the product.
        value, zero = self.term(number.numer) * self.term(number.denom), self.z3.RealVal(0)
        kinds = {sp.Gt: value > zero, sp.Ge: value >= zero, sp.Lt: value < zero, sp.Le: value <= zero, sp.Eq: value == zero, sp.Ne: value != zero}
        return next((made for kind, made in kinds.items() if isinstance(relation, kind)), None)

    def field(self) -> list[Any]:
        """What roots are, the ranges of angles, and what symbols assume."""
        out = [self.term(self.halves.polynomial(one)) == 0 for one in self.algebra.root_relations]
        for symbol, place in self.place.items():
            x = self.variables[place]
            if symbol.is_positive:
                out.append(x > 0)
            elif symbol.is_negative:
                out.append(x < 0)
            elif symbol.is_nonnegative:
                out.append(x >= 0)
        for angle in self.algebra.angles.values():
            out += self._range(angle)
        out += [self.variables[self.place[symbol]] == self._constant(value) for symbol, value in self.algebra.constants.items()]
        return out

    def _range(self, angle: Any) -> list[Any]:
        bounds = self.halves.bounds(angle)
        if bounds is None:
            return []
        low, high, left_open, right_open = bounds
        t, out = self.variables[self.place[angle.half]], []
        if not low.is_infinite:
            out.append(t > self._constant(low) if left_open else t >= self._constant(low))
        if not high.is_infinite:
            out.append(t < self._constant(high) if right_open else t <= self._constant(high))
        return out

    def _constant(self, value: Any) -> Any:
        """A number: an algebraic one is the root of its polynomial that lies near it, of others only this is said."""
        if value.is_Rational:
            return self.z3.RealVal(str(value))
        unknown = sp.Symbol("x")
        variable = self.z3.FreshReal("k")
        near, step = sp.Rational(str(sp.N(value, 30))), sp.Rational(1, 10**20)
        if value.is_algebraic:
            total: Any = self.z3.RealVal(0)
            for coefficient in sp.Poly(sp.minimal_polynomial(value, unknown), unknown).all_coeffs():
                total = total * variable + self.z3.RealVal(str(coefficient))
            self.constants.append(total == 0)
        self.constants += [variable > self.z3.RealVal(str(near - step)), variable < self.z3.RealVal(str(near + step))]
        return variable


def _ask(algebra: Algebra, asked: Sequence[tuple[Asked, int, list[Any]]], relations: Sequence[Any], *, strict: bool, seconds: float) -> Existence:
    translator = _Translator(algebra)
    z3 = translator.z3
    solver = z3.SolverFor("QF_NRA")
    solver.set("timeout", max(1, int(1000 * seconds)))
    for one, sign, factors in asked:
        value = translator.product(sign, factors)
        solver.add(value == 0 if one.zero else value > 0 if strict and not one.weak else value >= 0)
    given = [*algebra.assumptions.relations, *relations]
    for term in [*translator.field(), *[translator.relation(one) for one in given]]:
        if term is not None:
            solver.add(term)
    solver.add(*translator.constants)
    answer = solver.check()
    if answer == z3.unsat:
        return Existence("empty")
    if answer != z3.sat:
        return Existence("unknown", f"Z3 did not decide within {seconds:g} s")
    example = _example(algebra, translator, solver.model())
    if example is None or not _holds(algebra, example, [*given, *_told(algebra, asked)]):
        # Where an angle stands in sines and beside them, Z3 knows only that both are numbers.
        return Existence("unknown", "Z3 found an example in which an angle and its sine do not fit")
    unused = set(algebra.unknowns) - {symbol for one, _, _ in asked for symbol in algebra.plain(one.number.numer).free_symbols}
    return Existence("holds", "", {symbol: value for symbol, value in example.items() if symbol not in unused})


def _example(algebra: Algebra, translator: _Translator, model: Any) -> dict[Any, float] | None:
    """Values of the problem's own symbols."""
    own: dict[Any, float] = {}
    for symbol, place in translator.place.items():
        value = model.eval(translator.variables[place], model_completion=True)
        if translator.z3.is_algebraic_value(value):
            value = value.approx(20)
        own[symbol] = float(value.as_fraction())
    out = {symbol: own[symbol] for symbol in [*algebra.symbols, *algebra.unknowns] if symbol in own}
    for angle in algebra.angles.values():
        symbols = list(angle.angle.free_symbols)
        if len(symbols) != 1:
            return None
        turned = 2 * math.atan(own[angle.half])
        found = [sp.solve(angle.angle - (turned + 2 * math.pi * k), symbols[0]) for k in (0, 1, -1)]
        inside = [one[0] for k, one in zip((0, 1, -1), found) if one and angle.bounds.contains(turned + 2 * math.pi * k) == sp.true]
        if not inside:
            return None
        out[symbols[0]] = float(inside[0])
    return out


def _told(algebra: Algebra, asked: Sequence[tuple[Asked, int, list[Any]]]) -> list[Any]:
    return [(one, algebra.plain(one.number.numer) / algebra.plain(one.number.denom)) for one, _, _ in asked]


def _holds(algebra: Algebra, example: dict[Any, float], conditions: Sequence[Any]) -> bool:
    """True where an example meets conditions to rounding: relations, and numbers that were asked."""
    for one in conditions:
        asked, difference = one if isinstance(one, tuple) else (None, one.lhs - one.rhs)
        value = sp.sympify(difference).subs(example)
        if not value.is_number:
            return False
        try:
            number = float(value)
            size = float(sum(abs(term.subs(example)) for term in sp.Add.make_args(sp.sympify(difference)))) or 1.0
        except (TypeError, ValueError):
            return False
        slack = _ROUNDING * size
        if asked is not None:
            good = abs(number) <= slack if asked.zero else number >= -slack
        elif isinstance(one, sp.Eq | sp.Ne):
            good = (abs(number) <= slack) == isinstance(one, sp.Eq)
        else:
            good = number >= -slack if isinstance(one, sp.Gt | sp.Ge) else number <= slack
        if not good:
            return False
    return True

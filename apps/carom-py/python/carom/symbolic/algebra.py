"""Exact arithmetic with rational functions of symbols, of sines and cosines, and of square roots.

Sines and cosines of an angle are two unknowns c and s with c² + s² = 1, a root is one with r² = its radicand. Every number has one normal form
(no s and no r below the line), so that zero is told from what is not zero, and systems of equations have their true rank.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property, reduce
from typing import TYPE_CHECKING, Any

import sympy as sp
from sympy.polys.orderings import lex
from sympy.polys.rings import ring

from carom.symbolic.assumptions import Assumptions

if TYPE_CHECKING:
    from carom.symbolic.tidy import Halves

_TRIGONOMETRIC = (sp.sin, sp.cos, sp.tan, sp.cot)


class Angle:
    """An angle, its cosine and its sine as unknowns."""

    def __init__(self, angle: Any, bounds: Any) -> None:
        self.angle, self.bounds = angle, bounds
        cosine = {"positive": True} if bounds.is_subset(sp.Interval.open(-sp.pi / 2, sp.pi / 2)) else {}
        sine = {"positive": True} if bounds.is_subset(sp.Interval.open(0, sp.pi)) else {}
        self.half = sp.Dummy("t", **{"real": True, **sine})
        #: The cosine of the half angle, which only results have: its square is (1 + c)/2.
        self.half_cosine = sp.Dummy("h", real=True)
        self.cosine, self.sine = sp.Dummy("c", **{"real": True, **cosine}), sp.Dummy("s", **{"real": True, **sine})

    def multiple(self, times: Any) -> tuple[Any, Any]:
        """Cosine and sine of a multiple of the angle, or of an odd multiple of its half.

        Raises ValueError for other parts of it.
        """
        if times.is_Integer:
            n, cosine, sine = abs(int(times)), self.cosine, self.sine
        elif (2 * times).is_Integer:
            n, cosine, sine = abs(int(2 * times)), self.half_cosine, self.half_cosine * self.sine / (1 + self.cosine)
        else:
            raise ValueError(f"{times * self.angle} is no multiple of half of {self.angle}")
        if n == 0:
            return sp.Integer(1), sp.Integer(0)
        turned = sine * sp.chebyshevu_poly(n - 1, cosine)
        return sp.chebyshevt_poly(n, cosine), turned if times > 0 else -turned

    def without_halves(self, above: Any, below: Any) -> tuple[Any, Any]:
        """A quotient in which the cosine of the half angle stands only in even powers, or cancels, without it.

        Raises ValueError where it stays.
        """
        h, square, out = self.half_cosine, (1 + self.cosine) / 2, []
        if not (above.has(h) or below.has(h)):
            return above, below
        for one in (above, below):
            parts = sp.Poly(sp.expand(one), h).all_coeffs()[::-1]
            out.append([sum(part * square ** (k // 2) for k, part in enumerate(parts) if k % 2 == odd) for odd in (0, 1)])
        parity = [[sp.expand(part) != 0 for part in one] for one in out]
        if all(one[0] and not one[1] for one in parity) or parity[0] == [False, False]:
            return sp.sympify(out[0][0]), sp.sympify(out[1][0])
        if all(one[1] and not one[0] for one in parity):
            return sp.sympify(out[0][1]), sp.sympify(out[1][1])
        raise ValueError(f"the half of {self.angle} stays")


class Algebra:
    """The field that a problem's numbers live in.

    ``unknowns`` are further symbols that may stand in expressions: impulses that stay free.
    """

    def __init__(self, expressions: Iterable[Any], assumptions: Assumptions, unknowns: Iterable[Any] = ()) -> None:
        self.assumptions = assumptions
        given = [sp.sympify(one) for one in expressions]
        self.angles = _angles(given, assumptions)
        #: Angles as they stand in what was given.
        self.written = {function.args[0] for one in given for function in one.atoms(*_TRIGONOMETRIC)}
        self._roots: dict[Any, Any] = {}
        self._opaque: dict[Any, Any] = {}
        walked = [self._walk(one) for one in given]
        self.symbols = sorted({symbol for one in [*walked, *self._roots] for symbol in one.free_symbols} - self._own(), key=lambda symbol: str(symbol.name))
        self.unknowns = list(unknowns)
        generators = [*reversed(self._roots.values()), *[one.sine for one in self.angles.values()], *[one.cosine for one in self.angles.values()], *self._opaque.values(), *self.unknowns]
        generators += [symbol for symbol in self.symbols if symbol not in self.unknowns]
        self.ring: Any = ring(generators or [sp.Dummy()], sp.QQ, lex)[0]
        self.field: Any = self.ring.to_field()
        #: What each root is.
        self.root_relations = [self.ring.from_expr(sp.expand(r**2 - square)) for square, r in reversed(self._roots.items())]
        self._relations = [*self.root_relations]
        self._relations += [self.ring.from_expr(one.sine**2 + one.cosine**2 - 1) for one in self.angles.values()]
        quadratic = [*reversed(self._roots.values()), *[one.sine for one in self.angles.values()]]
        self._quadratic = [self.ring.gens[generators.index(one)] for one in quadratic]
        self._back = {one.cosine: sp.cos(one.angle) for one in self.angles.values()} | {one.sine: sp.sin(one.angle) for one in self.angles.values()}
        self._back_roots = {r: sp.sqrt(square) for square, r in self._roots.items()} | {r: what for what, r in self._opaque.items()}

    @property
    def constants(self) -> dict[Any, Any]:
        """Unknowns that stand for numbers such as pi, and these numbers."""
        return {r: what for what, r in self._opaque.items() if what.is_number}

    def _own(self) -> set[Any]:
        return {one for angle in self.angles.values() for one in (angle.cosine, angle.sine)} | set(self._roots.values()) | set(self._opaque.values())

    def element(self, expression: Any) -> Any:
        """An expression as a number of the field, in its normal form.

        Raises ValueError where it has an angle or a root that the algebra was not made for.
        """
        known = len(self._roots), len(self._opaque)
        walked = self._walk(sp.sympify(expression))
        if (len(self._roots), len(self._opaque)) != known:
            raise ValueError(f"{expression} has roots or functions that the problem has not")
        numerator, denominator = sp.fraction(sp.together(walked))
        for angle in self.angles.values():
            numerator, denominator = angle.without_halves(numerator, denominator)
        numerator, denominator = sp.fraction(sp.together(numerator / denominator))
        try:
            above, below = self.ring.from_expr(sp.expand(numerator)), self.ring.from_expr(sp.expand(denominator))
        except (ValueError, sp.GeneratorsError, sp.CoercionFailed):
            raise ValueError(f"{expression} has symbols that the problem has not") from None
        return self.normal(above, below)

    def normal(self, above: Any, below: Any) -> Any:
        """The quotient of two polynomials in its normal form."""
        above, below = above.rem(self._relations) if self._relations else above, below.rem(self._relations) if self._relations else below
        for generator in self._quadratic:
            other = _conjugate(below, generator)
            if other is not None:
                above, below = (above * other).rem(self._relations), (below * other).rem(self._relations)
        if not below:
            raise ZeroDivisionError
        above, below = above.cancel(below)
        return self.field.new(above, below)

    def tidy(self, number: Any) -> Any:
        """A number of the field in its normal form, after arithmetic."""
        return self.normal(number.numer, number.denom)

    def sum(self, numbers: Iterable[Any]) -> Any:
        """The sum in normal form."""
        return self.tidy(reduce(lambda a, b: a + b, numbers, self.field.zero))

    def plain(self, polynomial: Any) -> Any:
        """A polynomial as an expression of the problem's own symbols."""
        return self.own(polynomial.as_expr())

    def own(self, expression: Any) -> Any:
        """The problem's own sines, cosines, roots and functions in place of unknowns."""
        for _ in range(len(self._roots) + 1):
            expression = expression.xreplace(self._back_roots)
        return expression.xreplace(self._back)

    @cached_property
    def halves(self) -> Halves:
        """The same field in tangents of half angles."""
        from carom.symbolic.tidy import Halves

        return Halves(self)

    def _walk(self, e: Any) -> Any:
        """The same with unknowns in place of sines, cosines and roots."""
        if e.is_Symbol or e.is_Rational:
            return e
        if isinstance(e, sp.tan | sp.cot):
            cosine, sine = self._cosine_and_sine(e.args[0])
            return sine / cosine if isinstance(e, sp.tan) else cosine / sine
        if isinstance(e, sp.sin | sp.cos):
            cosine, sine = self._cosine_and_sine(e.args[0])
            return sine if isinstance(e, sp.sin) else cosine
        if isinstance(e, sp.Add | sp.Mul):
            return e.func(*[self._walk(one) for one in e.args])
        if isinstance(e, sp.Pow) and e.exp.is_Integer:
            return self._walk(e.base) ** e.exp
        if isinstance(e, sp.Pow) and (2 * e.exp).is_Integer:
            return self._root(self._walk(e.base)) ** int(2 * e.exp)
        known = {"positive": True} if e.is_positive else {"negative": True} if e.is_negative else {"real": True}
        return self._opaque.setdefault(e, sp.Dummy("f", **known))

    def _root(self, square: Any) -> Any:
        numerator, denominator = sp.fraction(sp.together(square))
        radicand = sp.expand(numerator * denominator)
        for angle in self.angles.values():
            radicand = sp.rem(radicand, angle.sine**2 + angle.cosine**2 - 1, angle.sine) if radicand.has(angle.sine) else radicand
        outside = sp.Integer(1)
        for factor, power in sp.factor_list(radicand)[1] if radicand.free_symbols else []:
            if factor.is_positive and power >= 2:
                outside *= factor ** (power // 2)
        radicand = sp.cancel(radicand / outside**2)
        if radicand.is_Rational and sp.sqrt(radicand).is_Rational:
            return outside * sp.sqrt(radicand) / denominator
        radicand = sp.expand(radicand)
        return outside * self._roots.setdefault(radicand, sp.Dummy("r", positive=True)) / denominator

    def _cosine_and_sine(self, argument: Any) -> tuple[Any, Any]:
        cosine, sine = sp.Integer(1), sp.Integer(0)
        for count, rest in _terms(argument):
            if rest == sp.pi or rest == 1:
                c, s = self._walk(sp.cos(count * rest)), self._walk(sp.sin(count * rest))
            else:
                if rest not in self.angles:
                    raise ValueError(f"the problem has no angle {rest}")
                angle = self.angles[rest]
                c, s = angle.multiple(count / angle.angle.as_coeff_Mul(rational=True)[0])
            cosine, sine = cosine * c - sine * s, sine * c + cosine * s
        return sp.expand(cosine), sp.expand(sine)


def _terms(argument: Any) -> list[tuple[Any, Any]]:
    """An angle as multiples of others."""
    return [one.as_coeff_Mul(rational=True) for one in sp.Add.make_args(sp.expand(argument))]


def _angles(expressions: list[Any], assumptions: Assumptions) -> dict[Any, Angle]:
    """The angles of which all that stand in sines and cosines are whole multiples."""
    counts: dict[Any, list[Any]] = {}
    for one in expressions:
        for function in one.atoms(*_TRIGONOMETRIC):
            for count, rest in _terms(function.args[0]):
                if rest != sp.pi and rest != 1:
                    counts.setdefault(rest, []).append(abs(count))
    ordered = sorted(counts.items(), key=lambda item: str(item[0]))
    bases = {rest: reduce(sp.gcd, many) * rest for rest, many in ordered}
    return {rest: Angle(angle, assumptions.range_of(angle)) for rest, angle in bases.items()}


def _conjugate(below: Any, generator: Any) -> Any:
    """What takes a root out of a polynomial that is linear in it; None where it has none."""
    index = below.ring.gens.index(generator)
    without, beside = below.ring.zero, below.ring.zero
    for monomial, coefficient in below.terms():
        if monomial[index] == 0:
            without += below.ring.term_new(monomial, coefficient)
        else:
            lower = tuple(power - (k == index) for k, power in enumerate(monomial))
            beside += below.ring.term_new(lower, coefficient)
    return None if not beside else without - beside * generator


class Family:
    """What solves linear equations: a point, and directions with the columns that are free along them."""

    def __init__(self, point: list[Any], free: list[int], directions: list[list[Any]]) -> None:
        self.point, self.free, self.directions = point, free, directions


def solve(algebra: Algebra, rows: list[list[Any]], right: list[Any]) -> Family | Any:
    """Solves linear equations; columns to the left are solved for first.

    Where the equations contradict each other, what is left over in place of 0.
    """
    width = len(rows[0]) if rows else 0
    table = [[*row, b] for row, b in zip(rows, right)]
    pivots: list[int] = []
    for column in range(width):
        place = len(pivots)
        candidates = [k for k in range(place, len(table)) if table[k][column]]
        if not candidates:
            continue
        best = min(candidates, key=lambda k: len(table[k][column].numer) + len(table[k][column].denom))
        table[place], table[best] = table[best], table[place]
        pivot = table[place][column]
        table[place] = [algebra.tidy(one / pivot) if one else one for one in table[place]]
        for k, row in enumerate(table):
            if k != place and row[column]:
                factor = row[column]
                table[k] = [algebra.tidy(one - factor * two) if two else one for one, two in zip(row, table[place])]
        pivots.append(column)
    for row in table[len(pivots) :]:
        if row[-1]:
            return row[-1]
    free = [column for column in range(width) if column not in pivots]
    zero, one = algebra.field.zero, algebra.field.one
    point = [zero] * width
    directions = [[one if column == along else zero for column in range(width)] for along in free]
    for place, column in enumerate(pivots):
        point[column] = table[place][-1]
        for direction, along in zip(directions, free):
            direction[column] = -table[place][along]
    return Family(point, free, directions)

"""Short forms of exact numbers, and what is known of their signs.

With t = tan(θ/2) the sine and the cosine of θ are rational, so that factors which only look different cancel: signs are told in this form, and
of both forms the shorter is shown.
"""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy.polys.orderings import lex
from sympy.polys.rings import ring

from carom.symbolic.algebra import Algebra, Angle

#: Expressions of more operations than this are left as their factors are: simplification would take long and help little.
_SMALL = 60
#: Numbers of more terms than this are not tried in many ways.
_FEW = 60
#: What a function of an angle that the caller has not written costs beside a plain operation.
_STRANGE = 4


class Halves:
    """The field of an algebra with t = tan(θ/2) in place of c and s."""

    def __init__(self, algebra: Algebra) -> None:
        self.algebra = algebra
        self.angles = list(algebra.angles.values())
        own = {one for angle in self.angles for one in (angle.cosine, angle.sine)}
        self.symbols = [*[angle.half for angle in self.angles], *[one for one in algebra.ring.symbols if one not in own]]
        self.ring: Any = ring(self.symbols or [sp.Dummy()], sp.QQ, lex)[0]
        self.field: Any = self.ring.to_field()
        places = {symbol: k for k, symbol in enumerate(algebra.ring.symbols)}
        self._trigonometric = [(places[angle.cosine], places[angle.sine]) for angle in self.angles]
        self._plain = [places[symbol] for symbol in self.symbols[len(self.angles) :]]
        self.names: dict[Any, Any] = {angle.half: sp.tan(sp.expand(angle.angle / 2)) for angle in self.angles}

    def number(self, number: Any) -> Any:
        """A number of the algebra in this field, cancelled."""
        above, degrees_above = self._polynomial(number.numer)
        below, degrees_below = self._polynomial(number.denom)
        for angle, up, down in zip(self.angles, degrees_above, degrees_below):
            one = self.ring.from_expr(1 + angle.half**2)
            above, below = above * one**down, below * one**up
        above, below = above.cancel(below)
        return self.field.new(above, below)

    def polynomial(self, polynomial: Any) -> Any:
        """What has the sign of a polynomial of the algebra, without denominator."""
        return self._polynomial(polynomial)[0]

    def _polynomial(self, polynomial: Any) -> tuple[Any, list[int]]:
        """A polynomial times (1 + t²) to the powers that are told."""
        degrees = [max((m[c] + m[s] for m in polynomial.monoms()), default=0) for c, s in self._trigonometric]
        parts = [self.ring.from_expr(angle.half) for angle in self.angles]
        total = self.ring.zero
        for monomial, coefficient in polynomial.terms():
            term = self.ring.term_new((0,) * len(self.angles) + tuple(monomial[k] for k in self._plain), coefficient) if self.symbols else self.ring.one * coefficient
            for (c, s), t, degree in zip(self._trigonometric, parts, degrees):
                term = term * (1 - t**2) ** monomial[c] * (2 * t) ** monomial[s] * (1 + t**2) ** (degree - monomial[c] - monomial[s])
            total = total + term
        return total, degrees

    def plain(self, polynomial: Any) -> Any:
        """A polynomial as an expression of the problem's own symbols."""
        return self.algebra.own(polynomial.as_expr().xreplace(self.names))

    def bounds(self, angle: Angle) -> tuple[Any, Any, bool, bool] | None:
        """Between what t lies, and whether the ends are left out; None where all numbers are possible."""
        inside: Any = angle.bounds
        if isinstance(inside, sp.FiniteSet) and len(inside) == 1:
            only: Any = list(inside)[0]
            return sp.tan(only / 2), sp.tan(only / 2), False, False
        if not isinstance(inside, sp.Interval) or not inside.is_subset(sp.Interval(-sp.pi, sp.pi)):
            return None
        low = -sp.oo if inside.inf == -sp.pi else sp.tan(inside.inf / 2)
        high = sp.oo if inside.sup == sp.pi else sp.tan(inside.sup / 2)
        return low, high, bool(inside.left_open), bool(inside.right_open)

    def sign(self, polynomial: Any) -> int | None:
        """1 or −1 where a polynomial is positive or negative for all that is assumed; None where that is not seen."""
        plain = _plain_sign(polynomial)
        if plain is not None:
            return plain
        expression = polynomial.as_expr()
        value = self.algebra.own(expression)
        if expression.free_symbols and value.is_number:
            # Nothing but roots of numbers: their sign is told from thirty digits.
            return 1 if sp.N(value, 30) > 0 else -1
        for angle in self.angles:
            if expression.free_symbols == {angle.half} and (bounds := self.bounds(angle)) is not None:
                return _sign_between(sp.Poly(expression, angle.half), bounds)
        return None


def _sign_between(polynomial: Any, bounds: tuple[Any, Any, bool, bool]) -> int | None:
    low, high, left_open, right_open = bounds
    if low == high:
        value = polynomial.eval(low)
        return 1 if value.is_positive else -1 if value.is_negative else None
    roots = [one for one in polynomial.real_roots(multiple=False)]
    if any((low < root or (low == root and not left_open)) and (root < high or (root == high and not right_open)) for root, _ in roots):
        return None
    inner = (low + high) / 2 if not (low.is_infinite or high.is_infinite) else high - 1 if not high.is_infinite else low + 1 if not low.is_infinite else sp.Integer(0)
    return 1 if polynomial.eval(inner) > 0 else -1


def short(algebra: Algebra, number: Any) -> Any:
    """A number of the field as a short expression: factors, half angles where they are shorter."""
    if not number:
        return sp.Integer(0)
    candidates = [_of_sines(algebra, *factored(number))]
    if len(number.numer) + len(number.denom) <= _FEW:
        candidates += [_over_sine(algebra, number, angle, power) for angle in algebra.angles.values() for power in (-1, 1)]
    if algebra.angles:
        halves = algebra.halves
        candidates.append(_of_halves(halves, *factored(halves.number(number))))
    return min(candidates, key=lambda one: _cost(algebra, one))


def _over_sine(algebra: Algebra, number: Any, angle: Angle, power: int) -> Any:
    """The same number as one divided by a power of a sine: its normal form may hide a factor in s² = 1 − c²."""
    sine = algebra.field.from_expr(angle.sine)
    other = algebra.tidy(number * sine if power > 0 else number / sine)
    coefficient, factors = factored(other)
    return _of_sines(algebra, coefficient, [*factors, (sine.numer, -power)])


def _cost(algebra: Algebra, expression: Any) -> tuple[int, int]:
    """Operations, and what functions of other angles than the caller's cost."""
    functions = expression.atoms(sp.sin, sp.cos, sp.tan)
    strange = sum(_STRANGE for one in functions if one.args[0] not in algebra.written)
    return int(sp.count_ops(expression)) + len(functions) + strange, len(str(expression))


def factored(number: Any) -> tuple[Any, list[tuple[Any, int]]]:
    """A rational coefficient, and polynomials with their powers."""
    above, below = number.numer.factor_list(), number.denom.factor_list()
    coefficient = sp.Rational(above[0].numerator, above[0].denominator) / sp.Rational(below[0].numerator, below[0].denominator)
    return coefficient, [*above[1], *[(factor, -power) for factor, power in below[1]]]


_Powers = tuple[int, int, int]


def _of_sines(algebra: Algebra, coefficient: Any, factors: list[tuple[Any, int]]) -> Any:
    """Factors as an expression, with powers of s, 1 − c and 1 + c in their shortest form."""
    powers, rest = _taken_out(algebra, factors)
    plain = coefficient * sp.prod([_factor(algebra, algebra.plain(factor)) ** power for factor, power in rest])
    for angle, of in powers.items():
        plain = plain * min(_forms(angle, of), key=lambda one: _cost(algebra, one))
    return plain


def _of_halves(halves: Halves, coefficient: Any, factors: list[tuple[Any, int]]) -> Any:
    """The same in t: 1 + t² is one over the square of the cosine of the half angle."""
    plain = coefficient
    powers = {angle.half: [0, 0] for angle in halves.angles}
    for factor, power in factors:
        expression = factor.as_expr()
        for angle in halves.angles:
            if expression == angle.half:
                powers[angle.half][0] += power
                break
            if expression == angle.half**2 + 1:
                powers[angle.half][1] += power
                break
        else:
            plain = plain * _factor(halves.algebra, halves.plain(factor)) ** power
    for angle in halves.angles:
        p, q = powers[angle.half]
        half = sp.expand(angle.angle / 2)
        # t^p (1 + t²)^q = sin^p cos^(−p − 2q).
        k = 0 if p * (p + 2 * q) <= 0 else min(abs(p), abs(p + 2 * q)) * (1 if p > 0 else -1)
        plain = plain * sp.tan(half) ** k * sp.sin(half) ** (p - k) * sp.cos(half) ** (k - p - 2 * q)
    return plain


def _taken_out(algebra: Algebra, factors: list[tuple[Any, int]]) -> tuple[dict[Angle, _Powers], list[tuple[Any, int]]]:
    """Powers of s, 1 − c and 1 + c of each angle, and the other factors; signs go to the others."""
    powers: dict[Angle, list[int]] = {}
    rest: list[tuple[Any, int]] = []
    minus_one = algebra.ring.one * -1
    for factor, power in factors:
        for angle in algebra.angles.values():
            sine, cosine = (algebra.ring.from_expr(one) for one in (angle.sine, angle.cosine))
            kinds = [sine, 1 - cosine, 1 + cosine]
            found = [(k, sign) for k, kind in enumerate(kinds) for sign in (1, -1) if factor == kind * sign]
            if found:
                k, sign = found[0]
                powers.setdefault(angle, [0, 0, 0])[k] += power
                if sign < 0 and power % 2:
                    rest.append((minus_one, 1))
                break
        else:
            rest.append((factor, power))
    return {angle: (p[0], p[1], p[2]) for angle, p in powers.items()}, rest


def _forms(angle: Angle, powers: _Powers) -> list[Any]:
    """The same product in several ways: (1 − c)(1 + c) is s², and both are squares of the half angle."""
    p, q, r = powers
    theta = angle.angle
    out = [sp.sin(theta) ** (p + 2 * k) * (1 - sp.cos(theta)) ** (q - k) * (1 + sp.cos(theta)) ** (r - k) for k in {0, q, r, -(p // 2), (q + r) // 2}]
    sine, cosine, half = p + 2 * q, p + 2 * r, sp.expand(theta / 2)
    out.append(sp.Integer(2) ** (p + q + r) * sp.sin(half) ** sine * sp.cos(half) ** cosine)
    if sine * cosine < 0:
        k = min(abs(sine), abs(cosine)) * (1 if sine > 0 else -1)
        out.append(sp.Integer(2) ** (p + q + r) * sp.tan(half) ** k * sp.sin(half) ** (sine - k) * sp.cos(half) ** (cosine + k))
    return out


def _factor(algebra: Algebra, plain: Any) -> Any:
    candidates = [plain, sp.factor_terms(plain)]
    unknown = [symbol for symbol in algebra.unknowns if plain.has(symbol)]
    if unknown:
        return sp.collect(sp.expand(plain), unknown, lambda one: _factor(algebra, sp.factor(one)))
    if plain.has(sp.sin, sp.cos) and sp.count_ops(plain) < _SMALL:
        candidates.append(sp.trigsimp(plain))
    return min(candidates, key=lambda one: _cost(algebra, one))


def _plain_sign(polynomial: Any) -> int | None:
    """The sign of a polynomial that its symbols show."""
    expression = polynomial.as_expr()
    return 1 if expression.is_positive else -1 if expression.is_negative else None


def reduced(algebra: Algebra, number: Any) -> tuple[int, list[Any]]:
    """The sign of a number up to factors of which it is not known: 0, or ±1 and these factors, each once, in the field of half angles."""
    if not number:
        return 0, []
    halves = algebra.halves
    coefficient, factors = factored(number)
    sign, rest = (1 if coefficient > 0 else -1), algebra.field.one
    for factor, power in factors:
        plain = _plain_sign(factor)
        if plain is None:
            rest = rest * algebra.field.new(factor, algebra.ring.one) ** power
        elif power % 2:
            sign *= plain
    coefficient, factors = factored(halves.number(rest))
    unknown: list[Any] = []
    sign *= 1 if coefficient > 0 else -1
    for factor, power in factors:
        if power % 2 == 0:
            continue
        known = halves.sign(factor)
        if known is None:
            unknown.append(factor)
        else:
            sign *= known
    return sign, unknown


def shown(algebra: Algebra, number: Any) -> Any:
    """What is left of a number without factors that are positive for all that is assumed; only its sign counts."""
    sign, factors = reduced(algebra, number)
    if not factors or (sign > 0 and all(factor.as_expr().is_nonnegative for factor in factors)):
        return sp.Integer(sign)
    candidates = [sign * sp.prod([_factor(algebra, algebra.halves.plain(factor)) for factor in factors])]
    # Perhaps it is shorter in sines, where only factors that are plainly positive are left out.
    coefficient, all_factors = factored(number)
    in_sines, sign = algebra.ring.one, (1 if coefficient > 0 else -1)
    for factor, power in all_factors:
        known = (_plain_sign(factor) or algebra.halves.sign(algebra.halves.polynomial(factor))) if power % 2 else 1
        if known is None:
            in_sines = in_sines * factor
        else:
            sign *= known
    candidates.append(_of_sines(algebra, sp.Integer(sign), [(factor, 1) for factor, _ in in_sines.factor_list()[1]]) * _constant(in_sines))
    return min(candidates, key=lambda one: _cost(algebra, one))


def _constant(polynomial: Any) -> Any:
    """The sign of what a list of factors leaves out."""
    return sp.Integer(1 if polynomial.factor_list()[0] > 0 else -1)

"""Conditions without the impulse that stays open: what all of its values together allow."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from carom.symbolic.algebra import Algebra
from carom.symbolic.solution import Condition
from carom.symbolic.tidy import reduced


def without(algebra: Algebra, conditions: Sequence[Condition], free: Any) -> tuple[Condition, ...] | None:
    """Conditions that say together that some value of one open impulse meets all of these (Fourier and Motzkin).

    None where they are not linear in it, or the sign of a coefficient is not known.
    """
    own: list[Condition] = []
    bounds: dict[int, list[tuple[Condition, Any, Any]]] = {1: [], -1: []}
    for condition in conditions:
        split = _split(algebra, condition.number, free)
        if split is None or (condition.equation and split[1]):
            return None
        rest, slope = split
        if not slope:
            own.append(condition)
            continue
        sign, unknown = reduced(algebra, slope)
        if unknown:
            return None
        bounds[sign].append((condition, rest, algebra.tidy(slope * sign)))
    for low, a, up in bounds[1]:
        for high, b, down in bounds[-1]:
            if low.contact == high.contact and low.kind == high.kind == "friction_cone":
                # Both sides of one cone leave room where the contact pushes, which is asked anyway.
                continue
            contact = low.contact if low.contact == high.contact else f"{low.contact} and {high.contact}"
            meaning = low.meaning if low.meaning == high.meaning else f"{low.meaning}, and {high.meaning}"
            own.append(Condition(contact, low.kind, low.phase, meaning, algebra.tidy(a * down + b * up), algebra))
    return tuple(condition for condition in own if condition.reduced != 1)


def _split(algebra: Algebra, number: Any, free: Any) -> tuple[Any, Any] | None:
    """A number as one without the open impulse, and the coefficient of that; None where it is not linear in it."""
    expression = number.numer.as_expr()
    if number.denom.as_expr().has(free) or sp.degree(expression, free) > 1:
        return None
    below = algebra.field.new(number.denom, algebra.ring.one)
    parts = [algebra.ring.from_expr(sp.expand(one)) for one in (expression.subs(free, 0), sp.diff(expression, free))]
    rest, slope = (algebra.tidy(algebra.field.new(part, algebra.ring.one) / below) for part in parts)
    return rest, slope

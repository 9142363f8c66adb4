"""Formulas at numbers, one set of them or arrays."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from carom.errors import CaromError, Problem
from carom.symbolic.derivation import Derivation

#: Slacks below zero by less than this share of their terms are rounding, as in the engine.
SLACK_TOLERANCE = 1e-10

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Numbers:
    """A derivation at numbers: arrays of as many entries as were given (of one where all were single numbers)."""

    impulse: dict[str, Array]
    """Of each contact its impulse, a row for each component: tangential and normal in the plane, along the axes of the file in space."""
    velocity: dict[str, Array]
    """Of each contact its velocity after, in the same axes."""
    motion: dict[str, Array]
    """Of each body its velocity after along the axes, then its spin."""
    holds: NDArray[np.bool_]
    """Whether every condition is met, by some of the impulses where they stay open."""
    slack: Array
    """The least slack as a share of its terms; where impulses stay open, of those that make it largest (for one of them)."""


def numbers(derivation: Derivation, values: Mapping[Any, Any]) -> Numbers:
    """Evaluates a derivation. Free impulses may be given too; in the plane those that are not are chosen so that the conditions hold, if they can.

    Raises :class:`carom.CaromError` that names the symbols of which no value was given.
    """
    given = _given(derivation, values)
    count = max((len(one) for one in given.values()), default=1)
    open_ones = [symbol for symbol in derivation.free if symbol not in given]
    holds, slack, chosen = _decided(derivation, given, open_ones, count)
    for symbol, value in zip(open_ones, chosen):
        given[symbol] = value
    algebra, size = derivation.mechanics.algebra, derivation.problem.axes
    names = [contact.name for contact in derivation.problem.contacts]
    rows = [derivation.impulse_numbers, derivation.phases[-1].velocity, *derivation.mechanics.bodies_after(derivation.impulse_numbers)]
    flat = _evaluate(derivation, "rows", [algebra.plain(one.numer) / algebra.plain(one.denom) for row in rows for one in row], given, count)
    width = size * len(names)
    impulse = {name: flat[size * k : size * (k + 1)] for k, name in enumerate(names)}
    velocity = {name: flat[width + size * k : width + size * (k + 1)] for k, name in enumerate(names)}
    each = 6 if size == 3 else 3
    motion = {body.name: flat[2 * width + each * k : 2 * width + each * (k + 1)] for k, body in enumerate(derivation.problem.bodies)}
    return Numbers(impulse, velocity, motion, holds, slack)


def _given(derivation: Derivation, values: Mapping[Any, Any]) -> dict[Any, Array]:
    known = {symbol.name: symbol for symbol in (*derivation.problem.symbols, *derivation.free)}
    given = {known[str(name)]: np.atleast_1d(np.asarray(value, dtype=float)) for name, value in values.items() if str(name) in known}
    missing = sorted(symbol.name for symbol in derivation.problem.symbols if symbol not in given)
    if missing:
        raise CaromError(f"no value of {', '.join(missing)}", [Problem("has no value", kind="missing_key", path=f"values.{name}", key=name) for name in missing])
    return given


def _evaluate(derivation: Derivation, key: str, expressions: list[Any], given: dict[Any, Array], count: int) -> Array:
    """Expressions at arrays; the function is made once."""
    made: dict[str, Any] = derivation.__dict__.setdefault("_made", {})
    symbols = sorted(given, key=lambda symbol: str(symbol.name))
    name = f"{key}:{','.join(symbol.name for symbol in symbols)}"
    if name not in made:
        made[name] = sp.lambdify(symbols, expressions, "numpy", cse=True)
    with np.errstate(all="ignore"):
        found = made[name](*[given[symbol] for symbol in symbols])
    return np.array([np.broadcast_to(np.asarray(one, dtype=float), (count,)) for one in found]).reshape(len(expressions), count)


def _decided(derivation: Derivation, given: dict[Any, Array], open_ones: list[Any], count: int) -> tuple[NDArray[np.bool_], Array, Array]:
    """Whether all conditions hold, the least share, and values of the impulses that stay open."""
    if derivation.contradiction is not None:
        return np.zeros(count, dtype=bool), np.full(count, -np.inf), np.zeros((0, count))
    constants, sizes, slopes = _slacks(derivation, open_ones)
    at_zero, scale = _evaluate(derivation, "slack", constants, given, count), _evaluate(derivation, "scale", sizes, given, count)
    along = np.array([_evaluate(derivation, f"slope{k}", row, given, count) for k, row in enumerate(slopes)]).reshape(len(open_ones), len(constants), count)
    chosen = np.zeros((len(open_ones), count))
    if len(open_ones) == 1:
        chosen[0] = _middle(at_zero, along[0])
    elif len(open_ones) > 1:
        # Where a condition is broken that no open impulse changes, none needs to be looked for.
        possible = ~((at_zero < -SLACK_TOLERANCE * scale) & (along == 0).all(axis=0)).any(axis=0)
        for i in np.flatnonzero(possible):
            chosen[:, i] = _best(at_zero[:, i], along[:, :, i].T)
    total = at_zero + np.einsum("kji,ki->ji", along, chosen) if len(open_ones) else at_zero
    scale = scale + np.einsum("kji,ki->ji", np.abs(along), np.abs(chosen)) if len(open_ones) else scale
    shares = np.divide(total, scale, out=np.zeros_like(total), where=scale > 0)
    equations = np.array([one.equation for one in derivation.conditions], dtype=bool)
    shares[equations] = -np.abs(shares[equations])
    # What is zero whatever the numbers are is met, and is no border.
    shares[np.array([not one.number for one in derivation.conditions], dtype=bool)] = np.inf
    least = shares.min(axis=0, initial=np.inf)
    # What is no number holds nowhere.
    known = np.isfinite(total).all(axis=0)
    return known & (least >= -SLACK_TOLERANCE), np.where(known, least, np.nan), chosen


def _slacks(derivation: Derivation, open_ones: list[Any]) -> tuple[list[Any], list[Any], list[list[Any]]]:
    """Slacks where the open impulses are zero, the sums of their terms, and how they change with each open impulse."""
    made: dict[str, Any] = derivation.__dict__.setdefault("_slacks", {})
    key = ",".join(str(one) for one in open_ones)
    if key in made:
        found: tuple[list[Any], list[Any], list[list[Any]]] = made[key]
        return found
    algebra = derivation.mechanics.algebra
    slacks = [algebra.plain(one.number.numer) / algebra.plain(one.number.denom) for one in derivation.conditions]
    slopes = [[sp.diff(slack, symbol) for slack in slacks] for symbol in open_ones]
    if any(slope.has(*open_ones) for row in slopes for slope in row):
        message = f"friction in space leaves {', '.join(str(one) for one in open_ones)} open: give them values"
        raise CaromError(message, [Problem(message, kind="missing_key", path=f"values.{open_ones[0]}")])
    constants = [slack.subs({symbol: 0 for symbol in open_ones}) for slack in slacks]
    made[key] = constants, [_size(one) for one in constants], slopes
    return _slacks(derivation, open_ones)


def _size(expression: Any) -> Any:
    """The sum of the magnitudes of an expression's terms above the line, over the magnitude below it."""
    above, below = sp.fraction(expression)
    return sum(abs(one) for one in sp.Add.make_args(sp.expand(above))) / abs(below)


def _middle(at_zero: Array, slope: Array) -> Array:
    """Of one open impulse: the middle of what every condition allows."""
    with np.errstate(all="ignore"):
        ends = -at_zero / slope
        low = np.where(slope > 0, ends, -np.inf).max(axis=0)
        high = np.where(slope < 0, ends, np.inf).min(axis=0)
        inside = np.where(np.isinf(low), np.where(np.isinf(high), 0.0, high - 1 - np.abs(high)), low + 1 + np.abs(low))
        middle = np.where(np.isinf(low) | np.isinf(high), inside, (low + high) / 2)
    return np.asarray(middle)


def _best(at_zero: Array, slopes: Array) -> Array:
    """Of several: where the smallest slack is largest, at a corner of the linear programme."""
    count = slopes.shape[1]
    best, where = -np.inf, np.zeros(count, dtype=np.float64)
    for rows in itertools.combinations(range(len(at_zero)), count + 1):
        matrix = np.hstack([slopes[list(rows)], -np.ones((count + 1, 1))])
        if abs(np.linalg.det(matrix)) < 1e-12:
            continue
        point = np.asarray(np.linalg.solve(matrix, -at_zero[list(rows)])[:count], dtype=np.float64)
        least = float((at_zero + slopes @ point).min())
        if least > best:
            best, where = least, point
    return where

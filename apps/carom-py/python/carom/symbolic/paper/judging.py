"""What a paper prints, as data, and what follows when it is derived again.

A verdict is never written down: a printed formula agrees where it is the derived one; else it is a *misprint* where what is obviously meant agrees,
and *wrong in print* where it does not, or nothing is. These are the words of ``carom validate``.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp

from carom.symbolic.derivation import Derivation
from carom.symbolic.emptiness import Asked, Existence, exists
from carom.symbolic.solution import Condition

AGREES, MISPRINT, WRONG, OPEN = "agrees", "misprint", "wrong in print", "not decided"
#: Two formulas that differ by less than this share of their terms at random numbers, with 30 digits, are one.
_SAME = sp.Float("1e-20")


@dataclass(frozen=True)
class Outcome:
    """What a comparison says."""

    holds: bool | None
    """Whether what is printed is right; None where that could not be decided."""
    right: str = ""
    """What is right, or an example against it."""


@dataclass(frozen=True)
class Claim:
    """One printed formula or statement."""

    key: str
    """Its name, as in the tables of ``carom validate`` where these have it."""
    section: str
    """Where it stands in the paper."""
    what: str
    """What it is of."""
    printed: str
    """As it is read in print."""
    judged: Callable[[], Outcome]
    """Whether it is right, by derivation."""
    meant: str = ""
    """What is probably meant, where it is not what is printed."""
    judged_as_meant: Callable[[], Outcome] | None = None

    @cached_property
    def outcome(self) -> Outcome:
        """As it is printed."""
        return self.judged()

    @cached_property
    def verdict(self) -> str:
        """``agrees``, ``misprint``, ``wrong in print`` or ``not decided``."""
        if self.outcome.holds:
            return AGREES
        if self.outcome.holds is None:
            return OPEN
        if self.judged_as_meant is not None and self.judged_as_meant().holds:
            return MISPRINT
        return WRONG

    @property
    def right(self) -> str:
        """What is right, where what is printed is not."""
        if self.verdict == AGREES:
            return ""
        if self.verdict == MISPRINT:
            return f"{self.meant} is meant" + (f": {self.outcome.right}" if self.outcome.right and self.outcome.right != self.meant else "")
        return self.outcome.right


def formula(key: str, section: str, what: str, printed: str, derived: Callable[[], tuple[Derivation, Any]], *, read: str | None = None, meant: str = "") -> Claim:
    """A printed formula beside the derived one. ``read`` is the printed one as an expression, where its letters are not plainly that."""

    def judged(text: str) -> Callable[[], Outcome]:
        def judge() -> Outcome:
            derivation, right = derived()
            same = equal(derivation, text, right)
            return Outcome(same, f"{sp.sstr(derivation.simplify(right))}")

        return judge

    return Claim(key, section, what, printed, judged(read or printed), meant, judged(meant) if meant else None)


def equal(derivation: Derivation, text: str, right: Any) -> bool:
    """Whether a text is a derived expression: exactly, or at random numbers where exact arithmetic does not take it."""
    names = derivation.problem.names
    printed = names.read(text)
    strange = {symbol.name for symbol in printed.free_symbols} - {symbol.name for symbol in derivation.problem.symbols}
    if strange:
        return False
    try:
        return not derivation.mechanics.algebra.element(printed - right)
    except ValueError:
        return same_at_random(printed, right)


def same_at_random(one: Any, other: Any, times: int = 5) -> bool:
    """Whether two expressions agree at random positive numbers, to twenty digits."""
    chance = random.Random(1)
    symbols = sorted((one - other).free_symbols, key=str)
    for _ in range(times):
        values = {symbol: sp.Rational(chance.randint(2, 98), 100) for symbol in symbols}
        a, b = (sp.N(side.subs(values), 30) for side in (one, other))
        if not (abs(a - b) <= _SAME * (abs(a) + abs(b))):
            return False
    return True


def statement(key: str, section: str, what: str, printed: str, judged: Callable[[], Outcome], *, meant: str = "", judged_as_meant: Callable[[], Outcome] | None = None) -> Claim:
    """A statement in words, decided by hypotheses and inequalities."""
    return Claim(key, section, what, printed, judged, meant, judged_as_meant)


def told(found: Existence) -> str:
    """An example, in words."""
    if found.example is None:
        return found.why
    # Units do not matter: what is 1 is left out.
    return ", ".join(f"{symbol} = {value:.4g}" for symbol, value in sorted(found.example.items(), key=lambda item: str(item[0])) if str(symbol) not in ("m", "a", "omega0"))


def may_hold(derivation: Derivation, *, beside: Sequence[Asked] = (), relations: Sequence[Any] = (), without: Sequence[Condition] = (), seconds: float = 5.0) -> Existence:
    """Whether the conditions of a hypothesis can hold together with others."""
    own = [Asked(one.number, one.meaning, one.equation) for one in derivation.conditions if one not in without]
    return exists(derivation.mechanics.algebra, [*own, *beside], relations, seconds=seconds)


def broken(condition: Condition) -> Asked:
    """That an inequality does not hold."""
    return Asked(-condition.number, f"not: {condition.meaning}")


def never(found: Existence) -> bool | None:
    """True where there is no example, but perhaps on a border; None where that is not known."""
    return None if found.verdict == "unknown" else found.verdict in ("empty", "border")


def occurs(found: Existence, what: str = "") -> Outcome:
    """That something can happen."""
    absent = never(found)
    return Outcome(None if absent is None else not absent, f"{what}{': ' if what and found.why else ''}{found.why}")


def does_not_occur(found: Existence, what: str = "") -> Outcome:
    """That something cannot happen."""
    return Outcome(never(found), f"{what}{': ' if what else ''}{told(found)}")


def all_of(outcomes: Sequence[Outcome]) -> Outcome:
    """That several statements hold."""
    wrong = [one for one in outcomes if one.holds is False]
    if wrong:
        return Outcome(False, "; ".join(one.right for one in wrong))
    return Outcome(None if any(one.holds is None for one in outcomes) else True, "")

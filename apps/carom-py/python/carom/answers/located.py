"""Answers of `carom located`. Written by `generate.py` from its schema."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from carom._answer import Answer
from carom.answers.shared import (
    Approximation,
    StudyRun,
)


@dataclass(frozen=True, kw_only=True)
class LocatedShare:
    """A probability by the boundary of what is wanted."""

    along: str
    """Path of the quantity along which the boundary was located."""
    high: float
    """Upper end of its 95 % interval."""
    lines: int
    """Along how many lines it was located."""
    low: float
    """Lower end of its 95 % interval, in which what no line and no check met is not."""
    share: float
    """The probability."""
    unseen_share: float
    """What of all drops may end otherwise than their line says, at most (Wilson, 95 %): one more drop on each
    line checked it.
    """


@dataclass(frozen=True, kw_only=True)
class Located(Answer):
    """The summary of a yield that was located: lines along one quantity say where drops stop to end as wanted."""

    approximations: list[Approximation] | None = None
    """How the computed part differs from the drawn one; absent where it does not."""
    notes: list[str] | None = None
    """What was read from the part's file, taken from tables, or assumed; absent where there is nothing to say."""
    plate: str
    """The plate that is looked at."""
    run: StudyRun
    """What it took."""
    scene: str
    """Name of the scene."""
    seed: int
    """What every random number comes from."""
    wanted: str
    """What is wanted: as the scene says, or as the drop of the middle of all tolerances ends."""
    yield_: LocatedShare
    """With what probability it comes out so."""
    yield_within_limits: LocatedShare | None = None
    """With what probability it does and keeps the limits of `[design]` on speed and time; null where it has
    none.
    """

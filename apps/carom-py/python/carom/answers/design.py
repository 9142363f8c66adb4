"""Answers of `carom design`. Written by `generate.py` from its schema."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from carom._answer import Answer
from carom.answers.shared import (
    Approximation,
    Exit,
    Probability,
    SpaceExit,
    StudyRun,
)


@dataclass(frozen=True, kw_only=True)
class Delivered:
    """How the part comes to lie on a plate."""

    ending: str
    """How it ends there."""
    plate: str
    """Name of the plate."""


@dataclass(frozen=True, kw_only=True)
class DesignLayout:
    """A layout."""

    chosen: dict[str, float]
    """The quantities that were chosen, SI."""
    height_m: float
    """From the highest end of a plate to the lowest [m]."""
    impact_speed_m_s: float
    """The hardest strike on a plate, the first or a later one, where nothing varies [m/s]."""
    sliding_speed_m_s: float
    """The largest slip velocity [m/s]."""
    time_s: float
    """When the run ends [s]."""
    width_m: float
    """From the leftmost end of a plate to the rightmost [m]."""
    yield_: Probability
    """Share of drops that end as wanted within the limits, under the tolerances."""
    yield_doubled: Probability
    """The same with every tolerance doubled."""


@dataclass(frozen=True, kw_only=True)
class DesignWorst:
    """The worst of the winner's drops within their tolerances."""

    drops: int
    """How many drops were looked at."""
    impact_speed_m_s: float
    """The hardest strike on a plate, the first or a later one [m/s]."""
    limits_hold: bool
    """True where none of them exceeds a limit on speed or time."""
    sliding_speed_m_s: float
    """The largest slip velocity [m/s]."""
    time_s: float
    """When the longest run ends [s]."""


@dataclass(frozen=True, kw_only=True)
class Forbidden:
    """What a demand forbids."""

    alone: int
    """Those that fail it and no other."""
    demand: Literal["it can be drawn", "no two plates cross", "it ends as wanted", "impact speed", "sliding speed", "height", "width", "time", "it touches no wall", "it does not jam afterwards"]
    """The demand."""
    failed: int
    """Layouts of the first look that fail it."""
    limit: float | None = None
    """The limit, SI; null where the demand has no measure."""
    nearest: float | None = None
    """The nearest to the limit of these, SI; null where there is none, or the demand has no measure."""


DesignExit = Exit | SpaceExit
"""How the part leaves the last plate: the pose of a part that moves in the plane, place and attitude of a solid
one.
"""


@dataclass(frozen=True, kw_only=True)
class Design(Answer):
    """The answer to an inverse design."""

    aim: Literal["yield", "height", "time"]
    """What is aimed at: yield, height or time."""
    approximations: list[Approximation] | None = None
    """How the computed part differs from the drawn one; absent where it does not."""
    at_range_ends: dict[str, Literal["low", "high"]]
    """Its quantities that are at an end of their range, with `low` or `high`: a wider range may do better."""
    delivered: list[str]
    """How the part is delivered: the ending on every plate but the first, in order, in words."""
    endings: list[Delivered]
    """The same as data."""
    ends: Literal["landed", "delivered", "stuck", "on_end", "jammed", "missed", "escaped", "never_flat", "unresolved", "blocked"] | None = None
    """How the winner's run ends that is followed as far as the part goes: `delivered`, or why it is not."""
    exit: DesignExit | None = None
    """How it leaves the last plate, where nothing varies; null where it does not, and without a winner."""
    forbidden: list[Forbidden]
    """What the demands forbid, by the first look."""
    front: list[DesignLayout]
    """Layouts none of which is worse than another in yield, height and impact speed at once."""
    met: int
    """Those of them that meet every demand where nothing varies."""
    outcome: Literal["found", "not possible"]
    """found, or not possible."""
    run: StudyRun
    """What it took."""
    scanned: int
    """Layouts of the first look."""
    scene: str
    """Name of the scene."""
    seed: int
    """What every random number comes from."""
    wall_strikes: dict[str, int]
    """How often it strikes each wall where nothing varies; walls that it does not touch are absent."""
    winner: DesignLayout | None = None
    """The best layout, with values that a workshop can keep."""
    worst: DesignWorst | None = None
    """The worst of its drops within their tolerances; null without a winner."""

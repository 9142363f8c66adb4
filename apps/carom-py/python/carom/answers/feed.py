"""Answers of `carom feed`. Written by `generate.py` from its schema."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from carom._answer import Answer
from carom.answers.shared import (
    Approximation,
    StudyRun,
)


@dataclass(frozen=True, kw_only=True)
class Alone:
    """One part alone."""

    end_s: float
    """When [s]."""
    ending: str
    """How it ends on the last plate."""
    outcome: Literal["landed", "delivered", "stuck", "on_end", "jammed", "missed", "escaped", "never_flat", "unresolved", "blocked"]
    """How its run ends."""


@dataclass(frozen=True, kw_only=True)
class Doing:
    """What a part was doing."""

    plate: str
    """The plate or wall it is on; in flight, the one it was on last."""
    stage: Literal["slide", "tip", "flight", "swing", "stick", "roll", "wedge", "push", "rest", "clatter"] | None = None
    """Its stage, as in the result of a run; null where it has just been put on the first plate."""


@dataclass(frozen=True, kw_only=True)
class FeedEnd:
    """What becomes of one part."""

    as_wanted: bool
    """True where it ends as is wanted, and leaves the feeder or does what one alone does."""
    ending: str
    """same side, turned, face and its number; else how a run ends that never lies on the last plate."""
    outcome: Literal["landed", "delivered", "stuck", "on_end", "jammed", "missed", "escaped", "never_flat", "unresolved", "blocked"]
    """How its run ends: it is followed until it has left the last plate or rests."""


@dataclass(frozen=True, kw_only=True)
class FeedMeeting:
    """How two parts are in each other's way."""

    blocked: bool
    """True where the second found its place taken and did not start; false where they touched."""
    doing: list[Doing]
    """What each was doing until then."""
    parts: list[int]
    """Their numbers, from 1; the first one goes ahead."""


@dataclass(frozen=True, kw_only=True)
class FeedStretch:
    """Intervals at which the same happens."""

    first: FeedMeeting | None = None
    """How parts are first in each other's way; null where none is."""
    from_s: float
    """The shortest interval of them that was followed [s]."""
    parts: list[FeedEnd]
    """What becomes of each part. Of solid parts that do not touch what becomes of one, as of all; of those that
    touch it is not followed, and the list is empty.
    """
    to_s: float
    """The longest interval of them that was followed [s]."""
    what: Literal["no_touch", "as_wanted", "otherwise", "touch", "blocked", "unresolved"]
    """no_touch, as_wanted (parts touch, and all end as wanted), otherwise (one at least does not), touch (solid
    parts touch, and are not followed on), blocked (a part cannot start) or unresolved (more meet at once than
    is resolved).
    """


@dataclass(frozen=True, kw_only=True)
class OwnMeeting:
    """The longest interval at which the way of one part alone meets itself."""

    high_s: float
    """It does at none above this [s]."""
    low_s: float
    """It does at this interval [s]."""


@dataclass(frozen=True, kw_only=True)
class SavedFeed:
    """A scene that was saved: `carom run` follows it again."""

    file: str
    """Its file, beside the summary."""
    interval_s: float
    """The interval [s]."""
    why: Literal["touches", "otherwise", "free"]
    """touches: the longest interval with a touch; otherwise: the longest at which a part ends otherwise; free:
    the smallest free of touch.
    """


@dataclass(frozen=True, kw_only=True)
class SmallestInterval:
    """The smallest interval above which parts do not touch."""

    below: Literal["no_touch", "as_wanted", "otherwise", "touch", "blocked", "unresolved"]
    """What happens at that one, as in the stretches."""
    first: FeedMeeting | None = None
    """How they touch at the longest interval at which they do."""
    interval_s: float
    """Parts do not touch at this interval [s]."""
    limited_by: str | None = None
    """The plate that limits it: the one that the part ahead is on."""
    parts_per_minute: float
    """60 s over the interval."""
    touching_s: float
    """They do at this one, the longest that was seen, or it is not resolved whether they do [s]."""


@dataclass(frozen=True, kw_only=True)
class Feed(Answer):
    """The summary of a search for the interval of a feed."""

    accuracy_s: float
    """How finely changes are located [s]."""
    alone: Alone
    """One part alone, followed until it has left the last plate or rests."""
    approximations: list[Approximation] | None = None
    """How the computed part differs from the drawn one; absent where it does not."""
    feeds: int
    """Feeds that were followed; of solid parts one part alone."""
    friction: float | None = None
    """Friction coefficient between parts; null of solid parts, which are followed until they touch."""
    own_meeting: OwnMeeting | None = None
    """The longest interval at which the way of one part meets itself, found without any feed; null where it
    comes to rest.
    """
    parts: int | None = None
    """Number of parts that are fed; null of solid parts: what is said is so for any number."""
    piles_up: bool
    """True where parts come to rest on the feeder, and are in the way of later ones at every interval."""
    restitution: float | None = None
    """Coefficient of restitution between parts; null of solid parts."""
    run: StudyRun
    """What it took; a drop is one part of one feed."""
    saved: list[SavedFeed]
    """Scenes that were saved."""
    scene: str
    """Name of the scene."""
    smallest: SmallestInterval | None = None
    """The smallest interval above which parts do not touch; null where there is none."""
    stretches: list[FeedStretch]
    """What happens at which interval, from the shortest to the longest that was followed."""
    unresolved_s: float
    """What of these lies between changes that were not followed [s]."""
    wanted: str
    """What is wanted: as the scene says, or as one part alone ends."""

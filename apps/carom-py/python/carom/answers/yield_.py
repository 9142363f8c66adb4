"""Answers of `carom yield`. Written by `generate.py` from its schema."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from carom._answer import Answer
from carom.answers.shared import (
    Approximation,
    Probability,
    Spread,
    StudyRun,
)


@dataclass(frozen=True, kw_only=True)
class Ending:
    """How a drop may end, and how probable that is."""

    ending: str
    """same side, turned, face and its number; else how a run ends that never lies on the plate."""
    probability: Probability
    """Its probability."""


@dataclass(frozen=True, kw_only=True)
class FaceShare:
    """A face and its share."""

    face: int
    """Number of the face."""
    share: Probability
    """Its share; `count` tells from how many repetitions the interval comes."""


@dataclass(frozen=True, kw_only=True)
class Law:
    """How the drop of the middle of all tolerances ends under another law."""

    ending: str
    """How it ends."""
    law: Literal["poisson", "stronge", "newton"]
    """poisson, stronge or newton."""
    restitution: float
    """Restitution on every plate and wall."""


@dataclass(frozen=True, kw_only=True)
class Recirculation:
    """A loop that throws the rejected back, when it has run for long: each rejected part comes back on the face
    on which it lay on the plate that is looked at; for each part that leaves, or lies on no face, a new one
    comes in.
    """

    passes: float
    """Passes for each part that ends as wanted."""
    starts: list[FaceShare]
    """On which faces parts start, new ones and thrown back ones."""
    yield_: Probability
    """With what probability a part in the loop ends as wanted in one pass."""


@dataclass(frozen=True, kw_only=True)
class Sensitivity:
    """How much a tolerance has to do with whether a drop ends as wanted: Sobol's indices."""

    first: float
    """Share of the variance that it explains by itself."""
    first_error: float
    """Half of the 95 % interval of that."""
    quantity: str
    """Path of the quantity."""
    total: float
    """That and what it does together with others."""
    total_error: float
    """Half of the 95 % interval of that."""


@dataclass(frozen=True, kw_only=True)
class Transition:
    """With what probability a part that lies on one face comes to lie on another on the next plate."""

    drops: int
    """How many drops do so."""
    ending: str
    """How it ends: the face, or how a run ends that never lies on the plate."""
    from_: int | None = None
    """The face on the plate before, by its number; on the plate after the first, that on which it starts. Null
    of a disc.
    """
    high: float
    """Upper end of its 95 % interval."""
    low: float
    """Lower end of its 95 % interval."""
    plate: str
    """Name of the plate."""
    share: float
    """Share of the drops that come from that face."""
    to: int | None = None
    """The face on this plate; null where it comes to lie on none."""


@dataclass(frozen=True, kw_only=True)
class Worst:
    """A drop that somebody should look at."""

    ending: str
    """How it ends."""
    file: str
    """Its scene, beside the summary: `carom run` follows it again."""
    impact_speed_m_s: float | None = None
    """Largest speed of a first strike on the plates that the part comes to lie on [m/s]; null where it comes to
    lie on none but the one it starts on, whatever it strikes.
    """
    why: Literal["nearest", "hardest"]
    """nearest: of all drops with its ending the most probable one; hardest: the hardest first strike of all, on
    plates that the part comes to lie on.
    """


@dataclass(frozen=True, kw_only=True)
class YieldPlate:
    """One plate."""

    flat_s: Spread | None = None
    """When the part first lies flat [s]."""
    impact_speed_m_s: Spread | None = None
    """Speed of the striking point at the first strike [m/s]."""
    plate: str
    """Its name."""
    sliding_speed_m_s: Spread | None = None
    """Largest slip velocity [m/s]."""


@dataclass(frozen=True, kw_only=True)
class Yield(Answer):
    """The summary of a yield study."""

    approximations: list[Approximation] | None = None
    """How the computed part differs from the drawn one; absent where it does not."""
    endings: list[Ending]
    """How drops end."""
    laws: list[Law]
    """The drop of the middle of all tolerances under every law, and with more or less restitution."""
    notes: list[str] | None = None
    """What was read from the part's file, taken from tables, or assumed; absent where there is nothing to say."""
    parts_per_minute: float | None = None
    """Parts a minute, one at a time: 60 s over the mean time; null where none ends as wanted."""
    plate: str
    """The plate that is looked at."""
    plates: list[YieldPlate]
    """What happens on each plate."""
    recirculation: Recirculation | None = None
    """What a loop that throws the rejected back comes to. Null of a disc; where no drop ends as wanted; where a
    rejected part lies on a face on which none was dropped.
    """
    run: StudyRun
    """What it took."""
    samples: int
    """Samples, in 16 repetitions."""
    scene: str
    """Name of the scene."""
    seed: int
    """What every random number comes from."""
    sensitivity: list[Sensitivity] | None = None
    """Which tolerance decides, the largest first; null where too few samples end otherwise to tell, or there are
    too many quantities.
    """
    time_s: Spread | None = None
    """When runs end that end as wanted [s]."""
    transitions: list[Transition]
    """From which face to which, plate by plate."""
    wanted: str
    """What is wanted: as the scene says, or as the drop of the middle of all tolerances ends."""
    worst: list[Worst]
    """Drops to look at."""
    yield_: Probability
    """With what probability it comes out so."""
    yield_within_limits: Probability | None = None
    """With what probability it does and keeps the limits of `[design]` on speed and time; null where it has
    none.
    """

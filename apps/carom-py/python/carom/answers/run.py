"""Answers of `carom run`. Written by `generate.py` from its schema."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from carom._answer import Answer
from carom.answers.shared import (
    Accumulation,
    AmountUnit,
    Approximation,
    Exit,
    Jam,
    Limit,
    Plate,
    StageEnd,
    Wanted,
    Work,
)


@dataclass(frozen=True, kw_only=True)
class Contact:
    """One contact's part in an impact."""

    after: ContactVelocity
    """Velocity of the contact point after."""
    before: ContactVelocity
    """Velocity of the contact point before."""
    feature: str
    """The part's feature, as it lay at the start."""
    normal: list[float]
    """Unit normal out of the obstacle."""
    normal_impulse_N_s: float
    """Normal impulse on the part [N s]."""
    normal_work_J: float
    """Work of the normal impulse [J]."""
    plate: str
    """The plate or wall: its name, or its number, counted from 0, where it has none."""
    point_m: list[float]
    """Where they touch [m]."""
    state: Literal["separates", "sticks", "slips"]
    """What it does after."""
    tangential_impulse_N_s: float
    """Tangential impulse on the part [N s]."""
    tangential_work_J: float
    """Work of the tangential impulse [J]."""


@dataclass(frozen=True, kw_only=True)
class ContactVelocity:
    """Velocity of a contact point of the body; the tangent is the normal turned 90° clockwise."""

    normal_m_s: float
    """Along the normal [m/s]; an approach is negative."""
    slip_m_s: float
    """Along the tangent [m/s]."""


DecidedKind = Literal["nothing", "contacts", "impact"]
"""What a decision was about."""


@dataclass(frozen=True, kw_only=True)
class Decided:
    """What the tightest decision of a run was about."""

    kind: DecidedKind
    """What it was."""
    t_s: float | None = None
    """When [s]; null where nothing was decided."""


@dataclass(frozen=True, kw_only=True)
class FedPart:
    """One of several parts."""

    end_s: float
    """When that was decided [s]."""
    entered_s: float
    """When it started [s]."""
    exit: Exit | None = None
    """How it left over the last plate's edge; null unless delivered."""
    impacts: list[Impact]
    """The impacts, in order of time; `another part` is what it struck where it struck no plate or wall."""
    outcome: Literal["landed", "delivered", "stuck", "on_end", "jammed", "missed", "escaped", "never_flat", "unresolved", "blocked"]
    """As of a run of one part; or blocked: it did not start, for another part stood in its place; or unresolved:
    more contacts met at once than could be resolved.
    """
    part: int
    """Its number, from 1."""
    plates: list[Plate]
    """The plates it landed on, in order of landing."""
    stages: list[Stage]
    """The stages, in order of time, to the end of the feed."""


@dataclass(frozen=True, kw_only=True)
class FeedContact:
    """Two parts that touch."""

    parts: list[int]
    """Their numbers, from 1."""
    speed_m_s: float | None = None
    """Speed of the points that strike each other then [m/s]; null where they come to touch without a strike."""
    t_s: float
    """When they touch first [s]."""


@dataclass(frozen=True, kw_only=True)
class Feed:
    """Several parts, one after the other."""

    broken_off: str | None = None
    """Why it was broken off there, where it was."""
    contacts: list[FeedContact]
    """The first contact of each two parts that touch, in order of time."""
    end_s: float
    """When nothing was left to decide [s]."""
    friction: float
    """Friction coefficient between parts."""
    interval_s: float
    """Time from one part's start to the next [s]."""
    parts: list[FedPart]
    """The parts, in order; their times count from the first part's start."""
    restitution: float
    """Coefficient of restitution between parts."""


@dataclass(frozen=True, kw_only=True)
class Impact:
    """An impact."""

    after: Twist
    """Velocity after."""
    angle_to_normal_rad: float | None = None
    """From the struck plate's normal to the part's axis, positive where the mass centre is uphill of the
    striking corner [rad].
    """
    before: Twist
    """Velocity before."""
    class_: Literal["sliding", "sliding from rest", "sticking", "R-reversed", "C-reversed", "R-sticking", "C-sticking"] | None = None
    """Class of Wang and Mason, where one contact acts."""
    contacts: list[Contact]
    """The contacts, the striking one first."""
    energy_after_J: float
    """Kinetic energy after [J]."""
    energy_before_J: float
    """Kinetic energy before [J]."""
    gained_energy: bool
    """True where the law created energy."""
    incidence_rad: float | None = None
    """From the struck plate's inward normal to the striking corner's velocity, positive where it moves downhill
    [rad].
    """
    law: Literal["poisson", "stronge", "newton"]
    """Restitution law."""
    note: str | None = None
    """What is remarkable about it, in words."""
    notes: list[Note] | None = None
    """The same as data; absent where nothing is."""
    t_s: float
    """Time [s]."""
    type: int | None = None
    """Type 1 to 7, where one contact acts."""


NoteKind = Literal["without_approach", "ways_on", "open_share", "lifts_off", "gained_energy", "restitution_scaled"]
"""A kind of note on an impact."""


@dataclass(frozen=True, kw_only=True)
class Note:
    """What is remarkable about an impact."""

    amount: float | None = None
    """How much; null where the kind says all."""
    kind: NoteKind
    """What it is."""
    unit: AmountUnit | None = None
    """The unit of the amount; null without one."""


@dataclass(frozen=True, kw_only=True)
class Stage:
    """A stage."""

    end: State
    """Pose and velocity at the end."""
    end_s: float
    """End [s]."""
    ended_by: str
    """Why it ended, in words."""
    event: StageEnd
    """The same as data."""
    name: Literal["slide", "tip", "flight", "swing", "stick", "roll", "wedge", "push", "rest", "clatter"]
    """Its name."""
    plate: str | None = None
    """The plate or wall it happens on, by its name; by its number, counted from 0, where it has none; null in
    flight.
    """
    start: State
    """Pose and velocity at the start."""
    start_s: float
    """Start [s]."""


@dataclass(frozen=True, kw_only=True)
class State:
    """Pose and velocity."""

    angle_rad: float
    """Angle of the part from its drawing [rad]."""
    spin_rad_s: float
    """Spin [rad/s]."""
    vx_m_s: float
    """Velocity of the mass centre [m/s]."""
    vy_m_s: float
    """Velocity of the mass centre [m/s]."""
    x_m: float
    """Mass centre [m]."""
    y_m: float
    """Mass centre [m]."""


@dataclass(frozen=True, kw_only=True)
class Twist:
    """Velocity of a body."""

    spin_rad_s: float
    """Spin [rad/s]."""
    vx_m_s: float
    """Velocity of the mass centre [m/s]."""
    vy_m_s: float
    """Velocity of the mass centre [m/s]."""


@dataclass(frozen=True, kw_only=True)
class Run(Answer):
    """A run of a feeder."""

    accumulations: list[Accumulation]
    """Infinitely many impacts in finite time, closed at their limits."""
    approximations: list[Approximation] | None = None
    """How the computed part differs from the drawn one; absent where it does not."""
    decided: Decided
    """The same as data."""
    end_s: float
    """When the run ended [s]."""
    exit: Exit | None = None
    """How it left over the last plate's edge; null unless delivered."""
    feed: Feed | None = None
    """What several parts did, one after the other; only where the scene has a `[feed]`. All else is about one
    part alone.
    """
    impacts: list[Impact]
    """The impacts, in order of time."""
    jam: Jam | None = None
    """Between what the part jammed; absent unless jammed."""
    limit_runs: int | None = None
    """How many runs that took."""
    limits: list[Limit] | None = None
    """How far each quantity may move before the verdict flips; only where it was asked for."""
    margin: float | None = None
    """The smallest decided inequality divided by the sum of its terms' magnitudes; null where none was decided."""
    margin_of: str
    """What that decided, in words."""
    missed_by_m: float | None = None
    """How near the part came to the last plate in the flight in which it missed it [m]; absent unless missed."""
    notes: list[str] | None = None
    """What was read from the part's file, taken from tables, or assumed; absent where there is nothing to say."""
    outcome: Literal["landed", "delivered", "stuck", "on_end", "jammed", "missed", "escaped", "never_flat", "unresolved", "blocked"]
    """How it ended; blocked and unresolved only in a feed."""
    plates: list[Plate]
    """The plates the part landed on, in order of landing."""
    scene: str
    """Name of the scene."""
    stages: list[Stage]
    """The stages, in order of time."""
    swings_on_face: int | None = None
    """The face on whose arc the part swings to and fro for ever; absent of every other end."""
    wanted: list[Wanted]
    """Whether it ended as wanted, plate by plate; empty where the scene wants nothing."""
    work: Work
    """Counts of the work done."""

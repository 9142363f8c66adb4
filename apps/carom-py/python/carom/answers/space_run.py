"""Answers of `carom run` of a scene with a solid part. Written by `generate.py` from its schema."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from carom._answer import Answer
from carom.answers.shared import (
    Accumulation,
    Approximation,
    Jam,
    Limit,
    Plate,
    SpaceExit,
    StageEnd,
    Wanted,
    Work,
)


@dataclass(frozen=True, kw_only=True)
class SolidFace:
    """A face of a solid part's hull: on it the part can lie, or it rolls off."""

    centre_height_m: float
    """Height of the mass centre above it [m]."""
    corners: list[int]
    """Its corners, by their numbers, counter-clockwise as seen from outside."""
    face: int
    """Its number, as results name it."""
    margin_m: float
    """How far inside the face the mass centre's projection is from the nearest side [m]; negative where it is
    outside. Of a rounded part the face ends where the round edges begin.
    """
    normal: list[float]
    """Unit normal, outwards, in the part's axes."""
    quasi_static_share: float
    """The share of all attitudes from which the part comes to rest on this face, where it is let go so gently
    that it never swings on: by solid angles, and with what rolls onto it from faces on which it does not
    stay.
    """
    solid_angle_share: float
    """The face as it is seen from the mass centre: its solid angle, as a share of 4π."""
    stable: bool
    """True where the part stays on it on level ground."""
    tips_after_rad: float
    """How far the part can be tilted at least before it tips over [rad]; 0 where it does not stay."""
    tips_onto: int
    """The face beyond that side."""
    tips_over: list[int]
    """The side over which it tips so, or rolls off: the corners at its two ends."""


@dataclass(frozen=True, kw_only=True)
class SpaceContact:
    """A contact of an impact."""

    feature: str
    """What of the part touches: a corner, a face, an edge."""
    impulse_N_s: list[float]
    """The impulse on the part, world axes."""
    plate: str
    """The plate or wall."""
    state: Literal["slips", "sticks", "separates"]
    """What it does after: slips, sticks or separates."""
    strikes: bool
    """True where it comes down in this impact."""


@dataclass(frozen=True, kw_only=True)
class SpaceImpact:
    """An impact."""

    contacts: list[SpaceContact]
    """The contacts that touch, those that strike first."""
    energy_after_J: float
    """Kinetic energy after."""
    energy_before_J: float
    """Kinetic energy before."""
    plate: str
    """The plate or wall that is struck first."""
    several: bool
    """True where several outcomes are consistent."""
    speed_m_s: float
    """Speed of the striking point just before [m/s]."""
    spin_after_rad_s: list[float]
    """Spin after, in the part's axes [rad/s]."""
    spin_before_rad_s: list[float]
    """Spin before, in the part's axes [rad/s]."""
    t_s: float
    """When [s]."""


@dataclass(frozen=True, kw_only=True)
class SpaceStage:
    """A stage."""

    end: SpaceState
    """State at its end."""
    end_s: float
    """End [s]."""
    ended_by: str
    """Why it ended, in words."""
    event: StageEnd
    """The same in parts."""
    name: Literal["slide", "tip", "flight", "swing", "stick", "roll", "wedge", "push", "rest", "clatter"]
    """Its name."""
    plate: str | None = None
    """The plate or wall on which it happens; null in flight."""
    start: SpaceState
    """State at its start."""
    start_s: float
    """Start [s]."""


@dataclass(frozen=True, kw_only=True)
class SpaceState:
    """Place, attitude and motion."""

    attitude: list[float]
    """The rotation of the part's axes into the world's, as a unit quaternion: w, x, y, z."""
    position_m: list[float]
    """Mass centre, world axes [m]."""
    spin_rad_s: list[float]
    """Angular velocity, in the part's axes [rad/s]."""
    velocity_m_s: list[float]
    """Velocity of the mass centre, world axes [m/s]."""


@dataclass(frozen=True, kw_only=True)
class SolidRun(Answer):
    """The result of a run in space."""

    accumulations: list[Accumulation]
    """Series of infinitely many impacts that were closed at their limit."""
    approximations: list[Approximation] | None = None
    """How the computed part differs from the drawn one; absent where it does not."""
    end: SpaceState
    """Place, attitude and motion then."""
    end_s: float
    """When [s]."""
    exit: SpaceExit | None = None
    """How it left the last plate, when delivered."""
    faces: list[SolidFace]
    """The faces of the part, by their numbers."""
    forks: int
    """Impacts that had several consistent outcomes, of which the one that keeps the most contacts was followed."""
    impacts: list[SpaceImpact]
    """Impacts, in order of time."""
    jam: Jam | None = None
    """Between what it jammed; absent of other outcomes."""
    limit_runs: int | None = None
    """How many runs that took."""
    limits: list[Limit] | None = None
    """How far each quantity may move before the verdict flips; only where it was asked for."""
    notes: list[str] | None = None
    """What was done to the drawing that its author should know; absent where there is nothing to say."""
    outcome: Literal["landed", "delivered", "stuck", "on_end", "jammed", "missed", "escaped", "never_flat", "unresolved", "blocked"]
    """How the run ended."""
    plates: list[Plate]
    """The plates on which the part came to lie flat, in the order of landing."""
    scene: str
    """Name of the scene."""
    stages: list[SpaceStage]
    """Stages, in order of time."""
    wanted: list[Wanted]
    """What the scene wants, and whether the run has it."""
    work: Work
    """Deterministic counts of the work done."""

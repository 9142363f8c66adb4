"""Answers of `carom contact`. Written by `generate.py` from its schema."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from carom._answer import Answer


@dataclass(frozen=True, kw_only=True)
class BodyAcceleration:
    """One of several bodies under forces."""

    acceleration_m_s2: list[float]
    """Acceleration of its mass centre [m/s²]."""
    name: str
    """Its name."""
    spin_acceleration_rad_s2: float
    """How its spin changes, counter-clockwise [rad/s²]."""


@dataclass(frozen=True, kw_only=True)
class ForceContact:
    """One contact under forces."""

    name: str
    """Its name."""
    normal_acceleration_m_s2: float
    """How the normal velocity changes [m/s²]."""
    normal_force_N: float
    """Normal force on the body [N]."""
    slip_acceleration_m_s2: float
    """How the slip changes [m/s²]."""
    state: Literal["separates", "sticks", "slips"]
    """What it does."""
    tangential_force_N: float
    """Tangential force on the body [N]."""


@dataclass(frozen=True, kw_only=True)
class ForceMotion:
    """A motion that all laws allow."""

    acceleration_m_s2: list[float] | None = None
    """Acceleration of the body's mass centre [m/s²]; null where there are several bodies."""
    bodies: list[BodyAcceleration]
    """Several bodies; else empty."""
    contacts: list[ForceContact]
    """The contacts."""
    hypothesis: str
    """What each contact does: "A slips+, B sticks"."""
    indeterminate: bool
    """The forces are not determined, the motion is: these forces are one choice of many."""
    margin: float | None = None
    """Smallest slack divided by the sum of its terms' magnitudes; null where nothing touches."""
    spin_acceleration_rad_s2: float | None = None
    """How the body's spin changes, counter-clockwise [rad/s²]; null where there are several bodies."""


ImpactOutcome = Literal["unique", "several", "path_dependent", "none", "unresolved", "found", "not_found"]
"""Whether an impact has one answer."""


InequalityKind = Literal["normal_impulse", "normal_force", "normal_velocity", "normal_acceleration", "friction_cone", "slip_direction", "equations"]
"""What an inequality is about."""


@dataclass(frozen=True, kw_only=True)
class Inequality:
    """The inequality that a hypothesis breaks most, and by how much."""

    amount: float | None = None
    """By how much it is broken, > 0; null for equations, where numbers overflow, and for a stage in space, which
    knows its share.
    """
    contact: str | None = None
    """The contact; null for equations."""
    kind: InequalityKind
    """What it is about."""
    phase: Literal["compression", "restitution"] | None = None
    """compression (or the one step of Newton's law) or restitution; null for forces, and for the law under which
    nothing slides.
    """
    share: float | None = None
    """The amount divided by the magnitudes of all that it is a difference of: near 0 a close call, 1 where
    nothing speaks for the hypothesis; null where numbers overflow, and for the law under which nothing
    slides.
    """
    unit: Literal["N s", "N", "m/s", "m/s^2", ""]
    """The unit of the amount: N s, N, m/s or m/s^2; empty for equations."""


@dataclass(frozen=True, kw_only=True)
class Rejected:
    """A hypothesis that is not consistent."""

    because: str
    """The inequality that fails, in words."""
    hypothesis: str
    """What each contact was supposed to do."""
    inequality: Inequality
    """The same as data."""
    slips: list[Literal["open", "sticks", "slips+", "slips-"]]
    """The same as data, in the order of the contacts: while the impulse grows, or from now on under forces."""


Uniqueness = Literal["examined", "not_examined"]
"""Whether every end state was examined."""


@dataclass(frozen=True, kw_only=True)
class Contact(Answer):
    """What contacts under forces do."""

    count: int
    """How many motions are consistent; the first four are listed."""
    outcome: ImpactOutcome
    """unique, several or none; of more than six contacts found or not_found."""
    rejected: list[Rejected]
    """The other hypotheses; empty where uniqueness is not examined."""
    solutions: list[ForceMotion]
    """The motions that are consistent."""
    uniqueness: Uniqueness
    """Whether every hypothesis was examined."""

"""Answers of `carom contact`. Written by `generate.py` from its schema."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from carom._answer import Answer
from carom.answers.shared import (
    ImpactOutcome,
    Rejected,
    Uniqueness,
)


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

"""Answers of `carom impact`. Written by `generate.py` from its schema."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from carom._answer import Answer
from carom.answers.shared import (
    Body,
    EndContact,
    EndState,
    ImpactOutcome,
    Inequality,
    Rejected,
    Uniqueness,
)


@dataclass(frozen=True, kw_only=True)
class Deciders:
    """The numbers that decide the class at one contact."""

    because: str
    """The inequality that decided."""
    mu_s: float
    """Friction that holds the contact without slip."""
    p_d: float
    """`P_d` of Wang and Mason."""
    p_q: float
    """`P_q` of Wang and Mason."""


@dataclass(frozen=True, kw_only=True)
class End:
    """Where an impact ends."""

    bodies: list[Body]
    """Where several bodies meet: each of them; else empty."""
    contacts: list[EndContact]
    """The contacts, in the order given."""
    energy_after_J: float | None = None
    """Kinetic energy after [J]; null without a body."""
    energy_before_J: float | None = None
    """Kinetic energy before [J]; null without a body."""
    spin_rad_s: float | None = None
    """Spin of the body after [rad/s]; null without a body."""
    velocity_m_s: list[float] | None = None
    """Velocity of the body after [m/s]; null without a body."""


ForcedKind = Literal["driven_in", "fastest_first"]
"""Why a stage is walked that no consistent hypothesis says."""


@dataclass(frozen=True, kw_only=True)
class Forced:
    """The contact that is loaded in a stage that no consistent hypothesis says."""

    contact: str | None = None
    """Its name; of several that are alike, and loaded together, the first."""
    kind: ForcedKind
    """Why it is that one."""


@dataclass(frozen=True, kw_only=True)
class PlanarImpact(Answer):
    """The answer to an impact."""

    decided_by: Deciders | None = None
    """What decided the class, at one contact."""
    end_states: list[EndState]
    """Every consistent end state; the one that was found where uniqueness is not examined."""
    failure: ImpactFailure | None = None
    """The same as data."""
    law: Literal["poisson", "stronge", "newton"]
    """The law that the answer obeys: Poisson's where several contacts close, Stronge's where they share as
    springs.
    """
    not_staged: str | None = None
    """Why there is no staged walk, in words."""
    outcome: ImpactOutcome
    """Whether this is the only answer."""
    rejected: list[Rejected]
    """The other hypotheses, 4096 at most; empty where uniqueness is not examined."""
    rejected_left_out: int
    """Rejected hypotheses beyond those that are told."""
    sharing: list[Sharing]
    """What the conventions on sharing say, where several contacts act; else empty."""
    staged: Staged | None = None
    """The staged walk; null where there is none."""
    uniqueness: Uniqueness
    """Whether every end state was examined."""


ImpactAxes = Literal["file", "contact"]
"""In which axes impulses and velocities of contacts are."""


ImpactEventKind = Literal["slip_stops", "slip_starts", "closes", "opens", "loads", "driven_in", "repaid", "compression_ends", "restitution_ends"]
"""What ended a stage of an impact."""


@dataclass(frozen=True, kw_only=True)
class ImpactEvent:
    """Why a stage of an impact ended."""

    contact: str | None = None
    """At which contact; null where it is none in particular."""
    kind: ImpactEventKind
    """What happened."""


ImpactFailure = Literal["too_many", "refused", "overflow", "unending", "circling", "jammed"]
"""Why an impact has no walk."""


@dataclass(frozen=True, kw_only=True)
class OpenShare:
    """What another share of compression leaves: restitution multiplies the share that is taken."""

    contact: str
    """The contact whose share is asked for."""
    end: End
    """Where that ends."""
    takes: ShareTaken
    """Which share it takes."""


ShareTaken = Literal["least", "middle", "most"]
"""Which share of the impulses of compression a contact takes, of those that give the same motion."""


@dataclass(frozen=True, kw_only=True)
class Sharing:
    """What a convention on how closing contacts share an impact says."""

    because: str | None = None
    """Why it has no answer, in words; else null."""
    end: End | None = None
    """Where it ends; null where it has no answer."""
    failure: ImpactFailure | None = None
    """The same as data."""
    sharing: Literal["together", "in sequence", "by stiffness"]
    """The convention."""
    verdict: SharingVerdict
    """It moves as the answer does."""


SharingVerdict = Literal["agrees", "differs", "does_not_apply", "no_answer"]
"""What a convention on sharing says of the answer."""


@dataclass(frozen=True, kw_only=True)
class SpatialBody:
    """One of several bodies after an impact in space."""

    name: str
    """Its name."""
    spin_rad_s: list[float]
    """Spin after [rad/s]."""
    velocity_m_s: list[float]
    """Velocity of its mass centre after [m/s]."""


SpatialContactState = Literal["open", "slips", "sticks", "starts to slip", "separates"]
"""What a contact does: in a stage, or after the impact."""


@dataclass(frozen=True, kw_only=True)
class SpatialHypothesis:
    """A hypothesis, and the inequality that rejects it."""

    because: str
    """What rejects it, in words."""
    hypothesis: str
    """What it says of each contact."""
    inequality: Inequality
    """The same as data."""
    states: list[Literal["open", "slips", "sticks", "starts to slip"]]
    """The same as data, in the order of the contacts: while the impulse grows. Under the law under which nothing
    slides, contacts stick or are open.
    """


@dataclass(frozen=True, kw_only=True)
class SpatialImpactContact:
    """One contact of an impact in space, at the end of the impact or of a stage."""

    impulse_N_s: list[float]
    """Impulse so far on the body into which the normal points [N s], in the axes that `axes` names."""
    name: str
    """Its name."""
    normal_impulse_N_s: float
    """Normal part of it [N s]."""
    normal_velocity_m_s: float
    """Normal part of it [m/s]."""
    state: SpatialContactState
    """At the end separates, sticks or slips; in a stage open, slips, sticks or starts to slip."""
    velocity_m_s: list[float]
    """Velocity of the contact point, relative to the other body [m/s]."""


@dataclass(frozen=True, kw_only=True)
class SpatialImpactEnd:
    """Where an impact in space ends."""

    bodies: list[SpatialBody]
    """Where several bodies meet: each of them; else empty."""
    contacts: list[SpatialImpactContact]
    """The contacts."""
    energy_after_J: float | None = None
    """Kinetic energy after [J]; null without a body."""
    energy_before_J: float | None = None
    """Kinetic energy before of all that can be moved [J]; null without a body."""
    friction_demand: float | None = None
    """Largest quotient of a tangential and a normal impulse."""
    gained_energy: bool
    """Restitution created energy (possible under Newton's law)."""
    open: Literal["nothing", "the rates", "the motion"]
    """What sharing among the contacts leaves open."""
    restitution_scaled: float
    """Common factor on all restitutions that keeps energy from growing; 1 where none is needed."""
    spin_rad_s: list[float] | None = None
    """Spin of the one body [rad/s]; null where there are several, or none is known."""
    velocity_m_s: list[float] | None = None
    """Velocity of the mass centre of the one body [m/s]; null where there are several, or none is known."""


@dataclass(frozen=True, kw_only=True)
class SpatialImpact(Answer):
    """The answer to an impact in space."""

    axes: ImpactAxes
    """In which axes impulses and velocities of contacts are."""
    end: SpatialImpactEnd | None = None
    """Where it ends; null where there is no walk."""
    examined: bool
    """False where there may be other ways on than those that were found."""
    failure: ImpactFailure | None = None
    """The same as data."""
    law: Literal["poisson", "stronge", "newton"]
    """The law that was used."""
    non_sliding: list[SpatialKept]
    """Every consistent state of the law under which nothing slides, without restitution."""
    non_sliding_rejected: list[SpatialHypothesis]
    """Its other states, each with what rejects it, 4096 at most."""
    non_sliding_rejected_left_out: int
    """Rejected states beyond those that are told."""
    not_staged: str | None = None
    """Why there is no walk, in words; null where there is one."""
    outcome: Literal["unique", "several", "none", "forced"]
    """Whether there is one answer: several where the walk chose, forced where at some stage no way on is
    consistent and one contact is loaded alone.
    """
    stages: list[SpatialWalkStage]
    """The walk."""


@dataclass(frozen=True, kw_only=True)
class SpatialKept:
    """A consistent state of the law under which nothing slides."""

    friction_demand: float | None = None
    """The least friction with which no contact slides; null where none is enough."""
    hypothesis: str
    """Which contacts keep."""
    normal_impulses_N_s: list[float]
    """Normal impulses of all contacts [N s]."""
    normal_velocities_m_s: list[float]
    """Normal velocities of all contacts after [m/s]."""


@dataclass(frozen=True, kw_only=True)
class SpatialWalkStage:
    """A stage of the walk."""

    contacts: list[SpatialImpactContact]
    """What each contact does in it, and where it ends."""
    ended_by: str
    """Why it ended, in words."""
    event: ImpactEvent
    """The same as data."""
    examined: bool
    """False where there may be other ways on: directions of several slips that start were looked for."""
    forced: str | None = None
    """Why it is walked though no way on is consistent at its start: the contact that friction drives in
    (Painlevé's paradox), or the fastest one, is loaded alone; in words, null where one is.
    """
    forced_at: Forced | None = None
    """The same as data."""
    phase: Literal["compression", "restitution"]
    """The phase that it is in."""
    rejected: list[SpatialHypothesis]
    """The other hypotheses, each with what rejects it."""
    rejected_left_out: int
    """Rejected hypotheses beyond those that are told."""
    straight: bool
    """No slip turns in it."""
    ways: list[list[Literal["open", "slips", "sticks", "starts to slip"]]]
    """The same as data, each in the order of the contacts."""
    ways_on: list[str]
    """Every consistent way on at its start."""


@dataclass(frozen=True, kw_only=True)
class StageContact:
    """One contact during a stage; pairs are the stage's start and end."""

    normal_impulse_N_s: list[float]
    """Normal impulse so far [N s]."""
    normal_velocity_m_s: list[float]
    """Normal velocity [m/s]."""
    slip: Literal["open", "sticks", "slips+", "slips-"]
    """What it does: slips+ along the tangent, slips- against it."""
    slip_m_s: list[float]
    """Slip [m/s]."""
    tangential_impulse_N_s: list[float]
    """Tangential impulse so far [N s]."""


@dataclass(frozen=True, kw_only=True)
class Staged:
    """The staged walk."""

    bodies: list[Body]
    """Where several bodies meet: each of them; else empty."""
    branches: int
    """Largest number of consistent continuations met at a stage."""
    class_: Literal["sliding", "sliding from rest", "sticking", "R-reversed", "C-reversed", "R-sticking", "C-sticking"] | None = None
    """Class of Wang and Mason, where one contact acts."""
    contacts: list[EndContact]
    """The contacts, in the order given."""
    end_states_compared: bool
    """False where the walk obeys another law than the end states, Stronge's or that of springs: the two are not
    compared then.
    """
    energy_after_J: float | None = None
    """Kinetic energy after [J]; null without a body."""
    energy_before_J: float | None = None
    """Kinetic energy before [J]; null without a body."""
    gained_energy: bool
    """True where the law created energy."""
    open_shares: list[OpenShare]
    """What the ends of the shares of compression leave, where these are open and another share leaves another
    motion; else empty.
    """
    path_dependent: bool
    """True where it ends in none of the end states: the end depends on the way there."""
    restitution_scaled: float
    """Common factor on the coefficients of restitution that kept energy from growing; 1 where none was needed."""
    spin_rad_s: float | None = None
    """Spin of the body after [rad/s]; null without a body."""
    stages: list[WalkStage]
    """Its straight stages."""
    type: int | None = None
    """Type 1 to 7, where one contact acts."""
    velocity_m_s: list[float] | None = None
    """Velocity of the body after [m/s]; null without a body."""
    without_approach: bool
    """True where friction, not approach, forced the impact."""


@dataclass(frozen=True, kw_only=True)
class WalkStage:
    """One straight stage of the walk."""

    contacts: list[StageContact]
    """The contacts."""
    ended_by: str
    """Why it ended, in words."""
    event: ImpactEvent
    """The same as data."""
    phase: Literal["compression", "restitution"]
    """The phase that it is in."""

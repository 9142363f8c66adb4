"""Answers of `carom roll`. Written by `generate.py` from its schema."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from carom._answer import Answer
from carom.answers.shared import (
    Accumulation,
    EndContact,
    EndState,
    ImpactOutcome,
    Probability,
    Rejected,
    Spread,
    StudyRun,
)


@dataclass(frozen=True, kw_only=True)
class ClosedForm:
    """What a closed form says of a strike, beside the engine's numbers."""

    agrees: bool
    """True where the same contacts keep, and the numbers differ by rounding."""
    case: str
    """Which case of the literature it is."""
    impulse_difference: float | None = None
    """Largest difference of normal impulses, as a fraction of the largest; null where the form does not give
    them.
    """
    kept: list[str]
    """The contacts that it keeps."""
    spin_difference: float
    """Largest difference of spins, as a fraction of the spin before."""
    words: str
    """What the literature says of it, and whether that holds."""


PoseAt = Literal["before_strike", "after_strike", "end"]
"""What stands beside a pose at a strike or at the end."""


@dataclass(frozen=True, kw_only=True)
class PoseEnd:
    """A way in which throws end."""

    end: str
    """How."""
    face: int | None = None
    """The face that is down; null of the other ends."""
    first: PoseThrow | None = None
    """The first throw that ends so; null where none does."""
    normal: list[float] | None = None
    """Its unit normal, outwards."""
    of_resting: Probability | None = None
    """Of the throws that come to rest on a face, the share on this one, with Wilson's interval of independent
    throws; null of other ends.
    """
    probability: Probability
    """With what probability a throw ends so."""
    stable: bool | None = None
    """True where the mass centre is over the face."""
    vertices: list[str]
    """Its vertices."""


@dataclass(frozen=True, kw_only=True)
class Throws(Answer):
    """Many throws of a body."""

    body: ThrownBody
    """The body."""
    ends: list[PoseEnd]
    """Every way in which throws end; their counts add up to all of them. Faces come first: every stable one, and
    any other that came up.
    """
    height_m: ThrowRange
    """Of its lowest vertex above the plane [m]."""
    kind: Literal["body"]
    """body."""
    law: str
    """The law of its strikes, in a sentence."""
    mass_kg: float
    """Mass [kg]."""
    resting: Probability
    """With what probability a throw comes to rest on a face."""
    rise_m_s: float
    """Velocity upwards at the release [m/s]."""
    run: StudyRun
    """What it took."""
    seed: int
    """What every random number comes from."""
    speed_m_s: ThrowRange
    """Horizontal speed [m/s]."""
    spin_rate_rad_s: ThrowRange
    """Size of the spin [rad/s]."""
    strikes: Spread | None = None
    """Their strikes."""
    throws: int
    """Throws, in 16 repetitions."""
    time_s: Spread | None = None
    """When those come to rest [s]."""


@dataclass(frozen=True, kw_only=True)
class PoseThrow:
    """One throw, to be made again."""

    number: int
    """Its number in it."""
    repetition: int
    """The repetition that it is of."""
    set: list[str]
    """What `carom roll body --set` makes it again from."""


@dataclass(frozen=True, kw_only=True)
class Resting:
    """On what it rests, and what became of its energy."""

    energy_end_J: float
    """The same at the end [J]."""
    energy_start_J: float
    """Kinetic energy at the release, and potential energy above the plane [J]."""
    face: int | None = None
    """The face that is down; null where it does not rest on one."""
    held: list[str]
    """Those of them that are held."""
    margin_m: float | None = None
    """How far inside the face the mass centre's projection is [m]."""
    normal: list[float] | None = None
    """Its unit normal, outwards, in the drawing's axes; at rest it points down."""
    vertices: list[str]
    """Its vertices."""


@dataclass(frozen=True, kw_only=True)
class RollEnd:
    """How it ends."""

    state: Literal["at rest", "rolling", "sliding", "free", "overturned", "strikes reached", "no consistent outcome"]
    """In which way."""
    t_s: float
    """When that is so [s]: for "strikes reached" the last strike, for a motion that goes on the end of the time
    it was followed.
    """


@dataclass(frozen=True, kw_only=True)
class RollPose:
    """A pose in the plane."""

    angle_rad: float
    """Angle of the body from its start on the level, counter-clockwise; whole turns count [rad]."""
    at: PoseAt | None = None
    """Where it stands beside a strike, or at the end; absent at a multiple of the interval."""
    position_m: list[float]
    """The mass centre [m]."""
    spin_rad_s: float
    """Spin, counter-clockwise: a body that rolls forward has a negative one [rad/s]."""
    strike: int | None = None
    """The strike's place in `strikes`, from 0; absent where the pose is at none."""
    t_s: float
    """When [s]."""
    velocity_m_s: list[float]
    """Velocity of the mass centre [m/s]."""


@dataclass(frozen=True, kw_only=True)
class PlanarRoll(Answer):
    """A body followed through its strikes."""

    accumulations: list[Accumulation]
    """Infinitely many strikes within a finite time, closed at their limit."""
    end: RollEnd
    """How it ends."""
    friction: float | None = None
    """Friction coefficient; null for the non-sliding law."""
    inertia_kg_m2: float
    """Moment of inertia about the mass centre [kg m²]."""
    kind: Literal["cylinder", "prism", "rod"]
    """What rolls."""
    law: Literal["poisson", "stronge", "newton"]
    """The law of its strikes."""
    mass_kg: float
    """Mass [kg]."""
    poses: list[RollPose] | None = None
    """With `--poses`: where it is at every multiple of the interval, and just before and after each strike; in
    order of time. Absent without.
    """
    restitution: float
    """Coefficient of restitution."""
    strikes: list[RollStrike]
    """The strikes, in order."""


@dataclass(frozen=True, kw_only=True)
class RollStrike:
    """One strike."""

    branches: int
    """Largest number of ways on that the impact met; above 1 it chose."""
    contacts: list[EndContact]
    """The contacts, those touched before the strike first."""
    end_states: list[EndState]
    """Every end state that the laws allow."""
    energy_after_J: float
    """Kinetic energy after [J]."""
    energy_before_J: float
    """Kinetic energy before [J]."""
    number: int | None = None
    """The literature's number: 1–7 cylinder, 1–8 prism, 1–4 rod."""
    open_share: bool
    """True where another share of compression leaves another motion."""
    outcome: ImpactOutcome
    """Of the end states that the laws allow: unique, several or none."""
    path_dependent: bool
    """True where what happens is none of the end states: the end depends on the way there."""
    rejected: list[Rejected]
    """The other hypotheses, each with the inequality that rejects it."""
    restitution_scaled: float
    """Common factor on the coefficients of restitution that kept energy from growing; 1 where none was needed."""
    roll_rate_before_rad_s: float
    """Roll rate before, > 0 forward (clockwise) [rad/s]."""
    roll_rate_rad_s: float
    """Roll rate after, > 0 forward (clockwise) [rad/s]."""
    state: str
    """What happens: "1: separates at A, sticks at K", with the literature's number where it has one."""
    t_s: float
    """When [s]."""
    tilt_rad: float
    """Angle of the body from its start on the level, counter-clockwise [rad]."""
    velocity_before_m_s: list[float]
    """Velocity of the mass centre before [m/s]."""
    velocity_m_s: list[float]
    """Velocity of the mass centre after [m/s]."""
    words: str | None = None
    """What the literature says of that number."""


@dataclass(frozen=True, kw_only=True)
class SpatialContact:
    """One contact at a strike."""

    impulse_N_s: list[float]
    """Impulse on the body, world axes [N s]."""
    name: str
    """Its name: O, A, K of a pyramid; the number of a stool's support."""
    normal_impulse_N_s: float
    """Normal impulse on the body [N s]."""
    state: Literal["keeps", "slides", "opens"]
    """What it does; without friction it keeps or opens."""
    strikes: bool
    """True where it comes down in this strike; the others stood on the plane."""
    tangential_impulse_N_s: float
    """Size of the tangential impulse [N s]; where impulses along a line are open, that of the shortest ones."""
    velocity_before_m_s: list[float]
    """Velocity before, world axes [m/s]."""
    velocity_m_s: list[float]
    """Velocity after, world axes [m/s]."""


@dataclass(frozen=True, kw_only=True)
class SpatialEnd:
    """How it ends."""

    state: Literal["at rest", "balanced", "flat", "overturned", "strikes reached", "no consistent outcome", "several ways on", "flies away", "budget spent"]
    """In which way."""
    t_s: float
    """When that is so [s]."""
    words: str
    """The same in a sentence."""


@dataclass(frozen=True, kw_only=True)
class SpatialEndState:
    """A state that the non-sliding law allows."""

    contacts: list[SpatialContact]
    """Its contacts."""
    followed: bool
    """True for the one that is followed."""
    friction_demand: float | None = None
    """The least friction coefficient with which no contact slides; null where none suffices."""
    friction_is_bound: bool
    """False: the least is found over all impulses of which the law leaves the choice."""
    hypothesis: str
    """"O and K keep, A opens"."""
    indeterminate: bool
    """True where the impulses along the contacts' lines are not determined; the motion is."""
    kept: list[str]
    """The contacts whose velocity is zero after."""
    margin: float
    """The smallest of its inequalities' slacks, as a fraction of all impulses or of all velocities."""


@dataclass(frozen=True, kw_only=True)
class SpatialFork:
    """A moment of a strike with friction at which several ways on are consistent."""

    followed: str | None = None
    """What each contact does on the way that is followed; null where it is a limit of the others."""
    others: list[str]
    """The other ways, four ways in all at most."""
    phase: Literal["compression", "restitution"]
    """The phase that it is in."""
    stage: int
    """The stage of the walk that starts there, from 1."""
    ways: list[list[Literal["open", "slips", "sticks", "starts to slip"]]]
    """The same as data, the one that is followed first, each in the order of the contacts."""


@dataclass(frozen=True, kw_only=True)
class SpatialRejected:
    """A state that is refused."""

    at: str | None = None
    """The contact whose inequality fails; null where no impulses bring the kept contacts to rest."""
    because: str
    """The inequality that fails, with its number."""
    hypothesis: str
    """"O, A and K keep"."""
    kept: list[str]
    """The contacts that it keeps."""
    normal_impulse_N_s: float | None = None
    """Its normal impulse, where that is negative [N s]."""
    normal_velocity_m_s: float | None = None
    """Its normal velocity after, where that is negative [m/s]."""


@dataclass(frozen=True, kw_only=True)
class SpatialRollPose:
    """A pose in space."""

    at: PoseAt | None = None
    """Where it stands beside a strike, or at the end; absent at a multiple of the interval."""
    attitude: list[float]
    """The rotation of the body's axes into the world's, as a unit quaternion w, x, y, z."""
    position_m: list[float]
    """The mass centre, world axes [m]."""
    spin_rad_s: list[float]
    """Spin, in the body's axes [rad/s]."""
    strike: int | None = None
    """The strike's place in `strikes`, from 0; absent where the pose is at none."""
    t_s: float
    """When [s]."""
    velocity_m_s: list[float]
    """Velocity of the mass centre, world axes [m/s]."""


@dataclass(frozen=True, kw_only=True)
class SpatialRoll(Answer):
    """A body in space followed through its strikes."""

    accumulations: list[SpatialSeries]
    """Infinitely many strikes within a finite time, closed at their limit."""
    body: ThrownBody | None = None
    """The polyhedron that is thrown; null of the others."""
    end: SpatialEnd
    """How it ends."""
    energy_drift: float
    """The largest change of the energy between two events, in units of m g × size plus the kinetic energy: the
    integration's error.
    """
    friction: float | None = None
    """Friction coefficient; null under the non-sliding law."""
    friction_demand: float | None = None
    """The largest of the strikes' friction demands; null without strikes, where no friction suffices, or where
    contacts may slide.
    """
    friction_is_bound: bool
    """False: the least is found over all impulses of which the law leaves the choice."""
    inertia_axial_kg_m2: float | None = None
    """Moment of inertia about the body's axis; null of a polyhedron [kg m²]."""
    inertia_transverse_kg_m2: float | None = None
    """Moment of inertia about the mass centre, across the body's axis; null of a polyhedron [kg m²]."""
    kind: Literal["pyramid", "stool", "body"]
    """What it is."""
    mass_kg: float
    """Mass [kg]."""
    poses: list[SpatialRollPose] | None = None
    """With `--poses`: where it is at every multiple of the interval, and just before and after each strike; in
    order of time. Absent without.
    """
    resting: Resting | None = None
    """On what it rests; null of the others."""
    restitution: float
    """Restitution: 0 under the non-sliding law."""
    stages: list[SpatialStage]
    """What it does between its strikes."""
    strikes: list[SpatialStrike]
    """The strikes, in order; one that has no way on is the last."""
    tilt: Tilt
    """The course of its tilt."""


@dataclass(frozen=True, kw_only=True)
class SpatialSeries:
    """Infinitely many strikes within a finite time, closed at their limit."""

    from_s: float
    """The last strike that was resolved [s]."""
    kept: list[str]
    """The contacts that stay on the plane after it."""
    period: int
    """How many strikes make a period."""
    ratio: float
    """The ratio of the lengths of successive periods."""
    to_s: float
    """The limit [s]."""


@dataclass(frozen=True, kw_only=True)
class SpatialStage:
    """A stretch of motion between two events."""

    end_s: float
    """End [s]."""
    held: list[str]
    """The contacts that are held."""
    name: Literal["flight", "pivot", "edge", "rest", "slide", "roll"]
    """What it does: pivot about one contact, turn about an edge, which is two."""
    start_s: float
    """Start [s]."""


@dataclass(frozen=True, kw_only=True)
class SpatialStrike:
    """One strike."""

    closed_form: ClosedForm | None = None
    """What a closed form says of it, where there is one."""
    contacts: list[SpatialContact]
    """The contacts as it is followed; empty where there is no way on."""
    end_states: list[SpatialEndState]
    """Every state that the law allows."""
    energy_after_J: float | None = None
    """Kinetic energy after [J]; null where there is no way on."""
    energy_before_J: float
    """Kinetic energy before [J]."""
    forks: list[SpatialFork]
    """With friction: where the walk through the strike had several ways on."""
    friction_demand: float | None = None
    """The least friction coefficient with which no contact slides; null where none suffices, where there is no
    way on, or where contacts may slide.
    """
    friction_is_bound: bool
    """False: the least is found over all impulses of which the law leaves the choice."""
    kept: list[str]
    """The contacts that stay on the plane; without friction their velocity is zero after."""
    open: Literal["nothing", "the rates", "the motion"]
    """What sharing among the contacts leaves open: where that is the motion, one sharing was chosen, and others
    are as consistent.
    """
    outcome: Literal["unique", "several", "none", "forced"]
    """Of the states that the non-sliding law allows, or of the ways through a strike with friction: forced where
    at some stage none was consistent, and the contact that friction drives in was loaded alone.
    """
    rejected: list[SpatialRejected]
    """The other states, each with the inequality that refuses it."""
    rejected_left_out: int
    """Refused states that are not listed."""
    spin_before_rad_s: list[float]
    """Spin before, body axes [rad/s]."""
    spin_rad_s: list[float] | None = None
    """Spin after, body axes [rad/s]; null where there is no way on."""
    state: str
    """What happens: "O and K keep, A opens"; with friction, "O keeps, K slides, A opens"."""
    struck: list[str]
    """The contacts that come down."""
    t_s: float
    """When [s]."""
    tilt_rad: float
    """Angle from flat of the face that is nearest to the plane [rad]."""
    velocity_before_m_s: list[float]
    """Velocity of the mass centre before, world axes [m/s]."""
    velocity_m_s: list[float] | None = None
    """Velocity of the mass centre after, world axes [m/s]; null where there is no way on."""


@dataclass(frozen=True, kw_only=True)
class ThrowRange:
    """A quantity that may vary from throw to throw."""

    distribution: Literal["fixed", "uniform", "normal"]
    """fixed, uniform, or normal."""
    high: float | None = None
    """Highest; null where a normal distribution has no end."""
    low: float | None = None
    """Lowest; null where a normal distribution has no end."""
    middle: float
    """Its value, or the middle of its tolerance."""
    sigma: float | None = None
    """Standard deviation, of a normal distribution before its ends are cut; null of the others."""


@dataclass(frozen=True, kw_only=True)
class ThrownBody:
    """A polyhedron. Axes are those of its drawing."""

    centre_m: list[float]
    """The mass centre [m]."""
    convex: bool
    """False where the file's surface is not convex: then mass centre and inertia are those of the surface, and
    the plane is touched by its hull.
    """
    corner_radius_m: float | None = None
    """Radius of its edges and corners [m]; null where they are sharp."""
    density_kg_m3: float
    """Mass over volume [kg/m³]."""
    faces: list[ThrownFace]
    """Its faces: the number of a face is its place here."""
    file: str | None = None
    """The file that it comes from; null where there is none."""
    homogeneous: bool
    """True where mass centre and inertia follow from the shape."""
    inertia_kg_m2: list[list[float]]
    """Inertia about the mass centre, by rows [kg m²]."""
    moved_m: float
    """How far a vertex was moved at most to bring it onto its faces [m]."""
    points: int
    """Points that were given."""
    principal_axes: list[list[float]]
    """The unit axis of each, right-handed."""
    principal_moments_kg_m2: list[float]
    """Principal moments, ascending [kg m²]."""
    shape: Literal["box", "vertices", "file"]
    """box, vertices or file."""
    vertices: list[ThrownVertex]
    """Vertices of the hull, as drawn and not rounded: their names, which are the numbers of the points, and
    their places [m].
    """
    volume_m3: float
    """Volume [m³]."""


@dataclass(frozen=True, kw_only=True)
class ThrownFace:
    """A face of the hull."""

    centre_height_m: float
    """Height of the mass centre over it [m]."""
    face: int
    """Its number."""
    margin_m: float
    """How far inside the face the mass centre's projection is; negative where it is outside [m]."""
    normal: list[float]
    """Unit normal, outwards."""
    stable: bool
    """True where the body can rest on it: the projection is inside."""
    vertices: list[str]
    """Its corners, counter-clockwise as seen from outside."""


@dataclass(frozen=True, kw_only=True)
class ThrownVertex:
    """A vertex of the hull."""

    name: str
    """The number of the point."""
    place_m: list[float]
    """Its place [m]."""


@dataclass(frozen=True, kw_only=True)
class Tilt:
    """The course of the tilt, thinned for a plot."""

    t_s: list[float]
    """Times [s]."""
    tilt_rad: list[float]
    """Angle from flat of the face that is nearest to the plane [rad]."""

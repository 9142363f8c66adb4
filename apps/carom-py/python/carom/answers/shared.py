"""What answers of several commands share. Written by `generate.py` from their schemas."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal



@dataclass(frozen=True, kw_only=True)
class Accumulation:
    """Infinitely many impacts in finite time."""

    from_s: float
    """The first impact counted [s]."""
    to_s: float
    """Their limit [s]."""


AmountUnit = Literal["m", "m/s", "N", "1/kg", "J", "1"]
"""The unit of an amount, SI."""


@dataclass(frozen=True, kw_only=True)
class Approximation:
    """One way in which the computed part differs from the drawn one."""

    amount: float
    """How far it differs: of chords the greatest distance from the outline, of a hull the share of it that the
    part does not fill.
    """
    kind: ApproximationKind
    """What stands in for the outline."""
    of: Literal["part"]
    """What is approximated: `part`."""
    text: str
    """The same in a sentence."""
    unit: Literal["m", "1"]
    """Unit of the amount: `m` of chords, `1` of a hull."""


ApproximationKind = Literal["chords", "convex_hull"]
"""What stands in for a drawn outline."""


@dataclass(frozen=True, kw_only=True)
class Body:
    """One of several bodies after an impact."""

    name: str
    """Its name."""
    spin_rad_s: float
    """Spin after [rad/s]."""
    velocity_m_s: list[float]
    """Velocity of its mass centre after [m/s]."""


@dataclass(frozen=True, kw_only=True)
class EndContact:
    """One contact at the end."""

    name: str
    """Its name."""
    normal_impulse_N_s: float
    """Normal impulse on the body [N s]."""
    normal_velocity_m_s: float
    """Normal velocity after [m/s]."""
    slip_m_s: float
    """Slip after [m/s]."""
    state: Literal["separates", "sticks", "slips"]
    """What it does after."""
    tangential_impulse_N_s: float
    """Tangential impulse on the body [N s]."""


@dataclass(frozen=True, kw_only=True)
class EndState:
    """A consistent end state."""

    bodies: list[Body]
    """Where several bodies meet: each of them; else empty."""
    contacts: list[EndContact]
    """The contacts, in the order given."""
    energy_after_J: float | None = None
    """Kinetic energy after [J]; null without a body."""
    energy_before_J: float | None = None
    """Kinetic energy before [J]; null without a body."""
    gained_energy: bool
    """True where the impulses do positive work: restitution created energy."""
    hypothesis: str
    """What each contact does: "A slips+, B sticks"."""
    indeterminate: bool
    """The impulses are not determined, the motion is; but where uniqueness is not examined and there is
    restitution by Poisson's law, which multiplies the impulses that were taken, the motion may be open too.
    """
    margin: float | None = None
    """Smallest slack divided by the sum of its terms' magnitudes."""
    spin_rad_s: float | None = None
    """Spin of the body after [rad/s]; null without a body."""
    velocity_m_s: list[float] | None = None
    """Velocity of the body after [m/s]; null without a body."""


@dataclass(frozen=True, kw_only=True)
class Exit:
    """How the part left."""

    angle_rad: float
    """Angle of the part from its drawing [rad]."""
    spin_rad_s: float
    """Spin [rad/s]."""
    t_s: float
    """Time [s]."""
    vx_m_s: float
    """Velocity of the mass centre [m/s]."""
    vy_m_s: float
    """Velocity of the mass centre [m/s]."""
    x_m: float
    """Mass centre [m]."""
    y_m: float
    """Mass centre [m]."""


@dataclass(frozen=True, kw_only=True)
class Histogram:
    """How often a measure takes which values."""

    above: int
    """Samples above the last edge."""
    below: int
    """Samples below the first edge: far from the others."""
    counts: list[int]
    """Samples from each edge up to below the next; the last bin holds its upper edge too."""
    edges: list[float]
    """Edges of the bins, ascending and equally far apart, one more than there are bins; in the measure's unit."""


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
class Jam:
    """Between what a part jammed."""

    contacts: list[Touch]
    """The contacts that hold it, or that no impact resolves."""
    kind: JamReportKind
    """Which of the two it is."""


JamReportKind = Literal["wedged", "unresolved"]
"""Which of the two keeps a jammed part."""


@dataclass(frozen=True, kw_only=True)
class Limit:
    """How far one quantity may move alone before the verdict flips, SI."""

    high: float | None = None
    """Highest value with the same verdict; null where the verdict does not flip above."""
    high_end: LimitEnd
    """What ended the search upwards."""
    high_kept: float
    """The highest value that was found to keep the verdict."""
    low: float | None = None
    """Lowest value with the same verdict; null where the verdict does not flip below."""
    low_end: LimitEnd
    """What ended the search downwards."""
    low_kept: float
    """The lowest value that was found to keep the verdict."""
    quantity: str
    """Its path."""


LimitEnd = Literal["flips", "no_such_feeder", "end_of_search"]
"""What ended the search for a limit."""


@dataclass(frozen=True, kw_only=True)
class Plate:
    """A landing."""

    face: int | None = None
    """The face that is down; null for a disc."""
    first_touch_s: float
    """First touch of this plate [s]."""
    flat_s: float | None = None
    """Flat on it [s]; null for a disc."""
    impact_speed_m_s: float
    """Largest approach speed of its impacts [m/s]."""
    max_sliding_speed_m_s: float
    """Largest slip on it [m/s]."""
    plate: str
    """Name of the plate; its number, counted from 0, where it has none."""
    turned_here: bool | None = None
    """Against the plate before; null for a disc."""
    verdict: Verdict | None = None
    """Against the start; null for a disc."""


@dataclass(frozen=True, kw_only=True)
class Probability:
    """A probability with its 95 % interval."""

    count: int
    """How many samples."""
    high: float
    """Upper end of the interval."""
    low: float
    """Lower end of the interval."""
    share: float
    """Share of the samples."""


@dataclass(frozen=True, kw_only=True)
class RegionsAxis:
    """An axis of a diagram."""

    cells: int
    """Cells of the first grid."""
    from_: float
    """Where it begins."""
    key: str
    """The quantity's key."""
    to: float
    """Where it ends."""
    unit: str
    """The unit of `from`, `to` and of every coordinate; empty for plain numbers."""


@dataclass(frozen=True, kw_only=True)
class RegionsBoundary:
    """A boundary between two labels."""

    closed: bool
    """True where it closes upon itself."""
    labels: list[str]
    """The labels on its two sides."""
    points: int
    """Points of its polyline; they are in `regions.csv`."""


@dataclass(frozen=True, kw_only=True)
class RegionsJunction:
    """A point where three or more labels meet."""

    accuracy_share: float
    """Size of the window that it lies in, as a share of the axes."""
    labels: list[str]
    """The labels."""
    x: float
    """Abscissa, in the axis' unit."""
    y: float
    """Ordinate, in the axis' unit."""


@dataclass(frozen=True, kw_only=True)
class RegionsLabel:
    """A label with the room it takes."""

    area_share: float
    """Share of the plane, 0 to 1."""
    grid_nodes: int
    """Nodes of the first grid that have it."""
    label: str
    """The label, as it stands in its region."""
    words: str
    """What it is."""


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


Side = Literal["same", "turned"]
"""Which side of a part is down."""


@dataclass(frozen=True, kw_only=True)
class SpaceExit:
    """How the part left the last plate."""

    attitude: list[float]
    """The rotation of the part's axes into the world's, as a unit quaternion: w, x, y, z."""
    position_m: list[float]
    """Mass centre, world axes [m]."""
    spin_rad_s: list[float]
    """Angular velocity, in the part's axes [rad/s]."""
    t_s: float
    """When [s]."""
    velocity_m_s: list[float]
    """Velocity of the mass centre, world axes [m/s]."""


@dataclass(frozen=True, kw_only=True)
class Spread:
    """What a measure spreads over."""

    count: int
    """Samples that have it."""
    high: float
    """Highest."""
    histogram: Histogram
    """How often which values."""
    low: float
    """Lowest."""
    mean: float
    """Arithmetic mean."""
    median: float
    """Half are below."""
    p01: float
    """One in a hundred is below."""
    p05: float
    """One in twenty is below."""
    p25: float
    """A quarter is below."""
    p75: float
    """A quarter is above."""
    p95: float
    """One in twenty is above."""
    p99: float
    """One in a hundred is above."""


StageEndKind = Literal["touches", "lies_down", "centre_at_edge", "lifts_off", "slip_stops", "friction_gives_way", "runs_off", "painleve", "rests", "flies_away", "swings", "other_part", "time_up", "strikes", "strikes_to_limit"]
"""What ended a stage."""


@dataclass(frozen=True, kw_only=True)
class StageEnd:
    """Why a stage ended."""

    amount: float | None = None
    """What it came to; null where nothing was watched."""
    contact: Touch | None = None
    """Where; null where it is no single contact."""
    kind: StageEndKind
    """What happened."""
    plates: list[str]
    """The plates and walls struck by the strikes that are told together; empty for every other kind."""
    quantity: WatchedQuantity | None = None
    """What was watched; null where nothing was."""
    unit: AmountUnit | None = None
    """The unit of the amount; null where nothing was watched."""


@dataclass(frozen=True, kw_only=True)
class StudyRun:
    """What a study took: kept apart from what it found, which is the same on every machine."""

    drops: int
    """Drops that were followed."""
    seconds: float
    """Time it took [s]."""
    threads: int
    """Threads that worked on it."""


@dataclass(frozen=True, kw_only=True)
class Touch:
    """A feature of the part on a plate or wall."""

    feature: str
    """The part's feature: front, rear, front top, corner 2, face 0 or rim."""
    plate: str
    """Name of the plate or wall; its number, counted from 0, where it has none."""


Uniqueness = Literal["examined", "not_examined"]
"""Whether every end state was examined."""


@dataclass(frozen=True, kw_only=True)
class Wanted:
    """What is wanted on a plate, and whether a run has it."""

    met: bool
    """True where the part's first lying flat on the plate is as wanted; false too where it never lay flat on it."""
    plate: str
    """Name of the plate."""
    want: str
    """same, turned or face and its number."""


WatchedQuantity = Literal["gap", "angle", "normal_force", "slip", "friction_left", "extent", "response", "strikes"]
"""What was watched when a stage ended."""


@dataclass(frozen=True, kw_only=True)
class Work:
    """Counts of the work done."""

    events: int
    """Events."""
    impacts: int
    """Impacts."""
    rhs_evaluations: int
    """Evaluations of a mode's forces and accelerations."""


Verdict = Side | int
"""`same` or `turned`, or the number of the face that is down."""

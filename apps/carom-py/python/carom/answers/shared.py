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


@dataclass(frozen=True, kw_only=True)
class StudyRun:
    """What a study took: kept apart from what it found, which is the same on every machine."""

    drops: int
    """Drops that were followed."""
    seconds: float
    """Time it took [s]."""
    threads: int
    """Threads that worked on it."""


Uniqueness = Literal["examined", "not_examined"]
"""Whether every end state was examined."""

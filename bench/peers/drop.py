"""The drop that every engine is given: its geometry, when a part counts as released, when as lying flat.

World axes: x right, y up, angles counter-clockwise, SI units.
The upper plate descends to the right and its edge is the origin.
The paper's axes: x along the upper plate, y down through it; the lower plate is the line x/along + y/normal = 1 in them.
"""

import csv
import math
from dataclasses import dataclass

LENGTH = 0.1  # m
THICKNESS = 0.001  # m: what the engines that need volume are given
MASS = 0.3  # kg
INERTIA = 2.5e-4  # kg m2, of the rod and of the box alike
FRICTION = 0.15
GRAVITY = 9.81  # m/s2
TO_EDGE = 0.1  # m, from the part's centre to the edge at the start

LOOK_EVERY = 0.005  # s between two looks at a running simulation: looking takes time as well
LIMIT = 5.0  # s, after which a run has no verdict
FLAT_ANGLE = 0.05  # rad between the part and the plate
FLAT_SPIN = 1.0  # rad/s; both are wide, for engines that leave a part trembling
FLAT_LOOKS = 6  # looks in a row at which the part lies flat: 30 ms, in which a turning part leaves the angle
RELEASE_GAP = 0.0005  # m between part and edge


@dataclass(frozen=True)
class Design:
    """A feeder: the upper plate's slope, the lower plate's line, and the exact verdicts ("" where unknown)."""

    upper_slope_deg: float
    along: float
    normal: float
    rod: str
    box: str

    @property
    def slope(self):
        """The upper plate's slope [rad]."""
        return math.radians(self.upper_slope_deg)

    def to_world(self, x, y):
        """A vector in the paper's axes, in world axes."""
        c, s = math.cos(self.slope), math.sin(self.slope)
        return (x * c - y * s, -x * s - y * c)

    @property
    def lower_angle(self):
        """The angle [rad] of the direction along the lower plate that goes right and up."""
        x, y = self.to_world(self.along, -self.normal)
        return math.atan2(y, x)

    @property
    def lower_point(self):
        """A point of the lower plate, below the edge."""
        return self.to_world(0.0, self.normal)

    def start(self):
        """Centre and angle of the box that lies on the upper plate."""
        x, y = self.to_world(-TO_EDGE, -THICKNESS / 2)
        return x, y, -self.slope


def read_designs(path):
    """The designs of a list."""
    with open(path, newline="") as file:
        return [
            Design(
                float(row["upper_slope_deg"]),
                float(row["along_m"]),
                float(row["normal_m"]),
                row["verdict_rod"],
                row["verdict_box_1mm"],
            )
            for row in csv.DictReader(file)
        ]


class Watch:
    """Looks at a part every LOOK_EVERY seconds of its run."""

    def __init__(self, design):
        self.slope = design.slope
        self.plate = design.lower_angle
        self.released = False
        self.looks = 0

    def sees_release(self, x, y, angle):
        """True once: when the part has left the upper plate's edge."""
        if self.released:
            return False
        c, s = math.cos(angle), math.sin(angle)
        edge_along, edge_across = -c * x - s * y, s * x - c * y
        past = x * math.cos(self.slope) - y * math.sin(self.slope) > 0.0
        self.released = past and (
            edge_along < -LENGTH / 2 or edge_across < -(THICKNESS / 2 + RELEASE_GAP)
        )
        return self.released

    def sees_verdict(self, angle, spin):
        """"same" or "turned" once the part has lain flat long enough; else None."""
        tilt = angle - self.plate
        flat = self.released and abs(math.sin(tilt)) < FLAT_ANGLE and abs(spin) < FLAT_SPIN
        self.looks = self.looks + 1 if flat else 0
        if self.looks < FLAT_LOOKS:
            return None
        return "same" if math.cos(tilt) > 0.0 else "turned"


@dataclass(frozen=True)
class Strike:
    """An isolated impact of the 1 mm box: its state when the corner touches the lower plate."""

    design: Design
    x: float
    y: float
    angle: float
    vx: float
    vy: float
    spin: float

    def approach(self, angle, vx, vy, spin):
        """Velocity [m/s] of the box's lowest corner along the lower plate's upward normal, in a given state."""
        c, s = math.cos(self.design.lower_angle), math.sin(self.design.lower_angle)
        corners = [(i * LENGTH / 2, j * THICKNESS / 2) for i in (-1, 1) for j in (-1, 1)]
        ca, sa = math.cos(angle), math.sin(angle)
        arms = [(ca * p - sa * q, sa * p + ca * q) for p, q in corners]
        arm = min(arms, key=lambda r: -s * r[0] + c * r[1])
        return -s * (vx - spin * arm[1]) + c * (vy + spin * arm[0])

    def is_over(self, approach_now):
        """True when the corner approaches no more: 0.1 % of its speed before, which soft contacts keep for long."""
        before = self.approach(self.angle, self.vx, self.vy, self.spin)
        return approach_now > 0.001 * before


def read_strikes(path):
    """The impacts of a list."""
    with open(path, newline="") as file:
        rows = [[float(field) for field in row] for row in list(csv.reader(file))[1:]]
    return [Strike(Design(*row[:3], "", ""), *row[3:]) for row in rows]

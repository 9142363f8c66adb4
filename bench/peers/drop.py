"""The drop that every engine is given: its geometry, when a part counts as released, when as lying flat.

World axes: x right, y up, angles counter-clockwise, SI units.
The upper plate descends to the right and its edge is the origin.
The paper's axes: x along the upper plate, y down through it; the lower plate is the line x/along + y/normal = 1 in them.
"""

import csv
import math
from dataclasses import dataclass

from parts import BOX, PARTS, Part

LENGTH = 0.1  # m
THICKNESS = 0.001  # m: what the engines that need volume are given
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
    """A feeder: the upper plate's slope, the lower plate's line, and the part that lies on the upper plate at the start."""

    upper_slope_deg: float
    along: float
    normal: float
    part: Part = BOX
    face: int = 0
    to_edge: float = TO_EDGE
    friction: float = FRICTION

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
        """Centre and angle of the part that lies on the upper plate."""
        rest = self.part.rests[self.face]
        x, y = self.to_world(-self.to_edge, -rest.depth)
        return x, y, -self.slope - (math.pi / 2 + rest.normal)


def read_designs(path):
    """The designs of a list: of the box, or of parts with hollows where it names parts."""
    with open(path, newline="") as file:
        return [_design(row) for row in csv.DictReader(file)]


def _design(row):
    plates = [float(row[name]) for name in ("upper_slope_deg", "along_m", "normal_m")]
    if "part" not in row:
        return Design(*plates)
    return Design(*plates, PARTS[row["part"]], int(row["face"]), float(row["to_edge_m"]), float(row["friction"]))


class Watch:
    """Looks at the box every LOOK_EVERY seconds of its run, and says when the upper plate is to be taken away."""

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

    def steps(self, step):
        """How many steps there are between two looks."""
        return max(1, round(LOOK_EVERY / step))

    def sees_verdict(self, _time, _centre, angle, spin, _touching):
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
    return [Strike(Design(*row[:3]), *row[3:]) for row in rows]

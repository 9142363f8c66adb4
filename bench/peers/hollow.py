"""Drops of parts with hollows: which scenes there are, and what is written down of a drop as it happens.

Here the upper plate stays where it is, as a leg may hook onto its edge. Every step is looked at.
"""

import csv
import itertools
import math

from drop import FLAT_ANGLE, FLAT_SPIN, Design
from parts import PARTS

# The scenes are all combinations of these; none was left out for what came of it.
STARTS = [("L", 0), ("L", 2), ("T", 0), ("T", 2)]  # part, and the rest that it lies on: its longest face, across its hollow
UPPER_SLOPES = [14.0, 22.0]  # deg
TO_EDGE = [0.06, 0.11]  # m
LOWER_PLATES = [(25.0, 0.20), (10.0, 0.30), (0.0, 0.12)]  # deg, rising to the right; m below the edge, square to the upper plate
FRICTIONS = [0.1, 0.2]
COLUMNS = ["upper_slope_deg", "along_m", "normal_m", "to_edge_m", "friction", "face", "part", "outline_m"]

FLAT_TIME = 0.03  # s in which a part stays flat before it counts as lying
NEAR = 0.003  # m above the lower plate, from where on the engine is asked whether they touch
LYING_ANGLE = 0.02  # rad of tilt, from where on the time of coming to lie is counted on straight: soft contacts creep for long
MOVED = 5.0  # mm or per cent by which Carom's scenes are moved at most, to see what changes their face
AFTER = 0.005  # s after the first touch, when the spin is noted


def write_list(target):
    """The list of scenes; the outline in each row is what Carom is given."""
    with open(target, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(COLUMNS)
        for (part, face), upper, (lower, normal), to_edge, friction in grid():
            along = normal / math.tan(math.radians(upper + lower))
            outline = " ".join(f"{value:.6g}" for corner in PARTS[part].outline for value in corner)
            writer.writerow([upper, along, normal, to_edge, friction, face, part, outline])


def grid():
    """Every scene: part and start, upper slope, lower plate, start distance, friction."""
    return list(itertools.product(STARTS, UPPER_SLOPES, LOWER_PLATES, TO_EDGE, FRICTIONS))


class Record:
    """Looks at a part with hollows after every step, and notes when it touches the lower plate and when it lies on it."""

    def __init__(self, design: Design):
        self.part = design.part
        self.plate = design.lower_angle
        self.normal = (-math.sin(self.plate), math.cos(self.plate))
        x, y = design.lower_point
        self.level = self.normal[0] * x + self.normal[1] * y
        self.touch = self.spins = self.tilt = None
        self.flat = []

    def steps(self, _step):
        """How many steps there are between two looks."""
        return 1

    def sees_release(self, *_):
        """The upper plate stays."""
        return False

    def height(self, centre, angle):
        """Of the part's lowest point above the lower plate [m]."""
        c, s = math.cos(angle), math.sin(angle)
        (nx, ny), (x, y) = self.normal, centre
        p, q = nx * c + ny * s, ny * c - nx * s
        return nx * x + ny * y - self.level + min(p * a + q * b for a, b in self.part.hull)

    def sees_verdict(self, time, centre, angle, spin, touching):
        """What became of the drop, once the part has lain flat long enough; else None."""
        if self.touch is None:
            if self.height(centre, angle) > NEAR or not touching():
                self.before = spin
                return None
            self.touch, self.tilt, self.spins = time, angle - self.plate, [self.before, spin]
        if time <= self.touch + AFTER:
            self.spins[1] = spin
        if abs(self.off(angle)) > FLAT_ANGLE or abs(spin) > FLAT_SPIN and not self.flat:
            self.flat = []
            return None
        self.flat.append((time, angle, spin))
        if time - self.flat[0][0] < FLAT_TIME or abs(spin) > FLAT_SPIN:
            return None
        return self.result(self.face(angle), self.lay_down())

    def result(self, face=None, lies=None):
        """What is written down."""
        return {"face": face, "touch": self.touch, "lies": lies, "tilt": self.tilt, "spins": self.spins}

    def face(self, angle):
        """The rest that is nearest to being down."""
        return min(range(len(self.part.rests)), key=lambda i: abs(self.tilt_of(i, angle)))

    def tilt_of(self, i, angle):
        """By how much a rest is tilted against the lower plate [rad]."""
        return math.remainder(self.part.rests[i].normal + angle - self.plate + math.pi / 2, 2 * math.pi)

    def off(self, angle):
        """The tilt of the nearest rest [rad]."""
        return self.tilt_of(self.face(angle), angle)

    def lay_down(self):
        """When it came to lie: the last of its fall is counted on at the spin that it had then."""
        last = [entry for entry in self.flat if abs(self.off(entry[1])) > LYING_ANGLE]
        if not last:
            return self.flat[0][0]
        time, angle, spin = last[-1]
        falls = spin * self.off(angle) < 0.0
        return time - (self.off(angle) / spin if falls else 0.0)

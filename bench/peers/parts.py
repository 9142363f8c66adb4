"""The parts that the engines are given: an outline, and the convex boxes that it is made of for engines that know no hollow.

SI units; a part's frame has its origin in its mass centre. Rests are the sides of the outline's hull, counted
counter-clockwise from the one that begins at the outline's first corner: these are Carom's numbers as well.
"""

import math
from dataclasses import dataclass
from functools import cached_property


@dataclass(frozen=True)
class Rest:
    """A side of the hull: the direction [rad] out of the part, and the mass centre's distance from it."""

    normal: float
    depth: float


@dataclass(frozen=True)
class Part:
    """A part of uniform thickness, or one whose inertia about its centre is given."""

    name: str
    outline: tuple  # corners, counter-clockwise from one of the hull, in any frame
    boxes: tuple  # (x from, y from, x to, y to) in the same frame
    mass: float
    given_inertia: float | None = None

    @cached_property
    def moments(self):
        """Area, centre, and polar second moment about the centre, divided by the area."""
        area = sx = sy = polar = 0.0
        for (ax, ay), (bx, by) in _sides(self.outline):
            doubled = ax * by - ay * bx
            area += doubled / 2
            sx += doubled * (ax + bx) / 6
            sy += doubled * (ay + by) / 6
            polar += doubled * (ax * ax + ax * bx + bx * bx + ay * ay + ay * by + by * by) / 12
        x, y = sx / area, sy / area
        return area, x, y, polar / area - x * x - y * y

    @property
    def inertia(self):
        """About the mass centre [kg m2]."""
        return self.given_inertia or self.mass * self.moments[3]

    @cached_property
    def placed_boxes(self):
        """Centre and half extents of each box, about the mass centre."""
        _, x, y, _ = self.moments
        return [((a + c) / 2 - x, (b + d) / 2 - y, (c - a) / 2, (d - b) / 2) for a, b, c, d in self.boxes]

    @cached_property
    def hull(self):
        """The corners of the hull about the mass centre, counter-clockwise from the outline's first."""
        _, x, y, _ = self.moments
        corners = list(self.outline)
        found, here = [], corners[0]
        while here not in found:
            found.append(here)
            # The next corner has none to the right of the way to it, and of several in line it is the farthest.
            following = next(c for c in corners if c != here)
            for c in corners:
                turn = _cross(here, following, c)
                farther = math.dist(here, c) > math.dist(here, following)
                if turn < -1e-15 or (abs(turn) <= 1e-15 and farther):
                    following = c
            here = following
        return [(a - x, b - y) for a, b in found]

    @cached_property
    def rests(self):
        """The sides that it can lie on."""
        found = []
        for (ax, ay), (bx, by) in _sides(self.hull):
            length = math.hypot(bx - ax, by - ay)
            found.append(Rest(math.atan2(ax - bx, by - ay), (ax * by - ay * bx) / length))
        return found


def _sides(corners):
    return zip(corners, [*corners[1:], corners[0]])


def _cross(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def of_boxes(name, outline_mm, boxes_mm, mass):
    """A part from millimetres."""
    outline = tuple((x / 1000, y / 1000) for x, y in outline_mm)
    return Part(name, outline, tuple(tuple(v / 1000 for v in box) for box in boxes_mm), mass)


# The box 1 mm thick that stands for the feeder paper's rod, and has its inertia.
BOX = Part(
    "box",
    ((-0.05, -0.0005), (0.05, -0.0005), (0.05, 0.0005), (-0.05, 0.0005)),
    ((-0.05, -0.0005, 0.05, 0.0005),),
    0.3,
    2.5e-4,
)

# Legs of 47 and 34 mm, 6 mm thick.
L = of_boxes(
    "L", [(0, 0), (47, 0), (47, 6), (6, 6), (6, 34), (0, 34)], [(0, 0, 47, 6), (0, 6, 6, 34)], 0.02
)

# A bar of 40 × 6 mm on a stem of 6 × 24 mm.
T = of_boxes(
    "T",
    [(-20, 0), (20, 0), (20, 6), (3, 6), (3, 30), (-3, 30), (-3, 6), (-20, 6)],
    [(-20, 0, 20, 6), (-3, 6, 3, 30)],
    0.02,
)

PARTS = {part.name: part for part in (BOX, L, T)}

"""A drop as engines are asked it: when the part has left the upper plate, and when it lies."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

#: Seconds after which a drop has no verdict, and between two looks at it.
LIMIT = 5.0
LOOK_EVERY = 0.005
#: Lying flat: within this angle [rad] of the plate, at less than this spin [rad/s], for so many looks. Wide, for engines that leave a part trembling.
FLAT_ANGLE, FLAT_SPIN, FLAT_LOOKS = 0.05, 1.0, 6
#: The gap between part and edge [m] from which on the part has left it.
GAP = 0.0005

Point = tuple[float, float]


@dataclass(frozen=True)
class Plate:
    """A straight plate."""

    uphill: Point
    edge: Point
    friction: float
    restitution: float

    @property
    def angle(self) -> float:
        """The angle [rad] of the direction along it that goes to the right."""
        x, y = self.edge[0] - self.uphill[0], self.edge[1] - self.uphill[1]
        return math.atan2(y, x) if x >= 0 else math.atan2(-y, -x)

    @property
    def ends(self) -> tuple[Point, Point]:
        """Its ends, the free edge first."""
        return self.edge, self.uphill

    def block(self, thick: float) -> list[Point]:
        """The corners of a block that lies below it: what is thin is passed through in one step."""
        nx, ny = -math.sin(self.angle), math.cos(self.angle)
        below = [(x - thick * nx, y - thick * ny) for x, y in self.ends]
        return [*self.ends, *reversed(below)]


class Drop:
    """A part over two plates, and what is seen of it while an engine moves it."""

    def __init__(self, world: dict[str, Any]) -> None:
        part = world["part"]
        self.gravity: float = world["gravity_m_s2"]
        self.corners: list[Point] = [(x, y) for x, y in part["corners_m"]]
        self.mass, self.inertia = part["mass_kg"], part["inertia_kg_m2"]
        self.start: Point = (part["start"]["position_m"][0], part["start"]["position_m"][1])
        self.start_angle: float = part["start"]["angle_rad"]
        plates = [Plate((p["uphill_m"][0], p["uphill_m"][1]), (p["edge_m"][0], p["edge_m"][1]), p["friction"], p["restitution"]) for p in world["plates"]]
        self.upper, self.lower = plates[0], plates[-1]
        self.released, self.looks = False, 0

    @property
    def half(self) -> Point:
        """Half the sides of the part, which is a box."""
        return max(x for x, _ in self.corners), max(y for _, y in self.corners)

    def followed(self, step: float, advance: Callable[[int], object], look: Callable[[], tuple[float, float, float, float]], release: Callable[[], object]) -> str:
        """The verdict of an engine that is stepped: ``advance`` goes on so many steps, ``look`` tells the part's place, angle and spin, ``release`` takes
        the upper plate away. ``none`` where the part does not lie in time."""
        steps = max(1, round(LOOK_EVERY / step))
        for _ in range(round(LIMIT / (steps * step))):
            advance(steps)
            x, y, angle, spin = look()
            verdict = self.sees_verdict(angle, spin)
            if verdict:
                return verdict
            if self.sees_release(x, y, angle):
                release()
        return "none"

    def sees_release(self, x: float, y: float, angle: float) -> bool:
        """True once: when the part has left the upper plate's edge."""
        if self.released:
            return False
        c, s = math.cos(angle), math.sin(angle)
        to_x, to_y = self.upper.edge[0] - x, self.upper.edge[1] - y
        along, across = c * to_x + s * to_y, -s * to_x + c * to_y
        half_x, half_y = self.half
        down = (self.upper.edge[0] - self.upper.uphill[0], self.upper.edge[1] - self.upper.uphill[1])
        past = -(to_x * down[0] + to_y * down[1]) > 0.0
        self.released = past and (abs(along) > half_x or abs(across) > half_y + GAP)
        return self.released

    def sees_verdict(self, angle: float, spin: float) -> str | None:
        """``same`` or ``turned`` once the part has lain flat long enough; else None."""
        tilt = (angle - self.start_angle) - (self.lower.angle - self.upper.angle)
        flat = self.released and abs(math.sin(tilt)) < FLAT_ANGLE and abs(spin) < FLAT_SPIN
        self.looks = self.looks + 1 if flat else 0
        if self.looks < FLAT_LOOKS:
            return None
        return "same" if math.cos(tilt) > 0.0 else "turned"

"""An impact as engines are asked it: bodies in space, and contacts between two of them or with what does not move."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

Vector = tuple[float, float, float]


class Refused(Exception):
    """The engine has no such thing."""


@dataclass(frozen=True)
class Twist:
    """A velocity of a mass centre [m/s] and a spin [rad/s]."""

    velocity: Vector
    spin: Vector

    def at(self, arm: Vector) -> Vector:
        """The velocity of a point that lies ``arm`` from the mass centre."""
        return added(self.velocity, crossed(self.spin, arm))


@dataclass(frozen=True)
class Body:
    """A body that can be moved."""

    mass: float
    inertia: Vector
    """Principal moments about the axes of the file; in the plane three times the one that there is."""
    centre: Vector
    twist: Twist


@dataclass(frozen=True)
class Contact:
    """A contact: the normal points into the body ``into``, out of the body ``out_of``, or of what does not move."""

    into: int
    out_of: int | None
    point: Vector
    normal: Vector
    friction: float
    restitution: float


@dataclass(frozen=True)
class Question:
    """An impact."""

    in_plane: bool
    bodies: list[Body]
    contacts: list[Contact]

    @classmethod
    def of(cls, impact: dict[str, Any]) -> Question:
        """Of an impact file in plain SI numbers, of bodies that can be moved."""
        listed = impact["body"] if isinstance(impact["body"], list) else [impact["body"]]
        in_plane = len(listed[0]["velocity"]) == 2
        bodies = [
            Body(
                mass=body["mass"],
                inertia=_three(body["inertia"]) if isinstance(body["inertia"], list) else (body["inertia"],) * 3,
                centre=_three(body.get("centre", (0, 0, 0))),
                twist=Twist(_three(body["velocity"]), _spin(body.get("spin", 0.0))),
            )
            for body in listed
        ]
        names = [body.get("name") for body in listed]

        def contact(of: dict[str, Any]) -> Contact:
            into, out_of = (names.index(name) for name in of["between"]) if "between" in of else (0, None)
            normal = _three(of["normal"])
            size = dot(normal, normal) ** 0.5
            unit = (normal[0] / size, normal[1] / size, normal[2] / size)
            return Contact(into, out_of, _three(of["point"]), unit, of["friction"], of.get("restitution", 0.0))

        return cls(in_plane, bodies, [contact(of) for of in impact["contact"]])

    def approach(self, contact: Contact, twists: list[Twist]) -> float:
        """The normal velocity of a contact [m/s], negative where it closes."""

        def of(body: int) -> Vector:
            return twists[body].at(less(contact.point, self.bodies[body].centre))

        there = of(contact.into)
        beyond = of(contact.out_of) if contact.out_of is not None else (0.0, 0.0, 0.0)
        return dot(less(there, beyond), contact.normal)

    def written(self, twist: Twist) -> dict[str, Any]:
        """A body of an answer."""
        if self.in_plane:
            return {"velocity_m_s": list(twist.velocity[:2]), "spin_rad_s": twist.spin[2]}
        return {"velocity_m_s": list(twist.velocity), "spin_rad_s": list(twist.spin)}


class Patience:
    """Watches the contacts of an impact that an engine steps through, and says when they have done their work.

    It is done when no contact closes any more (by more than a thousandth of the fastest before) and nothing changes from one step to the
    next; where something goes on changing, as soft contacts do while they push a body out, the state at the first such moment counts.
    """

    def __init__(self, question: Question, patience: int) -> None:
        before = [question.approach(contact, [body.twist for body in question.bodies]) for contact in question.contacts]
        self.slow = 1e-3 * min(before)
        self.question, self.patience = question, patience
        self.first: list[Twist] | None = None
        self.last: list[Vector] | None = None
        self.waited = 0

    def sees(self, twists: list[Twist]) -> list[Twist] | None:
        """The state that counts, once there is one."""
        # The spin of a free body in space changes by itself, its velocity does not.
        velocities = [twist.velocity for twist in twists]
        still, self.last = self.last == velocities, velocities
        if any(self.question.approach(contact, twists) < self.slow for contact in self.question.contacts):
            # What was over has begun again: another contact closed.
            self.first, self.waited = None, 0
            return None
        if self.first is None:
            self.first = twists
        self.waited += 1
        if still:
            return twists
        return self.first if self.waited > self.patience else None


def settled(question: Question, step: Callable[[], object], twists: Callable[[], list[Twist]], most: int, patience: int) -> list[Twist]:
    """The bodies once their contacts have done their work: an engine is stepped until then, so many times at most."""
    watch = Patience(question, patience)
    for _ in range(most):
        step()
        done = watch.sees(twists())
        if done:
            return done
    return twists()


def _three(numbers: Any) -> Vector:
    x, y, *rest = (float(number) for number in numbers)
    return (x, y, rest[0] if rest else 0.0)


def _spin(spin: Any) -> Vector:
    return _three(spin) if isinstance(spin, list) else (0.0, 0.0, float(spin))


def dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def added(a: Vector, b: Vector) -> Vector:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def less(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def times(k: float, a: Vector) -> Vector:
    return (k * a[0], k * a[1], k * a[2])


def crossed(a: Vector, b: Vector) -> Vector:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])

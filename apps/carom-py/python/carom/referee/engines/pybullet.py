"""Bullet (package ``pybullet``): lengths ×10, sequential impulses with 200 iterations, no split impulse, no slop, no
threshold on velocities that rebound, in impacts no error reduction at contacts.
Impacts by steps of 0.01 ms, drops by steps of 1/240 s. It multiplies the coefficients of both bodies."""

from __future__ import annotations

import math
from importlib import import_module
from typing import Any

from carom.referee.engines.drop import Drop, Plate
from carom.referee.engines.question import Body, Contact, Question, Refused, Twist, Vector, added, dot, less, times, settled

SCALE = 10.0
STEP, DROP_STEP = 1e-5, 1 / 240
RADIUS, WIDTH = 0.005, 0.01
MOST_STEPS, PATIENCE = 500, 20


class _World:
    """A world of Bullet's own that is closed at the end."""

    def __init__(self, gravity: float, step: float, **settings: float) -> None:
        self.engine: Any = import_module("pybullet")
        self.id = self.engine.connect(self.engine.DIRECT)
        self.call("setGravity", 0, -gravity * SCALE, 0)
        self.call("setPhysicsEngineParameter", fixedTimeStep=step, numSolverIterations=200, useSplitImpulse=0, restitutionVelocityThreshold=0.0, contactSlop=0.0, numSubSteps=0, **settings)

    def call(self, name: str, *given: Any, **named: Any) -> Any:
        return getattr(self.engine, name)(*given, **named, physicsClientId=self.id)

    def __enter__(self) -> _World:
        return self

    def __exit__(self, *_: object) -> None:
        self.call("disconnect")


def impact(question: Question) -> list[Twist]:
    """The bodies after an impact."""
    contacts = question.contacts
    if len({(contact.friction, contact.restitution) for contact in contacts}) > 1:
        raise Refused("contacts of one body have their own coefficients, and a body has one of each")
    planes = {_plane(contact): contact for contact in contacts if contact.out_of is None}
    for contact in contacts:
        for plane, other in planes.items():
            centre = added(contact.point, times(RADIUS, contact.normal))
            if plane != _plane(contact) and dot(less(centre, other.point), other.normal) < 1.5 * RADIUS:
                raise Refused("a contact would meet the obstacle of another one")
    with _World(0.0, STEP, contactERP=0.0) as world:
        # Coefficients of two that touch are multiplied.
        own = {"lateralFriction": math.sqrt(contacts[0].friction), "restitution": math.sqrt(contacts[0].restitution), "rollingFriction": 0, "spinningFriction": 0}
        for contact in planes.values():
            shape = world.call("createCollisionShape", world.engine.GEOM_PLANE, planeNormal=contact.normal)
            plane_body = world.call("createMultiBody", 0, shape, -1, [SCALE * x for x in contact.point])
            world.call("changeDynamics", plane_body, -1, **own)
        made = [_body(world, question, number, own) for number in range(len(question.bodies))]

        def twists() -> list[Twist]:
            moving = [world.call("getBaseVelocity", body) for body in made]
            return [Twist((v[0] / SCALE, v[1] / SCALE, v[2] / SCALE), (w[0], w[1], w[2])) for v, w in moving]

        return settled(question, lambda: world.call("stepSimulation"), twists, MOST_STEPS, PATIENCE)


def _plane(contact: Contact) -> tuple[float, ...]:
    """What tells the plane of a contact from others."""
    return (*(round(x, 9) for x in contact.normal), round(dot(contact.normal, contact.point), 9))


def _body(world: _World, question: Question, number: int, own: dict[str, float]) -> int:
    """A body with a sphere at each of its contacts."""
    body: Body = question.bodies[number]
    sides = [(contact, 1.0) for contact in question.contacts if contact.into == number]
    sides += [(contact, -1.0) for contact in question.contacts if contact.out_of == number]
    at = [times(SCALE, less(added(contact.point, times(side * RADIUS, contact.normal)), body.centre)) for contact, side in sides]
    if len(at) == 1:
        shape = world.call("createCollisionShape", world.engine.GEOM_SPHERE, radius=SCALE * RADIUS, collisionFramePosition=at[0])
    else:
        many = {"shapeTypes": [world.engine.GEOM_SPHERE] * len(at), "radii": [SCALE * RADIUS] * len(at), "collisionFramePositions": at}
        shape = world.call("createCollisionShapeArray", **many)
    # They touch from the beginning: before a gap is closed, Bullet rebounds and lets the gap be closed in one step, which is too little of both.
    made: int = world.call("createMultiBody", body.mass, shape, -1, times(SCALE, body.centre))
    inertia = [moment * SCALE**2 for moment in body.inertia]
    world.call("changeDynamics", made, -1, localInertiaDiagonal=inertia, linearDamping=0, angularDamping=0, **own)
    world.call("resetBaseVelocity", made, [SCALE * v for v in body.twist.velocity], body.twist.spin)
    return made


def drop(given: dict[str, Any]) -> str:
    """The verdict of a drop."""
    drop = Drop(given)
    with _World(drop.gravity, DROP_STEP) as world:

        def block(half: tuple[float, float], centre: tuple[float, float], angle: float, mass: float, friction: float) -> int:
            shape = world.call("createCollisionShape", world.engine.GEOM_BOX, halfExtents=[SCALE * half[0], SCALE * half[1], SCALE * WIDTH])
            turned = [0.0, 0.0, math.sin(angle / 2), math.cos(angle / 2)]
            made: int = world.call("createMultiBody", mass, shape, -1, [SCALE * centre[0], SCALE * centre[1], 0.0], turned)
            world.call("changeDynamics", made, -1, lateralFriction=math.sqrt(friction), restitution=math.sqrt(drop.lower.restitution))
            return made

        def plate(of: Plate, thick: float = 0.05) -> int:
            (x, y), (u, v) = of.ends
            c, s = math.cos(of.angle), math.sin(of.angle)
            middle = ((x + u) / 2 + thick * s, (y + v) / 2 - thick * c)
            return block((math.hypot(u - x, v - y) / 2, thick), middle, of.angle, 0.0, of.friction)

        upper = plate(drop.upper)
        plate(drop.lower)
        part = block(drop.half, drop.start, drop.start_angle, drop.mass, drop.lower.friction)
        inertia = [drop.inertia * SCALE**2] * 3
        world.call("changeDynamics", part, -1, localInertiaDiagonal=inertia, linearDamping=0, angularDamping=0)

        def advance(steps: int) -> None:
            for _ in range(steps):
                world.call("stepSimulation")

        def look() -> tuple[float, float, float, float]:
            (x, y, _), (_, _, qz, qw) = world.call("getBasePositionAndOrientation", part)
            return x / SCALE, y / SCALE, 2 * math.atan2(qz, qw), world.call("getBaseVelocity", part)[1][2]

        return drop.followed(DROP_STEP, advance, look, lambda: world.call("removeBody", upper))

"""pymunk (Chipmunk in 64-bit floats): metres; no slop in impacts, 1e-6 m in drops. Impacts by steps of 0.01 ms, drops by steps of 1 ms; 200 iterations in
impacts, 50 in drops. Bodies begin nine tenths of a step before they touch, so that all contacts close in the same step."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from carom.referee.engines.drop import Drop
from carom.referee.engines.question import Question, Refused, Twist, settled

STEP, DROP_STEP = 1e-5, 1e-3
ITERATIONS, DROP_ITERATIONS = 200, 50
#: How far before its contacts close a body begins, in steps.
BEFORE = 0.9
#: How thick [m] plates are below their upper side.
THICK = 0.05
RADIUS, REACH = 0.005, 0.5
MOST_STEPS, PATIENCE = 2000, 20
#: Contacts that its masks can keep apart.
MOST_CONTACTS = 31


def _space(pm: Any, gravity: float, slop: float, iterations: int) -> Any:
    space = pm.Space()
    space.gravity, space.iterations, space.collision_slop = (0, -gravity), iterations, slop
    return space


def impact(question: Question) -> list[Twist]:
    """The bodies after an impact."""
    if not question.in_plane:
        raise Refused("it knows the plane only")
    if len(question.contacts) > MOST_CONTACTS:
        raise Refused(f"more than {MOST_CONTACTS} contacts cannot be kept apart")
    pm: Any = import_module("pymunk")
    space = _space(pm, 0.0, 0.0, ITERATIONS)
    bodies = []
    for body in question.bodies:
        made = pm.Body(body.mass, body.inertia[2])
        made.position = tuple(at - BEFORE * v * STEP for at, v in zip(body.centre[:2], body.twist.velocity[:2], strict=True))
        made.angle = -BEFORE * body.twist.spin[2] * STEP
        made.velocity, made.angular_velocity = body.twist.velocity[:2], body.twist.spin[2]
        space.add(made)
        bodies.append(made)
    for number, contact in enumerate(question.contacts):
        n, p = contact.normal, contact.point
        own = pm.ShapeFilter(categories=1 << number, mask=1 << number)

        def added(shape: Any, friction: float, restitution: float, own: Any = own) -> None:
            # It multiplies the coefficients of both.
            shape.friction, shape.elasticity, shape.filter = friction, restitution, own
            space.add(shape)

        def circle(body: int, side: float, n: Any = n, p: Any = p) -> Any:
            centre = question.bodies[body].centre
            return pm.Circle(bodies[body], RADIUS, tuple(p[i] + side * RADIUS * n[i] - centre[i] for i in (0, 1)))

        added(circle(contact.into, 1.0), contact.friction, contact.restitution)
        if contact.out_of is not None:
            added(circle(contact.out_of, -1.0), 1.0, 1.0)
        else:
            ends = [(p[0] + r * n[1], p[1] - r * n[0]) for r in (-REACH, REACH)]
            added(pm.Segment(space.static_body, *ends, 0.0), 1.0, 1.0)

    def twists() -> list[Twist]:
        return [Twist((made.velocity[0], made.velocity[1], 0.0), (0.0, 0.0, made.angular_velocity)) for made in bodies]

    return settled(question, lambda: space.step(STEP), twists, MOST_STEPS, PATIENCE)


def drop(given: dict[str, Any]) -> str:
    """The verdict of a drop."""
    pm: Any = import_module("pymunk")
    drop = Drop(given)
    space = _space(pm, drop.gravity, 1e-6, DROP_ITERATIONS)

    def block(plate: Any) -> Any:
        shape = pm.Poly(space.static_body, plate.block(THICK))
        shape.friction, shape.elasticity = plate.friction, plate.restitution
        space.add(shape)
        return shape

    upper = block(drop.upper)
    block(drop.lower)
    part = pm.Body(drop.mass, drop.inertia)
    part.position, part.angle = drop.start, drop.start_angle
    shape = pm.Poly(part, drop.corners)
    shape.friction, shape.elasticity = 1.0, 1.0
    space.add(part, shape)

    def advance(steps: int) -> None:
        for _ in range(steps):
            space.step(DROP_STEP)

    return drop.followed(DROP_STEP, advance, lambda: (*part.position, part.angle, part.angular_velocity), lambda: space.remove(upper))

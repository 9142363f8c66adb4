"""Box2D 2.3 (package ``Box2D``): lengths ×100, so that its own tolerances (5 mm of slop, a threshold of 1 m/s below which nothing rebounds) become
0.05 mm and 1 cm/s. Impacts by steps of 0.01 ms, drops by steps of 2 ms. 200 iterations for velocities in
impacts, 8 in drops as its manual says: with 8, contacts that close together are not solved to the end. It counts in 32-bit floats."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from carom.referee.engines.drop import Drop
from carom.referee.engines.question import Body, Question, Refused, Twist, settled

SCALE = 100.0
STEP, DROP_STEP = 1e-5, 2e-3
#: For velocities and positions.
ITERATIONS, DROP_ITERATIONS = (200, 3), (8, 3)
#: The radius [m] of the circles at contacts, and half the length of what does not move.
RADIUS, REACH = 0.005, 0.5
MOST_STEPS, PATIENCE = 2000, 20
#: Contacts that its masks can keep apart.
MOST_CONTACTS = 15


def _body(b2: Any, world: Any, body: Body) -> Any:
    x, y = (SCALE * (at - v * STEP) for at, v in zip(body.centre[:2], body.twist.velocity[:2], strict=True))
    made = world.CreateDynamicBody(position=(x, y), angle=-body.twist.spin[2] * STEP)
    return made


def impact(question: Question) -> list[Twist]:
    """The bodies after an impact."""
    if not question.in_plane:
        raise Refused("it knows the plane only")
    if len(question.contacts) > MOST_CONTACTS:
        raise Refused(f"more than {MOST_CONTACTS} contacts cannot be kept apart")
    b2: Any = import_module("Box2D")
    world = b2.b2World(gravity=(0, 0), doSleep=False)
    bodies = [_body(b2, world, body) for body in question.bodies]
    for number, contact in enumerate(question.contacts):
        n, p = contact.normal, contact.point
        own: dict[str, Any] = {
            "friction": contact.friction,
            "restitution": contact.restitution,
            "filter": b2.b2Filter(categoryBits=1 << number, maskBits=1 << number, groupIndex=0),
        }

        def circle(body: int, side: float, own: dict[str, Any] = own, n: Any = n, p: Any = p) -> None:
            centre = question.bodies[body].centre
            at = tuple(SCALE * (p[i] + side * RADIUS * n[i] - centre[i]) for i in (0, 1))
            bodies[body].CreateFixture(shape=b2.b2CircleShape(pos=at, radius=SCALE * RADIUS), density=1.0, **own)

        circle(contact.into, 1.0)
        if contact.out_of is not None:
            circle(contact.out_of, -1.0)
        else:
            ends = [(SCALE * (p[0] + r * n[1]), SCALE * (p[1] - r * n[0])) for r in (-REACH, REACH)]
            world.CreateStaticBody().CreateFixture(shape=b2.b2EdgeShape(vertices=ends), **own)
    for made, body in zip(bodies, question.bodies, strict=True):
        made.massData = b2.b2MassData(mass=body.mass, center=(0, 0), I=body.inertia[2] * SCALE**2)
        made.linearVelocity = tuple(SCALE * v for v in body.twist.velocity[:2])
        made.angularVelocity = body.twist.spin[2]

    def twists() -> list[Twist]:
        moving = [(made.linearVelocity, made.angularVelocity) for made in bodies]
        return [Twist((v[0] / SCALE, v[1] / SCALE, 0.0), (0.0, 0.0, w)) for v, w in moving]

    return settled(question, lambda: world.Step(STEP, *ITERATIONS), twists, MOST_STEPS, PATIENCE)


def drop(given: dict[str, Any]) -> str:
    """The verdict of a drop."""
    b2: Any = import_module("Box2D")
    drop = Drop(given)
    world = b2.b2World(gravity=(0, -drop.gravity * SCALE), doSleep=False)
    ground = world.CreateStaticBody()

    def edge(plate: Any) -> Any:
        ends = [(SCALE * x, SCALE * y) for x, y in plate.ends]
        return ground.CreateFixture(shape=b2.b2EdgeShape(vertices=ends), friction=plate.friction, restitution=plate.restitution)

    upper = edge(drop.upper)
    edge(drop.lower)
    part = world.CreateDynamicBody(position=tuple(SCALE * x for x in drop.start), angle=drop.start_angle)
    half = tuple(SCALE * side for side in drop.half)
    part.CreateFixture(shape=b2.b2PolygonShape(box=half), density=1.0, friction=drop.lower.friction, restitution=drop.lower.restitution)
    part.massData = b2.b2MassData(mass=drop.mass, center=(0, 0), I=drop.inertia * SCALE**2)

    def advance(steps: int) -> None:
        for _ in range(steps):
            world.Step(DROP_STEP, *DROP_ITERATIONS)

    def look() -> tuple[float, float, float, float]:
        x, y = part.position
        return x / SCALE, y / SCALE, part.angle, part.angularVelocity

    return drop.followed(DROP_STEP, advance, look, lambda: ground.DestroyFixture(upper))

"""The drop in Box2D 2.3 (package `Box2D`), called from Python: one box 1 mm thick over two edge shapes.

| setting | lengths | step | iterations for velocity and position |
|---|---|---|---|
| `default` | in metres | 1/60 s | 8 and 3, the manual's |
| `fast` | ×100, so that the engine's own tolerances (5 mm of slop, 10 mm of skin) become 0.05 mm and 0.1 mm | 2 ms | 8 and 3 |
| `fine` | ×1000 | 0.5 ms | 8 and 3 |

Everything else is the vendor's default; bodies never sleep. The engine counts in 32-bit floats.
"""

import math
from importlib.metadata import version

import Box2D as b2

from drop import FRICTION, GRAVITY, INERTIA, LENGTH, LIMIT, LOOK_EVERY, MASS, THICKNESS, Watch

VERSION = version("Box2D")
SETTINGS = {
    "default": {"scale": 1.0, "step": 1 / 60},
    "fast": {"scale": 100.0, "step": 0.002},
    "fine": {"scale": 1000.0, "step": 0.0005},
}
ITERATIONS = (8, 3)
IMPACT_STEP = 1e-5  # s
REACH = 3.0  # m: half the lower plate's length
UPPER_LENGTH = 0.5  # m


def _world(design, scale, gravity):
    world = b2.b2World(gravity=(0.0, -gravity * scale), doSleep=False)
    ground = world.CreateStaticBody()
    x, y = design.lower_point
    c, s = math.cos(design.lower_angle), math.sin(design.lower_angle)
    _edge(ground, scale, *((x + r * c, y + r * s) for r in (-REACH, REACH)))
    return world, ground


def _edge(ground, scale, start, end):
    vertices = [(scale * x, scale * y) for x, y in (start, end)]
    return ground.CreateFixture(shape=b2.b2EdgeShape(vertices=vertices), friction=FRICTION)


def _part(world, scale, x, y, angle):
    body = world.CreateDynamicBody(position=(scale * x, scale * y), angle=angle)
    shape = b2.b2PolygonShape(box=(scale * LENGTH / 2, scale * THICKNESS / 2))
    body.CreateFixture(shape=shape, density=1.0, friction=FRICTION)
    body.massData = b2.b2MassData(mass=MASS, center=(0, 0), I=INERTIA * scale**2)
    return body


def run(design, setting):
    """The verdict of one drop; "none" where it has none in time."""
    scale, step = setting["scale"], setting["step"]
    world, ground = _world(design, scale, GRAVITY)
    upper = _edge(ground, scale, design.to_world(-UPPER_LENGTH, 0.0), (0.0, 0.0))
    part = _part(world, scale, *design.start())
    watch = Watch(design)
    advance, (velocity, position) = world.Step, ITERATIONS
    steps = max(1, round(LOOK_EVERY / step))
    for _ in range(round(LIMIT / (steps * step))):
        for _ in range(steps):
            advance(step, velocity, position)
        (x, y), angle = part.position, part.angle
        verdict = watch.sees_verdict(angle, part.angularVelocity)
        if verdict:
            return verdict
        if watch.sees_release(x / scale, y / scale, angle):
            ground.DestroyFixture(upper)
    return "none"


def strike(state, setting):
    """The spin after an isolated impact, without gravity, at the setting's lengths and a fine step."""
    scale, step = setting["scale"], IMPACT_STEP
    world, _ = _world(state.design, scale, 0.0)
    part = _part(world, scale, state.x - state.vx * step, state.y - state.vy * step, state.angle - state.spin * step)
    part.linearVelocity = (scale * state.vx, scale * state.vy)
    part.angularVelocity = state.spin
    for _ in range(1000):
        world.Step(step, *ITERATIONS)
        (vx, vy), spin = part.linearVelocity, part.angularVelocity
        if state.is_over(state.approach(part.angle, vx / scale, vy / scale, spin)):
            break
    return part.angularVelocity

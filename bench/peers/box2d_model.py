"""The drop in Box2D 2.3 (package `Box2D`), called from Python: one body of one or two boxes over two edge shapes.

| setting | lengths | step | iterations for velocity and position |
|---|---|---|---|
| `default` | in metres | 1/60 s | 8 and 3, the manual's |
| `fast` | ×100, so that the engine's own tolerances (5 mm of slop, 10 mm of skin) become 0.05 mm and 0.1 mm | 2 ms | 8 and 3 |
| `fine` | ×1000 | 0.5 ms | 8 and 3 |
| `1/N` (parts with hollows) | ×100 | 1/N s | 8 and 3 |
| `1/N, ×1000` | ×1000; a body moves at most two units a step | 1/N s | 8 and 3 |

Everything else is the vendor's default; bodies never sleep. The engine counts in 32-bit floats.
"""

import math
from importlib.metadata import version

import Box2D as b2

from drop import GRAVITY, LIMIT, Watch

VERSION = version("Box2D")
SETTINGS = {
    "default": {"scale": 1.0, "step": 1 / 60},
    "fast": {"scale": 100.0, "step": 0.002},
    "fine": {"scale": 1000.0, "step": 0.0005},
    **{f"1/{n}": {"scale": 100.0, "step": 1 / n} for n in (1000, 5000, 20000)},
    **{f"1/{n}, ×1000": {"scale": 1000.0, "step": 1 / n} for n in (5000, 20000, 50000)},
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
    lower = _edge(ground, scale, design.friction, *((x + r * c, y + r * s) for r in (-REACH, REACH)))
    return world, ground, lower


def _edge(ground, scale, friction, start, end):
    vertices = [(scale * x, scale * y) for x, y in (start, end)]
    return ground.CreateFixture(shape=b2.b2EdgeShape(vertices=vertices), friction=friction)


def _part(world, scale, design, x, y, angle):
    body = world.CreateDynamicBody(position=(scale * x, scale * y), angle=angle)
    for px, py, half_x, half_y in design.part.placed_boxes:
        shape = b2.b2PolygonShape(box=(scale * half_x, scale * half_y, (scale * px, scale * py), 0.0))
        body.CreateFixture(shape=shape, density=1.0, friction=design.friction)
    body.massData = b2.b2MassData(mass=design.part.mass, center=(0, 0), I=design.part.inertia * scale**2)
    return body


def run(design, setting, watch=None):
    """The verdict of one drop; "none" where it has none in time. A watch of another kind has verdicts of its own."""
    scale, step = setting["scale"], setting["step"]
    world, ground, lower = _world(design, scale, GRAVITY)
    upper = _edge(ground, scale, design.friction, design.to_world(-UPPER_LENGTH, 0.0), (0.0, 0.0))
    part = _part(world, scale, design, *design.start())
    watch = watch or Watch(design)

    def touching():
        edges = [edge.contact for edge in part.contacts]
        return any(c.touching and lower in (c.fixtureA, c.fixtureB) for c in edges)

    advance, (velocity, position) = world.Step, ITERATIONS
    steps = watch.steps(step)
    for n in range(round(LIMIT / (steps * step))):
        for _ in range(steps):
            advance(step, velocity, position)
        (x, y), angle = part.position, part.angle
        centre = (x / scale, y / scale)
        verdict = watch.sees_verdict((n + 1) * steps * step, centre, angle, part.angularVelocity, touching)
        if verdict:
            return verdict
        if watch.sees_release(*centre, angle):
            ground.DestroyFixture(upper)
    return "none"


def strike(state, setting):
    """The spin after an isolated impact, without gravity, at the setting's lengths and a fine step."""
    scale, step = setting["scale"], IMPACT_STEP
    world, *_ = _world(state.design, scale, 0.0)
    before = (state.x - state.vx * step, state.y - state.vy * step, state.angle - state.spin * step)
    part = _part(world, scale, state.design, *before)
    part.linearVelocity = (scale * state.vx, scale * state.vy)
    part.angularVelocity = state.spin
    for _ in range(1000):
        world.Step(step, *ITERATIONS)
        (vx, vy), spin = part.linearVelocity, part.angularVelocity
        if state.is_over(state.approach(part.angle, vx / scale, vy / scale, spin)):
            break
    return part.angularVelocity

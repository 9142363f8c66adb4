"""MuJoCo: stiff contacts with an elliptic cone, impratio 10. It has no coefficient of restitution: contacts are given the damping ratio with which a
linear spring that cannot pull returns that share of a velocity (Schwager and Pöschel, Granular Matter 9 (2007) 465). The formula for a spring that
may pull, ``ζ = -ln e / √(π² + ln² e)``, which is often given, returns too much. Impacts by steps of 0.002 ms, drops by steps of 0.05 ms.

| | time constant | impedance |
|---|---|---|
| impact, e = 0 | 40 steps, damping ratio 100 | 0.9999 |
| impact, e > 0 | 40 steps, damping ratio by e | 0.9999 |
| drop | 16 steps, damping ratio 3 | 0.95 to 0.99 |
"""

from __future__ import annotations

import math
from importlib import import_module
from typing import Any

from carom.referee.engines.drop import Drop
from carom.referee.engines.question import Contact, Question, Refused, Twist, settled

STEP, DROP_STEP = 2e-6, 5e-5
RADIUS, REACH, WIDTH = 0.005, 0.5, 0.01
MOST_STEPS, PATIENCE = 4000, 1000
#: Contacts that its masks can keep apart.
MOST_CONTACTS = 31
SOFT = 'solref="{} 3" solimp="0.95 0.99 0.001"'


def returned(damping: float) -> float:
    """The share of its velocity with which a body leaves a linear spring of this damping ratio that cannot pull.

    >>> returned(0.0), round(returned(1.0), 6) == round(math.exp(-2), 6)
    (1.0, True)
    """
    if damping >= 1.0:
        root = math.sqrt(damping**2 - 1)
        # Near one the quotient of the logarithm and the root goes to two.
        return math.exp(-2 * damping) if root < 1e-4 else ((damping + root) / (damping - root)) ** (-damping / root)
    root = math.sqrt(1 - damping**2)
    return math.exp(-damping / root * math.atan2(2 * damping * root, 2 * damping**2 - 1)) if damping > 0 else 1.0


def damping_for(restitution: float) -> float:
    """The damping ratio that returns this share of a velocity."""
    low, high = 0.0, 1e3
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if returned(middle) > restitution else (low, middle)
    return (low + high) / 2


def _contact(contact: Contact) -> str:
    """How hard a contact is."""
    if contact.restitution <= 0.0:
        return f'solref="{40 * STEP} 100" solimp="0.9999 0.9999 0.001"'
    damping = damping_for(contact.restitution)
    # Time constant and damping ratio of a linear spring; it works at full impedance, and is not hardened where it is pressed in.
    frequency = 1.0 / (40 * STEP)
    return f'solref="{-(frequency**2)} {-2 * damping * frequency}" solimp="0.9999 0.9999 0.001"'


def _numbers(*numbers: float) -> str:
    return " ".join(repr(float(number)) for number in numbers)


def impact(question: Question) -> list[Twist]:
    """The bodies after an impact."""
    if len(question.contacts) > MOST_CONTACTS:
        raise Refused(f"more than {MOST_CONTACTS} contacts cannot be kept apart")
    mj: Any = import_module("mujoco")
    geoms: list[list[str]] = [[] for _ in question.bodies]
    ground = []
    for number, contact in enumerate(question.contacts):
        own = f'friction="{contact.friction!r} 0 0" contype="{1 << number}" conaffinity="{1 << number}" {_contact(contact)}'

        def sphere(body: int, side: float, own: str = own, contact: Contact = contact) -> None:
            centre = question.bodies[body].centre
            at = [contact.point[i] + side * RADIUS * contact.normal[i] - centre[i] for i in range(3)]
            geoms[body].append(f'<geom type="sphere" size="{RADIUS}" pos="{_numbers(*at)}" {own}/>')

        sphere(contact.into, 1.0)
        if contact.out_of is not None:
            sphere(contact.out_of, -1.0)
        else:
            ground.append(f'<geom type="plane" size="{REACH} {REACH} 1" pos="{_numbers(*contact.point)}" zaxis="{_numbers(*contact.normal)}" {own}/>')
    bodies = "".join(
        f'<body pos="{_numbers(*body.centre)}"><freejoint/><inertial pos="0 0 0" mass="{body.mass!r}" diaginertia="{_numbers(*body.inertia)}"/>{"".join(own)}</body>'
        for body, own in zip(question.bodies, geoms, strict=True)
    )
    model = mj.MjModel.from_xml_string(f"""<mujoco><option timestep="{STEP}" gravity="0 0 0" cone="elliptic" impratio="10"/>
<compiler boundmass="0" boundinertia="0" balanceinertia="false"/><worldbody>{"".join(ground)}{bodies}</worldbody></mujoco>""")
    data = mj.MjData(model)
    for number, body in enumerate(question.bodies):
        data.qpos[7 * number : 7 * number + 3] = [at - v * STEP for at, v in zip(body.centre, body.twist.velocity, strict=True)]
        # The attitude is none before the first step, so that spins in the axes of the body are those of the file.
        data.qvel[6 * number : 6 * number + 6] = [*body.twist.velocity, *body.twist.spin]

    def twists() -> list[Twist]:
        found = []
        for number in range(len(question.bodies)):
            turned = data.xmat[1 + number].reshape(3, 3) @ data.qvel[6 * number + 3 : 6 * number + 6]
            velocity = data.qvel[6 * number : 6 * number + 3]
            found.append(Twist((float(velocity[0]), float(velocity[1]), float(velocity[2])), (float(turned[0]), float(turned[1]), float(turned[2]))))
        return found

    return settled(question, lambda: mj.mj_step(model, data), twists, MOST_STEPS, PATIENCE)


def drop(given: dict[str, Any]) -> str:
    """The verdict of a drop."""
    mj: Any = import_module("mujoco")
    drop = Drop(given)
    if drop.lower.restitution > 0.0:
        raise Refused("drops with restitution have no setting here")
    own = f'friction="{drop.lower.friction!r} 0 0" {SOFT.format(16 * DROP_STEP)}'
    half_x, half_y = drop.half

    def plate(name: str, of: Any, thick: float) -> str:
        # Its upper side lies on the line of the plate; the world's y is MuJoCo's z.
        (x, y), (u, v) = of.ends
        length = math.hypot(u - x, v - y)
        c, s = (u - x) / length, (v - y) / length
        nx, ny = (-s, c) if c > 0 else (s, -c)
        middle = ((x + u) / 2 - thick * nx, (y + v) / 2 - thick * ny)
        angle = of.angle
        return (
            f'<geom name="{name}" type="box" size="{length / 2!r} {0.25} {thick}" pos="{middle[0]!r} 0 {middle[1]!r}" '
            f'quat="{math.cos(angle / 2)!r} 0 {-math.sin(angle / 2)!r} 0"/>'
        )

    model = mj.MjModel.from_xml_string(f"""<mujoco><option timestep="{DROP_STEP}" gravity="0 0 {-drop.gravity}" cone="elliptic" impratio="10"/>
<default><geom {own}/></default><worldbody>{plate("upper", drop.upper, 0.05)}{plate("lower", drop.lower, 0.05)}
<body name="part"><joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 0 1"/><joint type="hinge" axis="0 -1 0"/>
<inertial pos="0 0 0" mass="{drop.mass!r}" diaginertia="{_numbers(*[drop.inertia] * 3)}"/><geom type="box" size="{half_x!r} {WIDTH} {half_y!r}"/></body>
</worldbody></mujoco>""")
    data = mj.MjData(model)
    data.qpos[:] = [*drop.start, drop.start_angle]
    upper = model.geom("upper").id

    def release() -> None:
        model.geom_contype[upper] = model.geom_conaffinity[upper] = 0

    def look() -> tuple[float, float, float, float]:
        x, y, angle = (float(q) for q in data.qpos)
        return x, y, angle, float(data.qvel[2])

    return drop.followed(DROP_STEP, lambda steps: mj.mj_step(model, data, steps), look, release)

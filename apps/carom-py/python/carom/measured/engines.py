"""Measured tosses through other engines, each through its own interface, as its users would ask it."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from importlib.util import find_spec
from typing import Any

import numpy as np

from carom.measured.profile import Array
from carom.measured.tosses import MeasuredTosses

#: Steps of an engine for one pose of the film.
STEPS = 4


def mujoco(tosses: MeasuredTosses, friction: float) -> tuple[list[Array], list[Array]]:
    """MuJoCo: a box on a plane with the default softness of its contacts; it has no coefficient of restitution."""
    engine: Any = import_module("mujoco")
    half = " ".join(str(0.5 * side) for side in tosses.body["box"])
    inertia = " ".join(map(str, tosses.body["inertia"]))
    model: Any = engine.MjModel.from_xml_string(f"""
        <mujoco>
          <option timestep="{tosses.interval / STEPS}" gravity="0 0 -9.81" cone="elliptic"/>
          <worldbody>
            <geom type="plane" size="0 0 1" friction="{friction} 0 0"/>
            <body>
              <freejoint/>
              <inertial pos="0 0 0" mass="{tosses.body["mass"]}" diaginertia="{inertia}"/>
              <geom type="box" size="{half}" friction="{friction} 0 0" condim="3"/>
            </body>
          </worldbody>
        </mujoco>""")
    data: Any = engine.MjData(model)

    def step() -> tuple[Array, Array]:
        for _ in range(STEPS):
            engine.mj_step(model, data)
        return data.qpos[:3].copy(), data.qpos[3:7].copy()

    def begin(state: Array) -> None:
        engine.mj_resetData(model, data)
        # A free joint's spin is in the body's axes, as ours is.
        data.qpos[:], data.qvel[:] = state[:7], state[7:]

    return _followed(tosses, begin, step)


def pybullet(tosses: MeasuredTosses, friction: float) -> tuple[list[Array], list[Array]]:
    """Bullet: a box on a plane, with its restitution as published."""
    engine: Any = import_module("pybullet")
    world = engine.connect(engine.DIRECT)
    try:
        engine.setGravity(0, 0, -9.81, physicsClientId=world)
        engine.setTimeStep(tosses.interval / STEPS, physicsClientId=world)
        plane = engine.createMultiBody(0, engine.createCollisionShape(engine.GEOM_PLANE, physicsClientId=world), physicsClientId=world)
        shape = engine.createCollisionShape(engine.GEOM_BOX, halfExtents=[0.5 * side for side in tosses.body["box"]], physicsClientId=world)
        box = engine.createMultiBody(tosses.body["mass"], shape, physicsClientId=world)
        # Bullet multiplies the coefficients of both bodies.
        engine.changeDynamics(plane, -1, lateralFriction=1.0, restitution=1.0, physicsClientId=world)
        engine.changeDynamics(
            box, -1, lateralFriction=friction, restitution=0.125, localInertiaDiagonal=tosses.body["inertia"], linearDamping=0, angularDamping=0, physicsClientId=world
        )

        def begin(state: Array) -> None:
            w, x, y, z = state[3:7]
            matrix = np.array(engine.getMatrixFromQuaternion([x, y, z, w])).reshape(3, 3)
            engine.resetBasePositionAndOrientation(box, state[:3], [x, y, z, w], physicsClientId=world)
            engine.resetBaseVelocity(box, state[7:10], matrix @ state[10:], physicsClientId=world)

        def step() -> tuple[Array, Array]:
            for _ in range(STEPS):
                engine.stepSimulation(physicsClientId=world)
            position, (x, y, z, w) = engine.getBasePositionAndOrientation(box, physicsClientId=world)
            return np.array(position), np.array([w, x, y, z])

        return _followed(tosses, begin, step)
    finally:
        engine.disconnect(world)


def _followed(tosses: MeasuredTosses, begin: Callable[[Array], None], step: Callable[[], tuple[Array, Array]]) -> tuple[list[Array], list[Array]]:
    positions, attitudes = [], []
    for states in tosses.states:
        begin(states[0])
        poses = [(states[0, :3], states[0, 3:7]), *(step() for _ in range(len(states) - 1))]
        positions.append(np.array([position for position, _ in poses]))
        attitudes.append(np.array([attitude for _, attitude in poses]))
    return positions, attitudes


#: The engines that can be asked, by the names of their modules.
ENGINES: dict[str, Callable[[MeasuredTosses, float], tuple[list[Array], list[Array]]]] = {"mujoco": mujoco, "pybullet": pybullet}


def installed() -> list[str]:
    """Those that are here."""
    return [name for name in ENGINES if find_spec(name) is not None]

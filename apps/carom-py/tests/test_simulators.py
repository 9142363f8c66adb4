"""Scenes in MuJoCo's own form: they load, weigh what they weigh, and end as Carom says."""

import math
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

import carom


@pytest.mark.parametrize("name", ["case_1_box", "case_2_box", "bracket"])
def test_a_scene_ends_in_mujoco_as_in_carom(name: str) -> None:
    mujoco: Any = import_module("mujoco")
    scene = carom.Scene.read(f"examples/{name}.toml")
    model = mujoco.MjModel.from_xml_string(scene.simulators()["scene.mjcf.xml"])
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    part = model.body("part").id
    run = carom.run(scene)
    assert isinstance(run, carom.Run)
    start, end = run.stages[0].start, run.stages[-1].end
    assert data.qpos.tolist() == [0, 0, 0]
    mujoco.mj_forward(model, data)
    assert data.xpos[part].tolist() == pytest.approx([start.x_m, 0, start.y_m])
    depth = max((-contact.dist for contact in data.contact), default=0.0)
    assert 0 <= depth < 1e-6, "it lies on the plate and not in it"
    for _ in range(round(1.3 * run.end_s / model.opt.timestep)):
        mujoco.mj_step(model, data)
    turned = start.angle_rad + data.qpos[2] - end.angle_rad
    assert abs(math.remainder(turned, 2 * math.pi)) < 0.05, "the same face is down"


def test_what_differs_from_the_scene_is_said() -> None:
    rod = carom.Scene.read("examples/case_2.toml").simulators()
    assert "no thickness" in rod["scene.mjcf.xml"].splitlines()[0]
    assert "made of triangles" in carom.Scene.read("examples/bracket.toml").simulators()["part.urdf"]
    bouncing = carom.Scene.read("examples/bouncing.toml").simulators()
    assert "Restitution (up to" in bouncing["plates.urdf"].splitlines()[0]


def test_meshes_of_urdf_are_among_the_files(tmp_path: Path) -> None:
    files = carom.Scene.read("examples/bracket.toml").simulators()
    for name in files:
        if name.endswith(".obj"):
            assert f'filename="{name}"' in files["part.urdf"]
    assert files["part.urdf"].count("<collision>") == sum(name.endswith(".obj") for name in files)

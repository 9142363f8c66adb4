"""The drop in MuJoCo (package `mujoco`), called from Python: one body of one or two boxes that moves and turns in one plane.

| setting | step | contact's time constant, damping ratio | impedance (solimp) | friction cone | impratio |
|---|---|---|---|---|---|
| `default` | 2 ms | 20 ms, 1 | 0.9 to 0.95 | pyramidal | 1 |
| `tuned` | 0.05 ms | 16 steps, 3 | 0.95 to 0.99 | elliptic | 10 |
| `fine` | 0.01 ms | 40 steps, 3 | 0.95 to 0.99 | elliptic | 10 |
| `1/N` (parts with hollows) | 1/N s | 40 steps, 3 | 0.95 to 0.99 | elliptic | 10 |

Everything else is the vendor's default. Time constants below about 8 steps throw the part back up.
A part that slides chatters a little at every setting that was tried, the less the more steps the time constant has; which way a
design close to the boundary goes then depends on it, so that neighbours of `tuned` score 91 to 98 on A and 74 to 94 on B.
"""

import math

import mujoco

from drop import GRAVITY, LIMIT, Watch
from parts import BOX

VERSION = mujoco.__version__
STIFF = {"option": 'cone="elliptic" impratio="10"', "contact": 'solimp="0.95 0.99 0.001"'}
HOLLOW_RATES = (1000, 5000, 20000, 100000)  # steps in a second
SETTINGS = {
    "default": {"step": 0.002, "option": "", "contact": ""},
    "tuned": {"step": 5e-5, "time_constant": 16, "damping_ratio": 3, **STIFF},  # the constant in steps
    "fine": {"step": 1e-5, "time_constant": 40, "damping_ratio": 3, **STIFF},
    **{f"1/{n}": {"step": 1 / n, "time_constant": 40, "damping_ratio": 3, **STIFF} for n in HOLLOW_RATES},
}
IMPACT_STEP = 1e-5  # s
REACH = 0.25  # m: half the extent of the upper plate
SHEET = 0.001  # m: half its thickness where it stays, and parts may hook onto its edge
WIDTH = 0.01  # m: half the box's width, out of the plane

_MODELS = {}


def _model(setting, step, design):
    """The compiled model: compiling takes longer than a drop, so designs share it and move its plates.

    The midphase, which a part of several boxes goes through, would look for them where they were compiled.
    """
    part, below = design.part, _half_thickness(design)
    key = (*setting.items(), step, part.name, design.friction)
    if key not in _MODELS:
        contact = setting["contact"]
        if "time_constant" in setting:
            contact += f' solref="{setting["time_constant"] * step} {setting["damping_ratio"]}"'
        # A plate that stood at the origin would be compiled to stay there.
        elsewhere = 'pos="1 2 3" euler="10 20 30"'
        boxes = "".join(
            f'<geom type="box" pos="{x} 0 {y}" size="{half_x} {WIDTH} {half_y}"/>'
            for x, y, half_x, half_y in part.placed_boxes
        )
        midphase = '<flag midphase="disable"/>' if len(part.boxes) > 1 else ""
        inertia = " ".join([str(part.inertia)] * 3)
        _MODELS[key] = mujoco.MjModel.from_xml_string(f"""
<mujoco>
  <option timestep="{step}" gravity="0 0 {-GRAVITY}" {setting["option"]}>{midphase}</option>
  <default><geom friction="{design.friction} 0 0" {contact}/></default>
  <worldbody>
    <geom name="lower" type="plane" size="0 0 1" {elsewhere}/>
    <geom name="upper" type="box" size="{REACH} {REACH} {below}" {elsewhere}/>
    <body name="part">
      <joint type="slide" axis="1 0 0"/>
      <joint type="slide" axis="0 0 1"/>
      <joint type="hinge" axis="0 -1 0"/>
      <inertial pos="0 0 0" mass="{part.mass}" diaginertia="{inertia}"/>
      {boxes}
    </body>
  </worldbody>
</mujoco>""")
    return _MODELS[key]


def _half_thickness(design):
    """Of the upper plate [m]: a block where it is taken away in time."""
    return REACH if design.part is BOX else SHEET


def _place(model, name, x, y, angle):
    """Moves a plate: the world's y is MuJoCo's z, and MuJoCo's y points into the page."""
    geom = model.geom(name)
    geom.pos = (x, 0.0, y)
    geom.quat = (math.cos(angle / 2), 0.0, -math.sin(angle / 2), 0.0)


def _allow_upper(model, allowed):
    upper = model.geom("upper").id
    model.geom_contype[upper] = model.geom_conaffinity[upper] = int(allowed)


def run(design, setting, watch=None):
    """The verdict of one drop; "none" where it has none in time. A watch of another kind has verdicts of its own."""
    step = setting["step"]
    model = _model(setting, step, design)
    model.opt.gravity[2] = -GRAVITY
    _place(model, "lower", *design.lower_point, design.lower_angle)
    _place(model, "upper", *design.to_world(-REACH, _half_thickness(design)), -design.slope)
    _allow_upper(model, True)
    data = mujoco.MjData(model)
    data.qpos[:] = design.start()
    watch = watch or Watch(design)
    lower = model.geom("lower").id

    def touching():
        return any(c.dist <= 0.0 and lower in (c.geom1, c.geom2) for c in data.contact)

    steps = watch.steps(step)
    for n in range(round(LIMIT / (steps * step))):
        mujoco.mj_step(model, data, steps)
        x, y, angle = data.qpos
        verdict = watch.sees_verdict((n + 1) * steps * step, (x, y), angle, data.qvel[2], touching)
        if verdict:
            return verdict
        if watch.sees_release(x, y, angle):
            _allow_upper(model, False)
    return "none"


def strike(state, setting):
    """The spin after an isolated impact, without gravity, at a fine step."""
    step = IMPACT_STEP
    model = _model(setting, step, state.design)
    model.opt.gravity[2] = 0.0
    _place(model, "lower", *state.design.lower_point, state.design.lower_angle)
    _allow_upper(model, False)
    data = mujoco.MjData(model)
    data.qpos[:] = (state.x - state.vx * step, state.y - state.vy * step, state.angle - state.spin * step)
    data.qvel[:] = (state.vx, state.vy, state.spin)
    for _ in range(10000):
        mujoco.mj_step(model, data)
        if state.is_over(state.approach(data.qpos[2], *data.qvel)):
            break
    return float(data.qvel[2])

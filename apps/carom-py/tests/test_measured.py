"""Tosses by the thousand, and what was measured: readers, errors, fits."""

from __future__ import annotations

import io
import json
import runpy
import subprocess
import tarfile
from pathlib import Path
from typing import Any

import carom
import carom.data
import numpy as np
import pytest
import scipy.io
from carom.measured import MeasuredImpacts, MeasuredTosses, fit_impacts, fit_tosses

EXCERPT = Path(__file__).parent / "data/cube-tosses"
CUBE: dict[str, Any] = {"box": [0.1, 0.1, 0.1], "mass": 0.4, "inertia": [0.0008] * 3}


def test_tosses_are_rolls_of_the_command(command: Path, tmp_path: Path) -> None:
    file = tmp_path / "brick.toml"
    file.write_text('box = ["60 mm", "40 mm", "25 mm"]\nfriction = 0.2\nrestitution = 0.3\nvelocity = [0.4, 0, 0.2]\nspin = [3, -2, 5]\n')
    words = ["roll", "body", str(file), "--poses", "10 ms", "--format", "json", "--out", str(tmp_path)]
    said = json.loads(subprocess.run([command, *words], capture_output=True, check=True).stdout)
    poses = [pose for pose in said["poses"] if "at" not in pose]
    first = poses[0]
    found = carom.tosses(
        file, position=first["position_m"], attitude=first["attitude"], velocity=first["velocity_m_s"], spin=first["spin_rad_s"],
        friction=0.2, restitution=0.3, interval=0.01, count=len(poses) + 5,
    )
    assert len(poses) > 20
    assert found.position[0, : len(poses)] == pytest.approx(np.array([pose["position_m"] for pose in poses]), abs=1e-12)
    assert found.attitude[0, : len(poses)] == pytest.approx(np.array([pose["attitude"] for pose in poses]), abs=1e-11)
    # It rests: later it is where it was.
    assert np.all(found.position[0, len(poses) + 1 :] == found.position[0, -1])


def test_tosses_say_what_is_wrong() -> None:
    good: dict[str, Any] = {"position": (0, 0, 1), "velocity": (0, 0, 0), "friction": 0.2, "interval": 0.01, "count": 3}
    with pytest.raises(carom.CaromError) as error:
        carom.tosses(CUBE, **good | {"position": [(0, 0, 1)] * 2, "velocity": [(0, 0, 0)] * 3, "spin": (1, 2), "interval": 0})
    assert sorted(problem.path for problem in error.value.problems) == ["interval", "rows", "spin"]
    with pytest.raises(carom.CaromError, match="interval: expected a finite number"):
        carom.tosses(CUBE, **good | {"interval": "0.1 s"})
    with pytest.raises(carom.CaromError) as error:
        carom.tosses(CUBE, **good | {"position": [(0, 0, 1), (0, np.nan, 1)], "friction": [0.1, -1], "restitution": 2})
    assert [(problem.path, problem.message.split(":")[0]) for problem in error.value.problems] == [
        ("position_y", "row 1"), ("friction", "row 1"), ("restitution", "row 0"),
    ]
    with pytest.raises(carom.CaromError, match="no rotation"):
        carom.tosses(CUBE, **good | {"attitude": (0, 0, 0, 0)})
    with pytest.raises(carom.CaromError, match="unknown"):
        carom.tosses({"bax": 1}, **good)


def test_a_file_of_tosses_is_read_without_calling_anything(tmp_path: Path) -> None:
    tosses = carom.data.cube_tosses(EXCERPT)
    assert len(tosses) == 3 and [len(one) for one in tosses.states] == [111, 99, 104]
    for states in tosses.states:
        # What is given as a velocity is that of the poses; attitudes are rotations.
        moved = (states[2, :3] - states[0, :3]) / (2 * tosses.interval)
        assert moved == pytest.approx(states[1, 7:10], abs=0.05)
        assert np.linalg.norm(states[:, 3:7], axis=1) == pytest.approx(1.0, abs=1e-6)
        assert 0.04 < states[-1, 2] < 0.06, "it lies on a face"
    evil = tmp_path / "data/tosses_processed/0.pt"
    evil.parent.mkdir(parents=True)
    evil.write_bytes(b"cos\nsystem\n(S'true'\ntR.")
    with pytest.raises(carom.CaromError, match="names os.system"):
        carom.data.cube_tosses(tmp_path)
    evil.write_bytes(b"")
    with pytest.raises(carom.CaromError, match="no tensor"):
        carom.data.cube_tosses(tmp_path)
    with pytest.raises(carom.CaromError, match="no tosses"):
        carom.data.cube_tosses(tmp_path / "none")


def test_the_engine_is_near_what_was_measured() -> None:
    tosses = carom.data.cube_tosses(EXCERPT)
    errors = tosses.errors(0.18, 0.125)
    assert np.all(errors.position < 0.2) and np.all(errors.rotation < 40)
    # Before the first touch it is free flight: the same but for the film's own errors.
    falls = MeasuredTosses(tosses.body, tosses.size, tosses.interval, [one[:5] for one in tosses.states])
    assert np.all(falls.errors(0.18, 0.125).position < 0.01)


def test_data_are_brought_once_and_checked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    content = io.BytesIO()
    with tarfile.open(fileobj=content, mode="w:gz") as files:
        files.add(EXCERPT, arcname="state")
    archive = tmp_path / "archive.tar.gz"
    archive.write_bytes(content.getvalue())
    with pytest.raises(carom.CaromError, match="not what was published"):
        carom.data.fetch("cube-tosses", tmp_path / "bad", archive=archive)
    known = carom.data.SETS["cube-tosses"]
    whole = carom.data.DataSet(known.about, known.source, known.licence, known.archive, known.prefix, carom.data.digest(EXCERPT, "data/"))
    monkeypatch.setitem(carom.data.SETS, "cube-tosses", whole)
    place = carom.data.fetch("cube-tosses", tmp_path / "good", archive=archive)
    assert len(carom.data.cube_tosses(place)) == 3 and not (place / "LICENSE").exists(), "what is not data is left"
    # It is there: no archive is needed.
    assert carom.data.fetch("cube-tosses", tmp_path / "good", archive=tmp_path / "none") == place
    with pytest.raises(carom.CaromError, match="cannot be brought"):
        carom.data.fetch("cube-tosses", tmp_path / "other", archive=tmp_path / "none")
    archive.write_bytes(content.getvalue()[:-400])
    with pytest.raises(carom.CaromError, match="cannot be brought"):
        carom.data.fetch("cube-tosses", tmp_path / "cut", archive=archive)
    with pytest.raises(carom.CaromError, match="is none of"):
        carom.data.fetch("dice", tmp_path)  # type: ignore[arg-type]


def struck(rows: int, seed: int, noise: float, friction: Any = 0.2, restitution: Any = 0.55) -> MeasuredImpacts:
    """Impacts of an ellipse, as the engine resolves them, with errors of the measurement."""
    random = np.random.default_rng(seed)
    mass, inertia = 0.0364, 0.0364 * 0.0192**2
    arm = np.column_stack([random.uniform(-0.02, 0.02, rows), random.uniform(-0.035, -0.025, rows)])
    velocity, spin = np.column_stack([random.uniform(-1, 1, rows), random.uniform(-3, -2, rows)]), random.uniform(-20, 20, rows)
    normal = np.tile([0.0, 1.0], (rows, 1))
    seen = MeasuredImpacts(mass, inertia, arm, velocity, spin, velocity, spin, normal)
    if callable(friction):
        friction, restitution = friction(seen), restitution(seen)
    after = carom.impacts(mass=mass, inertia=inertia, arm=arm, velocity=velocity, spin=spin, friction=friction, restitution=restitution)
    masses = np.sqrt([mass, mass, inertia])
    before = np.linalg.norm(np.column_stack([velocity, spin]) * masses, axis=1)
    errors = random.normal(0, noise, (rows, 3)) * before[:, None] / masses
    measured = np.column_stack([after["velocity_x_m_s"], after["velocity_y_m_s"], after["spin_rad_s"]]) + errors
    return MeasuredImpacts(mass, inertia, arm, velocity, spin, measured[:, :2], measured[:, 2], normal)


def test_intervals_hold_the_truth_as_often_as_they_say() -> None:
    held = 0
    for seed in range(20):
        fit = fit_impacts(struck(150, seed, 0.03))
        held += sum(one.low <= truth <= one.high for one, truth in zip(fit.parameters, (0.2, 0.55), strict=True))
    # Of 40 intervals of 95 % fewer than 32 hold by chance twice in 10⁴.
    assert 32 <= held <= 40
    print(f"measured: {held} of 40 intervals of 95 % hold the friction or the restitution that made the impacts")


def test_what_depends_on_incidence_is_found() -> None:
    def friction(seen: MeasuredImpacts) -> Any:
        return 0.2 - 0.05 * seen.feature("lever")

    def restitution(seen: MeasuredImpacts) -> Any:
        return 0.6 - 0.3 * seen.feature("incidence")

    seen = struck(600, 1, 0.01, friction, restitution)
    plain, by = fit_impacts(seen), fit_impacts(seen, friction_by=["lever"], restitution_by=["incidence"])
    found = {one.name: one for one in by.parameters}
    assert found["friction by lever"].low < -0.05 < found["friction by lever"].high
    assert found["restitution by incidence"].low < -0.3 < found["restitution by incidence"].high
    other = struck(300, 2, 0.01, friction, restitution)
    assert by.error_of(other) < 0.7 * plain.error_of(other)
    assert seen.unexplained() < by.error, "any impulse explains more than a law"


def test_the_reader_of_the_ellipse_and_the_example(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    seen = struck(200, 3, 0.01)
    # As the published file has them: Jacobians of the contact, the tangent's lever with the sign turned round.
    rows = len(seen)
    data = {
        "states_i": np.column_stack([np.zeros((rows, 3)), seen.velocity, seen.spin]),
        "states_f": np.column_stack([np.zeros((rows, 3)), seen.velocity_after, seen.spin_after]),
        "n": np.column_stack([seen.normal, seen.arm[:, 0]]),
        "d": np.column_stack([np.ones(rows), np.zeros(rows), seen.arm[:, 1]]),
    }
    (tmp_path / "processed_data").mkdir()
    scipy.io.savemat(tmp_path / "processed_data/data_ellipse.mat", {"data": data})
    read = carom.data.planar_ellipse(tmp_path)
    assert (read.mass, read.inertia) == (seen.mass, seen.inertia) and np.array_equal(read.arm, seen.arm)
    assert np.array_equal(read.differences(0.2, 0.5), seen.differences(0.2, 0.5))
    runpy.run_path("apps/carom-py/examples/measured.py")["fitted"](read)
    assert "restitution by incidence" in capsys.readouterr().out
    with pytest.raises(carom.CaromError, match="data_ellipse.mat"):
        carom.data.planar_ellipse(tmp_path / "none")


def test_what_is_wrong_with_a_fit_is_told() -> None:
    seen = struck(3, 1, 0.0)
    with pytest.raises(carom.CaromError, match="'colour': a feature is one of incidence"):
        fit_impacts(seen, friction_by=["colour"])  # type: ignore[list-item]
    with pytest.raises(carom.CaromError, match="named twice"):
        fit_impacts(seen, friction_by=["slip", "slip"])
    with pytest.raises(carom.CaromError, match="must be above 0"):
        MeasuredImpacts(-1.0, 1.0, seen.arm, seen.velocity, seen.spin, seen.velocity, seen.spin, seen.normal)
    with pytest.raises(carom.CaromError, match="too few"):
        fit_impacts(seen[:1])
    with pytest.raises(carom.CaromError, match="not between 0 and 1"):
        fit_impacts(seen, level=95)
    with pytest.raises(carom.CaromError, match="arm has the shape"):
        MeasuredImpacts(1.0, 1.0, np.zeros(2), np.zeros((1, 2)), np.zeros(1), np.zeros((1, 2)), np.zeros(1), np.zeros((1, 2)))
    with pytest.raises(carom.CaromError, match="13 numbers"):
        MeasuredTosses(CUBE, 0.1, 0.01, [np.zeros((3, 12))])
    with pytest.raises(carom.CaromError, match="ranges of friction"):
        fit_tosses(carom.data.cube_tosses(EXCERPT), friction=(0.5, 0.1))


@pytest.mark.parametrize("truth", [(0.02, 0.98), (0.05, 0.95), (0.0, 0.0), (0.4, 1.0)])
def test_the_ends_of_what_may_be_are_found(truth: tuple[float, float]) -> None:
    fit = fit_impacts(struck(60, 5, 0.0, *truth))
    assert [one.best for one in fit.parameters] == pytest.approx(list(truth), abs=2e-3) and fit.error < 1e-3
    friction, restitution = fit.parameters
    assert friction.low >= 0 and 0 <= restitution.low <= restitution.high <= 1


def test_where_nothing_strikes_nothing_is_told() -> None:
    seen = struck(40, 5, 0.0)
    parting = MeasuredImpacts(seen.mass, seen.inertia, seen.arm, -seen.velocity, -0 * seen.spin, -seen.velocity, -0 * seen.spin, seen.normal)
    fit = fit_impacts(parting)
    assert [(one.low, one.high) for one in fit.parameters] == [(0.0, np.inf), (0.0, 1.0)]


def test_a_toss_is_followed_as_long_as_it_is_looked_at() -> None:
    sliding = carom.tosses(CUBE | {"time": "1 s"}, position=(0, 0, 0.05005), velocity=(5, 0, 0), friction=0, interval=10, count=6)
    assert sliding.position[0, :, 0] == pytest.approx([0, 50, 100, 150, 200, 250])
    still = carom.tosses(CUBE, position=(0, 0, 1), velocity=(0, 0, 0), friction=0.2, interval=1e-7, count=2)
    assert still.position[0, 1, 2] == pytest.approx(1.0, abs=1e-12)
    with pytest.raises(carom.CaromError, match="too many for one call"):
        carom.tosses(CUBE, position=np.tile([0, 0, 1.0], (100_000, 1)), velocity=(0, 0, 0), friction=0.2, interval=0.1, count=1_000_000)


def test_tosses_that_are_lost_are_told() -> None:
    tosses = carom.data.cube_tosses(EXCERPT)
    sunk = [states.copy() for states in tosses.states]
    sunk[1][:, 2] -= 0.2
    bad = MeasuredTosses(tosses.body, tosses.size, tosses.interval, sunk)
    assert "(1 of 3 could not be followed)" in str(bad.errors(0.18, 0.125))
    with pytest.raises(carom.CaromError, match=r"tosses \[1\] cannot be followed"):
        fit_tosses(bad)
    with pytest.raises(carom.CaromError, match="a pose is expected"):
        tosses.errors_of([states[:1, :3] for states in tosses.states], [states[:1, 3:7] for states in tosses.states])
    with pytest.raises(carom.CaromError, match="no unit quaternions"):
        MeasuredTosses(tosses.body, tosses.size, tosses.interval, [states * 0.9 for states in tosses.states])


def test_friction_and_restitution_of_tosses_are_found() -> None:
    random = np.random.default_rng(4)
    start = np.array([
        [0, 0, 0.12, *random.normal(size=4), *random.uniform(-1, 1, 2), -1, *random.uniform(-4, 4, 3)] for _ in range(4)
    ])
    start[:, 3:7] /= np.linalg.norm(start[:, 3:7], axis=1)[:, None]
    interval, count = 1 / 148, 30
    seen = carom.tosses(
        CUBE, position=start[:, :3], attitude=start[:, 3:7], velocity=start[:, 7:10], spin=start[:, 10:], friction=0.25, restitution=0.3, interval=interval, count=count
    )
    rest = np.zeros((4, count, 6))
    rest[:, 0] = start[:, 7:]
    tosses = MeasuredTosses(CUBE, 0.1, interval, list(np.concatenate([seen.position, seen.attitude, rest], axis=2)))
    fit = fit_tosses(tosses, friction=(0.05, 0.45), restitution=(0.0, 0.6))
    assert fit.friction == pytest.approx(0.25, abs=0.01) and fit.restitution == pytest.approx(0.3, abs=0.01)
    assert all(one.low <= truth <= one.high for one, truth in zip(fit.parameters, (0.25, 0.3), strict=True))
    assert fit.errors.position.mean() < 0.01

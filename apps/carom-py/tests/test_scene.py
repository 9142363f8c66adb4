"""Scenes: read, changed, refused."""

from __future__ import annotations

import pickle
from pathlib import Path

import carom
import numpy as np
import pytest

CASE = "examples/case_2.toml"


def test_a_scene_is_what_it_is_read_from() -> None:
    text = Path(CASE).read_text()
    for given in (CASE, Path(CASE), text, carom.Scene.read(CASE)):
        assert carom.run(given).end_s == carom.run(CASE).end_s


def test_values_are_written_into_the_text() -> None:
    scene = carom.Scene.read(CASE)
    other = scene.set({"plate.0.slope": 0.2, "contact.friction": "0.1 ± 0.01"})
    assert other["plate.upper.slope"].value == 0.2 and other["plate.0.slope"].value == 0.2
    assert '"0.1 ± 0.01"' in other.text and scene.text == Path(CASE).read_text()
    assert scene["contact.friction"].value == 0.15
    with pytest.raises(KeyError, match="contact.friction"):
        scene["contact.fricton"]


def test_every_problem_is_told_with_its_place() -> None:
    with pytest.raises(carom.CaromError) as caught:
        carom.Scene('[part]\nshape = "rod"\nlength = "100 mn"\nmass = -1\n', name="bad.toml")
    problems = {problem.path: problem for problem in caught.value.problems}
    assert problems["part.length"].value == '"100 mn"' and problems["part.length"].key == "length"
    assert problems["part.mass"].allowed
    assert "bad.toml:3:10" in str(caught.value)


def test_what_is_no_scene() -> None:
    for given in ("nowhere.toml", {}, "", {"part": None}, {"part": object()}, "]", "a = 1"):
        with pytest.raises(carom.CaromError):
            carom.run(given)


def test_files_beside_a_scene() -> None:
    text = Path("examples/bracket.toml").read_text()
    files = {"bracket.dxf": Path("examples/bracket.dxf").read_bytes()}
    assert carom.run(carom.Scene(text, files=files)).end_s == carom.run("examples/bracket.toml").end_s


def test_in_a_notebook() -> None:
    page = carom.run(CASE)._repr_html_()
    assert page is not None and "sandbox" in page and "<svg" not in page
    assert carom.Scene.read(CASE)._repr_svg_().startswith("<svg")


def test_files_are_saved(tmp_path: Path) -> None:
    saved = carom.run(CASE).save(tmp_path / "out")
    assert [path.name for path in saved] == ["run.json", "report.html", "trace.csv"] and all(path.is_file() for path in saved)


def test_values_are_written_together_and_checked_once() -> None:
    values: dict[str, float | str] = {"part.length": "50 mm", "part.inertia": "6e-5 kg m^2"}
    backwards = dict(reversed(values.items()))
    assert carom.run(CASE, set=values).end_s == carom.run(CASE, set=backwards).end_s
    with pytest.raises(carom.CaromError) as caught:
        carom.run(CASE, set={"no.such": 1.0, "nor.this": 2.0})
    assert len(caught.value.problems) == 2
    with pytest.raises(carom.CaromError) as caught:
        carom.run(CASE, set={"contact.friction": "x", "part.mass": -1.0})
    assert {problem.path for problem in caught.value.problems} >= {"contact.friction", "part.mass"}


@pytest.mark.parametrize("wrong", [None, True, float("nan"), "", [1.0]])
def test_what_is_no_value(wrong: object) -> None:
    with pytest.raises(carom.CaromError, match=r"contact\.friction: expected"):
        carom.run(CASE, set={"contact.friction": wrong})  # type: ignore[dict-item]


def test_numbers_that_are_none_are_told_by_their_paths() -> None:
    with pytest.raises(carom.CaromError) as caught:
        carom.impact({"body": {"mass": float("nan"), "inertia": 1j}, "contact": [{"friction": float("inf")}]})
    assert [problem.path for problem in caught.value.problems] == ["body.mass", "body.inertia", "contact.0.friction"]


def test_scenes_are_equal_where_they_say_the_same() -> None:
    assert carom.Scene.read(CASE) == carom.Scene.read(CASE) != carom.Scene.read(CASE).set({"part.mass": 0.4})
    text = Path("examples/bracket.toml").read_text()
    scene = carom.Scene(text, files={"bracket.dxf": Path("examples/bracket.dxf").read_bytes()})
    assert pickle.loads(pickle.dumps(scene)) == scene


def test_names_of_files(tmp_path: Path) -> None:
    named = tmp_path / "mu=0.3.toml"
    named.write_text(Path(CASE).read_text())
    assert carom.run(str(named)).end_s == carom.run(CASE).end_s
    with pytest.raises(carom.CaromError, match=r"Scene\.read"):
        carom.Scene(CASE)
    with pytest.raises(carom.CaromError, match="empty"):
        carom.roll("prism", "\n")
    for given in (b"x", 5, [1]):
        with pytest.raises(carom.CaromError):
            carom.run(given)  # type: ignore[arg-type]


def test_a_vector_of_a_roll() -> None:
    spin = np.array([1.0, 2.0, 3.0])
    assert carom.roll("body", set={"spin": spin}) == carom.roll("body", set={"spin": [1, 2, 3]})  # type: ignore[dict-item]

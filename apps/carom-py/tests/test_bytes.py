"""Python and the command say the same, byte for byte."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import carom
import numpy as np
import pytest
from carom import Answer

ALL = sorted((Path(__file__).parents[3] / "examples").glob("*.toml"))
SOLID = "examples/solid.toml"


def verb(path: Path) -> list[str]:
    """The command that an example is for."""
    text = path.read_text()
    if path.stem.startswith("roll_"):
        return ["roll", path.stem.split("_")[1]]
    if path.stem.startswith("contact_"):
        return ["contact"]
    struck = any(line.strip() in ("[body]", "[[body]]", "[operator]") for line in text.splitlines())
    return ["impact" if struck else "run"]


def asked(words: list[str], file: str) -> carom.Answer:
    match words:
        case ["roll", kind]:
            return carom.roll(kind, file)  # type: ignore[arg-type]
        case ["contact"]:
            return carom.contact(file)
        case ["impact"]:
            return carom.impact(file)
        case _:
            return carom.run(file)


@pytest.mark.parametrize("path", ALL, ids=lambda path: path.stem)
def test_every_example(path: Path, command: Path, tmp_path: Path) -> None:
    words, file = verb(path), f"examples/{path.name}"
    said = subprocess.run([command, *words, file, "--format", "json", "--out", tmp_path], capture_output=True, check=False)
    answer = asked(words, file)
    assert answer.json.encode() == said.stdout
    # Nothing of it is lost on the way to objects.
    assert as_plain(answer) == as_plain(answer.to_dict())
    for name, text in answer.files.items():
        # Where the files of the command stand is told on some pages.
        if name.endswith((".csv", ".svg")):
            assert next(tmp_path.rglob(name)).read_bytes() == text.encode(), name
    for name, content in answer.tables.items():
        assert next(tmp_path.rglob(name)).read_bytes() == content, name


def test_a_solid_part_is_refused_by_name_where_it_is_not_followed() -> None:
    scene = carom.Scene.read(SOLID)
    assert scene.is_solid and scene.set({"start.turn": "3 deg"})["start.turn"].value == pytest.approx(np.deg2rad(3))
    for asked in (lambda: carom.fit(scene, {"outcome": ["turned"]}), scene.simulators):
        with pytest.raises(carom.CaromError, match="is a solid"):
            asked()


def test_studies_of_a_solid_part(command: Path, tmp_path: Path) -> None:
    words = ["yield", SOLID, "--samples", "16", "--format", "json", "--out", str(tmp_path)]
    said = json.loads(subprocess.run([command, *words], capture_output=True, check=True).stdout)
    own = carom.yield_(SOLID, samples=16).to_dict()
    del said["run"], own["run"]
    assert own == said
    turns = np.deg2rad([1.0, 5.0, 20.0])
    runs = [carom.run(SOLID, set={"start.turn": turn}) for turn in turns]
    found = carom.drops(SOLID, {"start.turn": turns})
    verdicts = [run.plates[-1].verdict for run in runs]
    told = [f"face {verdict}" if isinstance(verdict, int) else {"same": "same side"}.get(str(verdict), verdict) for verdict in verdicts]
    assert found["ending"].tolist() == told


def as_plain(value: Any) -> Any:
    """Objects and dictionaries alike, without what is null or absent."""
    if isinstance(value, list):
        return [as_plain(one) for one in value]
    if hasattr(value, "__dataclass_fields__"):
        value = {name.removesuffix("_"): getattr(value, name) for name in value.__dataclass_fields__}
    if isinstance(value, dict):
        return {key: as_plain(one) for key, one in value.items() if one is not None}
    return value


def test_a_yield(command: Path, tmp_path: Path) -> None:
    words = ["yield", "examples/designer.toml", "--samples", "1024", "--seed", "7", "--format", "json", "--out", str(tmp_path)]
    said = json.loads(subprocess.run([command, *words], capture_output=True, check=True).stdout)
    answer = carom.yield_("examples/designer.toml", samples=1024, seed=7)
    own = answer.to_dict()
    del said["run"], own["run"]
    assert own == said
    for name in answer.files:
        if name.endswith(".toml"):
            assert next(tmp_path.rglob(name)).read_bytes() == answer.files[name].encode(), name


def test_a_design(command: Path, tmp_path: Path) -> None:
    words = ["design", "examples/design_turn_once.toml", "--scan", "32", "--samples", "64", "--format", "json", "--out", str(tmp_path)]
    said = json.loads(subprocess.run([command, *words], capture_output=True, check=True).stdout)
    answer = carom.design("examples/design_turn_once.toml", scan=32, samples=64)
    own = answer.to_dict()
    del said["run"], own["run"]
    assert own == said


def test_drops_are_those_of_a_sweep(command: Path, tmp_path: Path) -> None:
    frictions, slopes = [0.05, 0.15, 0.17, 0.3], [10.0, 11.0, 12.5, 20.0]
    designs = tmp_path / "designs.csv"
    rows = [f"{friction},{slope} deg" for friction, slope in zip(frictions, slopes, strict=True)]
    designs.write_text("contact.friction,plate.upper.slope\n" + "\n".join(rows) + "\n")
    subprocess.run([command, "sweep", "examples/case_2.toml", "--list", designs, "--out", tmp_path], capture_output=True, check=True)
    import pyarrow.parquet

    table = carom.drops("examples/case_2.toml", {"contact.friction": frictions, "plate.0.slope": np.deg2rad(slopes)})
    swept = pyarrow.parquet.read_table(next(tmp_path.rglob("*.parquet")))
    for name in ("ending", "outcome"):
        assert swept[name].to_pylist() == table[name].tolist()
    for name in ("impact_speed_m_s", "flat_s", "end_s", "margin"):
        own = [None if np.isnan(value) else value for value in table[name]]
        assert swept[name].to_pylist() == pytest.approx(own, rel=1e-12), name


def test_a_run_is_a_drop() -> None:
    table = carom.drops("examples/case_2.toml", {"contact.friction": [0.15]})
    run = carom.run("examples/case_2.toml")
    assert isinstance(run, carom.Run)
    assert table["end_s"][0] == run.end_s
    assert table["margin"][0] == run.margin


def plain(said: dict[str, object]) -> dict[str, object]:
    """All but what it took."""
    return {key: value for key, value in said.items() if key != "run"}


FRICTION, SLOPE = "contact.friction=0.05..0.17:12", "plate.upper.slope=9..25 deg:12"
#: What the command is asked, and Python.
STUDIES: dict[str, tuple[list[str], Callable[[], Answer]]] = {
    "map": (
        ["map", "examples/case_2.toml", "--x", FRICTION, "--y", SLOPE, "--depth", "1"],
        lambda: carom.map("examples/case_2.toml", FRICTION, ("plate.0.slope", "9 deg", "25 deg", 12), depth=1),
    ),
    "map with cells": (
        ["map", "examples/case_2.toml", "--x", FRICTION, "--y", SLOPE, "--cells"],
        lambda: carom.map("examples/case_2.toml", FRICTION, SLOPE, cells=True),
    ),
    "located yield": (
        ["yield", "examples/designer.toml", "--locate", "--lines", "32"],
        lambda: carom.locate_yield("examples/designer.toml", lines=32),
    ),
    "regions": (
        ["regions", "cylinder", "--set", "inertia_ratio=0.5", "--x", "friction=0..1.5:12", "--y", "gamma=1..89 deg:12"],
        lambda: carom.regions("cylinder", ("friction", 0, 1.5, 12), "gamma=1..89 deg:12", set={"inertia_ratio": 0.5}),
    ),
    "regions of a file": (
        ["regions", "--file", "examples/impact_box.toml", "--x", "body.spin=-10..10:8", "--y", "contact.0.friction=0..1:8"],
        lambda: carom.regions(Path("examples/impact_box.toml"), ("body.spin", -10, 10, 8), ("contact.0.friction", 0, 1, 8)),
    ),
    "feed": (
        ["feed", "examples/feed_closely.toml", "--parts", "2", "--intervals", "16"],
        lambda: carom.feed("examples/feed_closely.toml", parts=2, intervals=16),
    ),
    "feed of a solid part": (
        ["feed", SOLID, "--intervals", "16"],
        lambda: carom.feed(SOLID, intervals=16),
    ),
    "fit": (
        ["fit", "examples/measured.toml", "examples/measured.csv", "--samples", "64", "--nodes", "200"],
        lambda: carom.fit("examples/measured.toml", "examples/measured.csv", samples=64, nodes=200),
    ),
}


@pytest.mark.parametrize("name", STUDIES)
def test_a_study(name: str, command: Path, tmp_path: Path) -> None:
    words, asked = STUDIES[name]
    said = json.loads(subprocess.run([command, *words, "--format", "json", "--out", tmp_path], capture_output=True, check=True).stdout)
    answer = asked()
    assert plain(answer.to_dict()) == plain(said)
    assert as_plain(answer) == as_plain(answer.to_dict())
    told = next(name for name in answer.files if name.endswith(".json"))
    written = {path.name: path for path in tmp_path.rglob("*") if path.is_file() and path.suffix != ".png"}
    assert set(written) == {*answer.files, *answer.tables}
    for file, text in answer.files.items():
        assert file == told or written[file].read_bytes() == text.encode(), file
    for file, table in answer.tables.items():
        assert written[file].read_bytes() == table, file
    assert {path.name for path in answer.save(tmp_path / "own")} == set(written)

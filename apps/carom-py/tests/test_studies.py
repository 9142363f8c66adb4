"""Maps, regions, feeds and fits: what is taken, and what is wrong with what is not."""

from __future__ import annotations

from pathlib import Path

import carom
import numpy as np
import pandas
import polars
import pytest

CASE = "examples/case_2.toml"


def problems(error: pytest.ExceptionInfo[carom.CaromError]) -> list[str]:
    return [problem.path or "" for problem in error.value.problems]


def test_every_fault_of_a_call_is_told_at_once() -> None:
    with pytest.raises(carom.CaromError) as error:
        carom.map(CASE, "contact.frictoin=0..1:8", ("contact.restitution", 0, 7, 8), plate="third", accuracy=2)
    told = problems(error)
    assert [path.split()[0] for path in sorted(told)] == ["accuracy", "plate", "x", "y"]
    assert 'did you mean "contact.friction"' in str(error.value) and "--" not in str(error.value)


def test_an_axis_is_a_text_or_a_tuple() -> None:
    text = carom.map(CASE, "contact.friction=0.05..0.17:6", "contact.restitution=0..0.4:6", depth=0)
    pair = carom.map(CASE, ("contact.friction", 0.05, np.float64(0.17), 6), ("contact.restitution", 0, "0.4", 6), depth=0)
    assert [axis.to for axis in text.axes] == [axis.to for axis in pair.axes] and text.labels == pair.labels
    for wrong in (("contact.friction", 1), 3, ("contact.friction", 0, float("nan"))):
        with pytest.raises(carom.CaromError, match="^x: expected"):
            carom.map(CASE, wrong, "contact.restitution=0..0.4:6")  # type: ignore[arg-type]


def test_a_picture_is_shown_by_a_notebook() -> None:
    rod = carom.regions("rod", ("to_a", 0.1, 0.4, 4), ("to_b", 0.1, 0.4, 4))
    assert rod._repr_html_() is None and (rod._repr_svg_() or "").startswith("<svg")


def test_regions_of_an_impact_need_axes() -> None:
    with pytest.raises(carom.CaromError) as error:
        carom.regions(Path("examples/impact_box.toml"))
    assert sorted(problems(error)) == ["x", "y"]
    with pytest.raises(carom.CaromError, match="is none of cylinder, prism"):
        carom.regions("cilinder")
    with pytest.raises(carom.CaromError, match="depth: 9 is outside 0 to 8"):
        carom.regions("rod", depth=9)


def test_a_region_diagram_of_a_dictionary() -> None:
    box = {
        "body": {"mass": 1, "inertia": 0.4, "velocity": [1.0, -2.0]},
        "contact": [{"point": [0.3, -1.0], "normal": [0, 1], "friction": 0.3, "restitution": 0.5}],
    }
    found = carom.regions(box, ("contact.0.friction", 0, 1, 8), ("body.spin", -5, 5, 8))
    assert sum(label.area_share for label in found.labels) == pytest.approx(1.0, abs=1e-9)


def test_rows_of_a_fit_come_in_many_ways(tmp_path: Path) -> None:
    over = ("contact.restitution", 0, 0.5)
    seen = {"contact.friction": [0.02, 0.15], "outcome": ["same", "turned"], "drops": [4, 5]}
    text = "contact.friction,outcome,drops\n0.02,same,4\n0.15,turned,5\n"
    file = tmp_path / "seen.csv"
    file.write_text(text)
    frames = (seen, text, file, str(file), pandas.DataFrame(seen), polars.DataFrame(seen))
    fits = [carom.fit(CASE, rows, over=over) for rows in frames]
    assert {fit.observed_drops for fit in fits} == {9}
    assert len({fit.parameters[0].high for fit in fits}) == 1
    for same in (["contact.restitution=0..0.5"], ("contact.restitution", "0", "0.5"), [over]):
        assert carom.fit(CASE, seen, over=same).parameters == fits[0].parameters
    # Beside a missing value a frame's whole numbers are floats.
    assert carom.fit(CASE, seen | {"drops": [4.0, 5.0]}, over=over).observed_drops == 9
    for wrong, why in (({"over": 5}, "over: expected"), ({"level": "high"}, "level: expected")):
        with pytest.raises(carom.CaromError, match=why):
            carom.fit(CASE, seen, **wrong)


def test_what_is_wrong_with_rows_is_told() -> None:
    with pytest.raises(carom.CaromError) as error:
        carom.fit(CASE, {"outcome": ["turned", "turnd"], "drops": [1, -1]}, level=2)
    assert sorted(problems(error)) == ["drops", "level", "outcome"]
    with pytest.raises(carom.CaromError, match="columns of one length"):
        carom.fit(CASE, {"outcome": ["turned"], "drops": [1, 2]})
    with pytest.raises(carom.CaromError, match="no such file"):
        carom.fit(CASE, "no.csv")
    with pytest.raises(carom.CaromError, match="never happens"):
        carom.fit(CASE, {"outcome": ["stuck"]}, over=("contact.friction", 0, 0.1), nodes=100, samples=16)


def test_drops_take_frames() -> None:
    columns = {"contact.friction": [0.01, 0.15]}
    tables = [carom.drops(CASE, frame) for frame in (columns, pandas.DataFrame(columns), polars.DataFrame(columns))]
    assert {tuple(table["ending"].tolist()) for table in tables} == {("same side", "turned")}


def test_a_feed_is_told_why_there_is_none() -> None:
    with pytest.raises(carom.CaromError) as error:
        carom.feed("examples/feed_closely.toml", parts=1, intervals=1, accuracy=1)
    assert sorted(problems(error)) == ["accuracy", "intervals", "parts"]

"""Arrays: what comes out is right, and what is wrong is told."""

from __future__ import annotations

from typing import Any

import carom
import carom.answers.impact
import numpy as np
import pytest

CASE = "examples/case_2.toml"


def test_impacts_are_those_of_one_at_a_time() -> None:
    random = np.random.default_rng(1)
    n = 200
    given: dict[str, Any] = {
        "mass": random.uniform(0.1, 5, n),
        "inertia": random.uniform(0.01, 2, n),
        "arm": random.uniform(-1, 1, (n, 2)),
        "velocity": random.uniform(-3, 3, (n, 2)),
        "spin": random.uniform(-5, 5, n),
        "friction": random.uniform(0, 1.5, n),
        "restitution": random.uniform(0, 1, n),
    }
    angles = random.uniform(0, 2 * np.pi, n)
    normal = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    for law in ("poisson", "stronge", "newton"):
        table = carom.impacts(**given, normal=3 * normal, law=law)
        struck = 0
        for row in range(n):
            # An impact file is for a body that approaches: one that leaves does nothing.
            touching = given["velocity"][row] + given["spin"][row] * np.array([-given["arm"][row][1], given["arm"][row][0]])
            if touching @ normal[row] >= -1e-9:
                assert table["type"][row] == 0 and table["normal_impulse_N_s"][row] == 0
                continue
            struck += 1
            body = {
                "mass": f"{given['mass'][row]} kg",
                "inertia": f"{given['inertia'][row]} kg m^2",
                "velocity": [f"{v} m/s" for v in given["velocity"][row].tolist()],
                "spin": f"{given['spin'][row]} rad/s",
            }
            contact = {
                "point": [f"{v} m" for v in given["arm"][row].tolist()],
                "normal": normal[row],
                "friction": given["friction"][row],
                "restitution": given["restitution"][row],
            }
            one = carom.impact({"law": law, "body": body, "contact": [contact]})
            assert isinstance(one, carom.answers.impact.PlanarImpact) and one.staged is not None
            after = one.staged
            assert table["type"][row] == after.type and table["state"][row] == after.contacts[0].state
            assert after.velocity_m_s is not None
            assert table["velocity_x_m_s"][row] == pytest.approx(after.velocity_m_s[0], abs=1e-11)
            assert table["velocity_y_m_s"][row] == pytest.approx(after.velocity_m_s[1], abs=1e-11)
            assert table["spin_rad_s"][row] == pytest.approx(after.spin_rad_s, abs=1e-10)
        assert struck > 50


def problems(call: object, *arguments: object, **named: object) -> list[carom.Problem]:
    with pytest.raises(carom.CaromError) as caught:
        call(*arguments, **named)  # type: ignore[operator]
    return caught.value.problems


def test_faults_name_rows_and_columns() -> None:
    wrong = problems(carom.drops, CASE, {"part.mass": [0.3, -1.0, np.nan], "contact.friction": [0.1, 0.2, np.inf]})
    assert [(one.path, one.message.split(":")[0]) for one in wrong] == [
        ("part.mass", "row 1"),
        ("part.mass", "row 2"),
        ("contact.friction", "row 2"),
    ]


def test_of_many_faults_some_are_told_and_the_rest_is_counted() -> None:
    wrong = problems(carom.drops, CASE, {"part.mass": np.full(1000, -1.0)})
    assert len(wrong) == 11 and wrong[-1].message.startswith("990 more")


def test_faults_of_shape_and_kind() -> None:
    assert "holds text" in problems(carom.drops, CASE, {"part.mass": ["0.3 kg"]})[0].message
    assert "shape (2, 2)" in problems(carom.drops, CASE, {"part.mass": np.ones((2, 2))})[0].message
    assert "complex" in problems(carom.drops, CASE, {"part.mass": [1j]})[0].message
    assert "rows" in problems(carom.drops, CASE, {"part.mass": [1, 2, 3], "contact.friction": [0.1, 0.2]})[0].message
    assert problems(carom.drops, CASE, {"no.such": [1.0]})[0].kind == "unknown_key"
    assert "named twice" in problems(carom.drops, CASE, {"plate.0.slope": [0.1], "plate.upper.slope": [0.1]})[0].message
    assert "no column" in problems(carom.drops, CASE, {})[0].message
    assert "is none of" in problems(carom.drops, CASE, {"part.mass": [1.0]}, plate="third")[0].message
    assert "no names" in problems(carom.drops, CASE, np.ones(3))[0].message
    assert problems(carom.impacts, mass=-1, inertia=1, arm=(0, -1), velocity=(0, -1))[0].path == "mass"
    assert "no direction" in problems(carom.impacts, mass=1, inertia=1, arm=(0, -1), velocity=(0, -1), normal=(0, 0))[0].message
    assert "(3,)" in str(pytest.raises(carom.CaromError, carom.impacts, mass=1, inertia=1, arm=(0, 1, 2), velocity=(0, -1)).value)
    assert "law" in problems(carom.impacts, mass=1, inertia=1, arm=(0, -1), velocity=(0, -1), law="newtn")[0].message


def test_masked_places_are_told() -> None:
    masked = np.ma.MaskedArray([0.1, 0.5], mask=[False, True])
    assert problems(carom.drops, CASE, {"contact.friction": masked})[0].message.startswith("row 1: NaN")


def test_all_faults_of_impacts_are_told() -> None:
    wrong = problems(carom.impacts, mass="x", inertia=[[1]], arm=(1,), velocity=[(0, 1), (1,)])
    assert {one.path for one in wrong} == {"mass", "inertia", "arm", "velocity"}
    assert "above 0" in problems(carom.impacts, mass=0, inertia=1, arm=(0, -1), velocity=(0, -1))[0].message


def test_a_normal_has_any_length() -> None:
    columns = {"mass": 1, "inertia": 0.4, "arm": (0, -1), "velocity": (0, -1), "restitution": 0.5}
    for length in (1e-200, 1, 1e200):
        assert carom.impacts(**columns, normal=(0, length))["velocity_y_m_s"].tolist() == [0.5]  # type: ignore[arg-type]


def test_every_kind_of_array_is_taken() -> None:
    values = np.linspace(0.05, 0.17, 7)
    plain = carom.drops(CASE, {"contact.friction": values})
    strided = np.empty((7, 2))
    strided[:, 0] = values
    structured = np.zeros(7, dtype=[("contact.friction", "f8")])
    structured["contact.friction"] = values
    kinds = [values.tolist(), strided[:, 0], values[::-1][::-1], values.astype(">f8"), values.astype(object).astype(float)]
    for kind in kinds:
        assert carom.drops(CASE, {"contact.friction": kind})["end_s"].tolist() == plain["end_s"].tolist()
    assert carom.drops(CASE, structured)["end_s"].tolist() == plain["end_s"].tolist()
    one_for_all = carom.drops(CASE, {"contact.friction": values, "part.mass": 0.3})
    assert one_for_all["end_s"].tolist() == plain["end_s"].tolist() and one_for_all["part.mass"].tolist() == [0.3] * 7


def test_no_rows_are_a_table_without_rows() -> None:
    assert len(carom.drops(CASE, {"contact.friction": []})) == 0


def test_designs_that_cannot_be_are_told_in_their_rows() -> None:
    table = carom.drops(CASE, {"start.to_edge": [0.1, 50.0]})
    assert len(table) == 2 and table["ending"][0] == "turned"


def test_arrow_readers_see_the_same() -> None:
    table = carom.drops(CASE, {"contact.friction": [0.05, 0.15, 0.5]})
    pyarrow = pytest.importorskip("pyarrow")
    arrow = pyarrow.table(table)
    assert arrow.column_names == table.columns
    assert arrow["ending"].to_pylist() == table["ending"].tolist()
    assert arrow["flat_s"].null_count == 1 and arrow["flat_s"].to_pylist()[:2] == table["flat_s"][:2].tolist()
    assert arrow.schema.field("flat_s").metadata[b"unit"] == b"s"
    polars = pytest.importorskip("polars")
    assert polars.DataFrame(table)["ending"].to_list() == table["ending"].tolist()
    pandas = pytest.importorskip("pandas")
    assert pandas.DataFrame.from_arrow(table)["ending"].tolist() == table["ending"].tolist()
    assert pandas.DataFrame(dict(table))["ending"].tolist() == table["ending"].tolist()
    assert np.asarray(table)["ending"].tolist() == table["ending"].tolist()
    duckdb = pytest.importorskip("duckdb")
    assert duckdb.sql("select ending from arrow where margin > 0.1 order by ending").fetchall() == [("same side",), ("stuck",)]


def test_a_table_is_one_array_and_counts_its_words() -> None:
    table = carom.drops(CASE, {"contact.friction": [0.05, 0.15, 0.16]})
    whole = table.to_numpy()
    assert whole["ending"].tolist() == ["same side", "turned", "turned"] and whole["end_s"].tolist() == table["end_s"].tolist()
    assert table.counts() == {"turned": 2, "same side": 1}
    assert "3 rows" in repr(table) and "<table>" in table._repr_html_()
    with pytest.raises(KeyError, match="none of"):
        table["no"]

"""Impacts at several contacts as arrays: what one impact says, row by row."""

from typing import Any

import numpy as np
import pytest

import carom

RNG = np.random.default_rng(5)


def given(rows: int, contacts: int) -> dict[str, Any]:
    lean = RNG.uniform(-1.2, 1.2, (rows, contacts))
    return {
        "mass": RNG.uniform(0.1, 2.0, rows),
        "inertia": RNG.uniform(1e-4, 1e-2, rows),
        "points": np.stack([RNG.uniform(-0.1, 0.1, (rows, contacts)), RNG.uniform(-0.1, 0.0, (rows, contacts))], axis=-1),
        "normals": np.stack([np.sin(lean), np.cos(lean)], axis=-1),
        "friction": RNG.uniform(0.0, 1.0, (rows, contacts)),
        "restitution": RNG.uniform(0.0, 1.0, (rows, contacts)),
        "velocity": np.stack([RNG.uniform(-1.0, 1.0, rows), RNG.uniform(-2.0, -0.5, rows)], axis=-1),
        "spin": RNG.uniform(-10.0, 10.0, rows),
    }


@pytest.mark.parametrize(("contacts", "law"), [(1, "stronge"), (2, "poisson"), (3, "poisson"), (7, "poisson")])
def test_a_row_is_what_one_impact_says(contacts: int, law: Any) -> None:
    columns = given(12, contacts)
    found = carom.impact_batch(**columns, law=law)
    for row in range(12):
        body = {name: columns[name][row] for name in ("mass", "inertia", "velocity", "spin")}
        own = [{"point": p, "normal": n, "friction": f, "restitution": e} for p, n, f, e in zip(*(columns[name][row] for name in ("points", "normals", "friction", "restitution")), strict=True)]
        one = carom.impact({"law": law, "body": body, "contact": own})
        assert isinstance(one, carom.PlanarImpact)
        end = one.staged or (one.end_states[0] if one.end_states else None)
        assert found["outcome"][row] == one.outcome
        if end is None:
            assert np.isnan(found["spin_rad_s"][row])
            continue
        assert found["velocity_m_s"][row].tolist() == list(end.velocity_m_s or ())
        assert found["spin_rad_s"][row] == end.spin_rad_s
        assert found["energy_after_J"][row] == end.energy_after_J
        assert found["normal_impulse_N_s"][row].tolist() == [contact.normal_impulse_N_s for contact in end.contacts]
        assert found["state"][row].tolist() == [contact.state for contact in end.contacts]


def test_one_value_stands_for_all() -> None:
    columns = given(5, 2)
    alone = carom.impact_batch(**{**columns, "friction": 0.3, "restitution": [0.1, 0.2], "points": columns["points"][0], "mass": 1.0})
    every = carom.impact_batch(
        **{**columns, "friction": np.full((5, 2), 0.3), "restitution": np.tile([0.1, 0.2], (5, 1)), "points": np.tile(columns["points"][0], (5, 1, 1)), "mass": np.ones(5)}
    )
    assert all(np.array_equal(alone[name], every[name]) for name in ("velocity_m_s", "spin_rad_s", "normal_impulse_N_s"))
    assert alone["slip_m_s"].shape == (5, 2)


@pytest.mark.parametrize(
    ("name", "value", "told"),
    [
        ("mass", -1.0, r"mass: row 0: -1\.0 is not a number above 0"),
        ("points", np.full((5, 2, 2), np.nan), r"points\[0, 0\]: row 0: NaN"),
        ("points", [[0.0, 0.0, 0.0]], r"points: has the shape \(1, 3\), not \(n, k, 2\)"),
        ("normals", np.zeros((5, 2, 2)), "row 0: .0, 0. has no direction"),
        ("friction", np.zeros((5, 3)), "friction: has 3 contacts, points have 2"),
        ("restitution", "high", "restitution: holds"),
        ("velocity", [1.0], r"velocity: has the shape \(1,\), not \(n, 2\)"),
        ("spin", np.zeros(4), "has 4 rows"),
        ("law", "nobody", "is none of poisson"),
        ("points", np.zeros((5, 25, 2)), "25 contacts, not 1 to 24"),
    ],
)
def test_what_is_wrong_is_named(name: str, value: Any, told: str) -> None:
    with pytest.raises(carom.CaromError, match=told):
        carom.impact_batch(**{**given(5, 2), name: value})


def test_no_row_is_no_fault() -> None:
    assert carom.impact_batch(**given(0, 2))["spin_rad_s"].shape == (0,)

"""Closed forms beside the engine, at random numbers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import carom
import numpy as np
import pytest

sympy = pytest.importorskip("sympy")
pytest.importorskip("z3")

from carom.symbolic.check import Agreement, against_engine, all_found  # noqa: E402
from carom.symbolic.paper import cylinder, space  # noqa: E402

#: As a share of the largest velocity, or impulse.
ROUNDING = 1e-10

Draw = Callable[[np.random.Generator, int], dict[str, Any]]


def between(**ranges: tuple[float, float]) -> Draw:
    """Draws every symbol evenly from its range."""
    return lambda random, count: {name: random.uniform(low, high, count) for name, (low, high) in ranges.items()}


ROLLING = between(m=(0.2, 3), a=(0.2, 2), b=(0.1, 1.5), omega0=(0.2, 3), f=(0, 2), gamma=(0.02, 1.55), R=(0.05, 0.95))
BOX = {
    "body": {"mass": "m", "inertia": "J", "velocity": ["u", "-v"], "spin": "omega0"},
    "contact": [
        {"name": "left", "point": ["-w", "-h"], "normal": [0, 1], "friction": "f", "restitution": "e"},
        {"name": "right", "point": ["w", "-h"], "normal": [0, 1], "friction": "f", "restitution": "e"},
    ],
}
BOXES = between(m=(0.2, 3), J=(0.05, 2), u=(-2, 2), v=(0.1, 2), omega0=(-3, 3), w=(0.1, 1), h=(0.1, 1), f=(0, 1.5), e=(0.05, 0.95))


def agrees(found: Agreement, draws: int) -> None:
    assert found.draws == found.found == draws, found
    assert found.velocity < ROUNDING and found.impulse < ROUNDING, found


def ball(**more: Any) -> dict[str, Any]:
    body = {"mass": "m", "inertia": "2*m*r**2/5", "velocity": ["u", "-v"], "spin": "omega0"}
    return {"body": body, "contact": [{"name": "A", "point": [0, "-r"], "normal": [0, 1], "friction": "f", **more}]}


def test_every_state_of_the_cylinder_is_the_engines_and_every_one_of_the_engines_is_derived() -> None:
    found = carom.derive(cylinder.problem(), assume=cylinder.ASSUME)
    assert {one.title for one in found} == set(cylinder.STATES)
    for one in found:
        agrees(against_engine(one, ROLLING, 150), 150)
    matched, missed = all_found(found, ROLLING, 300)
    assert matched >= 300 and not missed


def test_restitution_of_the_cylinder_beside_the_engine() -> None:
    for state, end in ((1, "A separates, K separates (sticks)"), (1, "A slips-, K separates (sticks)"), (2, "A separates, K separates (slips-)"), (3, "A slips-, K separates (slips-)")):
        agrees(against_engine(cylinder.elastic(state, end), ROLLING, 100), 100)
    # Where compression leaves impulses open the motion after restitution is a family, and the engine's is one of it.
    family = cylinder.elastic(4, "A sticks, K sticks")
    assert [str(one) for one in family.free] == ["T_K", "T_K_2"]
    agrees(against_engine(family, ROLLING, 20), 20)


def test_a_box_that_lands_on_both_corners_in_every_way() -> None:
    plain = {**BOX, "contact": [{**one, "restitution": 0} for one in BOX["contact"]]}  # type: ignore[dict-item]
    found = carom.derive(plain, assume=["v > 0", "w > 0", "h > 0"])
    assert len(found) >= 8
    for one in found:
        seen = against_engine(one, BOXES, 40, at_most=60)
        agrees(seen, seen.draws)
    matched, missed = all_found(found, BOXES, 300)
    assert matched >= 300 and not missed


def test_newtons_law_is_one_step() -> None:
    found = carom.derive({**ball(restitution="e"), "law": "newton"}, assume=["r > 0", "v > 0"])
    draw = between(m=(0.2, 3), r=(0.1, 1), u=(-2, 2), v=(0.1, 2), omega0=(-5, 5), f=(0, 1), e=(0, 1))
    assert {one.hypothesis for one in found} == {"A sticks", "A slips+", "A slips-"}
    for one in found:
        assert one.contact("A").normal_velocity == sympy.Symbol("e", nonnegative=True) * sympy.Symbol("v", positive=True)
        agrees(against_engine(one, draw, 100), 100)
    with pytest.raises(carom.CaromError, match="assume it"):
        carom.derive({**ball(restitution="e"), "law": "newton"}, "A sticks", assume=["r > 0"])


def test_several_bodies_and_a_fixed_one() -> None:
    problem = {
        "body": [
            {"name": "first", "mass": "m", "inertia": "J", "centre": [0, 0], "velocity": ["-u", "w"], "spin": "omega0"},
            {"name": "second", "mass": "M", "inertia": "K", "centre": ["-2*r", 0], "velocity": ["u", 0]},
            {"name": "floor", "kind": "fixed"},
        ],
        "contact": [
            {"name": "A", "between": ["first", "second"], "point": ["-r", 0], "normal": [1, 0], "friction": "f"},
            {"name": "B", "between": ["first", "floor"], "point": [0, "-r"], "normal": [0, 1], "friction": "g"},
        ],
    }
    draw = between(m=(0.2, 3), M=(0.2, 3), J=(0.05, 2), K=(0.05, 2), r=(0.1, 1), u=(0.1, 2), w=(-2, 0.5), omega0=(-3, 3), f=(0, 1), g=(0, 1))
    found = carom.derive(problem, assume=["r > 0", "u > 0"], discard=False)
    compared = [against_engine(one, draw, 30, at_most=5) for one in found]
    assert sum(one.draws > 0 for one in compared) >= 8
    for one in compared:
        agrees(one, one.draws)
    assert {"first", "second"} <= {body.name for body in found[0].bodies}


def test_the_operator_alone() -> None:
    given = {"operator": {"matrix": [["p", "q"], ["q", "s"]], "velocity": ["x", "-y"], "friction": "f", "restitution": "e"}}
    draw = between(p=(2, 4), q=(-1, 1), s=(2, 4), x=(-2, 2), y=(0.1, 2), f=(0, 1), e=(0.1, 0.9))
    slides = carom.derive(given, "A slips+", restitution="A separates (slips+)", assume=["p > 0", "s > 0", "y > 0"])
    agrees(against_engine(slides, draw, 100), 100)
    same = carom.derive({"operator": {"w_tt": "p", "w_tn": "q", "w_nn": "s", "slip": "x", "approach": "-y", "friction": "f", "restitution": "e"}}, "A slips+", restitution="A separates (slips+)")
    assert same.contact("A").slip == slides.contact("A").slip.subs({old: new for old in slides.problem.symbols for new in same.problem.symbols if old.name == new.name})
    with pytest.raises(carom.CaromError, match="not symmetric"):
        carom.derive({"operator": {"matrix": [["p", "q"], ["x", "s"]], "velocity": [0, -1], "friction": 0}}, "A slips")


def test_the_pyramid_and_the_supports_beside_the_engine() -> None:
    def pyramids(random: np.random.Generator, count: int) -> dict[str, Any]:
        return {"m": random.uniform(0.2, 3, count), "a": random.uniform(0.2, 2, count), "h": random.uniform(0.1, 3, count), "w": random.uniform(0.2, 3, count), "n": random.integers(4, 13, count)}

    for names in ("OK", "K"):
        agrees(against_engine(space.kept(names), pyramids, 100, non_sliding=True), 100)
    for names in ("OAK", "AK"):
        agrees(against_engine(space.kept(names, 3), pyramids, 100, non_sliding=True), 100)

    def stools(random: np.random.Generator, count: int) -> dict[str, Any]:
        drawn = between(m=(0.2, 3), a=(0.2, 2), c=(0.02, 1), Jt=(0.01, 1), share=(0.05, 1.95), delta=(-0.5, 0.5), omega_xi=(-2, 2), omega_eta=(-2, 2), omega_zeta=(-2, 2))(random, count)
        return drawn | {"Jz": drawn["share"] * drawn["Jt"]}

    for names in ("OK", "K"):
        agrees(against_engine(space.on_supports(names, 3), stools, 60, non_sliding=True), 60)


def test_friction_in_space() -> None:
    problem = {
        "body": {"mass": "m", "inertia": ["J", "J", "J"], "velocity": ["u", 0, "-v"], "spin": [0, "omega0", 0]},
        "contact": [{"name": "A", "point": [0, 0, "-r"], "normal": [0, 0, 1], "friction": "f", "restitution": "e"}],
    }
    assume = ["r > 0", "v > 0", "J > 0"]
    draw = between(m=(0.2, 3), J=(0.05, 2), u=(-2, 2), v=(0.1, 2), omega0=(-3, 3), r=(0.1, 1), f=(0, 1), e=(0.1, 0.9))
    slides = carom.derive(problem, {"A": ("slips", [1, 0, 0])}, restitution={"A": ("separates", [1, 0, 0])}, assume=assume)
    assert slides.existence.verdict == "holds"
    agrees(against_engine(slides, draw, 60), 60)
    sticks = carom.derive(problem, "A sticks", restitution="A separates (sticks)", assume=assume)
    assert {one.kind for one in sticks.conditions} == {"normal_impulse", "friction_cone", "normal_velocity"}
    # A slip across the motion before the impact is no solution: it must vanish, and does not.
    across = carom.derive(problem, {"A": ("slips", [0, 1, 0])}, restitution={"A": ("separates", [0, 1, 0])}, assume=[*assume, "u > 0", "omega0 < 0"])
    assert across.existence.verdict in ("empty", "border") and any(one.equation for one in across.conditions)


def test_without_friction_in_space() -> None:
    problem = {
        "body": {"mass": "m", "inertia": ["J", "K", "L"], "velocity": [0, "u", "-v"], "spin": ["omega0", "omega1", 0]},
        "contact": [{"name": name, "point": [x, y, "-h"], "normal": [0, 0, 1], "friction": 0, "restitution": "e"} for name, x, y in (("A", "a", "b"), ("B", "-a", "b"))],
    }
    draw = between(m=(0.2, 3), J=(0.5, 0.9), K=(0.5, 0.9), L=(0.5, 0.9), u=(-1, 1), v=(1, 2), omega0=(-0.3, 0.3), omega1=(-0.3, 0.3), a=(0.3, 1), b=(-0.2, 0.2), h=(0.1, 1), e=(0.2, 0.9))
    both = carom.derive(problem, "A slips, B slips", restitution="A separates (slips), B separates (slips)", assume=["v > 0", "a > 0"])
    agrees(against_engine(both, draw, 60), 60)

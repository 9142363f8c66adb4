"""Notebooks: each runs from its first cell to its last in a kernel of its own, and what it finds is right."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import pytest

NOTEBOOKS = Path(__file__).parents[1] / "notebooks"
#: No output is kept in a notebook: it is text, and small.
MOST_BYTES = 40_000

Execute = Callable[[str, Mapping[str, str], Mapping[str, str]], dict[str, Any]]


def test_every_notebook_says_first_what_it_teaches_and_what_it_needs() -> None:
    found = sorted(path.stem for path in NOTEBOOKS.glob("*.py"))
    assert found == ["design_from_scratch", "feeder_paper", "friction_from_impacts", "how_engines_differ", "many_drops_on_a_cluster", "simultaneous_collisions"]
    for name in found:
        text = (NOTEBOOKS / f"{name}.py").read_text(encoding="utf-8")
        first = text.split("# %% [markdown]")[1].split("# %%")[0]
        assert "# You learn " in first and 'pip install "./apps/carom-py[notebooks]"' in first, name
        assert len(text.encode()) < MOST_BYTES, name


def test_the_feeder_paper(execute: Execute) -> None:
    said = execute("feeder_paper", {}, {"verdicts": "verdicts", "counts": "counts", "borne_out": "int(borne_out)", "types": "[strike.type for strike in strikes.values()]", "low": "share.low", "high": "share.high", "areas": "shares"})
    assert said["verdicts"] == {"case_1": "same", "case_2": "turned"} and said["types"] == [5, 1]
    assert said["borne_out"] == sum(said["counts"].values()) == 82 and "off" not in said["counts"]
    assert 0.8 < said["low"] < said["high"] < 0.95
    assert {"same side", "turned", "stuck"} <= set(said["areas"]) and sum(said["areas"].values()) == pytest.approx(1.0, abs=2e-3)


def test_simultaneous_collisions(collisions: dict[str, Any]) -> None:
    assert collisions["counts"] == {"agrees": 52, "misprint": 8, "wrong in print": 16}
    assert len(collisions["rows"]) == 76 and collisions["errata"] == 24
    assert set(collisions["ways"]) == {"A separates, K sticks", "A separates, K slips-", "A sticks, K sticks", "A slips-, K slips-"}
    assert collisions["discarded"] == 12 and collisions["difference"] == "0"
    # The rod of 1 m and 1 kg on supports at 0.4 m, by hand: m ω₀ (12 a b − l²)/(12 (a + b)).
    right = (12 * 0.16 - 1) / (12 * 0.8)
    assert collisions["impulses"] == {"as printed": pytest.approx(-0.0875), "derived": pytest.approx(right), "engine": pytest.approx(right)}


def test_friction_from_impacts(execute: Execute) -> None:
    said = execute("friction_from_impacts", {}, {"intervals": "intervals", "truth": "TRUTH", "floor": "floor", "held": "held_out", "laws": "laws", "tosses": "len(tosses)"})
    for name, truth in said["truth"].items():
        low, best, high = said["intervals"][name]
        assert low < best < high and low <= truth <= high, name
    assert 0 < said["floor"] < said["held"] < 0.06
    assert min(said["laws"], key=said["laws"].get) == "poisson" and said["tosses"] == 3


def test_design_from_scratch(execute: Execute) -> None:
    said = execute("design_from_scratch", {"CAROM_SCAN": "16", "CAROM_SAMPLES": "16"}, {"before": "before.yield_.share", "after": "after.yield_.low", "strike": "winner.impact_speed_m_s", "stays": "[one['stays'] for one in faces]", "files": "[path.name for path in written]"})
    assert said["before"] < 0.6 and said["after"] > 0.9 and said["strike"] <= 2.0
    assert said["stays"] == [True, True, True, False, True]
    assert {"design.toml", "drawing.dxf", "drawing.svg", "report.html", "yield.html"} <= set(said["files"])


def test_how_engines_differ(execute: Execute) -> None:
    said = execute("how_engines_differ", {"CAROM_EVERY": "8"}, {"spins": "spins", "follows": "follows", "like": "like_one_step", "off": "restitution_error"})
    assert {"box2d", "mujoco", "pymunk"} <= set(said["follows"])
    assert said["like"]["pymunk"] > 0.99, "it solves one problem for each step"
    assert said["follows"]["pymunk"]["follows newton"] == 20 and said["follows"]["pymunk"]["agrees"] == 56
    spins = said["spins"]
    assert spins["Carom"] == pytest.approx(spins["Routh's walk, in closed form"], rel=1e-9)
    assert spins["pymunk"] == pytest.approx(spins["one complementarity problem"], rel=1e-3)
    assert abs(spins["Carom"] - spins["one complementarity problem"]) > 2
    assert said["off"]["pymunk"] < 1e-2


def test_many_drops_on_a_cluster(execute: Execute) -> None:
    said = execute("many_drops_on_a_cluster", {"CAROM_DROPS": "1e4"}, {"rows": "swept.rows", "endings": "swept.endings", "counted": "counted", "same": "same", "shared": "found.yield_.share", "alone": "alone.yield_.share"})
    assert said["rows"] == 10_000 and said["endings"] == said["counted"] and sum(said["counted"].values()) == 10_000
    assert said["same"] is True and said["shared"] == said["alone"]

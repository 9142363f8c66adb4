"""Answers of `carom regions`. Written by `generate.py` from its schema."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from carom._answer import Answer
from carom.answers.shared import (
    RegionsAxis,
    RegionsBoundary,
    RegionsJunction,
    RegionsLabel,
)


@dataclass(frozen=True, kw_only=True)
class RegionsClosedForm:
    """How a closed form and the engine's boundary compare."""

    boundary_points: int
    """Points of the engine's boundary between these states."""
    curve: str
    """The closed form."""
    curve_points: int
    """Points of the curve, where it applies."""
    curve_points_confirmed: int
    """Those on whose two sides the engine finds the two states."""
    largest_distance_share: float
    """Largest distance of one of them from the curve, as a share of the axes."""
    states: list[int]
    """Numbers of the states on its two sides."""


@dataclass(frozen=True, kw_only=True)
class RegionsEnds:
    """On what share of the nodes of the first grid the laws leave a choice."""

    branching_share: float
    """The staged impact met several ways on, and one was chosen."""
    not_reached_share: float
    """The staged impact, which gives the label, ends in none of them: the end depends on the way there."""
    several_share: float
    """Several end states obey the laws, judged at the end alone."""


@dataclass(frozen=True, kw_only=True)
class RegionsSetting:
    """A quantity that is no axis."""

    unit: str
    """Its SI unit; empty for plain numbers."""
    value: float
    """Its value in `unit`."""


@dataclass(frozen=True, kw_only=True)
class RegionsThreshold:
    """Where the outcome changes on one line of the plane, at a fixed abscissa."""

    above: str
    """The label above."""
    below: str
    """The label below."""
    closed_form_y: float | None = None
    """The closed form's ordinate; null where there is none for this change."""
    x: float
    """The abscissa, in the axis' unit."""
    y: float
    """The ordinate between two points of which the engine says one thing and the other."""
    y_bracket: float
    """How far these two points are apart."""


@dataclass(frozen=True, kw_only=True)
class RegionsWork:
    """What a diagram took."""

    evaluations: int
    """Points at which the engine was asked."""


@dataclass(frozen=True, kw_only=True)
class Regions(Answer):
    """The summary of a region diagram."""

    axes: list[RegionsAxis]
    """Abscissa and ordinate."""
    boundaries: list[RegionsBoundary]
    """The boundaries."""
    closed_forms: list[RegionsClosedForm]
    """Comparisons with closed forms, where there are any."""
    diagram: str
    """Name of the diagram, and of its folder."""
    ends: RegionsEnds | None = None
    """Where the laws leave a choice; null where it is not examined."""
    junctions: list[RegionsJunction]
    """Where three or more labels meet."""
    labels: list[RegionsLabel]
    """The labels."""
    points_without_closed_form: int
    """Points of boundaries between labels for which there is no closed form."""
    remarks: list[str]
    """What else a person should know."""
    settings: dict[str, RegionsSetting]
    """The quantities that are no axis, by key."""
    thresholds: list[RegionsThreshold]
    """Where the outcome changes on single lines: of a pyramid at every whole number of sides; empty for other
    diagrams.
    """
    title: str
    """What it shows."""
    work: RegionsWork
    """What it took."""

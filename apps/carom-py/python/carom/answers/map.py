"""Answers of `carom map`. Written by `generate.py` from its schema."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from carom._answer import Answer
from carom.answers.shared import (
    Approximation,
    RegionsAxis,
    RegionsBoundary,
    RegionsJunction,
    RegionsLabel,
    StudyRun,
)


@dataclass(frozen=True, kw_only=True)
class CellsEnding:
    """How many cells end in a way."""

    cells: int
    """Cells."""
    ending: str
    """same side, turned, face and its number; else how a run ends that never lies on the plate."""


@dataclass(frozen=True, kw_only=True)
class Cells:
    """The cells of a map: each ends as the drop at its middle does, which was followed or lies in a region whose
    boundaries were.
    """

    columns: int
    """Cells across."""
    endings: list[CellsEnding]
    """How they end; all of them are in the table of cells."""
    rows: int
    """Cells up."""


@dataclass(frozen=True, kw_only=True)
class Span:
    """The lowest and the highest of a measure among the nodes of a map."""

    high: float
    """Highest."""
    low: float
    """Lowest."""


@dataclass(frozen=True, kw_only=True)
class Map(Answer):
    """The summary of an outcome map."""

    accuracy_share: float
    """How finely boundaries are located, as a share of the axes."""
    approximations: list[Approximation] | None = None
    """How the computed part differs from the drawn one; absent where it does not."""
    axes: list[RegionsAxis]
    """Abscissa and ordinate."""
    boundaries: list[RegionsBoundary]
    """The boundaries between them."""
    cells: Cells | None = None
    """A finer grid than that of the axes, every cell of which has its ending; absent where it was not asked for."""
    flat_s: Span | None = None
    """When the part first lies flat on the plate, over the nodes [s]."""
    impact_speed_m_s: Span | None = None
    """Speed at which the plate is first struck, over the nodes where the part lies on it [m/s]; null where it
    never does.
    """
    junctions: list[RegionsJunction]
    """Where three or more outcomes meet."""
    labels: list[RegionsLabel]
    """The outcomes: same side, turned, face and its number, or how a run ends that never lies on the plate."""
    plate: str
    """The plate that is looked at."""
    run: StudyRun
    """What it took."""
    scene: str
    """Name of the scene."""
    unresolved_share: float
    """Share of the plane that was not looked into: cells that hold more than was followed when they were as
    small as allowed.
    """

"""Answers of `carom sweep`. Written by `generate.py` from its schema."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from carom._answer import Answer
from carom.answers.shared import (
    Approximation,
    StudyRun,
)


@dataclass(frozen=True, kw_only=True)
class Column:
    """A column of a table."""

    name: str
    """Its name."""
    unit: str
    """Its unit, SI; empty for words, counts and pure numbers."""


@dataclass(frozen=True, kw_only=True)
class Sweep(Answer):
    """The summary of a sweep."""

    approximations: list[Approximation] | None = None
    """How the computed part differs from the drawn one; absent where it does not."""
    columns: list[Column]
    """The columns of the part files, in their order."""
    designs: int
    """Designs in all."""
    endings: dict[str, int]
    """How often each ending occurs among the rows."""
    folder: str
    """Folder of the part files."""
    plate: str
    """The plate that is looked at."""
    rows: int
    """Designs whose rows are there, of all shards."""
    run: StudyRun
    """What this shard took: nothing for parts that were there."""
    scene: str
    """Name of the scene."""

"""Answers of `carom fit`. Written by `generate.py` from its schema."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from carom._answer import Answer
from carom.answers.shared import (
    Approximation,
    StudyRun,
)


@dataclass(frozen=True, kw_only=True)
class FitParameter:
    """A quantity that was fitted."""

    best: float
    """Where the likelihood is highest, of all points that are in the intervals of all quantities."""
    high: float
    """Upper end of its interval."""
    level: float
    """Probability that the interval holds it."""
    low: float
    """Lower end of its interval."""
    mean: float
    """Mean of the posterior."""
    median: float
    """It is as probably above as below this."""
    name: str
    """Its path in the scene."""
    range: list[float]
    """The range that was looked at, in which all values are equally likely before."""
    standard_deviation: float
    """Standard deviation of the posterior."""
    unit: str
    """SI unit of its values; empty for plain numbers."""


@dataclass(frozen=True, kw_only=True)
class FitScatter:
    """The standard deviation of measured times, where it was fitted."""

    best: float
    """Most probable [s]."""
    high: float
    """Upper end of its interval [s]."""
    low: float
    """Lower end of its interval [s]."""


@dataclass(frozen=True, kw_only=True)
class NotTold:
    """What the runs do not tell."""

    correlation: float | None = None
    """Correlation of two; null for one."""
    kind: Literal["range", "ridge"]
    """range: the interval of one is about as wide as without any run; ridge: the runs tell a combination of two,
    and neither alone.
    """
    parameters: list[str]
    """Paths of one quantity, or of two."""
    why: str
    """The same in words."""


@dataclass(frozen=True, kw_only=True)
class Fit(Answer):
    """The summary of a fit."""

    approximations: list[Approximation] | None = None
    """How the computed part differs from the drawn one; absent where it does not."""
    few_samples: bool
    """True where the engine's drops at a node are fewer than ten times those observed under one setting:
    intervals are then wider than the observed drops allow, and may miss by several of their widths where an
    outcome is rare.
    """
    likelihood: float
    """Natural logarithm of the highest likelihood: densities of times per second, counts without multinomial
    coefficients.
    """
    misfit: float | None = None
    """How far times of a known scatter are off the engine's at the best values, as a root mean square in
    standard deviations: about 1 where the scatter and the scene are right. Null without such times.
    """
    nodes: int
    """Nodes of the range that the engine was asked at."""
    not_told_apart: list[NotTold]
    """What the runs do not tell; empty where they tell all."""
    observed_drops: int
    """Drops that it tells of."""
    parameters: list[FitParameter]
    """What was fitted."""
    plate: str
    """The plate that is looked at."""
    resolved: bool
    """False where the budget of nodes ended first: intervals are then coarse."""
    run: StudyRun
    """What it took."""
    runs: str
    """The file of the runs."""
    samples: int
    """Drops of the engine at each node, under each condition."""
    scene: str
    """Name of the scene."""
    seed: int
    """What every random number comes from."""
    time_scatter_s: FitScatter | None = None
    """Standard deviation of the times; null where it was given, or nothing was timed."""

"""Motions of a body in space that were measured: thrown onto a plane."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np

from carom._progress import Progress, Told
from carom._tosses import tosses as followed
from carom.errors import CaromError
from carom.measured.profile import Array, Fitted, threshold

#: Points of each axis of the first look, and of each later one, which is half as wide.
FIRST, LATER = 9, 5
#: Later looks.
LOOKS = 4


@dataclass(frozen=True)
class MeasuredTosses:
    """Tosses of one body, each a motion at equal intervals of time. ``tosses[mask]`` is some of them."""

    body: dict[str, Any]
    """The body, with the keys of ``carom roll body``."""
    size: float
    """What errors of position are told as a share of [m]: its width."""
    interval: float
    """Between two poses [s]."""
    states: Sequence[Array]
    """Of each toss its poses and velocities, shape (count, 13): position (world), attitude (w, x, y, z), velocity (world), spin (body's axes); SI."""

    def __post_init__(self) -> None:
        wrong = [k for k, one in enumerate(self.states) if np.ndim(one) != 2 or np.shape(one)[1] != 13 or not np.all(np.isfinite(one))]
        wrong += [k for k, one in enumerate(self.states) if k not in wrong and not len(one)]
        if wrong or not len(self.states):
            raise CaromError(f"tosses {wrong}: rows of 13 numbers are expected" if wrong else "there are no tosses")
        turned = [k for k, one in enumerate(self.states) if np.any(np.abs(np.linalg.norm(np.asarray(one)[:, 3:7], axis=1) - 1) > 1e-3)]
        if turned:
            raise CaromError(f"tosses {turned}: attitudes are no unit quaternions")
        if not (self.size > 0 and self.interval > 0):
            raise CaromError(f"size {self.size} and interval {self.interval} must be above 0")

    def __len__(self) -> int:
        return len(self.states)

    def __getitem__(self, which: Any) -> MeasuredTosses:
        return replace(self, states=[self.states[k] for k in np.atleast_1d(np.arange(len(self))[which])])

    def errors(
        self, friction: float, restitution: float, *, law: Literal["poisson", "stronge"] = "poisson", progress: Progress = None
    ) -> TossErrors:
        """How far the engine's motion is from each measured one, from its first state on."""
        start = np.array([one[0] for one in self.states])
        longest = max(len(one) for one in self.states)
        found = followed(
            self.body, position=start[:, :3], attitude=start[:, 3:7], velocity=start[:, 7:10], spin=start[:, 10:], friction=friction,
            restitution=restitution, law=law, interval=self.interval, count=longest, progress=progress,
        )
        return self.errors_of(list(found.position), list(found.attitude))

    def errors_of(self, positions: Sequence[Array], attitudes: Sequence[Array]) -> TossErrors:
        """How far predicted motions are from the measured ones: whoever predicted them. A toss without a prediction has NaN."""
        short = [k for k, seen in enumerate(self.states) if k >= len(positions) or k >= len(attitudes) or min(len(positions[k]), len(attitudes[k])) < len(seen)]
        if short or len(positions) != len(self) or len(attitudes) != len(self):
            raise CaromError(f"tosses {short}: a pose is expected for each that was measured, and a motion for each of {len(self)} tosses")
        position, rotation = [], []
        for seen, places, turns in zip(self.states, positions, attitudes, strict=True):
            count = len(seen)
            position.append(np.linalg.norm(places[:count] - seen[:, :3], axis=1).mean() / self.size)
            lengths = np.linalg.norm(turns[:count], axis=1) * np.linalg.norm(seen[:, 3:7], axis=1)
            cosine = (np.abs((turns[:count] * seen[:, 3:7]).sum(axis=1)) / lengths).clip(0.0, 1.0)
            rotation.append(np.degrees(2 * np.arccos(cosine)).mean())
        return TossErrors(np.array(position), np.array(rotation))


@dataclass(frozen=True)
class TossErrors:
    """Errors of each toss, means over its instants (Acosta, Yang and Posa, arXiv 2110.00541)."""

    position: Array
    """Distance of the mass centres, as a share of the body's width."""
    rotation: Array
    """Angle between the attitudes [deg]."""

    def __str__(self) -> str:
        position, rotation = 100 * self.position, self.rotation
        lost = int(np.isnan(position).sum())
        if lost == len(position):
            return f"none of {lost} tosses could be followed"
        told = f"position {np.nanmean(position):.1f} ± {np.nanstd(position):.1f} %, rotation {np.nanmean(rotation):.1f} ± {np.nanstd(rotation):.1f}°"
        return told + (f" ({lost} of {len(position)} could not be followed)" if lost else "")


@dataclass(frozen=True)
class TossFit:
    """Friction and restitution that agree with measured tosses best."""

    parameters: list[Fitted]
    """``friction`` and ``restitution``."""
    level: float
    """Probability that an interval holds."""
    errors: TossErrors
    """Of the tosses that were fitted."""

    @property
    def friction(self) -> float:
        """The best."""
        return self.parameters[0].best

    @property
    def restitution(self) -> float:
        """The best."""
        return self.parameters[1].best


def fit_tosses(
    tosses: MeasuredTosses,
    *,
    friction: tuple[float, float] = (0.05, 0.6),
    restitution: tuple[float, float] = (0.0, 0.6),
    law: Literal["poisson", "stronge"] = "poisson",
    level: float = 0.95,
    progress: Progress = None,
) -> TossFit:
    """Which friction and restitution agree with measured tosses, within these ranges.

    Least squares of the errors of position, as if those of all tosses had one normal scatter that is not known. A toss depends on its start without
    measure once it tumbles, so no slope leads to the best: it is looked for on grids, each half as wide as the one before. An interval reaches to the nearest
    points that were looked at where −2 ln of the profile likelihood has risen more than χ² allows: it is no wider.

    ``progress`` hears how many points are done. Raises :class:`CaromError` where a range or the level is none.
    """
    try:
        ranges = np.array([friction, restitution], dtype=float).reshape(2, 2)
    except (TypeError, ValueError):
        raise CaromError(f"ranges of friction and restitution are expected, not {friction!r} and {restitution!r}") from None
    if not (np.all(np.isfinite(ranges)) and np.all(ranges[:, 0] < ranges[:, 1]) and np.all(ranges[:, 0] >= 0) and ranges[1, 1] <= 1):
        raise CaromError(f"ranges of friction and restitution are expected, not {friction!r} and {restitution!r}")
    allowed = threshold(level)
    seen: dict[tuple[float, float], float] = {}
    lost: set[int] = set()

    def look(points: Sequence[Array], hear: Callable[[int, int | None], object] | None) -> None:
        for x in points[0]:
            for y in points[1]:
                pair = (round(float(x), 9), round(float(y), 9))
                if pair not in seen:
                    squares = np.square(tosses.errors(*pair, law=law).position)
                    # A toss that cannot be followed says nothing against the others' constants: the pair is left out.
                    lost.update(np.flatnonzero(np.isnan(squares)).tolist())
                    seen[pair] = float(squares.sum()) if not np.isnan(squares).any() else np.inf
                    if hear is not None:
                        hear(len(seen), None)

    with Told(progress) as hear:
        look([np.linspace(low, high, FIRST) for low, high in ranges], hear)
        if not np.isfinite(min(seen.values())):
            raise CaromError(f"tosses {sorted(lost)} cannot be followed by the engine: leave them out")
        width = (ranges[:, 1] - ranges[:, 0]) / (FIRST - 1)
        for _ in range(LOOKS):
            best = np.array(min(seen, key=seen.__getitem__))
            look([np.clip(np.linspace(b - w, b + w, LATER), low, high) for b, w, (low, high) in zip(best, width, ranges, strict=True)], hear)
            width = width / 2
    best_pair = min(seen, key=seen.__getitem__)
    limit = seen[best_pair] * float(np.exp(allowed / len(tosses)))
    parameters = [Fitted(name, best_pair[k], *_interval(seen, k, best_pair[k], limit)) for k, name in enumerate(("friction", "restitution"))]
    return TossFit(parameters, level, tosses.errors(*best_pair, law=law))


def _interval(seen: dict[tuple[float, float], float], k: int, best: float, limit: float) -> tuple[float, float]:
    """The nearest values on both sides that are outside, whatever the other parameter is: the interval is no wider."""
    profile: dict[float, float] = {}
    for pair, squares in seen.items():
        profile[pair[k]] = min(squares, profile.get(pair[k], np.inf))
    outside = [value for value, squares in profile.items() if squares > limit]
    return (
        max((value for value in outside if value < best), default=min(profile)),
        min((value for value in outside if value > best), default=max(profile)),
    )

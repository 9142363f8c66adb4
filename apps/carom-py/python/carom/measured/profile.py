"""Least squares with intervals from the profile likelihood."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from carom.errors import CaromError, needed

Array = NDArray[np.float64]
#: Steps outwards before an end of an interval is given up.
MOST_STEPS = 30
#: Bisections of the last step: an end is located to a thousandth of it.
BISECTIONS = 10


@dataclass(frozen=True)
class Fitted:
    """A parameter that was fitted."""

    name: str
    """Its name: ``friction``, ``restitution``, ``restitution by incidence``."""
    best: float
    """Where what was measured is most probable."""
    low: float
    """The lower end of its interval."""
    high: float
    """The upper end."""


def optimizer() -> ModuleType:
    """SciPy's, or one clear error."""
    needed("fit", "scipy")
    import scipy.optimize

    return scipy.optimize  # type: ignore[no-any-return]


def threshold(level: float) -> float:
    """How far −2 ln of the likelihood may rise within an interval of one parameter: the quantile of χ² with one degree of freedom (Wilks 1938)."""
    if not 0 < level < 1:
        raise CaromError(f"level: {level!r} is not between 0 and 1")
    optimizer()
    from scipy.stats import chi2

    return float(chi2.ppf(level, 1))


class Least:
    """Residuals whose squares are least somewhere; their scatter is not known."""

    def __init__(self, residuals: Callable[[Array], Array], starts: list[Array], scale: Array, bounds: tuple[Array, Array]) -> None:
        self.residuals, self.scale, self.bounds = residuals, scale, bounds
        # Where a contact begins to stick the residuals have kinks, and minima beside the least one.
        self.best = min((self._solved(start, None, 0.0) for start in starts), key=self._squares)
        self.squares = self._squares(self.best)

    def _squares(self, x: Array) -> float:
        found = self.residuals(x)
        return float(found @ found)

    def _solved(self, x: Array, held: int | None, value: float) -> Array:
        """The others at their best where one parameter is held."""
        free = np.arange(len(x)) != held

        def whole(part: Array) -> Array:
            full = x.copy()
            full[free] = part
            if held is not None:
                full[held] = value
            return full

        if not free.any():
            return whole(np.empty(0))
        # Steps of the differences are far above the kinks where a contact begins to stick, far below what is looked for.
        solve: Any = optimizer().least_squares
        low, high = (bound[free] for bound in self.bounds)
        found = solve(lambda part: self.residuals(whole(part)), x[free], x_scale=self.scale[free], diff_step=1e-4, max_nfev=60, bounds=(low, high))
        return whole(found.x)

    def interval(self, k: int, level: float) -> tuple[float, float]:
        """Where −2 ln of the profile likelihood rises no further than the level allows, within what the parameter may be."""
        count = len(self.residuals(self.best))
        allowed = self.squares * float(np.exp(threshold(level) / count))
        low, high = (self._end(k, sign, allowed) for sign in (-1.0, 1.0))
        return low, high

    def _end(self, k: int, sign: float, allowed: float) -> float:
        inside, step, x = float(self.best[k]), 0.02 * float(self.scale[k]), self.best
        bound = float(self.bounds[0 if sign < 0 else 1][k])
        for _ in range(MOST_STEPS):
            outside = max(inside - step, bound) if sign < 0 else min(inside + step, bound)
            x = self._solved(x, k, outside)
            if self._squares(x) > allowed:
                break
            if outside == bound:
                return bound
            inside, step = outside, 1.6 * step
        else:
            return sign * np.inf
        for _ in range(BISECTIONS):
            middle = 0.5 * (inside + outside)
            if self._squares(self._solved(x, k, middle)) > allowed:
                outside = middle
            else:
                inside = middle
        return 0.5 * (inside + outside)

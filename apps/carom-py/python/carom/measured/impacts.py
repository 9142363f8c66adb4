"""Single impacts in the plane that were measured."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from carom._many import impacts as resolved
from carom.errors import CaromError
from carom.measured.profile import Array, Fitted, Least

#: What friction and restitution may depend on.
Feature = Literal["incidence", "approach", "slip", "lever"]
FEATURES: dict[Feature, str] = {
    "incidence": "the angle of the contact's velocity to the normal [rad]",
    "approach": "the speed at which the contact approaches [m/s]",
    "slip": "the speed at which it slips [m/s]",
    "lever": "how far the contact lies ahead of the mass centre in the direction of its slip, by the radius of gyration",
}


@dataclass(frozen=True)
class MeasuredImpacts:
    """Impacts of a free planar body at one contact, one a row; SI, world axes. ``impacts[mask]`` is some of them."""

    mass: float
    """[kg]."""
    inertia: float
    """About the mass centre [kg m²]."""
    arm: Array
    """From the mass centre to the contact [m], shape (n, 2)."""
    velocity: Array
    """Of the mass centre before [m/s], shape (n, 2)."""
    spin: Array
    """Before [rad/s], shape (n,)."""
    velocity_after: Array
    """Of the mass centre after [m/s], shape (n, 2)."""
    spin_after: Array
    """After [rad/s], shape (n,)."""
    normal: Array
    """Out of the obstacle, unit, shape (n, 2)."""

    def __post_init__(self) -> None:
        for one in fields(self):
            try:
                value = np.asarray(getattr(self, one.name), dtype=float)
            except (TypeError, ValueError) as error:
                raise CaromError(f"{one.name}: {error}") from None
            object.__setattr__(self, one.name, float(value) if value.ndim == 0 and one.name in ("mass", "inertia") else value)
        if np.ndim(self.spin) != 1:
            raise CaromError(f"spin has the shape {np.shape(self.spin)}, not one number a row")
        shapes = {one.name: np.shape(getattr(self, one.name)) for one in fields(self)}
        rows = len(self.spin)
        wrong = [f"{name} has the shape {shape}" for name, shape in shapes.items() if shape != self._shape(name, rows)]
        bad = [name for name in shapes if not np.all(np.isfinite(getattr(self, name)))]
        if wrong or bad or rows == 0:
            raise CaromError("; ".join([*wrong, *(f"{name} holds what is no number" for name in bad)]) or "there are no impacts")
        if not (self.mass > 0 and self.inertia > 0):
            raise CaromError(f"mass {self.mass} and inertia {self.inertia} must be above 0")
        if not np.all(np.any(self.velocity != 0, axis=1) | (self.spin != 0)):
            raise CaromError("velocity: an impact of a body that does not move has no error as a share of the motion before")

    @staticmethod
    def _shape(name: str, rows: int) -> tuple[int, ...]:
        return () if name in ("mass", "inertia") else (rows,) if name in ("spin", "spin_after") else (rows, 2)

    def __len__(self) -> int:
        return len(self.spin)

    def __getitem__(self, which: Any) -> MeasuredImpacts:
        which = np.atleast_1d(np.arange(len(self))[which])
        chosen = {one.name: getattr(self, one.name)[which] for one in fields(self) if one.name not in ("mass", "inertia")}
        return replace(self, **chosen)

    def feature(self, name: Feature) -> Array:
        """A number of each impact, from the motion before it: see :data:`FEATURES`."""
        along = np.stack([self.normal[:, 1], -self.normal[:, 0]], axis=1)
        contact = self.velocity + self.spin[:, None] * np.stack([-self.arm[:, 1], self.arm[:, 0]], axis=1)
        approach, slip = -(contact * self.normal).sum(axis=1), (contact * along).sum(axis=1)
        lever = (self.arm * along).sum(axis=1) * np.sign(slip) / np.sqrt(self.inertia / self.mass)
        found: dict[Feature, Array] = {"incidence": np.arctan2(np.abs(slip), approach), "approach": approach, "slip": np.abs(slip), "lever": lever}
        return found[name]

    def differences(self, friction: ArrayLike, restitution: ArrayLike, law: Literal["poisson", "stronge", "newton"] = "poisson") -> Array:
        """What the engine says after each impact less what was measured, shape (n, 3), in the metric of the kinetic energy and as a share of the motion
        before: the length of a row is the square root of the energy of the difference by the energy before."""
        table = resolved(
            mass=self.mass, inertia=self.inertia, arm=self.arm, normal=self.normal, velocity=self.velocity, spin=self.spin,
            friction=friction, restitution=restitution, law=law,
        )
        masses = np.sqrt([self.mass, self.mass, self.inertia])
        before = np.linalg.norm(np.column_stack([self.velocity, self.spin]) * masses, axis=1)
        after = np.column_stack([table["velocity_x_m_s"], table["velocity_y_m_s"], table["spin_rad_s"]])
        seen = np.column_stack([self.velocity_after, self.spin_after])
        found: Array = (after - seen) * masses / before[:, None]
        return found

    def unexplained(self) -> float:
        """What is left of the change of motion where any impulse at the contact is allowed: the mean length of a row of :meth:`differences`. No law can do better."""
        masses = np.sqrt([self.mass, self.mass, self.inertia])
        columns = np.zeros((len(self), 3, 2))
        columns[:, 0, 0] = columns[:, 1, 1] = 1 / self.mass
        columns[:, 2, 0], columns[:, 2, 1] = -self.arm[:, 1] / self.inertia, self.arm[:, 0] / self.inertia
        columns *= masses[:, None]
        change = np.column_stack([self.velocity_after - self.velocity, self.spin_after - self.spin]) * masses
        impulse = np.linalg.solve(np.swapaxes(columns, 1, 2) @ columns, (np.swapaxes(columns, 1, 2) @ change[:, :, None]))
        left = np.linalg.norm((columns @ impulse)[:, :, 0] - change, axis=1)
        before = np.linalg.norm(np.column_stack([self.velocity, self.spin]) * masses, axis=1)
        return float((left / before).mean())


@dataclass(frozen=True)
class ImpactFit:
    """Friction and restitution that agree with measured impacts best."""

    parameters: list[Fitted]
    """``friction`` and ``restitution`` of a mean impact, then how they change by each feature."""
    level: float
    """Probability that an interval holds."""
    error: float
    """The mean of what the engine says less what was measured, as :meth:`MeasuredImpacts.differences` has it."""
    law: Literal["poisson", "stronge", "newton"]
    """The law of restitution."""
    friction_by: tuple[Feature, ...]
    """What friction depends on."""
    restitution_by: tuple[Feature, ...]
    """What restitution depends on."""
    middle: dict[Feature, float]
    """The mean of each feature among the impacts that were fitted."""

    def contact(self, impacts: MeasuredImpacts) -> tuple[Array, Array]:
        """Friction and restitution of each impact."""
        return _contact(impacts, np.array([one.best for one in self.parameters]), (self.friction_by, self.restitution_by), self.middle)

    def error_of(self, impacts: MeasuredImpacts) -> float:
        """The mean difference for other impacts, those that were held out say."""
        return float(np.linalg.norm(impacts.differences(*self.contact(impacts), self.law), axis=1).mean())


def _contact(impacts: MeasuredImpacts, x: Array, by: tuple[Sequence[Feature], Sequence[Feature]], middle: dict[Feature, float]) -> tuple[Array, Array]:
    """Friction and restitution of each impact: linear in the features, cut where they are none."""
    found, at = [], 2
    for k, features in enumerate(by):
        value = np.full(len(impacts), x[k])
        for name in features:
            value += x[at] * (impacts.feature(name) - middle[name])
            at += 1
        found.append(value)
    friction, restitution = found
    return np.maximum(friction, 0.0), np.clip(restitution, 0.0, 1.0)


def _features(given: Sequence[Feature] | Feature) -> tuple[Feature, ...]:
    """Features as they are given: one alone, or several."""
    return (given,) if isinstance(given, str) else tuple(given)


def fit_impacts(
    impacts: MeasuredImpacts,
    *,
    friction_by: Sequence[Feature] | Feature = (),
    restitution_by: Sequence[Feature] | Feature = (),
    law: Literal["poisson", "stronge", "newton"] = "poisson",
    level: float = 0.95,
) -> ImpactFit:
    """Which friction and restitution agree with measured impacts: constants, or linear in what the motion before says (:data:`FEATURES`).

    Least squares of :meth:`MeasuredImpacts.differences`, as if all of them had one normal scatter that is not known; the interval of a parameter is where
    −2 ln of its profile likelihood rises no more than χ² allows, cut at what friction and restitution may be. An interval that is all of that says that the impacts
    tell nothing of the parameter.

    Raises :class:`CaromError` where a feature is none, a level is none, SciPy is not there, or fewer rows are given than parameters.

    >>> import numpy as np
    >>> from carom.measured import MeasuredImpacts, fit_impacts
    >>> import carom
    >>> n = 60
    >>> x = np.linspace(-0.3, 0.3, n)
    >>> before = {"velocity": np.column_stack([np.linspace(0.1, 2, n), -np.ones(n)]), "spin": np.linspace(-3, 3, n), "arm": np.column_stack([x, -0.1 - 0 * x])}
    >>> after = carom.impacts(mass=1, inertia=0.02, friction=0.2, restitution=0.6, **before)
    >>> velocity = np.column_stack([after["velocity_x_m_s"], after["velocity_y_m_s"]])
    >>> seen = MeasuredImpacts(1.0, 0.02, velocity_after=velocity, spin_after=after["spin_rad_s"], normal=np.tile([0.0, 1.0], (n, 1)), **before)
    >>> fit = fit_impacts(seen)
    >>> [round(one.best, 3) for one in fit.parameters]
    [0.2, 0.6]
    """
    by = (_features(friction_by), _features(restitution_by))
    twice = [name for features in by for name in features if features.count(name) > 1]
    if twice:
        raise CaromError(f"{twice[0]!r} is named twice: its two parameters could not be told apart")
    wrong = [name for features in by for name in features if name not in FEATURES]
    if wrong:
        raise CaromError(f"{', '.join(map(repr, wrong))}: a feature is one of {', '.join(FEATURES)}")
    names = ["friction", "restitution", *(f"friction by {name}" for name in by[0]), *(f"restitution by {name}" for name in by[1])]
    if len(impacts) < len(names):
        raise CaromError(f"{len(impacts)} impacts are too few for {len(names)} parameters")
    middle: dict[Feature, float] = {name: float(impacts.feature(name).mean()) for features in by for name in features}
    spread = [max(float(impacts.feature(name).std()), 1e-12) for features in by for name in features]

    def residuals(x: Array) -> NDArray[np.float64]:
        return impacts.differences(*_contact(impacts, x, by, middle), law).ravel()

    rest = [0.0] * len(spread)
    starts = [np.array([friction, restitution, *rest]) for friction in (0.03, 0.3, 0.9) for restitution in (0.1, 0.5, 0.9)]
    scale = np.array([0.3, 0.3, *(0.1 / one for one in spread)])
    free = np.full(len(spread), np.inf)
    bounds = (np.array([0.0, 0.0, *-free]), np.array([np.inf, 1.0, *free]))
    least = Least(residuals, starts, scale, bounds)
    parameters = [Fitted(name, float(least.best[k]), *least.interval(k, level)) for k, name in enumerate(names)]
    error = float(np.linalg.norm(least.residuals(least.best).reshape(-1, 3), axis=1).mean())
    return ImpactFit(parameters, level, error, law, *by, middle)

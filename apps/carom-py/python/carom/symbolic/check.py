"""Formulas beside the engine: the same problem at random numbers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp

from carom._one import impact
from carom.answers.impact import PlanarImpact
from carom.symbolic.derivation import Derivation, Derivations
from carom.symbolic.numbers import Numbers
from carom.symbolic.problem import SymbolicProblem

#: Draws whose least slack is below this share of its terms lie on a border, where rounding decides: they are left out.
BORDER = 1e-6
#: Up to which relative difference of velocities two motions are taken for the same one.
SAME_MOTION = 1e-6

#: Makes so many draws: values of every symbol by its name.
Draws = Callable[[np.random.Generator, int], Mapping[str, Any]]


@dataclass(frozen=True)
class Agreement:
    """A formula beside the engine."""

    title: str
    draws: int
    """Random numbers at which the hypothesis holds by its formulas."""
    found: int
    """At how many of them the engine has an end state with this motion."""
    velocity: float
    """Worst difference of a velocity, as a share of the largest velocity of the contacts."""
    impulse: float
    """Worst difference of an impulse, as a share of the largest; of those that are determined."""
    missed: tuple[Mapping[str, float], ...] = ()
    """Some numbers at which it has none."""


def _file(problem: SymbolicProblem, plain: Callable[[Any], Any]) -> dict[str, Any]:
    """The keys of an impact file with each value as ``plain`` makes it."""
    def vector(many: Iterable[Any]) -> list[Any]:
        return [plain(one) for one in many]

    out: dict[str, Any] = {"law": problem.law}
    if problem.operator is not None:
        matrix, velocity = problem.operator
        rows, size, count = vector(velocity), problem.axes, len(problem.contacts)
        operator = {"matrix": [[plain(matrix[i, j]) for j in range(matrix.shape[1])] for i in range(matrix.shape[0])]}
        operator["velocity"] = [rows[size * k : size * (k + 1)] for k in range(count)] if problem.space else rows
        return out | {"operator": operator | {key: [plain(getattr(one, key)) for one in problem.contacts] for key in ("friction", "restitution")}}
    several = len(problem.bodies) > 1 or problem.contacts[0].out_of is not None
    bodies = []
    for body in problem.bodies:
        spin = vector(body.spin) if problem.space else plain(body.spin[0])
        table: dict[str, Any] = {"velocity": vector(body.velocity), "spin": spin}
        if not body.fixed:
            table |= {"mass": plain(body.mass), "inertia": vector(body.inertia) if problem.space else plain(body.inertia[0])}
        if several:
            table |= {"name": body.name, "kind": "fixed"} if body.fixed else {"name": body.name, "centre": vector(body.centre)}
        bodies.append(table)
    contacts: list[dict[str, Any]] = []
    for one in problem.contacts:
        contact = {"name": one.name, "point": vector(one.point), "normal": vector(one.normal), "friction": plain(one.friction), "restitution": plain(one.restitution)}
        contacts.append(contact | ({"between": [problem.bodies[one.into].name, problem.bodies[one.out_of].name]} if one.out_of is not None else {}))
    return out | {"body": bodies if several else bodies[0], "contact": contacts}


class Files:
    """Impact files of one problem, quickly at many numbers."""

    def __init__(self, problem: SymbolicProblem) -> None:
        self.problem = problem
        self.names = [symbol.name for symbol in problem.symbols]
        expressions: list[Any] = []

        def collect(one: Any) -> int:
            expressions.append(sp.sympify(one))
            return len(expressions) - 1

        self.pattern = _file(problem, collect)
        self.made = sp.lambdify(problem.symbols, expressions, "math")

    def at(self, values: Mapping[str, float]) -> dict[str, Any]:
        """The file at these values."""
        numbers = self.made(*[float(values[name]) for name in self.names])
        return {key: _filled(one, numbers) for key, one in self.pattern.items()}


def _filled(pattern: Any, numbers: Sequence[float]) -> Any:
    if isinstance(pattern, dict):
        return {key: _filled(one, numbers) for key, one in pattern.items()}
    if isinstance(pattern, list):
        return [_filled(one, numbers) for one in pattern]
    return float(numbers[pattern]) if isinstance(pattern, int) else pattern


def against_engine(derivation: Derivation, draws: Draws, count: int, *, seed: int = 1, non_sliding: bool = False, at_most: int = 200) -> Agreement:
    """Compares a derivation with :func:`carom.impact` at ``count`` random draws at which it holds.

    ``non_sliding``: with the engine's states of the law under which nothing slides. At most ``at_most`` batches of draws are made; where the
    hypothesis holds rarely there are fewer comparisons, and :attr:`Agreement.draws` says how many. Draws must be impacts that the engine takes.

    Where the motion depends on impulses that stay open the engine takes one share of them: those draws are compared in which its end state is of this
    hypothesis, with the share that fits.
    """
    random = np.random.default_rng(seed)
    files, done, found = Files(derivation.problem), 0, 0
    worst, missed, family = [0.0, 0.0], [], moves_freely(derivation)
    for _ in range(at_most):
        given = {name: np.asarray(value, dtype=float) for name, value in draws(random, max(count, 1000)).items()}
        numbers = derivation.at(given)
        for i in np.flatnonzero(numbers.holds & (numbers.slack > BORDER)):
            if done == count:
                break
            one = {name: float(value[i]) for name, value in given.items()}
            file = files.at(one)
            near = _of_family(derivation, one, file) if family else _nearest(derivation, numbers, int(i), file, non_sliding)
            if family and near is None:
                continue
            done += 1
            if near is None or near[0] > SAME_MOTION:
                missed.append(one)
                continue
            found += 1
            worst = [max(a, b) for a, b in zip(worst, near)]
        if done == count:
            break
    return Agreement(derivation.title, done, found, worst[0], worst[1], tuple(missed[:5]))


@dataclass(frozen=True)
class _End:
    """An end state of the engine, contact by contact."""

    hypothesis: str
    velocity: Any
    impulse: Any
    open: bool


def _nearest(derivation: Derivation, numbers: Numbers, i: int, file: dict[str, Any], non_sliding: bool) -> tuple[float, float] | None:
    """How far the engine's nearest end state is: in velocities, and in those impulses that are not open."""
    ends = list(_ends(file, non_sliding))
    if not ends:
        return None
    names = [contact.name for contact in derivation.problem.contacts]
    velocity = np.array([numbers.velocity[name][:, i] for name in names])
    impulse = np.array([numbers.impulse[name][:, i] for name in names])
    if non_sliding:
        normals = np.array([[float(one) for one in contact["normal"]] for contact in file["contact"]])
        velocity, impulse = (velocity * normals).sum(axis=1), (impulse * normals).sum(axis=1)
    speed = max(float(np.abs(velocity).max()), max(float(np.abs(end.velocity).max()) for end in ends), _speed(file))
    off, best = min(((float(np.abs(velocity - end.velocity).max()) / speed, end) for end in ends), key=lambda pair: pair[0])
    largest = float(np.abs(best.impulse).max())
    settled = _settled(derivation, non_sliding)
    return off, 0.0 if not settled.any() or largest == 0 else float(np.abs(impulse - best.impulse)[settled].max()) / largest


def _settled(derivation: Derivation, non_sliding: bool) -> Any:
    """Which components of impulses do not depend on those that stay open: the normal ones alone where nothing slides."""
    made: dict[str, Any] = derivation.__dict__.setdefault("_settled", {})
    if not made:
        every = [[one.normal_impulse] if non_sliding else list(one.impulse) for one in derivation.contacts]
        made["mask"] = np.array([[not (derivation.free and part.has(*derivation.free)) for part in one] for one in every])
    return made["mask"][:, 0] if non_sliding else made["mask"]


def _of_family(derivation: Derivation, one: Mapping[str, float], file: dict[str, Any]) -> tuple[float, float] | None:
    """The same of a family of motions; None where the engine has no end state of this hypothesis."""
    ends = [end for end in _ends(file, False) if end.hypothesis == derivation.hypothesis]
    return min(((_fitted(derivation, one, end, max(float(np.abs(end.velocity).max()), _speed(file))), 0.0) for end in ends), default=None)


def moves_freely(derivation: Derivation) -> bool:
    """True where the motion depends on impulses that stay open: restitution multiplies those of compression."""
    algebra = derivation.mechanics.algebra
    return any(algebra.plain(one.numer).has(*derivation.free) for one in derivation.phases[-1].velocity if derivation.free and one)


def _fitted(derivation: Derivation, one: Mapping[str, float], end: _End, speed: float) -> float:
    """How far an end state is from a motion of the family, for the open impulses that come nearest; infinite where the hypothesis does not hold for them."""
    free = [symbol.name for symbol in derivation.free]
    basis = {name: np.array([0.0, *[float(name == other) for other in free]]) for name in free}
    names = [contact.name for contact in derivation.problem.contacts]

    def velocity(values: Mapping[str, Any]) -> tuple[Any, Numbers]:
        found = derivation.at({**one, **values})
        return np.concatenate([found.velocity[name] for name in names]), found

    table, _ = velocity(basis)
    # Impulses are of the size of those that the engine has.
    chosen = np.linalg.lstsq(table[:, 1:] - table[:, :1], end.velocity.ravel() - table[:, 0], rcond=None)[0]
    moved, found = velocity(dict(zip(free, chosen)))
    return float(np.abs(moved[:, 0] - end.velocity.ravel()).max()) / speed if found.slack[0] > -BORDER else np.inf


def _speed(file: dict[str, Any]) -> float:
    """Speeds before: what differences are small against, where a motion stops."""
    if "operator" in file:
        return float(np.abs(np.array(file["operator"]["velocity"], dtype=float)).max())
    bodies = file["body"] if isinstance(file["body"], list) else [file["body"]]
    return max(float(np.abs(np.array(one["velocity"], dtype=float)).max()) for one in bodies)


def _ends(file: dict[str, Any], non_sliding: bool) -> Iterable[_End]:
    """The end states of the engine."""
    answer = impact(file)
    if isinstance(answer, PlanarImpact):
        for end in answer.end_states:
            velocity = np.array([[one.slip_m_s, one.normal_velocity_m_s] for one in end.contacts])
            yield _End(end.hypothesis, velocity, np.array([[one.tangential_impulse_N_s, one.normal_impulse_N_s] for one in end.contacts]), end.indeterminate)
    elif non_sliding:
        for kept in answer.non_sliding:
            yield _End(kept.hypothesis, np.array(kept.normal_velocities_m_s), np.array(kept.normal_impulses_N_s), False)
    elif answer.end is not None:
        velocity = np.array([one.velocity_m_s for one in answer.end.contacts])
        yield _End("", velocity, np.array([one.impulse_N_s for one in answer.end.contacts]), answer.end.open != "nothing")


def all_found(derivations: Derivations, draws: Draws, count: int, *, seed: int = 1) -> tuple[int, list[dict[str, float]]]:
    """The other way round: of how many end states of the engine (in the plane) there is a derivation, and numbers at which one is missing."""
    random = np.random.default_rng(seed)
    given = {name: np.asarray(value, dtype=float) for name, value in draws(random, count).items()}
    files = Files(derivations.kept[0].problem)
    evaluated = [(one, one.at(given), moves_freely(one)) for one in derivations.kept]
    matched, missed = 0, []
    for i in range(count):
        one = {name: float(value[i]) for name, value in given.items()}
        if any(abs(numbers.slack[i]) < BORDER for _, numbers, _ in evaluated):
            continue
        file = files.at(one)
        for end in _ends(file, False):
            speed = max(float(np.abs(end.velocity).max()), _speed(file))
            if any(_off(derivation, numbers, i, free, one, end, speed) <= SAME_MOTION for derivation, numbers, free in evaluated if numbers.holds[i]):
                matched += 1
            else:
                missed.append(one)
    return matched, missed


def _off(derivation: Derivation, numbers: Numbers, i: int, free: bool, one: Mapping[str, float], end: _End, speed: float) -> float:
    if free:
        return _fitted(derivation, one, end, speed)
    velocity = np.array([numbers.velocity[contact.name][:, i] for contact in derivation.problem.contacts])
    return float(np.abs(velocity - end.velocity).max()) / speed

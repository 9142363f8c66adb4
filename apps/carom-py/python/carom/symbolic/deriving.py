"""From a problem to its derivations: which phases there are, which hypotheses, and which of them can hold."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp

from carom._given import FileLike
from carom.errors import CaromError, Problem
from carom.symbolic.assumptions import Assumptions, properties_of
from carom.symbolic.derivation import Derivation, Derivations
from carom.symbolic.emptiness import Asked, Existence, exists
from carom.symbolic.hypothesis import Hypothesis, HypothesisLike, every, parse
from carom.symbolic.mechanics import Mechanics, impulse_symbols, normal_symbol
from carom.symbolic.problem import problem_of
from carom.symbolic.solution import PhaseSolution, solve_phase
from carom.symbolic.tidy import reduced

_NOT_ASKED = Existence("unknown", "it was not asked")


class Deriver:
    """Derives hypotheses of one problem."""

    def __init__(self, problem: FileLike, assume: Sequence[Any], non_sliding: bool, discard: bool, seconds: float) -> None:
        known = {symbol for one in assume if not isinstance(one, str) for symbol in sp.sympify(one).free_symbols}
        self.problem = problem_of(problem, known=known, properties=properties_of(assume))
        self._names_are_free()
        self.mechanics = Mechanics(self.problem, Assumptions(self.problem, assume))
        self.non_sliding, self.discard, self.seconds = non_sliding, discard, seconds
        self.zero = self.mechanics.algebra.field.zero
        bounces = any(self.mechanics.restitution) and not non_sliding
        self.newton = self.problem.law == "newton" and bounces
        self.two_phases = self.problem.law == "poisson" and bounces
        if self.problem.space and self.newton and len(self.problem.contacts) > 1:
            message = "law = newton is for one contact in space"
            raise CaromError(f"law: {message}", [Problem(message, kind="unsupported", path="law", key="law")])

    def _names_are_free(self) -> None:
        """Raises :class:`carom.CaromError` where a symbol has the name of an impulse."""
        own = {symbol.name for k in range(self.count) for phase in (1, 2) for symbol in (*impulse_symbols(self.problem, k, phase), normal_symbol(self.problem, k, phase))}
        taken = [symbol.name for symbol in self.problem.symbols if symbol.name in own]
        if taken:
            problems = [Problem(f"{name} is the name of an impulse: call the symbol otherwise", kind="name", path=name, key=name) for name in taken]
            raise CaromError("\n".join(one.message for one in problems), problems)

    @property
    def count(self) -> int:
        """How many contacts there are."""
        return len(self.problem.contacts)

    def first(self, hypothesis: Hypothesis) -> tuple[PhaseSolution, list[Any]]:
        """The one phase, or compression; and the normal velocities that Newton's law adds."""
        drive, bounce = list(self.mechanics.before), [self.zero] * self.count
        if self.newton:
            bounce = [self._bounce(k) for k in range(self.count)]
            drive = self._with(drive, bounce, 1)
        solved = solve_phase(self.mechanics, hypothesis, drive, [self.zero] * self.count, "compression")
        if self.newton and solved.contradiction is None:
            solved = PhaseSolution(solved.impulse, self._with(solved.velocity, bounce, -1), solved.conditions, solved.free)
        return solved, bounce

    def _with(self, velocity: list[Any], bounce: list[Any], sign: int) -> list[Any]:
        size, out = self.problem.axes, list(velocity)
        for k, normal in enumerate(self.mechanics.normals):
            for i, n in enumerate(normal):
                out[size * k + i] = self.mechanics.algebra.tidy(out[size * k + i] + sign * n * bounce[k])
        return out

    def normal_part(self, vector: list[Any], k: int) -> Any:
        """Along the normal of a contact."""
        size = self.problem.axes
        return self.mechanics.algebra.sum(a * b for a, b in zip(self.mechanics.normals[k], vector[size * k : size * (k + 1)]))

    def _bounce(self, k: int) -> Any:
        """Restitution times the approach, if it approaches."""
        algebra = self.mechanics.algebra
        normal = self.normal_part(self.mechanics.before, k)
        sign, unknown = reduced(algebra, normal)
        if not unknown:
            return algebra.tidy(self.mechanics.restitution[k] * normal) if sign < 0 else self.zero
        can = {which: exists(algebra, [Asked(which * normal, "")], seconds=self.seconds).verdict for which in (1, -1)}
        if can[1] in ("empty", "border"):
            return algebra.tidy(self.mechanics.restitution[k] * normal)
        if can[-1] in ("empty", "border"):
            return self.zero
        name = self.problem.contacts[k].name
        message = f"by Newton's law it must be known whether {name} approaches: assume it"
        raise CaromError(message, [Problem(message, kind="missing_key", path="assume")])

    def second(self, first: PhaseSolution, hypothesis: Hypothesis) -> PhaseSolution:
        """Restitution after this compression."""
        return solve_phase(self.mechanics, hypothesis, first.velocity, self.owed(first), "restitution")

    def owed(self, first: PhaseSolution) -> list[Any]:
        """Normal impulses that restitution owes."""
        return [self.mechanics.algebra.tidy(e * self.normal_part(first.impulse, k)) for k, e in enumerate(self.mechanics.restitution)]

    def loaded(self, first: PhaseSolution) -> list[bool]:
        """Which contacts restitution owes an impulse."""
        return [bool(one) for one in self.owed(first)]

    def made(self, compression: Hypothesis, restitution: Hypothesis | None, phases: tuple[PhaseSolution, ...], bounce: list[Any]) -> Derivation:
        """A derivation, and whether it can hold."""
        return Derivation(self.mechanics, compression, restitution, phases, self.existence((compression, restitution), phases), tuple(bounce))

    def existence(self, hypotheses: tuple[Hypothesis | None, ...], phases: tuple[PhaseSolution, ...]) -> Existence:
        """Whether a hypothesis can hold."""
        if any(phase.contradiction is not None for phase in phases):
            return Existence("empty", "its equations contradict each other")
        if not self.discard:
            return _NOT_ASKED
        conditions = [condition for phase in phases for condition in phase.conditions]
        still = next((one for one in conditions if one.kind == "slip_direction" and not one.number), None)
        if still is not None:
            return Existence("border", f"{still.contact} would not slip: it is the border of the hypothesis in which it sticks")
        return exists(self.mechanics.algebra, [Asked(one.number, one.meaning, one.equation) for one in conditions], seconds=self.seconds)


def derive_one(
    problem: FileLike, hypothesis: HypothesisLike, restitution: HypothesisLike | None, assume: Sequence[Any], non_sliding: bool, discard: bool, seconds: float
) -> Derivation:
    """One hypothesis. See :func:`carom.derive`."""
    deriver = Deriver(problem, assume, non_sliding, discard, seconds)
    compression = parse(hypothesis, deriver.problem, loaded=[False] * deriver.count, non_sliding=non_sliding)
    first, bounce = deriver.first(compression)
    if restitution is None:
        if deriver.two_phases and first.contradiction is None:
            message = "there is restitution: say what each contact does in it, or call without a hypothesis"
            raise CaromError(f"restitution: {message}", [Problem(message, kind="missing_key", path="restitution", key="restitution")])
        return deriver.made(compression, None, (first,), bounce)
    if not deriver.two_phases:
        message = "no contact has restitution by Poisson's law"
        raise CaromError(f"restitution: {message}", [Problem(message, kind="unsupported", path="restitution", key="restitution")])
    if first.contradiction is not None:
        return deriver.made(compression, None, (first,), bounce)
    second_hypothesis = parse(restitution, deriver.problem, loaded=deriver.loaded(first), path="restitution")
    return deriver.made(compression, second_hypothesis, (first, deriver.second(first, second_hypothesis)), bounce)


def derive_all(problem: FileLike, restitution: HypothesisLike | None, assume: Sequence[Any], non_sliding: bool, discard: bool, seconds: float) -> Derivations:
    """Every hypothesis. See :func:`carom.derive`."""
    deriver = Deriver(problem, assume, non_sliding, discard, seconds)
    kept: list[Derivation] = []
    discarded: list[Derivation] = []
    for one in _each(deriver, restitution):
        if one.contradiction is not None or (discard and one.existence.verdict in ("empty", "border")):
            discarded.append(one)
            continue
        twin = next((other for other in kept if discard and _same(one, other) and _within(deriver, one, other)), None)
        if twin is None:
            kept.append(one)
            continue
        same = Existence("border", f"it is the same motion as {twin.title}, which holds wherever this does")
        discarded.append(Derivation(one.mechanics, one.compression, one.restitution, one.phases, same, one.bounce))
    return Derivations(tuple(kept), tuple(discarded))


def _each(deriver: Deriver, restitution: HypothesisLike | None) -> Iterator[Derivation]:
    for compression in every(deriver.problem, [False] * deriver.count, non_sliding=deriver.non_sliding):
        first, bounce = deriver.first(compression)
        alone = deriver.made(compression, None, (first,), bounce)
        if not deriver.two_phases or alone.existence.verdict in ("empty", "border"):
            yield alone
            continue
        loaded = deriver.loaded(first)
        several = every(deriver.problem, loaded) if restitution is None else [parse(restitution, deriver.problem, loaded=loaded, path="restitution")]
        for second in several:
            yield deriver.made(compression, second, (first, deriver.second(first, second)), bounce)


def _same(one: Derivation, other: Derivation) -> bool:
    """The same impulses and velocities, whatever the contacts are said to do."""
    if one.contradiction is not None or one.free or other.free:
        return False
    return one.impulse_numbers == other.impulse_numbers and one.phases[-1].velocity == other.phases[-1].velocity


def _within(deriver: Deriver, one: Derivation, other: Derivation) -> bool:
    """True where the other holds wherever this one does."""
    algebra = deriver.mechanics.algebra
    own = [Asked(condition.number, condition.meaning, condition.equation) for condition in one.conditions]
    broken = (Asked(-condition.number, "", condition.equation) for condition in other.conditions)
    return all(exists(algebra, [*own, each], seconds=deriver.seconds).verdict in ("empty", "border") for each in broken)

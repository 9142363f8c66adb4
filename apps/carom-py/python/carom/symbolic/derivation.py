"""What is derived: a hypothesis with all that follows from it, and several hypotheses of one problem."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from carom.symbolic.emptiness import Existence
from carom.symbolic.elimination import without
from carom.symbolic.equations import Equation, momentum, of_contacts
from carom.symbolic.hypothesis import Hypothesis, said
from carom.symbolic.mechanics import Mechanics
from carom.symbolic.problem import SymbolicProblem
from carom.symbolic.solution import Condition, PhaseSolution
from carom.symbolic.tidy import short

if TYPE_CHECKING:
    from carom.symbolic.numbers import Numbers


@dataclass(frozen=True, eq=False)
class DerivedContact:
    """One contact after the impact; names are those of the engine's answers, without units."""

    name: str
    state: str
    """What it does: ``separates``, ``sticks``, ``slips+``, …"""
    normal_impulse: Any
    """Normal impulse on the body."""
    normal_velocity: Any
    """Normal velocity after."""
    impulse: tuple[Any, ...]
    """The whole impulse: tangential and normal in the plane, along the axes of the file in space."""
    velocity: tuple[Any, ...]
    """The whole velocity after: slip and normal velocity in the plane, along the axes of the file in space."""
    space: bool

    @property
    def tangential_impulse(self) -> Any:
        """Tangential impulse on the body, in the plane."""
        return self._first(self.impulse)

    @property
    def slip(self) -> Any:
        """Slip after, in the plane."""
        return self._first(self.velocity)

    def _first(self, pair: tuple[Any, ...]) -> Any:
        if self.space:
            raise AttributeError("in space impulse and velocity are vectors along the axes of the file")
        return pair[0]


@dataclass(frozen=True, eq=False)
class DerivedBody:
    """One body after the impact."""

    name: str
    velocity: tuple[Any, ...]
    """Velocity of its mass centre after."""
    spin: Any
    """Spin after: a number in the plane, a vector in space."""


@dataclass(frozen=True, eq=False)
class Derivation:
    """A hypothesis and what follows from it, in closed form. Made by :func:`carom.derive`."""

    mechanics: Mechanics
    compression: Hypothesis
    restitution: Hypothesis | None
    phases: tuple[PhaseSolution, ...]
    existence: Existence
    """Whether it can hold at all, within what is assumed."""
    bounce: tuple[Any, ...] = ()
    """By Newton's law: the normal velocities that are added to those of the equations."""

    @property
    def problem(self) -> SymbolicProblem:
        """What was given."""
        return self.mechanics.problem

    @property
    def hypothesis(self) -> str:
        """In the words of the engine's answers; of two phases that of the end."""
        return said(self.problem, self.restitution or self.compression)

    @property
    def title(self) -> str:
        """The hypothesis, of two phases both."""
        first = said(self.problem, self.compression)
        return first if self.restitution is None else f"compression: {first}; restitution: {said(self.problem, self.restitution)}"

    @property
    def contradiction(self) -> Any:
        """What the equations leave over where they contradict each other, in place of 0; else None."""
        left = next((phase.contradiction for phase in self.phases if phase.contradiction is not None), None)
        return None if left is None else short(self.mechanics.algebra, left)

    @property
    def free(self) -> tuple[Any, ...]:
        """Impulses that the equations leave open, by the symbols that stand for them; the motion after compression does not depend on them."""
        return tuple(symbol for phase in self.phases for symbol in phase.free)

    @property
    def conditions(self) -> tuple[Condition, ...]:
        """The inequalities that bound it."""
        return tuple(condition for phase in self.phases for condition in phase.conditions)

    @cached_property
    def closed_conditions(self) -> tuple[Condition, ...] | None:
        """The same without impulses that stay open: met where some value of these meets all conditions. What always holds is left out.

        None where several impulses stay open, or signs that it takes are not known.
        """
        algebra = self.mechanics.algebra
        if not self.free:
            return tuple(one for one in self.conditions if one.reduced != 1)
        return without(algebra, self.conditions, self.free[0]) if len(self.free) == 1 else None

    @property
    def impulse_numbers(self) -> list[Any]:
        """All impulses together, in the field of the problem."""
        algebra = self.mechanics.algebra
        first = self.phases[0].impulse
        return first if len(self.phases) == 1 else [algebra.tidy(a + b) for a, b in zip(first, self.phases[1].impulse)]

    @cached_property
    def contacts(self) -> tuple[DerivedContact, ...]:
        """Every contact after the impact."""
        algebra, size = self.mechanics.algebra, self.problem.axes
        impulse, velocity = self.impulse_numbers, self.phases[-1].velocity
        out = []
        for k, (contact, state) in enumerate(zip(self.problem.contacts, self.restitution or self.compression)):
            p, u = impulse[size * k : size * (k + 1)], velocity[size * k : size * (k + 1)]
            normal = self.mechanics.normals[k]
            push, leave = (algebra.sum(a * b for a, b in zip(normal, one)) for one in (p, u))
            plain = [tuple(short(algebra, one) for one in vector) for vector in (p, u)]
            out.append(DerivedContact(contact.name, state.word, short(algebra, push), short(algebra, leave), plain[0], plain[1], self.problem.space))
        return tuple(out)

    @cached_property
    def bodies(self) -> tuple[DerivedBody, ...]:
        """Every body after the impact; none where only the operator is known."""
        algebra, size = self.mechanics.algebra, self.problem.axes
        out = []
        for body, motion in zip(self.problem.bodies, self.mechanics.bodies_after(self.impulse_numbers)):
            plain = [short(algebra, one) for one in motion]
            out.append(DerivedBody(body.name, tuple(plain[:size]), tuple(plain[size:]) if self.problem.space else plain[size]))
        return tuple(out)

    @property
    def velocity(self) -> tuple[Any, ...]:
        """Velocity of the one body after."""
        return self._one.velocity

    @property
    def spin(self) -> Any:
        """Spin of the one body after."""
        return self._one.spin

    @property
    def _one(self) -> DerivedBody:
        if len(self.bodies) != 1:
            raise AttributeError("there is not one body: look at bodies")
        return self.bodies[0]

    def contact(self, name: str) -> DerivedContact:
        """The contact of this name."""
        return next(one for one in self.contacts if one.name == name)

    def simplify(self, expression: Any) -> Any:
        """An expression of this problem in its shortest form; zero is told from what is not zero."""
        return short(self.mechanics.algebra, self.mechanics.algebra.element(expression))

    @cached_property
    def equations(self) -> tuple[Equation, ...]:
        """The equations of compression: impulse and momentum, and what the hypothesis says of each contact."""
        before = [(body.velocity, body.spin) for body in self.problem.bodies]
        return (*momentum(self.problem, self.compression, before), *of_contacts(self.problem, self.compression))

    def at(self, values: Mapping[Any, Any]) -> Numbers:
        """Impulses, velocities and whether the conditions are met, at numbers (or arrays of them) for all symbols.

        That numbers meet what is assumed is not asked. Raises :class:`carom.CaromError` that names every symbol without a value.
        """
        from carom.symbolic.numbers import numbers

        return numbers(self, values)

    def text(self) -> str:
        """The derivation, step by step, in plain sentences."""
        from carom.symbolic.telling import text

        return text(self)

    def latex(self) -> str:
        """The result in LaTeX: impulses, velocities, conditions."""
        from carom.symbolic.telling import latex

        return latex(self)

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {self.latex()}$"

    def _repr_markdown_(self) -> str:
        from carom.symbolic.telling import markdown

        return markdown(self)

    def __repr__(self) -> str:
        return f"<Derivation {self.title}: {self.existence.verdict}>"


@dataclass(frozen=True, eq=False)
class Derivations:
    """All hypotheses of a problem. Made by :func:`carom.derive`."""

    kept: tuple[Derivation, ...]
    """Those that hold somewhere, or of which that was not decided in time."""
    discarded: tuple[Derivation, ...]
    """Those that hold nowhere, or nowhere but on the border of another; :attr:`Derivation.existence` says why."""

    def __iter__(self) -> Iterator[Derivation]:
        return iter(self.kept)

    def __len__(self) -> int:
        return len(self.kept)

    def __getitem__(self, which: str | int) -> Derivation:
        """One of those that are kept, by number or by its words."""
        if isinstance(which, int):
            return self.kept[which]
        found = [one for one in self.kept if which in (one.title, one.hypothesis)]
        if not found:
            raise KeyError(f"{which!r} is none of {', '.join(repr(one.title) for one in self.kept)}")
        return found[0]

    def at(self, values: Mapping[Any, Any]) -> list[tuple[Derivation, Numbers]]:
        """Which of them hold at these numbers, with their numbers."""
        found = [(one, one.at(values)) for one in self.kept]
        return [(one, numbers) for one, numbers in found if numbers.holds.all()]

    def text(self) -> str:
        """Which hypotheses there are, where each holds, and why the others are discarded."""
        from carom.symbolic.telling import overview

        return overview(self)

    def draw(self, x: tuple[Any, float, float], y: tuple[Any, float, float], values: Mapping[Any, float] | None = None, **how: Any) -> Any:
        """Where each hypothesis holds over two symbols, as a figure of matplotlib. See :func:`carom.symbolic.picture.draw`."""
        from carom.symbolic.picture import draw

        return draw(self, x, y, values or {}, **how)

    def _repr_markdown_(self) -> str:
        return "\n\n".join(one._repr_markdown_() for one in self.kept)

    def __repr__(self) -> str:
        return f"<Derivations: {len(self.kept)} hypotheses, {len(self.discarded)} discarded>"

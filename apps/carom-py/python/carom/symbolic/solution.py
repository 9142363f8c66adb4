"""A hypothesis solved: its equations, its impulses, and the inequalities that bound it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import sympy as sp

from carom.symbolic.algebra import Algebra, Family, solve
from carom.symbolic.hypothesis import Hypothesis, State
from carom.symbolic.mechanics import Mechanics, cross, impulse_symbols, normal_symbol
from carom.symbolic.tidy import short, shown

Phase = Literal["compression", "restitution"]


@dataclass(frozen=True, eq=False)
class Condition:
    """An inequality that bounds a hypothesis: :attr:`slack` is not negative where it holds (zero, where :attr:`equation`)."""

    contact: str
    """At which contact."""
    kind: Literal["normal_impulse", "normal_velocity", "friction_cone", "slip_direction"]
    """As the engine's answers name it."""
    phase: Phase
    """In which phase it is asked."""
    meaning: str
    """What it says, in a sentence."""
    number: Any
    algebra: Algebra
    equation: bool = False
    """It is no inequality: what must vanish for the slip to have its direction."""

    @cached_property
    def slack(self) -> Any:
        """The slack."""
        return short(self.algebra, self.number)

    @cached_property
    def reduced(self) -> Any:
        """What is left of the slack without factors that are positive for all that is assumed: 1 where it always holds, −1 where never."""
        return shown(self.algebra, self.number)

    @property
    def relation(self) -> Any:
        """The condition as a relation of SymPy, by its reduced slack."""
        return sp.Eq(self.reduced, 0) if self.equation else sp.Ge(self.reduced, 0)


@dataclass(frozen=True, eq=False)
class PhaseSolution:
    """One phase: impulses and velocities of contacts at its end, in the axes of impulses, one contact after another."""

    impulse: list[Any]
    velocity: list[Any]
    conditions: list[Condition]
    free: list[Any]
    """Impulses that stay open, by their symbols."""
    contradiction: Any = None
    """What the equations leave over in place of 0; None where they can be met."""


def solve_phase(mechanics: Mechanics, hypothesis: Hypothesis, drive: list[Any], base: list[Any], phase: Phase) -> PhaseSolution:
    """Solves one phase. ``drive`` are the velocities of contacts when it begins, ``base`` the normal impulses that it owes."""
    algebra, size = mechanics.algebra, mechanics.problem.axes
    number = 1 if phase == "compression" else 2
    columns, offset, names = _columns(mechanics, hypothesis, base, number)
    rows = _rows(mechanics, hypothesis)
    start = mechanics.after(drive, offset)
    responses = [mechanics.after([algebra.field.zero] * len(drive), column) for column in columns]
    left = [[algebra.sum(e * response[size * k + i] for i, e in enumerate(row) if e) for response in responses] for k, row in rows]
    right = [algebra.sum(-e * start[size * k + i] for i, e in enumerate(row) if e) for k, row in rows]
    # Normal impulses are solved for first: friction is what stays open.
    order = sorted(range(len(columns)), key=lambda j: str(names[j]).startswith(("T_", "Px_", "P1_")))
    family = solve(algebra, [[row[j] for j in order] for row in left], right) if columns else _nothing(right)
    if not isinstance(family, Family):
        return PhaseSolution([algebra.field.zero] * len(drive), list(drive), [], [], family)
    free = [names[order[j]] for j in family.free]
    values = list(family.point)
    for direction, symbol in zip(family.directions, free):
        value = algebra.element(symbol)
        values = [algebra.tidy(one + step * value) if step else one for one, step in zip(values, direction)]
    impulse = list(offset)
    for j, value in zip(order, values):
        impulse = [algebra.tidy(one + entry * value) if entry and value else one for one, entry in zip(impulse, columns[j])]
    velocity = mechanics.after(drive, impulse)
    return PhaseSolution(impulse, velocity, _conditions(mechanics, hypothesis, impulse, velocity, base, phase), free)


def _nothing(right: list[Any]) -> Any:
    left_over = [one for one in right if one]
    return left_over[0] if left_over else Family([], [], [])


def _friction_line(mechanics: Mechanics, k: int, state: State) -> list[Any]:
    """The impulse of a slipping contact for a normal impulse of 1."""
    algebra, normal = mechanics.algebra, mechanics.normals[k]
    along = slip_direction(mechanics, state)
    if along is None:
        return normal
    return [algebra.tidy(n - mechanics.friction[k] * t) for n, t in zip(normal, along)]


def slip_direction(mechanics: Mechanics, state: State) -> list[Any] | None:
    """Where a contact slips; None where it does not, or has no friction."""
    if state.slip in ("slips+", "slips-"):
        return [mechanics.algebra.element(1 if state.slip == "slips+" else -1), mechanics.algebra.field.zero]
    if state.direction is not None:
        return [mechanics.algebra.element(one) for one in state.direction]
    return None


def tangents(mechanics: Mechanics, k: int) -> list[list[Any]]:
    """Directions that span the tangent plane (in the plane the tangent)."""
    algebra = mechanics.algebra
    if not mechanics.problem.space:
        return [[algebra.field.one, algebra.field.zero]]
    normal = mechanics.normals[k]
    along = next(j for j in (2, 1, 0) if normal[j])
    units = [[algebra.field.one if i == j else algebra.field.zero for j in range(3)] for i in range(3)]
    return [[algebra.tidy(one) for one in cross(normal, units[j])] for j in range(3) if j != along]


def _columns(mechanics: Mechanics, hypothesis: Hypothesis, base: list[Any], phase: int) -> tuple[list[list[Any]], list[Any], list[Any]]:
    """How each unknown makes impulses, the impulses that are there without them, and what the unknowns are called."""
    zero, size = mechanics.algebra.field.zero, mechanics.problem.axes
    total = size * len(hypothesis)
    columns: list[list[Any]] = []
    names: list[Any] = []
    offset = [zero] * total

    def add(k: int, vector: list[Any], name: Any) -> None:
        columns.append([vector[i - size * k] if size * k <= i < size * (k + 1) else zero for i in range(total)])
        names.append(name)

    for k, state in enumerate(hypothesis):
        components = impulse_symbols(mechanics.problem, k, phase)
        if state.slip == "open":
            continue
        if state.holds and state.slip in ("sticks", "keeps"):
            for i, name in enumerate(components):
                add(k, [mechanics.algebra.field.one if i == j else zero for j in range(size)], name)
            continue
        line = mechanics.normals[k] if state.slip in ("sticks", "keeps") else _friction_line(mechanics, k, state)
        if state.holds:
            add(k, line, normal_symbol(mechanics.problem, k, phase))
            continue
        for i, entry in enumerate(line):
            offset[size * k + i] = mechanics.algebra.tidy(entry * base[k])
        if state.slip in ("sticks", "keeps"):
            for vector, name in zip(tangents(mechanics, k), components):
                add(k, vector, name)
    return columns, offset, names


def _rows(mechanics: Mechanics, hypothesis: Hypothesis) -> list[tuple[int, list[Any]]]:
    """Which velocities must vanish: contact and direction."""
    algebra, size = mechanics.algebra, mechanics.problem.axes
    out: list[tuple[int, list[Any]]] = []
    for k, state in enumerate(hypothesis):
        if state.holds and state.slip in ("sticks", "keeps"):
            out += [(k, [algebra.field.one if i == j else algebra.field.zero for j in range(size)]) for i in range(size)]
        elif state.holds:
            out.append((k, mechanics.normals[k]))
        elif state.slip in ("sticks", "keeps"):
            out += [(k, one) for one in tangents(mechanics, k)]
    return out


def _conditions(mechanics: Mechanics, hypothesis: Hypothesis, impulse: list[Any], velocity: list[Any], base: list[Any], phase: Phase) -> list[Condition]:
    algebra, size = mechanics.algebra, mechanics.problem.axes
    out: list[Condition] = []
    for k, state in enumerate(hypothesis):
        name, normal, friction = mechanics.problem.contacts[k].name, mechanics.normals[k], mechanics.friction[k]
        p, u = impulse[size * k : size * (k + 1)], velocity[size * k : size * (k + 1)]
        push = algebra.sum(a * b for a, b in zip(normal, p))

        def add(kind: Any, meaning: str, number: Any, equation: bool = False, name: str = name) -> None:
            out.append(Condition(name, kind, phase, meaning, algebra.tidy(number), algebra, equation))

        if state.holds:
            add("normal_impulse", f"{name} pushes" if not base[k] else f"{name} gives back at least its share", push - base[k])
        else:
            add("normal_velocity", f"{name} does not go in", algebra.sum(a * b for a, b in zip(normal, u)))
        if state.slip == "sticks":
            for number in _cone(mechanics, p, push, friction):
                add("friction_cone", f"friction can hold {name}", number)
        along = slip_direction(mechanics, state)
        if along is not None:
            add("slip_direction", f"the slip at {name} keeps its direction", algebra.sum(a * b for a, b in zip(along, u)))
            if mechanics.problem.space:
                across = [algebra.tidy(one) for one in cross(normal, along)]
                sideways = algebra.sum(a * b for a, b in zip(across, u))
                if sideways:
                    add("slip_direction", f"the slip at {name} has this direction", sideways, True)
    return out


def _cone(mechanics: Mechanics, p: list[Any], push: Any, friction: Any) -> list[Any]:
    """What friction could give more than it must: in the plane for both directions, in space for the squares."""
    if not mechanics.problem.space:
        return [friction * push - p[0], friction * push + p[0]]
    square = mechanics.algebra.sum(one * one for one in p)
    return [(friction * friction + 1) * push * push - square]

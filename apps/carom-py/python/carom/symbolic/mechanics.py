"""Impulse and momentum: the operator that takes impulses at contacts to changes of their velocities."""

from __future__ import annotations

from typing import Any

import sympy as sp

from carom.symbolic.algebra import Algebra
from carom.symbolic.assumptions import Assumptions
from carom.symbolic.problem import SymbolicBody, SymbolicContact, SymbolicProblem


def impulse_symbols(problem: SymbolicProblem, contact: int, phase: int = 1) -> tuple[Any, ...]:
    """What the components of an impulse are called: T and N in the plane; in space along the axes of the file."""
    name = problem.contacts[contact].name
    ends = ("T", "N") if not problem.space else ("Px", "Py", "Pz") if problem.operator is None else ("P1", "P2", "Pn")
    again = "" if phase == 1 else "_2"
    return tuple(sp.Symbol(f"{end}_{name}{again}", real=True) for end in ends)


def normal_symbol(problem: SymbolicProblem, contact: int, phase: int = 1) -> Any:
    """The normal impulse."""
    return sp.Symbol(f"N_{problem.contacts[contact].name}{'' if phase == 1 else '_2'}", real=True)


def tangent(normal: tuple[Any, ...]) -> tuple[Any, ...]:
    """The tangent of a contact in the plane: its normal turned 90° clockwise."""
    return (normal[1], -normal[0])


def cross(a: Any, b: Any) -> tuple[Any, ...]:
    """The cross product of two vectors in space."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


class Mechanics:
    """The bodies of a problem and their contacts, in the field of its numbers."""

    def __init__(self, problem: SymbolicProblem, assumptions: Assumptions) -> None:
        self.problem, self.assumptions = problem, assumptions
        count = len(problem.contacts)
        unknowns = [one for phase in (1, 2) for k in range(count) for one in (*impulse_symbols(problem, k, phase), normal_symbol(problem, k, phase))]
        self.algebra = Algebra(self._expressions(), assumptions, dict.fromkeys(unknowns))
        element = self.algebra.element
        #: Of each contact: its normal and, in the plane, its tangent in the axes of impulses.
        self.normals: list[list[Any]] = []
        for contact in problem.contacts:
            plain: tuple[Any, ...] = contact.normal if problem.space else (0, 1)
            self.normals.append([element(one) for one in plain])
        self.friction = [element(one.friction) for one in problem.contacts]
        self.restitution = [element(one.restitution) for one in problem.contacts]
        self.lines = [[self._line(contact, k) for k in range(len(problem.bodies))] for contact in problem.contacts]
        self.inverse = [self._inverse(body) for body in problem.bodies]
        self.motion = [[element(one) for one in (*body.velocity, *body.spin)] for body in problem.bodies]
        self.before, self.operator = self._contact_space()

    def _expressions(self) -> list[Any]:
        problem = self.problem
        out = [value for body in problem.bodies for value in (body.mass, *body.inertia, *body.centre, *body.velocity, *body.spin)]
        out += [value for one in problem.contacts for value in (*one.point, *one.normal, one.friction, one.restitution)]
        if problem.operator is not None:
            out += [*problem.operator[0], *problem.operator[1]]
        # Roots, sines and cosines of what is assumed belong to the field too.
        assumed = [one.lhs - one.rhs for one in self.assumptions.relations]
        return out + [one for one in assumed if one.has(sp.sin, sp.cos, sp.tan, sp.cot) or any(not power.exp.is_Integer for power in one.atoms(sp.Pow))]

    def arm(self, contact: SymbolicContact, body: SymbolicBody) -> tuple[Any, ...]:
        """From the mass centre to the contact."""
        return tuple(p - c for p, c in zip(contact.point, body.centre))

    def _line(self, contact: SymbolicContact, k: int) -> list[list[Any]] | None:
        """How the velocities of a body (along the axes, then spin) make that of a contact; None where it does not touch it."""
        sign = 1 if k == contact.into else -1 if k == contact.out_of else 0
        if sign == 0:
            return None
        arm = self.arm(contact, self.problem.bodies[k])
        rows: list[Any]
        if self.problem.space:
            units = [tuple(int(i == j) for j in range(3)) for i in range(3)]
            rows = [[*unit, *cross(arm, unit)] for unit in units]
        else:
            rows = [[*axis, arm[0] * axis[1] - arm[1] * axis[0]] for axis in (tangent(contact.normal), contact.normal)]
        return [[self.algebra.element(sign * one) for one in row] for row in rows]

    def _inverse(self, body: SymbolicBody) -> list[Any]:
        """One over mass and inertia, for each velocity."""
        if body.fixed:
            return [self.algebra.field.zero] * (6 if self.problem.space else 3)
        masses = [body.mass] * self.problem.axes + list(body.inertia)
        return [self.algebra.element(1 / one) for one in masses]

    def _contact_space(self) -> tuple[list[Any], list[list[Any]]]:
        """Velocities of contacts before, and the operator, row by row."""
        element, algebra = self.algebra.element, self.algebra
        if self.problem.operator is not None:
            matrix, velocity = self.problem.operator
            size = matrix.shape[0]
            return [element(one) for one in velocity], [[element(matrix[i, j]) for j in range(size)] for i in range(size)]
        size = self.problem.axes
        pairs = [(contact, row) for contact in range(len(self.problem.contacts)) for row in range(size)]
        before, operator = [], []
        for contact, row in pairs:
            mine = [(k, line[row]) for k, line in enumerate(self.lines[contact]) if line is not None]
            before.append(algebra.sum(a * v for k, line in mine for a, v in zip(line, self.motion[k])))
            entries = []
            for other, column in pairs:
                products = [a * i * b for k, line in mine if (theirs := self.lines[other][k]) is not None for a, i, b in zip(line, self.inverse[k], theirs[column])]
                entries.append(algebra.sum(products))
            operator.append(entries)
        return before, operator

    def after(self, velocity: list[Any], impulse: list[Any]) -> list[Any]:
        """Velocities of contacts once these impulses have acted."""
        return [self.algebra.sum([v, *[w * p for w, p in zip(row, impulse) if p]]) for v, row in zip(velocity, self.operator)]

    def bodies_after(self, impulse: list[Any]) -> list[list[Any]]:
        """Velocities and spins of bodies after these impulses."""
        size, out = self.problem.axes, []
        for k, motion in enumerate(self.motion):
            change = [self.algebra.field.zero] * len(motion)
            for contact, lines in enumerate(self.lines):
                line = lines[k]
                if line is not None:
                    change = [one + i * sum((row[d] * impulse[size * contact + r] for r, row in enumerate(line)), self.algebra.field.zero) for d, (one, i) in enumerate(zip(change, self.inverse[k]))]
            out.append([self.algebra.tidy(v + one) for v, one in zip(motion, change)])
        return out

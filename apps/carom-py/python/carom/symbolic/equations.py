"""The equations of a hypothesis as a student writes them: impulse and momentum of each body, and what each contact does."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

from carom.symbolic.hypothesis import Hypothesis, State
from carom.symbolic.mechanics import cross, impulse_symbols, normal_symbol, tangent
from carom.symbolic.problem import SymbolicContact, SymbolicProblem


@dataclass(frozen=True)
class Equation:
    """An equation and what it says."""

    says: str
    equation: Any


def after_symbols(problem: SymbolicProblem, body: int) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
    """What velocity and spin of a body after the impact are called."""
    of = f"_{problem.bodies[body].name}" if len(problem.bodies) > 1 else ""
    axes = ("x", "y", "z") if problem.space else ("x", "y")
    spins = tuple(f"omega_{axis}" for axis in axes) if problem.space else ("omega",)
    return tuple(sp.Symbol(f"v_{axis}{of}", real=True) for axis in axes), tuple(sp.Symbol(f"{spin}{of}", real=True) for spin in spins)


def impulse_of(problem: SymbolicProblem, k: int, state: State, phase: int = 1) -> tuple[Any, ...]:
    """The impulse at a contact along the axes of the file, in its unknowns."""
    contact = problem.contacts[k]
    symbols = impulse_symbols(problem, k, phase)
    if state.slip == "open":
        return (sp.Integer(0),) * problem.axes
    if not problem.space:
        along = tangent(contact.normal)
        return tuple(symbols[0] * t + symbols[1] * n for t, n in zip(along, contact.normal))
    if state.slip in ("sticks", "keeps"):
        return symbols
    push = normal_symbol(problem, k, phase)
    against = state.direction or (0, 0, 0)
    return tuple(push * (n - contact.friction * t) for n, t in zip(contact.normal, against))


def momentum(problem: SymbolicProblem, hypothesis: Hypothesis, before: list[tuple[tuple[Any, ...], tuple[Any, ...]]], phase: int = 1) -> list[Equation]:
    """Impulse and momentum, impulse and angular momentum about the mass centre, of every body that can move."""
    out: list[Equation] = []
    for k, body in enumerate(problem.bodies):
        if body.fixed:
            continue
        linear = [sp.Integer(0)] * problem.axes
        angular = [sp.Integer(0)] * len(body.spin)
        for index, (contact, state) in enumerate(zip(problem.contacts, hypothesis)):
            sign = 1 if k == contact.into else -1 if k == contact.out_of else 0
            p = [sign * one for one in impulse_of(problem, index, state, phase)]
            arm = tuple(a - b for a, b in zip(contact.point, body.centre))
            turn = cross(arm, p) if problem.space else (arm[0] * p[1] - arm[1] * p[0],)
            linear = [a + b for a, b in zip(linear, p)]
            angular = [a + b for a, b in zip(angular, turn)]
        velocity, spin = after_symbols(problem, k)
        whose = f" of {body.name}" if len(problem.bodies) > 1 else ""
        axes = ("x", "y", "z")
        for axis, new, old, total in zip(axes, velocity, before[k][0], linear):
            out.append(Equation(f"momentum{whose} along {axis}", sp.Eq(body.mass * (new - old), _collected(total))))
        for axis, new, old, inertia, total in zip(axes, spin, before[k][1], body.inertia, angular):
            about = f" about {axis}" if problem.space else ""
            out.append(Equation(f"angular momentum{whose}{about}", sp.Eq(inertia * (new - old), _collected(total))))
    return out


def _collected(total: Any) -> Any:
    """A sum by its impulses, each with a short factor."""
    expanded = sp.expand(total)
    impulses = [symbol for symbol in expanded.free_symbols if str(symbol.name).startswith(("T_", "N_", "P"))]
    factors = {symbol: sp.trigsimp(expanded.coeff(symbol)) for symbol in sorted(impulses, key=lambda symbol: str(symbol.name))}
    rest = expanded - sum(expanded.coeff(symbol) * symbol for symbol in impulses)
    return sum(factor * symbol for symbol, factor in factors.items()) + sp.expand(rest)


def contact_velocity(problem: SymbolicProblem, contact: SymbolicContact, motions: list[tuple[tuple[Any, ...], tuple[Any, ...]]]) -> tuple[Any, ...]:
    """The velocity of the first body at a contact against the second."""
    total = [sp.Integer(0)] * problem.axes
    for k, sign in ((contact.into, 1), (contact.out_of, -1)):
        if k is None:
            continue
        velocity, spin = motions[k]
        arm = tuple(a - b for a, b in zip(contact.point, problem.bodies[k].centre))
        turned = cross(spin, arm) if problem.space else (-spin[0] * arm[1], spin[0] * arm[0])
        total = [a + sign * (v + w) for a, v, w in zip(total, velocity, turned)]
    return tuple(total)


def of_contacts(problem: SymbolicProblem, hypothesis: Hypothesis, phase: int = 1, owed: list[Any] | None = None) -> list[Equation]:
    """What the hypothesis says of each contact, as equations."""
    out: list[Equation] = []
    motions = [after_symbols(problem, k) if not body.fixed else (body.velocity, body.spin) for k, body in enumerate(problem.bodies)]
    for k, (contact, state) in enumerate(zip(problem.contacts, hypothesis)):
        if state.slip == "open":
            continue
        share = owed[k] if owed else sp.Integer(0)
        push = normal_symbol(problem, k, phase)
        if not state.holds:
            out.append(Equation(f"{contact.name} gives back its share", sp.Eq(push, share)))
        if problem.bodies:
            velocity = contact_velocity(problem, contact, motions)
            normal = sum(a * b for a, b in zip(velocity, contact.normal))
            if state.holds:
                out.append(Equation(f"{contact.name} comes to rest along its normal", sp.Eq(sp.expand(normal), 0)))
            if state.slip in ("sticks", "keeps"):
                out += _at_rest(problem, contact, velocity)
        if state.slip in ("slips+", "slips-"):
            pull = -contact.friction if state.slip == "slips+" else contact.friction
            out.append(Equation(f"friction at {contact.name} acts against its slip", sp.Eq(impulse_symbols(problem, k, phase)[0], pull * push)))
        if state.slip == "slips" and not problem.space:
            out.append(Equation(f"{contact.name} has no friction", sp.Eq(impulse_symbols(problem, k, phase)[0], 0)))
    return out


def _at_rest(problem: SymbolicProblem, contact: SymbolicContact, velocity: tuple[Any, ...]) -> list[Equation]:
    says = f"{contact.name} comes to rest along its tangent"
    if not problem.space:
        return [Equation(says, sp.Eq(sp.expand(sum(a * b for a, b in zip(velocity, tangent(contact.normal)))), 0))]
    normal = sum(a * b for a, b in zip(velocity, contact.normal))
    return [Equation(f"{says} plane, along {axis}", sp.Eq(sp.expand(v - normal * n), 0)) for axis, v, n in zip("xyz", velocity, contact.normal)]

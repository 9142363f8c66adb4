"""Derivations for readers: in plain sentences, in LaTeX, in Markdown."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

from carom.symbolic.derivation import Derivation, Derivations
from carom.symbolic.equations import Equation, after_symbols, momentum, of_contacts
from carom.symbolic.hypothesis import Hypothesis
from carom.symbolic.mechanics import impulse_symbols
from carom.symbolic.solution import Condition
from carom.symbolic.tidy import short

#: What each kind of condition has on its left, in words.
_SLACKS = {
    "normal_impulse": "normal impulse",
    "normal_velocity": "normal velocity after",
    "friction_cone": "friction that is left",
    "slip_direction": "slip after, in its direction",
}


def _vector(values: tuple[Any, ...], show: Callable[[Any], str]) -> str:
    return show(values[0]) if len(values) == 1 else f"({', '.join(show(one) for one in values)})"


def given(derivation: Derivation, show: Callable[[Any], str] = str) -> list[str]:
    """What is given, a sentence each."""
    problem = derivation.problem
    out = []
    for body in problem.bodies:
        name = f"Body {body.name}" if len(problem.bodies) > 1 else "One body"
        if body.fixed:
            out.append(f"{name} is fixed: its velocity is {_vector(body.velocity, show)} and stays so.")
            continue
        where = f", mass centre at {_vector(body.centre, show)}" if len(problem.bodies) > 1 else ", mass centre at the origin"
        out.append(f"{name}: mass {show(body.mass)}, moment of inertia {_vector(body.inertia, show)}{where}.")
        out.append(f"Before: velocity {_vector(body.velocity, show)}, spin {_vector(body.spin, show)}.")
    for contact in problem.contacts:
        where = f" at {_vector(contact.point, show)}, normal {_vector(contact.normal, show)}" if problem.bodies else ""
        more = f", restitution {show(contact.restitution)}" if contact.restitution != 0 else ""
        out.append(f"Contact {contact.name}{where}, friction {show(contact.friction)}{more}.")
    if derivation.mechanics.assumptions.said:
        out.append(f"Assumed: {', '.join(derivation.mechanics.assumptions.said)}.")
    return out


def unknowns(derivation: Derivation) -> list[Any]:
    """The unknowns of compression: velocities after, and impulses of contacts that transmit any."""
    problem = derivation.problem
    out: list[Any] = []
    for k, body in enumerate(problem.bodies):
        if not body.fixed:
            velocity, spin = after_symbols(problem, k)
            out += [*velocity, *spin]
    return out + [symbol for k, state in enumerate(derivation.compression) if state.slip != "open" for symbol in impulse_symbols(problem, k)]


def before(derivation: Derivation, show: Callable[[Any], str] = str) -> list[str]:
    """Velocities of the contacts before."""
    mechanics, size = derivation.mechanics, derivation.problem.axes
    out = []
    for k, contact in enumerate(derivation.problem.contacts):
        values = tuple(short(mechanics.algebra, one) for one in mechanics.before[size * k : size * (k + 1)])
        if size == 2:
            out.append(f"{contact.name}: slip {show(values[0])}, normal velocity {show(values[1])}.")
        else:
            out.append(f"{contact.name}: velocity {_vector(values, show)}.")
    return out


def phase_equations(derivation: Derivation, phase: int) -> list[Equation]:
    """The equations of a phase; those of restitution start from what compression left."""
    problem, mechanics = derivation.problem, derivation.mechanics
    if phase == 0:
        return list(derivation.equations)
    algebra, size = mechanics.algebra, problem.axes
    left = [tuple(short(algebra, one) for one in motion) for motion in mechanics.bodies_after(derivation.phases[0].impulse)]
    start = [(motion[:size], motion[size:]) for motion in left]
    owed = [contact.restitution * short(algebra, _normal(derivation, k)) for k, contact in enumerate(problem.contacts)]
    states = derivation.restitution or derivation.compression
    return [*momentum(problem, states, start, 2), *of_contacts(problem, states, 2, owed)]


def _normal(derivation: Derivation, k: int) -> Any:
    mechanics, size = derivation.mechanics, derivation.problem.axes
    impulse = derivation.phases[0].impulse[size * k : size * (k + 1)]
    return mechanics.algebra.sum(a * b for a, b in zip(mechanics.normals[k], impulse))


def result(derivation: Derivation) -> list[tuple[str, Any]]:
    """Name and value of all that is derived; of two phases impulses are those of both together."""
    problem = derivation.problem
    out: list[tuple[str, Any]] = []
    for k, contact in enumerate(derivation.contacts):
        for symbol, value in zip(impulse_symbols(problem, k), contact.impulse):
            out.append((symbol.name, value))
    for k, body in enumerate(derivation.bodies):
        if problem.bodies[k].fixed:
            continue
        velocity, spin = after_symbols(problem, k)
        spins = body.spin if problem.space else (body.spin,)
        out += [(symbol.name, value) for symbol, value in zip((*velocity, *spin), (*body.velocity, *spins))]
    for contact in derivation.contacts:
        if problem.space:
            out += [(f"u_{axis}_{contact.name}", value) for axis, value in zip("xyz", contact.velocity)]
        else:
            out += [(f"u_t_{contact.name}", contact.velocity[0]), (f"u_n_{contact.name}", contact.velocity[1])]
    return out


def _condition(condition: Condition) -> str:
    sign = "=" if condition.equation else ">="
    if condition.reduced == 1 and not condition.equation:
        return f"{condition.meaning}: always."
    if condition.reduced == -1:
        return f"{condition.meaning}: never."
    if condition.reduced == 0:
        return f"{condition.meaning}: as an equality, always."
    return f"{condition.meaning}: {condition.reduced} {sign} 0."


def _numbered(title: str, lines: list[str], number: int) -> list[str]:
    return [f"{number}. {title}", *[f"   {line}" for line in lines], ""]


def _equations(equations: list[Equation]) -> list[str]:
    return [f"{one.equation.lhs} = {one.equation.rhs}    ({one.says})" if isinstance(one.equation, sp.Eq) else f"0 = 0    ({one.says})" for one in equations]


def _hypothesis(derivation: Derivation, states: Hypothesis) -> list[str]:
    out = []
    for contact, state in zip(derivation.problem.contacts, states):
        if state.slip == "open":
            out.append(f"{contact.name} separates: it transmits nothing, and must not go in.")
        elif not state.holds:
            out.append(f"{contact.name} separates under the impulse that restitution owes it, and {'does not slip' if state.slip in ('sticks', 'keeps') else 'slips'}.")
        elif state.slip in ("sticks", "keeps"):
            out.append(f"{contact.name} {state.word}: in the end it rests along normal and tangent.")
        else:
            out.append(f"{contact.name} {state.word}: in the end it rests along its normal, and slides.")
    return out


def text(derivation: Derivation) -> str:
    """The derivation, step by step."""
    lines = [f"Hypothesis: {derivation.title}.", ""]
    lines += _numbered("What is given", given(derivation), 1)
    lines += _numbered("Velocities of the contacts before", before(derivation), 2)
    lines += _numbered("What the hypothesis says", _hypothesis(derivation, derivation.compression), 3)
    names = ", ".join(str(one) for one in unknowns(derivation))
    lines += _numbered("Equations", [f"Unknown are {names}.", *_equations(phase_equations(derivation, 0))] if derivation.problem.bodies else ["u = u before + W p, with the operator W that is given."], 4)
    number = 5
    if derivation.restitution is not None:
        lines += _numbered("Restitution", [*_hypothesis(derivation, derivation.restitution), *_equations(phase_equations(derivation, 1))], number)
        number += 1
    if derivation.contradiction is not None:
        lines += _numbered("Solution", [f"The equations contradict each other: {derivation.contradiction} would have to be 0."], number)
        return "\n".join(lines).rstrip() + "\n"
    solution = [f"{name} = {value}" for name, value in result(derivation)]
    if derivation.free:
        solution.append(f"The equations leave {', '.join(str(one) for one in derivation.free)} open: more contacts hold the body than it has velocities.")
    lines += _numbered("Solution", solution, number)
    conditions = [_condition(one) for one in derivation.conditions]
    if derivation.free and derivation.closed_conditions:
        conditions += [f"Some {derivation.free[0]} meets all of them where", *[f"   {_condition(one)}" for one in derivation.closed_conditions]]
    lines += _numbered("When it holds", [*conditions, _verdict(derivation)], number + 1)
    return "\n".join(lines).rstrip() + "\n"


def _verdict(derivation: Derivation) -> str:
    found = derivation.existence
    if found.verdict == "holds" and found.example is not None:
        shown = set(derivation.problem.symbols) | set(derivation.free)
        values = ", ".join(f"{symbol} = {value:.6g}" for symbol, value in found.example.items() if symbol in shown)
        return f"It holds, for example at {values}." if values else "It holds."
    words = {"holds": "It holds somewhere.", "border": "It holds on a border at most", "empty": "It never holds", "unknown": "Whether it can hold is not known"}[found.verdict]
    return words if not found.why else f"{words.rstrip('.')}: {found.why}."


def _aligned(rows: list[str]) -> str:
    return "\\begin{aligned}" + r" \\ ".join(rows) + "\\end{aligned}"


def latex(derivation: Derivation) -> str:
    """Impulses, velocities and conditions as one block."""
    rows = [f"{sp.latex(sp.Symbol(name))} &= {sp.latex(value)}" for name, value in result(derivation)]
    for condition in derivation.conditions:
        if condition.reduced not in (0, 1):
            rows.append(f"{sp.latex(condition.reduced)} &{'=' if condition.equation else chr(92) + 'ge'} 0 && \\text{{{condition.meaning}}}")
    return _aligned(rows)


def markdown(derivation: Derivation) -> str:
    """The derivation for a notebook."""
    show = lambda one: f"${sp.latex(one)}$"  # noqa: E731
    parts = [f"### {derivation.title}", "**Given.** " + " ".join(given(derivation, show)), "**Before.** " + " ".join(before(derivation, show))]
    parts.append("**Hypothesis.** " + " ".join(_hypothesis(derivation, derivation.compression)))
    for phase in range(len(derivation.phases) if derivation.problem.bodies else 0):
        rows = [f"{sp.latex(one.equation.lhs)} &= {sp.latex(one.equation.rhs)} && \\text{{{one.says}}}" for one in phase_equations(derivation, phase) if isinstance(one.equation, sp.Eq)]
        parts.append(f"**{'Equations' if phase == 0 else 'Restitution'}.**\n\n$$\n{_aligned(rows)}\n$$")
    if derivation.contradiction is None:
        parts.append(f"**Solution.**\n\n$$\n{latex(derivation)}\n$$")
    parts.append(_verdict(derivation))
    return "\n\n".join(parts)


def overview(derivations: Derivations) -> str:
    """Which hypotheses hold where, and why the others are discarded."""
    lines = []
    for one in derivations.kept:
        lines.append(f"{one.title}: {_verdict(one)}")
        lines += [f"   {_condition(condition)}" for condition in one.conditions if condition.reduced not in (0, 1)]
    if derivations.discarded:
        lines.append("Discarded:")
        lines += [f"   {one.title}: {one.existence.why}." for one in derivations.discarded]
    return "\n".join(lines) + "\n"

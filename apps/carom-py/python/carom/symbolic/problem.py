"""An impact whose numbers may be symbols, with the keys of an impact file."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches
from typing import Any

import numpy as np
import sympy as sp

from carom._given import FileLike, read
from carom.errors import CaromError, Problem
from carom.symbolic.expressions import Names, quantity

#: Keys of an impact file that a hypothesis knows nothing of, and why.
NOT_HERE = {
    "sharing": "hypotheses take all contacts together: another sharing of an impact cannot be derived",
    "exponent": "springs cannot be derived: hypotheses take all contacts together",
    "stiffness": "springs cannot be derived: hypotheses take all contacts together",
    "gravity": "an impact has no time for forces",
    "force": "an impact has no time for forces",
    "torque": "an impact has no time for forces",
}
_ROOT = ["law", "body", "contact", "operator"]
_BODY = ["name", "kind", "mass", "inertia", "centre", "velocity", "spin"]
_ONE_BODY = ["mass", "inertia", "velocity", "spin"]
_CONTACT = ["name", "between", "point", "normal", "friction", "restitution"]
_OPERATOR = ["matrix", "velocity", "friction", "restitution", "w_tt", "w_tn", "w_nn", "slip", "approach"]


@dataclass(frozen=True)
class SymbolicBody:
    """A body before the impact; a fixed one has no mass."""

    name: str
    fixed: bool
    mass: Any
    inertia: tuple[Any, ...]
    """One number in the plane, three about the axes in space."""
    centre: tuple[Any, ...]
    velocity: tuple[Any, ...]
    spin: tuple[Any, ...]


@dataclass(frozen=True)
class SymbolicContact:
    """A contact; the normal has length 1 and points into the first of its bodies."""

    name: str
    into: int
    out_of: int | None
    point: tuple[Any, ...]
    normal: tuple[Any, ...]
    friction: Any
    restitution: Any


@dataclass(frozen=True)
class SymbolicProblem:
    """What is given. Made by :func:`problem_of`."""

    space: bool
    law: str
    bodies: tuple[SymbolicBody, ...]
    contacts: tuple[SymbolicContact, ...]
    names: Names = field(compare=False)
    operator: tuple[Any, Any] | None = None
    """The operator and the velocities before, where no body is given."""

    @property
    def axes(self) -> int:
        """Components of an impulse: two in the plane, three in space."""
        return 3 if self.space else 2

    @property
    def symbols(self) -> list[Any]:
        """Every symbol of the problem, by name."""
        given: list[Any] = [value for body in self.bodies for value in (body.mass, *body.inertia, *body.centre, *body.velocity, *body.spin)]
        given += [value for one in self.contacts for value in (*one.point, *one.normal, one.friction, one.restitution)]
        if self.operator is not None:
            given += [*self.operator[0], *self.operator[1]]
        return sorted({symbol for value in given for symbol in sp.sympify(value).free_symbols}, key=lambda symbol: str(symbol.name))


class _Reader:
    """Reads a dictionary and notes every problem."""

    def __init__(self, names: Names) -> None:
        self.names = names
        self.problems: list[Problem] = []

    def blame(self, path: str, message: str, kind: str, **more: Any) -> None:
        self.problems.append(Problem(message, kind=kind, path=path, key=path.rsplit(".", 1)[-1], **more))

    def keys(self, table: Mapping[str, Any], known: list[str], path: str) -> None:
        for key in table:
            where = f"{path}.{key}" if path else key
            if key in NOT_HERE:
                self.blame(where, NOT_HERE[key], "unsupported")
            elif key not in known:
                near = get_close_matches(key, known, 1)
                self.blame(where, f"unknown key; there are {', '.join(known)}", "unknown_key", allowed=known, help=f'did you mean "{near[0]}"?' if near else None)

    def number(self, table: Mapping[str, Any], key: str, dimension: str, path: str, default: Any = None) -> Any:
        where = f"{path}.{key}"
        if key not in table:
            if default is None:
                self.blame(where, f"is missing: {dimension if dimension != 'number' else 'a number'}", "missing_key")
                return sp.Integer(1)
            return sp.sympify(default)
        return self.value(table[key], dimension, where)

    def value(self, given: object, dimension: str, where: str) -> Any:
        try:
            return quantity(given, dimension, self.names)
        except ValueError as why:
            self.blame(where, str(why), "wrong_value", value=repr(given)[:200])
            return sp.Integer(1)

    def vector(self, table: Mapping[str, Any], key: str, dimension: str, path: str, count: int, default: Any = None) -> tuple[Any, ...]:
        where = f"{path}.{key}"
        given: Any = table.get(key)
        if given is None and key not in table:
            if default is None:
                self.blame(where, f"is missing: {count} numbers", "missing_key")
            return (sp.Integer(0),) * count
        if isinstance(given, np.ndarray):
            given = given.tolist()
        if not isinstance(given, list | tuple) or len(given) != count:
            self.blame(where, f"expected a list of {count} numbers, not {given!r}", "wrong_value", value=repr(given)[:200])
            return (sp.Integer(0),) * count
        return tuple(self.value(one, dimension, f"{where}.{k}") for k, one in enumerate(given))


def problem_of(given: FileLike, *, known: Iterable[Any] = (), properties: Mapping[str, dict[str, bool]] | None = None) -> SymbolicProblem:
    """Reads an impact whose numbers may be symbols: a dictionary, a file or a text with the keys of the impact file.

    ``known`` are symbols of the caller, ``properties`` what is assumed of names.

    Raises :class:`carom.CaromError` that lists every problem with its path.
    """
    table = given if isinstance(given, Mapping) else _parsed(given)
    names = Names(known)
    names.properties = dict(properties or {})
    _roles(table, names)
    reader = _Reader(names)
    reader.keys(table, _ROOT, "")
    law = table.get("law", "poisson")
    if law not in ("poisson", "newton"):
        what = "an end state does not know the work of its impulses" if law == "stronge" else f"{law!r} is no law"
        reader.blame("law", f"{what}: derive with poisson or newton", "unsupported", allowed=["poisson", "newton"])
    made = _of_operator(table, reader) if "operator" in table else _of_bodies(table, reader)
    if reader.problems:
        raise CaromError("\n".join(f"{one.path}: {one.message}" for one in reader.problems), reader.problems)
    space, bodies, contacts, operator = made
    return SymbolicProblem(space, law, bodies, contacts, names, operator)


def _parsed(given: FileLike) -> Mapping[str, Any]:
    name, text, is_json = read(given, "derive")
    try:
        parsed = json.loads(text) if is_json else tomllib.loads(text)
    except ValueError as why:
        raise CaromError(f"{name}: {why}", [Problem(str(why), kind="syntax")]) from None
    if not isinstance(parsed, dict):
        raise CaromError(f"{name}: expected a table with the keys of an impact file")
    return parsed


def _roles(table: Mapping[str, Any], names: Names) -> None:
    """A name that stands alone for a mass is positive, for a friction not negative: known before the first text is read."""
    positive, nonnegative = {"positive": True}, {"nonnegative": True}

    def note(value: object, what: dict[str, bool]) -> None:
        if isinstance(value, list | tuple):
            for one in value:
                note(one, what)
        elif isinstance(value, str) and value.strip().isidentifier():
            names.properties.setdefault(value.strip(), what)

    tables: Any
    for key, roles in (("body", {"mass": positive, "inertia": positive}), ("contact", {"friction": nonnegative, "restitution": nonnegative})):
        tables = table.get(key)
        for one in tables if isinstance(tables, list | tuple) else [tables]:
            for name, what in roles.items() if isinstance(one, Mapping) else ():
                note(one.get(name), what)


_Made = tuple[bool, tuple[SymbolicBody, ...], tuple[SymbolicContact, ...], tuple[Any, Any] | None]


def _tables(table: Mapping[str, Any], key: str, reader: _Reader) -> list[Mapping[str, Any]]:
    given: Any = table.get(key)
    tables: list[Any] = list(given) if isinstance(given, list | tuple) else [given]
    if given is None or not all(isinstance(one, Mapping) for one in tables):
        reader.blame(key, f"expected {'a table or ' if key == 'body' else ''}a list of tables" if given is not None else "is missing", "wrong_value" if given is not None else "missing_key")
        return []
    return tables


def _of_bodies(table: Mapping[str, Any], reader: _Reader) -> _Made:
    body_tables, contact_tables = _tables(table, "body", reader), _tables(table, "contact", reader)
    several = isinstance(table.get("body"), list | tuple)
    space = _in_space(body_tables, contact_tables)
    bodies = tuple(_body(one, k, several, space, reader) for k, one in enumerate(body_tables))
    index = {body.name: k for k, body in enumerate(bodies)}
    if len(index) < len(bodies):
        reader.blame("body", "two bodies have one name", "name")
    contacts = tuple(_contact(one, k, index if several else None, space, reader) for k, one in enumerate(contact_tables))
    if len({one.name for one in contacts}) < len(contacts):
        reader.blame("contact", "two contacts have one name", "name")
    return space, bodies, contacts, None


def _in_space(bodies: list[Mapping[str, Any]], contacts: list[Mapping[str, Any]]) -> bool:
    """What most vectors say."""
    vectors = [one.get(key) for one in bodies for key in ("velocity", "centre", "spin", "inertia")] + [one.get(key) for one in contacts for key in ("point", "normal")]
    lengths = [len(one) for one in vectors if isinstance(one, list | tuple)]
    return lengths.count(3) > lengths.count(2)


def _body(table: Mapping[str, Any], k: int, several: bool, space: bool, reader: _Reader) -> SymbolicBody:
    path = f"body.{k}" if several else "body"
    reader.keys(table, _BODY if several else _ONE_BODY, path)
    count = 3 if space else 2
    name = str(table.get("name", f"body {k + 1}")) if several else "body"
    fixed = several and table.get("kind") == "fixed"
    if several and table.get("kind", "free") not in ("free", "fixed"):
        reader.blame(f"{path}.kind", f"{table['kind']!r} is no kind", "wrong_value", allowed=["free", "fixed"])
    mass, inertia = sp.Integer(1), (sp.Integer(1),) * (3 if space else 1)
    if not fixed:
        mass = reader.number(table, "mass", "mass", path)
        inertia = reader.vector(table, "inertia", "inertia", path, 3) if space else (reader.number(table, "inertia", "inertia", path),)
        for key, values in (("mass", (mass,)), ("inertia", inertia)):
            if any(value.is_positive is False for value in values):
                reader.blame(f"{path}.{key}", "must be more than 0", "out_of_range")
    centre = reader.vector(table, "centre", "length", path, count, () if fixed else None) if several else (sp.Integer(0),) * count
    velocity = reader.vector(table, "velocity", "speed", path, count, () if several else None)
    spin = reader.vector(table, "spin", "spin", path, 3, ()) if space else (reader.number(table, "spin", "spin", path, 0),)
    return SymbolicBody(name, fixed, mass, inertia, centre, velocity, spin)


def _contact(table: Mapping[str, Any], k: int, index: Mapping[str, int] | None, space: bool, reader: _Reader) -> SymbolicContact:
    path, count = f"contact.{k}", 3 if space else 2
    reader.keys(table, [key for key in _CONTACT if key != "between" or index is not None], path)
    name = str(table.get("name", chr(ord("A") + k % 26)))
    into, out_of = 0, None
    if index is not None:
        between = table.get("between")
        if not isinstance(between, list | tuple) or len(between) != 2 or any(one not in index for one in between) or between[0] == between[1]:
            reader.blame(f"{path}.between", f"expected the names of two bodies, not {between!r}", "wrong_value", allowed=list(index))
        else:
            into, out_of = index[between[0]], index[between[1]]
    point = reader.vector(table, "point", "length", path, count)
    normal = reader.vector(table, "normal", "number", path, count)
    square = sp.trigsimp(sp.expand(sum(one**2 for one in normal)))
    if square == 0:
        if "normal" in table:
            reader.blame(f"{path}.normal", "has no direction: it must not be zero", "geometry")
        square = sp.Integer(1)
    normal = tuple(one / sp.sqrt(square) for one in normal)
    friction = reader.number(table, "friction", "number", path)
    restitution = reader.number(table, "restitution", "number", path, 0)
    if friction.is_negative:
        reader.blame(f"{path}.friction", f"{friction} must be 0 or more", "out_of_range")
    if restitution.is_negative or (1 - restitution).is_negative:
        reader.blame(f"{path}.restitution", f"{restitution} must be from 0 to 1", "out_of_range")
    return SymbolicContact(name, into, out_of, point, normal, friction, restitution)


def _of_operator(table: Mapping[str, Any], reader: _Reader) -> _Made:
    given = table["operator"]
    for key in ("body", "contact"):
        if key in table:
            reader.blame(key, "an operator has no bodies and no contacts beside it", "conflict")
    if not isinstance(given, Mapping):
        reader.blame("operator", "expected a table", "wrong_value")
        return False, (), (), None
    reader.keys(given, _OPERATOR, "operator")
    rows, speeds, space = _operator_parts(given, reader)
    size = 3 if space else 2
    count = len(rows) // size
    if count == 0 or len(rows) != count * size or any(len(row) != len(rows) for row in rows) or len(speeds) != len(rows):
        reader.blame("operator.matrix", "expected a square matrix of two rows for each contact (three in space), and a velocity for each row", "wrong_value")
        return space, (), (), None
    matrix = sp.Matrix(len(rows), len(rows), lambda i, j: reader.value(rows[i][j], "number", f"operator.matrix.{i}.{j}"))
    velocity = sp.Matrix([reader.value(one, "speed", f"operator.velocity.{i}") for i, one in enumerate(speeds)])
    if (matrix - matrix.T).applyfunc(sp.simplify) != sp.zeros(len(rows), len(rows)):
        reader.blame("operator.matrix", "is not symmetric", "wrong_value")
    normal = tuple(sp.Integer(int(k == size - 1)) for k in range(size))
    contacts = tuple(
        SymbolicContact(chr(ord("A") + k), 0, None, (), normal, _each(given, "friction", k, count, reader), _each(given, "restitution", k, count, reader)) for k in range(count)
    )
    return space, (), contacts, (matrix, velocity)


def _operator_parts(given: Mapping[str, Any], reader: _Reader) -> tuple[list[Any], list[Any], bool]:
    """Rows, velocities, and whether it is in space."""
    if "matrix" not in given:
        w = {key: given.get(key) for key in ("w_tt", "w_tn", "w_nn", "slip", "approach")}
        for key, value in w.items():
            if value is None:
                reader.blame(f"operator.{key}", "is missing: a number, or a matrix for several contacts", "missing_key")
        if None in w.values():
            return [], [], False
        return [[w["w_tt"], w["w_tn"]], [w["w_tn"], w["w_nn"]]], [w["slip"], w["approach"]], False
    rows, speeds = list(given["matrix"]), list(given.get("velocity", []))
    if speeds and all(isinstance(one, list | tuple) for one in speeds):
        return rows, [value for one in speeds for value in one], all(len(one) == 3 for one in speeds)
    return rows, speeds, len(rows) == 3


def _each(given: Mapping[str, Any], key: str, k: int, count: int, reader: _Reader) -> Any:
    value = given.get(key, 0 if key == "restitution" else None)
    if isinstance(value, list | tuple):
        if len(value) != count:
            reader.blame(f"operator.{key}", f"expected one number, or {count}", "wrong_value")
            return sp.Integer(0)
        value = value[k]
    if value is None:
        if k == 0:
            reader.blame(f"operator.{key}", "is missing: a number", "missing_key")
        return sp.Integer(0)
    return reader.value(value, "number", f"operator.{key}")

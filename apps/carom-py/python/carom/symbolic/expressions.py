"""Numbers that may be symbols: texts, quantities with units, and SymPy's own expressions.

Texts are read by a parser of our own, which knows arithmetic and a few functions and nothing else: a file may come from anywhere.
"""

from __future__ import annotations

import ast
import math
import operator
import re
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
import sympy as sp

#: Units of the impact file by dimension: what one of them is in SI.
UNITS: dict[str, dict[str, Any]] = {
    "length": {"m": 1, "mm": "1/1000", "cm": "1/100", "um": "1/1000000", "in": "127/5000", "ft": "1524/5000"},
    "mass": {"kg": 1, "g": "1/1000", "lb": "45359237/100000000"},
    "inertia": {"kg m^2": 1, "kg mm^2": "1/1000000", "kg cm^2": "1/10000", "g m^2": "1/1000", "g mm^2": "1/1000000000", "g cm^2": "1/10000000"},
    "speed": {"m/s": 1, "mm/s": "1/1000", "cm/s": "1/100", "in/s": "127/5000", "ft/s": "1524/5000"},
    "spin": {"rad/s": 1, "deg/s": sp.pi / 180, "rpm": sp.pi / 30},
    "number": {},
}

_QUANTITY = re.compile(r"^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([A-Za-zµ°].*?)\s*$")
_FUNCTIONS: dict[str, Any] = {"sin": sp.sin, "cos": sp.cos, "tan": sp.tan, "cot": sp.cot, "sqrt": sp.sqrt, "atan": sp.atan, "asin": sp.asin, "acos": sp.acos, "abs": sp.Abs}
_OPERATORS: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
}
#: Largest power that a text may ask for.
_LARGEST_POWER = 24


class Names:
    """The symbols of a problem, one for each name."""

    def __init__(self, known: Iterable[sp.Symbol] = ()) -> None:
        self.known: dict[str, sp.Symbol] = {}
        self.properties: dict[str, dict[str, bool]] = {}
        for symbol in known:
            self.known.setdefault(symbol.name, symbol)

    def symbol(self, name: str) -> sp.Symbol:
        """The symbol of this name: that of the caller, or a real one."""
        if name not in self.known:
            self.known[name] = sp.Symbol(name, **{"real": True, **self.properties.get(name, {})})
        return self.known[name]

    def read(self, text: str) -> Any:
        """An expression, or a list of relations where the text compares: ``"0 < gamma < pi/2"``.

        Raises ValueError with one sentence where the text is neither.
        """
        try:
            tree = ast.parse(text.strip().replace("^", "**"), mode="eval")
        except (SyntaxError, ValueError, MemoryError, RecursionError):
            raise ValueError(f"{text!r} is no expression") from None
        if isinstance(tree.body, ast.Compare):
            return self._compared(tree.body, text)
        return self._value(tree.body, text)

    def _compared(self, node: ast.Compare, text: str) -> list[Any]:
        sides = [self._value(one, text) for one in (node.left, *node.comparators)]
        kinds: dict[type[ast.cmpop], Any] = {ast.Lt: sp.Lt, ast.LtE: sp.Le, ast.Gt: sp.Gt, ast.GtE: sp.Ge, ast.Eq: sp.Eq, ast.NotEq: sp.Ne}
        out = []
        for how, left, right in zip(node.ops, sides, sides[1:]):
            if type(how) not in kinds:
                raise ValueError(f"{text!r} compares with something other than <, <=, >, >=, == and !=")
            out.append(kinds[type(how)](left, right))
        return out

    def _value(self, node: ast.expr, text: str) -> Any:
        match node:
            case ast.Constant(value=bool() | str() | bytes() | None):
                raise ValueError(f"{text!r} is no expression")
            case ast.Constant(value=int() | float() as value):
                return exact(value)
            case ast.Name(id="pi"):
                return sp.pi
            case ast.Name(id=name):
                return self.symbol(name)
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return -self._value(operand, text)
            case ast.UnaryOp(op=ast.UAdd(), operand=operand):
                return self._value(operand, text)
            case ast.BinOp(op=how, left=left, right=right) if type(how) in _OPERATORS:
                a, b = self._value(left, text), self._value(right, text)
                if isinstance(how, ast.Pow) and not (b.is_Rational and abs(b) <= _LARGEST_POWER):
                    raise ValueError(f"{text!r}: a power must be a number of at most {_LARGEST_POWER}")
                if isinstance(how, ast.Div) and b.is_zero:
                    raise ValueError(f"{text!r} divides by zero")
                return _OPERATORS[type(how)](a, b)
            case ast.Call(func=ast.Name(id=name), args=[argument], keywords=[]) if name in _FUNCTIONS:
                return _FUNCTIONS[name](self._value(argument, text))
            case _:
                raise ValueError(f"{text!r} is no expression: it may have numbers, names, + - * / **, pi and {', '.join(_FUNCTIONS)}")


def exact(value: float) -> Any:
    """A number as a fraction: that which its shortest decimal form says.

    >>> exact(0.3)
    3/10
    """
    if isinstance(value, int):
        return sp.Integer(value)
    if not math.isfinite(value):
        raise ValueError(f"{value} is not a finite number")
    return sp.Rational(repr(float(value)))


def quantity(value: object, dimension: str, names: Names) -> Any:
    """A value of an impact file: a number in SI, a text with a unit, a text with symbols, or an expression of SymPy.

    Raises ValueError with one sentence.
    """
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, bool):
        raise ValueError(f"{value} is neither a number nor an expression")
    if isinstance(value, int | float):
        return exact(value)
    if isinstance(value, sp.Expr):
        for symbol in value.atoms(sp.Symbol):
            names.known.setdefault(symbol.name, symbol)
        return _rational(value)
    if isinstance(value, str) and value.strip():
        return _text(value, dimension, names)
    raise ValueError(f"{value!r} is neither a number nor an expression")


def _rational(value: Any) -> Any:
    """The same without floating-point numbers."""
    return value.xreplace({one: exact(float(one)) for one in value.atoms(sp.Float)})


def _text(value: str, dimension: str, names: Names) -> Any:
    with_unit = _QUANTITY.match(value)
    if with_unit is None:
        out = names.read(value)
        if isinstance(out, list):
            raise ValueError(f"{value!r} compares: expected an expression")
        return out
    number, unit = with_unit.groups()
    plain = unit.replace("²", "^2").replace("·", " ").replace("µ", "u").replace("°", "deg")
    table = UNITS[dimension]
    if plain not in table:
        what = f"units are {', '.join(table)}" if table else "a pure number has no unit"
        raise ValueError(f"{value!r} has an unknown unit: {what}")
    return sp.Rational(number) * (table[plain] if isinstance(table[plain], sp.Expr) else sp.Rational(table[plain]))

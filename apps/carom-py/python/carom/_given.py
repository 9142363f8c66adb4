"""What is given: a file, a text, or a dictionary."""

from __future__ import annotations

import json
import math
import operator
import os
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Protocol, TypeAlias

import numpy as np

from carom.errors import CaromError, Problem

#: A file, a text with the keys of the file, or a dictionary with them.
FileLike: TypeAlias = str | os.PathLike[str] | Mapping[str, Any]
#: Values by their paths: numbers are SI, text has a unit.
Values: TypeAlias = Mapping[str, float | str]


class Frame(Protocol):
    """A table with named columns, of pandas or polars."""

    @property
    def columns(self) -> Any:
        """The names."""

    def __getitem__(self, name: Any, /) -> Any:
        """A column."""


def is_path(given: str | os.PathLike[str]) -> bool:
    """True of the name of a file: a text of one line that ends like one, or has no equals sign, or is one."""
    if not isinstance(given, str):
        return True
    if "\n" in given:
        return False
    return given.endswith((".toml", ".stl")) or "=" not in given or os.path.isfile(given)


def mapping(given: object, name: str) -> Mapping[str, Any]:
    """What was given, where it is a dictionary."""
    if isinstance(given, Mapping):
        return given
    raise CaromError(f"{name}: expected a dictionary, not {type(given).__name__}")


def as_text(path: str, value: object, unit: str) -> str:
    """A value as a file has it: numbers are in this unit."""
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, str) and value.strip():
        return value
    if isinstance(value, int | float) and not isinstance(value, bool) and abs(value) < math.inf and abs(value) <= sys.float_info.max:
        return f"{float(value)!r} {unit}".strip()
    message = f"{path}: expected a finite number, or a text with a unit, not {value!r}"
    raise CaromError(message, [Problem(message, kind="wrong_value", path=path)])


def _plain(value: object, path: str, problems: list[Problem]) -> object:
    """A value as JSON has it; what it cannot be is noted."""
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, Mapping):
        return {str(key): _plain(one, f"{path}.{key}" if path else str(key), problems) for key, one in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(one, f"{path}.{k}", problems) for k, one in enumerate(value)]
    if value is None or isinstance(value, str | bool | int) or (isinstance(value, float) and math.isfinite(value)):
        return value
    what = f"{value} is not a finite number" if isinstance(value, float) else f"{type(value).__name__} is neither a number, a text, a list nor a dictionary"
    problems.append(Problem(what, kind="wrong_value", path=path, key=path.rsplit(".", 1)[-1], value=repr(value)[:200]))
    return None


def as_json(given: Mapping[str, Any]) -> str:
    """One JSON object; numbers and arrays of NumPy are taken as they are."""
    problems: list[Problem] = []
    try:
        plain = _plain(given, "", problems)
    except RecursionError:
        raise CaromError("the dictionary is too deep, or holds itself") from None
    if problems:
        raise CaromError("\n".join(f"{one.path}: {one.message}" for one in problems), problems)
    return json.dumps(plain, allow_nan=False)


def text_of(path: str | os.PathLike[str]) -> str:
    """The text of a file."""
    try:
        return Path(path).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        why = "there is no such file" if isinstance(error, FileNotFoundError) else str(error)
        raise CaromError(f"{os.fspath(path)}: {why}", [Problem(why, kind="file")]) from error


def read(given: FileLike, name: str) -> tuple[str, str, bool]:
    """Name, text, and whether the text is JSON."""
    if isinstance(given, Mapping):
        return name, as_json(given), True
    if not isinstance(given, str | os.PathLike):
        raise CaromError(f"{name}: expected a file, a text or a dictionary, not {type(given).__name__}")
    if is_path(given):
        return os.fspath(given), text_of(given), False
    return name, os.fspath(given), False


def number(name: str, value: object) -> float:
    """A finite number."""
    try:
        found = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        found = math.nan
    if isinstance(value, str) or not math.isfinite(found):
        raise CaromError(f"{name}: expected a finite number, not {value!r}", [Problem("is no finite number", kind="wrong_value", path=name, value=repr(value)[:200])])
    return found


def within(name: str, value: int, low: int, high: int) -> int:
    """A whole number that is neither too small nor too large."""
    try:
        whole = operator.index(value)
    except TypeError:
        raise CaromError(f"{name}: expected a whole number, not {value!r}") from None
    if not low <= whole <= high:
        raise CaromError(f"{name}: {whole} is outside {low} to {high}")
    return whole


def table_of(given: Any) -> Mapping[str, Any] | None:
    """Columns by their names: of a dictionary, of a structured array, of a frame of pandas or polars; None of what is no table."""
    if isinstance(given, Mapping):
        return given
    if isinstance(given, np.ndarray):
        return None if given.dtype.names is None else {name: given[name] for name in given.dtype.names}
    columns = getattr(given, "columns", None)
    if columns is None or not hasattr(given, "__getitem__"):
        return None
    return {str(name): given[name] for name in columns}

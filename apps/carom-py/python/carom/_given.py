"""What is given: a file, a text, or a dictionary."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np

from carom.errors import CaromError, Problem

#: A file, a text with the keys of the file, or a dictionary with them.
FileLike: TypeAlias = str | os.PathLike[str] | Mapping[str, Any]


def is_path(given: str | os.PathLike[str]) -> bool:
    """True of the name of a file: a text of one line without an equals sign."""
    return not isinstance(given, str) or ("\n" not in given and "=" not in given)


def _plain(value: object) -> object:
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, np.generic):
        return value.item()
    raise TypeError(f"{type(value).__name__} is neither a number, a text, a list nor a dictionary")


def as_json(given: Mapping[str, Any]) -> str:
    """One JSON object; numbers and arrays of NumPy are taken as they are."""
    try:
        return json.dumps(dict(given), default=_plain, allow_nan=False)
    except (TypeError, ValueError) as error:
        raise CaromError(str(error), [Problem(str(error))]) from error


def read(given: FileLike, name: str) -> tuple[str, str, bool]:
    """Name, text, and whether the text is JSON."""
    if isinstance(given, Mapping):
        return name, as_json(given), True
    if is_path(given):
        path = os.fspath(given)
        try:
            return path, Path(path).read_text(encoding="utf-8"), False
        except (OSError, UnicodeDecodeError) as error:
            why = "there is no such file" if isinstance(error, FileNotFoundError) else str(error)
            raise CaromError(f"{path}: {why}", [Problem(why, kind="file")]) from error
    return name, os.fspath(given), False

"""From the engine's JSON to objects."""

from __future__ import annotations

import dataclasses
import html
import json
import types
import typing
from pathlib import Path
from typing import Any, Self


@dataclasses.dataclass(frozen=True, kw_only=True)
class Answer:
    """An answer of the engine: its fields, the JSON that the command prints, and the files that the command writes."""

    @property
    def json(self) -> str:
        """The answer as the command writes it, byte for byte (of a study but for the time it took)."""
        text: str = self.__dict__["_json"]
        return text

    @property
    def files(self) -> dict[str, str]:
        """What the command writes, by the names of its files: the JSON, pages, tables, pictures."""
        files: dict[str, str] = self.__dict__["_files"]
        return files

    @property
    def tables(self) -> dict[str, bytes]:
        """What the command writes that is no text, by the names of its files: tables as Parquet, the motion of a solid part as glTF."""
        tables: dict[str, bytes] = self.__dict__["_tables"]
        return tables

    def to_dict(self) -> dict[str, Any]:
        """The answer as plain dictionaries and lists."""
        plain: dict[str, Any] = json.loads(self.json)
        return plain

    def save(self, folder: str | Path) -> list[Path]:
        """Writes :attr:`files` and :attr:`tables` into a folder, which is made where it is not there; returns where they are."""
        place = Path(folder)
        place.mkdir(parents=True, exist_ok=True)
        for name, text in self.files.items():
            (place / name).write_text(text, encoding="utf-8", newline="")
        for name, table in self.tables.items():
            (place / name).write_bytes(table)
        return [place / name for name in (*self.files, *self.tables)]

    def _repr_html_(self) -> str | None:
        """The page of the answer, for a notebook. It runs apart from the notebook's own page."""
        page = next((text for name, text in self.files.items() if name.endswith(".html")), None)
        if page is None:
            return None
        source = html.escape(page, quote=True)
        return f'<iframe srcdoc="{source}" sandbox="allow-scripts" style="width: 100%; height: 60em; border: 0"></iframe>'

    def _repr_svg_(self) -> str | None:
        """The picture of an answer that has no page, for a notebook."""
        return next((text for name, text in self.files.items() if name.endswith(".svg")), None)

    @classmethod
    def _of(cls, answer: tuple[str, dict[str, str]], file: str, tables: dict[str, bytes] | None = None) -> Self:
        text, files = answer
        made: Self = _build(cls, json.loads(text))
        made.__dict__["_json"] = text
        made.__dict__["_files"] = {file: text, **files}
        made.__dict__["_tables"] = tables or {}
        return made


def _build(kind: Any, value: Any) -> Any:
    """A value of JSON as a value of this type."""
    if dataclasses.is_dataclass(kind) and isinstance(value, dict):
        return _object(typing.cast(type, kind), value)
    origin, arguments = typing.get_origin(kind), typing.get_args(kind)
    if origin is list:
        return [_build(arguments[0], one) for one in value]
    if origin is dict:
        return {key: _build(arguments[1], one) for key, one in value.items()}
    if origin in (typing.Union, types.UnionType):
        return _one_of([one for one in arguments if one is not type(None)], value)
    # A whole number of JSON may be any number.
    return float(value) if kind is float and isinstance(value, int) else value


def _one_of(kinds: list[Any], value: Any) -> Any:
    """A value of one of several types: of several classes that which has all of its keys."""
    if value is None:
        return None
    if isinstance(value, dict):
        classes = [kind for kind in kinds if dataclasses.is_dataclass(kind)]
        fitting = [kind for kind in classes if {_key(one) for one in dataclasses.fields(kind)} >= set(value)]
        return _build((fitting or kinds)[0], value)
    lists = [kind for kind in kinds if typing.get_origin(kind) is list]
    if isinstance(value, list) and lists:
        return _build(lists[0], value)
    if isinstance(value, int) and not isinstance(value, bool) and float in kinds and int not in kinds:
        return float(value)
    return value


def _key(field: dataclasses.Field[Any]) -> str:
    """The key of JSON that a field is: a keyword of Python has a line below behind it."""
    return field.name.removesuffix("_")


_HINTS: dict[type, dict[str, Any]] = {}


def _object(kind: type, value: dict[str, Any]) -> Any:
    hints = _HINTS.get(kind)
    if hints is None:
        hints = _HINTS[kind] = typing.get_type_hints(kind)
    known = {_key(field): field.name for field in dataclasses.fields(kind)}
    return kind(**{known[key]: _build(hints[known[key]], one) for key, one in value.items()})

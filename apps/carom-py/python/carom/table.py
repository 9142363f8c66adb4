"""Answers by the million."""

from __future__ import annotations

import html
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from carom import _carom


class Table:
    """A table whose columns NumPy, pandas, polars, DuckDB and pyarrow read.

    A column is ``table["flat_s"]``: numbers as ``float64``, NaN where there is none; words as text, None where there is none. All of it goes
    to another library by Arrow: ``polars.DataFrame(table)``, ``pandas.DataFrame.from_arrow(table)`` (or of ``dict(table)``, which older ones take),
    ``pyarrow.table(table)``; DuckDB asks a name that holds it. :meth:`to_numpy` makes one structured array of it.

    >>> import carom
    >>> table = carom.drops("examples/case_2.toml", {"contact.friction": [0.05, 0.15, 0.5]})
    >>> table["ending"].tolist()
    ['same side', 'turned', 'stuck']
    """

    def __init__(self, inner: _carom.Table) -> None:
        self._inner = inner

    @property
    def columns(self) -> list[str]:
        """The names of the columns, in their order."""
        return self._inner.names

    @property
    def units(self) -> dict[str, str]:
        """The unit of each column; empty of words and plain numbers."""
        return dict(zip(self._inner.names, self._inner.units, strict=True))

    def __len__(self) -> int:
        return len(self._inner)

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def keys(self) -> list[str]:
        """The names of the columns: with them ``dict(table)`` holds every column."""
        return self.columns

    def __getitem__(self, name: str) -> NDArray[Any]:
        found = self._inner.column(name)
        if isinstance(found, tuple):
            numbers, words = found
            # Number −1, of no word, is the last of the list.
            return np.array([*words, None], dtype=object)[numbers]
        return found

    def counts(self, name: str = "ending") -> dict[str, int]:
        """How often each word of a column occurs, the most frequent first."""
        found = self._inner.column(name)
        if not isinstance(found, tuple):
            raise TypeError(f'"{name}" holds numbers: only words are counted')
        numbers, words = found
        each = np.bincount(numbers[numbers >= 0], minlength=len(words)).tolist()
        found_words = [(word, count) for word, count in zip(words, each, strict=True) if count > 0]
        return dict(sorted(found_words, key=lambda pair: -pair[1]))

    def to_numpy(self) -> NDArray[Any]:
        """The table as one structured array: numbers as ``f8``, words as text."""
        columns = {name: self[name] for name in self.columns}
        kinds = [(name, column.dtype if column.dtype != object else "U32") for name, column in columns.items()]
        whole = np.empty(len(self), dtype=kinds)
        for name, column in columns.items():
            whole[name] = column if column.dtype != object else np.where(column == None, "", column)  # noqa: E711
        return whole

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        whole = self.to_numpy()
        return whole if dtype is None else whole.astype(dtype)

    def __arrow_c_stream__(self, requested_schema: Any = None) -> Any:
        return self._inner.__arrow_c_stream__(requested_schema)

    def __reduce__(self) -> tuple[Any, ...]:
        return (_again, ([(name, unit, self._inner.column(name)) for name, unit in self.units.items()],))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Table):
            return NotImplemented
        return self.units == other.units and all(_same(self[name], other[name]) for name in self.columns)

    def __repr__(self) -> str:
        shown = {name: self[name][:5].tolist() for name in self.columns}
        lines = [f"{name}{f' [{unit}]' if unit else ''}: {', '.join(map(str, shown[name]))}" for name, unit in self.units.items()]
        more = ", …" if len(self) > 5 else ""
        return f"carom.Table of {len(self)} rows\n" + "\n".join(line + more for line in lines)

    def _repr_html_(self) -> str:
        names = [html.escape(f"{name} [{unit}]" if unit else name) for name, unit in self.units.items()]
        head = "".join(f"<th>{name}</th>" for name in names)
        some = [self[name][:10].tolist() for name in self.columns]
        cells = ["".join(f"<td>{'' if cell is None else html.escape(str(cell))}</td>" for cell in row) for row in zip(*some, strict=True)]
        rows = "".join(f"<tr>{row}</tr>" for row in cells)
        return f"<p>{len(self)} rows</p><table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>"


def _same(a: NDArray[Any], b: NDArray[Any]) -> bool:
    """True of columns that are equal; places without a number are."""
    return bool(np.array_equal(a, b, equal_nan=a.dtype != object))


def _again(columns: list[tuple[str, str, Any]]) -> Table:
    return Table(_carom.Table(columns))

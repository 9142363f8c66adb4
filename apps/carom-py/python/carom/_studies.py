"""Studies over ranges: maps, region diagrams, feeds, fits."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Mapping, Sequence
from typing import Any, Literal, TypeAlias

import numpy as np

from carom import _carom
from carom._given import FileLike, Frame, Values, as_text, mapping, number, read, table_of, text_of, within
from carom._progress import Progress, Told
from carom.answers.feed import Feed
from carom.answers.fit import Fit
from carom.answers.map import Map
from carom.answers.regions import Regions
from carom.errors import CaromError
from carom.scene import SceneLike, scene_of

#: A quantity and its range: a text as the command takes it, ``"contact.friction=0..0.3:80"``, or ``("contact.friction", 0, 0.3)``, perhaps with
#: the number of cells. Numbers are SI.
Axis: TypeAlias = str | tuple[str, float | str, float | str] | tuple[str, float | str, float | str, int]

#: Drops that were observed: a file in CSV, its text, columns by their names, or a frame.
Runs: TypeAlias = str | os.PathLike[str] | Mapping[str, Any] | Frame


def _axis(name: str, given: object) -> str:
    """A range as the command takes it."""
    if isinstance(given, str):
        return given
    if not isinstance(given, tuple | list) or len(given) not in (3, 4) or not isinstance(given[0], str):
        raise CaromError(f"{name}: expected a text, or (path, low, high) or (path, low, high, cells), not {given!r}")
    path, low, high, *cells = given
    ends = f"{path}={as_text(name, low, '')}..{as_text(name, high, '')}"
    return f"{ends}:{cells[0]}" if cells else ends


def map(
    scene: SceneLike,
    x: Axis,
    y: Axis,
    *,
    plate: str | int | None = None,
    accuracy: float | None = None,
    depth: int = 3,
    cells: bool = False,
    set: Values | None = None,
    progress: Progress = None,
) -> Map:
    """How a drop ends over two quantities of a scene, as ``carom map`` draws it: boundaries between outcomes, located, and not a raster.

    ``x`` and ``y`` are ranges, ``"plate.lower.slope=2..38 deg:100"`` or ``("contact.friction", 0.05, 0.17)``. ``accuracy`` is how finely
    boundaries are located, as a share of the axes, 1e-7 where none is given; ``depth`` how often a cell is halved where something in it does not fit. ``plate`` is the one
    that is looked at, the last where none is given. :attr:`Answer.files` holds the picture and the boundaries, :attr:`Answer.tables` the nodes.

    With ``cells`` it says how the drop at the middle of every cell ends as well: boundaries are then followed on a grid eight times as coarse, to a
    tenth of a cell at least, and only drops beside them are made one by one. ``map.cells`` counts them, ``map-cells.csv`` and ``map-cells.parquet`` hold all.

    Raises :class:`CaromError` with every problem; KeyboardInterrupt within a moment of ctrl-C.

    >>> import carom
    >>> map = carom.map("examples/case_2.toml", ("contact.friction", 0.05, 0.17, 8), ("plate.upper.slope", "10 deg", "25 deg", 8))
    >>> [label.words for label in map.labels]
    ['same side', 'turned']
    """
    inner = scene_of(scene, set)
    asks = {"x": _axis("x", x), "y": _axis("y", y), "plate": _plate(plate), "accuracy": None if accuracy is None else number("accuracy", accuracy), "depth": within("depth", depth, 0, 8), "cells": bool(cells)}
    with Told(progress) as hear:
        text, files, tables = _carom.map(inner, asks, hear)
    return Map._of((text, files), "map.json", tables)


def regions(
    of: Literal["cylinder", "prism", "rod", "strike", "pyramid", "contact", "stool", "stool-strike"] | FileLike,
    x: Axis | None = None,
    y: Axis | None = None,
    *,
    set: Values | None = None,
    elastic: float | None = None,
    depth: int = 3,
    progress: Progress = None,
) -> Regions:
    """In which regions of two quantities the same thing happens, as ``carom regions`` draws it, with the closed forms over it where there are any.

    ``of`` is one of the kinds, or an impact: a file, a text or a dictionary, any two numbers of which may be axes (``body.spin``). Kinds have
    axes of their own; an impact has none. ``elastic`` labels the whole impact with this restitution, not the end of compression (cylinder, prism, rod).

    Raises :class:`CaromError` with every problem; KeyboardInterrupt within a moment of ctrl-C.

    >>> import carom
    >>> rod = carom.regions("rod", ("to_a", 0.1, 0.4, 8), ("to_b", 0.1, 0.4, 8))
    >>> [(form.curve, form.largest_distance_share < 1e-9) for form in rod.closed_forms]
    [('1|2  12ab = l²', True)]
    """
    kind = of if isinstance(of, str) and of.replace("-", "").isalpha() else None
    values = [f"{key}={as_text(key, value, '')}" for key, value in mapping(set or {}, "set").items()]
    asks = {
        "kind": kind,
        "file": None if kind is not None else read(of, "impact"),
        "set": values,
        "x": None if x is None else _axis("x", x),
        "y": None if y is None else _axis("y", y),
        "elastic": None if elastic is None else number("elastic", elastic),
        "depth": within("depth", depth, 0, 8),
    }
    with Told(progress) as hear:
        text, files, tables = _carom.regions(asks, hear)
    return Regions._of((text, files), "regions.json", tables)


def feed(
    scene: SceneLike,
    *,
    parts: int | None = None,
    intervals: int = 400,
    accuracy: float = 1e-6,
    set: Values | None = None,
    progress: Progress = None,
) -> Feed:
    """How closely parts may follow each other, as ``carom feed`` finds it: the smallest interval at which they do not touch.

    ``parts`` are fed, as the scene's ``[feed]`` says or 3; ``intervals`` are looked at first, and changes located to ``accuracy`` [s].
    :attr:`Answer.files` holds the picture, the table, and scenes of the longest interval with a touch and of the smallest without.
    Solid parts are followed until they touch: what is said is so for any number of them, and no scene is saved.

    Raises :class:`CaromError` with every problem of the scene; KeyboardInterrupt within a moment of ctrl-C.

    >>> import carom
    >>> found = carom.feed("examples/feed_closely.toml", parts=2, intervals=16)
    >>> round(found.smallest.interval_s, 4)
    0.2426
    """
    parts = None if parts is None else within("parts", parts, 0, 1 << 31)
    with Told(progress) as hear:
        answer = _carom.feed(scene_of(scene, set), parts, within("intervals", intervals, 0, 1 << 31), number("accuracy", accuracy), hear)
    return Feed._of(answer, "feed.json")


def fit(
    scene: SceneLike,
    runs: Runs,
    *,
    over: Axis | Sequence[Axis] = (),
    level: float = 0.95,
    scatter: float | str | None = None,
    samples: int = 256,
    nodes: int = 10_000,
    seed: int = 1,
    plate: str | int | None = None,
    set: Values | None = None,
    progress: Progress = None,
) -> Fit:
    """Which friction, which restitution agrees with drops that were observed, as ``carom fit`` finds it.

    ``runs`` are the drops: a file in CSV, its text, or columns by their names (a dictionary, or a frame of pandas or polars): ``outcome``, ``face``, ``time`` [s],
    ``scatter`` [s], ``drops`` (how many the row tells of), and quantities of the scene. ``over`` are the quantities to fit with their ranges;
    every friction and restitution that the scene writes, 0 to 1, where none are given. ``level`` is the probability that an interval holds, ``scatter`` the
    standard deviation of times [s], fitted where none is given. :attr:`Answer.files` holds the scene with what was found.

    Raises :class:`CaromError` with every problem of the scene and of the rows, and where no value gives the rows; KeyboardInterrupt
    within a moment of ctrl-C.

    >>> import carom
    >>> seen = {"contact.friction": [0.02, 0.15], "outcome": ["same", "turned"], "drops": [4, 5]}
    >>> fit = carom.fit("examples/case_2.toml", seen, over=("contact.restitution", 0, 0.5))
    >>> fit.observed_drops, fit.parameters[0].name
    (9, 'contact.restitution')
    """
    inner = scene_of(scene, set)
    # One range alone: a text, or a tuple that begins with a path and no range.
    alone = isinstance(over, str) or (isinstance(over, tuple) and len(over) > 2 and isinstance(over[0], str) and "=" not in over[0])
    if not isinstance(over, str | Sequence):
        raise CaromError(f"over: expected ranges, not {over!r}")
    ranges = [over] if alone else over
    asks = {
        "over": [_axis("over", one) for one in ranges],
        "level": number("level", level),
        "scatter": None if scatter is None else as_text("scatter", scatter, "s"),
        "samples": within("samples", samples, 16, 1 << 20),
        "nodes": within("nodes", nodes, 100, 1 << 20),
        "seed": within("seed", seed, 0, (1 << 64) - 1),
        "plate": _plate(plate),
    }
    rows = _rows(runs)
    with Told(progress) as hear:
        answer = _carom.fit(inner, rows, asks, hear)
    return Fit._of(answer, "fit.json")


def _plate(given: str | int | None) -> str | None:
    return None if given is None else str(given)


def _rows(runs: Runs) -> tuple[str, str]:
    """The name of a table of drops, and its text as CSV."""
    columns = table_of(runs)
    if columns is None:
        if isinstance(runs, str) and "\n" in runs:
            return "runs", runs
        if not isinstance(runs, str | os.PathLike):
            raise CaromError(f"runs: expected a file, a text or columns, not {type(runs).__name__}")
        return os.fspath(runs), text_of(runs)
    columns = {name: np.atleast_1d(np.asarray(values, dtype=object)) for name, values in columns.items()}
    lengths = {name: len(values) for name, values in columns.items()}
    if len(np.unique(list(lengths.values()))) > 1:
        raise CaromError(f"runs: columns of one length are needed, not {lengths}")
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(zip(*([_cell(one) for one in values] for values in columns.values()), strict=True))
    return "runs", out.getvalue()


def _cell(value: object) -> str:
    """A value of a table; what is missing was not looked at."""
    if isinstance(value, np.generic):
        value = value.item()
    if value is None or value != value:
        return ""
    # Whole numbers beside a missing one are floats in a frame.
    return repr(int(value) if value.is_integer() else value) if isinstance(value, float) else str(value)

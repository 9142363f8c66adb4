"""Drops and impacts by the million."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from carom import _carom
from carom._given import Frame, Values, mapping, table_of
from carom._progress import Progress, Told
from carom.errors import CaromError, Problem
from carom.scene import SceneLike, scene_of
from carom.table import Table


def _columns(given: Mapping[str, Any], what: str, problems: list[Problem]) -> list[tuple[str, NDArray[np.float64]]]:
    """Columns of numbers; all that are none are told together, with the problems that are known already."""
    columns: list[tuple[str, NDArray[np.float64]]] = []
    for name, values in given.items():
        try:
            # A place that is masked has no number.
            masked = isinstance(values, np.ma.MaskedArray) and values.dtype.kind in "biuf"
            array = np.atleast_1d(np.ma.filled(values.astype(float), np.nan) if masked else np.asarray(values))
        except ValueError as error:
            problems.append(Problem(str(error), kind="wrong_value", path=name))
            continue
        if array.dtype.kind not in "biuf":
            problems.append(Problem(f"holds {_kind(array)}, not numbers", kind="wrong_value", path=name))
        elif array.ndim != 1:
            problems.append(Problem(f"has the shape {array.shape}, not one value a row", kind="wrong_value", path=name))
        else:
            columns.append((name, np.asarray(array, dtype=np.float64)))
    if problems:
        raise CaromError("\n".join(f"{what}: {one.path}: {one.message}" for one in problems), problems)
    return columns


def _kind(array: NDArray[Any]) -> str:
    return {"U": "text", "S": "bytes", "O": "objects", "c": "complex numbers", "M": "dates", "m": "times"}.get(array.dtype.kind, str(array.dtype))


def drops(
    scene: SceneLike,
    columns: Mapping[str, ArrayLike] | NDArray[Any] | Frame,
    *,
    plate: str | int | None = None,
    set: Values | None = None,
    progress: Progress = None,
) -> Table:
    """One drop in each design, on all cores.

    ``columns`` gives quantities of the scene by their paths, SI (angles in rad), one value a row; one value alone stands for every row. A
    structured array and a frame of pandas or polars are taken as well. ``set`` gives other values to the scene first. ``plate`` is the one whose ending is told, the last where none is given. The columns that come out are those of
    ``carom sweep``: ``ending``, ``outcome``, ``impact_speed_m_s``, ``max_sliding_speed_m_s``, ``first_touch_s``, ``flat_s``, ``end_s``, ``margin``.

    ``ending`` is ``same side``, ``turned`` or ``face 2`` where the part lies on the plate, ``stays`` of a disc, how the run ended where it does not
    (``delivered``, ``stuck``, ``on end``, ``jammed``, ``missed``, ``escaped``, …), ``no such feeder`` where the values draw nothing that can be. Numbers
    that there are not are NaN.

    Raises :class:`CaromError` that names rows and columns; KeyboardInterrupt within a moment of ctrl-C.

    >>> import carom, numpy as np
    >>> friction = np.linspace(0.01, 0.17, 5)
    >>> carom.drops("examples/case_2.toml", {"contact.friction": friction}).counts()
    {'turned': 3, 'same side': 2}
    """
    named = table_of(columns)
    if named is None and isinstance(columns, np.ndarray):
        raise CaromError("columns: the array has no names: give a structured array or a dictionary of columns")
    inner = scene_of(scene, set)
    given = _columns(mapping(named or columns, "columns"), "drops", [])
    with Told(progress) as hear:
        return Table(_carom.drops(inner, given, None if plate is None else str(plate), hear))


def impacts(
    *,
    mass: ArrayLike,
    inertia: ArrayLike,
    arm: ArrayLike,
    velocity: ArrayLike,
    normal: ArrayLike = (0.0, 1.0),
    spin: ArrayLike = 0.0,
    friction: ArrayLike = 0.0,
    restitution: ArrayLike = 0.0,
    law: Literal["poisson", "stronge", "newton"] = "poisson",
    progress: Progress = None,
) -> Table:
    """Impacts of a free planar body at one contact, one a row, on all cores: the staged walk of each by the law that is asked for.

    Where the laws allow other end states beside it, or it ends in none of them, :func:`impact` says so of one; no column does.

    ``arm`` (from the mass centre to the contact [m]), ``normal`` (out of the obstacle, of any length) and ``velocity`` of the mass centre [m/s] have
    two components: shape ``(2,)`` for all rows, or ``(n, 2)``. ``mass`` [kg], ``inertia`` [kg m²], ``spin`` [rad/s], ``friction`` and
    ``restitution`` are one value for all rows or ``(n,)``.

    The columns that come out: impulses along the normal and the tangent (the normal turned a quarter clockwise), velocity and spin after, slip
    and normal velocity of the contact after, the type of the impact (1 to 7; 0 where the contact did not approach), what the impact does to
    the energy, the margin of what the walk decided (NaN where it decided nothing), and what the contact does in the end. Where the numbers
    overflow all are NaN.

    Raises :class:`CaromError` that names rows and columns.

    >>> import carom
    >>> fallen = carom.impacts(mass=1, inertia=0.4, arm=(0, -1), velocity=[(0, -2), (7, -2)], friction=0.3, restitution=0.5)
    >>> fallen["velocity_y_m_s"].tolist(), fallen["type"].tolist()
    ([1.0, 1.0], [3.0, 1.0])
    """
    given: dict[str, Any] = {"mass": mass, "inertia": inertia}
    problems: list[Problem] = []
    for name, pair in {"arm": arm, "normal": normal, "velocity": velocity}.items():
        try:
            array = np.ma.asanyarray(pair) if isinstance(pair, np.ma.MaskedArray) else np.asarray(pair)
        except ValueError as error:
            problems.append(Problem(str(error), kind="wrong_value", path=name))
            continue
        if array.shape[-1:] != (2,) or array.ndim > 2:
            problems.append(Problem(f"has the shape {array.shape}, not (2,) or (n, 2)", kind="wrong_value", path=name))
            continue
        given[f"{name}_x"], given[f"{name}_y"] = array[..., 0], array[..., 1]
    given |= {"spin": spin, "friction": friction, "restitution": restitution}
    columns = [array for _, array in _columns(given, "impacts", problems)]
    with Told(progress) as hear:
        return Table(_carom.impacts(columns, law, hear))

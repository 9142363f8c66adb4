"""Impacts at several contacts by the thousand."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from carom import _carom
from carom._progress import Progress, Told
from carom.errors import CaromError, Problem
from carom.table import Table

#: Most contacts that a body may have.
MOST_CONTACTS = 24


def _array(name: str, given: Any, axes: tuple[str, ...], problems: list[Problem]) -> NDArray[np.float64] | None:
    """Numbers with as many axes as are named, or fewer: then they stand for every row."""
    try:
        masked = isinstance(given, np.ma.MaskedArray) and given.dtype.kind in "biuf"
        array = np.ma.filled(given.astype(float), np.nan) if masked else np.asarray(given)
    except ValueError as error:
        problems.append(Problem(str(error), kind="wrong_value", path=name))
        return None
    shape = f"({', '.join(axes)}{',' if len(axes) == 1 else ''})"
    if array.dtype.kind not in "biuf":
        problems.append(Problem(f"holds {array.dtype}, not numbers", kind="wrong_value", path=name))
    elif array.ndim > len(axes) or (axes[-1] == "2" and array.shape[-1:] != (2,)):
        problems.append(Problem(f"has the shape {array.shape}, not {shape}", kind="wrong_value", path=name))
    else:
        return np.asarray(array, dtype=np.float64)
    return None


def impact_batch(
    mass: ArrayLike,
    inertia: ArrayLike,
    points: ArrayLike,
    normals: ArrayLike,
    friction: ArrayLike,
    restitution: ArrayLike,
    velocity: ArrayLike,
    spin: ArrayLike = 0.0,
    law: Literal["poisson", "stronge", "newton"] = "poisson",
    *,
    progress: Progress = None,
) -> dict[str, NDArray[Any]]:
    """Impacts of a free planar body at ``k`` contacts, one a row, on all cores: what :func:`impact` says of each.

    ``points`` (from the mass centre [m]) and ``normals`` (out of the obstacle, of any length) have the shape ``(n, k, 2)``; ``(k, 2)`` stands
    for every row. ``friction`` and ``restitution`` are ``(n, k)``, ``(k,)`` for every row, or one number; ``velocity`` of the mass centre
    [m/s] is ``(n, 2)`` or ``(2,)``; ``mass`` [kg], ``inertia`` [kg m²] and ``spin`` [rad/s] are ``(n,)`` or one number.

    The arrays that come out: ``outcome`` (``unique``, ``several``, ``path_dependent``, ``none``, ``unresolved``; of more than six contacts ``found`` or
    ``not_found``), ``velocity_m_s`` ``(n, 2)``, ``spin_rad_s``, ``energy_before_J`` and ``energy_after_J`` ``(n,)``; of each contact, ``(n, k)``,
    ``state``, ``normal_impulse_N_s``, ``tangential_impulse_N_s`` (the tangent is the normal turned a quarter clockwise), ``normal_velocity_m_s`` and
    ``slip_m_s``. Where the walk has no end, or numbers overflow, they are NaN. Of one contact :func:`impacts` is faster.

    Raises :class:`CaromError` that names rows and columns.

    >>> import carom
    >>> feet, up = [(-0.05, -0.02), (0.05, -0.02)], (0, 1)
    >>> landed = carom.impact_batch(1, 2e-3, feet, [up, up], 0.3, 0.2, velocity=[(0.6, -1), (0, -1)], spin=[3, 0])
    >>> landed["outcome"].tolist(), landed["velocity_m_s"].round(3).tolist()
    (['unique', 'unique'], [[0.24, 0.2], [0.0, 0.2]])
    """
    problems: list[Problem] = []
    given = {
        "mass": _array("mass", mass, ("n",), problems),
        "inertia": _array("inertia", inertia, ("n",), problems),
        "velocity": _array("velocity", velocity, ("n", "2"), problems),
        "spin": _array("spin", spin, ("n",), problems),
        "points": _array("points", points, ("n", "k", "2"), problems),
        "normals": _array("normals", normals, ("n", "k", "2"), problems),
        "friction": _array("friction", friction, ("n", "k"), problems),
        "restitution": _array("restitution", restitution, ("n", "k"), problems),
    }
    found = given["points"]
    count = found.shape[-2] if found is not None and found.ndim > 1 else 1
    if not 1 <= count <= MOST_CONTACTS:
        problems.append(Problem(f"has {count} contacts, not 1 to {MOST_CONTACTS}", kind="out_of_range", path="points"))
    for name, last in {"points": 2, "normals": 2, "friction": 1, "restitution": 1}.items():
        array = given[name]
        if array is not None and array.ndim >= last and array.shape[-last] not in (1, count):
            problems.append(Problem(f"has {array.shape[-last]} contacts, points have {count}", kind="conflict", path=name))
    if problems:
        raise CaromError("\n".join(f"impact_batch: {one.path}: {one.message}" for one in problems), problems)
    columns = [_of_body(array) for array in _body_columns(given)]
    for contact in range(count):
        for name, axes in {"points": 2, "normals": 2, "friction": 1, "restitution": 1}.items():
            columns.extend(_of_contact(given[name], contact, axes))
    with Told(progress) as hear:
        table = Table(_carom.impact_batch(columns, count, law, hear))
    return _arrays(table, count)


def _of_body(array: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.ascontiguousarray(np.atleast_1d(array))


def _body_columns(given: dict[str, Any]) -> list[NDArray[np.float64]]:
    velocity = given["velocity"]
    return [given["mass"], given["inertia"], velocity[..., 0], velocity[..., 1], given["spin"]]


def _of_contact(array: Any, contact: int, axes: int) -> list[NDArray[np.float64]]:
    """The columns of one contact: of a vector two, of a number one."""
    if array.ndim >= axes:
        # One contact's values stand for all.
        own = min(contact, array.shape[-axes] - 1)
        array = array[..., own, :] if axes == 2 else array[..., own]
    parts = [array[..., 0], array[..., 1]] if axes == 2 else [array]
    return [_of_body(part) for part in parts]


def _arrays(table: Table, count: int) -> dict[str, NDArray[Any]]:
    arrays = {"outcome": table["outcome"], "velocity_m_s": np.stack([table["velocity_x_m_s"], table["velocity_y_m_s"]], axis=1)}
    arrays |= {name: table[name] for name in ("spin_rad_s", "energy_before_J", "energy_after_J")}
    for name in ("state", "normal_impulse_N_s", "tangential_impulse_N_s", "normal_velocity_m_s", "slip_m_s"):
        arrays[name] = np.stack([table[f"{name}.{contact}"] for contact in range(count)], axis=1)
    return arrays

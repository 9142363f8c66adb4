"""Tosses of a body in space by the thousand."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from carom import _carom
from carom._given import FileLike, number, read, within
from carom._progress import Progress, Told
from carom.errors import CaromError, Problem

#: What a start has, with how many numbers each, in the order of the engine.
START = {"position": 3, "attitude": 4, "velocity": 3, "spin": 3}


@dataclass(frozen=True)
class Tosses:
    """Where bodies are at equal intervals of time."""

    time: NDArray[np.float64]
    """The instants [s], shape (count,)."""
    position: NDArray[np.float64]
    """Of the mass centre [m], z upwards, the plane is z = 0; shape (tosses, count, 3)."""
    attitude: NDArray[np.float64]
    """The rotation of the body's axes into the world's, a unit quaternion (w, x, y, z); shape (tosses, count, 4)."""

    def __len__(self) -> int:
        return len(self.position)


def tosses(
    body: FileLike,
    *,
    position: ArrayLike,
    velocity: ArrayLike,
    attitude: ArrayLike = (1.0, 0.0, 0.0, 0.0),
    spin: ArrayLike = (0.0, 0.0, 0.0),
    friction: ArrayLike,
    restitution: ArrayLike = 0.0,
    law: Literal["poisson", "stronge"] = "poisson",
    interval: float,
    count: int,
    progress: Progress = None,
) -> Tosses:
    """Follows many tosses of one body onto a plane, each from a start of its own, on all cores.

    ``body`` is a file, a text or a dictionary with the keys of ``carom roll body`` (``box``, ``vertices``, ``mass``, ``inertia``, ``gravity``); how it starts
    stands in the arrays: ``position`` of the mass centre [m] and its ``velocity`` [m/s] in world axes, ``attitude`` as a quaternion (w, x, y, z), ``spin``
    [rad/s] in the body's axes, one row a toss or one for all; ``friction`` and ``restitution`` likewise. Each is looked at ``count`` times, every
    ``interval`` [s], the first time at its start. A body that rests stays where it is. From where a toss cannot be followed any further, it has NaN.

    Raises :class:`CaromError` that names rows and columns; KeyboardInterrupt within a moment of ctrl-C.

    >>> import carom
    >>> cube = {"box": ["100 mm", "100 mm", "100 mm"], "mass": "0.4 kg"}
    >>> falls = carom.tosses(cube, position=(0, 0, 0.2), velocity=[(0, 0, 0), (1, 0, 0)], friction=0.2, interval=0.5, count=3)
    >>> falls.position[:, -1, 2].round(6).tolist()
    [0.05, 0.05]
    """
    problems: list[Problem] = []
    parts = [_rows(name, value, width, problems) for (name, width), value in zip(START.items(), (position, attitude, velocity, spin), strict=True)]
    contacts = [_rows(name, value, 1, problems)[:, 0] for name, value in (("friction", friction), ("restitution", restitution))]
    lengths = {len(one) for one in parts + contacts} - {1}
    if len(lengths) > 1:
        names = [*START, "friction", "restitution"]
        told = ", ".join(f"{name} {len(one)}" for name, one in zip(names, parts + contacts, strict=True))
        problems.append(Problem(f"one number of rows is expected, or one row for all, not {told}", kind="conflict", path="rows"))
    interval = number("interval", interval)
    if not interval > 0:
        problems.append(Problem(f"{interval!r} is no interval: a time above 0 s", kind="out_of_range", path="interval"))
    if problems:
        raise CaromError("\n".join(f"tosses: {one.path}: {one.message}" for one in problems), problems)
    rows = max(lengths, default=1)
    start = np.concatenate([np.broadcast_to(one, (rows, one.shape[1])) for one in parts], axis=1)
    count = within("count", count, 1, 1_000_000)
    asks: dict[str, Any] = {"body": read(body, "body"), "law": law, "interval": float(interval), "count": count}
    with Told(progress) as hear:
        poses = _carom.tosses(np.ascontiguousarray(start), contacts[0], contacts[1], asks, hear).reshape(rows, count, 7)
    time: NDArray[np.float64] = np.arange(count, dtype=np.float64) * float(interval)
    return Tosses(time, poses[:, :, :3], poses[:, :, 3:])


def _rows(name: str, value: ArrayLike, width: int, problems: list[Problem]) -> NDArray[np.float64]:
    """Rows of so many numbers; what is none is told."""
    try:
        array = np.asarray(value)
    except ValueError as error:
        problems.append(Problem(str(error), kind="wrong_value", path=name))
        return np.zeros((1, width))
    flat = width == 1
    right = array.dtype.kind in "biuf" and (array.ndim <= 1 if flat else array.ndim in (1, 2) and array.shape[-1] == width)
    if not right:
        wanted = "(n,)" if flat else f"({width},) or (n, {width})"
        problems.append(Problem(f"numbers of the shape {wanted} are expected, not {array.dtype} of {array.shape}", kind="wrong_value", path=name))
        return np.zeros((1, width))
    return np.asarray(array, dtype=np.float64).reshape(-1, width)

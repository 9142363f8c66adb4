"""Any number of designs into a folder, by this machine or by many."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any, TypeAlias

from carom import _carom
from carom._cluster import Cluster
from carom._given import Values, as_text
from carom._progress import Progress, Told
from carom.answers.sweep import Sweep
from carom.errors import CaromError
from carom.scene import Scene, SceneLike, scene_of

#: Quantities by their paths, each with its ends and how many points it has, both ends included: every combination is a design. Or the same as the
#: command takes it, ``["contact.friction=0..0.3:31"]``. Or a file in CSV: its first line names quantities, each other one is a design.
Designs: TypeAlias = Mapping[str, tuple[float | str, float | str, int]] | Sequence[str] | str | os.PathLike[str]

#: A number of shards of which the last has no step: there are no more designs.
NO_STEPS = 1 << 60


def sweep(
    scene: SceneLike,
    designs: Designs,
    folder: str | os.PathLike[str],
    *,
    plate: str | int | None = None,
    shard: tuple[int, int] = (1, 1),
    force: bool = False,
    set: Values | None = None,
    client: Any = None,
    progress: Progress = None,
) -> Sweep:
    """One drop in each of any number of designs, streamed into Parquet files in ``folder``, as ``carom sweep`` writes them.

    ``designs`` are a grid, ``{"contact.friction": (0, 0.3, 31)}``, or a file in CSV. A sweep that was stopped, whichever way, goes on where it was
    when it is asked again. ``force`` replaces what the folder holds of another sweep. Memory stays flat; pyarrow, polars and DuckDB open all
    files of the folder as one table, ``folder/*.parquet``.

    ``client`` is a client of a Dask cluster whose workers see the folder under the same name: each does portions of the work with all of its
    threads, and the files are to the byte those of one machine. A worker that dies costs time only. ``shard``, ``(2, 8)``, does the second of
    eight parts of the work alone: where a job array shares it.

    Raises :class:`CaromError` with every problem of what is asked, where the folder is of another sweep, or where the cluster did not finish;
    KeyboardInterrupt within a moment of ctrl-C.

    >>> import carom, tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     swept = carom.sweep("examples/case_2.toml", {"contact.friction": (0.01, 0.17, 33)}, folder)
    >>> swept.rows, swept.endings
    (33, {'same side': 10, 'turned': 23})
    """
    inner = scene_of(scene, set)
    asks = _asks(designs, plate, force)
    if not isinstance(folder, str | os.PathLike) or not os.fspath(folder):
        raise CaromError(f"folder: expected the name of a folder, not {folder!r}")
    place = os.fspath(folder)
    with Told(progress) as hear:
        if client is None:
            return _swept(inner, place, asks | {"shard": _shard(shard)}, hear)
        if tuple(shard) != (1, 1):
            raise CaromError("shard: a client shares the work among its workers by itself")
        if force:
            raise CaromError("force: other workers may be at work; remove the folder, or name another")
        cluster = Cluster(client)
        # A shard of no steps: what is wrong with what is asked is told here, not by every worker.
        _swept(inner, place, asks | {"shard": f"{NO_STEPS}/{NO_STEPS}"}, None)
        drops = sum(cluster.each(partial(_portion, Scene._of(inner), place, asks), hear))
        # All is there: what is left is to look at it.
        return _swept(inner, place, asks | {"shard": "1/1", "before": (drops, cluster.seconds, cluster.threads)}, None)


def _asks(designs: Designs, plate: str | int | None, force: bool) -> dict[str, Any]:
    asks: dict[str, Any] = {"list": None, "grid": [], "plate": None if plate is None else str(plate), "force": bool(force), "before": None}
    if isinstance(designs, str) and "=" in designs and not os.path.exists(designs):
        return asks | {"grid": [designs]}
    if isinstance(designs, str | os.PathLike):
        return asks | {"list": os.fspath(designs)}
    if not isinstance(designs, Mapping | Sequence):
        raise CaromError(f"designs: expected a grid or a file, not {designs!r}")
    if not isinstance(designs, Mapping):
        return asks | {"grid": [str(one) for one in designs]}
    wrong = [path for path, one in designs.items() if not isinstance(one, tuple | list) or len(one) != 3]
    if wrong:
        raise CaromError(f"designs: expected (low, high, points) of each quantity, not of {', '.join(wrong)}")
    return asks | {"grid": [f"{path}={as_text(path, low, '')}..{as_text(path, high, '')}:{points}" for path, (low, high, points) in designs.items()]}


def _shard(given: object) -> str:
    if isinstance(given, tuple | list) and len(given) == 2:
        return f"{given[0]}/{given[1]}"
    raise CaromError(f"shard: expected two numbers, (2, 8) for the second of eight, not {given!r}")


def _swept(inner: _carom.Scene, folder: str, asks: dict[str, Any], hear: Callable[[int, int | None], object] | None) -> Sweep:
    text, damaged = _carom.sweep(inner, folder, asks, hear)
    for line in damaged:
        warnings.warn(line, stacklevel=3)
    return Sweep._of((text, {}), "sweep.json")


def _portion(scene: Scene, folder: str, asks: dict[str, Any], portion: int, of: int) -> int:
    """One shard, on a worker; how many drops it made."""
    return _swept(scene._inner, folder, asks | {"shard": f"{portion + 1}/{of}"}, None).run.drops

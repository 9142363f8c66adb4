"""One question at a time."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from carom import _carom
from carom._cluster import Cluster
from carom._given import FileLike, Values, as_text, mapping, read, within
from carom._progress import Progress, Told
from carom.answers.contact import Contact
from carom.answers.design import Design
from carom.answers.impact import PlanarImpact, SpatialImpact
from carom.answers.located import Located
from carom.answers.roll import PlanarRoll, SpatialRoll
from carom.answers.run import Run
from carom.answers.space_run import SolidRun
from carom.answers.yield_ import Yield
from carom.errors import CaromError, needed
from carom.scene import Scene, SceneLike, scene_of

if TYPE_CHECKING:
    from carom._studio import Studio


def run(scene: SceneLike, *, set: Values | None = None, limits: bool = False, progress: Progress = None) -> Run | SolidRun:
    """Drops the part once, as ``carom run`` does: a :class:`Run`, or a :class:`SolidRun` where the part of the scene is a solid.

    ``scene`` is a :class:`Scene`, a file, a text or a dictionary; ``set`` gives other values to its quantities; ``limits`` also finds how far
    each quantity may move alone before the verdict flips. Of a solid :attr:`Answer.tables` holds its motion as glTF, ``motion.glb``.

    Raises :class:`CaromError` with every problem of the scene, or where the run met a fault of the numbers.

    >>> import carom
    >>> carom.run("examples/case_2.toml", set={"contact.friction": 0.5}).outcome
    'stuck'
    """
    inner = scene_of(scene, set)
    with Told(progress) as hear:
        text, files, motion = _carom.run(inner, limits, hear)
        return (SolidRun if inner.is_solid else Run)._of((text, files), "run.json", motion)


def studio(file: FileLike | Scene, *, height: int = 640) -> Studio:
    """Opens the studio in a cell of a notebook: drag plates, see at once what the part does, and go on with the scene in Python.

    ``file`` is a :class:`Scene`, a file, a text or a dictionary of a scene, an impact or a roll; ``height`` is that of the cell [px]. What is
    changed in the page is in the widget's ``text`` and ``scene``, and what is set there is shown in the page.

    Needs the package of the extra ``studio``, and a wheel that has the page: ``cargo xtask python wheels``. Raises :class:`CaromError` where one
    of them is missing.
    """
    needed("studio", "anywidget")
    from carom._studio import Studio

    return Studio(file, height=height)


def impact(impact: FileLike) -> PlanarImpact | SpatialImpact:
    """Resolves an impact, as ``carom impact`` does: the staged walk, and beside it, in the plane, all end states that the laws allow.

    ``impact`` is a file, a text or a dictionary with the keys of the impact file; in space where its vectors have three components.

    ``staged`` obeys the law that was asked for. ``end_states`` obey Poisson's, or Newton's where that was asked for: of Stronge's law, and of
    springs, ``staged.end_states_compared`` is False and the two are other answers.

    Raises :class:`CaromError` with every problem. Ctrl-C is heard when the impact is resolved.

    >>> import carom
    >>> ball = carom.impact({
    ...     "body": {"mass": "1 kg", "inertia": "0.4 kg m^2", "velocity": ["0 m/s", "-2 m/s"]},
    ...     "contact": [{"point": ["0 m", "-1 m"], "normal": [0, 1], "friction": 0.3, "restitution": 0.5}],
    ... })
    >>> ball.outcome
    'unique'
    """
    answer = _carom.impact(*read(impact, "impact"))
    # Only in space an answer says along which axes its impulses are told.
    kind = SpatialImpact if "axes" in json.loads(answer[0]) else PlanarImpact
    return kind._of(answer, "impact.json")


def contact(contact: FileLike) -> Contact:
    """Which accelerations and contact forces are consistent at this instant, as ``carom contact`` finds them.

    ``contact`` is an impact file with ``gravity``, ``force`` or ``torque``, a text or a dictionary.

    Raises :class:`CaromError` with every problem.

    A rod that slides with much friction, Painlevé's paradox: no motion is consistent.

    >>> import carom
    >>> carom.contact("examples/contact_painleve.toml").count
    0
    """
    return Contact._of(_carom.contact(*read(contact, "contact")), "contact.json")


def roll(
    kind: Literal["cylinder", "prism", "rod", "pyramid", "stool", "body"],
    roll: FileLike | None = None,
    *,
    set: Mapping[str, float | str | Sequence[float]] | None = None,
) -> PlanarRoll | SpatialRoll:
    """Follows what rolls through its strikes, as ``carom roll KIND`` does.

    ``roll`` is a file, a text or a dictionary; without it everything has its default. ``set`` gives other values to its keys.

    Raises :class:`CaromError` with every problem.

    >>> import carom
    >>> prism = carom.roll("prism", {"sides": 6, "strikes": 1})
    >>> len(prism.strikes)
    1
    """
    name, text, is_json = (f"roll {kind}", "", False) if roll is None else read(roll, f"roll {kind}")
    if roll is not None and not text.strip():
        raise CaromError(f"roll {kind}: the text is empty: without a file everything has its default")
    values = [f"{key}={_roll_value(key, value)}" for key, value in mapping(set or {}, "set").items()]
    answer = _carom.roll(kind, name, text, is_json, values)
    return (PlanarRoll if kind in ("cylinder", "prism", "rod") else SpatialRoll)._of(answer, "roll.json")


def _roll_value(key: str, value: object) -> str:
    """A value as the file has it; a vector is a list."""
    if isinstance(value, np.ndarray | list | tuple):
        return f"[{', '.join(as_text(key, one, '') for one in np.asarray(value).tolist())}]"
    return as_text(key, value, "")


def yield_(
    scene: SceneLike,
    *,
    samples: int = 16_384,
    seed: int = 1,
    plate: str | int | None = None,
    plain: bool = False,
    set: Values | None = None,
    client: Any = None,
    progress: Progress = None,
) -> Yield:
    """With what probability drops end as wanted under the tolerances of the scene, as ``carom yield`` finds it.

    ``samples`` drops at least; ``plate`` is the one that is looked at, the last where none is given; ``plain`` draws independent random numbers
    in place of Sobol's points. :attr:`Answer.files` holds the drops to look at as scenes. ``client`` is a client of a Dask cluster whose workers
    count portions of the drops: what comes out is to the last digit what one machine says.

    Raises :class:`CaromError` with every problem of the scene, or where the cluster did not finish; KeyboardInterrupt within a moment of ctrl-C.

    >>> import carom
    >>> found = carom.yield_("examples/designer.toml", samples=1024)
    >>> 0.5 < found.yield_.share <= 1
    True
    """
    asks = _sampling(within("samples", samples, 16, 1 << 34), seed, plate, plain)
    inner = scene_of(scene, set)
    with Told(progress) as hear:
        answer = _carom.yields(inner, asks, hear) if client is None else _yield_of(inner, asks, client, hear)
        return Yield._of(answer, "yield.json")


def locate_yield(
    scene: SceneLike,
    *,
    lines: int = 128,
    seed: int = 1,
    plate: str | int | None = None,
    plain: bool = False,
    set: Values | None = None,
    progress: Progress = None,
) -> Located:
    """With what probability drops end as wanted, by where they stop to end so, as ``carom yield --locate`` finds it: for a tenth to a hundredth of the drops.

    Along ``lines`` lines at least, of the one quantity that decides most often, it is located where drops stop to end as wanted; a surface is
    fitted to these places, and its mean is corrected by what the lines say. The interval does not hold windows that no line met:
    ``yield_.unseen_share`` bounds how much of all places they may fill. The other arguments are those of :func:`yield_`.

    Raises :class:`CaromError` with every problem of the scene; KeyboardInterrupt within a moment of ctrl-C.

    >>> import carom
    >>> found = carom.locate_yield("examples/designer.toml").yield_
    >>> found.high - found.low < 0.002
    True
    """
    asks = _sampling(within("lines", lines, 16, 1 << 18), seed, plate, plain)
    inner = scene_of(scene, set)
    with Told(progress) as hear:
        return Located._of(_carom.located(inner, asks, hear), "yield-located.json")


def _sampling(count: int, seed: int, plate: str | int | None, plain: bool) -> dict[str, Any]:
    """What is asked of a yield: of so many samples, or lines."""
    seed = within("seed", seed, 0, (1 << 64) - 1)
    return {"samples": count, "seed": seed, "plain": bool(plain), "plate": None if plate is None else str(plate)}


def _yield_of(
    scene: _carom.Scene, asks: dict[str, Any], client: Any, hear: Callable[[int, int | None], object] | None
) -> tuple[str, dict[str, str]]:
    """A yield that a cluster counts."""
    cluster = Cluster(client)
    # A portion of nothing: what is wrong with what is asked is told here, not by every worker.
    _carom.yield_portion(scene, asks, False, (0, (1 << 32) - 1))
    work = partial(_yield_portion, Scene._of(scene), asks)
    counted = cluster.each(partial(work, False), hear)
    answer = _carom.yield_joined(scene, counted, None, (cluster.seconds, cluster.threads))
    if answer is not None:
        return answer
    deciding = cluster.each(partial(work, True), hear)
    answer = _carom.yield_joined(scene, counted, deciding, (cluster.seconds, cluster.threads))
    if answer is None:
        raise CaromError("the cluster's portions say nothing of what decides")
    return answer


def _yield_portion(scene: Scene, asks: dict[str, Any], deciding: bool, portion: int, of: int) -> bytes:
    """One portion, on a worker."""
    return _carom.yield_portion(scene._inner, asks, deciding, (portion, of))


def design(
    scene: SceneLike,
    *,
    scan: int | None = None,
    samples: int | None = None,
    seed: int = 1,
    set: Values | None = None,
    progress: Progress = None,
) -> Design:
    """Which layout makes drops end as wanted, as ``carom design`` finds it: the scene says in ``[design]`` what may be chosen.

    ``scan`` layouts are looked at first, 4096 where nothing else is asked; ``samples`` drops confirm the winner, 16 384. A drop of a solid part takes a
    hundred times as long: of such a scene these are 512 and 1024.

    Raises :class:`CaromError` with every problem of the scene; KeyboardInterrupt within a moment of ctrl-C.

    >>> import carom
    >>> found = carom.design("examples/design_turn_once.toml", scan=32, samples=64)
    >>> "design.toml" in found.files
    True
    """
    scan = None if scan is None else within("scan", scan, 16, 1 << 24)
    samples = None if samples is None else within("samples", samples, 16, 1 << 34)
    seed = within("seed", seed, 0, (1 << 64) - 1)
    with Told(progress) as hear:
        return Design._of(_carom.design(scene_of(scene, set), scan, samples, seed, hear), "design.json")

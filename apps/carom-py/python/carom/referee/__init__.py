"""The referee of engines: cases whose answers are known, other engines that answer them, and a judge.

:func:`cases` gives the cases, :func:`ask` lets an engine answer them, and :func:`judge` compares. ``python -m carom.referee`` does all
three with every engine that is installed. Whoever has an engine of their own writes one JSON object a line and lets :func:`judge`, or
``carom judge``, read it.

>>> from carom import referee
>>> balls = referee.cases("ball")
>>> len(referee.cases()) >= 500, balls[0]["case"]
(True, 'ball/001')
>>> right = [{"case": case["case"], "bodies": case["expected"]["answers"][0]["bodies"]} for case in balls]
>>> judged = referee.judge({"copied": right})
>>> judged.engines[0].all.agree == len(balls)
True
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from carom._carom import referee_cases, referee_judge
from carom._given import as_json
from carom.errors import CaromError
from carom.referee.engines import ENGINES, Answer, Case, ask, installed

__all__ = ["ENGINES", "Answer", "Case", "Engine", "Group", "Judged", "Spread", "ask", "cases", "installed", "judge"]


@dataclass(frozen=True)
class Spread:
    """Middle and largest of the sizes of some numbers; None where there are none."""

    median: float | None
    largest: float | None


@dataclass(frozen=True)
class Group:
    """Counts and errors of a group of cases; all shares are of what was before the impact."""

    group: str
    cases: int
    agree: int
    """Answers that the law of the case allows."""
    other_convention: int
    """Answers that another law of restitution, or another convention on sharing, gives."""
    differ: int
    refused: int
    missing: int
    gained_energy: int
    difference: Spread
    """The root of the kinetic energy of the difference from the nearest answer that the law allows."""
    restitution_error: Spread
    """Of the restitution that is seen, where there is one contact."""
    energy_error: Spread
    spin_error: Spread


@dataclass(frozen=True)
class Engine:
    """What the judge says of one engine."""

    engine: str
    all: Group
    groups: list[Group]
    judged: list[dict[str, Any]] = field(repr=False)
    """Each case: its verdict, what it follows, and its errors."""


@dataclass(frozen=True)
class Judged:
    """What the judge says: the same as ``carom judge`` prints."""

    engines: list[Engine]
    json: str = field(repr=False)
    text: str = field(repr=False)

    def __str__(self) -> str:
        return self.text


def cases(group: str | None = None) -> list[Case]:
    """The cases, as dictionaries; with ``group`` those of that group, or those that have it in their group's name.

    Each has ``case`` (its name), ``group``, ``impact`` or ``scene`` (what is asked, in plain SI numbers), ``expected`` with ``answers`` and
    ``others``, ``tolerance`` and ``source``; a drop has ``world`` too, the scene laid out. They are the same ones each time.
    """
    return [json.loads(line) for line in referee_cases(group).splitlines()]


def judge(
    answers: Mapping[str, Iterable[Answer]] | Iterable[str | os.PathLike[str]],
    cases: Iterable[Case] | None = None,
    *,
    within: float | None = None,
) -> Judged:
    """Judges answers: by engine, or files with one answer a line; by cases of your own, or by ours.

    An answer agrees where it is off by no more than ``within``, a share of the motion before; by the tolerance of its case where that is
    left out, which only what is exact keeps.

    Raises :class:`carom.CaromError` that lists every answer which is none.
    """
    texts: list[tuple[str, str]]
    if isinstance(answers, Mapping):
        texts = [(str(name), _lines(_signed(str(name), given))) for name, given in answers.items()]
    else:
        paths = [answers] if isinstance(answers, str | os.PathLike) else answers
        texts = [(os.fspath(path), _read(path)) for path in paths]
    if within is not None and not 0 <= within <= 1:
        raise CaromError(f"within = {within}: a share from 0 to 1 is asked")
    said, text = referee_judge(texts, None if cases is None else ("cases", _lines(cases)), within)
    report = json.loads(said)
    return Judged([_engine(engine) for engine in report["engines"]], said, text)


def _signed(name: str, given: object) -> list[Answer]:
    """Answers with the engine's name."""
    if not isinstance(given, Iterable) or isinstance(given, str | Mapping):
        raise CaromError(f"{name}: a list of answers is asked, not {type(given).__name__}")
    return [{"engine": name, **one} if isinstance(one, Mapping) else _no_object(name, one) for one in given]


def _no_object(name: str, given: object) -> Answer:
    raise CaromError(f"{name}: each is a dictionary, not {type(given).__name__}: {given!r:.100}")


def _lines(objects: Iterable[Mapping[str, Any]]) -> str:
    return "".join(as_json(one) + "\n" for one in objects)


def _read(path: str | os.PathLike[str]) -> str:
    try:
        return Path(path).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise CaromError(f"cannot read {os.fspath(path)}: {error}") from error


def _group(of: dict[str, Any]) -> Group:
    spreads = {name: Spread(**of[name]) for name in ("difference", "restitution_error", "energy_error", "spin_error")}
    return Group(**{**of, **spreads})


def _engine(of: dict[str, Any]) -> Engine:
    return Engine(of["engine"], _group(of["all"]), [_group(group) for group in of["groups"]], of["judged"])

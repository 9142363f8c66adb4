"""Engines that answer the cases, each through its own interface, at the settings that its module states.

Every adapter is a module with ``VERSION``, ``impact(question) -> list[Twist]`` and ``drop(world) -> str``, and raises :class:`Refused`
where the engine has no such thing. An engine that steps through time is given the bodies one step before they touch, each contact as a
small sphere (a circle in the plane) that meets its own obstacle and nothing else, and is watched until the contacts have done their work. In a drop the upper plate is taken away once the part has left it: blocks that stand for
plates are thicker than these.
"""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable, Iterable
from importlib import import_module
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from math import isfinite
from typing import Any

from carom.errors import CaromError
from carom.referee.engines.question import Question, Refused, Twist

#: A case, and an answer to one, as JSON.
Case = dict[str, Any]
Answer = dict[str, Any]

#: The engines that can be asked: the name, the module that must be installed, and the distribution that tells its version.
ENGINES = {
    "box2d": ("Box2D", "Box2D"),
    "drake": ("pydrake", "drake"),
    "mujoco": ("mujoco", "mujoco"),
    "pybullet": ("pybullet", "pybullet"),
    "pymunk": ("pymunk", "pymunk"),
}


def installed() -> list[str]:
    """The engines that are installed here."""
    return [name for name, (module, _) in ENGINES.items() if find_spec(module) is not None]


def _named(name: str) -> str:
    try:
        return f"{name} {version(ENGINES[name][1])}"
    except PackageNotFoundError:
        return name


def ask(engine: str, cases: Iterable[Case], progress: Callable[[int], object] | None = None) -> list[Answer]:
    """The answers of an engine to cases: a name of :func:`installed`, or ``NAME=COMMAND`` for a program that reads one case a line from
    stdin and writes one answer a line. ``progress`` is called with how many are answered.

    >>> from carom import referee
    >>> referee.ask("nobody", [])
    Traceback (most recent call last):
      ...
    carom.errors.CaromError: no engine 'nobody': box2d, drake, mujoco, pybullet and pymunk can be asked where they are installed, or NAME=COMMAND
    """
    if "=" in engine:
        name, _, command = engine.partition("=")
        return _program(name, command, list(cases))
    if engine not in ENGINES:
        known = ", ".join(list(ENGINES)[:-1]) + f" and {list(ENGINES)[-1]}"
        raise CaromError(f"no engine {engine!r}: {known} can be asked where they are installed, or NAME=COMMAND")
    if engine not in installed():
        raise CaromError(f"{engine} is not installed: `pip install {ENGINES[engine][1]}`")
    module = import_module(f"carom.referee.engines.{engine}")
    name, answers = _named(engine), []
    for case in cases:
        answers.append({"case": case["case"], "engine": name, **_answer(module, case)})
        if progress:
            progress(len(answers))
    return answers


def _answer(module: Any, case: Case) -> Answer:
    try:
        if case.get("world"):
            return {"verdict": module.drop(case["world"])}
        question = Question.of(case["impact"])
        twists: list[Twist] = module.impact(question)
    except Refused as refused:
        return {"refused": str(refused)}
    except Exception as error:  # noqa: BLE001 - whatever an engine raises is its answer to this case
        return {"refused": f"{type(error).__name__}: {error}"[:200]}
    numbers = [number for twist in twists for number in (*twist.velocity, *twist.spin)]
    if not all(isfinite(number) for number in numbers):
        return {"refused": "the engine's answer is no number"}
    return {"bodies": [question.written(twist) for twist in twists]}


#: Seconds that a program may take for all cases.
PATIENCE = 3600.0


def _program(name: str, command: str, cases: list[Case]) -> list[Answer]:
    lines = "".join(json.dumps(case) + "\n" for case in cases)
    try:
        done = subprocess.run(command, shell=True, input=lines, capture_output=True, text=True, encoding="utf-8", errors="replace", check=False, timeout=PATIENCE)
    except subprocess.TimeoutExpired as error:
        raise CaromError(f"{name}: `{command}` did not end within {PATIENCE:.0f} s") from error
    if done.returncode != 0:
        raise CaromError(f"{name}: `{command}` ended with {done.returncode}: {done.stderr.strip()[-500:]}")
    answers = []
    for number, line in enumerate(done.stdout.splitlines(), 1):
        try:
            answers.append({**json.loads(line), "engine": name})
        except (TypeError, ValueError) as error:
            raise CaromError(f"{name}: line {number} of its answers is no JSON object: {error}") from error
    return answers

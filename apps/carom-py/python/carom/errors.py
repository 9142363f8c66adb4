"""The one exception of Carom, and the problems that it lists."""

from __future__ import annotations

import importlib
import json
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Problem:
    """One problem of what was given."""

    message: str
    """What is wrong and what is allowed, in a sentence."""
    kind: str | None = None
    """Its kind: ``unknown_key``, ``out_of_range``, …; None where the input is good and no answer could be computed."""
    path: str = ""
    """Where it is, key by key: ``plate.lower.slope``; empty for the input as a whole."""
    key: str | None = None
    """The last key of the path."""
    value: str | None = None
    """The value that is written there."""
    allowed: list[str] = field(default_factory=list)
    """What may stand there, where that can be listed."""
    help: str | None = None
    """What to do, where there is something to suggest."""


class CaromError(ValueError):
    """What was given has problems, or has no answer. All problems are listed.

    >>> import carom
    >>> try:
    ...     carom.impact({"body": {"mass": -1}})
    ... except carom.CaromError as error:
    ...     print(sorted({problem.path for problem in error.problems}))
    ['body.inertia', 'body.mass', 'body.velocity', 'contact']
    """

    problems: list[Problem]
    """Every problem, at least one."""

    def __init__(self, message: str, problems: list[Problem] | None = None) -> None:
        super().__init__(message)
        self.problems = problems or [Problem(message)]

    def __reduce__(self) -> tuple[type[CaromError], tuple[str, list[Problem]]]:
        return (type(self), (str(self), self.problems))

    @classmethod
    def _of_json(cls, message: str, problems: str) -> CaromError:
        return cls(message.rstrip(), [Problem(**problem) for problem in json.loads(problems)])


def needed(extra: str, *packages: str) -> None:
    """Raises :class:`CaromError` where a package of an extra is missing."""
    for package in packages:
        try:
            importlib.import_module(package)
        except ImportError:
            help = f"pip install carom[{extra}]"
            message = f"the package {package} is missing: {help}"
            raise CaromError(message, [Problem(message, kind="missing_package", value=package, help=help)]) from None

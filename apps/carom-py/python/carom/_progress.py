"""How far long work is."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import TypeAlias

#: Called with how many pieces of the work are done and how many there are, None where that is not known; True: a line on stderr.
Progress: TypeAlias = Callable[[int, int | None], object] | bool | None

#: The line is written so often [s].
PAUSE = 0.2


class _Line:
    """One line on stderr that is written over itself."""

    def __init__(self) -> None:
        self.begun = time.monotonic()
        self.next = 0.0
        self.width = 0

    def __call__(self, done: int, pieces: int | None) -> None:
        now = time.monotonic()
        if now < self.next:
            return
        self.next = now + PAUSE
        line = f"{done}" if pieces is None else f"{done} of {pieces}"
        if pieces and 0 < done < pieces:
            line += f", {(now - self.begun) * (pieces - done) / done:.0f} s left"
        self.write(line)

    def write(self, line: str) -> None:
        sys.stderr.write("\r" + line.ljust(self.width))
        sys.stderr.flush()
        self.width = len(line)


class Told:
    """Hears how far some work is; on the way out the line is taken away."""

    def __init__(self, progress: Progress) -> None:
        self.line = _Line() if progress is True else None
        self.hear: Callable[[int, int | None], object] | None = self.line
        if callable(progress):
            self.hear = progress
        elif progress not in (True, False, None):
            raise TypeError(f"progress: expected True, or a function of two numbers, not {progress!r}")

    def __enter__(self) -> Callable[[int, int | None], object] | None:
        return self.hear

    def __exit__(self, *_: object) -> None:
        if self.line is not None and self.line.width:
            self.line.write("")
            sys.stderr.write("\r")

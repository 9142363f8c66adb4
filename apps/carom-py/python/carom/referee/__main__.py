"""The referee: ``python -m carom.referee`` asks every engine that is installed all cases and prints what the judge says of each.

``--engine NAME`` asks that one; ``--engine "NAME=COMMAND"`` a program that reads one case a line from stdin and writes one answer a line to
stdout. ``--out FOLDER`` keeps the cases and the answers, for ``carom judge``.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

from carom import referee
from carom.errors import CaromError

#: How far an answer may be off by default and still agree: engines step through time.
WITHIN = 1e-3


def _written(folder: Path, name: str, lines: list[dict[str, object]]) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m carom.referee", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--engine", action="append", metavar="NAME[=COMMAND]", help="an engine to ask; every one that is installed where none is named")
    parser.add_argument("--group", help="only cases whose group has this in its name")
    parser.add_argument("--within", type=float, default=WITHIN, help=f"how far an answer may be off and still agree, as a share of the motion before [{WITHIN}]")
    parser.add_argument("--out", type=Path, help="where cases and answers are kept")
    words = parser.parse_args()
    engines = words.engine or referee.installed()
    names = [engine.partition("=")[0] for engine in engines]
    if len(set(names)) < len(names):
        print("two engines have one name", file=sys.stderr)
        return 2
    if not engines:
        print(f"no engine is installed: {', '.join(referee.ENGINES)} can be asked, or NAME=COMMAND", file=sys.stderr)
        return 1
    try:
        cases = referee.cases(words.group)
        if not cases:
            raise CaromError(f"no group of cases has {words.group!r} in its name")
        if words.out:
            _written(words.out, "cases.jsonl", cases)
        answers, failed = {}, 0
        for name, engine in zip(names, engines, strict=True):
            print(f"asking {name} …", file=sys.stderr)
            try:
                answers[name] = referee.ask(engine, cases)
            except CaromError as error:
                # The others are asked all the same.
                print(error, file=sys.stderr)
                failed = 1
                continue
            if words.out:
                _written(words.out, "".join(c if c.isalnum() or c in "._-" else "-" for c in name).strip(".") + ".jsonl", answers[name])
        if answers:
            print(referee.judge(answers, cases, within=words.within), end="")
        return failed
    except (CaromError, OSError) as error:
        print(error, file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())

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
    if not engines:
        print(f"no engine is installed: {', '.join(referee.ENGINES)} can be asked, or NAME=COMMAND", file=sys.stderr)
        return 1
    try:
        cases = referee.cases(words.group)
        if not cases:
            raise CaromError(f"no group of cases has {words.group!r} in its name")
        answers = {}
        for engine in engines:
            print(f"asking {engine.partition('=')[0]} …", file=sys.stderr)
            answers[engine.partition("=")[0]] = referee.ask(engine, cases)
        if words.out:
            _written(words.out, "cases.jsonl", cases)
            for name, given in answers.items():
                _written(words.out, f"{name}.jsonl", given)
        print(referee.judge(answers, cases, within=words.within), end="")
    except (CaromError, OSError) as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

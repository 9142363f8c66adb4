"""Prints every formula of the paper and its verdict: ``python -m carom.symbolic.paper [--markdown] [SECTION]``."""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Sequence

from carom.symbolic.paper import claims
from carom.symbolic.paper.judging import AGREES, Claim


def plain(claim: Claim) -> str:
    """For a terminal."""
    head = f"{claim.section:<4} {claim.key:<18} {claim.verdict:<15} {claim.what}: {claim.printed}"
    return head if claim.verdict == AGREES else f"{head}\n{'':<40}right: {claim.right}"


def markdown(claim: Claim) -> str:
    """A row of a table."""
    cells = [claim.section, claim.key, claim.what, f"`{claim.printed}`", claim.verdict, claim.right]
    return f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in cells)} |"


def main(words: Sequence[str] | None = None) -> int:
    """Prints the table; 1 where something could not be decided."""
    parser = argparse.ArgumentParser(prog="python -m carom.symbolic.paper", description=__doc__)
    parser.add_argument("section", nargs="?", choices=["1", "3", "4", "5.1", "5.2"], help="one section only")
    parser.add_argument("--markdown", action="store_true", help="a table in Markdown")
    given = parser.parse_args(words)
    found = claims(given.section)
    if given.markdown:
        print("| section | name | of what | printed | verdict | right |\n|---|---|---|---|---|---|")
    for claim in found:
        print(markdown(claim) if given.markdown else plain(claim), flush=True)
    counts = Counter(claim.verdict for claim in found)
    print(f"\n{len(found)} formulas and statements: {', '.join(f'{count} {verdict}' for verdict, count in counts.items())}")
    return int("not decided" in counts)


if __name__ == "__main__":
    raise SystemExit(main())

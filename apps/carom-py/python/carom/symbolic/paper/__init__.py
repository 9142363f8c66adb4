"""A paper on simultaneous collisions, derived again: every formula that it prints, and whether it is right.

Polukoshko, Viba and others, *Simultaneous collisions of rigid bodies in more than one point*, sections 1, 3, 4 and 5. The printed formulas are
data; what is right is derived by :func:`carom.derive`, and the verdict is their comparison. ``python -m carom.symbolic.paper`` prints the table.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from carom.symbolic.paper.judging import Claim

__all__ = ["claims"]


def claims(section: str | None = None) -> list[Claim]:
    """Every printed formula and statement, of all sections or of one: ``1``, ``3``, ``4``, ``5.1``, ``5.2``. Verdicts are derived as they are asked.

    Raises :class:`carom.CaromError` where a package of the extra ``derive`` is missing.

    >>> from carom.symbolic import paper
    >>> [claim.verdict for claim in paper.claims("4") if claim.key in ("SYA", "SYB")]
    ['misprint', 'agrees']
    """
    from carom.errors import needed

    needed("derive", "sympy", "z3")
    from carom.symbolic.paper import cylinder, prism, rod, space

    every = [*cylinder.claims(), *prism.claims(), *rod.claims(), *space.claims()]
    return [claim for claim in every if section is None or claim.section == section]

"""Closed forms of impacts, with SymPy: what a hypothesis says of n contacts, in symbols.

The one call is :func:`carom.derive`; ``python -m carom.symbolic.paper`` derives every formula of a paper on simultaneous collisions again.
Needs the packages of the extra ``derive``: ``pip install carom[derive]``.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, overload

from carom._given import FileLike
from carom.errors import needed

if TYPE_CHECKING:
    from carom.symbolic.derivation import Derivation, Derivations
    from carom.symbolic.hypothesis import HypothesisLike

__all__ = ["derive"]


@overload
def derive(
    problem: FileLike, hypothesis: None = None, *, restitution: HypothesisLike | None = None, assume: Sequence[Any] = (), non_sliding: bool = False, discard: bool = True, seconds: float = 2.0
) -> Derivations: ...
@overload
def derive(
    problem: FileLike, hypothesis: HypothesisLike, *, restitution: HypothesisLike | None = None, assume: Sequence[Any] = (), non_sliding: bool = False, discard: bool = True, seconds: float = 2.0
) -> Derivation: ...
def derive(
    problem: FileLike,
    hypothesis: HypothesisLike | None = None,
    *,
    restitution: HypothesisLike | None = None,
    assume: Sequence[Any] = (),
    non_sliding: bool = False,
    discard: bool = True,
    seconds: float = 2.0,
) -> Derivation | Derivations:
    """Derives what a hypothesis says of an impact, in closed form: impulses, velocities after, and the inequalities that bound it.

    ``problem`` is an impact file, a text or a dictionary with its keys, whose numbers may also be expressions of SymPy or texts such as
    ``"m*a**2*b"``; values are SI where they have units. ``hypothesis`` says what each contact does, in the words of the engine's answers:
    ``"A separates, K slips-"``, or a dictionary; in space a slip is ``("slips", direction)``, and without friction just ``"slips"``. Without a
    hypothesis all are derived (slips in space without friction only), and those that cannot hold are discarded with the reason.

    With restitution under Poisson's law ``hypothesis`` is that of compression and ``restitution`` that of the phase after it, as the engine's
    end states define them: each normal impulse is at least e times its compression's, and just that where the contact separates. Where
    ``restitution`` is not given, all of its hypotheses are derived. Newton's law is one step.

    ``assume`` are relations, of SymPy or as texts: ``"0 < gamma < pi/2"``. ``non_sliding`` takes friction without bound: a contact ``keeps`` or
    separates. ``discard=False`` asks Z3 nothing and keeps all. ``seconds`` is the time that Z3 has for each hypothesis; what it does not decide is kept as
    *unknown*.

    Raises :class:`CaromError` with every problem, or where a package of the extra ``derive`` is missing.

    A ball that is dropped with a spin:

    >>> import carom
    >>> ball = {
    ...     "body": {"mass": "m", "inertia": "2*m*r**2/5", "velocity": [0, "-v"], "spin": "omega0"},
    ...     "contact": [{"point": [0, "-r"], "normal": [0, 1], "friction": "f"}],
    ... }
    >>> all_of_them = carom.derive(ball, assume=["r > 0", "v > 0", "omega0 > 0"])
    >>> [one.hypothesis for one in all_of_them]
    ['A sticks', 'A slips+']
    >>> sticks = all_of_them["A sticks"]
    >>> sticks.spin
    2*omega0/7
    >>> [condition.reduced for condition in sticks.conditions if condition.kind == "friction_cone"]
    [1, 7*f*v - 2*omega0*r]
    """
    needed("derive", "sympy")
    if discard:
        needed("derive", "z3")
    from carom.symbolic.deriving import derive_all, derive_one

    if hypothesis is None:
        return derive_all(problem, restitution, assume, non_sliding, discard, seconds)
    return derive_one(problem, hypothesis, restitution, assume, non_sliding, discard, seconds)

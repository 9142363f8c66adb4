"""What a hypothesis says of each contact, in the words of the engine's answers."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from carom.errors import CaromError, Problem
from carom.symbolic.problem import SymbolicProblem

#: What a caller may give: ``"A separates, K slips-"``, or a word for each contact; in space ``("slips", direction)`` too.
HypothesisLike = str | Mapping[str, Any] | Sequence[Any]

_SLIPS = ("sticks", "slips+", "slips-", "slips", "keeps")
_WORDS = re.compile(r"^\s*(?P<name>.+?)\s+(?P<word>separates \((?:sticks|slips\+|slips-|slips)\)|separates|sticks|slips\+|slips-|slips|keeps)\s*$")


@dataclass(frozen=True)
class State:
    """What one contact does in a phase.

    >>> State(False, "open").word, State(True, "slips-").word, State(False, "sticks").word
    ('separates', 'slips-', 'separates (sticks)')
    """

    holds: bool
    """It comes to rest along its normal, and may push."""
    slip: str
    """``open``, ``sticks``, ``slips+``, ``slips-``; ``slips`` without friction, or along :attr:`direction` in space."""
    direction: tuple[Any, ...] | None = None
    """In space: where the slip goes, of length 1."""

    @property
    def word(self) -> str:
        """As the engine's answers say it."""
        if self.holds:
            return self.slip
        return "separates" if self.slip == "open" else f"separates ({self.slip})"


Hypothesis = tuple[State, ...]
OPEN = State(False, "open")


def said(problem: SymbolicProblem, hypothesis: Hypothesis) -> str:
    """A hypothesis in words: ``A separates, K slips-``."""
    words = []
    for contact, state in zip(problem.contacts, hypothesis):
        along = f" along ({', '.join(str(one) for one in state.direction)})" if state.direction else ""
        words.append(f"{contact.name} {state.word}{along}")
    return ", ".join(words)


def options(problem: SymbolicProblem, contact: int, *, loaded: bool = False, non_sliding: bool = False) -> list[State]:
    """What a contact can do: of slips in space only those that need no direction.

    ``loaded``: restitution owes it an impulse, so that it separates under it, sticking or slipping.
    """
    friction = problem.contacts[contact].friction
    if non_sliding:
        slips = ["keeps"]
    elif friction.is_zero:
        slips = ["slips"]
    else:
        slips = ["sticks"] if problem.space else ["sticks", "slips+", "slips-"]
    free = [State(False, slip) for slip in slips] if loaded else [OPEN]
    return free + [State(True, slip) for slip in slips]


def every(problem: SymbolicProblem, loaded: Sequence[bool], *, non_sliding: bool = False) -> Iterator[Hypothesis]:
    """All hypotheses of a phase."""
    each = [options(problem, k, loaded=owed, non_sliding=non_sliding) for k, owed in enumerate(loaded)]
    yield from itertools.product(*each)


def parse(given: HypothesisLike, problem: SymbolicProblem, *, loaded: Sequence[bool], non_sliding: bool = False, path: str = "hypothesis") -> Hypothesis:
    """Reads a hypothesis.

    Raises :class:`carom.CaromError` that lists every contact of which nothing, or nothing that can be, is said.
    """
    problems: list[Problem] = []
    words = _by_name(given, problem, path, problems)
    states = []
    for k, contact in enumerate(problem.contacts):
        allowed = [one.word for one in options(problem, k, loaded=loaded[k], non_sliding=non_sliding)]
        if contact.name not in words:
            if not any(one.path.endswith("*") for one in problems):
                problems.append(Problem(f"says nothing of {contact.name}: it {', '.join(allowed[:-1])} or {allowed[-1]}", kind="missing_key", path=f"{path}.{contact.name}", allowed=allowed))
            states.append(OPEN)
            continue
        states.append(_state(words[contact.name], problem, k, loaded[k], non_sliding, f"{path}.{contact.name}", problems))
    if problems:
        raise CaromError("\n".join(f"{one.path}: {one.message}" for one in problems), problems)
    return tuple(states)


def _by_name(given: HypothesisLike, problem: SymbolicProblem, path: str, problems: list[Problem]) -> dict[str, Any]:
    names = [contact.name for contact in problem.contacts]
    if isinstance(given, Mapping):
        words = dict(given)
    elif isinstance(given, str):
        words = {}
        for part in re.split(r"[,;]", given):
            found = _WORDS.match(part)
            if found is None:
                problems.append(Problem(f"{part.strip()!r} is not a contact's name and what it does, like '{names[0]} sticks'", kind="wrong_value", path=f"{path}.*", value=part.strip()))
            elif found["name"] in words:
                problems.append(Problem(f"of {found['name']} it is said twice what it does", kind="conflict", path=f"{path}.{found['name']}", value=part.strip()))
            else:
                words[found["name"]] = found["word"]
    elif isinstance(given, Sequence):
        words = dict(zip(names, given))
    else:
        raise CaromError(f"{path}: expected a text like '{names[0]} sticks', a dictionary or a list, not {given!r}")
    for name in words:
        if name not in names:
            problems.append(Problem(f"there is no contact {name}; there are {', '.join(names)}", kind="unknown_key", path=f"{path}.{name}", key=str(name), allowed=names))
    return words


def _state(word: Any, problem: SymbolicProblem, k: int, loaded: bool, non_sliding: bool, path: str, problems: list[Problem]) -> State:
    allowed = options(problem, k, loaded=loaded, non_sliding=non_sliding)
    if isinstance(word, State):
        return word
    if isinstance(word, list | tuple) and len(word) == 2 and problem.space:
        text, direction = str(word[0]), _direction(word[1], problem, k, path, problems)
        holds = not text.startswith("separates")
        return State(holds, "slips", direction)
    for state in allowed:
        # Without friction a slip has no sign.
        if word == state.word or (state.slip == "slips" and str(word).replace("slips+", "slips").replace("slips-", "slips") == state.word):
            return state
    if non_sliding and word == "sticks":
        return State(True, "keeps")
    words = [state.word for state in allowed]
    more = "; a slip in space is (\"slips\", direction)" if problem.space and not non_sliding else ""
    problems.append(Problem(f"{word!r} is none of {', '.join(words)}{more}", kind="wrong_value", path=path, value=str(word), allowed=words))
    return OPEN


def _direction(given: Any, problem: SymbolicProblem, k: int, path: str, problems: list[Problem]) -> tuple[Any, ...]:
    if problem.contacts[k].friction.is_zero:
        problems.append(Problem("without friction a slip needs no direction", kind="wrong_value", path=path))
    try:
        vector = [problem.names.read(one) if isinstance(one, str) else sp.nsimplify(one, rational=True) for one in given]
    except (TypeError, ValueError) as why:
        problems.append(Problem(f"{given!r} is no direction: {why}", kind="wrong_value", path=path))
        return (sp.Integer(1), sp.Integer(0), sp.Integer(0))
    off: Any = sp.simplify(sp.Add(*[a * b for a, b in zip(vector, problem.contacts[k].normal)]))
    length = sp.sqrt(sp.trigsimp(sum(one**2 for one in vector)))
    if len(vector) != 3 or off != 0 or length == 0:
        problems.append(Problem(f"{given!r} is no direction in the tangent plane of {problem.contacts[k].name}", kind="geometry", path=path))
        return (sp.Integer(1), sp.Integer(0), sp.Integer(0))
    return tuple(one / length for one in vector)

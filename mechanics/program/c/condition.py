"""What a C text decides by: conditions on values, and integers that depend on them.

    !(isfinite(a) && isfinite(b))  ->  or(not finite a, not finite b)

Negations are moved inwards and what && or || joins is a set, so that two ways of writing one
condition are mostly equal. An integer that depends on conditions is a tree of choices.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

from mechanics.errors import ExpressionError


@dataclass(frozen=True)
class Atom:
    """One statement about values, or its negation.

    Attributes
    ----------
    relation : str
        ``"finite"``, ``"<"``, ``"<="`` or ``"=="``.
    operands : tuple
        Nodes; in a comparison of two statuses keys of another kind.
    holds : bool
        False for the negation.
    """

    relation: str
    operands: tuple[Any, ...]
    holds: bool = True


@dataclass(frozen=True)
class Joined:
    """Conditions that hold all (``both``) or at least one of which holds."""

    both: bool
    parts: frozenset[Condition]


Condition = bool | Atom | Joined


def joined(both: bool, left: Condition, right: Condition) -> Condition:
    """left && right, or left || right."""
    parts: set[Condition] = set()
    for side in (left, right):
        if isinstance(side, bool):
            if side is not both:
                return side
        elif isinstance(side, Joined) and side.both is both:
            parts |= side.parts
        else:
            parts.add(side)
    if not parts:
        return both
    if any(negation(part) in parts for part in parts if isinstance(part, Atom)):
        return not both
    # a && (a || b)  ->  a
    parts = {p for p in parts if not (isinstance(p, Joined) and p.parts & parts)}
    return Joined(both, frozenset(parts)) if len(parts) > 1 else next(iter(parts))


def negation(condition: Condition) -> Condition:
    """The opposite."""
    if isinstance(condition, bool):
        return not condition
    if isinstance(condition, Atom):
        return Atom(condition.relation, condition.operands, not condition.holds)
    return Joined(not condition.both, frozenset(negation(part) for part in condition.parts))


@dataclass(frozen=True)
class Choice:
    """`yes` where the condition holds, else `no`."""

    condition: Condition
    yes: Decision
    no: Decision
    cases: int = field(init=False, compare=False, default=2)

    def __post_init__(self) -> None:
        cases = sum(side.cases if isinstance(side, Choice) else 1 for side in (self.yes, self.no))
        object.__setattr__(self, "cases", cases)


MOST_CASES = 64
"""Each condition can double them."""

MOST_STATEMENTS = 12
"""Of a condition whose every case is tried."""

Decision = int | Choice


def choice(condition: Condition, yes: Decision, no: Decision) -> Decision:
    """A choice, written in one way of those in which it can be.

    c ? x : (d ? x : y)  ->  c || d ? x : y            c ? (d ? x : y) : y  ->  c && d ? x : y
    """
    if isinstance(condition, bool):
        return yes if condition else no
    if yes == no:
        return yes
    if isinstance(no, Choice) and yes in (no.yes, no.no):
        other = no.condition if yes == no.yes else negation(no.condition)
        return choice(joined(False, condition, other), yes, no.no if yes == no.yes else no.yes)
    if isinstance(yes, Choice) and no in (yes.yes, yes.no):
        other = yes.condition if no == yes.no else negation(yes.condition)
        return choice(joined(True, condition, other), yes.yes if no == yes.no else yes.no, no)
    negative = isinstance(condition, Atom) and not condition.holds
    if negative or (isinstance(condition, Joined) and not condition.both):
        condition, yes, no = negation(condition), no, yes
    found = Choice(condition, yes, no)
    if found.cases > MOST_CASES:
        raise ExpressionError(f"an integer that has more than {MOST_CASES} cases is not supported")
    return found


MOST_PAIRS = 4_096
"""Pairs of decisions that `equivalent` looks at."""


def equivalent(one: Decision | None, two: Decision | None) -> bool:
    """Whether two decisions are the same, whichever of their statements are true.

    Shannon's expansion: with each statement true, and false, what is left has to be equivalent.
    False where that would take more than `MOST_PAIRS` pairs.
    """
    waiting = [(one, two)]
    seen: set[tuple[Decision | None, Decision | None]] = set()
    while waiting:
        pair = left, right = waiting.pop()
        if left == right or pair in seen:
            continue
        if left is None or right is None or len(seen) == MOST_PAIRS:
            return False
        seen.add(pair)
        first = next((atom for side in (left, right) for atom in atoms(side)), None)
        if first is None:
            return False
        for truth in (True, False):

            def known(atom: Atom, first: Atom = first, truth: bool = truth) -> Condition:
                return truth if atom == first else atom

            waiting.append((renamed(left, known), renamed(right, known)))
    return True


def renamed(decision: Decision, name: Callable[[Atom], Condition]) -> Decision:
    """The same decision with other names for its statements."""
    if not isinstance(decision, Choice):
        return decision
    yes, no = renamed(decision.yes, name), renamed(decision.no, name)
    return choice(_renamed(decision.condition, name), yes, no)


def _renamed(condition: Condition, name: Callable[[Atom], Condition]) -> Condition:
    if isinstance(condition, bool):
        return condition
    if isinstance(condition, Atom):
        found = name(Atom(condition.relation, condition.operands))
        return found if condition.holds else negation(found)
    result: Condition = condition.both
    for part in condition.parts:
        result = joined(condition.both, result, _renamed(part, name))
    return result


def atoms(decision: Decision) -> Iterator[Atom]:
    """Every statement that a decision is about, without its negation."""
    if isinstance(decision, Choice):
        yield from _atoms(decision.condition)
        yield from atoms(decision.yes)
        yield from atoms(decision.no)


def possible(condition: Condition) -> bool:
    """Whether a condition holds for some truth of its statements, each taken for itself.

    Raises
    ------
    ExpressionError
        If it has too many statements to try.
    """
    if isinstance(condition, bool):
        return condition
    every = dict.fromkeys(_atoms(condition))
    if len(every) > MOST_STATEMENTS:
        raise ExpressionError(f"more than {MOST_STATEMENTS} comparisons decide a value")
    one = next(iter(every))
    return any(
        possible(_renamed(condition, lambda atom, v=value: v if atom == one else atom))  # type: ignore[misc]
        for value in (True, False)
    )


def _atoms(condition: Condition) -> Iterator[Atom]:
    if isinstance(condition, Atom):
        yield Atom(condition.relation, condition.operands)
    elif not isinstance(condition, bool):
        for part in condition.parts:
            yield from _atoms(part)

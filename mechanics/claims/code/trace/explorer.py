"""The ways through a function that decides: every condition once with yes, once with no.

if x > 0: ...        -> (x > 0, True), and in the next call (x > 0, False)
"""

from dataclasses import dataclass, field
from typing import Any

import sympy
from sympy import Expr
from sympy.logic.boolalg import Boolean, BooleanFalse, BooleanTrue

from mechanics.claims.code.trace.formulas import Assignment, Authored
from mechanics.claims.demands import NOTHING, Asked, Demand
from mechanics.errors import InputError

MOST_PATHS = 64
MOST_DECISIONS = 200


class TooManyPathsError(InputError):
    """A function decides more often than all ways through it can be followed."""


@dataclass
class Explorer:
    """The decisions of one call: those that are set beforehand, then `True` for every new one.

    `formulas` are those of the numbers that it returns, as its code has them; `names` are the keys
    that they have, where they are entries of a dictionary; `asked` is what each decision asks
    for, `outputs` what each number that is returned does; `failure` is how it ended in an
    error; `assigned` what its lines give names to; `hidden` what it did with traced numbers that
    does not show in formulas, in words.
    """

    prefix: tuple[bool, ...] = ()
    taken: list[tuple[Boolean, bool]] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    formulas: dict[Expr, Authored] = field(default_factory=dict)
    names: tuple[str, ...] = ()
    asked: list[Asked] = field(default_factory=list)
    outputs: list[tuple[Demand, ...]] = field(default_factory=list)
    failure: str = ""
    assigned: dict[str, Assignment] = field(default_factory=dict)
    hidden: list[str] = field(default_factory=list)

    def decide(self, condition: Boolean, asked: Asked = NOTHING) -> bool:
        """Which way to go at a condition."""
        if isinstance(condition, BooleanTrue | BooleanFalse):
            return bool(condition)
        for known, answer in self.taken:
            if known == condition:
                return answer
            if known == sympy.Not(condition):
                return not answer
        if len(self.taken) >= MOST_DECISIONS:
            raise TooManyPathsError("the function has too many branches to trace")
        at = len(self.taken)
        answer = self.prefix[at] if at < len(self.prefix) else True
        self.taken.append((condition, answer))
        self.asked.append(asked)
        return answer


class Condition:
    """A comparison of traced numbers."""

    def __init__(self, condition: Boolean, explorer: Explorer, asked: Asked = NOTHING) -> None:
        self.condition, self.explorer, self.asked = condition, explorer, asked

    def __bool__(self) -> bool:
        return self.explorer.decide(self.condition, self.asked)

    def __and__(self, other: Any) -> bool:
        return bool(self) and bool(other)

    def __or__(self, other: Any) -> bool:
        return bool(self) or bool(other)

    def __invert__(self) -> bool:
        return not bool(self)

    def __eq__(self, other: object) -> Any:
        return bool(self) == other

    def __hash__(self) -> int:
        return hash(bool(self))

    def __repr__(self) -> str:
        return repr(bool(self))

    __rand__, __ror__ = __and__, __or__

"""Values while a C function is read: real numbers as nodes, integers, conditions, arrays."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from mechanics.errors import ExpressionError
from mechanics.program.c.condition import Choice, Condition, Decision, choice, joined, negation
from mechanics.program.c.function import Written
from mechanics.program.c.index_polynomials import Whole, whole
from mechanics.program.c.types import Type


class Real(NamedTuple):
    """A number of the function: its node and type."""

    node: int
    kind: str


class Truth(NamedTuple):
    """What a comparison gives: 1 or 0, or for `isfinite` any other number than 0, or 0."""

    condition: Condition
    exact: bool = True


@dataclass(eq=False)
class Array:
    """An argument or a local array.

    Attributes
    ----------
    name : str
        As messages call it.
    place : int or None
        Of the argument among the parameters; None for a local array.
    guards : int
        Conditions under which it was declared.
    entries : dict of int to list of Written
        What was written.
    """

    name: str
    kind: str
    size: int
    place: int | None = None
    stride: str = ""
    constant: bool = False
    guards: int = 0
    entries: dict[int, list[Written]] = field(default_factory=dict)


class Pointer(NamedTuple):
    """A place in an array."""

    array: Array
    offset: Whole


class Address(NamedTuple):
    """The address of a variable, for a function that writes it."""

    variable: Variable


@dataclass(eq=False)
class Variable:
    """A local variable; it has no value until something is assigned."""

    name: str
    type: Type
    value: Value | None = None
    guards: int = 0


Value = Real | Whole | Choice | Truth | Pointer | Address


def as_condition(value: Value | None, where: Any) -> Condition:
    """A value that decides.

    Raises
    ------
    ExpressionError
        If it is neither a comparison nor an integer.
    """
    if isinstance(value, Truth):
        return value.condition
    if isinstance(value, Whole) and value.known is not None:
        return value.known != 0
    if isinstance(value, Choice):
        yes, no = (as_condition(_value(d), where) for d in (value.yes, value.no))
        taken = joined(True, value.condition, yes)
        return joined(False, taken, joined(True, negation(value.condition), no))
    raise ExpressionError(f"{where}: {type(value).__name__} decides: compare it with a number")


def as_decision(value: Value | None, where: Any) -> Decision:
    """An integer, which may depend on conditions.

    Raises
    ------
    ExpressionError
        If it is none.
    """
    if isinstance(value, Choice):
        return value
    if isinstance(value, Truth):
        if not value.exact:
            raise ExpressionError(f"{where}: isfinite() gives 0 or any other number: compare it")
        return choice(value.condition, 1, 0)
    if isinstance(value, Whole) and value.known is not None:
        return value.known
    raise ExpressionError(f"{where}: an integer is expected, {type(value).__name__} found")


def _value(decision: Decision) -> Value:
    return whole(decision) if isinstance(decision, int) else decision


def of_decision(decision: Decision) -> Value:
    """The value that a decision is."""
    return _value(decision)


def compared(op: str, left: Decision, right: Decision) -> Decision:
    """left op right for two integers that depend on conditions."""
    if isinstance(left, Choice):
        sides = (compared(op, side, right) for side in (left.yes, left.no))
        return choice(left.condition, *sides)
    if isinstance(right, Choice):
        sides = (compared(op, left, side) for side in (right.yes, right.no))
        return choice(right.condition, *sides)
    return int(INTEGERS[op](left, right))


INTEGERS: dict[str, Callable[[int, int], int]] = {
    "<": int.__lt__, "<=": int.__le__, ">": int.__gt__, ">=": int.__ge__,
    "==": int.__eq__, "!=": int.__ne__, "|": int.__or__,
    "&": int.__and__, "<<": int.__lshift__, "+": int.__add__, "-": int.__sub__, "*": int.__mul__,
}  # fmt: skip


def words(value: Value | None) -> str:
    """What a value is, for messages."""
    names = {
        Whole: "an integer", Choice: "an integer", Truth: "a comparison", Pointer: "an array",
        Address: "an address", Real: "a number",
    }  # fmt: skip
    return names.get(type(value), "nothing")

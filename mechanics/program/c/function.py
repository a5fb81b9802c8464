"""What a C function does, in terms of nodes of whatever it is read into."""

from collections.abc import Mapping
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, NamedTuple, Protocol

from mechanics.program.c.condition import Condition, Decision


@dataclass(frozen=True)
class Parameter:
    """What one argument of a C function is, in the order of the arguments.

    Attributes
    ----------
    name : str
        Of the quantity, for messages; the text may call it otherwise.
    kind : str
        ``"double"`` or ``"float"`` for an array, ``"size_t"`` for an integer.
    size : int
        Entries of an array, of one lane.
    output : bool
        Whether the function writes it.
    stride : str
        Name of the integer parameter by which entries of a lane are apart; empty where all lanes
        share the array, or there are none.
    """

    name: str
    kind: str
    size: int = 1
    output: bool = False
    stride: str = ""


class Written(NamedTuple):
    """A value that an output gets where a condition holds."""

    condition: Condition
    node: int


@dataclass(frozen=True)
class Function:
    """What a C function computes.

    Attributes
    ----------
    outputs : mapping of (place, entry) to tuple of (Condition, node)
        What was written, in the order in which it was: each is what stands there at last where its
        condition holds and those after it do not.
    status : Decision or None
        What it returns; None for a function that returns nothing. Operands of its conditions are
        nodes.
    beyond : tuple of str
        Reads beyond the end of an array; such a value is an input of the place `BEYOND`.
    late : tuple of str
        Reads of an input after an output was written.
    lanes : str
        Name of the integer that counts the lanes; empty for a function of one state.
    named : mapping of int to (str, str)
        The first local variable that a node was assigned to, and where: ``file:line:column``.
    """

    name: str
    outputs: Mapping[tuple[int, int], tuple[Written, ...]]
    status: Decision | None
    beyond: tuple[str, ...]
    late: tuple[str, ...]
    lanes: str
    named: Mapping[int, tuple[str, str]] = field(default_factory=dict)


BEYOND = -1


class Target(Protocol):
    """Where operations go as they are read; a node is an integer, `kind` its type in C."""

    def number(self, value: Fraction, kind: str) -> int:
        """The node of a constant."""
        ...

    def input(self, place: int, entry: int, kind: str) -> int:
        """The node of an entry of an argument."""
        ...

    def apply(self, operation: str, operands: tuple[int, ...], kind: str) -> int:
        """The node of an operation, by its name in the table or in `COMPOSED`."""
        ...

    def constant(self, node: int) -> Fraction | None:
        """The number that a node is, if it is one."""
        ...

    def is_truth(self, node: int) -> bool:
        """Whether the value of a node is 0 or 1."""
        ...

    def choose(self, condition: Condition, yes: int, no: int, kind: str, where: Any) -> int:
        """The node that is `yes` where the condition holds, else `no`."""
        ...

    def under(self, condition: Condition) -> AbstractContextManager[Any]:
        """What is read inside is computed where the condition holds."""
        ...

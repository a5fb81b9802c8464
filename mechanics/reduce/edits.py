"""Edits of a program: which operations become less, and the program with some of them made.

    zero      x        ->  0          a parameter, a product of speeds, an entry of the mass matrix
    first     x +- y   ->  x          a summand
    second    x +- y   ->  +- y
    angle     sin x    ->  x          small angles
    one       cos x    ->  1

A program with edits is the program interpreted with others in the place of some values, so that
what remains of an operation is decided by the builder that it is built in.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction
from typing import Any

from mechanics.program import Builder, Node, Program
from mechanics.program import operations as op
from mechanics.program.interpret import Nodes


class Kind(Enum):
    """What becomes of a node; the value is for people."""

    ZERO = "left out"
    FIRST = "the second term left out"
    SECOND = "the first term left out"
    ANGLE = "sin x = x"
    ONE = "cos x = 1"


@dataclass(frozen=True)
class Edit:
    """One change.

    Attributes
    ----------
    node : int
        Of the program.
    """

    node: int
    kind: Kind


Edits = Mapping[int, Kind]
"""By node."""


def values(
    program: Program, domain: Any, inputs: Mapping[str, Any], edits: Edits,
    pushed: Callable[[int, Any], Any] = lambda number, value: value,
) -> list[Any]:  # fmt: skip
    """Values of all nodes in a domain, the edits made; the program holds no linear systems.

    Parameters
    ----------
    domain : Domain
    inputs : mapping of str to values of the domain
    edits : mapping of int to Kind
    pushed : callable
        What a value becomes, from the number of its node.
    """
    found: list[Any] = []
    first, known = program.operands[0], domain.operations
    for number, code in enumerate(program.operations):
        kind = edits.get(number)
        operands = [found[k] for k in program.operands_of(number)]
        if kind is not None:
            value = _edited(kind, code, operands, domain)
        elif code == op.CONSTANT:
            value = domain.constant(program.constants[first[number]])
        elif code == op.INPUT:
            value = inputs[program.inputs[first[number]]]
        elif code == op.PI:
            value = domain.pi()
        else:
            value = known[op.OPERATIONS[code].name](*operands)
        found.append(pushed(number, value))
    return found


def _edited(kind: Kind, code: int, operands: list[Any], domain: Any) -> Any:
    if kind in (Kind.ZERO, Kind.ONE):
        return domain.constant(Fraction(int(kind is Kind.ONE)))
    if kind is Kind.SECOND:
        return -operands[1] if code == op.SUBTRACT else operands[1]
    return operands[0]


def nodes(
    program: Program, builder: Builder, numbers: Mapping[str, Node], edits: Edits
) -> list[Node]:
    """All nodes in a builder, with numbers in the place of some inputs."""
    inputs = {n: numbers[n] if n in numbers else builder.input(n) for n in program.inputs}
    return values(program, Nodes(builder), inputs, edits)

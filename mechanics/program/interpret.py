"""Run a program in any domain: numbers, arrays, residues, series, nodes of another builder.

A domain says what constants are and what each operation does; nothing else knows how to walk a
program. Values that no later node needs are dropped as soon as that is known.
"""

import operator
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import partial
from typing import Any, Protocol, runtime_checkable

from mechanics.errors import ExpressionError
from mechanics.program.builder import Builder, Node
from mechanics.program.operations import ARITY, CONSTANT, ENTRY, INPUT, OPERATIONS, PI, SOLVE
from mechanics.program.program import Program


class Domain(Protocol):
    """What an interpreter needs to know."""

    @property
    def operations(self) -> Mapping[str, Callable[..., Any]]:
        """By the name in the table: from the values of the operands to the value."""

    def constant(self, value: Fraction) -> Any:
        """The rational in this domain."""

    def pi(self) -> Any:
        """The number pi in this domain."""


@runtime_checkable
class Solver(Protocol):
    """What a domain needs for programs that hold linear systems, too."""

    def solve(self, matrix: list[list[Any]], right: list[Any], symmetric: bool) -> Sequence[Any]:
        """x of matrix x = right."""


def interpret(
    program: Program, domain: Domain, inputs: Mapping[str, Any], *, release: bool = True
) -> dict[str, tuple[Any, ...]]:
    """Values of the outputs.

    Parameters
    ----------
    program : Program
    domain : Domain
    inputs : mapping of str to values of the domain
    release : bool
        False where values are so small that finding out when each is no longer needed costs more
        than keeping them.

    Raises
    ------
    KeyError
        If an input that is used has no value.
    ExpressionError
        If an operation has no meaning in the domain.
    """
    first, second, third = program.operands
    known = domain.operations
    functions = [known.get(row.name) for row in OPERATIONS]
    values: list[Any] = [None] * len(program)
    drop = _last_uses(program) if release else {}
    for number, code in enumerate(program.operations):
        arity = ARITY[code]
        if code == CONSTANT:
            values[number] = domain.constant(program.constants[first[number]])
        elif code == INPUT:
            values[number] = inputs[program.inputs[first[number]]]
        elif code == PI:
            values[number] = domain.pi()
        elif code == ENTRY:
            values[number] = values[first[number]][second[number]]
        elif code == SOLVE and isinstance(domain, Solver):
            values[number] = _solved(program, domain, values, first[number])
        else:
            function = functions[code]
            if function is None:
                raise ExpressionError(
                    f"operation {OPERATIONS[code].name} is not supported:"
                    " write the expression without it"
                )
            if arity == 2:
                values[number] = function(values[first[number]], values[second[number]])
            elif arity == 1:
                values[number] = function(values[first[number]])
            else:
                values[number] = function(
                    values[first[number]], values[second[number]], values[third[number]]
                )
        if release:
            for old in drop.get(number, ()):
                values[old] = None
    return {name: tuple(values[n] for n in ns) for name, ns in program.outputs.items()}


def _solved(program: Program, domain: Solver, values: list[Any], place: int) -> Sequence[Any]:
    size, symmetric, *entries = program.systems[place]
    known = [values[entry] for entry in entries]
    matrix = [known[size * i : size * (i + 1)] for i in range(size)]
    return domain.solve(matrix, known[size * size :], bool(symmetric))


def _last_uses(program: Program) -> dict[int, list[int]]:
    """Nodes whose values are used for the last time, by the node that uses them."""
    last = {operand: n for n in range(len(program)) for operand in program.operands_of(n)}
    kept = set(program.roots)
    found: dict[int, list[int]] = {}
    for operand, number in last.items():
        if operand not in kept:
            found.setdefault(number, []).append(operand)
    return found


ARITHMETIC: Mapping[str, Callable[..., Any]] = {"add": operator.add, "subtract": operator.sub,
    "multiply": operator.mul, "divide": operator.truediv, "negate": operator.neg}  # fmt: skip


@dataclass(frozen=True)
class Nodes:
    """The domain of nodes of a builder, some operations having another meaning."""

    builder: Builder
    others: Mapping[str, Callable[..., Node]] = field(default_factory=dict)

    @property
    def operations(self) -> Mapping[str, Callable[..., Any]]:
        """Each operation asks the builder for its node."""
        names = (row.name for row in OPERATIONS if row.arity and row.code != ENTRY)
        return {n: partial(self.builder.call, n) for n in names} | {**ARITHMETIC, **self.others}

    def constant(self, value: Fraction) -> Node:
        """The constant as a node."""
        return self.builder.constant(value)

    def pi(self) -> Node:
        """Pi as a node."""
        return self.builder.pi

    def solve(self, matrix: list[list[Any]], right: list[Any], symmetric: bool) -> Sequence[Node]:
        """The components of the solution as nodes."""
        return self.builder.solve(matrix, right, symmetric=symmetric)


def include(
    builder: Builder, program: Program, inputs: Mapping[str, Node] | None = None,
    operations: Mapping[str, Callable[..., Node]] | None = None,
) -> dict[str, tuple[Node, ...]]:  # fmt: skip
    """Build a program's outputs in a builder, with nodes in the place of its inputs.

    Parameters
    ----------
    inputs : mapping of str to Node, optional
        An input that is left out stays an input of its name.
    operations : mapping of str to callable, optional
        What operations become that are not built as they are.
    """
    given = {name: builder.input(name) for name in program.inputs} | dict(inputs or {})
    return interpret(program, Nodes(builder, operations or {}), given, release=False)

"""Programs as CasADi functions.

Constants are exact until here: x (1/n) becomes x / n, which rounds once; other rationals become the
nearest doubles.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from math import pi
from typing import Any

import casadi

from mechanics.errors import ExpressionError
from mechanics.program.constants import unit_fraction
from mechanics.program.elimination import expand_solves
from mechanics.program.interpret import interpret
from mechanics.program.operations import MULTIPLY, OPERATIONS
from mechanics.program.program import Program


def print_function(
    program: Program,
    name: str,
    inputs: Mapping[str, Sequence[str]],
    shapes: Mapping[str, tuple[int, int]] | None = None,
    options: Mapping[str, Any] | None = None,
) -> casadi.Function:
    """A CasADi function of vectors.

    Parameters
    ----------
    program : Program
        Its linear systems are written out, see `mechanics.program.elimination`.
    name : str
        Of the function.
    inputs : mapping of str to sequence of str
        Name of each vector, and the inputs of the program that it holds, in order.
    shapes : mapping of str to (int, int), optional
        Rows and columns of outputs that are matrices, row by row in the program; others are
        columns.
    options : mapping, optional
        Of `casadi.Function`.

    Returns
    -------
    casadi.Function
        Of SX, one output for each output of the program.

    Raises
    ------
    ExpressionError
        If an input of the program is in no vector or in two, a shape does not fit, or a linear
        system needs pivots that are chosen at run time.

    Examples
    --------
    >>> from mechanics.program import Builder
    >>> b = Builder()
    >>> program = b.program({"f": [b.input("x") * b.input("y")]})
    >>> print_function(program, "f", {"v": ["x", "y"]})([2, 3])
    DM(6)
    """
    vectors = {vector: casadi.SX.sym(vector, len(names)) for vector, names in inputs.items()}
    entries: dict[str, Any] = {}
    for vector, names in inputs.items():
        for k, entry in enumerate(names):
            if entry in entries:
                raise ExpressionError(f"input {entry} stands in two vectors: leave one out")
            entries[entry] = vectors[vector][k]
    if missing := [entry for entry in program.inputs if entry not in entries]:
        raise ExpressionError(f"input {missing[0]} stands in no vector: say in which")
    values = interpret(expand_solves(program), _Graph(), entries)
    outputs = {
        output: _column(output, [_graph(value) for value in numbers], (shapes or {}).get(output))
        for output, numbers in values.items()
    }
    return casadi.Function(
        name, list(vectors.values()), list(outputs.values()), list(vectors), list(outputs),
        dict(options or {}),
    )  # fmt: skip


def _column(name: str, values: Sequence[Any], shape: tuple[int, int] | None) -> Any:
    if shape is None:
        return casadi.vertcat(*values) if values else casadi.SX(0, 1)
    rows, columns = shape
    if rows * columns != len(values):
        raise ExpressionError(
            f"output {name} has {len(values)} entries: {rows} x {columns} do not hold them"
        )
    # CasADi fills matrices column by column.
    ordered = [values[i * columns + j] for j in range(columns) for i in range(rows)]
    return casadi.reshape(casadi.vertcat(*ordered), rows, columns)


class _Graph:
    """The domain of SX; constants stay rationals until an operation takes them."""

    @property
    def operations(self) -> Mapping[str, Callable[..., Any]]:
        return {
            row.name: _function(row.casadi) for row in OPERATIONS if row.casadi and row.arity
        } | {"select": _select, OPERATIONS[MULTIPLY].name: _multiply}

    def constant(self, value: Fraction) -> Fraction:
        return value

    def pi(self) -> Any:
        return casadi.SX(pi)

    def solve(self, matrix: list[list[Any]], right: list[Any], symmetric: bool) -> Sequence[Any]:
        raise AssertionError("systems are written out before")


def _graph(value: Any) -> Any:
    return casadi.SX(float(value)) if isinstance(value, Fraction) else value


def _function(operation: str) -> Callable[..., Any]:
    code = getattr(casadi, operation)

    def apply(*operands: Any) -> Any:
        make = casadi.SX.unary if len(operands) == 1 else casadi.SX.binary
        return make(code, *map(_graph, operands))

    return apply


def _multiply(x: Any, y: Any) -> Any:
    for constant, other in ((x, y), (y, x)):
        if isinstance(constant, Fraction) and (divisor := unit_fraction(constant)):
            return casadi.SX.binary(casadi.OP_DIV, _graph(other), casadi.SX(divisor))
    return casadi.SX.binary(casadi.OP_MUL, _graph(x), _graph(y))


def _select(condition: Any, x: Any, y: Any) -> Any:
    return casadi.if_else(*map(_graph, (condition, x, y)))

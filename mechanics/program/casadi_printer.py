"""Programs as CasADi functions.

Constants are exact until here, and so is what is computed from constants alone: sqrt(3)/2 is one
number. x (1/n) becomes x / n, which rounds once; other numbers become the nearest doubles.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import inf, isfinite
from typing import Any

import casadi
import sympy

from mechanics.errors import ExpressionError
from mechanics.program.constants import is_double, unit_fraction
from mechanics.program.elimination import expand_solves
from mechanics.program.interpret import interpret
from mechanics.program.operations import MULTIPLY, OPERATIONS
from mechanics.program.program import Program
from mechanics.program.sympy_printer import Expressions


def print_function(
    program: Program,
    name: str,
    inputs: Mapping[str, Sequence[str]],
    shapes: Mapping[str, tuple[int, int]] | None = None,
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
    outputs = print_graphs(program, entries, shapes)
    return casadi.Function(
        name, list(vectors.values()), list(outputs.values()), list(vectors), list(outputs)
    )


DIGITS = 40
"""Of a number before it becomes the nearest double."""

Named = Callable[[sympy.Expr], Any]
"""The graph that stands for a number that no double holds."""


def print_graphs(
    program: Program,
    entries: Mapping[str, Any],
    shapes: Mapping[str, tuple[int, int]] | None = None,
    named: Named | None = None,
) -> dict[str, Any]:
    """The outputs of a program as graphs.

    Parameters
    ----------
    entries : mapping of str to casadi.SX
        For each input a scalar.
    shapes : mapping of str to (int, int), optional
        As in `print_function`.
    named : callable, optional
        What stands for numbers that no double holds; by default the nearest doubles do.
    """
    domain = ExactGraphs(named or _nearest)
    values = interpret(expand_solves(program), domain, entries)
    return {
        output: _column(output, [domain.graph(value) for value in numbers],
                        (shapes or {}).get(output))
        for output, numbers in values.items()
    }  # fmt: skip


def nearest(number: sympy.Expr) -> float:
    """The double nearest to an exact number."""
    if isinstance(number, sympy.Rational):
        try:
            return float(Fraction(int(number.p), int(number.q)))
        except OverflowError:
            return inf if number > 0 else -inf  # which no text is written of
    return float(number.evalf(DIGITS))


def _nearest(number: sympy.Expr) -> Any:
    return casadi.SX(nearest(number))


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


@dataclass(frozen=True)
class ExactGraphs:
    """The domain of SX without roundings: numbers are rationals, or SymPy's, until a graph is made.

    CasADi computes in doubles what it is told of numbers alone: 981 / 100 would be 9.81.

    Attributes
    ----------
    named : callable
        The graph that stands for a number that no double holds.
    """

    named: Named

    @property
    def operations(self) -> Mapping[str, Callable[..., Any]]:
        """Those of CasADi."""
        graphs = {
            row.name: self._function(row.casadi) for row in OPERATIONS if row.casadi and row.arity
        } | {"select": self._select, OPERATIONS[MULTIPLY].name: self._multiply}
        numbers = Expressions().operations
        return {name: self._of(code, numbers.get(name)) for name, code in graphs.items()}

    def constant(self, value: Fraction) -> Fraction:
        """A number."""
        return value

    def pi(self) -> Any:
        """Pi."""
        return sympy.pi

    def solve(self, matrix: list[list[Any]], right: list[Any], symmetric: bool) -> Sequence[Any]:
        """None: systems are written out before."""
        raise AssertionError("systems are written out before")

    def value(self, entry: Any) -> Any:
        """A scalar graph or a number of SymPy's as a value; what is a number is that number."""
        if isinstance(entry, sympy.Rational):
            return Fraction(int(entry.p), int(entry.q))
        if isinstance(entry, casadi.SX) and entry.is_constant() and isfinite(float(entry)):
            return Fraction(float(entry))
        return entry

    def graph(self, value: Any) -> Any:
        """The graph of a value."""
        if isinstance(value, Fraction):
            return casadi.SX(float(value)) if is_double(value) else self.named(_number(value))
        return self.named(value) if isinstance(value, sympy.Expr) else value

    def _of(
        self, code: Callable[..., Any], number: Callable[..., Any] | None
    ) -> Callable[..., Any]:
        """An operation; of constants alone, a constant where it has a finite real value."""

        def apply(*operands: Any) -> Any:
            if number is not None and all(isinstance(x, Fraction | sympy.Expr) for x in operands):
                value = number(*map(_number, operands))
                if isinstance(value, sympy.Expr) and value.is_number and value.is_real:
                    return self.value(value)
            return self.value(code(*operands))

        return apply

    def _function(self, operation: str) -> Callable[..., Any]:
        code = getattr(casadi, operation)

        def apply(*operands: Any) -> Any:
            make = casadi.SX.unary if len(operands) == 1 else casadi.SX.binary
            return make(code, *map(self.graph, operands))

        return apply

    def _multiply(self, x: Any, y: Any) -> Any:
        for constant, other in ((x, y), (y, x)):
            if isinstance(constant, Fraction) and (divisor := unit_fraction(constant)):
                # Named, or CasADi would differentiate x / n into the double 1/n.
                below = self.named(sympy.Integer(divisor))
                return casadi.SX.binary(casadi.OP_DIV, self.graph(other), below)
        return casadi.SX.binary(casadi.OP_MUL, self.graph(x), self.graph(y))

    def _select(self, condition: Any, x: Any, y: Any) -> Any:
        return casadi.if_else(*map(self.graph, (condition, x, y)))


def _number(value: Any) -> Any:
    if isinstance(value, Fraction):
        return sympy.Rational(value.numerator, value.denominator)
    return value

"""Programs as SymPy expressions, for those who want to read them."""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

import sympy

from mechanics.errors import ExpressionError
from mechanics.program.elimination import expand_solves
from mechanics.program.interpret import interpret
from mechanics.program.operations import ARITY, ENTRY, OPERATIONS
from mechanics.program.program import Program

LARGEST = 100_000
"""Operations of all outputs, what is shared written out wherever it stands."""


def expressions(
    program: Program,
    symbols: Mapping[str, Any] | None = None,
    *,
    limit: int = LARGEST,
) -> dict[str, tuple[Any, ...]]:
    """SymPy expressions of the outputs.

    Parameters
    ----------
    program : Program
        Its linear systems are written out, see `mechanics.program.elimination`.
    symbols : mapping of str to sympy.Expr, optional
        What stands for an input; by default the symbol of its name.
    limit : int
        Most operations that may be written.

    Returns
    -------
    dict of str to tuple of sympy.Expr
        Evaluated as SymPy does by default, nothing expanded.

    Raises
    ------
    ExpressionError
        If they have more operations than the limit.

    Examples
    --------
    >>> from mechanics.program import Builder
    >>> b = Builder()
    >>> x, y = b.input("x"), b.input("y")
    >>> expressions(b.program({"f": [x / y + x.sin() / 3]}))["f"]
    (x/y + sin(x)/3,)
    """
    program = expand_solves(program)
    size = written_size(program)
    if size > limit:
        raise ExpressionError(
            f"{program!r} written out has {size} operations, more than {limit}:"
            " print fewer outputs, or raise the limit"
        )
    given = {name: sympy.Symbol(name) for name in program.inputs} | dict(symbols or {})
    values = interpret(program, Expressions(), given)
    return {name: tuple(map(_number, outputs)) for name, outputs in values.items()}


def written_size(program: Program) -> int:
    """Operations of the outputs where what is shared is written out wherever it stands.

    A linear system counts as its entries.
    """
    sizes: list[int] = []
    for number, code in enumerate(program.operations):
        own = int(ARITY[code] > 0 and code != ENTRY)
        sizes.append(own + sum(sizes[operand] for operand in program.operands_of(number)))
    return sum(sizes[root] for root in program.roots)


class Expressions:
    """The domain of SymPy expressions; truth values stay SymPy's until a number is needed."""

    @property
    def operations(self) -> Mapping[str, Callable[..., Any]]:
        """What each operation makes of expressions."""
        return {
            row.name: _of_numbers(getattr(sympy, row.sympy))
            for row in OPERATIONS
            if row.sympy and row.arity
        } | {
            "subtract": _of_numbers(lambda x, y: x - y),
            "divide": _of_numbers(lambda x, y: x / y),
            "negate": _of_numbers(lambda x: -x),
            "and": lambda x, y: sympy.And(_truth(x), _truth(y)),
            "or": lambda x, y: sympy.Or(_truth(x), _truth(y)),
            "not": lambda x: sympy.Not(_truth(x)),
            "select": _select,
        }

    def constant(self, value: Fraction) -> Any:
        """A rational."""
        return sympy.Rational(value.numerator, value.denominator)

    def pi(self) -> Any:
        """The number pi."""
        return sympy.pi

    def solve(self, matrix: list[list[Any]], right: list[Any], symmetric: bool) -> Sequence[Any]:
        """Nothing: systems are written out before."""
        raise AssertionError("systems are written out before")


def _of_numbers(function: Callable[..., Any]) -> Callable[..., Any]:
    return lambda *operands: function(*map(_number, operands))


def _number(value: Any) -> Any:
    if isinstance(value, sympy.Expr):
        return value
    return sympy.Piecewise((sympy.Integer(1), value), (sympy.Integer(0), True))


def _truth(value: Any) -> Any:
    return sympy.Ne(value, 0) if isinstance(value, sympy.Expr) else value


def _select(condition: Any, x: Any, y: Any) -> Any:
    return sympy.Piecewise((_number(x), _truth(condition)), (_number(y), True))

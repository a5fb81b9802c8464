"""Plain symbols: x(t), x'(t), x''(t) become x, x_dot, x_ddot.

Printers, walkers and differentiation are quick on plain symbols. SymPy's dynamic symbols appear in
what users write, and again only inside the two adapters over SymPy's own methods.
"""

import re
from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache
from typing import Any

from sympy import Basic, Derivative, Expr, Symbol, sympify
from sympy.core.function import AppliedUndef
from sympy.matrices import MatrixBase
from sympy.physics.vector import dynamicsymbols

from mechanics.errors import SceneError

TIME = Symbol("t")
DOTS = ("", "_dot", "_ddot", "_dddot")
NUMBER = re.compile(r"(\d+)")


def name_of(function: Expr) -> str:
    """``"x"`` for x(t)."""
    if not isinstance(function, AppliedUndef) or function.args != (dynamicsymbols._t,):
        raise SceneError(
            f"{function}: a coordinate, speed or input has to be a dynamic symbol such as"
            " dynamicsymbols('x')"
        )
    return str(function.func.__name__)


def by_name(symbol: Symbol) -> tuple[tuple[str | int, ...], str]:
    """Key that puts symbols in the order of their names, m2 before m10."""
    parts = NUMBER.split(symbol.name)
    return tuple(int(part) if i % 2 else part for i, part in enumerate(parts)), symbol.name


def plain_symbol(function: Expr, order: int = 0) -> Symbol:
    """Symbol that stands for the derivative of that order of a dynamic symbol.

    That of a speed x_dot is x_ddot.
    """
    return Symbol(dotted(name_of(function), order), real=True)


def dotted(name: str, order: int) -> str:
    """``"x_ddot"`` for ``"x"`` and 2, or for ``"x_dot"`` and 1."""
    if order and name.endswith(DOTS[1]):
        return f"{name.removesuffix(DOTS[1])}_{'d' * (order + 1)}ot"
    return name + DOTS[order]


def plain_table(functions: Iterable[Expr]) -> dict[Expr, Symbol]:
    """Table from each dynamic symbol and its first three derivatives to plain symbols."""
    t = dynamicsymbols._t
    table: dict[Expr, Symbol] = {}
    for function in functions:
        for order, rate in enumerate(_rates(function, t)):
            table[rate] = plain_symbol(function, order)
    return table


@lru_cache(maxsize=1024)
def _rates(function: Expr, t: Symbol) -> tuple[Expr, ...]:
    """A function of time and its derivatives, which many tables ask for again."""
    return tuple(function.diff(t, order) if order else function for order in range(len(DOTS)))


def to_plain(expression: Expr, table: Mapping[Expr, Expr], where: str) -> Expr:
    """Replace the functions of time in an expression by plain symbols.

    Raises
    ------
    SceneError
        When a function of time is left that the table does not know; `where` names the place.
    """
    expression = sympify(expression)
    if not any(isinstance(part, Derivative | AppliedUndef) for part in parts_of([expression])):
        return expression
    if expression.has(Derivative):
        # d/dt of a whole expression, as people type it, is carried out first.
        expression = expression.doit()
    plain = expression.xreplace(dict(table))
    high = plain.atoms(Derivative)
    if high:
        raise SceneError(
            f"{where}: {high.pop()} is a derivative that nothing determines: coordinates have two,"
            " inputs three"
        )
    left = plain.atoms(AppliedUndef)
    if left:
        names = ", ".join(sorted(str(function) for function in left))
        raise SceneError(
            f"{where}: {names} is neither a coordinate, a speed nor an input of the scene:"
            " add it to coordinates=, speeds= or inputs="
        )
    return plain


def parts_of(expressions: Iterable[Basic]) -> Iterator[Basic]:
    """Every part of the expressions, each object once.

    SymPy's own walk meets a part as often as it occurs, which long programs of people do not bear.
    """
    stack = list(expressions)
    # What was seen is kept: another object may get the id of one that is gone.
    seen: dict[int, Basic] = {}
    while stack:
        part = stack.pop()
        if id(part) not in seen:
            seen[id(part)] = part
            yield part
            # A matrix that may change is none of SymPy's expressions.
            stack += part.flat() if isinstance(part, MatrixBase) else part.args


def symbols_of(expressions: Iterable[Expr]) -> set[Symbol]:
    """Symbols that the expressions hold, those that sums and integrals bind left out."""
    every = list(parts_of(expressions))
    if any(getattr(part, "bound_symbols", None) for part in every):
        return set().union(*(expression.free_symbols for expression in expressions))
    return {part for part in every if isinstance(part, Symbol)}


def entries(value: Any) -> list[Any]:
    """Entries of a matrix, row by row; anything else is its only one."""
    return list(value) if isinstance(value, MatrixBase) else [value]

"""Parameters that are given a number before anything is compiled.

    M(q, p, 981/100) u' = f(q, u, p, 981/100)

A number is the exact decimal that was typed, so what is compiled can be proved equal to what was
derived, at that rational. A product with zero is gone, and what only it needed with it.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import partial
from typing import Any

import sympy
from sympy import Expr, Matrix, Rational, Symbol

from mechanics.equations import Equations, Matrices
from mechanics.errors import InputError, RangeError, SingularError
from mechanics.nearest import instead
from mechanics.program.constants import rational, with_pi
from mechanics.scene import Scene
from mechanics.symbolic import generic_rank

Fixed = Mapping[Symbol, Expr]


def read_fixed(
    scene: Scene, given: Mapping[str, Any], *, turns: bool = False, option: str = "--fix (fixed=)"
) -> dict[Symbol, Expr]:
    """Exact values by symbol; what a scene defines by fixed parameters is fixed too.

    Parameters
    ----------
    given : mapping of str to number or str
        By name of a parameter, or of a symbol that the definition of one uses.
    turns : bool
        Whether a value may be a multiple of pi, which is no rational.
    option : str
        Where a person gives them, for messages.

    Raises
    ------
    InputError
        For a name that the scene does not have, a value that is no number, or one that is
        negative where the parameter is declared positive.
    """
    if not isinstance(given, Mapping):
        raise InputError(f"{option}: {given!r} found: write a mapping such as {{'g': 9.81}}")
    definitions = {s: sympy.sympify(e) for s, e in scene.definitions.items()}
    named = {s.name: s for s in _used(scene.parameters, definitions)}
    table: dict[Symbol, Expr] = {}
    for name, value in given.items():
        if name not in named:
            raise InputError(
                f"{option} {name!r}: {scene.name} has no such parameter:"
                f" {instead(name, sorted(named), 'parameters')}"
            )
        table[named[name]] = _number(named[name], value, turns, option)
    for _ in definitions:
        for symbol, expression in definitions.items():
            value = expression.xreplace(table)
            if symbol not in table and not value.free_symbols:
                table[symbol] = value
    wanted = {*scene.parameters, *(named[name] for name in given)}
    return {symbol: value for symbol, value in table.items() if symbol in wanted}


def _used(symbols: Iterable[Symbol], definitions: Mapping[Symbol, Expr]) -> set[Symbol]:
    """Symbols, and those that their definitions use: others would be fixed without any effect."""
    found: set[Symbol] = set()
    stack = list(symbols)
    while stack:
        symbol = stack.pop()
        if symbol not in found:
            found.add(symbol)
            stack += definitions[symbol].free_symbols if symbol in definitions else ()
    return found


def _number(symbol: Symbol, value: Any, turns: bool, option: str) -> Expr:
    try:
        # The text of a float is the shortest decimal that gives it: what was typed.
        number, turned = with_pi(str(value)) if turns else (rational(str(value)), False)
        rounded = float(number)
    except (ValueError, ZeroDivisionError):
        raise InputError(
            f"{option} {symbol.name}: {value!r} is no number: write 9.81 or 1/3"
            f"{' or 2*pi' if turns else ''}"
        ) from None
    except RangeError as error:
        raise InputError(f"{option} {symbol.name}: {error}") from None
    except OverflowError:
        raise InputError(f"{option} {symbol.name}: {value} is beyond 1.8e308") from None
    if number and not rounded:
        raise InputError(f"{option} {symbol.name}: {value} is below the smallest double")
    if number < 0 and symbol.is_positive:
        raise InputError(
            f"{option} {symbol.name}: {value} is negative: the parameter is declared positive"
        )
    return Rational(number.numerator, number.denominator) * (sympy.pi if turned else 1)


def fix(equations: Equations, table: Fixed) -> Equations:
    """The equations with numbers in place of parameters.

    Raises
    ------
    InputError
        If something is divided by a parameter that is fixed to zero.
    SingularError
        If the equations no longer determine the accelerations.
    """
    if not table:
        return equations
    put = partial(fixed_matrix, equations, table)
    matrices = {name: put(matrix) for name, matrix in vars(equations.matrices).items()}
    fixed = replace(
        equations,
        textbook=Matrices(**matrices),
        reactions=_reactions(equations, table),
        fixed={**equations.fixed, **table},
    )
    left, _ = fixed.system
    if generic_rank(left.tolist()) < left.rows:
        raise SingularError(
            f"{equations.scene.name} by {equations.route}: with {words(table)} fixed, the equations"
            " do not determine the accelerations: is a body left without mass?"
        )
    return fixed


def fixed_matrix(equations: Equations, table: Fixed, matrix: Matrix) -> Matrix:
    """A matrix of expressions with numbers in place of parameters."""
    result = matrix.xreplace(dict(table))
    if result.has(sympy.zoo, sympy.nan, sympy.oo):
        raise InputError(
            f"{equations.scene.name} by {equations.route}: with {words(table)} fixed, something is"
            " divided by zero: leave the parameter free, or choose another route"
        )
    return result


def words(table: Fixed) -> str:
    """``c = 0, g = 981/100``."""
    return ", ".join(f"{s.name} = {e}" for s, e in sorted(table.items(), key=lambda x: x[0].name))


def _reactions(equations: Equations, table: Fixed) -> tuple[tuple[Symbol, Expr], ...]:
    symbols = [symbol for symbol, _ in equations.reactions]
    values = Matrix([value for _, value in equations.reactions])
    return tuple(zip(symbols, fixed_matrix(equations, table, values), strict=True))

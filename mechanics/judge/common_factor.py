"""Where an equation of motion says nothing: a factor of all its terms is zero, or a case holds nil.

    u (theta'' - a) = 0                  says    theta'' = a    except where u = 0
    theta'' - a if theta > 0 else 0      says    theta'' = a    where theta > 0

It counts as a divisor of what the equation says, as in ``(theta'' - a)/u = 0``.
"""

from collections.abc import Collection, Iterator
from functools import lru_cache

from sympy import (
    Abs,
    Add,
    Dummy,
    Expr,
    Function,
    Mod,
    Mul,
    Number,
    NumberSymbol,
    Piecewise,
    Pow,
    S,
    Symbol,
    degree,
    factor_list,
    factor_terms,
)
from sympy.matrices import MatrixBase

from mechanics.claims.demands import Demand
from mechanics.claims.statement import Statement
from mechanics.equations import Equations
from mechanics.errors import ExpressionError
from mechanics.kernel.field import Inadmissible
from mechanics.scene.quantities import EquationOfMotion
from mechanics.symbolic import Arithmetic, slope


def demands_of_factors(truth: Equations, statement: Statement) -> tuple[Demand, ...]:
    """What an equation of motion asks for to say something of accelerations."""
    row = statement.row
    if row is None or not isinstance(row.quantity, EquationOfMotion):
        return ()
    if len(row.sides) != 2 or any(isinstance(side, MatrixBase) for side in row.sides):
        return ()
    difference = row.sides[0] - row.sides[1]
    divisors = _all_divisors(difference, frozenset(truth.scene.ud))
    return tuple(Demand("divide", (S.One, divisor)) for divisor in divisors)


@lru_cache(maxsize=64)
def _all_divisors(difference: Expr, moving: frozenset[Symbol]) -> tuple[Expr, ...]:
    """Of one statement several questions ask."""
    return tuple(_divisors(difference, moving))


def _divisors(difference: Expr, moving: Collection[Symbol]) -> Iterator[Expr]:
    """What has to be other than zero for a difference to hold accelerations."""
    if isinstance(difference, Piecewise):
        says = [(S.One if e.free_symbols & {*moving} else S.Zero, c) for e, c in difference.args]
        if S.Zero in [value for value, _ in says]:
            yield Piecewise(*says, (S.Zero, True))
        return
    known: dict[Expr, frozenset[Expr]] = {}
    candidates = _candidates(difference, known)
    if len(known) <= MOST_PARTS:
        yield from _multiplied_out(difference, moving)
    if len(candidates) < 2 and not any(isinstance(one, Piecewise) for one in candidates):
        return
    factors = [f.as_base_exp() for f in Mul.make_args(factor_terms(difference))]
    moves = [base for base, _ in factors if base.free_symbols & {*moving}]
    if len(moves) != 1:
        return
    for base, exponent in factors:
        if exponent.is_positive and base.free_symbols and base not in moves:
            yield base
    if isinstance(moves[0], Piecewise):
        yield from _divisors(moves[0], moving)


MOST_PARTS = 400
"""Of a difference up to which a factor is looked for that was multiplied out."""


def _multiplied_out(difference: Expr, moving: Collection[Symbol]) -> Iterator[Expr]:
    """Factors that nothing shows: ``theta theta'' - theta'' - (theta - 1) a``.

    Each is one of the shortest slope, and where it is zero so is the difference.
    """
    slopes = [d for one in sorted(moving, key=str) if (d := slope(difference, one)) != 0]
    if not slopes or any(d.free_symbols & {*moving} for d in slopes):
        return
    functions = sorted(difference.atoms(Function), key=lambda f: (-f.count_ops(), str(f)))
    plain = {f: Dummy() for f in functions}
    back = {letter: f for f, letter in plain.items()}
    shortest = min((d.xreplace(plain) for d in slopes), key=lambda d: d.count_ops())
    whole = difference.xreplace(plain)
    if difference.has(Piecewise, Abs, Mod) or not shortest.is_polynomial(*shortest.free_symbols):
        return
    for found, _ in factor_list(shortest)[1]:
        if len(found.free_symbols) == 1 and found.is_Symbol:
            continue  # it stands in each term, and is seen there
        for letter in sorted(found.free_symbols, key=str):
            if degree(found, letter) == 1:
                root = -found.subs(letter, 0) / found.diff(letter)
                if _is_zero(whole.xreplace({letter: root})):
                    yield found.xreplace(back)
                break


def _is_zero(expression: Expr) -> bool:
    a = Arithmetic()
    try:
        return a.is_zero(a.value(expression))
    except (Inadmissible, ExpressionError):
        return False


def _candidates(expression: Expr, known: dict[Expr, frozenset[Expr]]) -> frozenset[Expr]:
    """What a product may have as factors, shared parts looked at once; SymPy takes long for it."""
    if expression not in known:
        known[expression] = _found(expression, known)
    return known[expression]


def _found(expression: Expr, known: dict[Expr, frozenset[Expr]]) -> frozenset[Expr]:
    if isinstance(expression, Mul):
        return frozenset().union(*(_candidates(part, known) for part in expression.args))
    if isinstance(expression, Add):
        first, *others = (_candidates(part, known) for part in expression.args)
        common = first.intersection(*others)
        return common | {expression}
    if isinstance(expression, Pow):
        return _candidates(expression.base, known)
    return frozenset() if isinstance(expression, Number | NumberSymbol) else frozenset({expression})

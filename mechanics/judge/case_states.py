"""States that enter a case whose conditions are not solved for a symbol: by trying.

sin(theta) > 0.999        theta = 403/256 is one of them

Of those that are drawn the nearest is moved by ever smaller steps: uphill on the least margin.
"""

import random
from collections.abc import Iterator
from fractions import Fraction

from sympy import Expr, Piecewise, Rational, S, Symbol
from sympy.core.relational import Ge, Gt, Le, Lt, Relational
from sympy.logic.boolalg import And

from mechanics.errors import ExpressionError
from mechanics.symbolic.decimals import Formulas, formulas

Region = dict[Symbol, Expr]

DRAWN, MOVED, MOST = 1500, 400, 2
SCALES = (1, 1, 4, 32)
LEAST_SCALE, LARGEST_SCALE = -48, 40
"""Powers of two that every fifth state is drawn from instead."""
HALVED = 16
"""Steps of one size, each half as large as those before."""
BITS = 96


def entered(conditions: tuple[Relational, ...]) -> Iterator[Region]:
    """Some values of the symbols of conditions where these hold, beyond doubt."""
    both = And(*conditions, evaluate=False)
    symbols = sorted(both.free_symbols, key=str)
    truth = Piecewise((S.One, both), (S.Zero, True))
    margins = [c.gts - c.lts for c in conditions if isinstance(c, Gt | Ge | Lt | Le)]
    try:
        program = formulas([truth, *margins])
    except (ExpressionError, ZeroDivisionError):
        return
    source, found = random.Random(0), 0
    nearest, least = Region(), -float("inf")
    for k in range(DRAWN + MOVED):
        if k < DRAWN:
            wide = Rational(2) ** (LEAST_SCALE + k // 5 * 7 % (LARGEST_SCALE - LEAST_SCALE + 1))
            scale = wide if k % 5 == 4 else SCALES[k % len(SCALES)]
            values = {symbol: _drawn(symbol, source, scale) for symbol in symbols}
        elif nearest:
            values = _moved(nearest, source, (k - DRAWN) // HALVED)
        else:
            return
        held, margin = _at(values, program)
        if margin > least:
            nearest, least = values, margin
        if held:
            yield values
            found += 1
        if found == MOST:
            return


def _at(values: Region, program: Formulas) -> tuple[bool, float]:
    """Whether conditions hold beyond doubt, and the least of their margins, about."""
    numbers = {s: Fraction(int(v.p), int(v.q)) for s, v in values.items()}
    truth, *margins = program.at(numbers, BITS)
    return truth == 1, min((float(margin.mid()) for margin in margins), default=0.0)


def _moved(values: Region, source: random.Random, halvings: int) -> Region:
    """Values a step away; what is positive stays so."""
    there: Region = {}
    for symbol, value in values.items():
        step = Rational(source.randrange(-1024, 1025), 1024 * 2**halvings)
        there[symbol] = value + step if value + step > 0 or not symbol.is_nonnegative else value
    return there


def _drawn(symbol: Symbol, source: random.Random, scale: Rational | int) -> Rational:
    size = Rational(source.randrange(1, 1024) * scale, 256)
    return size if symbol.is_nonnegative or source.random() < 0.5 else -size

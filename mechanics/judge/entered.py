"""States that enter a case whose conditions are not solved for a symbol: by trying.

sin(theta) > 0.999        theta = 403/256 is one of them
"""

import random
from collections.abc import Iterator
from fractions import Fraction

from sympy import Expr, Piecewise, Rational, S, Symbol
from sympy.core.relational import Relational
from sympy.logic.boolalg import And

from mechanics.errors import ExpressionError
from mechanics.exact.balls import BallArithmetic, State, precision

Region = dict[Symbol, Expr]

DRAWN, MOST = 1500, 2
SCALES = (1, 1, 4, 32)
BITS = 96


def entered(conditions: tuple[Relational, ...]) -> Iterator[Region]:
    """Some values of the symbols of conditions where these hold, beyond doubt."""
    both = And(*conditions, evaluate=False)
    symbols = sorted(both.free_symbols, key=str)
    truth = Piecewise((S.One, both), (S.Zero, True))
    source, found = random.Random(0), 0
    for k in range(DRAWN):
        values = {symbol: _drawn(symbol, source, SCALES[k % len(SCALES)]) for symbol in symbols}
        try:
            with precision(BITS):
                numbers = {s: Fraction(int(v.p), int(v.q)) for s, v in values.items()}
                held = BallArithmetic(State(numbers)).value(truth).arb
        except (ExpressionError, ArithmeticError):
            continue
        if held == 1:
            yield values
            found += 1
        if found == MOST:
            return


def _drawn(symbol: Symbol, source: random.Random, scale: int) -> Rational:
    size = Rational(source.randrange(1, 1024) * scale, 256)
    return size if symbol.is_nonnegative or source.random() < 0.5 else -size

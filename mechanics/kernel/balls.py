"""Balls: a program's values at one real state, enclosed.

A ball [m - r, m + r] contains the true value; disjoint balls prove that two values differ. What is
undefined at the state (a negative radicand, a division by zero, a comparison that cannot be told)
becomes a ball that is not finite.

Johansson, Arb: Efficient arbitrary-precision midpoint-radius interval arithmetic, IEEE Trans.
Computers 66 (2017) 1281-1292.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from fractions import Fraction
from typing import Any

from flint import arb, arb_mat, ctx, fmpq

from mechanics.program import Program, interpret

ARB_FUNCTIONS = (
    "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh",
    "asinh", "acosh", "atanh", "erf", "floor",
)  # fmt: skip
"""Operations that Arb has under the same name."""

PRECISIONS = (64, 128, 256, 512, 1024, 2048)


@contextmanager
def precision(bits: int) -> Iterator[None]:
    """Work with `bits` binary digits; Arb keeps the precision in a global."""
    before = ctx.prec
    ctx.prec = bits
    try:
        yield
    finally:
        ctx.prec = before


def ball(value: Fraction | int) -> arb:
    """The enclosure of a rational."""
    ratio = Fraction(value)
    return arb(fmpq(ratio.numerator, ratio.denominator))


def _truth(yes: bool, no: bool) -> arb:
    """1 or 0, or no finite ball where the comparison cannot be told."""
    return arb(1) if yes else arb(0) if no else arb.nan()


def _equal(x: arb, y: arb) -> arb:
    difference = x - y
    return _truth(bool(difference.is_zero()), not difference.contains(0))


def _not(x: arb) -> arb:
    return _truth(bool(x.is_zero()), x.is_finite() and not x.contains(0))


def _both(x: arb, y: arb) -> arb:
    return _truth(not x.contains(0) and not y.contains(0), bool(x.is_zero() or y.is_zero()))


def _select(condition: arb, x: arb, y: arb) -> arb:
    if condition.is_zero():
        return y
    return x if condition.is_finite() and not condition.contains(0) else arb.nan()


def _of_finite(function: Callable[..., arb]) -> Callable[..., arb]:
    """What has no value stays without one: Arb encloses sin(inf) by [-1, 1]."""

    def of_finite(*operands: arb) -> arb:
        if all(operand.is_finite() for operand in operands):
            return function(*operands)
        return arb.nan()

    return of_finite


class Balls:
    """The domain of Arb balls, at the precision that is set when it is used."""

    operations: Mapping[str, Callable[..., arb]] = {
        "add": arb.__add__, "subtract": arb.__sub__, "multiply": arb.__mul__,
        "divide": _of_finite(arb.__truediv__), "negate": arb.__neg__,
        "sqrt": arb.sqrt, "power": _of_finite(arb.__pow__),
        "abs": arb.__abs__, "sign": _of_finite(arb.sgn),
        **{name: _of_finite(getattr(arb, name)) for name in ARB_FUNCTIONS},
        "less": lambda x, y: _truth(x < y, x >= y),
        "not_greater": lambda x, y: _truth(x <= y, x > y),
        "equal": _equal, "and": _both, "not": _not,
        "or": lambda x, y: _not(_both(_not(x), _not(y))),
        "select": _select,
    }  # fmt: skip

    def constant(self, value: Fraction) -> arb:
        """The enclosure of a rational."""
        return ball(value)

    def pi(self) -> arb:
        """The enclosure of pi."""
        return arb.pi()

    def solve(
        self, matrix: Sequence[Sequence[arb]], right: Sequence[arb], symmetric: bool
    ) -> Sequence[arb]:
        """The solution by Arb's certified elimination; not finite where it finds no pivot."""
        try:
            solution = arb_mat([list(row) for row in matrix]).solve(
                arb_mat([[side] for side in right])
            )
        except ZeroDivisionError:
            return [arb.nan()] * len(right)
        entries: list[arb] = solution.entries()
        return entries


def enclose(
    program: Program, state: Mapping[str, Fraction | int | arb], bits: int = 128
) -> dict[str, tuple[arb, ...]]:
    """Enclosures of a program's outputs at a state.

    Parameters
    ----------
    program : Program
    state : mapping of str to Fraction, int or arb
        A value for every input.
    bits : int
        Working precision.

    Returns
    -------
    dict of str to tuple of flint.arb
        Not finite where an output has no value, or none that can be told at this precision.
    """
    with precision(bits):
        values: dict[str, Any] = {
            name: value if isinstance(value, arb) else ball(value) for name, value in state.items()
        }
        return interpret(program, Balls(), values)

"""Whether an expression with cases is zero on thin sets only: by the product over all its cases.

    N = prod_sigma f_sigma        sqrt x -> sigma sqrt x,  |x| -> sigma x,  c ? x : y -> x or y

Where f is zero on an open set, one f_sigma is zero wherever it can be continued to, and so is N.
One state at which N is not zero shows that there is no such set: sqrt(x^2 + y^2) - x is zero on a
thin set, |x| - x is not.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import product
from typing import Any

from flint import acb, arb

from mechanics.errors import ExpressionError
from mechanics.kernel.balls import ball, precision
from mechanics.program import Program, interpret
from mechanics.program.operations import ABS, FLOOR, OPERATIONS, SELECT, SIGN, SQRT

MOST_CASES = 512
BITS = 128

ENTIRE = ("exp", "sin", "cos", "sinh", "cosh", "erf")


class Case:
    """The domain of complex balls in which every choice is made beforehand.

    Parameters
    ----------
    choices : iterator of int
        One for each operation that has cases, in the order of the program.
    """

    def __init__(self, choices: Iterator[int]) -> None:
        def chosen(*cases: acb) -> acb:
            return cases[next(choices)]

        self.operations: Mapping[str, Callable[..., acb]] = {
            "add": acb.__add__, "subtract": acb.__sub__, "multiply": acb.__mul__,
            "divide": acb.__truediv__, "negate": acb.__neg__,
            "sqrt": lambda x: chosen(acb.sqrt(x), -acb.sqrt(x)),
            "abs": lambda x: chosen(x, -x),
            "sign": lambda x: chosen(acb(1), acb(-1)),
            "select": lambda c, x, y: chosen(x, y),
            "tan": acb.tan, "tanh": acb.tanh,
            "power": _on_the_real_sheet(acb.pow, True), "log": _on_the_real_sheet(acb.log, True),
            "atan": _on_the_real_sheet(acb.atan), "asinh": _on_the_real_sheet(acb.asinh),
            **{name: getattr(acb, name) for name in ENTIRE},
            # What a choice is made by.
            **{row.name: lambda *operands: acb(0) for row in OPERATIONS if row.boolean},
        }  # fmt: skip

    def constant(self, value: Fraction) -> acb:
        """The enclosure of a rational."""
        return acb(ball(value))

    def pi(self) -> acb:
        """The enclosure of pi."""
        return acb.pi()


def _on_the_real_sheet(function: Callable[..., acb], positive: bool = False) -> Callable[..., acb]:
    """Analytic where it is real, with other sheets beyond; of what is positive, if that is said."""

    def apply(x: acb, *others: acb) -> acb:
        real = x.imag.is_zero() and (x.real > 0 or not positive)
        return function(x, *others) if real else _NOWHERE

    return apply


_NOWHERE = acb(arb.nan())
_CHOSEN = frozenset({SQRT, ABS, SIGN, SELECT})
_CASES = _CHOSEN | {FLOOR} | {row.code for row in OPERATIONS if row.boolean}


def has_cases(program: Program) -> bool:
    """Whether a program holds something else than analytic functions."""
    return not _CASES.isdisjoint(program.operations)


def is_thin(program: Program, output: str, states: Sequence[Mapping[str, Fraction | arb]]) -> bool:
    """Whether it is shown that an output is zero on a set without interior at most.

    Parameters
    ----------
    output : str
        Name of an output of one entry.
    states : sequence of mappings of str to Fraction or arb
        At which the product is tried.
    """
    counts = [2 for code in program.operations if code in _CHOSEN]
    if 2 ** len(counts) > MOST_CASES:
        return False
    with precision(BITS):
        return any(_all_nonzero(program, output, counts, state) for state in states)


def _all_nonzero(
    program: Program, output: str, counts: Sequence[int], state: Mapping[str, Fraction | arb]
) -> bool:
    inputs: dict[str, Any] = {
        name: acb(value if isinstance(value, arb) else ball(value)) for name, value in state.items()
    }
    for choices in product(*map(range, counts)):
        try:
            (value,) = interpret(program, Case(iter(choices)), inputs)[output]
        except (ExpressionError, ZeroDivisionError):
            return False
        if not value.is_finite() or value.contains(0):
            return False
    return True

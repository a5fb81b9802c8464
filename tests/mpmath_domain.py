"""Numbers of as many digits as mpmath is set to: another library than the kernel's."""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any, ClassVar

import mpmath

from mechanics.program import OPERATIONS

OWN: Mapping[str, Callable[..., Any]] = {
    "add": lambda x, y: x + y, "subtract": lambda x, y: x - y, "negate": lambda x: -x,
    "multiply": lambda x, y: x * y, "divide": lambda x, y: x / y, "abs": abs,
    "select": lambda c, x, y: x if c else y, "less": lambda x, y: x < y,
    "not_greater": lambda x, y: x <= y, "equal": lambda x, y: x == y, "not": lambda x: not x,
    "and": lambda x, y: bool(x and y), "or": lambda x, y: bool(x or y),
}  # fmt: skip
MPMATH = [row.name for row in OPERATIONS if row.arity and row.name not in {*OWN, "entry"}]


class MultiplePrecision:
    """The domain of mpmath's numbers."""

    operations: ClassVar = {name: getattr(mpmath, name) for name in MPMATH} | OWN

    def constant(self, value: Fraction) -> Any:
        return mpmath.mpf(value.numerator) / value.denominator

    def pi(self) -> Any:
        return +mpmath.pi

    def solve(self, matrix: list[list[Any]], right: list[Any], symmetric: bool) -> Sequence[Any]:
        return list(mpmath.lu_solve(mpmath.matrix(matrix), mpmath.matrix(right)))

"""Everything that a machine may compute: balls that grow by each rounding.

    fl(x op y) = (x op y) (1 + delta) + eta,    |delta| <= u,   |eta| <= half the smallest number

with u = 2^-53 or 2^-24: what C without contraction gives, and with it too (a fused operation has
one rounding instead of two). Functions of a library are taken to be within `LIBRARY` units in the
last place; the inline sine and cosine are shown to be. A value outside is not what the text says.
"""

from collections.abc import Callable, Mapping
from functools import cached_property
from typing import Any

from flint import arb

from mechanics.kernel.balls import Balls
from mechanics.program.operations import OPERATIONS

LIBRARY = 2
"""Units in the last place."""
DIGITS = {"double": 53, "float": 24}
SMALLEST = {"double": -1074, "float": -149}

ONCE = frozenset({"add", "subtract", "multiply", "divide"})
EXACT = frozenset({"negate", "abs", "sign", "select"})
EXACT |= {row.name for row in OPERATIONS if row.boolean}


class RoundedBalls(Balls):
    """The domain of balls that grow with every operation, at the precision that is set.

    Parameters
    ----------
    kind : ``"double"`` or ``"float"``
    """

    def __init__(self, kind: str) -> None:
        self._unit = arb(2) ** -DIGITS[kind]
        self._smallest = arb(2) ** (SMALLEST[kind] - 1)

    def grown(self, value: arb, units: int) -> arb:
        """A ball with what `units` roundings may add."""
        # What is zero for certain is a factor of zero or a difference of equals, which is exact.
        if value.is_zero():
            return value
        return value + arb(0, units * (abs(value).upper() * self._unit + self._smallest))

    @cached_property
    def operations(self) -> Mapping[str, Callable[..., arb]]:  # type: ignore[override]
        """Those of balls, rounded."""
        found: dict[str, Callable[..., arb]] = dict(Balls.operations)
        for name, exact in Balls.operations.items():
            if name not in EXACT:
                found[name] = self._rounded(exact, 1 if name in ONCE else 2 * LIBRARY)
        return found

    def _rounded(self, exact: Callable[..., arb], units: int) -> Callable[..., arb]:
        def rounded(*operands: Any) -> arb:
            return self.grown(exact(*operands), units)

        return rounded

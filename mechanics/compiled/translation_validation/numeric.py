"""Programs at many states at once, in the precision of the machine.

Used for what is discrete, statuses, and for how large the terms of a result are:

    S(x + y) = S(x) + S(y)        S(x y) = S(x) S(y)        S(x / y) = S(x) S(y) / y^2
    S(f(x)) = |f(x)| + |f'(x)| S(x) for computed x,         S(input) = |input|

A result of plain operations is off by a few roundings of S, whatever cancels.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from mechanics.compiled.c.sine import LIMIT
from mechanics.program.c.condition import Atom, Choice, Condition, Decision
from mechanics.program.numpy_domain import Arrays

Values = Sequence[NDArray[np.floating]]


def decided(
    decision: Decision, known: Values, places: Mapping[int, int], count: int
) -> NDArray[np.int64]:
    """What a decision comes to at each state.

    Parameters
    ----------
    known : sequence of array
        Operands of its conditions.
    places : mapping of int to int
        Where each operand stands among them.
    count : int
        Number of states.
    """
    if not isinstance(decision, Choice):
        return np.full(count, decision)
    holds = _holds(decision.condition, known, places, count)
    yes, no = (decided(side, known, places, count) for side in (decision.yes, decision.no))
    return np.where(holds, yes, no)


def _holds(
    condition: Condition, known: Values, places: Mapping[int, int], count: int
) -> NDArray[np.bool_]:
    if isinstance(condition, bool):
        return np.full(count, condition)
    if isinstance(condition, Atom):
        operands = [known[places[i]] for i in condition.operands]
        found = np.broadcast_to(_atom(condition, operands), count)
        return found if condition.holds else ~found
    parts = [_holds(part, known, places, count) for part in condition.parts]
    return np.all(parts, axis=0) if condition.both else np.any(parts, axis=0)


def _atom(atom: Atom, x: Values) -> Any:
    if atom.relation == "finite":
        return np.isfinite(x[0])
    if atom.relation == "far":
        return ~(np.abs(x[0]) <= LIMIT)
    return {"<": np.less, "<=": np.less_equal, "==": np.equal}[atom.relation](*x)


class Sized(NamedTuple):
    """Values, the sum of magnitudes of their terms, and whether they were computed at all."""

    value: Any
    size: Any
    computed: bool = True


@dataclass(frozen=True)
class Magnitudes:
    """The domain of values with the sums of the magnitudes of their terms.

    Attributes
    ----------
    precision : type
        Of the values; sums are doubles.
    """

    precision: type

    @cached_property
    def operations(self) -> Mapping[str, Callable[..., Sized]]:
        """NumPy's functions, and their sums."""
        known = Arrays(self.precision).operations
        return {name: self._sized(name, function) for name, function in known.items()}

    def _sized(self, name: str, function: Callable[..., Any]) -> Callable[..., Sized]:
        rule, slope = _SIZES.get(name), _SLOPES.get(name)

        def sized(*operands: Sized) -> Sized:
            value = function(*(operand.value for operand in operands))
            if rule is not None:
                return Sized(value, rule(*operands))
            size = np.abs(np.asarray(value, dtype=float))
            if slope is not None and operands[0].computed:
                size = size + np.abs(slope(operands[0].value)) * operands[0].size
            return Sized(value, size)

        return sized

    def constant(self, value: Fraction) -> Sized:
        """A number."""
        return self._leaf(Arrays(self.precision).constant(value))

    def pi(self) -> Sized:
        """The nearest number to pi."""
        return self._leaf(Arrays(self.precision).pi())

    def _leaf(self, value: Any) -> Sized:
        return Sized(value, np.abs(np.asarray(value, dtype=float)))

    def input(self, value: Any) -> Sized:
        """An input, which is exact."""
        return Sized(value, np.abs(np.asarray(value, dtype=float)), False)


_SIZES: Mapping[str, Callable[..., Any]] = {
    "add": lambda x, y: x.size + y.size,
    "subtract": lambda x, y: x.size + y.size,
    "multiply": lambda x, y: x.size * y.size,
    "divide": lambda x, y: x.size / np.abs(y.value) * (y.size / np.abs(y.value)),
    "negate": lambda x: x.size,
    "abs": lambda x: x.size,
}
_SLOPES: Mapping[str, Callable[..., Any]] = {
    "sin": np.cos, "cos": np.sin, "exp": np.exp,
    "tan": lambda x: 1 / np.cos(x) ** 2, "sqrt": lambda x: 0.5 / np.sqrt(x),
    "atan": lambda x: 1 / (1 + x * x), "tanh": lambda x: 1 / np.cosh(x) ** 2,
    "log": lambda x: 1 / x,
}  # fmt: skip

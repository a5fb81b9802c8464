"""Programs on NumPy arrays, in any of NumPy's precisions."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from mechanics.program.operations import OPERATIONS


@dataclass(frozen=True)
class Arrays:
    """The domain of arrays of one precision; inputs of equal shape, elementwise.

    Attributes
    ----------
    precision : type
        ``numpy.float64``, ``numpy.float32`` or ``numpy.longdouble``.
    """

    precision: type = np.float64

    @cached_property
    def operations(self) -> Mapping[str, Callable[..., Any]]:
        """NumPy's functions by the names of the table; truth values become 0 and 1."""
        return {row.name: self._function(row.numpy, row.boolean) for row in OPERATIONS
                if row.arity and row.numpy} | {"erf": self._erf}  # fmt: skip

    def _function(self, name: str, boolean: bool) -> Callable[..., Any]:
        function = getattr(np, name)
        if boolean:
            return lambda *operands: self.precision(1) * function(*operands)
        if name == "where":
            return lambda condition, x, y: np.where(condition != 0, x, y)
        return function

    def _erf(self, x: Any) -> Any:
        """SciPy has it in double precision only, and takes a quarter of a second to import."""
        from scipy.special import erf

        return self.precision(1) * erf(np.asarray(x, dtype=np.float64))

    def constant(self, value: Fraction) -> Any:
        """The nearest number of the precision, by one division where that is exact enough."""
        if self.precision is np.longdouble:
            return self.precision(value.numerator) / self.precision(value.denominator)
        return self.precision(float(value))

    def pi(self) -> Any:
        """The nearest number to pi."""
        return self.precision("3.14159265358979323846264338327950288")

    def solve(self, matrix: list[list[Any]], right: list[Any], symmetric: bool) -> Sequence[Any]:
        """Solutions for a batch, by NumPy's solver in double precision."""
        entries = [entry for row in matrix for entry in row]
        shape = np.broadcast_shapes(*(np.shape(entry) for entry in (*entries, *right)))
        size = len(right)
        stack = [np.broadcast_to(entry, shape) for entry in entries]
        left = np.stack(stack, axis=-1).reshape((*shape, size, size)).astype(np.float64)
        side = np.stack([np.broadcast_to(entry, shape) for entry in right], axis=-1)
        solution = np.linalg.solve(left, side.astype(np.float64)[..., None])[..., 0]
        return [solution[..., i].astype(self.precision) for i in range(size)]

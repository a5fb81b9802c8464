"""Programs on JAX's arrays: the functions of the table's NumPy column, as ``jax.numpy`` has them.

What is computed can be compiled (``jit``), differentiated (``grad``) and mapped (``vmap``).
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from importlib import import_module
from math import pi
from types import ModuleType
from typing import Any

from mechanics.errors import InputError
from mechanics.program.operations import OPERATIONS


@dataclass(frozen=True)
class JaxArrays:
    """The domain of JAX's arrays; their precision is that of the inputs.

    Attributes
    ----------
    numpy : module
        ``jax.numpy``.
    erf : callable
        ``jax.scipy.special.erf``.
    """

    numpy: ModuleType
    erf: Callable[..., Any]

    @property
    def operations(self) -> Mapping[str, Callable[..., Any]]:
        """JAX's functions by the names of the table; truth values become 0 and 1."""
        return {row.name: self._function(row.numpy, row.boolean) for row in OPERATIONS
                if row.arity and row.numpy} | {"erf": self.erf}  # fmt: skip

    def _function(self, name: str, boolean: bool) -> Callable[..., Any]:
        function = getattr(self.numpy, name)
        if boolean:
            return lambda *operands: 1.0 * function(*operands)
        if name == "where":
            return lambda condition, x, y: self.numpy.where(condition != 0, x, y)
        return function

    def constant(self, value: Fraction) -> float:
        """The nearest double; JAX rounds it to the precision of what it meets."""
        return float(value)

    def pi(self) -> float:
        """The nearest double to pi."""
        return pi

    def solve(self, matrix: list[list[Any]], right: list[Any], symmetric: bool) -> Sequence[Any]:
        """The solution, by JAX's solver."""
        rows = self.numpy.stack([self.numpy.stack(row) for row in matrix])
        return self.numpy.linalg.solve(rows, self.numpy.stack(right))


def jax_arrays() -> JaxArrays:
    """The domain.

    Raises
    ------
    InputError
        Where JAX is not installed.
    """
    try:
        return JaxArrays(import_module("jax.numpy"), import_module("jax.scipy.special").erf)
    except ImportError:
        raise InputError("JAX is not installed: pip install 'mechanics[jax]'") from None

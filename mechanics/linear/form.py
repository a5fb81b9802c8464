"""Linear equations of motion about an equilibrium, in deviations x of independent coordinates.

M x'' + C x' + K x = E(w),    E(w) = E_0 w + E_1 w' + E_2 w'' + ...
q - q_0 = G x
"""

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Expr, Matrix, Symbol, zeros

from mechanics.errors import InputError
from mechanics.linear.algebra import is_zero
from mechanics.scene import Scene


@dataclass(frozen=True, eq=False)
class Linear:
    """Linearized equations of motion; rows as the route wrote them.

    Attributes
    ----------
    scene : Scene
    route : str
        The route that derived the nonlinear equations.
    point : mapping of Symbol to Expr
        The equilibrium: a value for every coordinate and input.
    coordinates : tuple of Symbol
        The independent coordinates whose deviations are x, n of them.
    inputs : tuple of Symbol
        Their deviations are w, p of them.
    mass, damping, stiffness : Matrix
        M, C and K, n x n.
    input_matrices : tuple of Matrix
        E_0, E_1, ..., n x p each: one for every order of derivative of the inputs.
    reach : Matrix
        G, (number of all coordinates) x n.
    conjugate : bool
        Whether the rows are power-conjugate to x', so that M and K are the second derivatives of
        kinetic and potential energy.
    """

    scene: Scene
    route: str
    point: Mapping[Symbol, Expr]
    coordinates: tuple[Symbol, ...]
    inputs: tuple[Symbol, ...]
    mass: Matrix
    damping: Matrix
    stiffness: Matrix
    input_matrices: tuple[Matrix, ...]
    reach: Matrix
    conjugate: bool

    def dynamic_stiffness(self, s: Expr) -> Matrix:
        """D(s) = M s^2 + C s + K, n x n."""
        return self.mass * s**2 + self.damping * s + self.stiffness

    def input_polynomial(self, s: Expr) -> Matrix:
        """E(s) = E_0 + E_1 s + E_2 s^2 + ..., n x p."""
        total = zeros(len(self.coordinates), len(self.inputs))
        for order, matrix in enumerate(self.input_matrices):
            total += matrix * s**order
        return total

    @property
    def undamped(self) -> bool:
        """Whether C = 0."""
        return all(is_zero(entry) for entry in self.damping)

    @property
    def state_symbols(self) -> tuple[Symbol, ...]:
        """(x, x') as plain symbols."""
        rates = dict(zip(self.scene.q, self.scene.qd, strict=True))
        return (*self.coordinates, *(rates[q] for q in self.coordinates))

    def coordinate_index(self, name: str) -> int:
        """Place of a coordinate among `coordinates`."""
        return _index("coordinate", name, self.coordinates, self)

    def input_index(self, name: str) -> int:
        """Place of an input among `inputs`."""
        return _index("input", name, self.inputs, self)


def _index(kind: str, name: str, symbols: tuple[Symbol, ...], linear: Linear) -> int:
    names = [symbol.name for symbol in symbols]
    if name not in names:
        raise InputError(
            f"{linear.scene.name}: {name!r} is no {kind} of the linear equations:"
            f" there are {', '.join(names) or 'none'}"
        )
    return names.index(name)

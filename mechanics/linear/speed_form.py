"""Cyclic coordinates taken out by their momenta, and the form of a bicycle in its forward speed.

    M_11 x'' + M_12 z'' + C_11 x' + C_12 z' + K x = 0                                        (1)
    M_21 x'' + M_22 z'' + C_21 x' = 0:   z' = -M_22^-1 (M_21 x' + C_21 x)    momenta kept    (2)
    M x'' + v C_1 x' + (g K_0 + v^2 K_2) x = 0                                               (3)

(2) in (1) is Routh's reduction, to first order; (3) is equation (5.3) of Meijaard, Papadopoulos,
Ruina and Schwab, Linearized dynamics equations for the balance and steer of a bicycle, Proceedings
of the Royal Society A 463, 2007.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from sympy import Integer, Matrix

from mechanics.errors import InputError
from mechanics.kernel import Finding, Range, Statement, decide
from mechanics.linear.first_order import Array
from mechanics.linear.form import Linear, matrix_of
from mechanics.linear.nodes import Rows, difference, inverse, product
from mechanics.linear.operating_point import Place
from mechanics.linear.values import Numbers, evaluate
from mechanics.program import Builder, Program
from mechanics.program.interpret import include
from mechanics.symbolic.arithmetic import range_of

NAMES = ("M", "C1", "K0", "K2")


@dataclass(frozen=True, eq=False, repr=False)
class SpeedForm:
    """Equation (3), shown by the kernel to be the linear equations for all v and g.

    Attributes
    ----------
    linear : Linear
    finding : Finding
        Which shows it.
    program : Program
        Its outputs ``"M"``, ``"C1"``, ``"K0"``, ``"K2"``, each n x n, row by row.
    """

    linear: Linear
    finding: Finding
    program: Program

    def __repr__(self) -> str:
        return f"<M x'' + v C1 x' + (g K0 + v^2 K2) x = 0 of {self.linear.scene.name}>"

    @cached_property
    def M(self) -> Matrix:
        """M, n x n, in kg m^2."""
        return self._matrix("M")

    @cached_property
    def C1(self) -> Matrix:
        """C_1, n x n, in kg m."""
        return self._matrix("C1")

    @cached_property
    def K0(self) -> Matrix:
        """K_0, n x n, in kg m."""
        return self._matrix("K0")

    @cached_property
    def K2(self) -> Matrix:
        """K_2, n x n, in kg."""
        return self._matrix("K2")

    def _matrix(self, name: str) -> Matrix:
        return matrix_of(self.program, name, self.linear.names, self._size)

    @property
    def _size(self) -> int:
        return len(self.linear.coordinates) - len(self.linear.cyclic)

    def numbers(self, values: Numbers | None = None) -> tuple[Array, Array, Array, Array]:
        """(M, C_1, K_0, K_2), each entry the double nearest to the exact one.

        Raises
        ------
        ValueMissingError
            If a parameter has neither a value nor a typical one.
        """
        found = evaluate(self.linear.scene, self.program, self.linear.names, values, NAMES)
        n = self._size
        one, two, three, four = (np.array(found[name]).reshape(n, n) for name in NAMES)
        return one, two, three, four


def speed_form(linear: Linear, speed: str, gravity: str = "g") -> SpeedForm:
    """The linear equations as a polynomial in a speed and in gravity, equation (3).

    Parameters
    ----------
    linear : Linear
        By a route with power-conjugate rows.
    speed, gravity : str
        Names of the symbols v and g in the linear equations.

    Raises
    ------
    InputError
        If they are not of that form.
    """
    builder = Builder()
    mass, damping, stiffness = routh(linear, builder)

    def put(matrix: Rows, v: int, g: int) -> Rows:
        values = {speed: Integer(v), gravity: Integer(g)}
        return Place(builder, values, builder).matrix(matrix)

    v, g = (builder.input(name) for name in (speed, gravity))
    inertia, rolling, fast = put(mass, 1, 0), put(damping, 1, 0), put(stiffness, 1, 0)
    heavy = difference(put(stiffness, 1, 1), fast)
    left = [entry for matrix in (mass, damping, stiffness) for row in matrix for entry in row]
    right = [entry for row in inertia for entry in row]
    right += [v * entry for row in rolling for entry in row]
    right += [
        g * one + v * v * two
        for rows in zip(heavy, fast, strict=True)
        for one, two in zip(*rows, strict=True)
    ]
    program = builder.program({"left": left, "right": right})
    finding = decide(Statement("the form in v and g", program, signs_of(linear, program)))
    if not finding.shown:
        raise InputError(
            f"{linear.scene.name}: the linear equations are not of the form M x'' + {speed} C1 x' +"
            f" ({gravity} K0 + {speed}^2 K2) x = 0: {finding.evidence}"
        )
    parts = dict(zip(NAMES, (inertia, rolling, heavy, fast), strict=True))
    flat = {name: [entry for row in matrix for entry in row] for name, matrix in parts.items()}
    return SpeedForm(linear, finding, builder.program(flat))


def routh(linear: Linear, builder: Builder) -> tuple[Rows, Rows, Rows]:
    """M, C and K of x alone, equation (2) put into (1), as nodes of a builder.

    Raises
    ------
    InputError
        If rows are not conjugate, or the momentum of a cyclic coordinate is not kept.
    """
    n = len(linear.coordinates)
    kept, rest = slice(n - len(linear.cyclic)), slice(n - len(linear.cyclic), n)
    nodes = include(builder, linear.program)
    M, C, K = (
        [list(nodes[name][n * i : n * (i + 1)]) for i in range(n)]
        for name in ("mass", "damping", "stiffness")
    )
    if not linear.conjugate:
        raise InputError(
            f"{linear.scene.name}: rows by {linear.route} are no momenta: use lagrange or kane"
        )

    def block(matrix: Rows, rows: slice, columns: slice) -> Rows:
        return [row[columns] for row in matrix[rows]]

    if not _vanish(linear, builder, [*block(C, rest, rest), *block(K, rest, kept)]):
        names = ", ".join(map(str, linear.cyclic))
        raise InputError(
            f"{linear.scene.name}: the momenta of {names} are not kept: something acts on them"
        )
    mass, damping, stiffness = (block(matrix, kept, kept) for matrix in (M, C, K))
    if not linear.cyclic:
        return mass, damping, stiffness
    turn = inverse(builder, block(M, rest, rest))
    by_rates = product(turn, block(M, rest, kept))
    by_place = product(turn, block(C, rest, kept))
    inward, across = block(M, kept, rest), block(C, kept, rest)
    mass = difference(mass, product(inward, by_rates))
    damping = difference(damping, product(inward, by_place))
    damping = difference(damping, product(across, by_rates))
    return mass, damping, difference(stiffness, product(across, by_place))


def _vanish(linear: Linear, builder: Builder, matrix: Rows) -> bool:
    entries = [entry for row in matrix for entry in row if not entry.is_zero]
    if not entries:
        return True
    program = builder.program({"left": entries, "right": [0] * len(entries)})
    return decide(Statement("momenta are kept", program, signs_of(linear, program))).shown


def signs_of(linear: Linear, program: Program) -> dict[str, Range]:
    """What is known of the inputs of a program made of linear equations."""
    known = [name for name in program.inputs if name in linear.names]
    return {name: range_of(linear.names[name]) for name in known}

"""Rows about the linear equations of a steady motion as a polynomial in its speed.

M x'' + v C_1 x' + (g K_0 + v^2 K_2) x = 0

They need no formulas: programs are compared, so that they are checked of scenes of any size.
"""

from collections.abc import Callable

from mechanics.errors import InputError
from mechanics.kernel import Finding, Statement, decide
from mechanics.linear.case import Case, require_conjugate
from mechanics.linear.speed_form import NAMES, signs_of, speed_form
from mechanics.program import Builder, Node
from mechanics.program.interpret import include
from mechanics.program.sympy_reader import read
from mechanics.scene.linear_quantities import LinearQuantity, SpeedMatrix
from mechanics.scene.symbols import entries


def speed_matrix(case: Case) -> Finding:
    """Every typed matrix against the derived one, entry by entry."""
    quantity: SpeedMatrix = case.quantity
    if quantity.matrix not in NAMES:
        raise InputError(f"{case.subject}: no matrix {quantity.matrix!r}: there are {NAMES}")
    require_conjugate(case.linear)
    form = speed_form(case.linear, quantity.speed, quantity.gravity)
    builder = Builder()
    derived = include(builder, form.program)[quantity.matrix]
    typed, sides = list[Node](), case.forms()
    for side in sides:
        nodes = read(builder, entries(side))
        if len(nodes) != len(derived):
            raise InputError(f"{case.subject}: {len(nodes)} entries typed, {len(derived)} derived")
        typed += nodes
    program = builder.program({"left": typed, "right": [*derived] * len(sides)})
    return decide(Statement(case.subject, program, signs_of(case.linear, program)))


CHECKS: dict[type[LinearQuantity], Callable[[Case], Finding]] = {SpeedMatrix: speed_matrix}

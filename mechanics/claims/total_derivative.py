r"""The derivative of a name by a coordinate with an upright d.

v dv/dx = v'      dT/dx = T'/x'      along the motion, of one freedom
dL/dx, dV/dx                          partial: L of what is independent, V of x alone

Who writes d for a partial derivative means another value where the name moves with more than the
coordinate; which one is meant is told by what the name is, or is refused.
"""

from collections.abc import Callable
from typing import Any

from sympy import Expr
from sympy.matrices import MatrixBase

from mechanics.claims.about import ENERGY_NAMES
from mechanics.claims.names import Naming
from mechanics.claims.place import Refused
from mechanics.claims.tree import Name, Total
from mechanics.scene.symbols import TIME

UNCLEAR = (
    "d{of}/d{by} may be taken along the motion or at a given speed: write \\partial, or a"
    " derivative by time"
)


def total_derivative(
    naming: Naming, node: Total, value: Any, by: Any, rate: Callable[[Any], Any]
) -> Any:
    """The value of a derivative along the motion; None where it is a partial one.

    Parameters
    ----------
    value, by : expression
        Of the name above, and of the one below.
    rate : callable
        Gives the time derivative of an expression.

    Raises
    ------
    Refused
        Where both are meant by people, and differ.
    """
    scene = naming.vocabulary.scene
    moving = {*scene.q, *scene.qd, *scene.u, TIME}
    if isinstance(value, MatrixBase) or not isinstance(by, Expr) or by not in scene.q:
        return None
    if not (value.free_symbols & moving) - {by}:
        return None
    of, below = node.arguments
    name = of.name if isinstance(of, Name) else ""
    quantity = ENERGY_NAMES.get(name)
    if quantity == "Lagrangian" or (quantity is not None and len(scene.q) > 1):
        return None  # of several freedoms there is no derivative along the motion
    if quantity is not None or len(scene.q) > 1:
        told = below.name if isinstance(below, Name) else str(by)
        raise Refused(node.at, UNCLEAR.format(of=name, by=told))
    return rate(value) / rate(by)

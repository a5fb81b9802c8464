"""Cartesian coordinates of bodies by names of the author's own, which a text may never use again.

x = L sin(phi)    y = -L cos(phi)    dx = der(x)
"""

from collections.abc import Iterator

from sympy import Expr
from sympy.matrices import MatrixBase

from mechanics.scene import Scene
from mechanics.scene.rates import rate_table
from mechanics.symbolic import is_zero, operations

LARGEST = 60
"""Operations of an expression that is compared."""


def body_at(scene: Scene, value: Expr | MatrixBase) -> str:
    """The body of whose centre a value is a coordinate or its rate, up to its sign and a constant.

    Empty where it is that of none.
    """
    if isinstance(value, MatrixBase) or operations(value) > LARGEST:
        return ""
    moving = {*scene.q, *scene.u}
    if not value.free_symbols & moving or value.free_symbols & {*scene.ud}:
        return ""
    for name, component in _components(scene):
        for other in (component, -component):
            if all(is_zero((value - other).diff(symbol)) for symbol in moving):
                return name
    return ""


def _components(scene: Scene) -> Iterator[tuple[str, Expr]]:
    """Coordinates of the centres of all bodies, and their rates."""
    table = rate_table(scene)
    for body in scene.bodies:
        for component in scene.position(body.centre):
            if component.free_symbols & {*scene.q}:
                yield body.name, component
                yield body.name, sum(component.diff(q) * table[q] for q in scene.q)

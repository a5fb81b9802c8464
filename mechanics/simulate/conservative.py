"""Whether total energy has to stay as it is.

It does when nothing but conservative loads and ideal, scleronomic constraints act: no damper, no
applied force or torque that is not zero, and nothing that is moved by a given function of time.
"""

from collections.abc import Mapping
from typing import Any

from sympy import Expr, Symbol

from mechanics.scene import Force, Scene, Torque
from mechanics.scene.loads import CONSERVATIVE, Load
from mechanics.scene.potential import potential
from mechanics.scene.rates import TIME
from mechanics.scene.symbols import DOTS


def conservative(scene: Scene, inputs: Mapping[str, Any]) -> bool:
    """Whether energy is conserved with these inputs; those that are not given are zero."""
    moving = {TIME}
    absent: dict[Symbol, int] = {}
    for symbol in scene.input_symbols:
        family = [Symbol(symbol.name + dots, real=True) for dots in DOTS]
        given = inputs.get(symbol.name, 0)
        if callable(given):
            moving |= set(family)
        elif given == 0:
            absent |= dict.fromkeys(family, 0)
    if any(_works(scene, load, absent) for load in scene.loads):
        return False
    at_rest = {**absent, **dict.fromkeys(scene.u, 0)}
    for constraint in scene.constraints:
        plain = scene.plain(constraint.expression, constraint.name)
        # A constraint that is not met at rest drives the motion, as a conveyor belt does.
        if not constraint.holonomic and plain.xreplace(at_rest) != 0:
            return False
        if plain.free_symbols & moving:
            return False
    return not _symbols(scene) & moving


def _works(scene: Scene, load: Load, absent: Mapping[Symbol, int]) -> bool:
    if isinstance(load, CONSERVATIVE):
        return False
    if isinstance(load, Force | Torque):
        vector = scene.vector(load.vector, load.name).xreplace(dict(absent))
        return any(entry != 0 for entry in vector)
    return True


def _symbols(scene: Scene) -> set[Symbol]:
    """Symbols that positions and potential energy depend on."""
    found: list[Expr] = [potential(scene)]
    for body in scene.bodies:
        found += list(scene.position(body.centre))
    return {symbol for expression in found for symbol in expression.free_symbols}

"""Which coordinates are angles: those whose sine or cosine places or turns a body."""

from sympy import Expr, S, Symbol, cos, sin

from mechanics.scene.declaration import Declaration
from mechanics.scene.units import rolled


def angular(scene: Declaration) -> frozenset[Symbol]:
    """Coordinates that are angles; an arc s is none, which turns a body by s/R."""
    found: set[Symbol] = set()
    for body in scene.bodies:
        matrices = [scene.position(body.centre)]
        if hasattr(body, "frame"):
            matrices.append(scene.rotation(body.frame))
        for matrix in matrices:
            for function in matrix.atoms(sin, cos):
                (of,) = function.args
                found |= {q for q in of.free_symbols & {*scene.q} if _is_ratio(of.diff(q))}
    return frozenset(found - rolled(scene))


def _is_ratio(rate: Expr) -> bool:
    """Whether it is a number, or one by the units of its symbols, as r_1/r_2 of gears."""
    powers: dict[str, Expr] = {}
    for base, power in rate.as_powers_dict().items():
        unit = "" if base.is_number else getattr(base, "unit", "?")
        powers[unit] = powers.get(unit, S.Zero) + power
    return all(unit in ("", "1") or power == 0 for unit, power in powers.items())

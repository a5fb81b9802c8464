"""What a person may say that an equation is about."""

from collections.abc import Callable
from typing import Any

from sympy import Matrix, S
from sympy.matrices import MatrixBase

from mechanics.errors import InputError
from mechanics.scene.published import Quantity
from mechanics.scene.quantities import (
    EquationOfMotion,
    Identity,
    KineticEnergy,
    Lagrangian,
    MassMatrix,
    PotentialEnergy,
    TotalEnergy,
)

QUANTITIES: dict[str, Callable[[], Quantity]] = {
    "equation of motion": EquationOfMotion,
    "kinetic energy": KineticEnergy,
    "potential energy": PotentialEnergy,
    "energy": TotalEnergy,
    "Lagrangian": Lagrangian,
    "mass matrix": MassMatrix,
    "identity": Identity,
}
"""By the words of a person."""

ENERGY_NAMES: dict[str, str] = {
    **dict.fromkeys(("T", "KE", "E_k", "E_kin", "E_K", "T_kin", "Ek", "Ekin"), "kinetic energy"),
    **dict.fromkeys(("V", "U", "PE", "E_p", "E_pot", "Ep", "Epot", "Pi"), "potential energy"),
    **dict.fromkeys(("E", "E_tot", "Etot", "H"), "energy"),
    **dict.fromkeys(("L", "Lagrangian", "Lag"), "Lagrangian"),
}
"""Names that mean an energy, where the scene has no such name and the line does not say more."""

MATRIX_NAMES = frozenset(("M", "MM", "Mq", "M_q", "M_mat", "mass_matrix"))
"""Names of the mass matrix, where the scene has no such name and nothing else uses it."""


def named_quantity(words: str) -> Quantity:
    """The quantity that words name.

    Raises
    ------
    InputError
        For other words.
    """
    if words not in QUANTITIES:
        raise InputError(f"about {words!r}: it can be {', '.join(QUANTITIES)}")
    return QUANTITIES[words]()


def as_asked(quantity: Quantity, sides: tuple[Any, ...]) -> tuple[Any, ...]:
    """Sides in the shape that rows about a quantity have: an equation of two, a matrix of one."""
    if isinstance(quantity, EquationOfMotion) and len(sides) == 1:
        return (*sides, S.Zero)
    if isinstance(quantity, MassMatrix):
        return tuple(s if isinstance(s, MatrixBase) else Matrix([[s]]) for s in sides)
    return sides

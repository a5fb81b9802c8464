"""What a person may say that an equation is about."""

from collections.abc import Callable
from typing import Any

from sympy import Matrix, S
from sympy.matrices import MatrixBase

from mechanics.errors import InputError
from mechanics.nearest import instead
from mechanics.scene.published import Quantity
from mechanics.scene.quantities import (
    EquationOfMotion,
    Hamiltonian,
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
    "Hamiltonian": Hamiltonian,
    "mass matrix": MassMatrix,
    "identity": Identity,
}
"""By the words of a person."""

Ranks = tuple[tuple[str, ...], ...]
"""What a letter means, by rank."""

_MEANINGS: tuple[tuple[str, str, str], ...] = (
    ("T", "kinetic energy", "tension|torque|period"),
    (
        "K KE E_k E_kin E_K T_kin Ek Ekin E_kinetic T_tot T_total K_tot K_total KE_tot KE_total",
        "kinetic energy",
        "",
    ),
    ("V", "potential energy", "speed|effective potential"),
    (
        "PE E_p E_pot Ep Epot Pi E_potential V_tot V_total U_tot U_total PE_tot PE_total",
        "potential energy",
        "",
    ),
    ("U", "potential energy", "effective potential"),
    ("E E_tot Etot E_total E_mech E_m", "energy", ""),
    ("T_period T_per", "period", ""),
    ("L", "Lagrangian", "angular momentum"),
    ("Lagrangian Lag", "Lagrangian", ""),
    ("H h", "Hamiltonian", "angular momentum"),
    ("P", "power", "momentum|period"),
    ("D", "Rayleigh's function", "dissipated power"),
    *((f"P_{axis}", f"momentum along {axis}", "") for axis in "xyz"),
    ("S N", "reaction", ""),
    ("J", "angular momentum", "Hamiltonian"),
    (
        "omega omega_0 omega_n omega_1 omega_2 omega_3 omega0 omega1 omega2 omega3"
        " w w0 w1 w2 w_0 w_1 w_2 w_n wn",
        "frequency",
        "",
    ),
    ("f f_0 f_n nu", "turns per second", ""),
)
"""Letters, what they mean at rank 1, and at rank 2."""

OF_CONSTANTS = frozenset(("frequency", "turns per second"))
"""What is no function of the state: omega = theta' is something else."""

ENTRIES: dict[str, tuple[int, int]] = {
    f"entry {i + 1}{j + 1} of the mass matrix": (i, j) for i in range(7) for j in range(7)
}
"""Entries of the mass matrix, by the words for them."""

LETTERS: dict[str, Ranks] = {
    letter: tuple(tuple(words.split("|")) for words in ranks if words)
    for letters, *ranks in (
        *_MEANINGS,
        *((" ".join(f"{m}_{i + 1}{j + 1} {m}{i + 1}{j + 1}" for m in "MDH"), words, "")
          for words, (i, j) in ENTRIES.items()),
    )
    for letter in letters.split()
}  # fmt: skip
"""What a name on the left means that the scene does not have, where the line says no more."""

WORDS = frozenset((*QUANTITIES, *(w for ranks in LETTERS.values() for rank in ranks for w in rank)))
"""All that a person may say that a name means."""

OTHERS = tuple(sorted(WORDS - QUANTITIES.keys() - ENTRIES.keys()))
"""What is looked for in the scene: which reaction, about which point."""

ENERGY_NAMES: dict[str, str] = {
    letter: ranks[0][0] for letter, ranks in LETTERS.items()
    if ranks[0][0] in QUANTITIES and letter != "h"
}  # fmt: skip
"""Names that mean an energy first."""

MATRIX_NAMES = frozenset(("M", "MM", "Mq", "M_q", "M_mat", "mass_matrix"))
"""Names of the mass matrix, where the scene has no such name and nothing else uses it."""


def named_quantity(words: str) -> Quantity:
    """The quantity that words name; an identity for one that is looked for in the scene.

    Raises
    ------
    InputError
        For other words.
    """
    if words not in WORDS:
        raise InputError(f"about {words!r}: {instead(words, (*QUANTITIES, *OTHERS), 'quantities')}")
    return QUANTITIES.get(words, Identity)()


def as_asked(quantity: Quantity, sides: tuple[Any, ...]) -> tuple[Any, ...]:
    """Sides in the shape that rows about a quantity have: an equation of two, a matrix of one."""
    if isinstance(quantity, EquationOfMotion) and len(sides) == 1:
        return (*sides, S.Zero)
    if isinstance(quantity, MassMatrix):
        return tuple(s if isinstance(s, MatrixBase) else Matrix([[s]]) for s in sides)
    return sides

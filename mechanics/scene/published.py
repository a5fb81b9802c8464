"""A source's own equations, typed by hand: one row an equality.

A row says which quantity it is about, in a closed vocabulary. It is compared with that quantity as
the engine derives it from the scene, never with another typed formula.
"""

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Quantity:
    """Base of the closed vocabulary of what a published row can be about."""


@dataclass(frozen=True, repr=False)
class Published:
    """One published equality.

    Attributes
    ----------
    tag : str
        The number the source gives, ``"(6)"``, or a short label of ours where it has none.
    quantity : Quantity
    sides : tuple
        The sides as the source types them, SymPy expressions or matrices in dynamic symbols; every
        typed side is compared. What a quantity expects of its sides, its docstring says.
    label : str
        What the row states, in words.
    note : str
        How a misprint was read, or another remark.
    latex : str
        The equality as its source types it, where it is kept: shown as it is, and read by a test
        that proves it equal to the sides.
    """

    tag: str
    quantity: Quantity
    sides: tuple[Any, ...]
    label: str
    note: str = ""
    latex: str = ""

    def __repr__(self) -> str:
        return f"<published {self.tag}: {self.label[:120]}>"


def published(
    tag: str, quantity: Quantity, *sides: Any, label: str, note: str = "", latex: str = ""
) -> Published:
    """One row of a ledger: see `Published`.

    Examples
    --------
    >>> from mechanics.scene.quantities import KineticEnergy
    >>> from systems.rod_pendulum import l, m, theta
    >>> published("(3)", KineticEnergy(), m * l**2 * theta.diff() ** 2 / 6, label="energy").sides
    (l**2*m*Derivative(theta(t), t)**2/6,)
    """
    return Published(tag, quantity, sides, label, note, latex)

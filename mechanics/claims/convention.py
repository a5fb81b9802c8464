"""One change of convention: what a person's symbol is in the scene's.

q -> q + pi        q -> -q, q' -> -q', q'' -> -q''        L -> L / 2
"""

from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Expr, Symbol

from mechanics.scene import Scene
from mechanics.scene.symbols import plain_symbol

Table = dict[Symbol, Expr]


@dataclass(frozen=True)
class Convention:
    """One change of convention.

    Attributes
    ----------
    name : str
        As a person declares it, with no choice left open: ``"half-length of L"``.
    words : str
        What has to be so for the equations to be right.
    table : dict of Symbol to Expr
        What stands for the person's symbols.
    kind : str
        ``"turn"``, ``"sign"``, ``"direction"`` (both at once), ``"joints"``, ``"size"`` or
        ``"masses"``.
    """

    name: str
    words: str
    table: Table
    kind: str


Change = tuple[Convention, ...]
"""Conventions that hold together: the last is applied to what the first gives."""

POINT_MASS = Convention("point mass", "every rod is a point mass at its mass centre", {}, "masses")


def combined_table(conventions: Change) -> Table:
    """One substitution for all changes, the last applied to what the first gives."""
    found: Table = {}
    for convention in conventions:
        found = {symbol: value.xreplace(convention.table) for symbol, value in found.items()}
        for symbol, value in convention.table.items():
            found.setdefault(symbol, value)
    return found


def negative(scene: Scene, symbols: Sequence[Symbol]) -> Table:
    """Coordinates and their rates with the other sign."""
    found: Table = {}
    for function in scene.coordinates:
        if plain_symbol(function) in symbols:
            for order in range(3):
                symbol = plain_symbol(function, order)
                found[symbol] = -symbol
    return found


def about(symbols: Sequence[Symbol], words: str) -> str:
    """``theta is counted ...``, ``q1, q2 are counted ...``."""
    return f"{', '.join(s.name for s in symbols)} {'is' if len(symbols) == 1 else 'are'} {words}"

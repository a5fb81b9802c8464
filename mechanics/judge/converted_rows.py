"""A row of a person who counts otherwise, as the scene counts.

q_p = T q + c        p_p = T^-T p        M = T^T M_p T

q_p, p_p and M_p are the person's coordinates, their momenta and their mass matrix. Generalized
speeds that are no rates are the scene's own.
"""

from collections.abc import Callable
from dataclasses import replace

from sympy import Expr, Matrix, Symbol, sympify
from sympy.core.function import AppliedUndef
from sympy.matrices import MatrixBase
from sympy.physics.vector import dynamicsymbols

from mechanics.claims.convention import Table
from mechanics.kinematics.momenta import momenta_written_out
from mechanics.kinematics.symbolic import Kinematics
from mechanics.scene import Scene
from mechanics.scene.momenta import momentum_symbols, rate_symbol
from mechanics.scene.published import Published
from mechanics.scene.quantities import GeneralizedMomentum, MassMatrix
from mechanics.scene.symbols import plain_symbol, plain_table, to_plain


def each_side(row: Published, change: Callable[[Expr], Expr]) -> Published:
    """A row with every side changed."""
    sides = (s.applyfunc(change) if isinstance(s, MatrixBase) else change(s) for s in row.sides)
    return replace(row, sides=tuple(sides))


def in_plain_symbols(kinematics: Kinematics, row: Published) -> Published:
    """A row in plain symbols."""
    plain = kinematics.scene.plain
    return each_side(row, lambda side: momenta_written_out(kinematics, plain(side)))


def moved(scene: Scene, row: Published, table: Table) -> Published:
    """A row with what stands for the person's symbols.

    Parameters
    ----------
    row : Published
        As the person counts.
    table : dict of Symbol to Expr
        The person's symbols in the scene's.
    """
    if not table:
        return row
    slopes = slopes_of(scene, table)
    momenta = _momenta(scene, slopes)
    there = {**table, **momenta}
    # The rates of the person's coordinates come before they are written in the scene's speeds.
    momentum = (dynamicsymbols(p.name) for p in momentum_symbols(scene))
    known = plain_table(
        (*momentum, *scene.coordinates, *scene.inputs, *(u for u, _ in scene.speeds))
    )
    found = each_side(row, lambda side: _named(scene, side, known).xreplace(there))
    match row.quantity:
        case MassMatrix() if not scene.speeds:
            # Of another shape it is left as it is, and the ledger tells.
            shapes = [getattr(m, "shape", None) == slopes.shape for m in found.sides]
            sides = zip(found.sides, shapes, strict=True)
            found = replace(
                found, sides=tuple(slopes.T * m * slopes if fits else m for m, fits in sides)
            )
        case GeneralizedMomentum(coordinate=name):
            (own,) = (p for p, q in momentum_symbols(scene).items() if q.name == name)
            value = momenta.get(own, own)
            share = value.coeff(own)
            others = value - share * own
            found = replace(found, sides=tuple((side - others) / share for side in found.sides))
    return found


def slopes_of(scene: Scene, table: Table) -> Matrix:
    """How the person's coordinates grow with the scene's, a row for each of the person's.

    Parameters
    ----------
    table : dict of Symbol to Expr
        The person's symbols in the scene's.
    """
    return Matrix([[table.get(q, q).diff(s) for s in scene.q] for q in scene.q])


def moves_more(scene: Scene, row: Published) -> bool:
    """Whether more than the symbols of a row in plain symbols has to be replaced."""
    if isinstance(row.quantity, GeneralizedMomentum):
        return True
    if isinstance(row.quantity, MassMatrix):
        return not scene.speeds
    special = {s.name for p in momentum_symbols(scene) for s in (p, rate_symbol(p))}
    if scene.speeds:
        special |= {plain_symbol(q, order).name for q in scene.coordinates for order in (1, 2)}
    held = {s.name for side in row.sides for s in sympify(side).free_symbols}
    functions = {f for side in row.sides for f in sympify(side).atoms(AppliedUndef)}
    return (
        bool(held & special)
        or bool(functions and scene.speeds)
        or bool({f.name for f in functions} & special)
    )


def _named(scene: Scene, side: Expr, known: dict[Expr, Symbol]) -> Expr:
    """A side in plain symbols, the rates of coordinates among them."""
    return to_plain(side, known, scene.name) if side.atoms(AppliedUndef) else side


def _momenta(scene: Scene, slopes: Matrix) -> Table:
    """What stands for the momenta of the person's coordinates, and for their rates."""
    symbols = {q: p for p, q in momentum_symbols(scene).items()}
    if slopes.is_Identity or set(symbols) != set(scene.q):
        return {}
    back = slopes.inv().T
    found: Table = {}
    for change in (lambda p: p, rate_symbol):
        all_of = Matrix([change(symbols[q]) for q in scene.q])
        found |= dict(zip(all_of, back * all_of, strict=True))
    return found

"""A nonholonomic constraint put into the Lagrangian before it is differentiated.

    L*(q, q'_free) = L(q, q'_free, q'_tied(q, q'_free))        d/dt(dL*/dq') - dL*/dq = Q*

That is wrong: rates of the tied coordinates are given, but not the coordinates themselves, and the
term p_tied (d/dt(dq'_tied/dq') - dq'_tied/dq) is lost.
"""

from collections.abc import Iterator
from itertools import combinations

from sympy import Add, Expr, S, Symbol

from mechanics.blame.mistakes.fault_model import Fault, Right, once
from mechanics.blame.pieces import Kind, Origin, Piece
from mechanics.kinematics.symbolic import Kinematics
from mechanics.scene import Gravity, Scene
from mechanics.scene.loads import CONSERVATIVE
from mechanics.scene.potential import load_potential
from mechanics.scene.rates import coordinate_rate_table, rate
from mechanics.scene.symbols import plain_symbol
from mechanics.symbolic import canonical, collect_linear, independent_rows
from mechanics.symbolic.cramer import cramer


def faults(right: Right) -> Iterator[Fault]:
    """For each set of rates that the constraints may be solved for."""
    scene = right.scene
    if right.free or not scene.constraints or any(c.holonomic for c in scene.constraints):
        return
    parts = _lagrangian(scene)
    energy = Add(*(value for _, value in parts))
    forms = [scene.rates(c.expression) for c in scene.constraints]
    for tied in _tied(scene, energy, forms):
        table = _solved(forms, tied)
        names = ", ".join(symbol.name for symbol in tied)
        words = f"the constraints, solved for {names}, substituted into the Lagrangian"
        yield Fault(words, once(_rows(right, parts, tied, table)), scene.ud)


def _lagrangian(scene: Scene) -> list[tuple[Origin, Expr]]:
    """Kinetic energy, and less the potential energy of each load, in q and q'."""
    found = [(Origin(Kind.TRANSLATION, "all bodies"), Kinematics(scene).energy_in_rates)]
    for load in scene.loads:
        if isinstance(load, CONSERVATIVE):
            name = "gravity" if isinstance(load, Gravity) else load.name
            found.append((Origin(Kind.LOAD, "", name), -load_potential(scene, load)))
    return found


def _tied(scene: Scene, energy: Expr, forms: list[Expr]) -> Iterator[tuple[Symbol, ...]]:
    """Sets of rates that the constraints determine, whose coordinates stand in fewest terms."""
    held = energy.free_symbols.union(*(form.free_symbols for form in forms))
    pairs = list(zip(scene.q, scene.qd, strict=True))
    choices = list(combinations(pairs, len(forms)))
    fewest = min(sum(q in held for q, _ in choice) for choice in choices)
    for choice in choices:
        rates = tuple(qd for _, qd in choice)
        matrix = [collect_linear(form, rates)[0] for form in forms]
        if sum(q in held for q, _ in choice) == fewest and len(independent_rows(matrix)) == len(
            forms
        ):
            yield rates


def _solved(forms: list[Expr], tied: tuple[Symbol, ...]) -> dict[Symbol, Expr]:
    """The tied rates in the free ones."""
    numerators, denominator = cramer(forms, tied)
    return {s: canonical(n / denominator) for s, n in zip(tied, numerators, strict=True)}


def _rows(
    right: Right,
    parts: list[tuple[Origin, Expr]],
    tied: tuple[Symbol, ...],
    table: dict[Symbol, Expr],
) -> Iterator[tuple[Piece, ...]]:
    """Lagrange's equations of L* for the free coordinates, in u and u'."""
    scene = right.scene
    reduced = [(origin, canonical(value.xreplace(table))) for origin, value in parts]
    clock = coordinate_rate_table(scene)
    second = {plain_symbol(q, 1): plain_symbol(q, 2) for q in scene.coordinates}
    given = {second[symbol]: rate(value, clock) for symbol, value in table.items()}
    for q, qd in zip(scene.q, scene.qd, strict=True):
        if qd in tied:
            continue
        pieces = []
        for origin, value in reduced:
            left = rate(value.diff(qd), clock) - value.diff(q)
            pieces.append(Piece(origin, scene.plain(left.xreplace(given).xreplace(table))))
        yield *pieces, *_forces(right, qd, table)


def _forces(right: Right, qd: Symbol, table: dict[Symbol, Expr]) -> Iterator[Piece]:
    """Loads without potential, projected on the velocities that the constraints admit."""
    scene = right.scene
    names = {load.name for load in scene.loads if not isinstance(load, CONSERVATIVE)}
    slopes = [_slope(scene, index, qd, table) for index in range(len(scene.u))]
    for row, slope in zip(right.rows, slopes, strict=True):
        for _, piece in row:
            if piece.origin.kind is Kind.LOAD and piece.origin.name in names and slope != 0:
                yield Piece(piece.origin, slope * piece.value)


def _slope(scene: Scene, index: int, qd: Symbol, table: dict[Symbol, Expr]) -> Expr:
    """du/dq' with the tied rates following the free one."""
    speed = scene.qd[index] if not scene.speeds else scene.rates(scene.speeds[index][1])
    follow = Add(*(speed.diff(s) * value.diff(qd) for s, value in table.items()))
    return S.Zero + speed.diff(qd) + follow

"""Dimensions of published rows: what is added or equated has to have one.

    [a + b] = [a] = [b]      [a b] = [a] [b]      [sin a] = [a] = 1      [da/dt] = [a] / s

A proof does not see a parameter whose unit is wrong, nor tells of a typing error that a power or a
factor is missing: this does, term by term. Where a symbol has no unit nothing is known of its
products, and nothing is said of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from sympy import Abs, Expr, Function, Pow, Symbol, cos, exp, sign, sin, tan

from mechanics.checks.ledger import QUANTITIES, plain_side
from mechanics.kernel import Finding, refuted, same
from mechanics.kinematics.symbolic import Kinematics
from mechanics.scene import Scene
from mechanics.scene.published import Published
from mechanics.scene.unit_names import Dimension, dimension_of_unit, words
from mechanics.scene.units import declared

NONE = dimension_of_unit("1", "")
PLAIN: tuple[Any, ...] = (sin, cos, tan, exp)
"""Functions of numbers that give numbers."""
LONGEST = 80
SUBJECT = "dimensions of published rows"


class _Mixed(Exception):
    """Two terms that stand together have different dimensions.

    Attributes
    ----------
    units : (str, str)
    """

    def __init__(self, message: str, one: str, other: str) -> None:
        super().__init__(message)
        self.units = one, other


def check_dimensions(
    scene: Scene, rows: Sequence[Published], units: Mapping[Symbol, str]
) -> tuple[Finding, ...]:
    """Whether the terms of each row, and its sides, have one dimension.

    Parameters
    ----------
    scene : Scene
    rows : sequence of Published
        Those about other quantities than `QUANTITIES` are left out: numbers may be lengths there.
    units : mapping of Symbol to str
        Of coordinates, speeds, accelerations, inputs, reactions and parameters, in plain symbols.

    Returns
    -------
    tuple of Finding
        One for each row that is not consistent, and one for all others; none of a scene that is
        declared with numbers in place of parameters, which carry units that nothing tells.
    """
    chosen = [row for row in rows if isinstance(row.quantity, QUANTITIES)]
    if not chosen or any(e.is_number and e != 0 and u != "1" for _, e, u in declared(scene)):
        return ()
    texts = {symbol: unit.replace(" ", "*") for symbol, unit in units.items()}
    known = {symbol: dimension_of_unit(text, str(symbol)) for symbol, text in texts.items()}
    found = []
    pairs: list[tuple[str, str]] = []
    kinematics = Kinematics(scene)
    for row in chosen:
        subject = f"{row.tag} {row.label}"
        try:
            for entries in _entries(kinematics, row, subject):
                first = _one(scene, entries, known)
                own = [_dimension(scene, side, known) for side in entries]
                pairs += [(words(first), words(one)) for one in own if first and one]
        except _Mixed as mixed:
            evidence = f"{mixed}: correct the row, or the unit of a parameter"
            found.append(refuted(f"{subject}: dimensions", evidence, *mixed.units))
    count = len(chosen) - len(found)
    evidence = f"in {count} rows all terms whose units are declared have one dimension"
    if not count or not pairs:
        return tuple(found)
    return (same(SUBJECT, [one for one, _ in pairs], [two for _, two in pairs], evidence), *found)


def _entries(kinematics: Kinematics, row: Published, subject: str) -> Iterator[tuple[Expr, ...]]:
    """The sides of a row; of vectors, entry by entry."""
    sides = [plain_side(kinematics, side, subject) for side in row.sides]
    yield from zip(*([*s] if hasattr(s, "shape") else [s] for s in sides), strict=True)


def _one(scene: Scene, terms: Sequence[Expr], known: Mapping[Symbol, Any]) -> Dimension | None:
    """The dimension that all terms have; None where none is known."""
    first: tuple[Expr, Dimension] | None = None
    for term in terms:
        found = _dimension(scene, term, known)
        if found is None:
            continue
        if first is not None and found != first[1]:
            one, other = words(first[1]), words(found)
            raise _Mixed(
                f"{_shown(first[0])} has the unit {one}, and {_shown(term)} has {other}", one, other
            )
        first = first or (term, found)
    return first[1] if first else None


def _dimension(scene: Scene, e: Expr, known: Mapping[Symbol, Any]) -> Dimension | None:
    if e.is_number:
        return None if e == 0 else NONE
    if e.is_Symbol:
        if known.get(e) is None and e in scene.definitions:
            return _dimension(scene, scene.definitions[e], known)
        return known.get(e)
    if e.is_Add:
        return _one(scene, e.args, known)
    if e.is_Mul:
        factors = [_dimension(scene, factor, known) for factor in e.args]
        return _sum([(f, 1) for f in factors])
    if isinstance(e, Pow):
        base = _dimension(scene, e.base, known)
        if e.exp.is_Rational:
            return _sum([(base, e.exp)])
        _plain(scene, e.exp, known, e)
        return NONE if base == NONE else None
    if isinstance(e, Abs):
        return _dimension(scene, e.args[0], known)
    if isinstance(e, sign):
        return NONE
    if isinstance(e, PLAIN):
        _plain(scene, e.args[0], known, e)
        return NONE
    if isinstance(e, Function):
        for argument in e.args:
            _dimension(scene, argument, known)
    return None


def _plain(scene: Scene, argument: Expr, known: Mapping[Symbol, Any], of: Expr) -> None:
    """Refuse an argument that has a dimension."""
    found = _dimension(scene, argument, known)
    if found is not None and found != NONE:
        unit = words(found)
        raise _Mixed(f"{_shown(argument)} in {_shown(of)} has the unit {unit}, not 1", unit, "1")


def _sum(parts: Sequence[tuple[Any, Any]]) -> Dimension | None:
    """Exponents of a product of powers; None where a factor is not known."""
    if any(found is None for found, _ in parts):
        return None
    columns = zip(*([power * entry for entry in found] for found, power in parts), strict=True)
    return tuple(sum(column) for column in columns)


def _shown(e: Expr) -> str:
    text = str(e)
    return text if len(text) <= LONGEST else f"{text[:LONGEST]}..."

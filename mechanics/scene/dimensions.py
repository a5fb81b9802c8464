"""Dimension of an expression: what is added has to have one.

    [a + b] = [a] = [b]      [a b] = [a] [b]      [sin a] = [a] = 1

Where a symbol has no unit nothing is known of its products, and nothing is said of them.
"""

from collections.abc import Mapping, Sequence
from typing import Any

from sympy import Abs, Expr, Function, Pow, Rational, Symbol, cos, exp, sign, sin, tan

from mechanics.scene.scene import Scene
from mechanics.scene.unit_names import Dimension, dimension_of_unit, words

NONE = dimension_of_unit("1", "")
PLAIN: tuple[Any, ...] = (sin, cos, tan, exp)
"""Functions of numbers that give numbers."""
LONGEST = 80
MOST_BITS = 10_000
BY_DIMENSION = "by dimension: "
"""Begins the evidence where a dimension alone refutes what a person wrote."""


class MixedDimensions(Exception):
    """Two terms that stand together have different dimensions.

    Attributes
    ----------
    units : (str, str)
    """

    def __init__(self, message: str, one: str, other: str) -> None:
        super().__init__(message)
        self.units = one, other


def one_dimension(
    scene: Scene, terms: Sequence[Expr], known: Mapping[Symbol, Any]
) -> Dimension | None:
    """The dimension that all terms have; None where none is known.

    Raises
    ------
    MixedDimensions
        Where two differ.
    """
    first: tuple[Expr, Dimension] | None = None
    for term in terms:
        found = dimension_of(scene, term, known)
        if found is None:
            continue
        if first is not None and found != first[1]:
            one, other = words(first[1]), words(found)
            raise MixedDimensions(
                f"{_shown(first[0])} has the unit {one}, and {_shown(term)} has {other}", one, other
            )
        first = first or (term, found)
    return first[1] if first else None


def dimension_of(scene: Scene, e: Expr, known: Mapping[Symbol, Any]) -> Dimension | None:
    """Dimension of an expression in plain symbols; None where it is not known.

    Parameters
    ----------
    known : mapping of Symbol to Dimension or None

    Raises
    ------
    MixedDimensions
        For a sum of terms of different dimensions, and a function of what is no number.
    """
    if e.is_number:
        return None if e == 0 else NONE
    if e.is_Symbol:
        if known.get(e) is None and e in scene.definitions:
            return dimension_of(scene, scene.definitions[e], known)
        return known.get(e)
    if e.is_Add:
        return one_dimension(scene, e.args, known)
    if e.is_Mul:
        factors = [dimension_of(scene, factor, known) for factor in e.args]
        return _sum([(f, 1) for f in factors])
    if isinstance(e, Pow):
        base = dimension_of(scene, e.base, known)
        if e.exp.is_Rational:
            return _sum([(base, e.exp)])
        _plain(scene, e.exp, known, e)
        return NONE if base == NONE else None
    if isinstance(e, Abs):
        return dimension_of(scene, e.args[0], known)
    if isinstance(e, sign):
        return NONE
    if isinstance(e, PLAIN):
        _plain(scene, e.args[0], known, e)
        return NONE
    if isinstance(e, Function):
        for argument in e.args:
            dimension_of(scene, argument, known)
    return None


def _plain(scene: Scene, argument: Expr, known: Mapping[Symbol, Any], of: Expr) -> None:
    """Refuse an argument that has a dimension."""
    found = dimension_of(scene, argument, known)
    if found is not None and found != NONE:
        unit = words(found)
        raise MixedDimensions(
            f"{_shown(argument)} in {_shown(of)} has the unit {unit}, not 1", unit, "1"
        )


def _sum(parts: Sequence[tuple[Any, Any]]) -> Dimension | None:
    """Exponents of a product of powers; None where a factor is not known."""
    if any(found is None for found, _ in parts):
        return None
    columns = zip(*([power * entry for entry in found] for found, power in parts), strict=True)
    return tuple(sum(column) for column in columns)


def _shown(e: Expr) -> str:
    if any(max(abs(n.p), n.q).bit_length() > MOST_BITS for n in e.atoms(Rational)):
        return "a number of very many digits"  # Python writes no integer that is so long
    text = str(e)
    return text if len(text) <= LONGEST else f"{text[:LONGEST]}..."

"""Dimensions of published rows: what is added or equated has to have one.

    [a + b] = [a] = [b]      [a b] = [a] [b]      [sin a] = [a] = 1      [da/dt] = [a] / s

A proof does not see a parameter whose unit is wrong, nor tells of a typing error that a power or a
factor is missing: this does, term by term. Where a symbol has no unit nothing is known of its
products, and nothing is said of them.
"""

from collections.abc import Iterator, Mapping, Sequence

from sympy import Expr, Symbol

from mechanics.checks.ledger import QUANTITIES, plain_side
from mechanics.kernel import Finding, refuted, same
from mechanics.kinematics.symbolic import Kinematics
from mechanics.scene import Scene
from mechanics.scene.dimensions import MixedDimensions, dimension_of, one_dimension
from mechanics.scene.published import Published
from mechanics.scene.unit_names import dimension_of_unit, words
from mechanics.scene.units import declared

SUBJECT = "dimensions of published rows"


def check_dimensions(
    scene: Scene, rows: Sequence[Published], units: Mapping[Symbol, str]
) -> tuple[Finding, ...]:
    """Whether the terms of each row, and its sides, have one dimension.

    Parameters
    ----------
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
                first = one_dimension(scene, entries, known)
                own = [dimension_of(scene, side, known) for side in entries]
                pairs += [(words(first), words(one)) for one in own if first and one]
        except MixedDimensions as mixed:
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

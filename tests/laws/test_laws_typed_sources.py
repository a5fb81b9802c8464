"""What a source typed says the same as the row of the ledger beside it: a typo in it is caught."""

from dataclasses import replace

import pytest
from sympy import Basic, Derivative, Expr, Matrix, sympify

from mechanics.claims.read import read_source
from mechanics.scene import Scene
from mechanics.scene.published import Published
from mechanics.symbolic.decide import prove_zero
from systems import EVERY, rocker, rocker_ledger

TYPED = [
    pytest.param(system, row, id=f"{system.name}-{row.tag}-{row.label}")
    for system in EVERY
    for row in system.published
    if row.latex
]


def entries(scene: Scene, side: object) -> list[Expr]:
    carried_out = sympify(side)
    if isinstance(carried_out, Basic) and carried_out.has(Derivative):
        carried_out = carried_out.doit()
    flat = carried_out if hasattr(carried_out, "shape") else Matrix([carried_out])
    return [scene.plain(entry) for entry in flat]


def equal(one: list[Expr], other: list[Expr]) -> bool:
    return len(one) == len(other) and all(
        prove_zero("typed", a - b).shown for a, b in zip(one, other, strict=True)
    )


def says_the_same(scene: Scene, row: Published) -> bool:
    """Whether each side of the row is typed, and no typed side is another one.

    Sides with a letter that the source defines elsewhere are left to the rows that define it.
    """
    rows = [statement.row for statement in read_source(scene, row.latex).statements]
    if None in rows:
        return False
    own = [entries(scene, side) for side in row.sides]
    # Rows of a matrix are statements of their own.
    columns = zip(*(one.sides for one in rows), strict=True)
    typed = [[e for side in column for e in entries(scene, side)] for column in columns]
    known = {*scene.q, *scene.qd, *scene.u, *scene.ud, *scene.parameters, *scene.definitions}
    known |= {*scene.input_symbols, *(r.symbol for r in scene.reactions)}
    read = [side for side in typed if set().union(*(e.free_symbols for e in side)) <= known]
    return all(any(equal(a, b) for b in read) for a in own) and all(
        any(equal(a, b) for b in own) for a in read
    )


@pytest.mark.sample(6)
@pytest.mark.parametrize(("system", "row"), TYPED)
def test_what_is_typed_is_what_the_row_states(system, row) -> None:
    made = system.scene()
    assert says_the_same(getattr(made, "scene", made), row)


@pytest.mark.parametrize(("wrong", "right"), [("{5}{4}", "{5}{3}"), (r"-M g", r"+M g")])
def test_a_typo_is_caught(wrong: str, right: str) -> None:
    row = next(row for row in rocker_ledger.PUBLISHED if row.tag == "(7)")
    assert says_the_same(rocker.scene(), row)
    assert wrong in row.latex
    typo = replace(row, latex=row.latex.replace(wrong, right))
    assert not says_the_same(rocker.scene(), typo)

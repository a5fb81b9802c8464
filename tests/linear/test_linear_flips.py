"""Sensitivity law: one flipped sign in a typed side turns its row, and only it, REFUTED.

Every term of every sum, however deep, the leading sign of every side and entry, every rounded
number, and every word is flipped in turn. A flip that changes nothing is left out: the normal form
shows the sides to be equal, or a row ... = 0 was multiplied by -1.
"""

from dataclasses import replace
from functools import cache
from typing import Any

import pytest
from sign_flips import flipped_rows
from sympy import Expr, ImmutableMatrix, Symbol, sympify
from sympy.matrices import MatrixBase

from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from mechanics.linear.ledger import QUANTITIES, check_linear_row
from mechanics.routes.derivation import by_route
from mechanics.scene.linear_quantities import (
    CharacteristicPolynomial,
    InertiaAbout,
    LinearQuantity,
    SpeedMatrix,
    operating_point,
)
from mechanics.scene.published import Published, published
from mechanics.scene.quantities import EquationOfMotion
from mechanics.symbolic import canonical
from systems import (
    rocker,
    rocker_control_ledger,
    rolling_disc,
    two_mass_chain,
    two_mass_chain_ledger,
)

v = Symbol("v", positive=True)
LEANING = operating_point({"lean": 0}, speeds={"u2": v / rolling_disc.R})
DISC = tuple(
    # Its yaw momentum is kept: 3 m v yaw' goes with it into K_2.
    published(name, SpeedMatrix(LEANING, name, "v"), ImmutableMatrix([[entry]]), label=f"{name}")
    for name, entry in (
        ("M", 5 * rolling_disc.m * rolling_disc.R**2 / 4),
        ("K0", -rolling_disc.m * rolling_disc.R),
        ("K2", 3 * rolling_disc.m),
    )
)
LEDGERS = {
    "rolling_disc": (rolling_disc.scene, DISC),
    "rocker": (rocker.scene, rocker_control_ledger.PUBLISHED),
    "two_mass_chain": (two_mass_chain.scene, two_mass_chain_ledger.MODES),
}
ROWS = [
    pytest.param(name, row, id=f"{name}: {row.tag} {row.label}")
    for name, (_, rows) in LEDGERS.items()
    for row in rows
]
ROUTES = ("lagrange", "kane", "free_body", "moving_point")
# Their coefficients themselves are compared, not what follows from the rows.
NEED_CONJUGATE = {
    "rolling_disc": {SpeedMatrix},
    "rocker": {InertiaAbout},
    "two_mass_chain": {CharacteristicPolynomial},
}


@cache
def derived(name: str, route: str = "lagrange") -> Equations:
    scene, _ = LEDGERS[name]
    return by_route(route, scene())


def says_the_same(name: str, row: Published, other: Published) -> bool:
    """Whether the flip changed nothing: equal entries, or a row ... = 0 times -1."""
    plain = derived(name).scene.plain

    def entries(side: Any) -> list[Expr]:
        return [plain(e) for e in (side if isinstance(side, MatrixBase) else [sympify(side)])]

    old, new = ([entries(side) for side in r.sides] for r in (row, other))
    if all(canonical(a - b) == 0 for o, n in zip(old, new) for a, b in zip(o, n)):  # noqa: B905
        return True
    if len(old) != 2 or any(entry != 0 for entry in old[1]):
        return False
    return all(canonical(a**2 - b**2) == 0 for a, b in zip(old[0], new[0], strict=True))


@pytest.mark.sample(2)
@pytest.mark.parametrize(("name", "row"), ROWS)
def test_row_is_proved(name: str, row: Published) -> None:
    equations = derived(name)
    finding = check_linear_row(equations.scene, row, equations)
    assert finding.verdict is Verdict.PROVED, finding


@pytest.mark.sample(2)
@pytest.mark.parametrize("route", ["kane", "free_body", "moving_point"])
@pytest.mark.parametrize("name", LEDGERS)
def test_rows_are_proved_by_the_other_routes(name: str, route: str) -> None:
    equations = derived(name, route)
    undecided = set()
    for row in LEDGERS[name][1]:
        finding = check_linear_row(equations.scene, row, equations)
        if finding.verdict is not Verdict.PROVED:
            assert finding.verdict is Verdict.UNDECIDED
            assert "not power-conjugate" in finding.evidence
            undecided.add(type(row.quantity))
    assert undecided == (set() if equations.conjugate else NEED_CONJUGATE[name])


@pytest.mark.sample(2)
@pytest.mark.parametrize(("name", "row"), ROWS)
def test_one_flipped_sign_is_refuted(name: str, row: Published) -> None:
    equations = derived(name)
    refuted = 0
    for other in flipped_rows(row):
        finding = check_linear_row(equations.scene, other, equations)
        if finding.verdict is Verdict.REFUTED:
            assert finding.witness is not None
            assert finding.witness.left != finding.witness.right
            refuted += 1
        else:
            assert says_the_same(name, row, other), (other.sides, finding)
    assert refuted > 0


@pytest.mark.parametrize("name", LEDGERS)
def test_only_the_flipped_row_is_refuted(name: str) -> None:
    equations, rows = derived(name), LEDGERS[name][1]
    place = len(rows) // 2
    other = next(flipped_rows(rows[place]))
    copy = [*rows[:place], other, *rows[place + 1 :]]
    findings = [check_linear_row(equations.scene, row, equations) for row in copy]
    assert [i for i, finding in enumerate(findings) if not finding.shown] == [place]


def test_every_quantity_of_the_vocabulary_is_checked_by_a_row() -> None:
    used = {type(row.quantity) for _, rows in LEDGERS.values() for row in rows}
    assert used == set(QUANTITIES) == set(LinearQuantity.__subclasses__())


def test_row_about_another_quantity_is_refused() -> None:
    equations = derived("rocker")
    row = replace(rocker_control_ledger.PUBLISHED[1], quantity=EquationOfMotion())
    with pytest.raises(InputError, match="EquationOfMotion is no quantity of linear equations"):
        check_linear_row(equations.scene, row, equations)


def test_identity_is_no_equation() -> None:
    equations = derived("rocker")
    row = rocker_control_ledger.PUBLISHED[1]
    finding = check_linear_row(equations.scene, replace(row, sides=(row.sides[0],) * 2), equations)
    assert finding.verdict is Verdict.UNDECIDED
    assert "identity" in finding.evidence

"""Statements that nobody should write: blame says little about them, and does not fail."""

from collections.abc import Callable

import pytest
from sympy import (
    Abs,
    Expr,
    Float,
    I,
    Max,
    Piecewise,
    S,
    Symbol,
    atan2,
    cos,
    exp,
    eye,
    log,
    nan,
    oo,
    pi,
    sign,
    sin,
    sqrt,
    tan,
    zeros,
)

from mechanics.blame.difference import LARGE, differences
from mechanics.blame.explanations import explanations
from mechanics.blame.reference import Reference
from mechanics.claims.statement import Statement
from mechanics.equations import Equations
from mechanics.kernel import Finding, Verdict
from mechanics.scene.published import Quantity, published
from mechanics.scene.quantities import (
    EquationOfMotion,
    Identity,
    KineticEnergy,
    Lagrangian,
    MassMatrix,
    PotentialEnergy,
    TotalEnergy,
)

REFUTED = Finding("strange", Verdict.REFUTED, "")
SYSTEMS = ("elastic_pendulum", "rocker", "cartpole_friction")


def residuals(row: Expr, q: Symbol, u: Symbol, ud: Symbol, p: Symbol) -> list[Expr]:
    return [
        row * tan(q), row + Abs(u), row + p * sign(u), row / (1 + sqrt(1 + q**2)), exp(q) * row + 1,
        Piecewise((row, q > 1), (row + 1, True)), row**2 + ud, ud * ud, row * Float("0.333") + u,
        sqrt(row**2 + 1), S.Zero, q, sin(q / 2) * row + p, cos(3 * q + pi / 4) * p + row,
        atan2(q, u) + row, row + p**q, row + Symbol("strange"), row + sin(sin(q)),
        log(p) * row + 1, row * p**40 + 1, (row + p + q) ** 4, row + S(10) ** 50 / 3, oo, nan,
        I * row, row / (row + 1), 1 / row, Max(q, u) + row, cos(q + u) + row, cos(100 * q) + row,
    ]  # fmt: skip


def others(q: Symbol, u: Symbol, p: Symbol, size: int) -> list[tuple[Quantity, tuple]]:
    return [
        (KineticEnergy(), (p * u**2,)),
        (PotentialEnergy(), (sin(q) + Abs(q),)),
        (Lagrangian(), (q * u,)),
        (TotalEnergy(), (p,)),
        (MassMatrix(), (p * eye(size),)),
        (MassMatrix(), (zeros(2, 7),)),
        (Identity(), (p, q)),
    ]


@pytest.mark.campaign
@pytest.mark.sample(0)
@pytest.mark.parametrize("name", SYSTEMS)
def test_strange_statements_are_survived(truth_of: Callable[[str], Equations], name: str) -> None:
    truth = truth_of(name)
    scene = truth.scene
    q, u, ud, p = scene.q[0], scene.u[0], scene.ud[0], scene.parameters[0]
    reference = Reference(truth)
    row = reference.derivation.generalized_rows[0].value
    rows = [
        published("1", EquationOfMotion(), value, S.Zero, label="strange")
        for value in residuals(row, q, u, ud, p)
    ]
    rows += [
        published("1", quantity, *sides, label="strange")
        for quantity, sides in others(q, u, p, len(scene.u))
    ]
    for one in rows:
        statement = Statement(one, "strange", "1")
        for difference in differences(reference, statement):
            assert difference.written or difference.right
            assert difference.written.count(" + ") + difference.right.count(" + ") < 10 * LARGE
        (words,) = explanations(reference, [statement], [REFUTED])
        assert all(isinstance(word, str) and word for word in words)


def test_what_could_not_be_read_has_nothing(truth_of: Callable[[str], Equations]) -> None:
    reference = Reference(truth_of("rocker"))
    unread = Statement(None, "strange", "1", doubt="it could not be read")
    assert differences(reference, unread) == ()
    assert explanations(reference, [unread], [REFUTED]) == ((),)

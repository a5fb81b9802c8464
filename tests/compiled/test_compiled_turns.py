"""Fixed turns whose sines no double holds: what is compiled is shown with the exact numbers."""

import pytest
from sympy import Expr, Rational, pi

from mechanics import compile, derive
from mechanics.compiled import prove_compiled
from tests.serial_arms import serial_arm

TURNS = {
    "30 degrees": pi / 6, "36 degrees": pi / 5, "22.5 degrees": pi / 8,
    "0.3 radians": Rational(3, 10),
}  # fmt: skip


@pytest.mark.campaign
@pytest.mark.sample(1)
@pytest.mark.parametrize("turn", TURNS.values(), ids=TURNS)
def test_every_function_is_as_derived(turn: Expr) -> None:
    scene = serial_arm(2, turn=turn).scene
    findings = list(prove_compiled(compile(derive(scene, "kane")), None))
    assert len(findings) > 5
    assert [finding.subject for finding in findings if not finding.shown] == []

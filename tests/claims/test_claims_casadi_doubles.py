"""What a CasADi function computes in doubles is its formula, or nothing is proved of it."""

import casadi
import pytest

import mechanics
from mechanics.kernel import Verdict
from systems import two_mass_chain

SCENE = two_mass_chain.scene()
Q, K, M = casadi.SX.sym("q", 2), casadi.SX.sym("k"), casadi.SX.sym("m")
FIRST = (K * Q[1] - 2 * K * Q[0]) / (3 * M)
SECOND = (K * Q[0] - K * Q[1]) / (2 * M)


def judged(first: casadi.SX):
    rates = casadi.Function("f", [Q, K, M], [casadi.vertcat(first, SECOND)], ["q", "k", "m"], ["a"])
    return mechanics.check(SCENE, rates, blame=False).judged


def test_accelerations_are_proved():
    assert {one.finding.verdict for one in judged(FIRST)} == {Verdict.PROVED}


@pytest.mark.parametrize("large", [K / M, Q[0], K * Q[1]])
def test_what_is_lost_in_doubles_is_not_proved(large):
    first, _ = judged((FIRST + 2e25 * large / 2) - 4e25 * large / 4)
    assert first.finding.verdict is Verdict.UNDECIDED
    assert "computed in doubles, output 1 is" in first.finding.evidence


def test_entries_are_compared_row_by_row():
    forces = casadi.vertcat(casadi.horzcat(3 * M, 0), casadi.horzcat(0, 2 * M))
    mass = casadi.Function("mass_matrix", [M], [forces], ["m"], ["M"])
    found = mechanics.check(SCENE, mass, blame=False).judged
    assert "doubles" not in " ".join(map(str, found))

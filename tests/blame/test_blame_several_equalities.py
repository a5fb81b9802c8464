"""Statements of several equalities: each wrong one gets its edit, in one repair."""

from collections.abc import Callable

import pytest

import mechanics
from mechanics.blame.result import Mistake
from mechanics.equations import Equations

MATRIX = "[M + 2*m, M*L/2*cos(theta); M*L/2*sin(theta), M*L^2/3]"
SIDES = "V = k*x^2 - M*g*L/2*sin(theta) = k*x^2 + M*g*L/2*cos(theta)"


@pytest.mark.parametrize(
    ("text", "mended"),
    [
        (MATRIX, "[M + m, M*L/2*cos(theta); M*L/2*cos(theta), M*L^2/3]"),
        (SIDES, "V = k*x^2 - M*g*L/2*cos(theta) = k*x^2 - M*g*L/2*cos(theta)"),
    ],
)
def test_each_equality_gets_its_edit(
    truth_of: Callable[[str], Equations], text: str, mended: str
) -> None:
    (entry,) = mechanics.check(truth_of("elastic_pendulum"), text).judged
    assert entry.finding.verdict.name == "REFUTED"
    assert entry.blame is not None
    first, *_ = entry.blame.repairs
    assert first.finding.shown
    assert first.repaired == mended
    assert len(first.edits) == 2
    assert {edit.mistake for edit in first.edits} <= {Mistake.FACTOR, Mistake.FUNCTION,
                                                      Mistake.SIGN}  # fmt: skip

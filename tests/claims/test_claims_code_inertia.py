"""Code that is given an inertia as a matrix: of a body about its principal axes."""

from pathlib import Path

import pytest

import mechanics
from benchmarks.corpus.free_bodies import turning_body
from mechanics.judge.check import derived

BODY = derived(turning_body("w1 w2 w3", "I1:kg*m^2 I2:kg*m^2 I3:kg*m^2", name="body"))
CODE = """
function dw = rates(w, I)
a = I(1,1); b = I(2,2); c = I(3,3);
dw = [(b - c)/a*w(2)*w(3); (c - a)/b*w(3)*w(1); (a - b)/c*w(1)*w(2)];
end
"""


@pytest.mark.parametrize(
    ("right", "wrong", "expected"),
    [
        ("", "", ["PROVED"] * 3),
        ("(c - a)/b", "(a - c)/b", ["PROVED", "REFUTED", "PROVED"]),
        ("(c - a)/b", "(c - a)/a", ["PROVED", "REFUTED", "PROVED"]),
    ],
)
def test_a_matrix_of_inertia_is_that_about_principal_axes(
    tmp_path: Path, right: str, wrong: str, expected: list[str]
) -> None:
    path = tmp_path / "rates.m"
    path.write_text(CODE.replace(right, wrong) if right else CODE)
    found = mechanics.check(BODY, path, blame=False)
    assert [entry.finding.verdict.name for entry in found.judged] == expected

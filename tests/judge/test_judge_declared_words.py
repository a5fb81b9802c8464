"""What comments of a function say of it counts: whose momentum it is, the order of its places."""

from pathlib import Path

import pytest

from mechanics import check
from mechanics.grading.submission import things_in
from systems import elastic_pendulum, rod_pendulum

MOMENTUM = """def angular_momentum(theta, omega, m, l):
    \"\"\"Angular momentum of the rod about the {}.\"\"\"
    return m*l**2*omega/{}
"""
MATRIX = """import numpy as np
def mass_matrix(theta, M, m, L):
    \"\"\"Mass matrix for q = ({}).\"\"\"
    c = M*L/2*np.cos(theta)
    return np.array([[M + m, c], [c, M*L**2/3]])
"""


@pytest.mark.parametrize(
    ("point", "divisor", "verdict"),
    [
        ("pivot", 3, "PROVED"),
        ("pivot", 12, "UNDECIDED"),
        ("mass centre", 12, "PROVED"),
        ("mass centre", 3, "UNDECIDED"),
    ],
)
def test_a_momentum_is_about_the_point_of_its_comment(
    point: str, divisor: int, verdict: str, tmp_path: Path
) -> None:
    path = tmp_path / "rod.py"
    path.write_text(MOMENTUM.format(point, divisor))
    found = check(rod_pendulum.scene(), things_in(path, run_python=True), blame=False)
    assert found.verdict.name == verdict


@pytest.mark.parametrize(("order", "verdict"), [("x, theta", "PROVED"), ("theta, x", "UNDECIDED")])
def test_a_mass_matrix_has_the_order_of_its_comment(
    order: str, verdict: str, tmp_path: Path
) -> None:
    path = tmp_path / "support.py"
    path.write_text(MATRIX.format(order))
    found = check(elastic_pendulum.scene(), things_in(path, run_python=True), blame=False)
    assert found.verdict.name == verdict

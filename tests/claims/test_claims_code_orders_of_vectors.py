"""Coordinates, speeds and accelerations in vectors are in one order, which the code's names say."""

# mypy: disable-error-code="no-untyped-def"

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from mechanics import check
from mechanics.errors import InputError
from mechanics.grading.submission import things_in
from mechanics.kernel import Verdict
from systems import acrobot, two_mass_chain


def parts(theta1, theta2, theta1_dot, theta2_dot, tau, m1, m2, l1, lc1, lc2, I1, I2, g):
    """The accelerations of both links, the first one first."""
    d1 = m1 * lc1**2 + m2 * (l1**2 + lc2**2 + 2 * l1 * lc2 * np.cos(theta2)) + I1 + I2
    d2 = m2 * (lc2**2 + l1 * lc2 * np.cos(theta2)) + I2
    d3 = m2 * lc2**2 + I2
    p2 = m2 * lc2 * g * np.sin(theta1 + theta2)
    turning = m2 * l1 * lc2 * np.sin(theta2)
    p1 = (m1 * lc1 + m2 * l1) * g * np.sin(theta1) + p2
    p1 = p1 - turning * (theta2_dot**2 + 2 * theta1_dot * theta2_dot)
    rest = np.array([-p1, tau - turning * theta1_dot**2 - p2])
    return np.linalg.solve(np.array([[d1, d2], [d2, d3]]), rest)


def ours(q, qd, tau, m1, m2, l1, lc1, lc2, I1, I2, g):
    theta1, theta2 = q
    theta1_dot, theta2_dot = qd
    return parts(theta1, theta2, theta1_dot, theta2_dot, tau, m1, m2, l1, lc1, lc2, I1, I2, g)


def other(q, qd, tau, m1, m2, l1, lc1, lc2, I1, I2, g):
    theta2, theta1 = q
    theta2_dot, theta1_dot = qd
    a = parts(theta1, theta2, theta1_dot, theta2_dot, tau, m1, m2, l1, lc1, lc2, I1, I2, g)
    return np.array([a[1], a[0]])


def exchanged(q, qd, tau, m1, m2, l1, lc1, lc2, I1, I2, g):
    theta2, theta1 = q
    theta2_dot, theta1_dot = qd
    return parts(theta1, theta2, theta1_dot, theta2_dot, tau, m1, m2, l1, lc1, lc2, I1, I2, g)


def mixed(q, qd, tau, m1, m2, l1, lc1, lc2, I1, I2, g):
    theta2, theta1 = q
    theta1_dot, theta2_dot = qd
    return parts(theta1, theta2, theta1_dot, theta2_dot, tau, m1, m2, l1, lc1, lc2, I1, I2, g)


@pytest.mark.parametrize(
    ("code", "expected"),
    [(ours, Verdict.PROVED), (other, Verdict.PROVED), (exchanged, Verdict.REFUTED)],
)
def test_accelerations_come_in_the_order_of_the_coordinates(
    code: Callable[..., object], expected: Verdict
) -> None:
    assert check(acrobot.scene(), code, blame=False).verdict is expected


def test_two_orders_are_refused() -> None:
    with pytest.raises(InputError, match="say in which order they are"):
        check(acrobot.scene(), mixed, blame=False)


def inertia_ours(q, m1, m2, l1, lc1, lc2, I1, I2):
    theta1, theta2 = q  # noqa: RUF059  (its name says the order)
    inner = m2 * (lc2**2 + l1 * lc2 * np.cos(theta2)) + I2
    outer = m1 * lc1**2 + m2 * (l1**2 + lc2**2 + 2 * l1 * lc2 * np.cos(theta2)) + I1 + I2
    return np.array([[outer, inner], [inner, m2 * lc2**2 + I2]])


def inertia_exchanged(q, m1, m2, l1, lc1, lc2, I1, I2):
    theta2, theta1 = q
    return inertia_ours([theta1, theta2], m1, m2, l1, lc1, lc2, I1, I2)


@pytest.mark.parametrize(
    ("code", "expected"),
    [
        (inertia_ours, Verdict.PROVED),
        (inertia_exchanged, Verdict.REFUTED),
    ],
)
def test_a_mass_matrix_is_in_the_order_of_the_coordinates(
    code: Callable[..., object], expected: Verdict
) -> None:
    answer = check(acrobot.scene(), code, about="mass matrix", blame=False)
    assert answer.verdict is expected


WHOLE = """import numpy as np

def rates(z, m, k):
    # z = [{names}]
    A = np.array([{rows}])
    return A @ z
"""
IN_BLOCKS = ("0, 0, 1, 0", "0, 0, 0, 1", "-2*k/(3*m), k/(3*m), 0, 0", "k/(2*m), -k/(2*m), 0, 0")
IN_PAIRS = ("0, 1, 0, 0", "-2*k/(3*m), 0, k/(3*m), 0", "0, 0, 0, 1", "k/(2*m), 0, -k/(2*m), 0")
FROM_BELOW = ("0, 0, 1, 0", "0, 0, 0, 1", "-k/(2*m), k/(2*m), 0, 0", "k/(3*m), -2*k/(3*m), 0, 0")


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("names", "own"),
    [
        ("x1, x2, x1_dot, x2_dot", IN_BLOCKS),
        ("x1, x1_dot, x2, x2_dot", IN_PAIRS),
        ("x1 v1 x2 v2", IN_PAIRS),
        ("x2, x1, x2_dot, x1_dot", FROM_BELOW),
    ],
)
def test_a_comment_says_the_order_of_a_state_that_is_used_as_a_whole(
    names: str, own: tuple[str, ...], tmp_path: Path
) -> None:
    for place, rows in enumerate((IN_BLOCKS, IN_PAIRS, FROM_BELOW)):
        path = tmp_path / f"rates{place}.py"
        path.write_text(WHOLE.format(names=names, rows=", ".join(f"[{row}]" for row in rows)))
        found = check(two_mass_chain.scene(), things_in(path, run_python=True), blame=False)
        assert found.verdict is (Verdict.PROVED if rows == own else Verdict.REFUTED), str(found)

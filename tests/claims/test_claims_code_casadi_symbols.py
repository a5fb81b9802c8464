"""Python functions that make CasADi's symbols themselves, and such that take columns of NumPy."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from mechanics.cli.load import run_file
from systems import rod_pendulum
from tests.verdict_of import verdict_of

SCENE = rod_pendulum.scene()
MODEL = """import casadi as ca
import numpy as np
def model(m=1.0, l=0.5, g=9.81):
    x = ca.MX.sym("x", 2)
    u = ca.MX.sym("u", 1)
    theta, rate = x[0], x[1]
    a = 3*g/(2*l)*ca.sin(theta) + 3*u[0]/(m*l**2)
    xdot = ca.vertcat(rate, a)
    return x, u, xdot
"""
COLUMNS = """import numpy as np
def model(x, u, m, l, g):
    q, rate = x[:1, :], x[1, 0]
    B = np.array([[3/(m*l**2)]])
    a = B @ u + 3*g/(2*l)*np.sin(q)
    return np.array([[rate], [a[0, 0]]])
"""


def _model(text: str, folder: Path) -> Callable[..., Any]:
    path = folder / "handed_in.py"
    path.write_text(text)
    return run_file(path).model


def _verdict(text: str, folder: Path) -> str:
    return verdict_of(SCENE, _model(text, folder))


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("", ""),
        ("MX", "SX"),
        ("import casadi as ca", "import casadi as ca\nfrom casadi import MX"),
        ("return x, u, xdot", "return {'x': x, 'u': u, 'rates': xdot}"),
        ("theta, rate = x[0], x[1]", "theta = x[0]; rate = x[1]"),
        ("(m=1.0, l=0.5, g=9.81)", "(m, l, g=9.81)"),
        ('x = ca.MX.sym("x", 2)', 'x = ca.vertcat(ca.MX.sym("theta"), ca.MX.sym("theta_dot"))'),
        (
            'x = ca.MX.sym("x", 2)\n    u = ca.MX.sym("u", 1)',
            'x = ca.vertcat(ca.SX.sym("theta"), ca.SX.sym("theta_dot"))\n    u = ca.SX.sym("u")',
        ),
    ],
)
def test_formulas_in_symbols_of_its_own_are_judged(old: str, new: str, tmp_path: Path) -> None:
    assert _verdict(MODEL.replace(old, new) if old else MODEL, tmp_path) == "PROVED"


@pytest.mark.sample(6)
@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("3*g/(2*l)", "3*g/l"),
        ("(m*l**2)", "(m*l)"),
        ("+ 3*u[0]", "- 5*u[0]"),
        ("ca.vertcat(rate, a)", "ca.vertcat(a, rate)"),
        ("ca.vertcat(rate, a)", "ca.vertcat(2*rate, a)"),
        ("theta, rate = x[0], x[1]", "theta, rate = x[1], x[0]"),
        ("return x, u, xdot", "x[0] = 2*x[0]; return x, u, xdot"),
        ('x = ca.MX.sym("x", 2)', 'x = 2*ca.MX.sym("x", 2)'),
        ('u = ca.MX.sym("u", 1)', 'u = ca.MX.sym("x", 1)'),
        ("return x, u, xdot", 'return ca.MX.sym("x", 2), u, xdot'),
        ("return x, u, xdot", "return x, u"),
        ("return x, u, xdot", "return x, xdot"),
        ("return x, u, xdot", "return x, u, 2*xdot"),
        ("    a = 3", "    m = 1.0\n    a = 3"),
        ("    a = 3", "    g = 9.81 if isinstance(g, float) else 2*g\n    a = 3"),
        ("    a = 3", "    g = g if isinstance(g, ca.MX) else 2*g\n    a = 3"),
        ("    a = 3", "    g = g*np.random.rand()\n    a = 3"),
        ("ca.sin(theta)", "(lambda t: t)(theta)"),
        ("import numpy as np", "import numpy as np\nclass ca2: sin = staticmethod(lambda t: t)"
         "\nca2.MX = ca.MX; ca2.vertcat = ca.vertcat; ca = ca2"),
        ("ca.sin(theta)", "ca.floor(theta)"),
        ("    a = 3", "    g = l\n    a = 3"),
    ],
)  # fmt: skip
def test_what_is_wrong_in_symbols_of_its_own_is_not_proved(
    old: str, new: str, tmp_path: Path
) -> None:
    assert old in MODEL
    assert _verdict(MODEL.replace(old, new), tmp_path) in ("REFUTED", "UNDECIDED", "not read")


@pytest.mark.parametrize("old", ["3*g/(2*l)", "+ 3*u[0]"])
def test_a_wrong_term_in_symbols_of_its_own_is_refuted(old: str, tmp_path: Path) -> None:
    assert _verdict(MODEL.replace(old, f"{old[:-1]}{old[-1]}*m"), tmp_path) == "REFUTED"


@pytest.mark.parametrize(
    ("old", "new"), [("", ""), ("x[:1, :]", "x[0:1, :]"), ("x[1, 0]", "x[-1, 0]")]
)
def test_a_column_is_one(old: str, new: str, tmp_path: Path) -> None:
    assert _verdict(COLUMNS.replace(old, new) if old else COLUMNS, tmp_path) == "PROVED"


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("3*g/(2*l)", "3*g/l"),
        ("x[:1, :], x[1, 0]", "x[1:, :], x[0, 0]"),
        ("x[:1, :], x[1, 0]", "x[:1, :], x[0, 1]"),
        ("x[:1, :], x[1, 0]", "x[:1, :], x[1]"),
        ("[[rate], [a[0, 0]]]", "[[a[0, 0]], [rate]]"),
        ("    B =", "    x = x.T\n    B ="),
        ("    B =", "    x[1, 0] = 0\n    B ="),
        ("    q, rate", "    x = x[::-1]\n    q, rate"),
        ("    q, rate", "    x *= 2\n    q, rate"),
        ("np.sin(q)", "np.sin(x[1:, :])"),
        ("B @ u", "B @ x"),
        ("x[:1, :]", "x[None, 0]"),
    ],
)
def test_what_is_wrong_in_columns_is_not_proved(old: str, new: str, tmp_path: Path) -> None:
    assert old in COLUMNS
    assert _verdict(COLUMNS.replace(old, new), tmp_path) in ("REFUTED", "UNDECIDED", "not read")


TOGETHER = """import casadi as ca
def model(m=1.0, l=2.0, g=9.81):
    angle, rate, u = ca.KIND.sym("theta"), ca.KIND.sym("theta_dot"), ca.KIND.sym("u")
    x = ca.vertcat(ORDER)
    acceleration = 3*g/(2*l)*ca.sin(angle) + 3*u/(m*l**2)
    return x, u, ca.vertcat(RATES)
"""


@pytest.mark.parametrize("kind", ["MX", "SX"])
def test_what_is_put_together_is_a_state_in_that_order(kind: str, tmp_path: Path) -> None:
    for order, rates, verdict in (
        ("angle, rate", "rate, acceleration", "PROVED"),
        ("rate, angle", "acceleration, rate", "PROVED"),
        ("rate, angle", "rate, acceleration", "REFUTED"),
        ("angle, rate", "acceleration, rate", "REFUTED"),
    ):
        text = TOGETHER.replace("KIND", kind).replace("ORDER", order).replace("RATES", rates)
        assert _verdict(text, tmp_path) == verdict

"""What a file makes of a judged function of CasADi's, once more; anything else is named."""

from pathlib import Path

import pytest

from mechanics import check
from mechanics.errors import InputError
from mechanics.grading.submission import things_in
from systems import rod_pendulum

MODEL = """import casadi as ca
def model(m=1.0, l=0.5, g=9.81):
    x = ca.MX.sym("x", 2)
    u = ca.MX.sym("u", 1)
    a = 3*g/(2*l)*ca.sin(x[0]) + 3*u[0]/(m*l**2)
    return x, u, ca.vertcat(x[1], a)
x, u, xdot = model()
f = ca.Function("f", [x, u], [xdot])
"""


def _found(text: str, folder: Path) -> str:
    path = folder / "own.py"
    path.write_text(text)
    try:
        found = check(rod_pendulum.scene(), things_in(path, run_python=True), blame=False)
    except InputError:
        return "not read"
    return found.verdict.name


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("", ""), ('f = ca.Function("f", [x, u], [xdot])\n', ""), ("[x, u]", "[u, x]"),
        ("import casadi as ca", "import casadi as ca\nfrom casadi import Function"),
        ("[xdot])\n", "[xdot])\nprint(f([0.1, 0.2], 0.3))\n"),
    ],
)  # fmt: skip
def test_a_function_of_what_was_returned_says_nothing_else(
    old: str, new: str, tmp_path: Path
) -> None:
    assert old in MODEL
    text = MODEL.replace(old, new, 1)
    assert _found(text, tmp_path) == "PROVED"
    for right, wrong in (("3*g/(2*l)", "3*g/l"), ("m*l**2", "m*l")):
        assert _found(text.replace(right, wrong), tmp_path) == "REFUTED"


@pytest.mark.sample(6)
@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("[xdot]", "[-xdot]"), ("[xdot]", "[2*xdot]"), ("[x, u]", "[x, u + 1]"),
        ("[x, u]", "[ca.MX.sym('x', 2), u], [xdot]); f = ca.Function('f', [x, u]"),
        ("f = ca", "xdot[1] = 0\nf = ca"), ("f = ca", "xdot = -xdot\nf = ca"),
        ("f = ca", "def spoil(v):\n    v[1] = 0\nspoil(xdot)\nf = ca"),
        ("f = ca", "def spoil():\n    xdot[1] = 0\nspoil()\nf = ca"),
        ("f = ca", "class A:\n    xdot[1] = 0\nf = ca"),
        ("f = ca", "class A:\n    def spoil(self):\n        xdot[1] = 0\nA().spoil()\nf = ca"),
        ("f = ca", "(lambda v: v.__setitem__(1, 0))(xdot)\nf = ca"),
        ("f = ca", "for v in (x, xdot):\n    v[1] = 0\nf = ca"),
        ("f = ca", "globals()['xdot'][1] = 0\nf = ca"),
        ("[xdot])\n", "[xdot])\nf = ca.Function('f', [x, u], [-xdot])\n"),
        ("[xdot])\n", "[xdot])\ng = ca.Function('g', [x, u], [-f(x, u)])\n"),
        ("f = ca.Function", "f = ca.integrator"), ("f = ca", "y = -xdot\nf = ca"),
        ("x, u, xdot = model()", "x, u, xdot = model()\nxdot = ca.vertcat(x[1], x[0])"),
    ],
)  # fmt: skip
def test_what_says_something_else_is_named(old: str, new: str, tmp_path: Path) -> None:
    assert old in MODEL
    assert _found(MODEL.replace(old, new, 1), tmp_path) not in ("PROVED", "CERTIFIED")

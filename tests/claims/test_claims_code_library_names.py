"""Solvers are known by what they are, not by what a file calls them."""

import pytest

from mechanics.claims.code.around.python_lines import lines_around
from mechanics.claims.names import Match, Naming, Vocabulary
from systems import rod_pendulum

NAMING = Naming(
    Vocabulary(rod_pendulum.scene()),
    {},
    (Match("y", "theta theta_dot", "the usual name of such a vector"),),
)
FILE = """import numpy as np
{}
def rate(t, y, u=0.0, m=1.0, l=1.0, g=9.81):
    return [y[1], 3*g/(2*l)*np.sin(y[0]) + 3*u/(m*l**2)]
sol = {}
"""
ODEINT = "(rate, [0.3, 0.0], np.linspace(0, 10, 100){})"
IVP = "(rate, (0, 10), [0.3, 0.0])"

BOUND = [
    ("from scipy.integrate import odeint as solve_ivp", "solve_ivp"),
    ("import scipy.integrate as si\nsolve = si.odeint", "solve"),
    ("from scipy.integrate import odeint\nsolve_ivp = odeint", "solve_ivp"),
    ("from scipy import integrate as solve", "solve.odeint"),
]


@pytest.mark.parametrize(("lines", "name"), BOUND)
def test_odeint_hands_the_state_first_by_every_name(lines: str, name: str) -> None:
    wrong = FILE.format(lines, name + ODEINT.format(""))
    right = FILE.format(lines, name + ODEINT.format(", tfirst=True"))
    assert lines_around(wrong, {"rate"}, NAMING) == (wrong.splitlines()[-1],)
    assert lines_around(right, {"rate"}, NAMING) == ()


@pytest.mark.parametrize(
    "lines",
    [
        "from scipy.integrate import solve_ivp",
        "from scipy.integrate import solve_ivp as solve_ivp",
        "from scipy.integrate import *",
        "import scipy.integrate\nsolve_ivp = scipy.integrate.solve_ivp",
    ],
)
def test_a_solver_of_scipy_is_silent(lines: str) -> None:
    assert lines_around(FILE.format(lines, "solve_ivp" + IVP), {"rate"}, NAMING) == ()


@pytest.mark.parametrize(
    "lines",
    [
        "from other import solve_ivp",
        "from .other import solve_ivp",
        "from other import *",
        "import scipy.integrate as si\nsolve_ivp = getattr(si, 'odeint')",
        "from functools import partial\nsolve_ivp = partial(print)",
        "try:\n    from other import solve_ivp\nexcept ImportError:\n"
        "    from scipy.integrate import solve_ivp",
    ],
)
def test_what_only_has_the_name_of_a_solver_is_quoted(lines: str) -> None:
    text = FILE.format(lines, "solve_ivp" + IVP)
    assert lines_around(text, {"rate"}, NAMING) == ("sol = solve_ivp" + IVP,)


def test_a_solver_of_another_module_is_quoted() -> None:
    text = FILE.format("import other", "other.solve_ivp" + IVP)
    assert lines_around(text, {"rate"}, NAMING) == ("sol = other.solve_ivp" + IVP,)

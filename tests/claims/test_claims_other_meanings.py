"""What looks like the scene's and means something else is not read as the scene's."""

import casadi as ca
import pytest
import sympy
from sympy import Dummy, Eq, Symbol

import mechanics
from mechanics.claims.code.translation.matlab import Unread, in_python
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from systems import double_pendulum, rod_pendulum

ROD = rod_pendulum.scene()
T = sympy.Symbol("t")
theta, u = (sympy.Function(name)(T) for name in ("theta", "u"))
m, g, l = sympy.symbols("m g l")


def verdict(thing: object) -> Verdict:
    return mechanics.check(ROD, thing, blame=False).verdict


def test_two_symbols_of_one_name_are_not_one() -> None:
    right = 3 * g / (2 * l) * sympy.sin(theta) + 3 * u / (m * l**2)
    assert verdict(Eq(theta.diff(T, 2), right)) is Verdict.PROVED
    for other in (Dummy("l"), Symbol("l", real=True)):
        assert verdict(Eq(theta.diff(T, 2), right + other - l)) is not Verdict.PROVED


def test_a_function_that_is_called_a_sine_is_not_one() -> None:
    own = type("sin", (sympy.Function,), {"__module__": "mine"})
    right = 3 * g / (2 * l) * own(theta) + 3 * u / (m * l**2)
    assert verdict(Eq(theta.diff(T, 2), right)) is Verdict.UNDECIDED


def test_a_determinant_is_no_matrix() -> None:
    rows = r"{vmatrix}(m_1+m_2)l_1 & m_2 l_2\\ l_1 & l_2\end{vmatrix}"
    column = r"{pmatrix}\ddot\phi_1\\ \ddot\phi_2\end{pmatrix}"
    text = rf"$$\begin{rows}\begin{column} = \begin{{pmatrix}}0\\0\end{{pmatrix}}$$"
    with pytest.raises(InputError, match="determinant"):
        mechanics.check(double_pendulum.scene(), text, blame=False)


def test_a_loop_through_a_column_is_not_read() -> None:
    text = "function a = f(x)\na = x;\nfor c = {}, a = a + c; end\nend\n"
    (function,) = in_python(text.format("1:3"), "page.m", set().__contains__).functions
    assert function(x=1.0) == 7.0
    with pytest.raises(Unread, match="columns"):
        in_python(text.format("[x; 2*x]"), "page.m", set().__contains__)


def test_a_model_whose_parts_are_changed_is_not_shown() -> None:
    base = """model Base
  parameter Real m, l, g; Real theta, w; input Real u;
equation
  der(theta) = w;
  der(w) = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2);
end Base;
"""
    rod = """model Rod
  parameter Real m, l, g; input Real u;
  Base b(m=m, l=2*l, g=g, u=u);
end Rod;"""
    assert verdict(base) is Verdict.PROVED
    with pytest.raises(InputError, match="parts of a model"):
        verdict(base + rod)
    assert verdict(base + rod.replace("\n", " ")) is Verdict.UNDECIDED


def test_a_function_that_solves_inside_is_refused_in_one_line() -> None:
    x = ca.MX.sym("x", 2)
    matrix = ca.vertcat(ca.horzcat(1 + x[0], x[1]), ca.horzcat(x[1], 2 + x[0]))
    solved = ca.Function("f", [x], [ca.solve(matrix, x)], ["x"], ["y"])
    with pytest.raises(InputError, match="cannot be expanded"):
        verdict(solved)

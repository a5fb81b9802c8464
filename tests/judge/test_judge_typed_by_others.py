"""What authors typed, in the forms of their trade: read as they meant it, refuted when wrong."""

from math import cos, sin

import pytest

from benchmarks.corpus.load import HERE, scene_of
from mechanics import check
from mechanics.scene import Scene
from tests.notation_scenes import judged

TYPED = HERE / "scenes" / "typed.py"


def scene(name: str) -> Scene:
    return scene_of(TYPED, name)


def verdict(name: str, text: str, **options: object) -> str:
    return check(scene(name), text, blame=False, **options).verdict.name  # type: ignore[arg-type]


MODELICA = """model Pendulum "swings"
  parameter Real m = 1, l = 1, g = 9.81; // mass, length, gravity
  input Real u;
  Real th(start = 1);
  Real thdot;
equation
  der(th) = thdot; // the rate
  der(thdot) = (u - m*g*l*sin(th))/(m*l^2);
end Pendulum;
"""

GSL = """#include <math.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
int func(double t, const double y[], double f[], void *params) {
  (void)t;
  double *p = (double *)params;
  double m = p[0], l = p[1], g = p[2], b = p[3];
  f[0] = y[1];
  f[1] = -g/l*sin(y[0]) - b/(m*l*l)*y[1];
  return GSL_SUCCESS;
}
"""

STATE = """function dy = robot(t, y)
theta = y(1);
v = y(2);
w = y(3);
J = (Mr+Mp)*r^2+Ir;
k = Mp*r*l*cos(theta);
h = l^2*Mp+Ip;
dy(1) = v;
dy(2) = -(k*l*Mp*r*sin(theta)*v^2-g*J*l*Mp*sin(theta)+(k+J)*tau)/(J*h-k^2);
dy(3) = (h*l*Mp*r*sin(theta)*v^2-g*k*l*Mp*sin(theta)+(h+k)*tau)/(J*h-k^2);
end
"""


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("name", "text", "old", "new", "notation"),
    [
        ("driven", MODELICA, "sin(th)", "sin(th)^2", "text"),
        ("damped", GSL, "(m*l*l)", "(m*l)", "c"),
        ("two_wheels", STATE, "dy(2) = -", "dy(2) = ", "text"),
        ("rolling", r"\[ \omega = \sqrt{2g/3(R-r)} \]", "2g", "g", "latex"),
        ("atwood", "E = 1/2 (m_1 + m_2 + I/R^2) x'^2 + (m_2 - m_1) g x", "m_1)", "2 m_1)", "text"),
        ("tilted_wire", "mr''=mr(wsin(a))^2-mgcos(a)", "mg", "2mg", "text"),
    ],
)
def test_forms_of_the_trade(name: str, text: str, old: str, new: str, notation: str) -> None:
    assert verdict(name, text, notation=notation) == "PROVED"
    assert verdict(name, text.replace(old, new), notation=notation) in ("REFUTED", "UNDECIDED")


def test_what_gsl_returns_is_its_own() -> None:
    with pytest.raises(Exception, match="gsl_sf"):
        verdict("damped", GSL.replace("sin(y[0])", "gsl_sf_sin(y[0])"), notation="c")


def step(x, x_dot, theta, theta_dot, force, gravity, masscart, masspole, length, tau):
    total = masspole + masscart
    push = (force + masspole * length * theta_dot**2 * sin(theta)) / total
    turn = (gravity * sin(theta) - cos(theta) * push) / (
        length * (4 / 3 - masspole * cos(theta) ** 2 / total)
    )
    pull = push - masspole * length * turn * cos(theta) / total
    return x + tau * x_dot, x_dot + tau * pull, theta + tau * theta_dot, theta_dot + tau * turn


def test_a_step_of_a_time_that_is_called_tau() -> None:
    found = check(scene("gym"), step, blame=False)
    assert found.verdict.name == "PROVED"
    assert any("explicit Euler" in entry.statement.tag for entry in found.judged)


def test_a_number_beside_an_angle_is_that_of_its_rate() -> None:
    def rates(theta1, theta2, omega1, omega2):
        return omega1, omega2, 0 * theta1, 0 * theta2

    found = check(scene("two_equal"), rates, blame=False)
    assert [match.meaning for match in found.names[2:]] == ["theta1_dot", "theta2_dot"]


def test_a_tension_under_the_name_that_prose_gives_it() -> None:
    text = r"The tension in the rod is $F_T = mg\cos\theta {} ml\dot\theta^2$."
    assert [judged("pendulum", text.format(sign)).verdict.name for sign in "+-"] == [
        "PROVED", "REFUTED",
    ]  # fmt: skip

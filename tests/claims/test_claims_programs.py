"""Programs of people: orders of a state, held inputs, steps, and parts of models.

The equations are those of a cart-pole, a pendulum and an oscillator, solved by hand.
"""

import pytest

from mechanics.errors import InputError
from mechanics.judge.check import check, derived
from mechanics.kernel import Verdict
from systems import cartpole
from tests.notation_scenes import verdicts

CART = derived(cartpole.scene())
HELD_INPUT = """function ydot = Cart(t, xx)
F = xx(5);
s = sin(xx(1)); c = cos(xx(1));
D = (mc+mp)*4/3*mp*l^2 - (mp*l*c)^2;
ydot(1) = xx(2);
ydot(2) = ((mc+mp)*mp*g*l*s - mp*l*c*(F + mp*l*xx(2)^2*s))/D;
ydot(3) = xx(4);
ydot(4) = (4/3*mp*l^2*(F + mp*l*xx(2)^2*s) - mp^2*l^2*g*s*c)/D;
ydot(5) = 0;
"""
OWN_NAMES = """function xdot = dynamics(t, x, F)
x1 = x(1); x2 = x(2);
s = sin(x2); c = cos(x(2)); w = x(4);
D = (mc+mp)*4/3*mp*l^2 - (mp*l*c)^2;
xdot(1,:) = x(3);
xdot(2,:) = x(4);
xdot(3,:) = [4/3*mp*l^2*(F + mp*l*w^2*s) - mp^2*l^2*g*s*c]/D;
xdot(4,:) = [(mc+mp)*mp*g*l*s - mp*l*c*(F + mp*l*w^2*s)]/D;
end
"""


@pytest.mark.parametrize("text", [HELD_INPUT, OWN_NAMES], ids=["angle first", "own names"])
def test_arrays_of_a_cart_are_taken_by_what_sines_are_taken_of(text: str) -> None:
    assert check(CART, text, blame=False).verdict is Verdict.PROVED
    for right, wrong in (("4/3*mp*l^2 -", "1/3*mp*l^2 -"), ("g*s*c", "g*s"), ("*(F + ", "*(F - ")):
        assert check(CART, text.replace(right, wrong), blame=False).verdict is Verdict.REFUTED


STEP = """function zn = step(z)
h = 0.01;
th = z(1);
zn(1) = th + h*z(2);
zn(2) = z(2) - h*g/l*sin(z(1));
end
"""


def test_a_step_of_explicit_euler_is_judged_by_its_rates() -> None:
    assert set(verdicts("pendulum", STEP)) == {"PROVED"}
    columns = "function zn = step(z)\nzn = [z(1) + h*z(2); z(2) - h*g/l*sin(z(1))];\nend"
    assert set(verdicts("pendulum", columns)) == {"PROVED"}
    for right, wrong in (("sin", "cos"), ("- h", "+ h"), ("th + h*z(2)", "th + h*z(1)")):
        assert "REFUTED" in verdicts("pendulum", STEP.replace(right, wrong))


@pytest.mark.parametrize(
    ("right", "other"),
    [("+ h*z(2)", "+ h*zn(2)"), ("+ h*z(2)", "+ h*z(2) - h^2*g/(2*l)*sin(th)"), ("- h*g", "- g")],
    ids=["semi-implicit", "constant acceleration", "no step"],
)
def test_another_step_is_not_refuted(right: str, other: str) -> None:
    with pytest.raises(InputError, match="the next state, not by explicit Euler"):
        verdicts("pendulum", STEP.replace(right, other))


PARTS = """model Bench
  input Real u;
  parameter Real m, F0, omega;
  Real x, w;
  Elastic s;
  Dashpot d;
equation
  s.e = x;
  d.e = w;
  der(x) = w;
  m*der(w) = s.f + d.f + F0*cos(omega*time);
end Bench;

model Elastic
  parameter Real k;
  Real e "extension";
  Real f "force";
equation
  f = -k*e;
end Elastic;

model Dashpot
  parameter Real c;
  Real e "its rate";
  Real f "force";
equation
  f = -c*e;
end Dashpot;
"""


def test_what_parts_of_a_model_declare_is_their_own() -> None:
    assert verdicts("oscillator", PARTS) == ["PROVED"]
    for right, wrong in (("-c*e", "c*e"), ("s.f + d.f", "s.f - d.f"), ("d.e = w", "d.e = x")):
        assert "REFUTED" in verdicts("oscillator", PARTS.replace(right, wrong))


@pytest.mark.parametrize(
    ("one", "two"), [("Elastic s;", "Elastic s, r;"), ("Elastic s;", "Elastic s(k = 2);")]
)
def test_parts_that_are_not_read_refute_nothing(one: str, two: str) -> None:
    with pytest.raises(InputError, match="parts of a model that are not read"):
        verdicts("oscillator", PARTS.replace(one, two))

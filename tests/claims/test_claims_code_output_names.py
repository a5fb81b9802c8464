"""Names of several outputs say their order, in the ways in which people write them."""

from pathlib import Path

import pytest
from notation_scenes import truth

from mechanics import check
from mechanics.claims.code.output_names import coordinates_of, orders_by_names, unknown_words
from mechanics.errors import InputError
from mechanics.grading.submission import things_in
from systems import acrobot, cartpole, double_pendulum

CART, PENDULA = cartpole.scene(), double_pendulum.scene()

OF_TWO_KINDS = (
    "xdd,thdd x_dd,th_dd xddot,thddot x_ddot,th_ddot xDDot,thetaDDot x_acc,th_acc"
    " ax,alpha a,alpha cart_acc,pole_acc cartAcceleration,poleAcceleration"
    " acc_cart,acc_pole linear_acc,angular_acc ddx,ddth xpp,tpp vdot,omegadot"
    " v_dot,omega_dot dv,domega dv,dw x2,theta2dot x_double_dot,theta_double_dot"
    " qdd_x,qdd_theta x_ddot,other xDdot,thetaDdot"
    " xdot_update,thetadot_update"
)
OF_ONE_KIND = (
    "a1,a2 alpha1,alpha2 w1_dot,w2_dot w1dot,w2dot dw1,dw2 wd1,wd2 domega1,domega2"
    " th1dd,th2dd phi1pp,phi2pp acc1,acc2 ang_acc_1,ang_acc_2 upper,lower"
    " acc_upper,acc_lower first,second q1dd,q2dd ddq1,ddq2 qdd0,qdd1 d2phi1,d2phi2"
    " tau_1,tau_2 shoulder,elbow torque1,torque2"
)


@pytest.mark.parametrize(
    ("scene", "names"),
    [
        *((CART, names) for names in OF_TWO_KINDS.split()),
        *((PENDULA, names) for names in OF_ONE_KIND.split()),
    ],
)
def test_names_leave_one_order(scene: object, names: str) -> None:
    pair = names.split(",")
    for some, order in ((pair, scene.q), (pair[::-1], scene.q[::-1])):
        assert list(orders_by_names(scene, some, [None, None])) == [tuple(order)]


@pytest.mark.parametrize("names", ["o0,o1", "out1,out2", "a,b", "u,v", "row1,row2", "eqs,rest"])
def test_other_names_leave_all(names: str) -> None:
    assert len(list(orders_by_names(CART, names.split(","), [None, None]))) == 2


def test_names_of_a_state_are_each_of_a_coordinate() -> None:
    x, theta = ({q} for q in CART.q)
    assert list(coordinates_of(CART, ["dx", "dtheta", "dv", "dw"])) == [x, theta, x, theta]
    assert all(len(hint) == 2 for hint in coordinates_of(CART, ["dx1", "dx2", "dx3", "dx4"]))


def test_words_that_the_scene_does_not_have_are_unknown() -> None:
    assert unknown_words(CART, ["trolley_acc", "load_acc"])
    for names in (["cart_acc", "pole_acc"], ["out1", "out2"], ["a", "b"], ["acc"], ["res", "val"]):
        assert not unknown_words(CART, names)


PYTHON = """import numpy as np
def accel(theta, theta_dot, F, mc, mp, l, g):
    A = np.array([[mc+mp, mp*l*np.cos(theta)], [np.cos(theta), 4/3*l]])
    b = np.array([F + mp*l*theta_dot**2*np.sin(theta), g*np.sin(theta)])
    a = np.linalg.solve(A, b)
    {} = {}
    return {}
"""
C = """#include <math.h>
void accel(double theta, double theta_dot, double F, double mc, double mp, double l, double g,
           double *{}, double *{}) {{
    double s = sin(theta), c = cos(theta), d = (mc + mp)*4.0/3*l - mp*l*c*c;
    double f = F + mp*l*theta_dot*theta_dot*s;
    *{} = (4.0/3*l*f - mp*l*c*g*s)/d;
    *{} = ((mc + mp)*g*s - c*f)/d;
}}
"""
MATLAB = """function [{}] = accel(theta, theta_dot, F, mc, mp, l, g)
s = [mc+mp, mp*l*cos(theta); cos(theta), 4/3*l] \\ [F + mp*l*theta_dot^2*sin(theta); g*sin(theta)];
{} = s(1);
{} = s(2);
end
"""


@pytest.mark.sample(4)
@pytest.mark.parametrize("language", ["python", "c", "matlab"])
@pytest.mark.parametrize("names", OF_TWO_KINDS.split())
def test_accelerations_are_those_of_their_names(names: str, language: str, tmp_path: Path) -> None:
    one, other = names.split(",")
    for first, second, right in ((one, other, True), (other, one, False)):
        pair = f"{first}, {second}"
        text, suffix = {
            "python": (PYTHON.format(pair, "a", pair), ".py"),
            "c": (C.format(first, second, first, second), ".c"),
            "matlab": (MATLAB.format(pair, first, second), ".m"),
        }[language]
        path = tmp_path / f"cart{suffix}"
        path.write_text(text)
        found = check(CART, things_in(path, run_python=True), blame=False)
        assert found.ok is right, f"{pair}: {found}"


def test_words_that_are_unknown_leave_an_exchange_open(tmp_path: Path) -> None:
    """Dimensions alone would say which is which, against the words."""
    path = tmp_path / "cart.py"
    for values, verdict in (("a", "PROVED"), ("a[::-1]", "UNDECIDED")):
        pair = "trolley_acc, load_acc"
        path.write_text(PYTHON.format(pair, values, pair))
        found = check(CART, things_in(path, run_python=True), blame=False)
        assert found.verdict.name == verdict


@pytest.mark.parametrize(
    ("comment", "verdict"),
    [
        ("Returns xdd and thdd.", "PROVED"),
        ("theta_ddot, x_ddot", "UNDECIDED"),
        ("thdd and xdd", "UNDECIDED"),
        ("theta'', x''.", "UNDECIDED"),
        ("x'' and theta''.", "PROVED"),
        ("of theta, x", "PROVED"),
        ("Solve for thdd and xdd by Cramer's rule.", "PROVED"),
    ],
)
def test_a_comment_that_lists_outputs_has_their_order(
    comment: str, verdict: str, tmp_path: Path
) -> None:
    path = tmp_path / "cart.py"
    text = PYTHON.format("xdd, thdd", "a", "xdd, thdd")
    path.write_text(text.replace("    A = ", f'    """{comment}"""\n    A = ', 1))
    found = check(CART, things_in(path, run_python=True), blame=False)
    assert found.verdict.name == verdict


@pytest.mark.parametrize(
    ("title", "verdict"),
    [("xdd_thdd", "PROVED"), ("thdd_xdd", "UNDECIDED"), ("theta_ddot_x_ddot", "PROVED")],
)
def test_a_name_that_lists_outputs_has_their_order(
    title: str, verdict: str, tmp_path: Path
) -> None:
    path = tmp_path / "cart.py"
    path.write_text(PYTHON.format("xdd, thdd", "a", "xdd, thdd").replace("accel", title))
    found = check(CART, things_in(path, run_python=True), blame=False)
    assert found.verdict.name == verdict


TORQUES = """from math import cos, sin
def inverse(theta1, theta2, w1, w2, theta1_ddot, theta2_ddot, m1, m2, l1, l2, g):
    c2, s2 = cos(theta2), sin(theta2)
    elbow = (m2*l2**2*(theta1_ddot + theta2_ddot) + m2*l1*l2*(c2*theta1_ddot + s2*w1**2)
             + m2*l2*g*cos(theta1 + theta2))
    shoulder = (elbow + (m1 + m2)*l1**2*theta1_ddot + (m1 + m2)*l1*g*cos(theta1)
                + m2*l1*l2*(c2*(theta1_ddot + theta2_ddot) - s2*(w1 + w2)**2))
    {} = shoulder, elbow
    return {}
"""


@pytest.mark.parametrize(
    "names", ["tau_1, tau_2", "t1, t2", "T1, T2", "torque1, torque2", "u1, u2", "one, two"]
)
def test_torques_are_those_of_their_names(names: str, tmp_path: Path) -> None:
    path = tmp_path / "arm.py"
    back = ", ".join(names.split(", ")[::-1])
    for made, right in ((names, True), (back, False)):
        path.write_text(TORQUES.format(made, made))
        found = check(truth("arm"), things_in(path, run_python=True), blame=False)
        assert found.ok is right, f"{made}: {found}"


def test_tensions_are_no_residuals() -> None:
    code = (
        "void forces(double theta1, double theta1_ddot, double m2, double g,"
        " double *tension1, double *tension2) {"
        " *tension1 = m2*(g - theta1_ddot); *tension2 = m2*(g + theta1_ddot); }"
    )
    with pytest.raises(InputError, match="say what"):
        check(acrobot.scene(), code, notation="c")

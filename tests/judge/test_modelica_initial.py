"""An initial section that says what a name is defines it; where a motion begins is no equation."""

import pytest

import mechanics
from mechanics.kernel import Verdict
from systems import bead_on_hoop

SCENE = bead_on_hoop.scene()
ROW = "der(w) = (omega^2*cos(theta) - {force})*sin(theta);"


def verdicts(declared: str, initial: str, force: str, beside: str = "") -> list[Verdict]:
    text = f"model B\n  Real theta, w; parameter Real g, omega{declared}\n{initial}\nequation\n"
    text += f"  der(theta) = w;\n{beside}  {ROW.format(force=force)}\nend B;\n"
    return [one.finding.verdict for one in mechanics.check(SCENE, text, blame=False).judged]


FREE = ", R; parameter Real r(fixed = false);"


@pytest.mark.parametrize(
    ("declared", "initial"),
    [
        (FREE, "initial equation\n  r = 2*R;"),
        (FREE, "initial algorithm\n  r := 2*R;"),
        (FREE, "initial equation\n  r - R = R;"),
        (FREE, ""),
        (", R; Real r;", "initial equation\n  r = 2*R;"),
        (", R; Real r;", "algorithm\n  r := 2*R;"),
        (", R; Real r;", "algorithm\n  r := R; r := 2*r;"),
    ],
)
def test_another_radius_is_not_taken_for_the_hoops(declared, initial):
    assert Verdict.PROVED not in verdicts(declared, initial, "g/r")


@pytest.mark.parametrize(
    ("declared", "initial"),
    [
        (FREE, "initial equation\n  r = R;"),
        (FREE, "initial algorithm\n  r := R;"),
        (", R; Real r;", "algorithm\n  r := R;"),
    ],
)
def test_the_radius_by_another_name_is_the_radius(declared, initial):
    assert verdicts(declared, initial, "g/r") == [Verdict.PROVED]


@pytest.mark.parametrize(
    ("initial", "beside"),
    [
        ("initial equation\n  theta = 0.1; der(theta) = 0;", ""),
        ("initial equation\n  w = 0;\n  theta = 0.1;", ""),
        ("initial equation\n  a = 0;", "  a = der(w);\n"),
        ("initial equation\n  a = 0;", "  der(w) = a;\n"),
    ],
)
def test_where_a_motion_begins_is_no_equation(initial, beside):
    assert {*verdicts(", R; Real a;", initial, "g/R", beside)} == {Verdict.PROVED}


def test_what_an_equation_only_uses_is_defined_at_the_begin():
    text = (
        "model B\n  Real theta, w, torque; parameter Real R, g, omega;\n"
        "initial equation\n  torque = 2*g/R*sin(theta);\nequation\n  der(theta) = w;\n"
        "  omega^2*cos(theta)*sin(theta) - der(w) = torque;\nend B;\n"
    )
    (found,) = mechanics.check(SCENE, text, blame=False).judged
    assert found.finding.verdict is not Verdict.PROVED

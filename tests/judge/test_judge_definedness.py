"""Where what was written has a value: the rows of the table, in every form.

Each statement is that of a rod pendulum; what is added is zero where it has a value, and what
stands for the angle is theta there.
"""

import json
import math

import casadi
import numpy as np
import pytest
import sympy
from rod_statements import (
    LATEX,
    ROD,
    C,
    of_c,
    of_casadi,
    of_latex,
    of_python,
    of_sympy,
    of_text,
    outcome,
)
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
from typer.testing import CliRunner

import mechanics
from mechanics.cli.app import app
from mechanics.judge.check_json import to_json
from mechanics.scene import force

FORMS = {
    "text": lambda: of_text("sqrt(theta)^2"),
    "LaTeX": lambda: of_latex(r"\sqrt{\theta}^2"),
    "LaTeX, by a definition": lambda: mechanics.check(
        ROD,
        r"$r = \sqrt{\theta}$ and "
        + "$"
        + LATEX.replace("ANGLE", "r^2").replace("TORQUE", "u").replace("MORE", "0")
        + "$",
        blame=False,
    ),
    "C": lambda: of_c("sqrt(theta)*sqrt(theta)"),
    "C, multiplied by zero": lambda: of_c("theta", more="0*sqrt(theta)"),
    "Python": lambda: of_python(lambda theta: np.sqrt(theta) ** 2),
    "CasADi": lambda: of_casadi(lambda theta: casadi.sqrt(theta) * casadi.sqrt(4 * theta) / 2),
    "SymPy": lambda: of_sympy(lambda theta: sympy.Pow(sympy.sqrt(theta), 2, evaluate=False)),
}


@pytest.mark.sample(2)
@pytest.mark.parametrize("form", FORMS)
def test_what_has_a_value_in_a_half_is_shown_there(form):
    assert outcome(FORMS[form]()) == ("UNDECIDED", "PROVED WHERE theta >= 0")


NOWHERE = {
    "text": lambda: of_text(more="sqrt(-1 - theta^2)^2 + 1 + theta^2"),
    "LaTeX": lambda: of_latex(more=r"\sqrt{-1 - \theta^2}^2 + 1 + \theta^2"),
    "C": lambda: of_c(more="sqrt(-1-theta*theta)*sqrt(-1-theta*theta) + 1 + theta*theta"),
    "Python": lambda: of_python(lambda x: x + 0 * np.log(np.where(x > 2, x, x - 1))),
    "CasADi": lambda: of_casadi(
        lambda x: x + casadi.sqrt(-1 - x * x) * casadi.sqrt(-4 - 4 * x * x) / 2 + 1 + x * x
    ),
    "C, zero by zero": lambda: of_c(more="0.0/(theta - theta)"),
    "C, beyond at rest": lambda: of_c(more="0*log(theta - 1)"),
}


@pytest.mark.parametrize("form", NOWHERE)
def test_what_has_no_value_at_rest_is_refuted(form):
    found = NOWHERE[form]()
    assert found.verdict.name == "REFUTED"
    assert "no real value" in str(found)
    assert found.judged[0].right_if == ()


@pytest.mark.parametrize(
    ("found", "domain"),
    [
        (lambda: of_text("exp(log(theta))"), "PROVED WHERE theta > 0"),
        (lambda: of_latex(r"e^{\ln\theta}"), "PROVED WHERE theta > 0"),
        (lambda: of_c("pow(theta*theta*theta, 1.0/3.0)"), "CERTIFIED WHERE theta**3 >= 0"),
        (lambda: of_casadi(lambda x: casadi.exp(casadi.log(x))), "PROVED WHERE theta > 0"),
        (lambda: of_c(more="0*acosh(1 + theta)"), "PROVED WHERE theta + 1 >= 1"),
        (lambda: of_c(more="(theta > 1 ? 0*sqrt(2 - theta) : 0)"), "PROVED WHERE 2 - theta >= 0"),
    ],
)
def test_open_sets_are_named(found, domain):
    assert outcome(found()) == ("UNDECIDED", domain)


def test_a_region_that_was_stated_is_where_it_has_to_have_a_value():
    text = "exp(log(theta))"
    assert outcome(of_text(text, where="theta > 0")) == ("PROVED", "")
    assert of_text(text, where="theta < 0").verdict.name == "REFUTED"
    assert of_text(text, where="theta > -1").verdict.name == "REFUTED"


@pytest.mark.parametrize(
    ("found", "expected"),
    [
        (lambda: of_text("theta^2/theta"), ("PROVED", "except where theta = 0")),
        (lambda: of_text("theta", more="0/u"), ("PROVED", "except where u = 0")),
        (lambda: of_c("theta*theta/theta"), ("UNDECIDED", "NOT SHOWN: NaN at rest (theta = 0)")),
        (
            lambda: of_python(lambda x: x * x / x),
            ("UNDECIDED", "NOT SHOWN: NaN at rest (theta = 0)"),
        ),
        (lambda: of_c(more="tan(theta) - sin(theta)/cos(theta)"),
         ("PROVED", "except where cos(theta) = 0")),
        (lambda: of_text(more="tan(theta) - sin(theta)/cos(theta)"),
         ("PROVED", "except where cos(theta) = 0")),
        (lambda: of_c(more="0/(theta - 1)"), ("PROVED", "except where theta - 1 = 0")),
    ],
)  # fmt: skip
def test_thin_sets_are_named_and_code_has_to_have_a_value_at_rest(found, expected):
    assert outcome(found()) == expected


SILENT = {
    "a mass": lambda: of_c(more="0/(m*l*l/3 + m*theta*theta)"),
    "a modulus": lambda: of_c(more="sqrt(theta*theta) - fabs(theta)"),
    "a norm": lambda: of_c(more="0*sqrt(theta*theta + u*u)"),
    "hypot": lambda: of_c(more="0*hypot(theta, u)"),
    "arctan2": lambda: of_python(lambda x: np.arctan2(np.sin(x), np.cos(x)) * 0 + x),
    "a branch of its own": lambda: of_c("theta > 0 ? sqrt(theta)*sqrt(theta) : theta"),
    "a branch of its own in Python": lambda: of_python(
        lambda x: np.where(x == 0, x, x * x / np.where(x == 0, 1, x))
    ),
    "a guard beside": lambda: of_c(more="((theta > 0 && sqrt(theta) > 1) ? 0 : 0)"),
    "a solution": lambda: of_python(
        lambda x: x + 0 * np.linalg.solve(np.array([[2 + np.cos(x), 1], [1, 2]]), [x, 1])[0]
    ),
    "the larger one": lambda: of_c(more="0*sqrt(fmax(theta, 0))"),
    "a sinc with a guard": lambda: of_python(lambda x: x * (1 if abs(x) < 1e-8 else x / x)),
    "unused": lambda: of_python(lambda x: (np.log(x), x)[1]),
    "a root of a square sum": lambda: of_latex(more=r"0\sqrt{1 - \cos\theta}"),
}


@pytest.mark.sample(4)
@pytest.mark.parametrize("name", SILENT)
def test_realistic_right_code_passes_in_silence(name):
    found = SILENT[name]()
    assert found.ok
    assert [entry.finding.domain for entry in found.judged] == [""]


WRAPPED = {
    "C": lambda: of_c("fmod(theta, 2*3.141592653589793)"),
    "Python": lambda: of_python(lambda x: (x + np.pi) % (2 * np.pi) - np.pi),
    "NumPy": lambda: of_python(lambda x: np.fmod(x, 2 * np.pi)),
    "math": lambda: of_python(lambda x: math.fmod(x, 2 * math.pi)),
    "CasADi": lambda: of_casadi(lambda x: casadi.fmod(x, 2 * casadi.pi)),
}


@pytest.mark.parametrize("form", WRAPPED)
def test_wrapped_angles_have_the_same_sine(form):
    assert outcome(WRAPPED[form]()) == ("PROVED", "")


@pytest.mark.parametrize(
    "angle", ["fmod(theta, 3)", "fmod(theta, 2*3.141592653589793)/2 + theta/2"]
)
def test_what_is_wrapped_otherwise_is_not_shown(angle):
    assert not of_c(angle).ok


@pytest.mark.campaign
def test_code_that_reaches_a_bound_is_told_that_rounding_may_step_over_it():
    found = of_c(more="0*acos(cos(theta)*cos(theta))")
    assert outcome(found) == ("PROVED", "")
    assert found.remarks == (
        "acos(cos(theta)**2) is defined up to its bound, which it reaches: rounding may step over"
        " it",
    )
    assert of_c(more="0*acos(cos(theta)/2)").remarks == ()
    assert of_c(more="0*sqrt(theta*theta + u*u)").remarks == ()
    assert of_text(more="0*acos(cos(theta)^2)").remarks == ()


def swinging():
    """A mass that swings in a plane at a distance r, which may become 0: nobody turns there."""
    r, theta = dynamicsymbols("r theta")
    m, g = mechanics.parameters("m g", units="kg m/s^2", typical="1 10")
    ground = ReferenceFrame("N")
    arm = ground.orientnew("A", "Axis", (theta, ground.z))
    origin = Point("O")
    mass = origin.locatenew("P", -r * arm.y)
    return mechanics.Scene(
        "swinging mass", ground, origin, coordinates=(r, theta),
        bodies=(mechanics.Particle("mass", mass, m),),
        loads=(mechanics.gravity(-g * ground.y),),
    )  # fmt: skip


def attracted():
    """A mass on a line that is attracted by 1/x^2."""
    (x,) = dynamicsymbols("x,")
    m, c = mechanics.parameters("m c", units="kg N*m^2", typical="1 1")
    ground = ReferenceFrame("N")
    origin = Point("O")
    mass = origin.locatenew("P", x * ground.x)
    return mechanics.Scene(
        "attracted mass", ground, origin, coordinates=(x,),
        bodies=(mechanics.Particle("mass", mass, m),),
        loads=(force("c", mass, -c / x**2 * ground.x, on="mass"),),
    )  # fmt: skip


def test_where_the_motion_itself_is_singular_nobody_has_to_have_a_value():
    def rates(r, theta, r_dot, theta_dot, m, g):
        first = r * theta_dot**2 + g * np.cos(theta)
        return np.array([first, -(2 * r_dot * theta_dot + g * np.sin(theta)) / r])

    def solved(r, theta, r_dot, theta_dot, m, g):
        left = np.array([[m, 0], [0, m * r**2]])
        first = m * (r * theta_dot**2 + g * np.cos(theta))
        return np.linalg.solve(left, [first, -m * r * (2 * r_dot * theta_dot + g * np.sin(theta))])

    text = "theta'' = -(2*r'*theta' + g*sin(theta))/r"
    for thing in (rates, solved, text):
        found = mechanics.check(swinging(), thing, blame=False)
        assert found.ok
        assert {entry.finding.domain for entry in found.judged} == {""}
    (other,) = mechanics.check(swinging(), f"{text} + 0/theta", blame=False).judged
    assert other.finding.domain == "except where theta = 0"


@pytest.mark.parametrize(
    ("right", "expected"),
    [
        ("-c/(m*x^2)", ("PROVED", "")),
        ("-c*x/(m*sqrt(x^4)*x)", ("PROVED", "")),
        ("-c/(m*x^2) + 0*log(x)", ("UNDECIDED", "PROVED WHERE x > 0")),
    ],
)
def test_where_a_load_has_no_value_nobody_has_to(right, expected):
    assert outcome(mechanics.check(attracted(), f"x'' = {right}", blame=False)) == expected


def test_exit_codes_and_first_lines(tmp_path):
    def run(more):
        path = tmp_path / "mine.c"
        path.write_text(C % ("theta", "u", more))
        return CliRunner().invoke(app, ["check", "rod_pendulum", str(path)])

    assert run("0").exit_code == 0
    nowhere = run("sqrt(-1-theta*theta)*sqrt(-1-theta*theta) + 1 + theta*theta")
    assert nowhere.exit_code == 1
    half = run("0*sqrt(theta)")
    assert half.exit_code == 3
    assert half.stdout.startswith("PROVED WHERE theta >= 0")
    assert "--where 'theta >= 0'" in half.stdout
    thin = run("0/(theta - 1)")
    assert thin.exit_code == 0
    assert thin.stdout.startswith("PROVED except where theta - 1 = 0")


def test_json_says_where():
    (statement,) = json.loads(json.dumps(to_json(of_text("sqrt(theta)^2"))))["statements"]
    assert statement["domain"] == "PROVED WHERE theta >= 0"


def test_the_same_answer_twice():
    assert str(of_c("sqrt(theta)*sqrt(theta)")) == str(of_c("sqrt(theta)*sqrt(theta)"))

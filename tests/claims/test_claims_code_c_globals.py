"""C whose functions read and change variables of their file."""

import shutil
import subprocess
from pathlib import Path

import pytest

from mechanics import check
from mechanics.claims.code.c.globals import with_globals
from mechanics.errors import InputError
from mechanics.report.answer.check import Check
from systems import rod_pendulum
from tests.verdict_of import verdict_of

SCENE = rod_pendulum.scene()
STATE = "static double theta = 0.1, theta_dot; extern double m, l, g;\n"
STEP = """static double acc(double u) { return 1.5*g/l*sin(theta) + 3*u/(m*l*l); }
void step(double u, double dt)
{ double a = acc(u);
  theta += dt*theta_dot;
  theta_dot += dt*a; }
"""
SINGLE = """static float theta = 0.1f, theta_dot; static const float dt = 0.001f;
void step(float u, float m, float l, float g)
{ float a = 1.5f*g/l*sinf(theta) + 3*u/(m*l*l);
  theta_dot += a*dt;
  theta += theta_dot*dt; }
"""


def _checked(text: str) -> Check:
    return check(SCENE, f"#include <math.h>\n{text}", notation="c", blame=False)


def _verdict(text: str) -> str:
    return verdict_of(SCENE, f"#include <math.h>\n{text}", notation="c")


@pytest.mark.parametrize(
    "text",
    [
        STATE + STEP,
        SINGLE,
        STATE + STEP.replace("void step(double u, double dt)", "void step(double dt, double u)"),
        STATE.replace("static ", "") + STEP,
        "static double s[2]; extern int n; extern double m, l, g;\n"
        "void rates(double u, double theta, double theta_dot, double out[n])\n"
        "{ out[0] = theta_dot; out[1] = 1.5*g/l*sin(theta) + 3*u/(m*l*l); }\n",
    ],
)  # fmt: skip
def test_variables_of_a_file_are_what_they_are_when_it_is_called(text: str) -> None:
    assert _checked(text).verdict.name == "PROVED"


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("1.5*g", "0.5*g"),
        ("3*u/(m*l*l)", "3*u/(m*l)"),
        ("theta += dt*theta_dot", "theta += dt*a"),
        ("theta_dot += dt*a", "theta_dot -= dt*a"),
        ("double a = acc(u);", "theta_dot = 2*theta_dot; double a = acc(u);"),
        ("double a = acc(u);", "m = 2*m; double a = acc(u);"),
        ("sin(theta)", "sin(theta_dot)"),
    ],
)
def test_what_is_wrong_is_not_proved(old: str, new: str) -> None:
    assert old in STEP
    assert _verdict(STATE + STEP.replace(old, new)) in ("REFUTED", "UNDECIDED", "not read")


@pytest.mark.parametrize(
    "text",
    [
        STATE + STEP.replace("double a = acc(u);", "double theta = 0, a = acc(u);"),
        STATE + STEP.replace("step(double u,", "step(double u, double theta,"),
        STATE + STEP.replace("{ double a = acc(u);", "{ double a = acc(u); { double theta_dot; }"),
        STATE + "#define theta_dot theta\n" + STEP,
        STATE + "static double sin(double x) { return x; }\n" + STEP,
        STATE + "static double *p = &theta;\n" + STEP.replace("sin(theta)", "sin(*p)"),
        STATE + "static int n;\n" + STEP.replace("1.5*g", "(1.5 + n)*g"),
        STATE.replace("static double", "static volatile double") + STEP,
        STATE + STEP.replace("double a = acc(u);", "double *p = &theta, a; *p = 0; a = acc(u);"),
        STATE + "static double both(void) { theta = 2*theta; return 1.5; }\n"
        + STEP.replace("1.5*g/l*sin(theta)", "g/l*sin(theta)*both()"),
        STATE + STEP.replace("acc(double u) {", "acc(double u) { static double k = 1; k += 1;"),
        STATE + STEP.replace("{ double a = acc(u);", "{ double a = acc(u); if (u > 0) theta = 0;"),
        "struct s { double theta, theta_dot; }; static struct s x;\n" + STATE
        + STEP.replace("theta += dt", "x.theta += dt"),
    ],
)  # fmt: skip
def test_what_hides_a_change_is_not_proved(text: str) -> None:
    assert _verdict(text) in ("REFUTED", "UNDECIDED", "not read")


@pytest.mark.parametrize(
    "more",
    [
        "double get(void) { return theta; }\n",
        "void reset(void) { theta = 0.1; theta_dot = 0; }\n",
        "void set(double v) { theta = v; }\n",
    ],
)
def test_of_several_functions_of_a_state_somebody_says_which(more: str) -> None:
    with pytest.raises(InputError, match="--function"):
        _checked(STATE + STEP + more)
    text = f"#include <math.h>\n{STATE}{STEP}{more}"
    assert check(SCENE, text, notation="c", function="step", blame=False).verdict.name == "PROVED"


def test_a_step_that_forgets_its_state_is_refuted() -> None:
    text = "void reset(double *theta, double *theta_dot) { theta[0] = 0.1; theta_dot[0] = 0; }\n"
    assert _verdict(text) == "REFUTED"


@pytest.mark.parametrize(
    "new", ["double a = 2*acc(u);", "double a = acc(u) + theta;", "double a = acc(2*u);"]
)
def test_what_calls_another_is_refuted(new: str) -> None:
    assert _verdict(STATE + STEP.replace("double a = acc(u);", new)) == "REFUTED"


@pytest.mark.skipif(shutil.which("gcc") is None, reason="gcc is not installed")
def test_a_file_with_arguments_computes_what_it_did(tmp_path: Path) -> None:
    head = "#include <math.h>\n#include <stdio.h>\ndouble m = 2, l = 3, g = 4;\n"
    own = STATE.replace("extern double m, l, g;", "")
    before = "int main(void) { theta = 0.3; theta_dot = 0.5; step(2, 0.01);"
    first = f'{head}{own}{STEP}{before} printf("%.17g %.17g", theta, theta_dot); }}'
    moved = with_globals(STATE + STEP)
    assert "double u, double dt, double *theta, double *theta_dot" in moved
    call = "double t = 0.3, w = 0.5; step(2, 0.01, &t, &w, 2, 3, 4);"
    second = f'{head}{moved}int main(void) {{ {call} printf("%.17g %.17g", t, w); }}'
    told = []
    for k, text in enumerate((first, second)):
        (tmp_path / f"{k}.c").write_text(text)
        run = ["gcc", "-O0", "-o", tmp_path / f"{k}", tmp_path / f"{k}.c", "-lm"]
        subprocess.run(run, check=True)
        told.append(subprocess.run([tmp_path / f"{k}"], capture_output=True, check=True).stdout)
    assert told[0] == told[1]

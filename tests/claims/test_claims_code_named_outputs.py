"""Outputs of code that are named like accelerations are these, in the order of the code."""

import math
from importlib import import_module
from pathlib import Path
from uuid import uuid4

import numpy as np
import particles
import pytest

from benchmarks.corpus.load import HERE, scene_of
from mechanics import check
from mechanics.errors import InputError
from mechanics.grading.submission import things_in
from mechanics.kernel import Verdict
from systems import cartpole, elastic_pendulum, rod_pendulum

SCENE = elastic_pendulum.scene()
DET = "(M/3*(M + m) - M*M/4*c*c)"
ANGLE = f"((M + m)*(-M*g*s/2) - M*c/2*(M*L/2*theta_dot*theta_dot*s - 2*k*x))/({DET}*L)"
PLACE = f"(M/3*(M*L/2*theta_dot*theta_dot*s - 2*k*x) + M*M*g*s*c/4)/{DET}"
HEAD = "double x, double theta, double theta_dot, double M, double m, double L, double k, double g"


def _c(*lines: str, result: str = "void", name: str = "f", more: str = "") -> str:
    body = " ".join(lines)
    return (
        f"#include <math.h>\n{result} {name}({HEAD}{more})"
        f" {{ double s = sin(theta), c = cos(theta); {body} }}\n"
    )


def _verdict(code: object, **options: object) -> str:
    return check(SCENE, code, blame=False, **options).verdict.name


def test_one_acceleration_by_the_name_of_the_function_or_the_output() -> None:
    named = _c(f"return {ANGLE};", result="double", name="theta_ddot")
    assert _verdict(named, notation="c") == "PROVED"
    output = _c(f"*thetadd = {ANGLE};", more=", double *thetadd")
    assert _verdict(output, notation="c") == "PROVED"
    wrong = _c(f"return {PLACE};", result="double", name="theta_ddot")
    assert _verdict(wrong, notation="c") == "REFUTED"


def test_accelerations_in_another_order_than_ours() -> None:
    more = ", double *theta_ddot, double *x_ddot"
    code = _c(f"*theta_ddot = {ANGLE};", f"*x_ddot = {PLACE};", more=more)
    assert _verdict(code, notation="c") == "PROVED"

    def swapped(x, theta, theta_dot, M, m, L, k, g):  # type: ignore[no-untyped-def]
        s, c = np.sin(theta), np.cos(theta)
        det = M / 3 * (M + m) - M * M / 4 * c * c
        push = M * L / 2 * theta_dot**2 * s - 2 * k * x
        thetadd = (-(M + m) * M * g * s / 2 - M * c / 2 * push) / (det * L)
        xdd = (M / 3 * push + M * M * g * s * c / 4) / det
        return thetadd, xdd

    assert _verdict(swapped) == "PROVED"


def test_accelerations_that_are_called_acc() -> None:
    more = ", double *theta_acc, double *xacc"
    lines = (f"*theta_acc = {ANGLE};", f"*xacc = {PLACE};")
    assert _verdict(_c(*lines, more=more), notation="c") == "PROVED"
    wrong = (lines[0].replace("-M*g*s/2", "M*g*s/2"), lines[1])
    assert _verdict(_c(*wrong, more=more), notation="c") == "REFUTED"


def test_about_takes_the_name_of_an_acceleration() -> None:
    plain = _c(f"return {ANGLE};", result="double")
    assert _verdict(plain, notation="c", about="theta_ddot") == "PROVED"
    assert _verdict(plain, notation="c", about="x_ddot") == "REFUTED"
    with pytest.raises(InputError, match=r"--about \(about=\) can be .*x_ddot, theta_ddot"):
        check(SCENE, plain, notation="c")
    with pytest.raises(InputError, match=r"about 'theta_dot', for 1 outputs of code"):
        check(SCENE, plain, notation="c", about="theta_dot")


def test_an_energy_is_asked_for_as_before() -> None:
    def energy(x, k):  # type: ignore[no-untyped-def]
        return k * x**2 + math.cos(0)

    found = check(SCENE, energy, about="potential energy", blame=False)
    assert found.verdict is Verdict.REFUTED


RATES = """
from math import cos, sin

def rate(t, y, u=0.0, m=1.0, l=1.0, g=9.81):
    theta, theta_dot = y
    theta_ddot = 3*g/(2*l)*sin(theta) + 3/(m*l**2)*u
    return {}
"""


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("returned", "verdict"),
    [
        ("[theta_dot, theta_ddot]", "PROVED"),
        ("(theta_dot, theta_ddot)", "PROVED"),
        ("{'theta_ddot': theta_ddot, 'theta_dot': theta_dot}", "PROVED"),
        ("[theta_ddot, theta_dot]", "REFUTED"),
        ("(theta_ddot, theta_dot)", "REFUTED"),
        ("list((theta_ddot, theta_dot))", "REFUTED"),
    ],
)
def test_rates_of_a_state_stand_in_its_order_whatever_they_are_called(
    returned: str, verdict: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    name = f"rates_{uuid4().hex}"
    (tmp_path / f"{name}.py").write_text(RATES.replace("{}", returned, 1))
    monkeypatch.syspath_prepend(tmp_path)
    rate = import_module(name).rate
    assert check(rod_pendulum.scene(), rate, blame=False).verdict.name == verdict


PULLEY = scene_of(HERE / "scenes" / "pulley.py", "make_scene")
ONE = (
    "#include <math.h>\ndouble {}(double theta, double theta_dot, double m, double l, double g)"
    " {{ return {}; }}"
)
TENSION = "m*g*cos(theta) + m*l*theta_dot*theta_dot"


def test_outputs_that_are_called_reactions_are_these() -> None:
    tensions = (
        "void tensions(double m1, double m2, double M, double g, double *T1, double *T2) {\n"
        "  double a = (m1 - m2)*g/(m1 + m2 + 0.5*M); *T1 = m1*(g - a); *T2 = m2*(g + a); }\n"
    )
    found = check(PULLEY, tensions, notation="c", blame=False)
    assert [e.verdict.name for e in found.judged] == ["PROVED", "PROVED"]
    other = tensions.replace("double *T1, double *T2", "double *T2, double *T1")
    assert check(PULLEY, other, notation="c", blame=False).verdict.name == "PROVED"  # by name
    for right, wrong in (("m1*(g - a)", "m1*(g + a)"), ("m2*(g + a)", "m1*(g + a)")):
        changed = tensions.replace(right, wrong)
        assert check(PULLEY, changed, notation="c", blame=False).verdict.name == "REFUTED"


def test_an_output_that_is_called_an_energy_is_no_acceleration() -> None:
    energy = "void f(double x_dot, double m1, double *T) { *T = 0.5*m1*x_dot*x_dot; }\n"
    with pytest.raises(InputError, match="calls an output T and would be taken to return"):
        check(PULLEY, energy, notation="c", blame=False)
    for name in "TVL":
        with pytest.raises(InputError, match=f"{name} would be taken to return"):
            check(particles.pendulum(names="m l g"), ONE.format(name, TENSION), notation="c")


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("name", "value", "about"),
    [
        ("S", TENSION, None), ("tension", TENSION, None), ("compute_tension", TENSION, None),
        ("stringTension", TENSION, None), ("normal_force", f"-({TENSION})", None),
        ("angular_momentum", "m*l*l*theta_dot", None), ("f", TENSION, "tension"),
        ("f", TENSION, "S"), ("f", "m*l*l*theta_dot", "angular momentum"),
    ],
)  # fmt: skip
def test_one_number_is_what_its_function_is_called(
    name: str, value: str, about: str | None
) -> None:
    """In its own name, or as the person says; never an acceleration."""
    scene = particles.pendulum(names="m l g")
    code = ONE.format(name, value)
    assert check(scene, code, notation="c", about=about, blame=False).verdict.name == "PROVED"
    for old, new in (("m", "2*m"), ("theta_dot", "theta_dot*2")):
        wrong = ONE.format(name, value.replace(old, new, 1))
        found = check(scene, wrong, notation="c", about=about, blame=False)
        assert found.verdict.name == "REFUTED"


@pytest.mark.parametrize("name", ["rod_force", "torque", "centripetalForce", "coriolis"])
def test_a_force_is_asked_for(name: str) -> None:
    with pytest.raises(InputError, match=f"{name} returns a force or a torque, .* say what it is"):
        check(particles.pendulum(names="m l g"), ONE.format(name, TENSION), notation="c")


@pytest.mark.parametrize("name", ["with_tension", "accel_without_force", "pendulum"])
def test_what_is_only_there_is_not_returned(name: str) -> None:
    code = ONE.format(name, "-g/l*sin(theta)")
    assert check(particles.pendulum(names="m l g"), code, notation="c").verdict.name == "PROVED"


def test_an_acceleration_may_be_of_another_acceleration() -> None:
    """x'' of theta'', by its name; without one it may be a residual, too."""
    head = "double {}(double theta, double theta_dot, double theta_ddot, double F,"
    code = (
        f"#include <math.h>\n{head} double m_c, double m_p, double l) {{\n"
        "  return (F + m_p*l*(theta_dot*theta_dot*sin(theta) - {}theta_ddot*cos(theta)))"
        "/(m_c + m_p); }}\n"
    )
    scene = cartpole.scene()

    def judged(name: str, factor: str) -> str:
        text = code.replace("{{", "{").replace("}}", "}").replace("{}", name, 1)
        return check(scene, text.replace("{}", factor), notation="c", blame=False).verdict.name

    assert judged("x_ddot", "") == "PROVED"
    assert judged("x_ddot", "2*") == "REFUTED"
    for name in ("cartAcceleration", "cart_acc"):
        assert judged(name, "") == "PROVED"
    with pytest.raises(InputError, match="may return x_ddot, or what is zero"):
        judged("cart", "")


SOLVED = """import numpy as np
def accel(theta, theta_dot, F, mc, mp, l, g):
    A = np.array([[mp*l*np.cos(theta), mc+mp], [4/3*l, np.cos(theta)]])
    b = np.array([F + mp*l*theta_dot**2*np.sin(theta), g*np.sin(theta)])
    {0} = np.linalg.solve(A, b)
    return {1}
"""


@pytest.mark.parametrize(
    ("solved", "returned", "verdict"),
    [
        ("thdd, xdd", "thdd, xdd", "PROVED"), ("thdd, xdd", "xdd, thdd", "PROVED"),
        ("xdd, thdd", "xdd, thdd", "REFUTED"), ("xdd, thdd", "thdd, xdd", "REFUTED"),
        ("xdd, other", "xdd, other", "REFUTED"), ("other, xdd", "other, xdd", "PROVED"),
        ("a, b", "a, b", "PROVED"), ("one, other", "one, other", "UNDECIDED"),
    ],
)  # fmt: skip
def test_names_of_accelerations_say_their_order(
    solved: str, returned: str, verdict: str, tmp_path: Path
) -> None:
    """Those that are short, too, and where one of two has a name; else dimensions say it."""
    path = tmp_path / "cart.py"
    path.write_text(SOLVED.format(solved, returned))
    things = things_in(path, run_python=True)
    assert check(cartpole.scene(), things, blame=False).verdict.name == verdict

"""Code that computes equations, judged by its own formulas."""

import math
import re
from collections.abc import Callable

import casadi as ca
import numpy as np
import pytest
import sympy as sp
from sympy.physics.mechanics import (
    KanesMethod,
    LagrangesMethod,
    Lagrangian,
    Particle,
    Point,
    ReferenceFrame,
    RigidBody,
    dynamicsymbols,
    inertia,
)

import mechanics
from mechanics.errors import InputError
from mechanics.judge.check import derived
from systems import cartpole, elastic_pendulum

PENDULUM = derived(elastic_pendulum.scene())


def judged(scene, thing, **options) -> list[str]:
    return [e.finding.verdict.name for e in mechanics.check(scene, thing, **options).judged]


def square(x):
    return x**2


def by_solving(state, M, m, L, k, g):
    x, theta, _, theta_dot = state
    c, s = math.cos(theta), np.sin(theta)
    mass = np.array(
        [[M + m, 0.5 * M * L * c], [M * L / 2 * c, M * L**2 * (1.0 / 3.0)]], dtype=float
    )
    force = np.array([-2 * k * x + M * L / 2 * theta_dot**2 * s, -M * g * L / 2 * s])
    rate = np.zeros(4)
    rate[:2] = state[2:]
    rate[2:] = np.linalg.solve(mass, force)
    return rate


def interleaved(t, y, M, m, L, k, g, wrong=False):
    x, x_dot, theta, theta_dot = y
    if theta > 1 or x <= 0:
        pull = 2 * k * x
    else:
        pull = 2 * x * (3 * k if wrong else k)
    c, s = math.cos(theta), math.sin(theta)
    det = (M + m) * M * L**2 / 3 - M**2 * L**2 / 4 * square(c)
    b1, b2 = -pull + M * L / 2 * theta_dot**2 * s, -M * g * L / 2 * s
    return [
        x_dot, (M * L**2 / 3 * b1 - M * L / 2 * c * b2) / det,
        theta_dot, ((M + m) * b2 - M * L / 2 * c * b1) / det,
    ]  # fmt: skip


def test_a_python_function_is_proved_and_its_folded_constants_are_listed() -> None:
    found = mechanics.check(PENDULUM, by_solving)
    assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED"] * 4
    assert found.judged[2].statement.notes == ("0.3333333333333333 is read as 1/3",)
    assert found.names[0].meaning == "x theta x_dot theta_dot"


def test_branches_are_followed_and_an_interleaved_state_is_seen() -> None:
    assert judged(PENDULUM, interleaved) == ["PROVED"] * 4
    found = mechanics.check(
        PENDULUM, lambda t, y, M, m, L, k, g: interleaved(t, y, M, m, L, k, g, True)
    )
    assert [e.finding.verdict.name for e in found.judged] == [
        "PROVED", "REFUTED", "PROVED", "REFUTED",
    ]  # fmt: skip
    assert found.names[1].meaning == "x x_dot theta theta_dot"


def casadi_function(factor: int) -> ca.Function:
    x, th, xd, thd, *parameters = (ca.SX.sym(n) for n in ("x", "th", "xd", "thd", *"MmLkg"))
    M, m, L, k, g = parameters
    c, s = ca.cos(th), ca.sin(th)
    mass = ca.vertcat(ca.horzcat(M + m, M * L / 2 * c), ca.horzcat(M * L / 2 * c, M * L**2 / 3))
    force = ca.vertcat(-factor * k * x + M * L / 2 * thd**2 * s, -M * g * L / 2 * s)
    return ca.Function(
        "a", [ca.vertcat(x, th), ca.vertcat(xd, thd), *parameters], [ca.solve(mass, force)],
        ["q", "u", *"MmLkg"], ["a"],
    )  # fmt: skip


def test_a_casadi_function() -> None:
    assert set(judged(PENDULUM, casadi_function(2))) <= {"PROVED", "CERTIFIED"}
    assert judged(PENDULUM, casadi_function(1)) == ["REFUTED", "REFUTED"]


C_SOURCE = """
#include <math.h>
#define HALF 0.5
static double sq(double x) { return x*x; }
void pend(const double q[2], const double qd[2], double M, double m, double L, double k, double g,
          double *a)
{
    double c = cos(q[1]), s = sin(q[1]);
    double det = (M+m)*M*sq(L)/3 - sq(M*L*c)/4;
    double b1 = -2*k*q[0] + HALF*M*L*sq(qd[1])*s, b2 = -M*g*L/2*s;
    a[0] = (M*L*L/3*b1 - M*L/2*c*b2)/det;
    a[1] = ((M+m)*b2 - M*L/2*c*b1)/det;
}
"""


def test_c_source(tmp_path) -> None:
    file = tmp_path / "pend.c"
    file.write_text(C_SOURCE)
    assert judged(PENDULUM, file) == ["PROVED", "PROVED"]
    assert judged(PENDULUM, C_SOURCE.replace("/4;", "/3;"), notation="c") == ["REFUTED"] * 2


@pytest.mark.sample(4)
@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("int f(", "no C"),
        ("", "there is no function in it"),
        ("double f(double x) { while (1) {} return x; }", "code.c, line 1, column 22"),
        ("double f(double x) { return g(x); }", "the call g() is not supported"),
        ("void f(const double *x, double *y) { y[0] = x[9]; }", "x[9] is read beyond the end"),
        ("(" * 20000, "code.c"),
        ("double f(double x) { return " + "1+" * 7000 + "1; }", "nested too deeply"),
        ("double f(double x) { return " + "-" * 5000 + "x; }", "nested too deeply"),
        (
            "\n".join(f"#define A{i} A{i + 1} A{i + 1}" for i in range(40))
            + "\ndouble f(double x) { return A0; }",
            "more than 20000 macros",
        ),
        (
            "double f(double x) { double y = x; " + "y = y*y + y; " * 200 + "return y; }",
            "more than 300000 operations",
        ),
        ("double f(double x) { for (int i = 0; i < 99999999; i++) x = x*x; return x; }", "loop"),
        ("double f(double x) { return x*1e999; }", "beyond the largest double"),
        (" " * 40_000, "30000 at most"),
    ],
)
def test_c_that_is_not_known(text: str, words: str) -> None:
    names = {"x": "x theta x_dot theta_dot"} if "const double *x" in text else {"x": "x"}
    with pytest.raises(InputError, match=re.escape(words)) as caught:
        mechanics.check(PENDULUM, text, notation="c", names=names)
    assert "\n" not in str(caught.value)


def hides(state, M, m, L, k, g):
    return [float(str(state[0])), 1.0]


def endless(state, M, m, L, k, g):
    x = state[0]
    while x > 0:
        x = x - 1
    return [x, x]


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("function", "words"),
    [
        (hides, "function hides: ValueError"),
        (endless, "too many branches"),
        (lambda omega_9, psi: [psi], "arguments omega_9, psi: nothing says what they are"),
        (lambda state, M: [state[0]], "returns 1 numbers"),
        (lambda state, M: "x", "numbers and arrays are known"),
        (abs, "has no name"),
    ],
)
def test_what_cannot_be_traced_is_named(function: Callable, words: str) -> None:
    with pytest.raises(InputError, match=re.escape(words)) as caught:
        mechanics.check(PENDULUM, function)
    assert "\n" not in str(caught.value)


def sympy_models() -> tuple[KanesMethod, LagrangesMethod]:
    x, phi, u1, u2 = dynamicsymbols("x phi u1 u2")
    M, m, L, k, g = sp.symbols("M m L k g")
    N, origin = ReferenceFrame("N"), Point("O")
    origin.set_vel(N, 0)
    rod = N.orientnew("A", "Axis", (phi, N.z))

    def bodies(v, w):
        rod.set_ang_vel(N, w * N.z)
        pivot = origin.locatenew("B", x * N.x)
        pivot.set_vel(N, v * N.x)
        centre = pivot.locatenew("C", -L / 2 * rod.y)
        centre.v2pt_theory(pivot, N, rod)
        spin = (inertia(rod, 0, 0, M * L**2 / 12), centre)
        return pivot, centre, (Particle("c", pivot, m), RigidBody("p", centre, rod, M, spin))

    pivot, centre, parts = bodies(u1, u2)
    loads = [(centre, -M * g * N.y), (pivot, -2 * k * x * N.x)]
    kane = KanesMethod(N, [x, phi], [u1, u2], [u1 - x.diff(), u2 - phi.diff()],
                       bodies=parts, forcelist=loads)  # fmt: skip
    pivot, centre, parts = bodies(x.diff(), phi.diff())
    loads = [(centre, -M * g * N.y), (pivot, -2 * k * x * N.x)]
    lagrange = LagrangesMethod(Lagrangian(N, *parts), [x, phi], forcelist=loads, frame=N)
    return kane, lagrange


def test_sympy_objects() -> None:
    for model in sympy_models():
        found = mechanics.check(PENDULUM, model)
        assert [entry.finding.verdict.name for entry in found.judged] == ["PROVED", "PROVED"]
        assert {m.name: m.meaning for m in found.names}["phi"] == "theta"
    x, theta = dynamicsymbols("x theta")
    M, L = sp.symbols("M L")
    term = sp.Matrix([M * L * x.diff().diff() - 2])
    assert judged(PENDULUM, [term, sp.Eq(M, 3 * L), x.diff() + theta]) == [
        "REFUTED", "REFUTED", "UNDECIDED",
    ]  # fmt: skip


def separate(x, x_dot, theta, theta_dot, F, mc, mp, l, g):  # type: ignore[no-untyped-def]
    sine, cosine = np.sin(theta), np.cos(theta)
    push = (F + mp * l * theta_dot**2 * sine) / (mc + mp)
    turn = (g * sine - cosine * push) / (l * (4 / 3 - mp * cosine**2 / (mc + mp)))
    return np.array([x_dot, push - mp * l * turn * cosine / (mc + mp), theta_dot, turn])


def separate_by_order(x, theta, x_dot, theta_dot, F, mc, mp, l, g):  # type: ignore[no-untyped-def]
    return separate(x, x_dot, theta, theta_dot, F, mc, mp, l, g)


def grouped(x, x_dot, theta, theta_dot, F, mc, mp, l, g):  # type: ignore[no-untyped-def]
    return separate(x, x_dot, theta, theta_dot, F, mc, mp, l, g)[[0, 2, 1, 3]]


@pytest.mark.parametrize("function", [separate, separate_by_order, grouped])
def test_rates_of_a_state_that_is_passed_entry_by_entry(function: Callable) -> None:
    found = mechanics.check(cartpole.scene(), function)
    assert found.ok, str(found)

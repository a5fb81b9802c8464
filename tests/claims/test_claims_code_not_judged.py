"""What a file of code says beside the functions that are judged is named, and puts it in doubt."""

from pathlib import Path

import pytest

import mechanics
from mechanics.blame.reference import Reference
from mechanics.errors import InputError
from mechanics.grading.grade import grade
from mechanics.judge.check import derived
from mechanics.kernel import Verdict
from systems import rod_pendulum

ROD = rod_pendulum.scene()
ARGUMENTS = "(double theta, double w, double u, double m, double l, double g)"
C = f"double acc{ARGUMENTS}\n{{\n  return 3*g/(2*l)*sin(theta) + 3*u/(m*l*l);\n}}\n"
MATLAB = """function dydt = rate(t, y, m, l, g, u)
theta = y(1);
w = y(2);
dydt = [w; 3*g/(2*l)*sin(theta) + 3*u/(m*l^2)];
end
"""
JULIA = """function rate!(du, y, p, t)
    theta, w = y
    m, l, g, u = p
    du[1] = w
    du[2] = 3g/(2l)*sin(theta) + 3u/(m*l^2)
end
"""


def found_in(folder: Path, suffix: str, text: str) -> mechanics.report.answer.check.Check:
    path = folder / f"page{suffix}"
    path.write_text(text)
    return mechanics.check(ROD, path, blame=False)


@pytest.mark.sample(4)
@pytest.mark.parametrize(
    ("suffix", "text", "named"),
    [
        (".c", f"#include <math.h>\ndouble theta_ddot{ARGUMENTS} {{ return g/l*sin(theta); }}\n{C}",
         "function theta_ddot"),
        (".m", f"theta_ddot = g/l*sin(theta)\n{MATLAB}", "theta_ddot = g/l*sin(theta)"),
        (".m", f"{MATLAB}theta_ddot = 0;\n", "theta_ddot = 0"),
        (".m", f"f = @(t, y) -rate(t, y, 1, 1, 9.81, 0);\n{MATLAB}", "f = @(t, y) -rate"),
        (".m", f"[t, y] = ode45(@(t, y) [y(2); sin(y(1))], [0 1], [1; 0]);\n{MATLAB}", "ode45"),
        (".m", f"v = -rate(0, [1; 0], 1, 1, 9.81, 0);\n{MATLAB}", "v = -rate"),
        (".m", f"syms theta(t)\neq = l*diff(theta, 2) == g*cos(theta);\n{MATLAB}", "eq = l*diff"),
        (".jl", f"{JULIA}theta_ddot = -g/l*sin(theta)\n", "theta_ddot = -g/l*sin(theta)"),
        (".jl", f"{JULIA}θ̈ = -g/l*sin(θ)\n", "-g/l*sin"),
        (".jl", f"{JULIA}f = (du, u, p, t) -> (du .= -u)\n", "f = (du, u, p, t)"),
        (".jl", f"{JULIA}eq = D(D(theta)) ~ -g/l*sin(theta)\n", "eq = D(D(theta))"),
        (".jl", f"theta_ddot(theta, l, g) = g/l*sin(theta)\n{JULIA}"
         "solve(ODEProblem(rate!, [1.0, 0.0], (0.0, 1.0)))\n", "function theta_ddot"),
    ],
)  # fmt: skip
def test_it_is_named_and_in_doubt(tmp_path: Path, suffix: str, text: str, named: str) -> None:
    found = found_in(tmp_path, suffix, text)
    assert any(named in words for words in found.unjudged)
    graded = grade(Reference(derived(ROD)), "page", [tmp_path / f"page{suffix}"])
    assert graded.verdict == "in doubt"


@pytest.mark.parametrize(
    ("suffix", "text"),
    [
        (".c", f"#include <math.h>\nstatic double sq(double a) {{ return a*a; }}\n"
         f"{C.replace('l*l', 'sq(l)')}"),
        (".m", "clear; clc; close all\nm = 1; l = 0.5; g = 9.81; u = 0; I = m*l^2/3;\n"
         "y0 = [pi/4; 0]; tspan = linspace(0, 10, 100);\n"
         "[t, y] = ode45(@(t, y) rate(t, y, m, l, g, u), tspan, y0);\n"
         "theta = y(:, 1);\nfigure; plot(t, theta*180/pi); hold on\nxlabel('t'); grid on\n"
         f"fprintf('%g\\n', max(theta));\n{MATLAB}"),
        (".m", MATLAB),
        (".jl", f"using OrdinaryDiffEq, Plots\n{JULIA}p = (1.0, 0.5, 9.81, 0.0)\n"
         "prob = ODEProblem(rate!, [pi/4, 0.0], (0.0, 10.0), p)\nsol = solve(prob, Tsit5())\n"
         "theta = sol[1, :]\nplot(sol.t, theta*180/pi)\nprintln(maximum(theta))\n"),
    ],
)  # fmt: skip
def test_plots_solvers_and_numbers_say_nothing(tmp_path: Path, suffix: str, text: str) -> None:
    found = found_in(tmp_path, suffix, text)
    assert found.verdict in (Verdict.PROVED, Verdict.CERTIFIED)
    assert not found.beside


BODIES = {
    "own.cpp": "void f(const double y[2], double dy[2]) {{\ndy[0] = y[1];\n{}\n}}",
    "own.c": "void f(const double y[2], double dy[2]) {{\ndy[0] = y[1];\n{}\n}}",
    "own.m": "function dy = f(y)\ndy = y;\n{}\nend",
    "own.jl": "function f!(dy, y)\ndy[1] = y[2]\n{}\nend",
}


@pytest.mark.parametrize(
    ("file", "changes"), [("own.cpp", "dy"), ("own.c", ""), ("own.m", ""), ("own.jl", "dy")]
)
def test_a_call_of_another_file_says_what_it_may_change_and_what_to_do(
    tmp_path: Path, file: str, changes: str
) -> None:
    (tmp_path / file).write_text(BODIES[file].format("publish(dy);"))
    with pytest.raises(InputError) as refused:
        mechanics.check(ROD, tmp_path / file)
    told = str(refused.value)
    assert "line 3" in told and "publish()" in told
    assert not changes or f"may change {changes}:" in told
    assert "into the file, or leave the call out if it changes nothing" in told

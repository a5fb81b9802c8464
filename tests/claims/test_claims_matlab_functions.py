"""Functions of MATLAB as code: structs, matrices, conditions, functions that are solved."""

from functools import cache
from pathlib import Path

import numpy as np
import pytest
from sympy.physics.mechanics import dynamicsymbols

import mechanics
from benchmarks.corpus.builders import P, pendulum, two_link_arm
from benchmarks.corpus.scenes.arms_chasers_discs import feder
from benchmarks.corpus.scenes.satellites_and_springs import satellite_torque
from mechanics.claims.code.translation.matlab import Unread, in_python
from mechanics.cli.load import load
from mechanics.errors import InputError
from systems import rod_pendulum

ROD = mechanics.derive(rod_pendulum.scene(), "free_body")
MASSES = """
function run
m1 = 1; k1 = 2;
M = [%s 0; 0 m1];
[t, z] = ode45(@rhs, [0 1], [1 0]', [], M);
end
"""


def functions(text: str, *names: str):
    return in_python(text, "page.m", set(names).__contains__).functions


def test_matrices_are_multiplied_and_solved() -> None:
    text = """function dx = f(x, s, c)
    if c == true
      A = [s.a 0; 0 2];  % of a struct
    end
    dx = zeros(2, 1);
    for i = 1:2
      dx(i) = A(i, :)*x;
    end
    dx(1:2) = A\\dx(1:end) + (A^-1)*[0; 2*x(1)];
    """
    (function,) = functions(text, "a")
    assert list(function(x=np.array([3.0, 5.0]), a=4.0)) == [3.0, 8.0]


def test_what_is_solved_is_the_statement_and_its_caller_gives_the_matrices() -> None:
    text = MASSES.replace("%s", "m1") + "function dz = rhs(t, z, M)\n dz = M*z;\nend\n"
    (function,) = functions(text)
    assert function.__name__ == "rhs"
    assert list(function(z=np.array([3.0, 5.0]))) == [3.0, 5.0]


def test_columns_and_rows_are_not_mixed() -> None:
    (function,) = functions("function y = f(x)\n y = x*[1; 2];\nend")
    with pytest.raises(ValueError):
        function(x=np.array([1.0, 2.0]))


@pytest.mark.parametrize("body", ["for i=1:1e9\n y=i;\nend", "y=zeros(1e5,1e5);", "y=9^(9^9);"])
def test_what_takes_long_is_refused(body: str) -> None:
    (one,) = functions(f"function y = f(x)\ny = x;\n{body}\nend")
    with pytest.raises((ValueError, TypeError)):
        one(x=1.0)


def test_a_while_is_refused_by_its_line() -> None:
    with pytest.raises(Unread, match="line 2"):
        functions("function y = f(x)\nwhile x > 1\n x = x - 1;\nend\ny = x;\nend")


@pytest.mark.parametrize(("factor", "verdict"), [("3", "PROVED"), ("2", "REFUTED")])
def test_a_struct_of_parameters(tmp_path: Path, factor: str, verdict: str) -> None:
    path = tmp_path / "pendulum.m"
    path.write_text(
        "function dx = pendulum(t, x, u, model)\n"
        "A = [0 1; 0 0]; J = model.rod.m*model.rod.l^2/3;\n"
        f"dx = A*x + [0; {factor}*model.rod.g/model.rod.l/2*sin(x(1)) + u/J];\n"
        "end\n"
    )
    assert mechanics.check(load("rod_pendulum").scene(), path).verdict.name == verdict


@pytest.mark.parametrize(("text", "value"), [("-x^2*3", -12.0), ("(-x)^2", 4.0), ("1 - -x^2", 5.0)])
def test_a_power_binds_more_than_a_sign(text: str, value: float) -> None:
    (function,) = functions(f"function y = f(x)\ny = {text};\nend")
    assert function(x=2.0) == value


def test_a_power_of_a_power_wants_brackets() -> None:
    with pytest.raises(Unread, match="brackets"):
        functions("function y = f(x)\ny = 2^x^2;\nend")


def test_a_function_inside_of_another_has_its_numbers_and_what_it_computes() -> None:
    inner = "  function r = f(~, x)\n    r = c*x;\n  end\n"
    text = f"function run()\n\nL = 2;\nk = 3;\nc = k*L;\n\n{inner}\nend\n"
    (function,) = functions(text, "L", "k")
    assert function(x=2.0) == 12.0


STATE = """function dz = f(z, u, p)
[l, g, m] = p{:};
%s
dz(%d) = z(%d);
dz(%d) = %s*g*sin(z(%d))/2/l + 3*u(1)/(m*l^2);
end
"""


@pytest.mark.parametrize("first", [1, 2])
@pytest.mark.parametrize(("factor", "verdict"), [("3", "PROVED"), ("2", "REFUTED")])
def test_the_order_of_a_state_is_what_its_rates_show(
    tmp_path: Path, first: int, factor: str, verdict: str
) -> None:
    path = tmp_path / "f.m"
    last = 3 - first
    path.write_text(STATE % ("", first, last, last, factor, first))
    assert mechanics.check(load("rod_pendulum").scene(), path).verdict.name == verdict


def test_momenta_are_not_taken_for_speeds(tmp_path: Path) -> None:
    path = tmp_path / "f.m"
    path.write_text(STATE % ("% z(1) -> theta\n% z(2) -> p_theta", 1, 2, 2, "3", 1))
    with pytest.raises(InputError, match="momentum p_theta"):
        mechanics.check(load("rod_pendulum").scene(), path)


@pytest.mark.parametrize(
    ("lines", "value"),
    [
        ("k = -1; k = k*1; s = 0; for i = 3:k:1\n s = s + i;\n end", 6),
        ("s = 0; for i = 1:0.5:2.2\n s = s + i;\n end", 4.5),
        ("a = sum([1 2; 3 4]); s = a(1);", 4),
    ],
)
def test_ranges_and_sums_are_those_of_matlab(lines: str, value: float) -> None:
    (function,) = functions(f"function y = f(x)\n {lines}\n y = s*x;\n end")
    assert function(x=1.0) == value


@pytest.mark.parametrize("value", ["norm([3 0; 0 4])", "b(1.7)", "b(2 > 1)", "det([4 0; 0 4]^0.5)"])
def test_what_matrices_mean_otherwise_is_refused(value: str) -> None:
    (function,) = functions(f"function y = f(x)\n b = [1 2 3];\n y = x*{value};\n end")
    with pytest.raises(ValueError, match=r"is not read|no integer"):
        function(x=1.0)


HANDLE = """k = 3; w = k + 1;
y0 = [1 0];
if k > 2
  c = 4;
end
f = @(t, y) [
    y(2);
    -w*y(1)*%s];
[t, y] = ode45(f, [0 1], y0);
plot(t, y(:, 1))
"""


def test_the_handle_that_a_script_has_solved() -> None:
    (function,) = functions(HANDLE % "sec(0)")
    assert list(function(y=np.array([5.0, 7.0]))) == [7.0, -20.0]


@pytest.mark.parametrize("part, more", [("c", ""), ("k", "k = 5;\n"), ("g(y)", "")])
def test_a_handle_with_what_is_not_plain_is_not_read_so(part: str, more: str) -> None:
    with pytest.raises((Unread, NameError, TypeError)):
        (function,) = functions(more + HANDLE % part)
        function(y=np.array([5.0, 7.0]))


ARM = """function [M, C, G] = arm(p, s)
if nargin == 1
  s = p.state;
end
q1 = s(1); q2 = s(2); q1d = s(3); q2d = s(4);
a = p.m2*p.l1*p.c2; b = p.m2*p.c2^2 + p.I2;
M = [p.m1*p.c1^2 + p.I1 + p.m2*p.l1^2 + b + 2*a*cos(q2), b + a*cos(q2); b + a*cos(q2), b];
C = [%sa*sin(q2)*(q2d^2 + 2*q1d*q2d); a*sin(q2)*q1d^2];
G = p.g*[(p.m1*p.c1 + p.m2*p.l1)*cos(q1) + p.m2*p.c2*cos(q1 + q2); p.m2*p.c2*cos(q1 + q2)];
"""


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("sign", "change", "verdict"),
    [
        ("-", ("", ""), "PROVED"), ("", ("", ""), "REFUTED"),
        ("-", ("+ p.I2;", "+ 2*p.I2;"), "REFUTED"), ("-", ("q2); b + a", "q2); b - a"), "REFUTED"),
        ("-", ("G = p.g*", "G = -p.g*"), "UNDECIDED"),
        ("-", ("l1)*cos(q1)", "l1)*sin(q1)"), "REFUTED"),
        ("-", ("(q2d^2", "-1*(q2d^2"), "REFUTED"), ("-", ("(q2d^2 + 2", "(q2d^2 + 4"), "REFUTED"),
    ],
)  # fmt: skip
def test_mass_matrix_turning_and_gravity_together(
    tmp_path: Path, sign: str, change: tuple[str, str], verdict: str
) -> None:
    """Only their signs are open, where the scene has gravity and several inputs alone."""
    path = tmp_path / "arm.m"
    path.write_text((ARM % sign).replace(*change))
    found = mechanics.check(arm(), path, blame=False)
    assert found.verdict.name == verdict
    assert verdict != "UNDECIDED" or any(
        "put together as M u' + C - G" in words for e in found.judged for words in e.right_if
    )


@pytest.mark.parametrize("of", ["one input", "a damper"])
def test_what_else_drives_leaves_open_how_they_are_put_together(of: str, tmp_path: Path) -> None:
    path = tmp_path / "arm.m"
    path.write_text((ARM % "-").replace("l1)*cos(q1)", "l1)*sin(q1)"))
    found = mechanics.check(arm(of), path, blame=False)
    assert found.verdict.name == "UNDECIDED"
    assert "otherwise than M" in str([e.right_if for e in found.judged])


@cache
def arm(of: str = "") -> mechanics.Scene:
    """Two links in gravity, with torques."""
    q1, q2, t1, t2 = dynamicsymbols("q1 q2 t1 t2")
    m1, m2, l1, c1, c2, i1, i2, g = P("m1:kg m2:kg l1:m c1:m c2:m I1:kg*m^2 I2:kg*m^2 g:m/s^2")
    (b,) = P("b:N*m*s")
    torques = {
        "": (t1, t2), "one input": (t1, 0), "a damper": (t1, t2 - b * q2.diff()),
    }[of]  # fmt: skip
    inputs = (t1,) if of == "one input" else (t1, t2)
    return two_link_arm((q1, q2), l1, (m1, c1, i1), (m2, c2, i2), g, torques, inputs)


def test_a_return_at_the_end_of_a_function_is_its_end() -> None:
    text = "function y = f(a)\n%s\ny = 2*a;\nreturn\n%% the end\n"
    (function,) = functions(text % "")
    assert function(a=3.0) == 6.0
    with pytest.raises(Unread, match="return"):
        functions(text % "if a > 1\n return\nend")
    with pytest.raises(Unread, match="return"):
        functions(text % "return")


def test_what_is_taken_in_slices_is_no_coordinate_of_that_name() -> None:
    text = "function dx = f(t, x)\nr = x(1:2);\ndx = [r(2); %s];\nend\n"
    for right, verdict in (("-D*r(1)/m", "PROVED"), ("D*r(1)/m", "REFUTED")):
        (function,) = functions(text % right, "D", "m")
        assert mechanics.check(feder(), function, blame=False).verdict.name == verdict


@pytest.mark.parametrize(
    ("lines", "words"),
    [
        ("a(1) = x; a(2) = a(1);\na(2) = a(2) + k;", ""),
        ("clc; close all; a(1) = x; a(2) = x + k;", ""),
        ("global m\na(1) = x; a(2) = x + k;", ""),
        ("global k\na(1) = x; a(2) = x + k;", "k is an argument"),
        ("a(1) = x; a(2) = x + k;\nclear a", "clear removes names"),
        ("clear all; a(1) = x; a(2) = x + k;", "clear removes names"),
        ("a(1) = k; a(1) = x; a(2) = x + k;", r"a\(1\) is set twice"),
        ("syms k\na(1) = x; a(2) = x + k;", "has a value already"),
        ("a(1) = x; a(2) = x + k; %{\na(2) = 0;\n%}", "line of its own"),
        ("%{\na(2) = 0;\n%}\na(1) = x; a(2) = x + k;", ""),
    ],
)
def test_what_a_line_undoes_is_not_passed_over(lines: str, words: str) -> None:
    text = f"function a = f(x, k)\n{lines}\nend\n"
    if not words:
        (function,) = functions(text)
        assert list(function(x=3.0, k=4.0)) == [3.0, 7.0]
        return
    with pytest.raises(Unread, match=words):
        functions(text)


@pytest.mark.parametrize(
    ("head", "last", "verdict"),
    [
        ("s.l = 0.7; % m\ns.g = 9.81;", "-s.g/s.l*sin(x(1))", "PROVED"),
        ("s.l = 0.7;\ns.g = 9.81;", "-2*s.g/s.l*sin(x(1))", "REFUTED"),
        ("s.l = 0.7;\nl = 2*s.l;", "-g/l*sin(x(1))", "UNDECIDED"),
        ("s.l = 0.7;\nr.l = 0.9;\n", "-g/s.l*sin(x(1))", "UNDECIDED"),
    ],
)
def test_a_script_has_the_fields_of_its_record(head: str, last: str, verdict: str) -> None:
    m, l, g = P("m:kg l:m g:m/s^2")
    scene = pendulum(dynamicsymbols("theta"), m, 0, l, g)
    text = f"{head}\ndx = zeros(2, 1);\ndx(1) = x(2);\ndx(2) = {last};\n"
    try:
        found = mechanics.check(scene, text, blame=False).verdict.name
    except InputError:
        found = "UNDECIDED"
    assert found == verdict


def test_a_file_that_a_function_runs_first_gives_the_values_of_what_it_has() -> None:
    (function,) = functions('function y = f(a)\nrun("values.m");\ny = k*a;\nend\n', "k")
    assert function(a=3.0, k=2.0) == 6.0
    with pytest.raises(Unread, match="run"):
        functions('function y = f(a)\nk = 2;\nrun("values.m");\ny = k*a;\nend\n', "k")


MAKES = """function [model, count] = make()
import casadi.*
k = 3;
x = SX.sym('x');  % where it is
v = SX.sym('v');
F = MX.sym('F');
rhs = vertcat(v, ...
  max(F - k*x, x));
y = vertcat(x, v);
count = length(y);
model = Function('f', {y, F}, {rhs}, {'y', 'F'}, {'rhs'});
end
"""


def test_a_function_of_casadi_is_what_it_is_made_of() -> None:
    (function,) = functions(MAKES)
    assert list(function(y=np.array([1.0, 5.0]), F=7.0)) == [5.0, 4.0]
    with pytest.raises(Unread):
        functions(MAKES.replace("vertcat(x, v)", "vertcat(x, x)"))
    with pytest.raises(Unread):
        functions(MAKES.replace("{rhs}", "{rhs, y}"))


@pytest.mark.parametrize("body", ["n = 9007199254740993; y = n*x;", "y = x*3^40;"])
def test_integers_that_no_double_is_are_refused(body: str) -> None:
    with pytest.raises((ValueError, Unread), match="more than a double holds exactly"):
        (one,) = functions(f"function y = f(x)\n{body}\nend")
        one(x=1.0)


EULER = """function [dx] = euler(x, L)
dx = zeros(%s, 1);
dx(1) = (x(5) - x(6))*x(2)*x(3)/x(4) + L(1)/x(4);
dx(2) = (x(6) - x(4))*x(1)*x(3)/x(5) + L(2)/x(5);
dx(3) = (x(4) - x(5))*x(1)*x(2)/x(6) + L(3)/x(6);
%s
end
"""
SATELLITE = satellite_torque()
MEANT = {"x": "w1 w2 w3 I1 I2 I3", "L": "M1 M2 M3"}


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("size", "more", "verdict"),
    [("length(x)", "", "PROVED"), ("numel(x)", "", "PROVED"), ("6", "dx(4) = 0;", "PROVED"),
     ("6", "dx(4) = x(1);", ""), ("length(L)", "", "PROVED"), ("length(x)", "dx(3) = 0;", ""),
     ("length(x) + 1", "", "")],
)  # fmt: skip
def test_speeds_and_what_is_held_are_a_state(
    size: str, more: str, verdict: str, tmp_path: Path
) -> None:
    path, text = tmp_path / "euler.m", EULER % (size, more)
    for told, expected in (
        (text, verdict), (text.replace("L(2)/x(5)", "L(2)/x(4)"), verdict and "REFUTED"),
    ):  # fmt: skip
        path.write_text(told)
        try:
            found = mechanics.check(SATELLITE, path, names=MEANT, blame=False).verdict.name
        except InputError:
            found = ""
        assert found == expected


def test_a_branch_that_ends_in_an_error_has_no_value(tmp_path: Path) -> None:
    path = tmp_path / "own.m"
    path.write_text(
        "function a = accel(theta, u, m, l, g)\nif theta < 0, error('theta'); end\n"
        "a = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2);\nend\n"
    )
    (judged,) = mechanics.check(rod_pendulum.scene(), path, blame=False).judged
    assert judged.finding.domain == "except where theta < 0"


DETERMINANTS = {
    "rod.m": "function a = acc(theta, u, m, l, g)\n"
    "A = [m*l^2/3 0; 1 2];\na = (m*g*l*sin(theta) + 2*u)/det(A);\nend\n",
    "rod.jl": "function acc(theta, u, m, l, g)\n"
    "A = [m*l^2/3 0.0; 1.0 2.0]\nreturn (m*g*l*sin(theta) + 2*u)/det(A)\nend\n",
}


@pytest.mark.parametrize("name", DETERMINANTS)
def test_a_determinant_of_formulas(tmp_path: Path, name: str) -> None:
    text = DETERMINANTS[name]
    for written, verdict in ((text, "PROVED"), (text.replace("det(A)", "det(2*A)"), "REFUTED")):
        (tmp_path / name).write_text(written)
        assert mechanics.check(ROD, tmp_path / name, blame=False).verdict.name == verdict

"""Lines around a judged function: plain calls and known integrators are innocent, others quoted."""

from pathlib import Path

import pytest

import mechanics
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from systems import rod_pendulum

ROD = rod_pendulum.scene()
GIVEN = "m = 1; l = 0.5; g = 9.81; u = 0;\n"
MATLAB = """
function dydt = rate(t, y, m, l, g, u)
dydt = [y(2); 3*g/(2*l)*sin(y(1)) + 3*u/(m*l^2)];
end
"""
ACCELERATION = """
function a = accel(theta, w, u, m, l, g)
a = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2);
end
"""
JULIA = """function rate!(du, y, p, t)
    theta, w = y
    m, l, g, u = p
    du[1] = w
    du[2] = 3g/(2l)*sin(theta) + 3u/(m*l^2)
end
"""
C = """#include <math.h>
#include <stdio.h>
void rate(double t, const double *y, double *dydt, double m, double l, double g, double u)
{
  dydt[0] = y[1];
  dydt[1] = 3*g/(2*l)*sin(y[0]) + 3*u/(m*l*l);
}
double accel(double theta, double w, double u, double m, double l, double g)
{
  return 3*g/(2*l)*sin(theta) + 3*u/(m*l*l);
}
"""
EULER = "y = [0.1; 0]; dt = 0.01; t = 0;\nfor k = 1:100\n  d = rate(t, y, m, l, g, u);\n  {}\nend"
COLUMNS = """h = 0.01; N = 100; t = 0:h:N*h; y = zeros(2, N+1); y(:,1) = [0.1; 0];
for i = 1:N
    k1 = rate(t(i), y(:,i), m, l, g, u);
    k2 = rate(t(i) + h/2, y(:,i) + h/2*k1, m, l, g, u);
    k3 = rate(t(i) + h/2, y(:,i) + h/2*k2, m, l, g, u);
    k4 = rate(t(i) + h, y(:,i) + h*k3, m, l, g, u);
    y(:,i+1) = y(:,i) + h/6*(k1 + 2*k2 + 2*k3 + k4);
end"""
SCALARS = """dt = 0.01; theta = 0.1; w = 0;
for k = 1:100
  a = accel(theta, w, u, m, l, g);
  w = w + dt*a;
  theta = theta + dt*w;
end"""
VERLET = """dt = 0.01; theta = 0.1; w = 0;
a = accel(theta, w, u, m, l, g);
for k = 1:100
  theta = theta + dt*w + dt^2/2*a;
  b = accel(theta, w, u, m, l, g);
  w = w + dt/2*(a + b);
  a = b;
end"""
SOLVED = "[t, y] = ode45(@(t, y) {}, [0 1], [0.1; 0]);"
RK4 = """void step(double t, double *y, double dt, double m, double l, double g, double u)
{
  double k1[2], k2[2], k3[2], k4[2], tmp[2];
  rate(t, y, k1, m, l, g, u);
  for (int j = 0; j < 2; j++) tmp[j] = y[j] + 0.5*dt*k1[j];
  rate(t + 0.5*dt, tmp, k2, m, l, g, u);
  for (int j = 0; j < 2; j++) tmp[j] = y[j] + 0.5*dt*k2[j];
  rate(t + 0.5*dt, tmp, k3, m, l, g, u);
  for (int j = 0; j < 2; j++) tmp[j] = y[j] + dt*k3[j];
  rate(t + dt, tmp, k4, m, l, g, u);
  for (int j = 0; j < 2; j++) y[j] += dt/6*(k1[j] + 2*k2[j] + 2*k3[j] + k4[j]);
}
"""
MAIN = """int main(void)
{{
  double y[2] = {{0.1, 0}}, k[2], t = 0, dt = 0.01, m = 1, l = 1, g = 9.81, u = 0;
  FILE *out = fopen("motion.csv", "w");
  for (int i = 0; i < 1000; i++) {{
    {}
    t += dt;
    fprintf(out, "%g,%g\\n", t, y[0]);
  }}
  fclose(out);
  return 0;
}}
"""
ONE = "double th = 0.1, om = 0, h = 0.01;\n  for (int i = 0; i < 9; i++) {{\n    {}\n  }}"
SMALL = "int main(void)\n{{\n  {}\n  return 0;\n}}\n"
PENDULUM = "p = (1.0, 0.5, 9.81, 0.0)\n"
LOOP = f"{PENDULUM}y = [0.1, 0.0]\ndu = zeros(2)\ndt = 0.01\nfor k in 1:100\n  {{}}\nend\n"


def beside(folder: Path, suffix: str, text: str, function: str | None = None) -> tuple[str, ...]:
    path = folder / f"page{suffix}"
    path.write_text(text)
    options = {"function": function} if function else {}
    found = mechanics.check(ROD, path, blame=False, **options)
    assert found.verdict in (Verdict.PROVED, Verdict.CERTIFIED)
    return found.beside


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    "call",
    [
        "rate(y, t, m, l, g, u)", "rate(t, flipud(y), m, l, g, u)", "rate(t, -y, m, l, g, u)",
        "rate(t, y, l, m, g, u)", "rate(t, y, m, l, -g, u)", "rate(t, y, m, 2*l, g, u)",
        "rate(t, [y(2); y(1)], m, l, g, u)", "rate(t, y, 1, 1, -9.81, 0)",
        "-rate(t, y, m, l, g, u)", "flipud(rate(t, y, m, l, g, u))",
        "rate(t, y, m, l, g, u) + [0; y(2)]",
    ],
)  # fmt: skip
def test_a_handle_with_other_arguments_is_quoted(tmp_path: Path, call: str) -> None:
    solved = SOLVED.format(call)
    assert beside(tmp_path, ".m", GIVEN + solved + MATLAB) == (solved.rstrip(";"),)
    assert beside(tmp_path, ".m", f"{GIVEN}f = @(t, y) {call};{MATLAB}")


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    "lines",
    [
        EULER.format("y(1) = y(1) - dt*d(1);\n  y(2) = y(2) + dt*d(2);"),
        EULER.format("y(1) = y(1) + dt*d(2);\n  y(2) = y(2) + dt*d(1);"),
        EULER.format("y(2) = y(2) + dt*d(2);"), EULER.format("y = y + d;"),
        EULER.format("y = y - dt*d;"), EULER.format("y = y + m*d;"), EULER.format("y = dt*d;"),
        EULER.format("y = y + dt*d;\n  y = -y;"), EULER.format("y = y + dt*d;\n  g = -g;"),
        EULER.replace("dt = 0.01", "dt = -0.01").format("y = y + dt*d;"),
        COLUMNS.replace("2*k3 + k4", "k3 + k4"), COLUMNS.replace("h/2*k1, m", "h*k1, m"),
        COLUMNS.replace("h/2*k2, m, l", "h/2*k2, l, m"),
        COLUMNS.replace("i+1) = y(:,i)", "i+1) = y(:,1)"),
    ],
)  # fmt: skip
def test_a_loop_that_is_no_integrator_is_quoted(tmp_path: Path, lines: str) -> None:
    assert beside(tmp_path, ".m", GIVEN + lines + MATLAB)


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    "lines",
    [
        SCALARS.replace("accel(theta, w", "accel(w, theta"),
        SCALARS.replace("w + dt*a", "w - dt*a"),
        SCALARS.replace("end", "  if theta > pi\n    theta = theta - pi;\n  end\nend"),
        VERLET.replace("a + b", "a - b"), VERLET.replace("a = b", "a = -b"),
        SCALARS.replace("a = ", "a = -"), "theta = 0.1; w = 0;\na = accel(w, theta, u, m, l, g);",
        "a = accel(0.1, 0, u, m, l, g);\nb = -a;",
        SOLVED.format("[y(2); -accel(y(1), y(2), u, m, l, g)]"),
        SOLVED.format("[accel(y(1), y(2), u, m, l, g); y(2)]"),
    ],
)  # fmt: skip
def test_an_acceleration_that_is_used_otherwise_is_quoted(tmp_path: Path, lines: str) -> None:
    assert beside(tmp_path, ".m", GIVEN + lines + ACCELERATION)


MADE = "prob = ODEProblem(rate!, [0.1, 0.0], (0.0, 1.0), {})\n"


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    "text",
    [
        "prob = ODEProblem(rate!, [0.1, 0.0], (0.0, 1.0), (l, m, g, u))\n",
        "p = [m, l, -g, u]\nprob = ODEProblem(rate!, [0.1, 0.0], (0.0, 1.0), p)\n",
        "f = (du, y, p, t) -> rate!(du, p, y, t)\n",
        "function back!(du, y, p, t)\n  rate!(du, y, p, t)\n  du .*= -1\nend\n"
        "prob = ODEProblem(rate!, [0.1, 0.0], (0.0, 1.0), (m, l, g, u))\n",
        "function next!(y, p, t)\n  du = zeros(2)\n  rate!(du, y, p, t)\n  y .-= du\nend\n"
        "prob = ODEProblem(rate!, [0.1, 0.0], (0.0, 1.0), (m, l, g, u))\n",
        LOOP.format("rate!(du, y, p, 0.0)\n  y .-= dt .* du"),
        LOOP.format("rate!(du, y, p, 0.0)\n  y .+= dt .* reverse(du)"),
        LOOP.format("l = abs(y[2])\n  rate!(du, y, (m, l, g, u), 0.0)\n  y .+= dt .* du"),
        "r = (m=1.0, l=0.5, g=9.81, u=0.0)\n" + MADE.format("(r.l, r.m, r.g, r.u)"),
        "r = (m=1.0, l=0.5, g=9.81, u=0.0)\np = [r.l, r.m, r.g, r.u]\n" + MADE.format("p"),
        "r = Dict(:m => 1.0, :l => 0.5)\n" + MADE.format("(r[:l], r[:m], g, u)"),
        'r = Dict("m" => 1.0, "l" => 0.5)\n' + MADE.format('(r["l"], r["m"], g, u)'),
        MADE.format("(l=1.0, m=0.5, g=9.81, u=0.0)"),
        "p = (l=1.0, m=0.5, g=9.81, u=0.0)\n" + MADE.format("p"),
    ],
)  # fmt: skip
def test_julia_is_quoted(tmp_path: Path, text: str) -> None:
    given = "m, l, g, u = 1.0, 0.5, 9.81, 0.0\n"
    assert beside(tmp_path, ".jl", JULIA + given + text)


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("function", "text"),
    [
        ("rate", MAIN.format("rate(t, y, k, m, l, g, u); y[0] += dt*k[1]; y[1] += dt*k[0];")),
        ("rate", MAIN.format("rate(t, y, k, m, g, l, u); y[0] += dt*k[0]; y[1] += dt*k[1];")),
        ("rate", RK4.replace("y[j] += dt/6", "y[1 - j] += dt/6")),
        ("rate", RK4.replace("y[j] + dt*k3", "y[j] - dt*k3")),
        ("rate", RK4 + MAIN.format("step(t, y, -dt, m, l, g, u);")),
        ("rate", RK4 + MAIN.format("step(t, y, dt, m, l, g, u); y[1] = -y[1];")),
        ("rate", "void step(double *y, double dt)\n{\n  double k[2];\n"
         "  rate(0, y, k, 1, 1, 9.81, 0);\n  y[0] += dt*k[1];\n  y[1] += dt*k[0];\n}\n"),
        ("rate", "#define BACK(y, k) rate(0, y, k, 1, 1, -9.81, 0)\n"),
        ("accel", SMALL.format(ONE.format(
            "double a = -accel(th, om, 0, 1, 1, 9.81); om += h*a; th += h*om;"))),
        ("accel", SMALL.format(ONE.format(
            "double a = accel(th, om, 0, 1, 1, 9.81); om += h*a; th -= h*om;"))),
        ("accel", SMALL.format(ONE.format(
            "double l = fabs(om), a = accel(th, om, 0, 1, l, 9.81); om += h*a; th += h*om;"))),
        ("accel", SMALL.format(ONE.format(
            "double a = accel(th, om, 0, 1, 1, 9.81); om += h*th; th += h*om;"))),
        ("accel", SMALL.format(
            "auto f = [&](double theta, double w) { return -accel(theta, w, 0, 1, 1, 9.81); };")),
    ],
)  # fmt: skip
def test_c_plus_plus_is_quoted_though_a_function_is_named(
    tmp_path: Path, function: str, text: str
) -> None:
    assert beside(tmp_path, ".cpp", C + text, function)


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    "lines",
    [
        SOLVED.format("rate(t, y, m, l, g, u)"), SOLVED.format("rate(t, y, m, l, g, -K*y)"),
        SOLVED.format("rate(t, y, 1, 0.5, 9.81, 0)"),
        "[t, y] = ode45(@rate, [0 1], [0.1; 0], [], m, l, g, u);",
        "x = lsode(@(x, t) rate(t, x, m, l, g, u), [0.1; 0], linspace(0, 1));",
        "f = @(t, y) rate(t, y, m, l, g, u);\n[t, y] = ode45(@(t, y) f(t, y), [0 1], [0.1; 0]);",
        EULER.format("y = y + dt*d;\n  t = t + dt;"),
        EULER.format("y(1) = y(1) + dt*d(1);\n  y(2) = y(2) + dt*d(2);\n  Y(:, k) = y;"), COLUMNS,
        EULER.format("y(1:2) = y(1:2) + dt*d(1:2);"),
        EULER.format("e = rate(t + dt, y + dt*d, m, l, g, u);\n  y = y + dt/2*(d + e);"),
        EULER.format("y(2) = y(2) + dt*d(2);\n  y(1) = y(1) + dt*y(2);"),
        "y = zeros(2, 1);\ndx = rate(0, y, m, l, g, u);",
        "dx = rate(0, [pi/2; 0], 1, 1, 9.81, 0);\nassert(abs(dx(2) - 14.715) < 1e-9)",
    ],
)  # fmt: skip
def test_matlab_is_innocent(tmp_path: Path, lines: str) -> None:
    assert not beside(tmp_path, ".m", GIVEN + lines + MATLAB)


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    "lines", [SCALARS, SOLVED.format("[y(2); accel(y(1), y(2), u, m, l, g)]"), VERLET,
              SCALARS.replace("end", "  if theta > pi\n    theta = theta - 2*pi;\n  end\nend"),
              "theta = pi/6; w = 0;\na = accel(theta, w, u, m, l, g)"],
)  # fmt: skip
def test_an_acceleration_is_used_innocently(tmp_path: Path, lines: str) -> None:
    assert not beside(tmp_path, ".m", GIVEN + lines + ACCELERATION)


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    "text",
    [
        "prob = ODEProblem(rate!, [0.1, 0.0], (0.0, 1.0), (m, l, g, u))\nsol = solve(prob)\n",
        LOOP.format("rate!(du, y, p, 0.0)\n  y .+= dt .* du\n  push!(ys, copy(y))"),
        LOOP.format("l = 0.5\n  rate!(du, y, (m, l, g, u), 0.0)\n  y .+= dt .* du"),
        "r = (l=0.5, m=1.0, g=9.81, u=0.0)\np = [r.m, r.l, r.g, r.u]\n" + MADE.format("p"),
        "r = Dict(:l => 1.0, :m => 0.5)\n" + MADE.format("(r[:m], r[:l], g, u)"),
        MADE.format("(m=1.0, l=0.5, g=9.81, u=0.0)"),
        "function run()\n  y = [0.1, 0.0]; du = similar(y); h = 0.01; t = 0.0\n  while t < 10\n"
        "    rate!(du, y, (1.0, 0.5, 9.81, 0.0), t)\n    y[1] += h*du[1]\n    y[2] += h*du[2]\n"
        "    t += h\n  end\nend\n",
    ],
)  # fmt: skip
def test_julia_is_innocent(tmp_path: Path, text: str) -> None:
    given = "m, l, g, u = 1.0, 0.5, 9.81, 0.0\n"
    assert not beside(tmp_path, ".jl", JULIA + given + text)


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    ("function", "text"),
    [
        ("rate", MAIN.format("rate(t, y, k, m, l, g, u); y[0] += dt*k[0]; y[1] += dt*k[1];")),
        ("rate", RK4), ("rate", RK4 + MAIN.format("step(t, y, dt, m, l, g, u);")),
        ("accel", SMALL.format(ONE.format(
            "double a = accel(th, om, 0, 1, 1, 9.81); om += h*a; th += h*om;"))),
        ("accel", SMALL.format('printf("%g\\n", accel(0.1, 0, 0, 1, 1, 9.81));')),
    ],
)  # fmt: skip
def test_c_plus_plus_is_innocent(tmp_path: Path, function: str, text: str) -> None:
    assert not beside(tmp_path, ".cpp", C + text, function)


OPTIONS = "o = odeset({});\n[t, y] = ode45(@(t, y) rate(t, y, m, l, g, u), [0 1], [0.1; 0], o);"
AGAIN = """y0 = [0.1; 0];
for i = 1:9
  [t, y] = ode45(@(t, y) rate(t, y, m, l, g, u), [i i+1], y0);
  y0 = {};
end"""
PROBLEM = "p = (1.0, 0.5, 9.81, 0.0)\nprob = ODEProblem(rate!, [0.1, 0.0], (0.0, 1.0), p)\n"


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    "lines",
    [
        SOLVED.format("rate(t, y, m, l, g, u)").replace("@(t, y)", "@(y, t)"),
        "f = @(y, t) rate(t, y, m, l, g, u);\n[t, y] = ode45(f, [0 1], [0.1; 0]);",
        OPTIONS.format("'Mass', [1 0; 0 2]"), OPTIONS.format("'NonNegative', 2"),
        SOLVED.format("rate(t, y, m, y(2), g, u)"), SOLVED.format("rate(t, y, m, l, g, -u)"),
        SOLVED.format("rate(t, y, m, l, 0, u)"), "p = struct('m', 1, 'g', -9.81);",
        "x = lsode(@(t, y) rate(t, y, m, l, g, u), [0.1; 0], linspace(0, 1));",
        "[t, y] = ode45(@(t, y) rate(t, y, m, l, g, u), [0.1; 0], [0 1]);",
        "[y, t] = ode45(@(t, y) rate(t, y, m, l, g, u), [0 1], [0.1; 0]);",
        'x = lsode("rate", [0.1; 0], linspace(0, 1));', "c = {l, m};\n[m, l] = c{:};", "l = l/2;",
        "[m, l] = deal(l, m);", "g = abs(g)*-1;", "p.l = l;\np = setfield(p, 'l', p.l/2);",
        "key = 'Mass';\n" + OPTIONS.format("key, [1 0; 0 2]"),
        OPTIONS.format("key, 1").replace("; 0], o)", "; 0], odeset(key, 1))"),
        "load('o.mat');\n" + OPTIONS.partition("\n")[2], OPTIONS.partition("\n")[2],
        "f = str2func('@(t, y) [y(2); y(1)]');\n[t, y] = ode45(f, [0 1], [0.1; 0]);",
        AGAIN.format("fliplr(y(end, :))'"), AGAIN.format("-y(end, :)'"),
        AGAIN.format("[y(end, 1); -y(end, 2)]"), AGAIN.format("[y(end, 2); y(end, 1)]"),
        AGAIN.format("y(end, :)';\n  y0(2) = -0.9*y(end, 2)"),
        AGAIN.format("y(end, :)';\n  y0(2) = 0"),
        AGAIN.format("[b; a]").replace("  y0", "  [a, b] = deal(y(end, 1), y(end, 2));\n  y0"),
        AGAIN.format("[w(end); a(end)]").replace("  y0", "  a = y(:, 1); w = y(:, 2);\n  y0"),
        EULER.format("y = y + dt*d;\n  l = abs(y(2));"),
        "c = {l, m, g, u};\n" + SOLVED.format("rate(t, y, c{:})"),
        EULER.format("y = y + dt*d;") + "\ny = flipud(y);\n" + EULER.format("y = y + dt*d;")[28:],
    ],
)  # fmt: skip
def test_what_a_solver_is_given_that_is_another_law_is_quoted(tmp_path: Path, lines: str) -> None:
    assert beside(tmp_path, ".m", GIVEN + lines + MATLAB)


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    "lines",
    [
        OPTIONS.format("'RelTol', 1e-8, 'AbsTol', 1e-9"), "p = struct('m', 1, 'g', 9.81);",
        "f = @(t, y) rate(t, y, m, l, g, u);\n[t, y] = ode45(f, [0 1], [0.1; 0]);",
        OPTIONS.replace("\n", "\no = odeset(o, 'MaxStep', 0.1);\no.AbsTol = 1e-9;\n").format(
            "'RelTol', 1e-8"),
        "c = {m, l, g, u};\n" + SOLVED.format("rate(t, y, c{:})"),
        "f = str2func('rate');\n" + SOLVED.format("f(t, y, m, l, g, u)"),
        AGAIN.format("[a; y(n, 2)]").replace("  y0", "  n = length(t); a = y(n, 1);\n  y0"),
        AGAIN.format("[a(end); w(end)]").replace("  y0", "  a = y(:, 1); w = y(:, 2);\n  y0"),
        AGAIN.format("y(end, :)'"), AGAIN.format("[y(end, 1); y(end, 2)]"),
        AGAIN.format("y(end, :)';\n  y0(2) = y(end, 2)"),
        EULER.format("y = y + dt*d;") + "\ny = 180/pi*y;\nplot(y)",
    ],
)  # fmt: skip
def test_options_that_leave_the_law_are_innocent(tmp_path: Path, lines: str) -> None:
    assert not beside(tmp_path, ".m", GIVEN + lines + MATLAB)


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    "lines",
    [
        "m, l = 1.0, 0.5\nlet l = m\n  prob2 = remake(prob, p=(m, l, 9.81, 0.0))\nend",
        "prob2 = remake(prob, p=(1.0, 1.0, -9.81, 0.0))",
        "q = (1.0, 1.0, -9.81, 0.0)\nprob2 = remake(prob; p=q)",
        "prob.p[3] = -9.81",
        "integrator = init(prob, Tsit5())\nintegrator.u[2] *= -1",
        "f = ODEFunction(rate!, mass_matrix=[1.0 0; 0 2.0])",
        "prob2 = ODEProblem(rate!, [0.1, 0.0], (0.0, 1.0), (1.0, 1.0, 0.0, 0.0))",
        "m, l, g, u = 1.0, 0.5, 9.81, 0.0\nprob2 = remake(prob, p=(l, m, g, u))",
        "prob2 = DiscreteProblem(rate!, [0.1, 0.0], (0, 10), p)",
        "m, l, g, u = 1.0, 0.5, 9.81, 0.0\nprob2 = NonlinearProblem(rate!, [0.1, 0], (l, m, g, u))",
        "sol = solve(prob, Tsit5(), callback=cb)",
        'include("bounce.jl")\nsol = solve(remake(prob; callback=bounce), Tsit5())',
        "sol = solve(prob, Tsit5(); callback)",
        "kw = (callback=cb,)\nsol = solve(prob, Tsit5(); kw...)",
        "sol = solve(prob, Tsit5(); options...)",
        "cb = bounce()\nsol = solve(prob; callback=cb)",
        "cb = DiscreteCallback((u, t, i) -> true, i -> (i.u[2] *= 0.5))\n"
        "sol = solve(prob, Tsit5(); callback=cb)",
        "hit!(i) = (i.u[2] = -i.u[2])\ncb = ContinuousCallback((u, t, i) -> u[1], hit!)\n"
        "sol = solve(prob; callback=CallbackSet(cb))",
        "cb = PresetTimeCallback([1.0], i -> set_u!(i, [0, 0]))\nsol = solve(prob; callback=cb)",
        "sol = solve(prob, FunctionMap(), dt=0.1)",
        "alg = FunctionMap()\nsol = solve(prob, alg)",
        "reverse!(prob.p)",
        "sort!(p)",
        "replace!(prob.p, 0.5 => -0.5)",
        "q = p\nreverse!(q)",
        "using LinearAlgebra\nlmul!(Diagonal([1, -1, 1, 1]), prob.p)",
        "p = reverse(p)",
        "integrator = init(prob, Tsit5())\nfor i in 1:9\n  reverse!(integrator.u)\nend",
        "s = solve(prob)\nprob2 = remake(prob, u0=-s.u[end])",
        "s = solve(prob)\nu0 = [s.u[end][2], s.u[end][1]]\nprob2 = remake(prob, u0=u0)",
        "prob2 = remake(prob, u0=-solve(prob).u[end])",
        "v = solve(prob).u[end]\nv[2] = -v[2]\nprob2 = remake(prob, u0=v)",
        "p = [1.0, 0.5, 9.81, 0.0]\np[1], p[2] = p[2], p[1]\nprob2 = remake(prob, p=p)",
        "kw = Dict(:callback => cb)\nsol = solve(prob; kw...)",
        "sol = solve(prob, alg)",
        "run(prob; kw...) = solve(prob, Tsit5(); kw...)\nrun(prob; callback=cb)",
        "function run(prob; kw...)\n  solve(prob; kw...)\nend\nsol = run(prob; callback=cb)",
    ],
)
def test_a_problem_that_is_made_again_otherwise_is_quoted(tmp_path: Path, lines: str) -> None:
    assert beside(tmp_path, ".jl", JULIA + PROBLEM + lines + "\n")


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    "line",
    [
        "double a = accel(th, om, 0, om, 1, 9.81); om += h*a; th += h*om;",
        "double a = accel(th, om, 0, 1, th, 9.81); om += h*a; th += h*om;",
        "double a = accel(th, om, 0, 1, 1, h); om += h*a; th += h*om;",
    ],
)
def test_what_moves_or_is_a_step_is_no_parameter(tmp_path: Path, line: str) -> None:
    assert beside(tmp_path, ".cpp", C + SMALL.format(ONE.format(line)), "accel")


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    "lines",
    [
        "sol = solve(prob, Tsit5(), reltol=1e-8, abstol=1e-8, saveat=0.1)",
        "prob2 = remake(prob, u0=[0.2, 0.0])\nsol = solve(prob2, Tsit5())",
        "prob2 = remake(prob; p=(2.0, 1.0, 9.81, 0.0), tspan=(0.0, 2.0))",
        "f = ODEFunction(rate!)\nprob2 = ODEProblem(f, [0.1, 0.0], (0.0, 10.0), p)",
        "integrator = init(prob, Tsit5())\nfor i in 1:10\n  step!(integrator, 0.1)\nend",
        "alg = Rodas5P()\nsol = solve(prob, alg; callback=TerminateSteadyState(), saveat)",
        "kw = (reltol=1e-8, abstol=1e-8)\nsol = solve(prob, Vern7(); kw..., saveat=0.1)",
        "xs = [2.0, 1.0]\nsort!(xs)\npush!(xs, 0.1)\nplot!(xs)\nsol = solve(prob)",
        "for i in 1:9\n  s = solve(prob, Tsit5())\n  global prob = remake(prob, u0=s.u[end])\nend",
        "s = solve(prob)\nu0 = [s.u[end][1], s.u[end][2]]\nprob2 = remake(prob, u0=u0)",
        "prob2 = remake(prob, u0=solve(prob).u[end])",
        "saveat = 0.0:0.1:1.0\nsol = solve(prob, OrdinaryDiffEq.Vern9(); saveat)",
    ],
)
def test_a_problem_that_is_solved_is_innocent(tmp_path: Path, lines: str) -> None:
    assert not beside(tmp_path, ".jl", JULIA + PROBLEM + lines + "\n")


KIND = """#include <cmath>
struct Rod {
  double m, l, g, theta, omega;
  void step(double u, double dt) {
    double a = 3*g/(2*l)*std::sin(theta) + 3*u/(m*l*l);
    theta += omega*dt;
    omega += a*dt;
  }
};
"""
BUILT = KIND.replace("  double m, l, g, theta, omega;",
    "  double m, l, g, theta = 0.1, omega = 0;\n"
    "  Rod(double m_, double l_, double g_) : m(m_), l(l_), g(g_) {}")  # fmt: skip
SHARED = """#include <math.h>
static double theta = 0.1, omega = 0;
void step(double u, double m, double l, double g, double dt) {
  double a = 3*g/(2*l)*sin(theta) + 3*u/(m*l*l);
  omega += a*dt;
  theta += omega*dt;
}
"""
RUN = (
    "int main() {{ double m = 1, l = 2, g = 9.81, u = 0, dt = 0.1; {}\n"
    "  for (int i = 0; i < 9; ++i) {{ {} }} }}"
)


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("suffix", "kind", "made", "turn"),
    [
        (".cpp", KIND, "Rod rod{l, m, g, 0.1, 0};", "rod.step(u, dt);"),
        (".cpp", KIND, "Rod rod{1, 2, -9.81, 0.1, 0};", "rod.step(u, dt);"),
        (".cpp", KIND, "Rod rod{m, l, g, 0.1, 0};", "rod.step(dt, u);"),
        (".cpp", KIND, "Rod rod{m, l, g, 0.1, 0};", "rod.step(u, dt); rod.omega *= 0.5;"),
        (".cpp", BUILT, "Rod rod(l, m, g);", "rod.step(u, dt);"),
        (".cpp", BUILT, "Rod rod(1, 2, -9.81);", "rod.step(u, dt);"),
        (".c", SHARED, "", "step(u, m, l, g, dt); omega = -omega;"),
        (".c", SHARED, "", "step(u, omega, l, g, dt);"),
    ],
)
def test_an_object_with_other_parameters_or_a_changed_state_is_quoted(
    tmp_path: Path, suffix: str, kind: str, made: str, turn: str
) -> None:
    assert beside(tmp_path, suffix, kind + RUN.format(made, turn))


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    ("suffix", "kind", "made", "turn"),
    [
        (".cpp", KIND, "Rod rod{m, l, g, 0.1, 0};", "rod.step(u, dt);"),
        (".cpp", KIND, "Rod rod{1, 2, 9.81, -0.1, 0};", "rod.step(0.0, 0.01);"),
        (".cpp", BUILT, "Rod rod(m, l, g);", "rod.step(u, dt);"),
        (".c", SHARED, "theta = 0.2; omega = 0;", "step(u, m, l, g, dt);"),
    ],
)
def test_an_object_with_its_parameters_is_innocent(
    tmp_path: Path, suffix: str, kind: str, made: str, turn: str
) -> None:
    assert not beside(tmp_path, suffix, kind + RUN.format(made, turn))


@pytest.mark.sample(8)
@pytest.mark.parametrize("suffix", [".c", ".cpp"])
def test_a_main_below_is_no_part_of_what_is_judged(tmp_path: Path, suffix: str) -> None:
    below = SMALL.format(
        "double th = 0.1, om = 0, h = 0.01;\n"
        "  for (int i = 0; i < 9; i++) { om += h*accel(th, om, 0, 1, 1, 9.81); th += h*om; }"
    )
    only = f"#include <math.h>\ndouble accel{C.partition('double accel')[2]}"
    assert not beside(tmp_path, suffix, only + below)
    assert beside(tmp_path, suffix, only + below.replace("om += h", "om -= h"))
    alone = tmp_path / f"alone{suffix}"
    alone.write_text((only + below).replace("sin(theta)", "sin(2*theta)"))
    assert mechanics.check(ROD, alone, blame=False).verdict is Verdict.REFUTED


UNDRIVEN = MATLAB.replace(", u)", ")").replace(" + 3*u/(m*l^2)", "")
HANDLE = """f = @(t, y) [y(2); 3*g/(2*l)*sin(y(1)) + 3*u/(m*l^2)];
[t, y] = ode45(f, [0 1], [0.1; 0]);
"""


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    "text",
    [
        GIVEN + SOLVED.format("rate(t, y, m, l, g)") + UNDRIVEN,
        GIVEN + HANDLE,
        SOLVED.replace("@(t, y) {}", "@rate") + MATLAB.replace("(t, y, m, l, g, u)",
            f"(t, y)\n{GIVEN.strip()}"),
    ],
)  # fmt: skip
def test_a_value_of_an_input_that_the_script_gives_is_no_mistake(tmp_path: Path, text: str) -> None:
    path = tmp_path / "page.m"
    path.write_text(text)
    found = mechanics.check(ROD, path, blame=False)
    assert found.verdict is Verdict.UNDECIDED
    assert [e.right_if for e in found.judged] == [
        (),
        ("u = 0, as the code says; as an argument u is judged for all values",),
    ]
    path.write_text(text.replace("sin", "cos"))
    assert mechanics.check(ROD, path, blame=False).verdict is Verdict.REFUTED


def test_a_function_that_leaves_out_an_input_which_it_takes_is_wrong(tmp_path: Path) -> None:
    path = tmp_path / "page.m"
    path.write_text(GIVEN + SOLVED.format("rate(t, y, m, l, g, u)")
                    + MATLAB.replace(" + 3*u/(m*l^2)", " + 0*u"))  # fmt: skip
    assert mechanics.check(ROD, path, blame=False).verdict is Verdict.REFUTED


@pytest.mark.sample(3)
@pytest.mark.parametrize("suffix", [".c", ".cpp"])
@pytest.mark.parametrize("change", ["k = 1.0;", "double *q = &k; *q = 1.0;", "k++;"])
def test_what_main_sets_is_no_number_of_the_file(tmp_path: Path, suffix: str, change: str) -> None:
    path = tmp_path / f"rod{suffix}"
    text = (
        "#include <math.h>\nstatic double k = 1.5;\n"
        "double accel(double theta, double u, double m, double l, double g)\n"
        "{ return k*g/l*sin(theta) + 3*u/(m*l*l); }\n"
        "int main(void) { %s return accel(0.1, 0.0, 1.0, 1.0, 9.81) > 0; }\n"
    )
    path.write_text(text % "")
    assert mechanics.check(rod_pendulum.scene(), path, blame=False).verdict is Verdict.PROVED
    for function in (None, "accel"):
        path.write_text(text % change)
        with pytest.raises(InputError):
            mechanics.check(rod_pendulum.scene(), path, blame=False, function=function)


def test_a_record_whose_entries_have_names_has_any_order(tmp_path: Path) -> None:
    function = JULIA.replace("m, l, g, u = p", "(; m, l, g, u) = p")
    assert not beside(tmp_path, ".jl", function + MADE.format("(l=1.0, m=0.5, g=9.81, u=0.0)"))
    other = JULIA + MADE.format("(l=1.0, m=0.5, g=9.81, u=0.0)")
    assert beside(tmp_path, ".jl", other)


@pytest.mark.sample(8)
@pytest.mark.parametrize(("made", "quoted"), [("o = odeset('RelTol', 1e-8);", False), ("", True)])
def test_options_that_another_function_makes(tmp_path: Path, made: str, quoted: bool) -> None:
    solve = f"function y = solved(f)\n{made}\n[t, y] = ode45(f, [0 1], [0.1; 0], o);\nend\n"
    script = GIVEN + "y = solved(@(t, y) rate(t, y, m, l, g, u));\n"
    assert bool(beside(tmp_path, ".m", script + MATLAB + solve, "rate")) == quoted


AFTER = "om += h*accel(th, om, 0, 1, 1, 9.81); th += h*om; "


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    ("line", "quoted"),
    [
        ("(th > 1) && (om = -om);", True), ("th > 1 or (om = -om);", True),
        ("int q; q = 1, om = -om;", True), ("double q = om = -om;", True),
        ("double q = th > 1 ? (om = -om) : 0;", True), ("do { om = -om; } while (0);", True),
        ("for (int q = 0; q < 1; q++, om = -om) {}", True), ("while (om = -om) {}", True),
        ("for (auto *v : {&om}) *v = -*v;", True), ('printf("%g", om = -om);', True),
        ('(th > 1) && printf("%g", th);', False), ("int q, z; q = 1, z = 2;", False),
        ("double q, z; q = z = 1;", False),
        ('if (th > 1 && om < 3) printf("%g", th);', False),
    ],
)  # fmt: skip
def test_what_a_formula_and_a_loop_of_c_set_is_seen(
    tmp_path: Path, line: str, quoted: bool
) -> None:
    assert bool(beside(tmp_path, ".cpp", C + SMALL.format(ONE.format(AFTER + line)), "accel")
                ) is quoted  # fmt: skip


ADVANCED = "m, l, g, u = 1.0, 0.5, 9.81, 0.0\n" + LOOP.format(
    "rate!(du, y, p, 0.0)\n  y .+= dt .* du\n  {}"
)


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    ("line", "quoted"),
    [
        ("y[1] > 1 && (y[2] = -y[2])", True), ("y[1] > 1 || (y .= -y)", True),
        ("y[1] > 1 && println(y)", False), ("q = z = 3", False),
    ],
)  # fmt: skip
def test_what_a_formula_of_julia_sets_is_seen(tmp_path: Path, line: str, quoted: bool) -> None:
    assert bool(beside(tmp_path, ".jl", JULIA + ADVANCED.format(line))) is quoted


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    ("line", "quoted"),
    [
        ("y[1] > 1 && continue", True), ("y[1] > 1 && break", False),
        ("if y[1] > 1 break end", False), ("if y[1] > 1 continue end", True),
    ],
)  # fmt: skip
def test_a_line_that_skips_a_part_of_a_step_is_seen(
    tmp_path: Path, line: str, quoted: bool
) -> None:
    lines = f"{line}\n  rate!(du, y, p, 0.0)\n  y .+= dt .* du"
    given = "m, l, g, u = 1.0, 0.5, 9.81, 0.0\n"
    assert bool(beside(tmp_path, ".jl", JULIA + given + LOOP.format(lines))) is quoted


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    ("line", "quoted"),
    [
        ("if (th > 1) continue;", True), ("if (th > 1) goto end;", True),
        ("if (th > 1) break;", False), ("if (th > 1) return 1;", False),
        ('switch (i) { case 1: printf("%g", th); break; }', False),
        ("switch (i) { case 1: om = -om; break; }", True),
    ],
)  # fmt: skip
def test_a_jump_of_c_is_seen(tmp_path: Path, line: str, quoted: bool) -> None:
    text = C + SMALL.format(ONE.format(f"{line} {AFTER}"))
    assert bool(beside(tmp_path, ".cpp", text, "accel")) is quoted


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    ("line", "quoted"),
    [
        ("if theta > pi, theta = theta - 2*pi; end", False),
        ("if w > pi, w = w - 2*pi; end", True),
        ("if theta > pi, theta = theta - 1.0*pi; end", True),
        ("if theta > pi, theta = theta - tau; end", True),
        ("pi = 3; if theta > pi, theta = theta - 2*pi; end", True),
    ],
)  # fmt: skip
def test_only_a_whole_turn_of_an_angle_says_nothing(
    tmp_path: Path, line: str, quoted: bool
) -> None:
    lines = SCALARS.replace("end", f"  {line}\nend")
    assert bool(beside(tmp_path, ".m", GIVEN + lines + ACCELERATION)) is quoted


JULIA_HEUN = (
    "y0 = {}\n  rate!(du, y, p, 0.0)\n  k = copy(du)\n  {}\n  rate!(du, y, p, 0.0)\n"
    "  y = y0 .+ dt/2 .* (k .+ du)"
)


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    ("start", "line", "quoted"),
    [
        ("y", "y .+= dt .* k", True), ("y", "y .= y .+ dt .* k", True),
        ("y", "y += dt .* k", False), ("copy(y)", "y .+= dt .* k", False),
        ("copy(y)", "y .= y0 .+ dt .* k", False),
    ],
)  # fmt: skip
def test_two_names_of_an_array_of_julia_are_one(
    tmp_path: Path, start: str, line: str, quoted: bool
) -> None:
    text = "m, l, g, u = 1.0, 0.5, 9.81, 0.0\n" + LOOP.format(JULIA_HEUN.format(start, line))
    assert bool(beside(tmp_path, ".jl", JULIA + text)) is quoted

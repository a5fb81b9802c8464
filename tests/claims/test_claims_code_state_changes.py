"""A state that is changed beside the steps of an integrator is quoted; all usual programs are not.

The wrong line must be among those that are quoted.
"""

from pathlib import Path

import pytest

import mechanics
from mechanics.kernel import Verdict
from systems import rod_pendulum

ROD = rod_pendulum.scene()
LAW = "3*g/(2*l)*sin({}) + 3*u/(m*l*l)"
INCLUDES = "#include <math.h>\n#include <stdio.h>\n#include <stdlib.h>\n"
ACCEL = INCLUDES + (
    "double accel(double theta, double w, double u, double m, double l, double g)\n"
    f"{{ return {LAW.format('theta')}; }}\n"
)
RATE = INCLUDES + (
    "void rate(double t, const double *y, double *dydt, double m, double l, double g, double u)\n"
    f"{{ dydt[0] = y[1]; dydt[1] = {LAW.format('y[0]')}; }}\n"
)
KIND = (
    "#include <cmath>\n#include <cstdio>\nstruct Rod {\n  double m, l, g, theta, omega;\n"
    "  void step(double u, double dt) {\n"
    f"    double a = {LAW.format('theta')};\n"
    "    theta += omega*dt;\n    omega += a*dt;\n  }\n};\n"
)
SHARED = (
    "#include <math.h>\nstatic double theta = 0.1, omega = 0;\n"
    "void step(double u, double m, double l, double g, double dt) {\n"
    f"  double a = {LAW.format('theta')};\n  omega += a*dt;\n  theta += omega*dt;\n}}\n"
)
STATE = "typedef struct {{ double theta, omega; } State;\n".replace("{{", "{")
ASKED = "accel(th, om, 0, 1, 1, 9.81)"
STEP = f"om += h*{ASKED}; th += h*om;"
STEPS = "rate(t, y, k, 1, 1, 9.81, 0); y[0] += h*k[0]; y[1] += h*k[1]; t += h;"
FIELDS = "s.omega += h*accel(s.theta, s.omega, 0, 1, 1, 9.81); s.theta += h*s.omega;"
ONE = "double th = 0.1, om = 0, h = 0.01;"
TWO = "double y[2] = {0.1, 0}, k[2], t = 0, h = 0.01;"
LOOP = "for (int i = 0; i < 9; i++)"


def program(function: str, given: str, lines: str, head: str = LOOP, after: str = "") -> str:
    return f"{function}int main(void)\n{{\n  {given}\n  {head} {{ {lines} }}\n  {after}\n}}\n"


def one(lines: str, given: str = "", head: str = LOOP, after: str = "", above: str = "") -> str:
    return program(ACCEL + above, ONE + given, lines, head, after)


def two(lines: str, given: str = "", head: str = LOOP, after: str = "", above: str = "") -> str:
    return program(RATE + above, TWO + given, lines, head, after)


def record(lines: str, given: str = "") -> str:
    return program(ACCEL + STATE, "State s = {0.1, 0}; double h = 0.01;" + given, lines)


def rod(lines: str, given: str = "") -> str:
    start = "double m = 1, l = 2, g = 9.81, u = 0, dt = 0.1; Rod rod{m, l, g, 0.1, 0};"
    return program(KIND, start + given, lines)


def shared(lines: str, given: str = "") -> str:
    start = "double m = 1, l = 2, g = 9.81, u = 0, dt = 0.1;"
    return program(SHARED, start + given, lines)


def sketch(lines: str, above: str = "", setup: str = "") -> str:
    function = "#include <Arduino.h>\n" + ACCEL.replace(INCLUDES, "#include <math.h>\n")
    return (
        f"{function}{ONE}\n{above}void setup() {{ Serial.begin(9600); {setup} }}\n"
        f"void loop() {{ {lines} Serial.println(th); delay(10); }}\n"
    )


def quoted(folder: Path, suffix: str, text: str, function: str | None) -> tuple[str, ...]:
    path = folder / f"page{suffix}"
    path.write_text(text)
    options = {"function": function} if function else {}
    found = mechanics.check(ROD, path, blame=False, **options)
    assert found.verdict in (Verdict.PROVED, Verdict.CERTIFIED, Verdict.UNDECIDED)
    assert found.verdict is not Verdict.UNDECIDED or any(e.right_if for e in found.judged)
    return found.beside


AGAIN = f"{LOOP} {{ {STEP} }}"
AGAIN_TWO = f"{LOOP} {{ {STEPS} }}"
KICK = "void kick(double *v) { *v *= 0.9; }\n"
C_WRONG = [
    ("accel", one(STEP + " *p -= h*0.5;", "double *p = &om;"), "*p -="),
    ("accel", one(STEP + " p[0] = -p[0];", "double *p = &om;"), "p[0] ="),
    ("accel", one(f"*p -= h*{ASKED}; th += h*om;", "double *p = &om;"), "*p -="),
    ("rate", two(STEPS + " *p *= 0.9;", "double *p = y + 1;"), "*p *="),
    ("rate", two(STEPS + " *p *= 0.9;", "double *p = &y[1];"), "*p *="),
    ("rate", two(STEPS + " p[1] *= 0.9;", "double *p; p = y;"), "p[1] *="),
    ("rate", two(STEPS + " (*q)[1] *= 0.9;", "double *p = y, **q = &p;"), "(*q)[1] *="),
    ("rate", two(STEPS + " *(y + 1) *= 0.9;"), "*(y + 1) *="),
    ("rate", two(STEPS + " for (double *p = y; p < y + 2; ) *p++ *= 0.9;"), "*p++ *="),
    ("rate", two(STEPS + " s.v[1] *= 0.9;", "struct { double *v; } s; s.v = y;"), "s.v[1] *="),
    ("rate", two(STEPS + " q[1] *= -1;", "double *q = k;"), "q[1] *="),
    ("accel", record(FIELDS.replace("omega +=", "omega -=")), "s.omega -="),
    ("accel", record(FIELDS + " q->omega *= 0.9;", "State *q = &s;"), "q->omega *="),
    ("accel", record(FIELDS + " (*q).omega *= 0.9;", "State *q = &s;"), "(*q).omega *="),
    ("accel", record(FIELDS + " *v *= 0.9;", "double *v = &s.omega;"), "*v *="),
    ("accel", record(FIELDS + " b = s; b.omega = -b.omega; s = b;", "State b;"), "b.omega ="),
    ("accel", one(STEP, head="for (double t = 0; t < 1; t += h, om *= 0.9)"), "om *= 0.9"),
    ("accel", one(STEP, head="for (double t = 0; (om *= 0.9) < 9; t += h)"), "om *= 0.9"),
    ("accel", one("th += h*om;", head=f"for (double t = 0; t < 1; om -= h*{ASKED})"), "om -="),
    ("accel", one(STEP).replace("double th = 0.1, om = 0,", "int th = 1, om = 0; double"), "int"),
    ("accel", one(STEP).replace("double th", "float th"), "float th"),
    ("accel", one(STEP).replace(", h = 0.01;", "; int h = 0.01;"), "int h"),
    ("accel", one(f"int a = {ASKED}; om += h*a; th += h*om;"), "int a"),
    ("accel", one(f"om += h*(int){ASKED}; th += h*om;"), "(int)"),
    ("accel", one(STEP, after=f"om = 0; {AGAIN}"), "om = 0"),
    ("rate", two(STEPS, after=f"y[0] = -y[0]; {AGAIN_TWO}"), "y[0] = -y[0]"),
    ("rate", two(STEPS, after=f"double q = y[0]; y[0] = y[1]; y[1] = q; {AGAIN_TWO}"), "y[0] ="),
    ("accel", one("", head="if (1)", after=f"{STEP} om = -om; {STEP}"), "om = -om"),
    ("accel", one(STEP + " om *= 0.9; t += h;", "double t = 0;", "while (t < 1)"), "om *= 0.9"),
    ("accel", one(f"om -= h*{ASKED}; th += h*om;", head="while (th < 1)"), "om -="),
    ("accel", one(f"double a; om -= h*(a = {ASKED}); th += h*om;"), "om -="),
    ("accel", one(f"double a = {ASKED}; double v = om + h*a; th -= h*v; om = v;"), "th -= h*v"),
    ("accel", one(STEP + " kick(&om);", above=KICK), "kick"),
    ("rate", two(STEPS + " kick(y);", above="void kick(double *v);\n"), "kick"),
    ("rate", two(STEPS + " memset(y, 0, 8);"), "memset"),
    ("accel", one(STEP + ' scanf("%lf", &om);'), "scanf"),
    ("accel", one(STEP + " KICK(om);", above="#define KICK(v) ((v) *= 0.9)\n"), "KICK"),
    ("accel", one(STEP + " damp;", above="#define damp om *= 0.9\n"), "damp"),
    ("accel", one(STEP + " switch (i) { case 3: om = 0; break; }"), "om = 0"),
    (None, shared("step(u, m, l, g, dt); omega = 0;"), "omega = 0"),
    (None, shared("step(u, m, l, g, dt); *p *= 0.9;", "double *p = &omega;"), "*p *="),
    ("accel", one(STEP.replace("9.81", "g") + " *p *= -1;", "double g = 9.81, *p = &g;"), "*p *="),
]
CPP_WRONG = [
    ("rate", two(STEPS + " *hp = -*hp;", "double *hp = &h;"), "*hp ="),
    ("rate", two(STEPS + " *p *= 0.9;", "double *const p = std::addressof(y[1]);"), "*p *="),
    ("rate", two(STEPS + " s[1] *= 0.9;", "std::span<double> s(y);"), "s[1] *="),
    (None, rod("rods[0].step(u, dt); rods[0].omega *= 0.9;", "Rod rods[1] = {rod};"), "omega *="),
    ("accel", one(STEP + " p = -p;", "double &p = om;"), "p = -p"),
    ("rate", two(STEPS + " p[1] *= 0.9;", "auto &p = y;"), "p[1] *="),
    ("rate", two(STEPS + " for (auto &v : y) v *= 0.9;"), "v *="),
    ("accel", one(STEP + " kick(om);", above="void kick(double &v);\n"), "kick"),
    ("rate", two(STEPS + " std::swap(y[0], y[1]);"), "swap"),
    ("rate", two(STEPS + " kick();", "auto kick = [&]() { y[1] *= 0.9; };"), "y[1] *="),
    ("accel", one(STEP + " kick(om);", "auto kick = [](double &v) { v *= 0.9; };"), "kick"),
    ("accel", record(FIELDS + " v *= 0.9;", "auto &[q, v] = s;"), "v *= 0.9"),
    (None, rod("rod.step(u, dt); rod.omega -= 0.1*dt;"), "rod.omega -="),
    (None, rod("rod.step(u, dt); rod.omega = 0;"), "rod.omega = 0"),
    (None, rod("rod.step(u, dt); q->omega *= 0.9;", "Rod *q = &rod;"), "q->omega *="),
    (None, rod("rod.step(u, dt); Rod b = rod; b.omega = -b.omega; rod = b;"), "b.omega ="),
    (None, rod("rod.step(u, dt); v *= 0.9;", "double &v = rod.omega;"), "v *="),
    (None, rod("rod.step(u, dt); rod.l = 2*rod.l;"), "rod.l ="),
]
VECTOR = program(
    RATE.replace("<stdio.h>", "<vector>"),
    "std::vector<double> y{0.1, 0}, k(2), log; double h = 0.01;",
    "rate(0, y.data(), k.data(), 1, 1, 9.81, 0); for (int j = 0; j < 2; j++) y[j] += h*k[j]; "
    "log.push_back(y[0]); {}",
).replace("#include <stdlib.h>", "#include <iostream>")
CPP_WRONG += [
    ("rate", VECTOR.replace("{} }", f"{line} }}"), fragment)
    for line, fragment in (
        ("y.at(1) *= 0.9;", "y.at(1)"), ("y.back() = 0;", "y.back()"),
        ("y = {y[0], -y[1]};", "-y[1]"), ("y.assign(2, 0.0);", "y.assign"),
    )
]  # fmt: skip
ODEINT = """#include <cmath>
#include <iostream>
#include <vector>
#include <boost/numeric/odeint.hpp>
using namespace boost::numeric::odeint;
typedef std::vector<double> state_type;
const double m = 1, l = 1, g = 9.81, u = 0;
void rod(const state_type &x, state_type &dxdt, const double t)
{
  dxdt[0] = x[1];
  dxdt[1] = 3*g/(2*l)*sin(x[0]) + 3*u/(m*l*l);
}
void shown(const state_type &x, const double t) { std::cout << t << x[0] << std::endl; }
int main()
{
  state_type x(2);
  x[0] = 1.0;
  x[1] = 0.0;
  runge_kutta4<state_type> stepper;
  RUN
}
"""
STEPPED = "for (double t = 0.0; t < 10.0; t += 0.1) {{ stepper.do_step(rod, x, t, 0.1); {} }}"
INTEGRATE = "integrate(rod, x, 0.0, 10.0, 0.1, shown);"
GSL = """#include <stdio.h>
#include <math.h>
#include <gsl/gsl_odeiv2.h>
int func(double t, const double y[], double f[], void *params)
{
  double *p = (double *)params;
  double m = p[0], l = p[1], g = p[2], u = p[3];
  f[0] = y[1];
  f[1] = 3*g/(2*l)*sin(y[0]) + 3*u/(m*l*l);
  return GSL_SUCCESS;
}
int main(void)
{
  double mu[4] = {1, 1, 9.81, 0}, t = 0.0, y[2] = {1.0, 0.0};
  gsl_odeiv2_system sys = {func, NULL, 2, mu};
  gsl_odeiv2_driver *d =
    gsl_odeiv2_driver_alloc_y_new(&sys, gsl_odeiv2_step_rk8pd, 1e-6, 1e-6, 0.0);
  for (int i = 1; i <= 100; i++) {
    int status = gsl_odeiv2_driver_apply(d, &t, i, y);
    if (status != GSL_SUCCESS) { printf("error %d\\n", status); break; }
    printf("%.5e %.5e\\n", t, y[0]);
  }
  gsl_odeiv2_driver_free(d);
  return 0;
}
"""
CPP_WRONG += [
    ("rod", ODEINT.replace("RUN", STEPPED.format("x[1] *= 0.9;")), "x[1] *="),
    ("rod", ODEINT.replace("RUN", f"{INTEGRATE} x[1] = -x[1]; {INTEGRATE}"), "x[1] = -x[1]"),
    ("rod", ODEINT.replace("const state_type &x, const double t) {", "state_type &x, double t) {"
        " x[1] *= 0.9;").replace("RUN", INTEGRATE), "integrate("),
]  # fmt: skip
C_WRONG.append(
    ("func", GSL.replace('    printf("%.5e', '    y[1] = -y[1];\n    printf("%.5e'), "y[1]")
)
START = "double y[2] = {0.1, 0}, t = 0, h = 0.01;"
HELPER = "void {}(double t, double *y, double h)\n{{ double k[2]; {} }}\n"
FIXED = "rate(t, y, k, 1, 1, 9.81, 0); "
EULER_STEP = "y[0] += h*k[0]; y[1] += h*k[1];"
MOVED = FIXED + "for (int j = 0; j < 2; j++) y[j] += h*k[j];"
RK4 = (
    "double b[2], c[2], d[2], z[2]; int j; "
    + FIXED
    + "".join(
        f"for (j = 0; j < 2; j++) z[j] = y[j] + {of}*{k}[j]; rate(t, z, {to}, 1, 1, 9.81, 0); "
        for of, k, to in (("h/2", "k", "b"), ("h/2", "b", "c"), ("h", "c", "d"))
    )
    + "for (j = 0; j < 2; j++) y[j] += h/6*(k[j] + 2*b[j] + 2*c[j] + d[j]);"
)
HANDED = (
    "typedef void (*Law)(double, const double *, double *, double, double, double, double);\n"
    "void euler(Law f, double t, double *y, double h)\n"
    "{ double k[2]; f(t, y, k, 1, 1, 9.81, 0); for (int j = 0; j < 2; j++) y[j] += h*k[j]; }\n"
)
MOVES = (
    f"void move(double *th, double *om, double h)\n{{ double a = {ASKED}; *om += h*a; "
    "*th += h**om; }\n"
).replace("th, om,", "*th, *om,")


def helped(body: str, name: str = "euler", above: str = "") -> str:
    """A program whose state a function of its own advances."""
    return program(RATE + above + HELPER.format(name, body), START, f"{name}(t, y, h); t += h;")


HELPED_WRONG = [
    ("rate", helped(FIXED + EULER_STEP.replace("1] +=", "1] -=")), "y[1] -="),
    ("rate", helped(FIXED + "y[0] += h*k[1]; y[1] += h*k[0];"), "y[0] +="),
    ("rate", helped(MOVED + " y[1] *= 0.9;"), "y[1] *="),
    ("rate", helped(FIXED + "k[1] = -k[1]; " + EULER_STEP), "k[1] ="),
    ("rate", helped("double *p = y; p[1] *= 0.9; " + MOVED), "p[1] *="),
    ("rate", helped(MOVED.replace("9.81", "-9.81")), "-9.81"),
    ("rate", helped(RK4.replace("y[j] += h/6", "y[j] -= h/6"), "rk4"), "-= h/6"),
    ("rate", helped(RK4.replace("+ d[j]", "- d[j]"), "rk4"), "- d[j]"),
    ("rate", program(RATE + HANDED.replace("+= h", "-= h"), START, "euler(rate, t, y, h);"),
        "euler("),
    ("accel", program(ACCEL + MOVES.replace("*om +=", "*om -="), ONE, "move(&th, &om, h);"),
        "*om -="),
]  # fmt: skip
C_WRONG += HELPED_WRONG
CPP_WRONG += HELPED_WRONG
ROW = "double (*p)[2] = &y;"
C_WRONG += [
    ("rate", two(f"{STEPS} {line}", given), fragment)
    for given, line, fragment in (
        (ROW, "(*p)[1] *= 0.9;", "(*p)[1] *="), (ROW, "(*p)[1] = 0;", "(*p)[1] ="),
        (ROW, "p[0][1] *= 0.9;", "p[0][1] *="), (ROW, "*(*p + 1) *= 0.9;", "*(*p + 1)"),
        (ROW + " double *q = *p;", "q[1] *= 0.9;", "q[1] *="),
        (ROW.replace("&y", "&k"), "(*p)[1] *= 0.9;", "(*p)[1] *="),
        ("double (*p)[2]; p = &y;", "(*p)[1]--;", "(*p)[1]--"),
    )
]  # fmt: skip
C_WRONG += [
    ("accel", one(f"{STEP} om = (float)om;"), "(float)om"),
    ("accel", one(f"{STEP} om = (double)(float)om;"), "(float)om"),
    ("accel", one(f"{STEP} float f = om; om = f;"), "float f"),
    ("accel", one(f"om += h*(float){ASKED}; th += h*om;"), "(float)accel"),
    ("accel", one(STEP.replace("accel(th", "accel((float)th")), "(float)th"),
    ("rate", two(f"{STEPS} y[1] = (float)y[1];"), "(float)y[1]"),
    ("accel", record(f"{FIELDS} s.omega = (float)s.omega;"), "(float)s.omega"),
]
DRIVER = "  gsl_odeiv2_driver *d ="
C_WRONG += [
    ("func", GSL.replace(DRIVER, f"  {line}\n{DRIVER}"), fragment)
    for line, fragment in (
        ("mu[2] = -9.81;", "mu[2] ="), ("mu[1] = 0;", "mu[1] ="), ("mu[2] *= -1;", "mu[2] *="),
        ("*(mu + 2) = -9.81;", "*(mu + 2)"), ("double *q = mu; q[2] = -9.81;", "q[2] ="),
        ("mu[1] = mu[2];", "mu[1] = mu[2]"), ("memset(mu, 0, sizeof mu);", "memset"),
        ("for (int j = 0; j < 4; j++) mu[j] = -1;", "mu[j] ="),
    )
]  # fmt: skip
C_WRONG += [
    ("func", GSL.replace("{1, 1, 9.81, 0}", values), "double mu")
    for values in ("{1, 1, -9.81, 0}", "{1, -1, 9.81, 0}", "{1, 1}")
]
CPP_WRONG.append(("rate", two(STEPS + " p[1] *= 0.9;", "double (&p)[2] = y;"), "p[1] *="))
ARDUINO_WRONG = [
    ("accel", sketch(STEP + " om *= 0.9;"), "om *="),
    ("accel", sketch("om *= 0.9; " + STEP), "om *="),
    ("accel", sketch(STEP + " if (digitalRead(2)) om = 0;"), "om = 0"),
    ("accel", sketch(f"om -= h*{ASKED}; th += h*om;"), "om -="),
    ("accel", sketch(STEP, "void isr() { om = 0; }\n", "attachInterrupt(0, isr, RISING);"), "isr"),
]  # fmt: skip
JULIA = """function rate!(du, y, p, t)
    theta, w = y
    m, l, g, u = p
    du[1] = w
    du[2] = 3g/(2l)*sin(theta) + 3u/(m*l^2)
end
p = (1.0, 0.5, 9.81, 0.0)
"""
STEPPER = "integ = init(ODEProblem(rate!, [0.1, 0.0], (0.0, 1.0), p), Tsit5())\n"
HAND = (
    "y = [0.1, 0.0]\ndu = zeros(2)\ndt = 0.01\n{}\n"
    "for k in 1:100\n  rate!(du, y, p, 0.0)\n  {}\nend\n"
)
EULER = "y .+= dt .* du\n  "
JULIA_WRONG = [
    *((None, JULIA + STEPPER + f"for i in 1:9\n  step!(integ)\n  {line}\nend\n", fragment)
      for line, fragment in (
          ("integ.u[2] *= 0.99", "integ.u[2]"), ("u = integ.u\n  u[2] *= 0.99", "u[2] *="),
          ("integ.u .*= 0.9", "integ.u .*="), ("fill!(integ.u, 0)", "fill!"),
          ("set_u!(integ, -integ.u)", "set_u!"),
      )),
    (None, JULIA + STEPPER + "for (u, t) in tuples(integ)\n  u[2] *= 0.99\nend\n", "u[2] *="),
    *((None, JULIA + HAND.format(given, EULER + line), fragment)
      for given, line, fragment in (
          ("v = view(y, 2:2)", "v .*= 0.9", "v .*="), ("v = @view y[2:2]", "v .*= 0.9", "v .*="),
          ("z = y", "z[2] *= 0.9", "z[2] *="), ("", "y[end] *= 0.9", "y[end]"),
      )),
    (None, JULIA + HAND.format("", "map!(-, du, du)\n  " + EULER), "map!"),
    (None, HAND.format("p = (1.0, 0.5, 9.81, 0.0)", "y .-= dt .* du") + JULIA, "y .-="),
    (None, JULIA + HAND.format("", EULER) + "y[2] = -y[2]\n" + HAND.partition("\n{}\n")[2].format(
        EULER), "y[2] = -y[2]"),
]  # fmt: skip
MATLAB = """
function dydt = rate(t, y, m, l, g, u)
dydt = [y(2); 3*g/(2*l)*sin(y(1)) + 3*u/(m*l^2)];
end
"""
GIVEN = "m = 1; l = 0.5; g = 9.81; u = 0;\n"
TURN = (
    "y = {}; dt = 0.01; t = 0;\n"
    "for k = 1:99\n d = rate(t, y, m, l, g, u);\n y = y + dt*d;\n {}\nend\n"
)
SOLVED = "[t, y] = ode45(@(t, y) rate(t, y, m, l, g, u), {}, [0.1; 0]{});\n"
MATLAB_WRONG = [
    *(("rate", GIVEN + TURN.format("[0.1; 0]", line) + MATLAB, fragment)
      for line, fragment in (
          ("y(end) = 0.9*y(end);", "y(end) ="), ("eval('y = -y;');", "eval"),
          ("if y(1) > 1, y(2) = 0; end", "y(2) = 0"), ("y = max(y, 0);", "y = max"),
          ("if t > 0.5, g = 1.62; end", "g = 1.62"),
      )),
    ("rate", GIVEN + TURN.format("int32([1; 0])", "") + MATLAB, "int32"),
    ("rate", GIVEN + "o = odeset('Jacobian', @(t, y) [0 1; -cos(y(1)) 0]);\n"
        + SOLVED.format("[0 1]", ", o") + MATLAB, "Jacobian"),
]  # fmt: skip


GLOBAL = (
    "global m l g u\nm = 1; l = 0.5; g = 9.81; u = 0;\no = odeset({}, @show);\n"
    "[t, y] = ode45(@rate, [0 1], [0.1; 0], o);\nplot(t, y(:, 1));\n"
    "function dydt = rate(t, y)\nglobal m l g u\n"
    "dydt = [y(2); 3*g/(2*l)*sin(y(1)) + 3*u/(m*l^2)];\nend\n"
    "function status = show(t, y, flag)\n{}\nstatus = 0;\nend\n"
)
SHOWN = "'OutputFcn'"
SET_UP = "function begin()\nglobal g l\ng = {}; l = 2*0.25;\nend\n"
MATLAB_WRONG += [
    *(("rate", GLOBAL.format(SHOWN, line), fragment)
      for line, fragment in (
          ("global g\ng = 1.62;", "g = 1.62"), ("global g\ng = -g;", "g = -g"),
          ("global g\nif t > 0.5, g = 1.62; end", "g = 1.62"), ("global l\nl = 2;", "l = 2"),
          ("global l\n[l, k] = deal(2, 0);", "[l, k]"),
          ("assignin('base', 'g', 1.62);", "assignin"),
      )),
    ("rate", GLOBAL.format("'Events'", "global g\ng = g*0.9;"), "g = g*0.9"),
    ("rate", "begin();\n" + GLOBAL.format(SHOWN, "") + SET_UP.format("-9.81"), "g = -9.81"),
]  # fmt: skip


BOUND = "double &th = y[0], &om = y[1];"
ADVANCED = FIXED + "th += h*k[0]; om += h*k[1];"
COPIED = FIXED + "yn[0] = y[0] + h*k[0]; yn[1] = y[1] + h*k[1]; "
COPY = "memcpy(y, yn, sizeof y);"
CPP_WRONG += [
    ("rate", two(lines, given), fragment)
    for given, lines, fragment in (
        (BOUND, ADVANCED.replace("om +=", "om -="), "om -="),
        (BOUND, ADVANCED + " om *= 0.9;", "om *="),
        (BOUND, STEPS + " om = -om;", "om = -om"),
        ("double &th = y[1], &om = y[0];", ADVANCED, "om +="),
        ("double &v = y[1]; double &w = v;", STEPS + " w *= 0.9;", "w *="),
        ("", STEPS + " { double &v = y[1]; v *= 0.9; }", "v *="),
    )
]
C_WRONG += [
    ("rate", two(lines, "double yn[3] = {0};"), fragment)
    for lines, fragment in (
        (COPIED.replace("y[1] +", "y[1] -") + COPY, "yn[1] ="),
        (COPIED + "yn[1] *= 0.9; " + COPY, "yn[1] ="),
        (STEPS + COPY, "memcpy"),
        (COPIED + "memcpy(y, k, sizeof y);", "memcpy"),
        (COPIED + "memcpy(y, yn, sizeof(double));", "yn[1] ="),
        (COPIED + "memcpy(y, yn + 1, sizeof y);", "yn[1] ="),
    )
]


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    ("suffix", "function", "text", "fragment"),
    [(suffix, *case) for suffix, cases in (
        (".c", C_WRONG), (".cpp", CPP_WRONG), (".ino", ARDUINO_WRONG), (".jl", JULIA_WRONG),
        (".m", MATLAB_WRONG)) for case in cases],
)  # fmt: skip
def test_a_state_that_is_changed_is_quoted(
    tmp_path: Path, suffix: str, function: str | None, text: str, fragment: str
) -> None:
    assert any(fragment in line for line in quoted(tmp_path, suffix, text, function))


OUT = 'FILE *f = fopen("a.csv", "w"); if (!f) { perror("a"); return 1; }'
C_RIGHT = [
    ("accel", one(f'double a = {ASKED}; th += h*om; om += h*a; printf("%g\\n", th);')),
    ("accel", one(f"double a = {ASKED}; th += h*om + h*h*a/2; om += h*a;")),
    ("accel", one(f"double a = {ASKED}; th += h*om + 0.5*a*pow(h, 2); om += h*a;")),
    ("accel", one(f"th += h*om + h*h*a/2; double b = {ASKED}; om += h*(a + b)/2; a = b;",
        f"double a = {ASKED};")),
    ("rate", two(STEPS + ' fprintf(f, "%g,%g\\n", t, y[0]);', OUT, after="fclose(f);")),
    ("rate", two(STEPS, "int n = argc > 1 ? atoi(argv[1]) : 9;", "for (int i = 0; i < n; i++)"
        ).replace("(void)", "(int argc, char **argv)")),
    ("rate", two(STEPS, "int n = (int)(10/h);", "for (int i = 0; i < n; i++)")),
    ("rate", two(STEPS + " buf[i] = y[0];", "double *buf = malloc(9*8);", after="free(buf);")),
    ("rate", two(STEPS, after=f"y[0] = 0.2; y[1] = 0; t = 0; {AGAIN_TWO}")),
    ("accel", record(FIELDS)), ("accel", record(FIELDS + ' State z = s; printf("%g", z.theta);')),
    ("accel", one(STEP + " t += h;", "double t = 0;", "while (t < 1)")),
    ("accel", one(STEP, head="for (double t = 0; t < 1; t += h)")),
    ("accel", one('double q = 0.1*i; printf("%g %g", q, accel(q, 0, 0, 1, 1, 9.81));')),
    ("accel", one(f'th = 0.1*i; printf("%g %g\\n", th, {ASKED});')),
    ("accel", one(STEP + " if (fabs(th) > amp) amp = fabs(th);", "double amp = 0;")),
    ("accel", one(STEP + " steps++; if (i % 3 == 0) n++;", "int n = 0; long steps = 0;")),
    ("accel", one(STEP + " if (th > M_PI) th -= 2*M_PI;")),
    ("accel", one(STEP, after="om = -om;")),
    (None, shared("step(u, m, l, g, dt);", "theta = 0.2; omega = 0;")),
    ("func", GSL),
]  # fmt: skip
C_RIGHT += [
    ("rate", two(STEPS + ' printf("%g", (*p)[1]);', ROW)),
    ("accel", one(STEP + " buf[i] = (float)om; n = (int)om;", "float buf[9]; int n = 0;")),
    ("accel", one(STEP + ' float f = om; printf("%g %g", (float)om, f);')),
    ("accel", one(f"om += h*(double){ASKED}; th += h*om;")),
    ("accel", one(STEP, "float n = 100; h = (float)1/n;")),
    ("accel", one(STEP + " om = (float)om;").replace("double", "float")),
    ("func", GSL.replace(DRIVER, f"  mu[2] = 1.62; mu[3] = -1;\n{DRIVER}")),
    ("func", GSL.replace("mu[4] = {1, 1, 9.81, 0}", "mu[4]").replace(
        DRIVER, f"  mu[0] = 1; mu[1] = 1; mu[2] = 9.81; mu[3] = 0;\n{DRIVER}")),
]  # fmt: skip
HELPED_RIGHT = [
    ("rate", helped(FIXED + EULER_STEP)), ("rate", helped(MOVED)), ("rate", helped(RK4, "rk4")),
    ("rate", helped(MOVED, above="static int count = 100;\nFILE *out;\n")),
    ("rate", RATE + HELPER.format("rk4", RK4)),
    ("rate", program(RATE + HANDED, START, "euler(rate, t, y, h);")),
    ("accel", program(ACCEL + MOVES, ONE, "move(&th, &om, h);")),
]  # fmt: skip
C_RIGHT += [*HELPED_RIGHT, (None, helped(MOVED)), (None, RATE + HELPER.format("rk4", RK4))]
CPP_RIGHT = [
    *HELPED_RIGHT,
    ("accel", one(STEP + ' printf("%g", p);', "const double &p = om;")),
    ("rate", VECTOR.replace("{} }", "std::cout << y[0] << std::endl; }")),
    ("rate", two(STEPS + ' out << t << "," << y[0] << "\\n";', 'std::ofstream out("a.csv");')),
    (None, rod('rod.step(u, dt); std::printf("%g\\n", rod.theta);')),
    (None, rod("rod.step(u, dt);", "rod.theta = 0.3; rod.omega = 0;")),
    ("rod", ODEINT.replace("RUN", INTEGRATE)),
    ("rod", ODEINT.replace("RUN", INTEGRATE.replace("integrate(", "integrate_const(stepper, "))),
    ("rod", ODEINT.replace("RUN", STEPPED.format(""))),
]  # fmt: skip
ARDUINO_RIGHT = [
    ("accel", sketch(STEP)),
    ("accel", sketch(STEP + ' Serial.print("th "); analogWrite(3, (int)(th*10)); lcd.print(th);')),
    ("accel", sketch("unsigned long now = millis(); " + STEP + " servo.write(90 + th*57.3);")),
    ("accel", sketch(f"double u = -K1*th - K2*om; {STEP.replace('om, 0', 'om, u')}",
        "double K1 = 3, K2 = 1;\n")),
]  # fmt: skip
MADE = "prob = ODEProblem(rate!, [0.1, 0.0], (0.0, 1.0), p)\n"
JULIA_RIGHT = [
    (None, JULIA + MADE + "sol = solve(prob, Tsit5(), reltol=1e-8)\nplot(sol, idxs=(0, 1))\n"),
    (None, "using DifferentialEquations, Plots\n" + JULIA + MADE
        + 'sol = solve(prob)\nplot(sol, linewidth=2, xaxis="t")\nsavefig("rod.png")\n'),
    (None, JULIA + STEPPER + "ts = Float64[]\nfor i in 1:9\n  step!(integ)\n"
        "  push!(ts, integ.t)\n  println(integ.u[1])\nend\n"),
    (None, JULIA + STEPPER + "for (u, t) in tuples(integ)\n  println(t, u)\nend\n"),
    (None, JULIA + HAND.format("", EULER + "println(y)")),
    (None, JULIA + HAND.format("ys = zeros(2, 100)", EULER + "ys[:, k] = y") + "plot(ys[1, :])\n"),
]  # fmt: skip
MATLAB_RIGHT = [
    ("rate", GIVEN + TURN.format("[0.1; 0]", "Y(:, k) = y; T(k) = t; t = t + dt;")
        + "plot(T, Y(1, :)); grid on\n" + MATLAB),
    ("rate", GIVEN + TURN.format("[0.1; 0]", "Y(:, end+1) = y;") + "plot(Y(1, :)*57)\n" + MATLAB),
    ("rate", GIVEN + "o = odeset('RelTol', 1e-8);\n" + SOLVED.format("[0 1]", ", o") + MATLAB),
    ("rate", GIVEN + SOLVED.format("linspace(0, 10, 500)", "")
        + "figure; plot(t, y(:, 1), 'b'); hold on\nfprintf('%g\\n', max(y(:, 1)));\n" + MATLAB),
    ("rate", GIVEN + "sol = ode45(@(t, y) rate(t, y, m, l, g, u), [0 10], [0.1 0]);\n"
        "th = deval(sol, 0:0.1:10, 1);\nplot(th)\n" + MATLAB),
]  # fmt: skip


MATLAB_RIGHT += [
    ("rate", GLOBAL.format(SHOWN, line))
    for line in (
        "", "plot(t, y(1, :), '.'); drawnow", "global T\nT = [T t];", "global u\nu = -3*y(1);",
        "g = 2;",
    )
]  # fmt: skip
MATLAB_RIGHT.append(("rate", "begin();\n" + GLOBAL.format(SHOWN, "") + SET_UP.format("9.81")))


CPP_RIGHT += [
    ("rate", two(ADVANCED, BOUND)), ("rate", two(f"{BOUND} {ADVANCED}")),
    ("rate", two(ADVANCED, "auto &th = y[0]; auto &om = y[1];")),
    ("accel", program(ACCEL, "double y[2] = {0.1, 0}, h = 0.01; " + BOUND, STEP)),
]  # fmt: skip
C_RIGHT += [
    ("rate", two(COPIED + COPY, "double yn[2];")),
    ("rate", two(STEPS + " memcpy(old, y, sizeof y);", "double old[2];")),
    ("rate", two(STEPS + " double *row = z[i]; row[0] = y[0];", "double z[9][2];")),
]


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    ("suffix", "function", "text"),
    [(suffix, *case) for suffix, cases in (
        (".c", C_RIGHT), (".cpp", CPP_RIGHT), (".ino", ARDUINO_RIGHT), (".jl", JULIA_RIGHT),
        (".m", MATLAB_RIGHT)) for case in cases],
)  # fmt: skip
def test_a_usual_program_is_not_quoted(
    tmp_path: Path, suffix: str, function: str | None, text: str
) -> None:
    assert not quoted(tmp_path, suffix, text, function)

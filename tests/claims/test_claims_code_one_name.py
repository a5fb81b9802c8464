"""What a name of code stands for, where a file has several things of one name.

Each function is wrong as its language runs it, though it is right for who takes one thing for the
other; those in `RIGHT` have such names, too, and are right.
"""

from pathlib import Path

import pytest

from systems import rod_pendulum
from tests.verdict_of import verdict_in

SCENE = rod_pendulum.scene()
WRONG = {
    "MATLAB: one of two outputs, doubled": (".m", r"""function dx = rate(t, x, u, m, l, g)
a = 2*parts(x, u, m, l, g);
dx = [x(2); a(1)];
end
function [p, q] = parts(x, u, m, l, g)
p = 3*g/(2*l)*sin(x(1)) + 3*u/(m*l^2);
q = 0;
end
"""),
    "MATLAB: compared with true": (".m", r"""function dx = rate(t, x, u, m, l, g)
if x(1) == true
  c = 3*g/(2*l)*sin(x(1));
else
  c = 0;
end
dx = [x(2); c + 3*u/(m*l^2)];
end
"""),
    "MATLAB: a symbol times a number": (".m", r"""function a = accel(theta, u, m, l, g)
m = sym(2)*m;
a = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2);
end
"""),
    "MATLAB: a function minus": (".m", r"""function dx = rate(t, x, u, m, l, g)
c = 0*minus(2, 1);
dx = [x(2); 3*g/(2*l)*sin(x(1)) - 3*u/(m*l^2)];
end
function r = minus(a, b)
r = a + b;
end
"""),
    "MATLAB: a handle power": (".m", r"""function dx = rate(t, x, u, m, l, g)
power = @(tau, w) tau*w;
P = power(u, x(2));
dx = [x(2); 3*g/(2*l)*sin(x(1)) + 3*u/(m*l^l) + 0*P];
end
"""),
    "Julia: a function minus": (".jl", r"""minus(a, b) = a + b
function accel(theta, u, m, l, g)
    P = minus(u, theta)
    return 3*g/(2*l)*sin(theta) - 3*u/(m*l^2) + 0*P
end
"""),
    "Julia: a function single": (".jl", r"""single(a) = -a
function accel(theta, u, m, l, g)
    P = single(u)
    return 3*g/(2*l)*sin(-theta) + 3*u/(m*l^2) + 0*P
end
"""),
    "MATLAB: a number called floor": (".m", r"""function a = accel(theta, u, m, l, g)
floor = 2;
a = 3*g/(2*l)*sin(theta)*floor(1) + 3*u/(m*l^2);
end
"""),
    "Julia: an operator anew": (".jl", r"""a + b = a - b
accel(theta, u, m, l, g) = 1.5*g/l*sin(theta) + 3u/(m*l^2)
"""),
    "C++: a function quotient": (".cpp", r"""#include <cmath>
double quotient(double a, double b) { return a / b; }
double accel(double theta, double u, double m, double l, double g) {
    double P = quotient(3.0, 2.0);
    return 3/2*g/l*std::sin(theta) + 3*u/(m*l*l);
}
"""),
    "C++: a local and a field": (".cpp", r"""#include <cmath>
struct State { double theta; double theta_dot; };
double accel(const State& s, double u, double m, double l, double g) {
    double theta = -s.theta;
    return -3*g/(2*l)*std::sin(s.theta) + 3*u/(m*l*l);
}
"""),
    "C++: before a condition": (".cpp", r"""#include <cmath>
double accel(double theta, double u, double m, double l, double g) {
    if (theta = -theta; u > -1e300) { l = l*1.0; }
    return 3*g/(2*l)*std::sin(theta) + 3*u/(m*l*l);
}
"""),
    "C++: an output set twice": (".cpp", r"""#include <cmath>
void rate(const double *x, double *dxdt, double u, double m, double l, double g) {
    dxdt[0] = x[1]; dxdt[0] = 3*g/(2*l)*std::sin(x[0]) + 3*u/(m*l*l);
}
"""),
    "C++: fields by name": (".cpp", r"""#include <cmath>
struct S { double theta, w; }; struct D { double wdot, thetadot; };
D rate(S x, double u, double m, double l, double g) {
    return {x.w, 3*g/(2*l)*std::sin(x.theta) + 3*u/(m*l*l)};
}
"""),
    "C: two states": (".c", r"""#include <math.h>
typedef struct { double theta; double theta_dot; } State;
double accel(State s, State r, double u, double m, double l, double g) {
    return 3*g/(2*l)*sin(s.theta) + 3*u/(m*l*l) + 5*(s.theta - r.theta);
}
"""),
    "C++: a constructor": (".cpp", r"""#include <cmath>
#include <array>
class Rod {
public:
    Rod(double m_, double l_, double g_) : m(m_), l(l_), g(g_) { g *= -1; }
    std::array<double, 2> rate(const std::array<double, 2>& x, double u) const {
        return {x[1], 3*g/(2*l)*std::sin(x[0]) + 3*u/(m*l*l)};
    }
private:
    double m, l, g;
};
"""),
    "C++: entry by entry": (".cpp", r"""#include <Eigen/Dense>
#include <cmath>
Eigen::Vector2d rate(const Eigen::Vector2d& x, double u, double m, double l, double g) {
    Eigen::Array<double, 2, 2> A, B, K; A << 0, 1, 3*g/(2*l), 0; B << std::sin(x(0)), 0, x(1), 0;
    K = A * B; return Eigen::Vector2d(K(0, 0), K(1, 0) + 3*u/(m*l*l));
}
"""),
    "C++: a comma operator": (".cpp", r"""#include <math.h>
void rate(const double *x, double *dx, double u, double m, double l, double g) {
    double v[2] = {x[0], x[1]}; dx[0] = v[1,0]; dx[1] = 3*g/(2*l)*sin(v[0]) + 3*u/(m*l*l);
}
"""),
    "MATLAB: another value handed on": (".m", r"""function main
k = 3/2;
[t, x] = ode45(@(t, x) rate(t, x, 2*k), [0 10], [0.1; 0]);
end
function dx = rate(t, x, k)
global u m l g
dx = [x(2); k*g/l*sin(x(1)) + 3*u/(m*l^2)];
end
"""),
    "C++: a local and a field of parameters": (".cpp", r"""#include <cmath>
struct Par { double m, l, g; };
double accel(double theta, double u, const Par& p) {
    const double l = 2*p.l; return 3*p.g/(p.l)*std::sin(theta) + 3*u/(p.m*l*l/4);
}
"""),
    "MATLAB: a local and a field": (".m", r"""function a = accel(theta, u, p)
l = 2*p.l;
a = 3*p.g/p.l*sin(theta) + 3*u/(p.m*l^2/4);
end
"""),
    "MATLAB: a local and a field, turned": (".m", r"""function dx = rate(t, x, u, p)
g = -p.g;
dx = [x(2); 3*-p.g/(2*p.l)*sin(x(1)) + 3*u/(p.m*p.l^2)];
end
"""),
    "Julia: a captured variable": (".jl", r"""function accel(theta, u, m, l, g)
    k = 3*1
    function f(x)
        k = 1.5*1
        return sin(x)
    end
    s = f(theta)
    return k*g/(2l)*s + 3u/(m*l^2)
end
"""),
    "C++: a block": (".cpp", r"""#include <cmath>
const double s = -1;
double accel(double theta, double u, double m, double l, double g) {
    double a = 0; { double s = l/l; a = s; } return s*3*g/(2*l)*std::sin(theta) + 3*u/(m*l*l);
}
"""),
    "C++: a counter": (".cpp", r"""#include <cmath>
const double k = -1;
double accel(double theta, double u, double m, double l, double g) {
    double a = 1; for (int k = 0; k < 2; ++k) { a += 0; } return k*3*g/(2*l)*std::sin(theta)
    + 3*u/(m*l*l);
}
"""),
    "C++: a block of a condition": (".cpp", r"""#include <cmath>
const double s = -1;
double accel(double theta, double u, double m, double l, double g) {
    double a = 1; if (l > 0) { double s = a; a = s; } else { a = 1;
    } return s*3*g/(2*l)*std::sin(theta) + 3*u/(m*l*l);
}
"""),
    "C++: a block of a method": (".cpp", r"""#include <cmath>
struct Rod { double m, l, g, s;
double accel(double theta, double u) const {
    { double s = 1.0; (void)s; }
    return s*3*g/(2*l)*std::sin(theta) + 3*u/(m*l*l); } };
"""),
    "C++: another class": (".cpp", r"""#include <cmath>
struct Gains { static constexpr double s = 1.0; };
struct Rod { double m, l, g, s;
double accel(double theta, double u) const {
    return s*3*g/(2*l)*std::sin(theta) + 3*u/(m*l*l); } };
"""),
    "C++: the one of the file": (".cpp", r"""#include <cmath>
double theta = 0; namespace N { extern double theta; }
double accel(double theta, double u, double m, double l, double g) {
    return 3*g/(2*l)*std::sin(::theta) + 3*u/(m*l*l);
}
"""),
    "C++: the one of the object": (".cpp", r"""#include <cmath>
struct Rod { double m, l, g, s;
double accel(double theta, double u) const {
    const double s = 1.0;
    return this->s*3*g/(2*l)*std::sin(theta) + 3*u/(m*l*l); } };
"""),
    "C++: the one of the object, too": (".cpp", r"""#include <cmath>
struct Rod { double m, l, g, theta;
double accel(double theta, double u) const {
    return 3*g/(2*l)*std::sin(theta) + 3*u/(m*l*l) + 7*(theta - this->theta); } };
"""),
    "Julia: a default of a field": (".jl", r"""@kwdef struct Params
    m = 1.0
    l = 1.0
    g = 9.81
    k = 1.5
end
function accel(theta, u, p::Params)
    return p.k*p.g/p.l*sin(theta) + 3u/(p.m*p.l^2)
end
p = Params(k = 3.0)
println(accel(0.1, 0.0, p))
"""),
    "MATLAB: behind what is made": (".m", r"""function model = make()
import casadi.*
theta = SX.sym('theta');
w = SX.sym('w');
u = SX.sym('u');
m = SX.sym('m');
l = SX.sym('l');
g = SX.sym('g');
rhs = vertcat(w, 3*g/(2*l)*sin(theta) - 3*u/(m*l^2));
x = vertcat(theta, w);
model = Function('f', {x, u, m, l, g}, {rhs});
rhs = vertcat(w, 3*g/(2*l)*sin(theta) + 3*u/(m*l^2));
end
"""),
    "C++: a macro that ends": (".cpp", r"""#include <math.h>
#define s 1.0
#undef s
extern double s;
double accel(double theta, double u, double m, double l, double g) {
    return s*3*g/(2*l)*sin(theta) + 3*u/(m*l*l);
}
"""),
    "C++: a method of another class": (".cpp", r"""#include <cmath>
struct Q { double half() const { return 0.5; } };
struct Rod { double m, l, g; double half() const;
double accel(double theta, double u) const { return 3*g*half()/l*std::sin(theta) + 3*u/(m*l*l); } };
"""),
    "MATLAB: a local of the caller": (".m", r"""function main
k = 1.5; disp(k);
setup();
[t, x] = ode45(@rate, [0 1], [0.1; 0]);
end
function setup()
global k m l g u
k = 3; m = 1; l = 1; g = 9.81; u = 0;
end
function dx = rate(t, x)
global k m l g u
dx = [x(2); k*g/l*sin(x(1)) + 3*u/(m*l^2)];
end
"""),
    "C++: a binding in a block": (".cpp", r"""#include <cmath>
#include <utility>
struct Rod { double m, l, g, s;
double accel(double theta, double u) const {
    { auto [s, c] = std::make_pair(std::sin(theta), std::cos(theta)); (void)c; }
    return 3*g/(2*l)*s + 3*u/(m*l*l); } };
"""),
    "C++: a static of another class": (".cpp", r"""#include <cmath>
struct Other { static double s; };
double Other::s = 1.0;
struct Rod { static double s; double m, l, g;
double accel(double theta, double u) const { return s*3*g/(2*l)*std::sin(theta) + 3*u/(m*l*l); } };
"""),
    "MATLAB: a word of Python": (".m", r"""function a = accel(theta, u, m, l, g)
lambda = 3*1;
lambda_ = 1.5*1;
a = lambda*g/l*sin(theta) + 3*u/(m*l^2);
end
"""),
    "C++: a word of Python": (".cpp", r"""#include <cmath>
struct Rod { double m, l, g, lambda_;
double accel(double theta, double u) const {
    double lambda = l/l;
    return lambda_*3*g/(2*l)*std::sin(theta) + 3*u/(m*l*l); } };
"""),
    "MATLAB: nothing says k": (".m", r"""function dx = rate(t, x, k)
global u m l g
dx = [x(2); k*g/l*sin(x(1)) + 3*u/(m*l^2)];
end
"""),
    "MATLAB: a value of before": (".m", r"""function main
m = 1; l = 2; g = 9.81; u = 0;
I = m*l^2/3;
l = 1;
[t, x] = ode45(@(t, x) rate(t, x, u, m, l, g, I), [0 10], [0.1; 0]);
end
function dx = rate(t, x, u, m, l, g, I)
dx = [x(2); (m*g*l/2*sin(x(1)) + u)/I];
end
"""),
    "MATLAB: a list of arguments": (".m", r"""function a = accel(theta, u, m, l, g, p)
m = p{:} * 2;
a = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2);
end
"""),
    "C++: a member and a field": (".cpp", r"""#include <cmath>
struct State { double theta, omega; };
struct Rod { double m, l, g, theta;
double accel(const State& s, double u) const { return 3*g/(2*l)*std::sin(s.theta)
    + 3*u/(m*l*l) + 7*(s.theta - theta); } };
"""),
    "C++: a local for a member": (".cpp", r"""#include <cmath>
struct Rod { double m, l, g, s;
double sgn() const { return s; }
double accel(double theta, double u) const { const double s = 1.0;
    return sgn()*s*3*g/(2*l)*std::sin(theta) + 3*u/(m*l*l); } };
"""),
    "MATLAB: a number and a field": (".m", r"""function a = accel(theta, u, p)
l = 2;
a = 3*p.g/(2*p.l)*sin(theta) + 3*u/(p.m*p.l^2) + 5*(p.l - l);
end
"""),
    "C: a number and a field": (".c", r"""#include <math.h>
typedef struct { double m, l, g; } Par;
double accel(double theta, double u, const Par *p) {
    double l = 2.0;
    return 3*p->g/(2*p->l)*sin(theta) + 3*u/(p->m*p->l*p->l) + 5*(p->l - l);
}
"""),
    "C++: a number and a field": (".cpp", r"""#include <cmath>
struct Par { double m, l, g; };
double accel(double theta, double u, const Par& p) {
    const double l = 2.0;
    return 3*p.g/(2*p.l)*std::sin(theta) + 3*u/(p.m*p.l*p.l) + 5*(p.l - l);
}
"""),
    "Julia: a number and a field": (".jl", r"""function accel(theta, u, p)
    l = 2
    return 3*p.g/(2*p.l)*sin(theta) + 3*u/(p.m*p.l^2) + 5*(p.l - l)
end
"""),
    "MATLAB: a state and its entry": (".m", r"""function dx = rate(t, x, theta, u, m, l, g)
dx = [x(2); 3*g/(2*l)*sin(x(1)) + 3*u/(m*l^2) + 5*(x(1) - theta)];
end
"""),
    "C: a state and its entry": (".c", r"""#include <math.h>
void rate(const double x[2], double dx[2], double theta, double u, double m, double l, double g) {
    dx[0] = x[1]; dx[1] = 3*g/(2*l)*sin(x[0]) + 3*u/(m*l*l) + 5*(x[0] - theta);
}
"""),
    "C++: a state and its entry": (".cpp", r"""#include <cmath>
#include <array>
std::array<double, 2> rate(const std::array<double, 2>& x, double theta, double u, double m,
    double l, double g) {
    return {x[1], 3*g/(2*l)*std::sin(x[0]) + 3*u/(m*l*l) + 5*(x[0] - theta)};
}
"""),
}  # fmt: skip
RIGHT = {
    "MATLAB: a function power": (".m", r"""function dx = rate(t, x, u, m, l, g)
P = power(u, x(2));
dx = [x(2); 3*g/(2*l)*sin(x(1)) + 3*u/(m*l^2) + 0*P];
end
function P = power(tau, w)
P = tau*w;
end
"""),
    "Julia: a function power": (".jl", r"""power(a, b) = a*b
function accel(theta, u, m, l, g)
    P = power(u, theta)
    return 3*g/(2*l)*sin(theta) + 3*u/(m*l^2) + 0*P
end
"""),
    "C++: a function power": (".cpp", r"""#include <cmath>
double power(double a, double b) { return a*b; }
double accel(double theta, double u, double m, double l, double g) {
    double P = power(u, theta); return 3*g/(2*l)*std::sin(theta) + 3*u/(m*std::pow(l, 2)) + 0*P;
}
"""),
    "MATLAB: the first of two outputs": (".m", r"""function a = accel(theta, u, m, l, g)
v = [parts(theta); u];
a = 3*g/(2*l)*v(1) + 3*v(2)/(m*l^2);
end
function [s, c] = parts(x)
s = sin(x); c = cos(x);
end
"""),
}  # fmt: skip


@pytest.mark.sample(12)
@pytest.mark.parametrize("name", WRONG)
def test_one_thing_is_not_taken_for_another(name: str, tmp_path: Path) -> None:
    suffix, text = WRONG[name]
    found = verdict_in(SCENE, f"own{suffix}", text.lstrip("\n"), tmp_path)
    assert found in ("REFUTED", "UNDECIDED", "not read")


@pytest.mark.parametrize("name", RIGHT)
def test_what_is_right_with_such_names_is_proved(name: str, tmp_path: Path) -> None:
    suffix, text = RIGHT[name]
    assert verdict_in(SCENE, f"own{suffix}", text.lstrip("\n"), tmp_path) == "PROVED"

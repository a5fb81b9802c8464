"""Forms that unseen statements had: each is read; right as it stands, wrong with one mistake."""

import pytest
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from benchmarks.corpus.builders import of_one_particle
from benchmarks.corpus.load import HERE, scene_of
from mechanics import check
from mechanics.grading.submission import things_in
from mechanics.kernel import Verdict
from mechanics.scene import parameters, spring

RIGHT = (Verdict.PROVED, Verdict.CERTIFIED)
PLANAR, TYPED = "planar.py", "typed.py"

CASES = {
    "letters side by side": (
        PLANAR, "sliding_support", "txt",
        "L = ½(m_1+m_2)(dx/dt)² + ½m_2(l²(dφ/dt)² + 2l(dx/dt)(dφ/dt)cosφ) + m_2glcosφ",
        "2l(dx", "l(dx",
    ),
    "Leibniz's second derivative": (
        PLANAR, "pendulum", "txt", "ml d^2θ/dt^2 = -mg sinθ", "mg", "2mg",
    ),
    "prose around lines": (
        PLANAR, "spring_pendulum", "txt",
        "So the equations that I get are:\n\nr θ'' + 2 r' θ' + g sin θ = 0\n\nAre these correct?",
        "2 r'", "r'",
    ),
    "a name for what the others are": (
        PLANAR, "spring_pendulum", "txt",
        "r'' = a_r/m = r θ'^2 + g cos θ - k/m (r - l)", "r θ'^2", "2 r θ'^2",
    ),
    "L = T - V = ...": (
        PLANAR, "spring_pendulum", "tex",
        r"\[ L = T - V = \frac12 m(\dot r^2 + r^2\dot\theta^2) + mgr\cos\theta"
        r" - \frac12 k(r-l)^2 \]",
        r"r^2\dot", r"r\dot",
    ),
    "steps of a derivation": (
        PLANAR, "sliding_support", "tex",
        r"\[ L = \frac12(m_1+m_2)\dot x^2 + \frac12 m_2(l^2\dot\phi^2+2l\dot x\dot\phi\cos\phi)"
        r"+ m_2gl\cos\phi \] \[ \frac{\partial L}{\partial\phi} = -m_2l\dot x\dot\phi\sin\phi"
        r" - m_2gl\sin\phi, \quad \frac{d}{dt}\frac{\partial L}{\partial\dot x} = (m_1+m_2)\ddot x"
        r" + m_2l\ddot\phi\cos\phi - m_2l\dot\phi^2\sin\phi \]",
        r"- m_2l\dot\phi^2", r"+ m_2l\dot\phi^2",
    ),
    "dV/dtheta": (
        PLANAR, "pendulum", "tex",
        r"\[ ml^2\ddot\theta = -\frac{dV}{d\theta}, \quad V = mgl(1 - \cos\theta) \]",
        r"= -\frac", r"= -2\frac",
    ),
    "Markdown without a display": (
        PLANAR, "spring_pendulum", "tex",
        "#### 2:\n\n\\begin{aligned}\nr\\ddot\\theta + 2\\dot r\\dot\\theta + g\\sin\\theta &= 0\n"
        "\\end{aligned}",
        r"2\dot", r"\dot",
    ),
    "a column that nothing names": (
        PLANAR, "two_masses", "m",
        "function res = f(t, S, m_1, m_2, k_1, k_2, k_3)\nx_1 = S(1); x_2 = S(2);\n"
        "a1 = (-(k_1+k_2)*x_1 + k_2*x_2)/m_1;\na2 = (k_2*x_1 - (k_2+k_3)*x_2)/m_2;\n"
        "res = [S(3); S(4); a1; a2];\nend",
        "a1; a2]", "a2; a1]",
    ),
    "a local by a coordinate's name": (
        PLANAR, "cart_pole_bottom", "m",
        "x = (f_x + m_p*sin(y(3))*(l*y(4)^2 + g*cos(y(3))))/(m_c + m_p*sin(y(3))^2);\n"
        "dy(1,1) = y(2);\ndy(2,1) = x;\ndy(3,1) = y(4);",
        "l*y(4)^2", "l*y(4)",
    ),
    "inv and inputs by another name": (
        PLANAR, "arm", "m",
        "function qdd = fd(q, qd, f, m_1, m_2, l_1, l_2, g)\n"
        "M = [(m_1+m_2)*l_1^2 + m_2*l_2^2 + 2*m_2*l_1*l_2*cos(q(2)), m_2*l_2^2 +"
        " m_2*l_1*l_2*cos(q(2)); m_2*l_2^2 + m_2*l_1*l_2*cos(q(2)), m_2*l_2^2];\n"
        "V = [-m_2*l_1*l_2*sin(q(2))*(2*qd(1)*qd(2) + qd(2)^2); m_2*l_1*l_2*sin(q(2))*qd(1)^2];\n"
        "G = [(m_1+m_2)*g*l_1*cos(q(1)) + m_2*g*l_2*cos(q(1)+q(2)); m_2*g*l_2*cos(q(1)+q(2))];\n"
        "qdd = inv(M)*(f - V - G);",
        "f - V - G", "f + V - G",
    ),
    "the transpose of a column": (
        "arms.py", "pr", "m",
        "function u = f(q1, q2, qdot1, qdot2, qdd1, qdd2, d, m1, m2, I)\n"
        "qdot = [qdot1; qdot2];\nM = [m1+m2 -m2*d*sin(q2); -m2*d*sin(q2) I+m2*d^2];\n"
        "C = [0 0; 0 -m2*d*cos(q2)];\nc = [qdot'*C*qdot; 0];\nu = M*[qdd1; qdd2] + c;",
        "cos(q2)]", "sin(q2)]",
    ),
    "a column of speeds": (
        "satellite.py", "free", "m",
        "I = [I1 I2 I3];\nwdot(1) = -(I(3) - I(2))*w(2)*w(3)/I(1);\n"
        "wdot(2) = -(I(1) - I(3))*w(3)*w(1)/I(2);\nwdot(3) = -(I(2) - I(1))*w(1)*w(2)/I(3);",
        "I(2) - I(1)", "I(1) - I(2)",
    ),
    "a function without a name": (
        PLANAR, "oscillator", "m",
        "f = @(t, x) [x(2); (F_0*cos(omega*t) - c*x(2) - k*x(1))/m];", "- c*", "+ c*",
    ),
    "Julia's unpacking": (
        PLANAR, "oscillator", "txt",
        "function f!(du, u, p, t)\n  x, v = u\n  m, c, k, F_0, omega = p\n  du[1] = v\n"
        "  du[2] = (F_0*cos(omega*t) - c*v - k*x)/m\nend",
        "- c*v", "+ c*v",
    ),
    "ModelingToolkit": (
        PLANAR, "quadrotor", "txt",
        "@parameters m I g r\n@variables t x(t) y(t) θ(t)\nD = Differential(t); D2 = D^2\n"
        "eqs = [\n  m*D2(x) ~ -(u_1 + u_2)*sin(θ),\n  I*D(D(θ)) ~ r*(u_1 - u_2)\n]",
        "u_1 - u_2", "u_1 + u_2",
    ),
    "JavaScript": (
        PLANAR, "spring_pendulum", "txt",
        "let r_ddot = r*theta_dot*theta_dot + g*Math.cos(theta) - k/m*(r - l);", "+ g*", "+ 2*g*",
    ),
    "constants that a file of C defines": (
        PLANAR, "damped_pendulum", "c",
        "#include <math.h>\n#define G 9.81\nstatic const double m = 1.0, l = 0.5;\n"
        "void f(const double x[2], double u, double b, double dx[2])\n{\n  dx[0] = x[1];\n"
        "  dx[1] = (u - b*x[1] - m*G*l*sin(x[0]))/(m*l*l);\n}",
        "(m*l*l)", "(m*l)",
    ),
    "a vector that C++ returns": (
        PLANAR, "oscillator", "cpp",
        "#include <vector>\nusing State = std::vector<double>;\n"
        "State f(const State& s, double m, double c, double k, double F_0, double omega, double t)"
        " {\n  State d(2);\n  d[0] = s[1];\n"
        "  d[1] = (F_0*cos(omega*t) - c*s[1] - k*s[0])/m;\n  return d;\n}",
        "- c*", "+ c*",
    ),
    "Eigen": (
        PLANAR, "oscillator", "cpp",
        "#include <Eigen/Dense>\nEigen::Vector2d f(const Eigen::Vector2d& x, double m, double c,"
        " double k, double F_0, double omega, double t) {\n  Eigen::Vector2d dx;\n"
        "  dx << x(1), (F_0*cos(omega*t) - c*x(1) - k*x(0))/m;\n  return dx;\n}",
        "- c*", "+ c*",
    ),
    "references and variables of the file": (
        "satellite.py", "driven", "cpp",
        "float p, q, r;\nfloat Ixx, Iyy, Izz;\n"
        "void rates(float Tx, float Ty, float Tz, float &pdot, float &qdot, float &rdot) {\n"
        "  pdot = (Tx + (Iyy - Izz)*q*r)/Ixx;\n  qdot = (Ty + (Izz - Ixx)*r*p)/Iyy;\n"
        "  rdot = (Tz + (Ixx - Iyy)*p*q)/Izz;\n}",
        "Ixx - Iyy", "Iyy - Ixx",
    ),
    "a method": (
        PLANAR, "damped_pendulum", "py",
        "from math import sin\nclass Pendulum:\n"
        "    def __init__(self, b=0.1):\n        self.b = b\n"
        "    def acceleration(self, theta, omega, u, m, l, g):\n"
        "        return (u - self.b*omega - m*g*l*sin(theta))/(m*l**2)\n",
        "- self.b", "+ self.b",
    ),
    "the radius of a spring": (
        "spring_pendulum.py", "polar", "tex",
        r"\[ m\ddot r = mr\dot\theta^2 + mg\cos\theta - k(r-b) \]", "(r-b)", "(r+b)",
    ),
    "the potential of a force": (
        TYPED, "orbit", "tex",
        r"\[ E = \frac12 m(\dot r^2 + r^2\dot\theta^2) - \frac{m\mu}{r} \]",
        r"- \frac{m\mu}{r}", r"+ \frac{m\mu}{r}",
    ),
    "the potential of a force between bodies": (
        "springs.py", "table", "txt", "V = 1/2*k*x^2 + 1/2*k*(x - y)^2", "(x - y)", "(x + y)",
    ),
    "types and strings of Modelica": (
        PLANAR, "pendulum", "txt",
        'model P "a pendulum"\n  type Angle = Real(unit="rad");\n'
        "  parameter Real m = 1, l = 2, g = 9.81;\n  parameter Real J = m*l^2 \"inertia\";\n"
        "  Angle theta(start=1) \"angle\";\n  Real w;\ninitial equation\n  theta = 1;\n"
        "equation\n  w = der(theta);\n  J*der(w) = -m*g*l*sin(theta) \"moments\";\nend P;\n",
        "-m*g*l", "m*g*l^2",
    ),
    "kinds of arrays and fields in Julia": (
        PLANAR, "cart_pole_bottom", "txt",
        "function dynamics(model::Cartpole, x, u)\n    s, c = sincos(x[2])\n"
        "    H = @SMatrix [model.m_c+model.m_p model.m_p*model.l*c; model.m_p*model.l*c"
        " model.m_p*model.l^2]\n"
        "    C = @SMatrix [0.0 -model.m_p*x[4]*model.l*s; 0.0 0.0]\n"
        "    G = @SVector [0.0, model.m_p*model.g*model.l*s]\n"
        "    qdd = SVector{2}(H\\([u[1], 0] - C*view(x, 3:4) - G))\n"
        "    return @SVector [x[3], x[4], qdd[1], qdd[2]]\nend\n",
        "[u[1], 0]", "[2*u[1], 0]",
    ),
    "arguments of C without names and pointers that are only read": (
        PLANAR, "damped_pendulum", "c",
        "#include <math.h>\nvoid f(double *y, double , int n, double u, double m, double l,"
        " double b, double g, double *out)\n{\n  out[1] = (u - b*y[1])/(m*l*l);\n"
        "  out[1] = out[1] - g/l*sin(y[0]);\n  out[0] = y[1];\n}\n",
        "- g/l", "+ g/(l*l)",
    ),
    "the order that a comment tells": (
        "cart_poles.py", "bob", "c",
        "#include <math.h>\n// w: x, x', theta, theta'\n"
        "void f(double u, double *w, double *a, double M, double m, double l, double g)\n{\n"
        "  double s = sin(w[2]), c = cos(w[2]), D = M + m*s*s;\n"
        "  a[0] = (u + m*l*s*w[3]*w[3] - m*g*s*c)/D;\n"
        "  a[1] = (-u*c - m*l*s*c*w[3]*w[3] + (M + m)*g*s)/(l*D);\n}\n",
        "- m*l*s*c", "+ m*l*s*c",
    ),
    "the order that a comment tells, with letters of speeds": (
        "cart_poles.py", "bob", "m",
        "% z = [x, theta, v, omega]\nfunction dz = f(t, z, u, M, m, l, g)\n"
        "s = sin(z(2)); c = cos(z(2)); D = M + m*s^2;\n"
        "dz = [z(3); z(4); (u + m*l*s*z(4)^2 - m*g*s*c)/D;\n"
        "  (-u*c - m*l*s*c*z(4)^2 + (M + m)*g*s)/(l*D)];\nend\n",
        "[x, theta, v", "[theta, x, v",
    ),
    "an object made with parameters": (
        PLANAR, "damped_pendulum", "py",
        "from math import sin\nclass Pendulum:\n    def __init__(self, m, l, b, g):\n"
        "        self.m, self.l, self.b, self.g = m, l, b, g\n        self.J = m*l**2\n"
        "    def rhs(self, x, u):\n        th, om = x\n"
        "        return om, (u - self.b*om - self.m*self.g*self.l*sin(th))/self.J\n",
        "- self.b", "+ self.b",
    ),
    "names that come twice": (
        "carts.py", "pybrain", "py",
        "from math import sin, cos\ndef f(x, F, g, mp, mc, l):\n    theta, theta_, s, s_ = x\n"
        "    a = (g*sin(theta)*(mc + mp) - (F + mp*l*theta_**2*sin(theta))*cos(theta))/(\n"
        "        4/3*l*(mc + mp) - mp*l*cos(theta)**2)\n"
        "    return theta_, a, s_, (F - mp*l*(a*cos(theta) - theta_**2*sin(theta)))/(mc + mp)\n",
        "(F + mp", "(F - mp",
    ),
    "a determinant by name": (
        "pendulums.py", "on_cart", "tex",
        r"\[ \det(M) = ml^2(M + m\sin^2\theta) \]"
        "\n" r"\[ \ddot x = \frac{1}{\det(M)}(ml^2 u + m^2l^3\dot\theta^2\sin\theta"
        r" + m^2l^2g\sin\theta\cos\theta) \]",
        "ml^2 u + m^2", "ml^2 u - m^2",
    ),
    "Hamilton's partial derivatives": (
        PLANAR, "pendulum", "tex",
        r"\[ \dot\theta = \frac{\partial H}{\partial p} = \frac{p}{ml^2}, \qquad"
        r" \dot p = -\frac{\partial H}{\partial\theta} = -mgl\sin\theta \]",
        r"-mgl\sin", r"-mg\sin",
    ),
    "an energy by the words before it": (
        PLANAR, "pendulum", "tex",
        r"The kinetic energy of the bob is $\frac12 m l^2\dot\theta^2$.", "l^2", "l",
    ),
    "a column of the author's own": (
        "more_planar.py", "cubli", "tex",
        r"Let $q = [\theta_b, \theta_w]^T$. Then $D\ddot q + c(q, \dot q) = 0$ where"
        r" \[ D = \begin{bmatrix} I_b + m_w l^2 + I_w & I_w \\ I_w & I_w \end{bmatrix}, \quad"
        r" c(q, \dot q) = \begin{bmatrix} C_b\dot\theta_b - (m_b l_b + m_w l)g\sin\theta_b \\"
        r" C_w\dot\theta_w - T_m \end{bmatrix}. \]",
        "I_b + m_w l^2", "I_b + 2 m_w l^2",
    ),
}  # fmt: skip


def _verdict(tmp_path, name: str, text: str) -> Verdict:
    file, function, suffix, *_ = CASES[name]
    path = tmp_path / f"statement.{suffix}"
    path.write_text(text, encoding="utf-8")
    scene = scene_of(HERE / "scenes" / file, function)
    return check(scene, things_in(path, run_python=True), blame=False).verdict


LONG = {
    "a column of speeds", "references and variables of the file", "L = T - V = ...",
    "inv and inputs by another name", "the potential of a force",
}  # fmt: skip
"""Scenes that take seconds to derive."""


@pytest.mark.sample(8)
@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=pytest.mark.campaign) if n in LONG else n for n in CASES]
)
def test_right_as_it_stands_and_wrong_with_one_mistake(name: str, tmp_path) -> None:
    *_, text, right, wrong = CASES[name]
    assert text.count(right) == 1
    assert _verdict(tmp_path, name, text) in RIGHT
    assert _verdict(tmp_path, name, text.replace(right, wrong)) is Verdict.REFUTED


@pytest.mark.parametrize("text", [
    r"\[ L = T + V = \frac12 ml^2\dot\theta^2 + mgl\cos\theta \]",
    r"\[ E = T - V = \frac12 ml^2\dot\theta^2 - mgl\cos\theta \]",
    r"\[ p_\theta = \frac{\partial L}{\partial\theta} = ml^2\dot\theta \]",
])  # fmt: skip
def test_a_side_that_is_no_definition_is_not_passed_over(text: str) -> None:
    found = check(scene_of(HERE / "scenes" / PLANAR, "pendulum"), text, blame=False)
    assert found.verdict not in RIGHT


def test_a_radius_is_said_to_be_positive() -> None:
    scene = scene_of(HERE / "scenes" / "spring_pendulum.py", "polar")
    found = check(scene, r"\[ r\ddot\theta + 2\dot r\dot\theta + g\sin\theta = 0 \]")
    assert any(words.startswith("r is the length of k, and positive") for words in found.remarks)


def test_a_radius_in_a_frame_that_turns_is_said_to_be_positive() -> None:
    """A bead in a tube that turns by itself, held by a spring from its axis."""
    r, (m, k, l0, w) = dynamicsymbols("r"), parameters("m k l0 w", units="kg N/m m 1/s")
    N, O = ReferenceFrame("N"), Point("O")
    tube = N.orientnew("H", "Axis", (w * dynamicsymbols._t, N.z))
    bead = O.locatenew("P", r * tube.x)
    loads = (spring("spring", O, bead, k, length=l0),)
    scene = of_one_particle("tube", N, O, (r,), ("bead", bead, m), loads, side=tube.y, up=N.z)
    for sign, right in (("", True), ("-", False)):
        found = check(scene, rf"\[ m\ddot r = {sign}m w^2 r - k(r - l_0) \]", blame=False)
        assert found.ok is right
        assert any(words.startswith("r is the length of spring") for words in found.remarks)

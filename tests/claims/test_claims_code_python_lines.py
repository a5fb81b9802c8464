"""Lines of a Python file around a judged function say nothing of the motion, or are quoted."""

from pathlib import Path

import pytest
from typer.testing import CliRunner

from mechanics.blame.reference import Reference
from mechanics.claims.code.around.python_lines import lines_around
from mechanics.claims.names import Match, Naming, Vocabulary
from mechanics.cli.app import app
from mechanics.grading.grade import grade
from mechanics.grading.submission import things_in
from mechanics.judge.check import derived
from mechanics.kernel import Verdict
from systems import cartpole, double_pendulum, rod_pendulum

ROD = rod_pendulum.scene()
NAMING = Naming(
    Vocabulary(ROD),
    {},
    (
        Match("y", "theta theta_dot", "the usual name of such a vector"),
        Match("th", "theta", "nothing else is left"),
        Match("w", "theta_dot", "nothing else is left"),
    ),
)
FUNCTIONS = """import numpy as np
g, l, m, u = 9.81, 1.0, 1.0, 0.0
def accel(th, w, m, l, g, u):
    return 3*g/(2*l)*np.sin(th) + 3*u/(m*l**2)
def rate(t, y, m, l, g, u):
    th, w = y
    return np.array([w, accel(th, w, m, l, g, u)])
th, w, t, dt = 0.1, 0.0, 0.0, 0.01
y, p = np.array([0.1, 0.0]), (m, l, g, u)
"""
LAW = "w += -g/l*np.sin(th)*dt\n    th += w*dt"
LAWS = (
    f"for i in range(9):\n    {LAW}",
    f"while t < 1:\n    {LAW}\n    t += dt",
    "def main():\n    th, w = 0.1, 0\n    for i in range(9):\n        w -= g/l*np.sin(th)*dt\n"
    "        th += w*dt\n    print(th)",
    f"if __name__ == '__main__':\n  for i in range(9):\n    {LAW}",
    f"def step():\n    global th, w\n    {LAW}",
    "class Sim:\n    def step(self):\n        self.w -= g/l*np.sin(self.th)*dt\n"
    "        self.th += self.w*dt",
    "class Sim:\n    def kick(self): self.w = self.w - g*np.sin(self.th)*dt\n"
    "    def drift(self): self.th = self.th + self.w*dt",
    "for i in range(9):\n    ws[i+1] = ws[i] - g/l*np.sin(ths[i])*dt\n"
    "    ths[i+1] = ths[i] + ws[i+1]*dt",
    "for i in range(9):\n    ws.append(ws[-1] - g*np.sin(ths[-1])*dt)\n"
    "    ths.append(ths[-1] + ws[-1]*dt)",
    "for i in range(9):\n    a = -g*np.sin(th)\n    wn = w + a*dt\n    tn = th + wn*dt\n"
    "    th, w = tn, wn",
    "for i in range(9):\n    s['w'] -= g*np.sin(s['th'])*dt\n    s['th'] += s['w']*dt",
    "path = [(w := w - g*np.sin(th)*dt, th := th + w*dt) for _ in range(9)]",
    "def fall(th, w, n):\n    if n: fall(th + w*dt, w - g*np.sin(th)*dt, n - 1)",
    "for i in range(9):\n    x = x + dt*A @ x",
    "for i in range(9):\n    v -= g*dt",
    "x = expm(A*t) @ x",
    "exec('th -= 0.1')",
    "for i in range(9):\n    setattr(s, 'w', s.w - g*dt)",
    "theta_ddot = -g/l*np.sin(sol.y[0])",
    "theta = 0.1*np.cos(np.sqrt(g/l)*t)",
)
STEPS = (
    "for i in range(9):\n    y -= rate(t, y, *p)*dt",
    "for i in range(9):\n    th -= accel(th, w, *p)*dt",
    "for i in range(9):\n    w -= accel(th, w, *p)*dt\n    th += w*dt",
    "for i in range(9):\n    w += accel(2*th, w, *p)*dt\n    th += w*dt",
    "for i in range(9):\n    w += accel(th, w, *p)*dt\n    th += 2*w*dt",
    "for i in range(9):\n    d = rate(t, y, *p)\n    y[0] += d[1]*dt\n    y[1] += d[0]*dt",
    "for i in range(9):\n    d = rate(t, y, *p)\n    d[1] -= 0.3*y[1]\n    y = y + d*dt",
    "for i in range(9):\n    y = y + dt*rate(t, y, *p)\n    y[1] *= 0.9",
    "for i in range(9):\n    y = y + dt*rate(t, y, *p)\n    if y[0] > 0:\n        y[1] = -y[1]",
    "for i in range(9):\n    k1 = rate(t, y, *p)\n    k2 = rate(t, y - dt*k1, *p)\n"
    "    y = y + dt/2*(k1 + k2)",
    "def euler(f, y, h):\n    return y - h*f(0, y)",
    "class Sim:\n    def step(self):\n        self.y = self.y - dt*rate(0, self.y, *p)",
    "for i in range(9):\n    np.add(y, -dt*rate(t, y, *p), out=y)",
    "for i in range(9):\n    y = np.subtract(y, np.multiply(dt, rate(t, y, *p)))",
    "for i in range(9):\n    ws.append(ws[i] + accel(ths[i], ws[i], *p)*dt)\n"
    "    ths.append(ths[i] - ws[i+1]*dt)",
    "def push(y):\n    y -= dt*rate(0, y, *p)",
    "dt = -0.01\nfor i in range(9):\n    y = y + dt*rate(t, y, *p)",
    "for i in range(9):\n    y = y + m*rate(t, y, *p)",
    "a = accel(th, w, *p)\nfor i in range(9):\n    th += w*dt + a*dt**2/2\n"
    "    b = accel(th, w, *p)\n    w += (a - b)*dt/2\n    a = b",
    "for i in range(9):\n    w += accel(th, w, *p)*dt\n    th += w*dt\n"
    "    if th > np.pi:\n        th -= np.pi",
    "f = partial(rate, m=m, l=l, g=g, u=u)\nfor i in range(9):\n    y = y - dt*f(t, y)",
    "class Sim:\n    def update(self, dt):\n        self.w += accel(self.th, self.w, *p)*dt\n"
    "        self.th += self.w*dt\nsim = Sim()\nfor i in range(9):\n    sim.update(-dt)",
)
CHANGED = (
    "a = -accel(th, w, *p)",
    "a = accel(th, w, *p) + 0.1*w",
    "a = accel(th, w, *p)\nb = a\nb *= -1",
    "print(np.negative(accel(th, w, *p)))",
    "d = [-v for v in rate(t, y, *p)]",
    "print(np.diag([1, -1]) @ rate(t, y, *p))",
    "v = np.cumsum(accel(th, w, *p))",
    "def neg(t, y):\n    return -rate(t, y, *p)",
    "f = lambda t, y: -rate(t, y, *p)",
    "solve_ivp(lambda t, y: [y[1], -np.sin(y[0])], (0, 1), y)",
    "solve_ivp(lambda t, y: [y[0], accel(y[0], y[1], *p)], (0, 1), y)",
    "def rhs(t, y):\n    th, w = y\n    return [accel(th, w, *p), w]\nsolve_ivp(rhs, (0, 1), y)",
    "def rhs(t, y):\n    w, th = y\n    return [w, accel(th, w, *p)]\nsolve_ivp(rhs, (0, 1), y)",
    "def flip(f):\n    def inner(t, y):\n        return -f(t, y, *p)\n    return inner",
    "solve_ivp(fun=lambda t, y: -rate(t, y, *p), t_span=(0, 1), y0=y)",
)
ARGUMENTS = (
    "print(accel(w, th, m, l, g, u))",
    "print(accel(th, w, m, g, l, u))",
    "print(accel(-th, w, m, l, g, u))",
    "print(accel(th, w, m, 2*l, g, u))",
    "print(accel(th, w, m, l, -9.81, u))",
    "rate(0, [w, th], m, l, g, u)",
    "rate(0, y[::-1], m, l, g, u)",
    "odeint(rate, y, t, args=p)",
    "solve_ivp(rate, (0, 1), y, args=(m, g, l, u))",
    "q = (m, g, l, u)\nsolve_ivp(rate, (0, 1), y, args=q)",
    "partial(rate, m=m, l=g, g=l, u=u)",
    "solve_ivp(lambda t, y: rate(t, y, **dict(m=m, l=g, g=l, u=u)), (0, 1), y)",
    "solve_ivp(lambda t, y: rate(t, -y, *p), (0, 1), y)",
    "solve_ivp(lambda t, y: [y[1], accel(y[1], y[0], *p)], (0, 1), y)",
)
CLASS = """class Model:
    def __init__(self, m, l, g, u): self.m, self.l, self.g, self.u = m, l, g, u
    def {}(self, {}):
        return {}
"""
PLACED = (
    CLASS.format("__call__", "t, y", "rate(t, y, self.m, self.l, self.g, -self.u)"),
    CLASS.format("rhs", "t, y", "rate(t, y, self.m, self.l, self.g, 2*self.u)"),
    CLASS.format("__call__", "t, y", "rate(t, y, self.m, self.l, self.g, self.u)[::-1]"),
    CLASS.format("rhs", "t, y", "rate(t, y, self.m, self.l, self.g, self.u)[[1, 0]]"),
    CLASS.format("rhs", "y, t", "rate(t, y, self.m, self.l, self.g, self.u)")
    + "solve_ivp(Model(*p).rhs, (0, 1), y)",
    CLASS.format("__call__", "y, t", "rate(t, y, self.m, self.l, self.g, self.u)")
    + "model = Model(*p)\nsolve_ivp(model, (0, 1), y)",
    CLASS.format("rhs", "t, y", "rate(t, y, self.m, self.l, self.g, self.u)")
    + "model = Model(1.0, 1.0, -9.81, 0.0)",
    "for i in range(9):\n    a = accel(th, w, m, w, g, u)\n    w += a*dt\n    th += w*dt",
    "print(accel(th, w, m, l, g, w))",
    "rate(t, y, m, y[1], g, u)",
    "print(accel(s.a, s.b, m, s.b, g, u))",
    "solve_ivp(lambda y, t: rate(t, y, *p), (0, 1), y)",
    "odeint(lambda t, y: rate(t, y, *p), y, ts)",
    "def f(y, t): return rate(t, y, *p)\nsolve_ivp(f, (0, 1), y)",
    "f = lambda y, t: rate(t, y, *p)\nsolve_ivp(f, (0, 1), y)",
    "solve_ivp(rate, (0, 1), y, args=(m, l, 0 - 9.81, u))",
    "for i in range(9):\n    l = abs(th)\n    w += accel(th, w, m, l, g, u)*dt\n    th += w*dt",
    "def f(t, y):\n    l = abs(y[0])\n    return rate(t, y, m, l, g, u)\nsolve_ivp(f, (0, 1), y)",
    "for i in range(9):\n    w += accel(th, w, m, next(ls), g, u)*dt\n    th += w*dt",
    "q = dict(m=1.0, g=9.81, l=1.0, u=0.0)\nsolve_ivp(rate, (0, 1), y, args=tuple(q.values()))",
    "solve_ivp(lambda t, y: rate(t, y, *astuple(P())), (0, 1), y)",
    "class P:\n    m, l, g, u = 1.0, 1.0, -9.81, 0.0\nprint(accel(th, w, P.m, P.l, P.g, P.u))",
    "def go():\n    sys.modules[__name__].accel = len\n    return accel(th, w, m, l, g, u)",
    "with patch('math.sin', len):\n    print(accel(th, w, m, l, g, u))",
    "solve_ivp(rate, (0, 1), y, args=(m, l, 0.0, u))",
    "gravity = -9.81\nsolve_ivp(rate, (0, 1), y, args=(m, l, gravity, u))",
    "q = dict(m=1.0, l=1.0, g=-9.81, u=0.0)",
    "q = {'m': 1.0, 'l': 1.0, 'g': -9.81, 'u': 0.0}",
    "def f(t, y):\n    d = rate(t, y, *p)\n    return [d[1], d[0]]",
    "def f(t, y):\n    a, b = rate(t, y, *p)\n    return np.array([b, a])",
    "g = -g\nsolve_ivp(rate, (0, 1), y, args=(m, l, g, u))",
    "l, m = m, l",
    "l = l/2",
    "g *= -1",
    "g = u",
    "s = m\nm = l\nl = s",
    "q = {'l': l}\nq['l'] = m",
    "solve_ivp(fun=rate, t_span=(0, 1), y0=y, args=(l, m, g, u))",
    "def f(t, y): return rate(t, [y[1], y[0]], *p)\nsolve_ivp(f, (0, 1), y)",
)
INNOCENT = (
    CLASS.format("__call__", "t, y", "rate(t, y, self.m, self.l, self.g, self.u)")
    + "solve_ivp(Model(1.0, 1.0, 9.81, -0.5), (0, 1), y)",
    CLASS.format("rhs", "y, t", "rate(t, y, self.m, self.l, self.g, self.u)")
    + "odeint(Model(*p).rhs, y, ts)",
    "odeint(lambda t, y: rate(t, y, *p), y, ts, tfirst=True)",
    "solve_ivp(lambda t, y: rate(t, y, m, l, g, -2*y[0] - y[1]), (0, 1), y)",
    "solve_ivp(lambda t, y: rate(t, y, m, l, g, -k*y), (0, 1), y)",
    "solve_ivp(rate, (0, 1), y, args=(1.0, 1.0, 9.81, -0.5))",
    "solve_ivp(lambda s, z: rate(s, z, *p), (0, 1), y)",
    "def f(t, y):\n    a, b = rate(t, y, *p)\n    return np.array([a, b])",
    "d = rate(t, y, *p)\nprint(d[0], d[1])",
    "print(accel(s.th, s.w, s.m, s.l, s.g, s.u))",
    "print(accel(s['th'], s['w'], s['m'], s['l'], s['g'], 0.0))",
    "plt.plot(sol.y[0][::-1])",
    "m, l = 2.0, 0.5",
    "l = np.float64(l)",
    "half = l/2",
    "class P:\n    m, l, g, u = 1.0, 1.0, 9.81, 0.0\nprint(accel(th, w, P.m, P.l, P.g, P.u))",
    "def f(t, y, *args): return rate(t, y, *args)\nsolve_ivp(f, (0, 1), y, args=p)",
    "def f(t, y):\n    u = -abs(y[0])\n    return rate(t, y, m, l, g, u)\nsolve_ivp(f, (0, 1), y)",
    "n = m\nsolve_ivp(rate, (0, 1), y)",
)
RK4 = """k1 = {f}(t, y{p})
    k2 = {f}(t + {h}/2, y + {h}/2*k1{p})
    k3 = {f}(t + {h}/2, y + {h}/2*k2{p})
    k4 = {f}(t + {h}, y + {h}*k3{p})
"""
NOTHING = (
    "sol = solve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\ntheta = np.degrees(sol.y[0])\n"
    "x, z = l*np.sin(sol.y[0]), l*np.cos(sol.y[0])\nplt.plot(x, z)",
    "sol = odeint(lambda y, t: rate(t, y, m, l, g, u), y, np.linspace(0, 1, 9))\n"
    "th, w = sol.T\nE = m*l**2*w**2/6 + m*g*l/2*np.cos(th)\nplt.plot(E)",
    "sol = odeint(rate, y, t, args=p, tfirst=True)",
    "solve_ivp(lambda t, y: [y[1], accel(y[0], y[1], *p)], (0, 1), y)",
    "solve_ivp(partial(rate, m=m, l=l, g=g, u=u), (0, 1), y)",
    "mass, length = 1.0, 2.0\nsolve_ivp(rate, (0, 1), y, args=(mass, length, 9.81, 0))",
    "acc = np.array([rate(s, z, *p)[1] for s, z in zip(sol.t, sol.y.T)])\nplt.plot(acc)",
    "assert np.allclose(rate(0, [0, 0], 1.0, 1.0, 9.81, 0.0), 0)",
    "for i in range(9):\n    y = y + dt*rate(i*dt, y, *p)\n    ys.append(y)",
    "for i in range(9):\n    y += rate(t, y, *p)*dt\n    t += dt\n    if i % 3 == 0: print(y)",
    "for i in range(9):\n    Y[i+1] = Y[i] + (t[i+1] - t[i])*rate(t[i], Y[i], *p)",
    "for i in range(1, 9):\n    Y[i, :] = Y[i-1, :] + dt*np.array(rate(t[i-1], Y[i-1, :], *p))",
    "for i in range(9):\n    a = accel(th, w, *p)\n    w += a*dt\n    th += w*dt\n    s.append(th)",
    "while t < 1:\n    th, w = th + w*dt, w + accel(th, w, *p)*dt\n    t += dt",
    "for i in range(9):\n    w[i+1] = w[i] + accel(th[i], w[i], *p)*dt\n"
    "    th[i+1] = th[i] + w[i+1]*dt",
    "for i in range(9):\n    w += accel(th, w, *p)*dt\n"
    "    th = (th + w*dt + np.pi) % (2*np.pi) - np.pi",
    f"for i in range(9):\n    {RK4.format(f='rate', p=', *p', h='dt')}"
    "    y = y + dt/6*(k1 + 2*k2 + 2*k3 + k4)",
    f"def rk4(f, t, y, h):\n    {RK4.format(f='f', p='', h='h')}"
    "    return y + h/6*(k1 + 2*k2 + 2*k3 + k4)",
    "def euler(f, y, t):\n    for n in range(len(t) - 1):\n        h = t[n+1] - t[n]\n"
    "        Y[n+1] = Y[n] + h*f(t[n], Y[n])\n    return Y",
    "for i in range(9):\n    ws.append(ws[i] + accel(ths[i], ws[i], *p)*dt)\n"
    "    ths.append(ths[i] + ws[i+1]*dt)",
    "class Sim:\n    def step(self, dt):\n        self.y = self.y + dt*rate(self.t, self.y, *p)\n"
    "        self.t += dt",
    "n = 0\nwhile n < 5:\n    n += 1",
    "top = 0\nfor v in sol.y[0]:\n    top = max(top, abs(v))",
    "for k in range(3):\n    sol = solve_ivp(rate, (0, 1), y, args=p)\n    y = sol.y[:, -1]",
    "a = accel(th, w, *p)\nfor i in range(9):\n    th += w*dt + a*dt**2/2\n"
    "    b = accel(th, w, *p)\n    w += (a + b)*dt/2\n    a = b",
    "for i in range(9):\n    w += accel(th, w, *p)*dt\n    th += w*dt\n"
    "    if th > np.pi:\n        th -= 2*np.pi",
    "for i in range(9):\n    w += accel(th, w, *p)*dt\n"
    "    th = np.arctan2(np.sin(th + w*dt), np.cos(th + w*dt))",
    "for i in range(9):\n    d = rate(t, y, *p)\n    y[1] += dt*d[1]\n    y[0] += dt*y[1]",
    "for i in range(9):\n    d = rate(t, y, *p)\n    for j in range(2):\n        y[j] += dt*d[j]",
    "f = partial(rate, m=m, l=l, g=g, u=u)\nfor i in range(9):\n    y = y + dt*f(t, y)",
    "def step(s):\n    th, w = s['th'], s['w']\n    w += accel(th, w, *p)*dt\n    th += w*dt\n"
    "    s['th'], s['w'] = th, w\nfor i in range(9):\n    step(state)",
    "def simulate(y, n):\n    ys = np.zeros((n, 2))\n    ys[0] = y\n    for k in range(n - 1):\n"
    "        ys[k+1] = ys[k] + dt*rate(0, ys[k], *p)\n    return ys\n"
    "plt.plot(180/np.pi*simulate(y, 9)[:, 0])",
)


def _quoted(text: str) -> tuple[str, ...]:
    return lines_around(f"{FUNCTIONS}{text}\n", {"rate"}, NAMING)


@pytest.mark.sample(40)
@pytest.mark.parametrize("text", [*LAWS, *STEPS, *CHANGED, *ARGUMENTS, *PLACED])
def test_a_law_a_wrong_step_a_changed_result_and_exchanged_arguments_are_quoted(text: str) -> None:
    quoted = _quoted(text)
    assert quoted
    assert {*quoted} <= {" ".join(line.split())[:60] for line in text.splitlines()}


@pytest.mark.sample(40)
@pytest.mark.parametrize("text", [*NOTHING, *INNOCENT])
def test_calls_plots_and_right_integrators_say_nothing(text: str) -> None:
    assert _quoted(text) == ()


def test_a_function_that_a_later_one_replaces_is_quoted() -> None:
    assert _quoted("def rate(t, y, m, l, g, u):\n    return 0") == ("def rate(t, y, m, l, g, u):",)


def test_a_quoted_line_puts_a_grade_in_doubt_and_stands_in_the_answer(tmp_path: Path) -> None:
    path = tmp_path / "a.py"
    path.write_text(f"{FUNCTIONS}for i in range(9):\n    y = y - dt*rate(t, y, *p)\n")
    things = things_in(path, run_python=True)
    graded = grade(Reference(derived(ROD)), "a", things)
    assert graded.verdict == "in doubt"
    assert graded.unjudged == ("y = y - dt*rate(t, y, *p)",)
    assert {line.verdict for line in graded.lines} == {Verdict.PROVED.name}
    shown = CliRunner().invoke(app, ["check", "rod_pendulum", f"{path}:rate"])
    assert "not judged: 'y = y - dt*rate(t, y, *p)'" in shown.output
    path.write_text(path.read_text().replace("y - dt", "y + dt"))
    assert grade(Reference(derived(ROD)), "a", things_in(path, run_python=True)).verdict == "right"


OBJECT = """class Rod:
    def __init__(self, m=1.0, l=1.0, g=9.81, k=1.5):
        self.m, self.l, self.g = m, l, g
        self.k = k
    def rate(self, t, y):
        return [y[1], self.k*self.g/self.l*np.sin(y[0])]
rod = Rod()
"""


@pytest.mark.parametrize(
    "line",
    ["rod.k = 1.0", "rod.k *= 2", "rod = Rod(k=1.0)", "rod = Rod(1.0, 1.0, 9.81, 1.0)",
     "vars(rod).update(k=1.0)", "setattr(rod, 'k', 1.0)"],
)  # fmt: skip
def test_what_an_object_gets_that_the_scene_has_no_name_for_is_quoted(line: str) -> None:
    assert lines_around(f"{OBJECT}{line}\n", {"rate"}, NAMING) == (line,)


@pytest.mark.parametrize(
    "line", ["rod = Rod(m=2.0, l=0.5)", "rod.l = 0.3", "rod.history = []", "rod = Rod()"]
)
def test_parameters_of_an_object_are_no_law(line: str) -> None:
    assert lines_around(f"{OBJECT}{line}\n", {"rate"}, NAMING) == ()


DEFAULT = """def rate(t, y, m, l, g, k=1.5):
    return [y[1], k*g/l*np.sin(y[0])]
"""


@pytest.mark.parametrize(
    ("line", "quoted"),
    [
        ("s = solve_ivp(lambda t, y: rate(t, y, 1.0, 1.0, 9.81, k=1.0), (0, 9), y)", True),
        ("s = solve_ivp(partial(rate, k=1.0), (0, 9), y, args=(1.0, 1.0, 9.81))", True),
        ("s = solve_ivp(rate, (0, 9), y, args=(1.0, 1.0, 9.81, 1.0))", True),
        ("s = solve_ivp(rate, (0, 9), y, args=(1.0, 1.0, 9.81, 1.5))", False),
        ("s = solve_ivp(rate, (0, 9), y, args=(1.0, 1.0, 9.81))", False),
    ],
)
def test_a_number_that_a_call_gives_otherwise_than_its_default_is_quoted(
    line: str, quoted: bool
) -> None:
    assert bool(lines_around(f"{DEFAULT}{line}\n", {"rate"}, NAMING)) is quoted


DRIVEN = FUNCTIONS.replace("l, g, u)])", "l, g, u*np.cos(t))])")
MIDPOINT = """for i in range(9):
    k = rate(t, y, *p)
    y = y + dt*rate({}, y + dt/2*k, *p)
    t += {}
"""


@pytest.mark.parametrize(
    ("time", "span", "quoted"),
    [("t + dt/2", "dt", False), ("t", "dt", True), ("t - dt/2", "dt", True),
     ("t + dt/2", "2*dt", True), ("t + dt/2", "-dt", True)],
)  # fmt: skip
def test_a_driven_system_is_advanced_at_its_times(time: str, span: str, quoted: bool) -> None:
    code = DRIVEN + MIDPOINT.format(time, span)
    assert code.count("np.cos(t)") == 1
    assert bool(lines_around(code, {"rate"}, NAMING)) is quoted


@pytest.mark.parametrize(("time", "quoted"), [("t + dt", False), ("(t + dt) % 0.01", True)])
def test_the_time_of_a_driven_system_is_no_angle(time: str, quoted: bool) -> None:
    step = f"for i in range(9):\n    y = y + dt*rate(t, y, *p)\n    t = {time}\n"
    assert bool(lines_around(DRIVEN + step, {"rate"}, NAMING)) is quoted
    assert not lines_around(FUNCTIONS + step, {"rate"}, NAMING)


TWO = """import numpy as np
def accel(q, qd):
    return np.linalg.solve(M(q), f(q, qd))
dt, q, qd = 0.01, np.array([0.1, 0.2]), np.zeros(2)
"""
ANGLES = Naming(
    Vocabulary(double_pendulum.scene()),
    {},
    (
        Match("q", "phi1 phi2", "nothing else is left"),
        Match("qd", "phi1_dot phi2_dot", "nothing else is left"),
    ),
)
SOLVED = "def rhs(t, y):\n    q, qd = y[:2], y[2:]\n    return {}\nsolve_ivp(rhs, (0, 1), y)"


@pytest.mark.parametrize(
    ("text", "quoted"),
    [
        ("for i in range(9):\n    qd += accel(q, qd)*dt\n    q += qd*dt", False),
        ("for i in range(9):\n    qd -= accel(q, qd)*dt\n    q += qd*dt", True),
        ("for i in range(9):\n    qd += accel(qd, q)*dt\n    q += qd*dt", True),
        ("for i in range(9):\n    y[2:] += dt*accel(y[:2], y[2:])\n    y[:2] += dt*y[2:]", False),
        ("for i in range(9):\n    y[2:] += dt*accel(y[:2], y[2:])\n    y[:2] += dt*y[:2]", True),
        (SOLVED.format("np.concatenate([qd, accel(q, qd)])"), False),
        (SOLVED.format("np.hstack((accel(q, qd), qd))"), True),
        (SOLVED.format("np.hstack((qd, -accel(q, qd)))"), True),
    ],
)
def test_columns_of_coordinates_and_speeds_are_followed(text: str, quoted: bool) -> None:
    assert bool(lines_around(f"{TWO}{text}\n", {"accel"}, ANGLES)) is quoted


@pytest.mark.parametrize(
    "text",
    [
        "def first(n):\n    while n > 0:\n        n -= 1\n    return n\ng = first(9)*l",
        "def again(f, n):\n    return again(f, n - 1) if n else f\nagain(rate, 9)",
        "def endless(x):\n    return endless(x)\nprint(endless(l)*rate(0, y, *p))",
        "l = 1/0",
    ],
)
def test_what_is_not_followed_raises_nothing(text: str) -> None:
    assert {*_quoted(text)} <= {*text.splitlines()}


ADVANCED = "for i in range(9):\n    w += accel(th, w, *p)*dt\n    th += w*dt\n    "


@pytest.mark.parametrize(
    ("line", "quoted"),
    [
        ("th > 1 and (w := -w)", True), ("th > 1 and (w := -w)\n    " * 2, True),
        ("q = (w := -w) if th > 1 else 0", True), ("print(w := -w)", True),
        ("n > 1 and print(w)", False), ("q = (z := w) if th > 1 else 0", False),
    ],
)  # fmt: skip
def test_what_a_formula_sets_is_seen(line: str, quoted: bool) -> None:
    assert bool(_quoted(ADVANCED + line)) is quoted


EULER = "for i in range(9):\n    y = y + dt*rate(t, y, *p)\n"
SKIPPING = (
    "match mode:\n    case 1: a = -accel(th, w, *p)",
    ADVANCED + "match n:\n        case 1: w = -w",
    ADVANCED + "match n:\n        case w: pass",
    "for i in range(9):\n    pass\nelse:\n    a = -accel(th, w, *p)",
    ADVANCED + "for j in range(0):\n        pass\n    else:\n        w = -w",
    "async def f():\n    async with z:\n        a = -accel(th, w, *p)",
    "try:\n    pass\nexcept* ValueError:\n    a = -accel(th, w, *p)",
    "while (q := -accel(th, w, *p)) < 3:\n    pass",
    "if (q := -accel(th, w, *p)) < 3:\n    pass",
    "while (w := -w) < 3:\n    w += accel(th, w, *p)*dt\n    th += w*dt",
    "for i in range(9):\n    if th > 1: continue\n    w += accel(th, w, *p)*dt\n    th += w*dt",
    "for i in range(9):\n    w += accel(th, w, *p)*dt\n    if th > 1: continue\n    th += w*dt",
    "def step(y, h):\n    if y[0] > 3: return -y\n    return y + h*rate(0, y, *p)",
    "for i in range(9):\n    k = rate(0, y, *p)\n    for j in range(2):\n"
    "        y[j] += dt*k[j]; break",
    "for i in range(9):\n    k = rate(0, y, *p)\n    for j in range(2):\n        y[j] += dt*k[j]\n"
    "        if y[j] > 2: break",
    "def run(y):\n    for i in range(9):\n        y = y + dt*rate(0, y, *p)\n"
    "        if y[0] > 3: return -y",
    "def f(y):\n    if y[0] > 1: return -y\n    return y\n" + EULER + "    y = f(y)",
)
LEAVING = (
    EULER + "    if y[0] > 3: break",
    "for i in range(9):\n    if t > 3:\n        break\n    y = y + dt*rate(t, y, *p)",
    "def run(y):\n    for i in range(9):\n        Y[i+1] = Y[i] + dt*rate(0, Y[i], *p)\n"
    "        if Y[i+1][0] > 3: return Y[:i+1]\n    return Y",
    "while t < 9:\n    y = y + dt*rate(t, y, *p)\n    t += dt\nelse:\n    print(t)",
    "match mode:\n    case 1: a = accel(th, w, *p)\n    case _: pass",
    "while np.abs(accel(th, w, *p)) > 1e-3:\n    w += accel(th, w, *p)*dt\n    th += w*dt",
    "def main():\n    x: int\n    def f(t, y): return rate(t, y, *p)\n    solve_ivp(f, (0, 1), y)",
    "try:\n    solve_ivp(rate, (0, 1), y, args=p)\nfinally:\n    print(2)",
    "for i in range(9):\n    if not np.isfinite(y).all():\n        raise ValueError(y)\n"
    "    y = y + dt*rate(t, y, *p)",
)


@pytest.mark.parametrize("text", SKIPPING)
def test_a_line_that_may_not_be_run_is_seen(text: str) -> None:
    assert _quoted(text)


@pytest.mark.parametrize("text", LEAVING)
def test_a_loop_may_be_left(text: str) -> None:
    assert _quoted(text) == ()


TURNED = (
    "if th > 3: th -= 1.0*np.pi", "if w > 5: w -= 2*np.pi", "while w > 5: w -= 2*np.pi",
    "tau = 0.3\n    if th > 1: th -= tau", "if th > 1: w -= tau", "w = w % (2*np.pi)",
    "w = (w + np.pi) % (2*np.pi) - np.pi", "w = np.arctan2(np.sin(w), np.cos(w))",
    "th = th % np.pi", "th = th % (1*np.pi)", "if th > 3: th -= 2*x",
    "pi = 3\n    if th > 3: th -= 2*pi", "if th > 3: th -= 2*np.pi; w = -w",
)  # fmt: skip
SAME_ANGLE = (
    "if th > 3: th -= 2.0*np.pi", "if th > 3: th = th - np.pi*2", "while th > 3: th -= 2*np.pi",
    "th = th % (2*np.pi)", "th = (th + np.pi) % (2*np.pi) - np.pi", "th = th % tau",
    "th = np.arctan2(np.sin(th), np.cos(th))", "if th > 3: th -= math.tau",
)  # fmt: skip


@pytest.mark.parametrize(
    "text",
    [
        *(ADVANCED + line for line in TURNED),
        "for i in range(9):\n    w = (w + dt*accel(th, w, *p)) % (2*np.pi)\n    th += dt*w",
        "for i in range(9):\n    y = (y + dt*rate(t, y, *p)) % (2*np.pi)",
        "print(accel(th, w % (2*np.pi), m, l, g, u))", "a = accel(th, w, *p) % (2*np.pi)",
        "def step(th, w, tau):\n    w = w + 0.1*accel(th, w, *p)\n    th = th + 0.1*w\n"
        "    if th > 3: th -= tau\n    return th, w",
    ],
)  # fmt: skip
def test_what_is_no_whole_turn_of_an_angle_is_quoted(text: str) -> None:
    assert _quoted(text)


@pytest.mark.parametrize(
    "text",
    [
        *(ADVANCED + line for line in SAME_ANGLE),
        "for i in range(9):\n    y = y + dt*rate(t, y, *p)\n    y[0] = y[0] % (2*np.pi)",
        "print(accel(th % (2*np.pi), w, m, l, g, u))",
    ],
)
def test_a_whole_turn_of_an_angle_says_nothing(text: str) -> None:
    assert _quoted(text) == ()


CART = Naming(
    Vocabulary(cartpole.scene()), {},
    (Match("y", "x theta x_dot theta_dot", "the usual name of such a vector"),),
)  # fmt: skip


@pytest.mark.parametrize(("entry", "quoted"), [(0, True), (1, False), (2, True), (3, True)])
def test_a_length_has_no_turns(entry: int, quoted: bool) -> None:
    code = (
        "import numpy as np\ndef rate(t, y):\n    x, th, v, w = y\n    return [v, w, f(y), g(y)]\n"
    )
    step = f"{EULER.replace(', *p', '')}    if y[{entry}] > 3: y[{entry}] -= 2*np.pi\n"
    assert bool(lines_around(f"{code}{step}", {"rate"}, CART)) is quoted


@pytest.mark.parametrize(
    "line",
    ["dt = -dt", "dt *= -1", "dt = dt - 1", "dt = -np.abs(dt)", "if th > 1: dt = -dt",
     "h = -dt\n    dt = h"],
)  # fmt: skip
def test_a_step_of_time_that_goes_back_is_quoted(line: str) -> None:
    assert _quoted(ADVANCED + line)


@pytest.mark.parametrize("line", ["dt *= 1.1", "dt = dt/2", "dt = 0.02", "t += dt"])
def test_a_step_of_time_may_be_another(line: str) -> None:
    assert _quoted(ADVANCED + line) == ()


def test_a_loop_in_a_loop_that_adds_rates_is_followed() -> None:
    assert _quoted("for i in range(9):\n    for j in range(9):\n        y -= dt*rate(t, y, *p)")


HEUN = "for i in range(9):\n    y0 = {}\n    k = rate(t, y, *p)\n    {}\n    y = y0 + dt/2*(k + {})"
AGAIN = "rate(t + dt, y, *p)"


@pytest.mark.parametrize(
    ("start", "line", "quoted"),
    [
        ("y", "y += dt*k", True), ("y", "y[:] = y + dt*k", True),
        ("y", "y[0] += dt*k[0]\n    y[1] += dt*k[1]", True), ("y", "y = y + dt*k", False),
        ("y.copy()", "y += dt*k", False), ("np.array(y)", "y += dt*k", False),
        ("1*y", "y += dt*k", False),
    ],
)  # fmt: skip
def test_two_names_of_an_array_are_one(start: str, line: str, quoted: bool) -> None:
    assert bool(_quoted(HEUN.format(start, line, AGAIN))) is quoted


@pytest.mark.parametrize("line", ["z = y\n    z *= -1", "z, q = y, 1\n    z *= -1"])
def test_what_changes_an_array_by_another_name_is_quoted(line: str) -> None:
    assert EULER.splitlines()[1].strip() in _quoted(f"{EULER}    {line}")


@pytest.mark.parametrize(
    "text",
    [
        "for i in range(9):\n    k = dt*rate(t, y, *p)\n    y += k\n    ys.append(y)",
        "for i in range(9):\n    Y[i+1] = Y[i]\n    Y[i+1] += dt*rate(t, Y[i], *p)",
        "def step(y, h):\n    y += h*rate(0, y, *p)\n    return y\n"
        "for i in range(9):\n    y = step(y, dt)",
    ],
)  # fmt: skip
def test_an_array_that_is_advanced_in_place_is_innocent(text: str) -> None:
    assert _quoted(text) == ()

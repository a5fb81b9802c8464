"""What stands around a judged function of a Python file is quoted unless it leaves the motion."""

from pathlib import Path

import pytest
from typer.testing import CliRunner

from mechanics.claims.code.around.python_lines import lines_around
from mechanics.claims.names import Match, Naming, Vocabulary
from mechanics.cli.app import app
from systems import cartpole, rod_pendulum

NAMING = Naming(
    Vocabulary(rod_pendulum.scene()),
    {},
    (
        Match("y", "theta theta_dot", "the usual name of such a vector"),
        Match("th", "theta", "nothing else is left"),
        Match("w", "theta_dot", "nothing else is left"),
    ),
)
HEAD = """import json, math, sys
import numpy as np
from functools import partial
from scipy.integrate import solve_ivp, odeint
g, l, m, u = 9.81, 1.0, 1.0, 0.0
def accel(th, w, m, l, g, u):
    return 3*g/(2*l)*np.sin(th) + 3*u/(m*l**2)
def rate(t, y, m, l, g, u):
    th, w = y
    return np.array([w, accel(th, w, m, l, g, u)])
th, w, t, dt = 0.1, 0.0, 0.0, 0.01
p = (m, l, g, u)
"""
S1 = """sol = solve_ivp(rate, (0, 1), y0, args=p)
"""
INP = """for i in range(9):
    y += dt*rate(t, y, *p)
"""
EUL = """for i in range(9):
    y = y + dt*rate(t, y, *p)
"""
SIM = """def simulate(y0, T=1.0):
    sol = solve_ivp(rate, (0, T), y0, args=p)
    return sol.y[:, -1]
"""
EULER = """def euler(f, y, n):
    for k in range(n):
        y += 0.01*f(0, y)
    return y
"""
F = """f = lambda t, y: rate(t, y, *p)
"""
Y = """y = np.array([0.1, 0.0])
"""
CALL = """sol = solve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))
"""
WRONG_STARTS = (
    f"y0 = [0.1, 0.0]\n{S1}y0 = -sol.y[:, -1]\n{S1}",
    f"y0 = [0.1, 0.0]\n{S1}y0 = sol.y[:, -1]\ny0[1] = -y0[1]\n{S1}",
    f"y0 = [0.1, 0.0]\n{S1}y0 = sol.y[:, -1]*0.9\n{S1}",
    f"y0 = [0.1, 0.0]\n{S1}y0 = sol.y[::-1, -1]\n{S1}",
    f"y0 = [0.1, 0.0]\n{S1}y0 = [sol.y[1, -1], sol.y[0, -1]]\n{S1}",
    f"y0 = [0.1, 0.0]\n{S1}solve_ivp(rate, (1, 2), [sol.y[0, -1], -sol.y[1, -1]], args=p)\n",
    f"y0 = [0.1, 0.0]\n{S1}end = sol.y[:, -1]\nend[1] *= -1\n"
    "solve_ivp(rate, (1, 2), end, args=p)\n",
    "y0 = [0.1, 0.0]\nys = odeint(rate, y0, [0, 1], args=p, tfirst=True)\n"
    "y0 = np.flip(ys[-1])\nys = odeint(rate, y0, [1, 2], args=p, tfirst=True)\n",
    "y = [0.1, 0.0]\nfor k in range(3):\n"
    "    sol = solve_ivp(rate, (k, k + 1), y, args=p)\n    y = sol.y[:, -1]\n"
    "    y[1] = -0.8*y[1]\n",
    "def run(y0):\n    a = solve_ivp(rate, (0, 1), y0, args=p)\n"
    "    b = a.y[:, -1].copy()\n    b[0] += 0.1\n"
    "    return solve_ivp(rate, (1, 2), b, args=p)\n",
    f"y0 = [0.1, 0.0]\n{S1}th1, w1 = sol.y[:, -1]\n"
    "sol = solve_ivp(rate, (1, 2), [th1, -w1], args=p)\n",
    f"y0 = [0.1, 0.0]\n{S1}y0 = np.dot(np.diag([1, -1]), sol.y[:, -1])\n{S1}",
    f"{Y}{EUL}y[1] = -y[1]\n{EUL}",
    f"{Y}{EUL}y = -y\n{EUL}",
)
WRONG_ROUNDED = (
    f"y = np.array([1, 0])\n{INP}",
    "y = np.array([1, 0])\nfor i in range(9):\n    d = rate(t, y, *p)\n"
    "    y[0] += dt*d[0]\n    y[1] += dt*d[1]\n",
    "y = np.zeros(2, dtype=int)\nfor i in range(9):\n    y[:] = y + dt*rate(t, y, *p)\n",
    "y = np.zeros(2, dtype=np.float16)\nfor i in range(9):\n    y[:] = y + dt*rate(t, y, *p)\n",
    f"y = np.array([0.1, 0.0]).astype(np.float16)\n{INP}",
    f"y = np.array([0.1, 0.0], dtype='float16')\n{INP}",
    f"y = np.asarray([0.1, 0.0], np.float32)\n{INP}",
    "y = np.array([1, 0])\nfor i in range(9):\n    y[:] = y + dt*rate(t, y, *p)\n",
    "ys = np.zeros((10, 2), dtype=int)\nfor i in range(9):\n"
    "    ys[i+1] = ys[i] + dt*rate(t, ys[i], *p)\n",
    "ys = np.full((10, 2), 1)\nfor i in range(9):\n    ys[i+1] = ys[i] + dt*rate(t, ys[i], *p)\n",
    "ys = np.zeros_like([1, 2])\nfor i in range(9):\n    ys[:] = ys + dt*rate(t, ys, *p)\n",
    f"y = np.int64([1, 0])\n{INP}",
    f"{Y}for i in range(9):\n    y = (y + dt*rate(t, y, *p)).astype(np.float16)\n",
    f"{Y}for i in range(9):\n    y = (y + dt*rate(t, y, *p)).astype(int)\n",
    f"{Y}for i in range(9):\n    y = np.round(y + dt*rate(t, y, *p), 1)\n",
)
WRONG_NUMBERS = (
    f'l = float("-0.5")\n{CALL}',
    f"l = math.copysign(0.5, -1)\n{CALL}",
    f"l = -abs(0.5)\n{CALL}",
    f"l = sum([1, -2])\n{CALL}",
    f'l = json.loads("-0.5")\n{CALL}',
    f'l = int("-3")\n{CALL}',
    f'l = np.float64("-1")\n{CALL}',
    f"l = -(0.5)\n{CALL}",
    f"l = max(-1, -2)\n{CALL}",
    f"l = min(-1, 2)\n{CALL}",
    f"l = 1 - 2\n{CALL}",
    f"l = [0.5, -0.5][1]\n{CALL}",
    f"l = (0.5, -0.5)[-1]\n{CALL}",
    f"l = dict(a=-1)['a']\n{CALL}",
    f"l = eval('-1')\n{CALL}",
    f"l = -np.pi\n{CALL}",
    f"l = np.cos(np.pi)\n{CALL}",
    f"l = 0.0\n{CALL}",
    f"l = float(np.array(-1))\n{CALL}",
    f"l = -1 if True else 1\n{CALL}",
    f"l = round(-0.5, 1)\n{CALL}",
    f"l = complex(-1).real\n{CALL}",
    f"l = True and -1\n{CALL}",
    f"l = (lambda: -1.0)()\n{CALL}",
    f"l = next(iter([-1]))\n{CALL}",
    f"(l := -1.0)\n{CALL}",
    f"l, m = -1, 1\n{CALL}",
    f"l: float = -0.5\n{CALL}",
    f"l = 1.0\nl -= 2\n{CALL}",
    f"l = np.negative(0.5)\n{CALL}",
    f"l = np.prod([-1, 2])\n{CALL}",
    "length = -0.5\nsol = solve_ivp(rate, (0, 1), [0.1, 0], args=(m, length, g, u))\n",
    f"c = dict(m=1.0, l=float('-1'), g=9.81, u=0.0)\n{CALL}",
    'sol = solve_ivp(rate, (0, 1), [0.1, 0], args=(m, float("-0.5"), g, u))\n',
    "sol = solve_ivp(rate, (0, 1), [0.1, 0], args=(1.0, -abs(0.5), 9.81, 0.0))\n",
    "for l in [-1.0]:\n    print(accel(0.1, 0, m, l, g, u))\n",
)
WRONG_VIEWS = (
    f"{Y}v = np.asarray(y)\nfor i in range(9):\n    y[:] = y + dt*rate(t, y, *p)\nv *= -1\n{INP}",
    f"{Y}v = y[:]\n{INP}    v[1] = -v[1]\n",
    f"{Y}v = y.view()\n{INP}    v[1] = 0\n",
    f"{Y}v = y.reshape(-1)\n{INP}    v[1] = 0\n",
    f"{Y}for i in range(9):\n    z = np.asarray(y)\n    z += dt*rate(t, y, *p)\n"
    "    y += dt*rate(t, z, *p)\n",
    f"{Y}for i in range(9):\n    old = y[:]\n    y += dt/2*rate(t, y, *p)\n"
    "    y[:] = old + dt*rate(t, y, *p)\n",
    f"{Y}for i in range(9):\n    old = np.asarray(y)\n    y += dt/2*rate(t, y, *p)\n"
    "    y[:] = old + dt*rate(t, y, *p)\n",
    f"{Y}for i in range(9):\n    old = y.view()\n    y += dt/2*rate(t, y, *p)\n"
    "    y[:] = old + dt*rate(t, y, *p)\n",
    f"{Y}for i in range(9):\n    old = y.reshape(-1)\n    y += dt/2*rate(t, y, *p)\n"
    "    y[:] = old + dt*rate(t, y, *p)\n",
    f"{Y}for i in range(9):\n    old = y\n    y += dt/2*rate(t, y, *p)\n"
    "    y[:] = old + dt*rate(t, y, *p)\n",
    f"{Y}for i in range(9):\n    old = y.ravel()\n    y += dt/2*rate(t, y, *p)\n"
    "    y[:] = old + dt*rate(t, y, *p)\n",
    f"{Y}for i in range(9):\n    old = y[0:2]\n    y += dt/2*rate(t, y, *p)\n"
    "    y[:] = old + dt*rate(t, y, *p)\n",
    f"{Y}w2 = y[1:]\n{INP}    w2 *= -1\n",
)
WRONG_TOLD = (
    "solve_ivp(rate, (0, 1), [0.1, 0], args=(l, m, g, u))\n",
    "def jac(t, y, m, l, g, u): return [[0, 1], [-3*g/(2*l)*np.cos(y[0]), 0]]\n"
    "solve_ivp(rate, (0, 1), [0.1, 0], args=p, method='Radau', jac=jac)\n",
    "solve_ivp(rate, (0, 1), [0.1, 0], args=p, method='Radau', jac=lambda t, y, *a: "
    "[[0, 1], [-1, 0]])\n",
    "solve_ivp(rate, (0, 1), [0.1, 0], args=p, method='Radau', jac=np.array([[0, 1], "
    "[-9.81, 0]]))\n",
    "def hit(t, y, *a):\n    y[1] = -y[1]\n    return y[0]\n"
    "solve_ivp(rate, (0, 1), [0.1, 0], args=p, events=hit)\n",
    "def hit(t, y, *a):\n    y *= 0.5\n    return y[0]\n"
    "solve_ivp(rate, (0, 1), [0.1, 0], args=p, events=[hit])\n",
    "solve_ivp(rate, (0, 1), [0.1, 0], args=p, mass=np.diag([1, 2]))\n",
    "f = partial(rate, m=l, l=m, g=g, u=u)\nsolve_ivp(f, (0, 1), [0.1, 0])\n",
    "solve_ivp(lambda t, y: -rate(t, y, *p), (0, 1), [0.1, 0])\n",
    "solve_ivp(lambda t, y: np.negative(rate(t, y, *p)), (0, 1), [0.1, 0])\n",
    "solve_ivp(lambda t, y: rate(t, y, *p)[::-1], (0, 1), [0.1, 0])\n",
    "solve_ivp(lambda t, y: rate(t, y, m=l, l=m, g=g, u=u), (0, 1), [0.1, 0])\n",
    "solve_ivp(rate, (0, 1), [0.1, 0], args=p[::-1])\n",
    "solve_ivp(rate, (0, 1), [0.1, 0], args=reversed(p))\n",
    "solve_ivp(rate, (0, 1), [0.1, 0], args=sorted(p))\n",
    "opts = {'args': (l, m, g, u)}\nsolve_ivp(rate, (0, 1), [0.1, 0], **opts)\n",
    "solve_ivp(rate, t_span=(0, 1), y0=[0.1, 0], args=(m, l, u, g))\n",
    "odeint(rate, [0.1, 0], [0, 1], args=(l, m, g, u), tfirst=True)\n",
    "odeint(rate, [0.1, 0], [0, 1], args=p)\n",
    "def step(y): y[1] = 0\nclass M:\n    def rate2(self, t, y):\n        y[0] = 0\n"
    "        return rate(t, y, *p)\nsolve_ivp(M().rate2, (0, 1), [0.1, 0])\n",
    "class Solver(RK45):\n    def step(self):\n        super().step()\n"
    "        self.y = -self.y\nsolve_ivp(rate, (0, 1), [0.1, 0], args=p, method=Solver)\n",
    "r = ode(rate).set_integrator('dopri5')\nr.set_initial_value([0.1, 0])\n"
    "while r.t < 1:\n    r.integrate(r.t + 0.1)\n    r._y[1] *= -1\n",
    "s = RK45(lambda t, y: rate(t, y, *p), 0, [0.1, 0], 1)\n"
    "while s.status == 'running':\n    s.step()\n    s.y[1] = -s.y[1]\n",
    "s = RK45(lambda t, y: rate(t, y, *p), 0, [0.1, 0], 1)\n"
    "while s.status == 'running':\n    s.step()\n    s.y *= 0.9\n",
)
WRONG_RECORDS = (
    "from collections import namedtuple\nS = namedtuple('S', 'w th')\ns = S(0.0, 0.1)\n"
    "th, w = s\nfor i in range(9):\n    w += accel(th, w, *p)*dt\n    th += w*dt\n",
    "from collections import namedtuple\nS = namedtuple('S', ['w', 'th'])\n"
    "s = S(0.1, 0.0)\nfor i in range(9):\n    th, w = s\n    w += accel(th, w, *p)*dt\n"
    "    th += w*dt\n    s = S(th, w)\n",
    "from typing import NamedTuple\nclass S(NamedTuple):\n    w: float\n    th: float\n"
    "s = S(0.1, 0.0)\nfor i in range(9):\n    th, w = s\n    print(accel(th, w, *p))\n",
    "from dataclasses import dataclass, astuple\n@dataclass\nclass S:\n    w: float\n"
    "    th: float\ns = S(0.1, 0.0)\nth, w = astuple(s)\nprint(accel(th, w, *p))\n",
    "from dataclasses import dataclass, astuple\n@dataclass\nclass P:\n"
    "    l: float = 1.0\n    m: float = 1.0\n    g: float = 9.81\n    u: float = 0.0\n"
    "solve_ivp(rate, (0, 1), [0.1, 0], args=astuple(P()))\n",
)
WRONG_OTHERS = (
    f"{SIM}end = simulate([0.1, 0])\nend = -end\nsimulate(end)\n",
    f"{SIM}end = simulate([0.1, 0])\nsimulate(0.9*end)\n",
    f"{SIM}a, b = simulate([0.1, 0])\nsimulate([b, a])\n",
    f"{SIM}y = np.array([0.1, 0])\nfor k in range(3):\n    y = simulate(y)\n    y[1] *= -1\n",
    "sols = []\ny0 = [0.1, 0]\nfor k in range(3):\n"
    "    sols.append(solve_ivp(rate, (0, 1), y0, args=p))\n"
    "    y0 = sols[-1].y[:, -1]*[1, -1]\n",
    "sol = solve_ivp(rate, (0, 1), [0.1, 0], args=p)\ny1 = sol.y.T[-1].tolist()\n"
    "y1.reverse()\nsol = solve_ivp(rate, (1, 2), y1, args=p)\n",
    "sol = solve_ivp(rate, (0, 1), [0.1, 0], args=p)\ny1 = sol.sol(1.0)\ny1[1] = 0\n"
    "sol = solve_ivp(rate, (1, 2), y1, args=p)\n",
    "y0 = [0.1, 0]\nsol = solve_ivp(rate, (0, 1), y0=y0, args=p)\n"
    "y0 = np.where(sol.y[:, -1] > 0, 0, 1)\n"
    "sol = solve_ivp(rate, (0, 1), y0=y0, args=p)\n",
    "y0 = [0.1, 0]\nsol = solve_ivp(rate, (0, 1), y0=y0, args=p)\n"
    "y0 = sol.y[:, -1] % (2*np.pi)\nsol = solve_ivp(rate, (0, 1), y0=y0, args=p)\n",
    f"{F}{EULER}euler(f, np.array([1, 0]), 9)\n",
    f"{F}{EULER}y = np.array([1, 0])\neuler(f, y, 9)\n",
    f"{F}{EULER}euler(f, np.zeros(2, int), 9)\n",
    "class Sim:\n    def __init__(self):\n        self.y = np.array([1, 0])\n"
    "    def step(self):\n        self.y += dt*rate(0, self.y, *p)\ns = Sim()\ns.step()\n",
    "class Sim:\n    def __init__(self):\n"
    "        self.y = np.array([0.1, 0], dtype='float16')\n    def step(self):\n"
    "        self.y += dt*rate(0, self.y, *p)\ns = Sim()\ns.step()\n",
    "y = np.ones(2, np.int32)\nfor i in range(9):\n    y += (dt*rate(t, y, *p)).astype(int)\n",
    "y = np.array([1, 0])\nfor i in range(9):\n    k1 = rate(t, y, *p)\n"
    "    k2 = rate(t, y + dt/2*k1, *p)\n    y[...] = y + dt*k2\n",
    f"y = np.eye(2, dtype=int)[0]\n{INP}",
    "y = np.array([1, 0]); z = y.copy()\nfor i in range(9):\n    z += dt*rate(t, z, *p)\n",
    "y = np.linspace(0, 1, 2, dtype=int)\nfor i in range(9):\n"
    "    y[0] += dt*rate(t, y, *p)[0]\n    y[1] += dt*rate(t, y, *p)[1]\n",
    "ths = np.arange(10)\nws = np.zeros(10)\nfor i in range(9):\n"
    "    ws[i+1] = ws[i] + dt*accel(ths[i], ws[i], *p)\n"
    "    ths[i+1] = ths[i] + dt*ws[i+1]\n",
    "def neg(x): return -x\nl = neg(0.5)\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "a = -0.5\nl = a\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "L = {'l': -0.5}\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, L['l'], g, u))\n",
    "vals = [1.0, -0.5]\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, vals[1], g, u))\n",
    "l = math.sin(-1)\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = abs(0.5)*-1\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = 0.5 - 0.5\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = m - 2\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = float('nan')\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = float('-inf')\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = None or -0.5\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = np.array([-0.5])[0]\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = np.array([-0.5]).item()\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = int('-0x1', 16)\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = math.fsum([-1, 0.5])\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = pow(-1, 3)\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = (-1)**5\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = -1 % 3 - 3\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = ~0\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = len('') - 1\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = '-0.5'\nl = float(l)\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "def f(t, y):\n    y = np.asarray(y)\n    y[1] *= -1\n    return rate(t, y, *p)\n"
    "solve_ivp(f, (0, 1), [0.1, 0])\n",
    "def f(t, y):\n    v = y[1:]\n    v *= -1\n    return rate(t, y, *p)\n"
    "solve_ivp(f, (0, 1), [0.1, 0])\n",
    "def f(t, y):\n    y.sort()\n    return rate(t, y, *p)\nsolve_ivp(f, (0, 1), [0.1, 0])\n",
    "def f(t, y):\n    np.random.shuffle(y)\n    return rate(t, y, *p)\n"
    "solve_ivp(f, (0, 1), [0.1, 0])\n",
    f"{Y}{INP}    y.sort()\n",
    f"{Y}{INP}    y.fill(0)\n",
    f"{Y}{INP}    y.put(1, 0)\n",
    f"{Y}{INP}    np.clip(y, -1, 1, out=y)\n",
    f"{Y}{INP}    y = np.clip(y, -1, 1)\n",
    "y = [0.1, 0.0]\nfor i in range(9):\n    d = rate(t, y, *p)\n"
    "    y = [y[0] + dt*d[0], y[1] + dt*d[1]]\n    y.reverse()\n",
    "solve_ivp(rate, (0, 1), [0.1, 0], 'RK45', None, False, None, False, (l, m, g, u))\n",
    "from dataclasses import dataclass, astuple\n@dataclass\nclass S:\n    w: float\n"
    "    th: float\ndef go(s: S):\n    return accel(*astuple(s), *p)\n",
    "from collections import namedtuple\nS = namedtuple('S', 'th w')\ns = S(w, th)\n"
    "print(accel(s.th, s.w, *p))\n",
)
RIGHT_STARTS = (
    f"y0 = [0.1, 0.0]\n{S1}y0 = sol.y[:, -1]\n{S1}",
    f"y0 = [0.1, 0.0]\n{S1}y0 = list(sol.y[:, -1])\n{S1}",
    f"y0 = [0.1, 0.0]\n{S1}y0 = [sol.y[0, -1], sol.y[1, -1]]\n{S1}",
    f"y0 = [0.1, 0.0]\n{S1}y0 = [0.2, 0.0]\n{S1}",
    f"y0 = np.radians([10, 0])\n{S1}",
    f"for a in (0.1, 0.2):\n    y0 = [a, 0.0]\n    {S1}",
    "for a in np.linspace(0.1, 1, 5):\n    y0 = np.array([np.deg2rad(a), 0.0])\n"
    f"    {S1}    plt.plot(sol.t, sol.y[0])\n",
    "y0 = [0.1, 0.0]\n"
    f"{S1}ys = odeint(rate, y0, np.linspace(0, 1, 11), args=p, tfirst=True)\n"
    "err = np.abs(sol.y[0, -1] - ys[-1, 0])\nprint(err)\nassert err < 1e-3\n",
    "y0 = np.array([0.1, 0.0])\n"
    f"{S1}s2 = solve_ivp(rate, (0, 1), y0 + [1e-8, 0], args=p)\n"
    "d = np.linalg.norm(s2.y - sol.y, axis=0)\n",
    "y = [0.1, 0.0]\nfor k in range(3):\n"
    "    sol = solve_ivp(rate, (k, k + 1), y, args=p)\n    y = sol.y[:, -1].copy()\n",
)
RIGHT_ROUNDED = (
    f"y = np.array([1, 0])\n{EUL}",
    f"y = np.array([1.0, 0])\n{INP}",
    f"y = np.zeros(2)\n{INP}",
    f"y = np.array([1, 0], dtype=float)\n{INP}",
    f"y = np.array([1, 0]).astype(float)\n{INP}",
    f"y = np.zeros(2, dtype=np.float64)\n{INP}",
    "ys = np.zeros((10, 2))\nys[0] = [1, 0]\nfor i in range(9):\n"
    "    ys[i+1] = ys[i] + dt*rate(t, ys[i], *p)\n",
    f"n = np.zeros(3, dtype=int)\nn[0] += 1\n{Y}{INP}",
    f"{Y}idx = np.array([1, 0])\nprint(y[idx])\n{INP}",
    f"y = np.array([np.pi/4, 0])\n{INP}",
    f"y = np.array([th, w])\n{INP}",
)
RIGHT_NUMBERS = (
    f'l = float("0.5")\n{CALL}',
    f"l = abs(-0.5)\n{CALL}",
    f"l = max(1, 2)\n{CALL}",
    f"l = 2 - 1\n{CALL}",
    f"l = [0.5, -0.5][0]\n{CALL}",
    f"l = np.float64(1)\n{CALL}",
    f"l = math.sqrt(2)\n{CALL}",
    f"u = -abs(0.5)\n{CALL}",
    f"u = float('-1')\n{CALL}",
    f"l = 1/2\n{CALL}",
    "import argparse\nap = argparse.ArgumentParser()\n"
    "ap.add_argument('--l', type=float, default=1.0)\nargs = ap.parse_args([])\n"
    f"l = args.l\n{CALL}",
    f"l = 0.5 if m > 1 else 1.0\n{CALL}",
    f"l: float = 0.5\n{CALL}",
    f"th = -0.5\n{CALL}",
    f"w = -abs(0.2)\n{CALL}",
    f"cfg = json.load(open('c.json'))\nl = cfg['l']\n{CALL}",
    "for l in [0.5, 1.0]:\n    print(accel(0.1, 0, m, l, g, u))\n",
    "for l in np.linspace(0.5, 1, 4):\n    print(accel(0.1, 0, m, l, g, u))\n",
    f"omega = np.sqrt(g/l)\nT = 2*np.pi/omega\nprint(T)\n{CALL}",
)
RIGHT_VIEWS = (
    f"{Y}for i in range(9):\n    old = y.copy()\n    y += dt/2*rate(t, y, *p)\n"
    "    y[:] = old + dt*rate(t, y, *p)\n",
    f"{Y}v = np.asarray(y)\n{EUL}print(v)\n",
    f"{Y}for i in range(9):\n    old = y\n    y = y + dt/2*rate(t, y, *p)\n"
    "    y = old + dt*rate(t, y, *p)\n",
    f"{Y}ys = [y.copy()]\n{INP}    ys.append(y.copy())\nys = np.array(ys)\nplt.plot(ys[:, 0])\n",
    f"{Y}for i in range(9):\n    old = np.array(y)\n    y += dt/2*rate(t, y, *p)\n"
    "    y[:] = old + dt*rate(t, y, *p)\n",
    f"{Y}for i in range(9):\n    z = np.asarray(y)\n    y = z + dt*rate(t, z, *p)\n",
)
RIGHT_TOLD = (
    "solve_ivp(rate, (0, 1), [0.1, 0], args=p, method='Radau', rtol=1e-8, atol=1e-10,"
    " max_step=0.1, dense_output=True, t_eval=np.linspace(0, 1, 5))\n",
    "def hit(t, y, *a):\n    return y[0]\nhit.terminal = True\nhit.direction = -1\n"
    "solve_ivp(rate, (0, 1), [0.1, 0], args=p, events=hit)\n",
    "solve_ivp(rate, (0, 1), [0.1, 0], args=p, events=lambda t, y, *a: y[0])\n",
    "solve_ivp(rate, t_span=[0, 5], y0=[0.1, 0], args=p)\n",
    "opts = dict(rtol=1e-8, atol=1e-8)\nsolve_ivp(rate, (0, 1), [0.1, 0], args=p, **opts)\n",
    "s = RK45(lambda t, y: rate(t, y, *p), 0, [0.1, 0], 1)\n"
    "while s.status == 'running':\n    s.step()\n    print(s.t, s.y)\n",
    "r = ode(rate).set_integrator('dopri5')\n"
    "r.set_initial_value([0.1, 0]).set_f_params(*p)\nwhile r.t < 1:\n"
    "    r.integrate(r.t + 0.1)\n    print(r.y)\n",
    "f = partial(rate, m=m, l=l, g=g, u=u)\nsolve_ivp(f, (0, 1), [0.1, 0])\n",
)
RIGHT_USES = (
    "import pandas as pd\nsol = solve_ivp(rate, (0, 1), [0.1, 0], args=p)\n"
    "df = pd.DataFrame({'t': sol.t, 'th': sol.y[0]})\ndf.to_csv('a.csv')\n"
    "print(df.describe())\n",
    "import matplotlib.pyplot as plt\nsol = solve_ivp(rate, (0, 1), [0.1, 0], args=p)\n"
    "fig, ax = plt.subplots()\nax.plot(sol.t, np.degrees(sol.y[0]))\nax.set_xlabel('t')\n"
    "plt.show()\n",
    "def main():\n    sol = solve_ivp(rate, (0, 1), [0.1, 0], args=p)\n"
    "    print(sol.y[0, -1])\nif __name__ == '__main__':\n    main()\n",
    "def test_up():\n    assert accel(0.0, 0.0, 1.0, 1.0, 9.81, 0.0) == 0\n"
    "    np.testing.assert_allclose(rate(0, [0, 0], 1.0, 1.0, 9.81, 0.0), [0, 0])\n",
    "from dataclasses import dataclass\n@dataclass(frozen=True)\nclass Config:\n"
    "    m: float = 1.0\n    l: float = 0.5\n    g: float = 9.81\n    u: float = 0.0\n"
    "c = Config()\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(c.m, c.l, c.g, c.u))\n",
    "sol = solve_ivp(rate, (0, 1), [0.1, 0], args=p)\ndef animate(i):\n"
    "    line.set_data([0, l*np.sin(sol.y[0, i])], [0, l*np.cos(sol.y[0, i])])\n"
    "    return line,\n",
)
RIGHT_OTHERS = (
    f"{SIM}end = simulate([0.1, 0])\nend = simulate(end)\nprint(end)\n",
    f"{SIM}for a in [0.1, 0.2]:\n    print(simulate([a, 0]))\n",
    f"{SIM}e = abs(simulate([0.1, 0], 2.0) - simulate([0.1, 0], 1.0))\nassert e[0] < 9\n",
    f"{F}{EULER}euler(f, np.array([1.0, 0]), 9)\n",
    "class Sim:\n    def __init__(self):\n        self.y = np.array([0.1, 0])\n"
    "    def step(self):\n        self.y += dt*rate(0, self.y, *p)\ns = Sim()\n"
    "for i in range(9):\n    s.step()\n    print(s.y)\n",
    "sol = solve_ivp(rate, (0, 1), [0.1, 0], args=p)\nidx = np.argmax(sol.y[0])\n"
    "k = np.array([0, 1])\nk[0] = idx\n",
    "th, w = 1, 0\nfor i in range(9):\n    w += accel(th, w, *p)*dt\n    th += w*dt\n",
    f"y0 = np.array([1, 0])\n{S1}",
    "sol = solve_ivp(rate, (0, 1), [0.1, 0], args=p, events=None, method='LSODA')\n",
    "kw = {'rtol': 1e-8, 'method': 'DOP853'}\n"
    "sol = solve_ivp(rate, (0, 1), [0.1, 0], args=p, **kw)\n",
    "def run(y0, **kw):\n    return solve_ivp(rate, (0, 1), y0, args=p, **kw)\n"
    "run([0.1, 0], rtol=1e-9)\n",
    "from dataclasses import dataclass, astuple\n@dataclass\nclass P:\n"
    "    m: float = 1.0\n    l: float = 1.0\nc = P(m=2.0)\nprint(c.m)\n",
    "sol = solve_ivp(rate, (0, 1), [0.1, 0], args=p)\nth, w = sol.y\n"
    "fig, (ax1, ax2) = plt.subplots(2)\nax1.plot(sol.t, th)\nax2.plot(th, w)\n",
    "l = 0.5 if len(sys.argv) > 1 else 1.0\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = float(sys.argv[1]) if len(sys.argv) > 1 else 1.0\n"
    "solve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = abs(-2) - 1\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    f"l = 1.0\nfor l in (0.5, 1.0, 2.0):\n    {CALL}",
    "l = pow(2, 3)\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "for w0 in [-1.0, 0.0, 1.0]:\n    sol = solve_ivp(rate, (0, 1), [0.1, w0], args=p)\n"
    "    plt.plot(sol.y[0], sol.y[1])\n",
    "for u in [-1.0, 0.0, 1.0]:\n    print(accel(0.1, 0, m, l, g, u))\n",
    "class Env:\n    def reset(self, seed=None):\n"
    "        self.state = np.array([np.pi, 0.0])\n        return self.state, {}\n"
    "    def step(self, action):\n        th, w = self.state\n"
    "        u = np.clip(action, -2, 2)[0]\n        w = w + accel(th, w, m, l, g, u)*dt\n"
    "        th = th + w*dt\n        self.state = np.array([th, w])\n"
    "        return self.state, 0.0, False, False, {}\n",
    f"{Y}Ys = np.empty((10, 2))\nYs[0] = y\nfor k in range(9):\n    k1 = rate(t, y, *p)\n"
    "    k2 = rate(t + dt/2, y + dt/2*k1, *p)\n    k3 = rate(t + dt/2, y + dt/2*k2, *p)\n"
    "    k4 = rate(t + dt, y + dt*k3, *p)\n    y = y + dt/6*(k1 + 2*k2 + 2*k3 + k4)\n"
    "    Ys[k+1] = y\n    t += dt\n",
    "a, b = -0.5, 0.5\nx = np.linspace(a, b, 9)\nprint([accel(v, 0, *p) for v in x])\n",
    "ymax = max(1, -2)\nplt.ylim(-ymax, ymax)\n",
    "def f(t, y):\n    y = np.asarray(y)\n    return rate(t, y, *p)\n"
    "solve_ivp(f, (0, 1), [0.1, 0])\n",
    "q = np.array([0.1]); qd = np.array([0.0])\n"
    "sol = solve_ivp(rate, (0, 1), np.concatenate([q, qd]), args=p)\n",
    "sol = solve_ivp(rate, (0, 1), [0.1, 0], args=p)\n"
    "E = 0.5*m*l**2*sol.y[1]**2/3 + m*g*l/2*np.cos(sol.y[0])\n"
    "drift = np.max(np.abs(E - E[0]))\nassert drift < 1e-2\n",
    f"{Y}best = y\n{EUL}    if y[0] > best[0]:\n        best = y\n",
)

WRONG_ATTACKS = (
    "y0 = [0.1, 0]\nsol = solve_ivp(rate, (0, 1), y0, args=p)\nsol.y[1] *= -1\n"
    "sol2 = solve_ivp(rate, (1, 2), sol.y[:, -1], args=p)\n",
    "res = [solve_ivp(rate, (0, 1), [0.1, 0], args=p)]\n"
    "res.append(solve_ivp(rate, (1, 2), res[-1].y[:, -1] + [0, 0.5], args=p))\n",
    "sol = solve_ivp(rate, (0, 1), [0.1, 0], args=p)\n"
    "start = np.array([sol.y[0][-1], -sol.y[1][-1]])\n"
    "solve_ivp(rate, (1, 2), start, args=p)\n",
    "sol = solve_ivp(rate, (0, 1), [0.1, 0], args=p)\nstart = dict(a=sol.y[:, -1])\n"
    "solve_ivp(rate, (1, 2), -start['a'], args=p)\n",
    "def next_start(y): return [y[0], -y[1]]\n"
    "sol = solve_ivp(rate, (0, 1), [0.1, 0], args=p)\n"
    "solve_ivp(rate, (1, 2), next_start(sol.y[:, -1]), args=p)\n",
    "sol = solve_ivp(rate, (0, 1), [0.1, 0], args=p)\nthe = sol.y[0, -1]\n"
    "we = -sol.y[1, -1]\nsolve_ivp(rate, (1, 2), [the, we], args=p)\n",
    "sol = solve_ivp(rate, (0, 1), [0.1, 0], args=p)\nthe = sol.y[0, -1]\n"
    "we = sol.y[1, -1]\nsolve_ivp(rate, (1, 2), (we, the), args=p)\n",
    "y = np.array(1*[1, 0])\nfor i in range(9):\n    y += dt*rate(t, y, *p)\n",
    "y = np.array([int(1), 0])\nfor i in range(9):\n    y += dt*rate(t, y, *p)\n",
    "a = 1\ny = np.array([a, 0])\nfor i in range(9):\n    y += dt*rate(t, y, *p)\n",
    "y = np.fromstring('1 0', dtype=int, sep=' ')\nfor i in range(9):\n"
    "    y += dt*rate(t, y, *p)\n",
    "y = np.array(range(2))\nfor i in range(9):\n    y += dt*rate(t, y, *p)\n",
    "y = np.array([True, False])\nfor i in range(9):\n    y[:] = y + dt*rate(t, y, *p)\n",
    "y = np.array([1, 0]).reshape(2)\nfor i in range(9):\n    y += dt*rate(t, y, *p)\n",
    "y = np.r_[1, 0]\nfor i in range(9):\n    y += dt*rate(t, y, *p)\n",
    "ty = int\ny = np.zeros(2, ty)\nfor i in range(9):\n    y += dt*rate(t, y, *p)\n",
    "y = np.random.randint(0, 2, 2)\nfor i in range(9):\n    y += dt*rate(t, y, *p)\n",
    "import array\ny = array.array('i', [1, 0])\nfor i in range(9):\n"
    "    d = rate(t, y, *p)\n    y[0] += int(dt*d[0])\n    y[1] += int(dt*d[1])\n",
    "l = float('-' + '0.5')\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = float(str(-0.5))\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "class C:\n    l = float('-0.5')\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, C.l, g, u))\n",
    "cfg = json.loads('{\"l\": -0.5}')\n"
    "solve_ivp(rate, (0, 1), [0.1, 0], args=(m, cfg['l'], g, u))\n",
    "m, l = map(float, ('1', '-0.5'))\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "m, l, g, u = np.array([1, -0.5, 9.81, 0])\n"
    "solve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = np.random.uniform(-1, -0.5)\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "for l in np.linspace(-1, 1, 5):\n    solve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "for k in range(3):\n    l = -1 + k\n"
    "    solve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "solve_ivp(rate, (0, 1), [0.1, 0], args=[*p][::-1])\n",
    "solve_ivp(rate, (0, 1), [0.1, 0], args=(*p[:1], g, l, u))\n",
    "def f(t, y, *a): return rate(t, y, *a[::-1])\nsolve_ivp(f, (0, 1), [0.1, 0], args=p)\n",
    "y = np.array([0.1, 0.0])\nv = y[1:2]\nfor i in range(9):\n    v[0] = 0\n"
    "    y += dt*rate(t, y, *p)\n",
)
RIGHT_ATTACKS = (
    "y = np.array([0.1, 0.0])\nfor i in range(9):\n    y = y + dt*rate(t, y, *p)\n"
    "print(np.sort(y))\n",
    "sol = solve_ivp(rate, (0, 1), [0.1, 0], args=p)\nthe = sol.y[0, -1]\n"
    "we = sol.y[1, -1]\nsolve_ivp(rate, (1, 2), (the, we), args=p)\n",
    "for l in np.linspace(0.5, 1, 5):\n    solve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = 2**0.5\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = 1e-3*500\nm = 4/3*np.pi*0.1**3\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "g = scipy.constants.g\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "ap = argparse.ArgumentParser()\nap.add_argument('--l', type=float, default=0.5)\n"
    "a = ap.parse_args()\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, a.l, g, u))\n",
    "l = float(os.environ.get('L', '1.0'))\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = np.float32(0.5)\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "m, l, g, u = map(float, ('1', '0.5', '9.81', '0'))\n"
    "solve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "l = sympy.Rational(1, 2)\nprint(accel(th, w, m, float(l), g, u))\n",
    "l = Fraction(1, 2)\nprint(accel(th, w, m, l, g, u))\n",
    "l = st.slider('l', 0.1, 2.0, 1.0)\nsolve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u))\n",
    "y0 = np.array([1, 0])\ny = y0.astype(float)\nfor i in range(9):\n    y += dt*rate(t, y, *p)\n",
    "l = jnp.array(0.5)\nprint(accel(th, w, m, l, g, u))\n",
    "l = torch.tensor(0.5)\nprint(accel(th, w, m, l, g, u))\n",
)

OBJECT = """class Rod:
    def __init__(self, m, l, g, u):
        self.p = {}
    def rhs(self, t, y):
        return rate(t, y, *self.p)
    def run(self):
        return solve_ivp(rate, (0, 1), [0.1, 0], args=self.p)
"""
OUTSIDE = """class Rod:
    def __init__(self, m, l, g, u):
        self.p = {}
rod = Rod(m, l, g, u)
solve_ivp(rate, (0, 1), [0.1, 0], args=rod.p)
"""
SPREAD = """class Rod:
    def __init__(self, m, l, g, u):
        self.p = {}
    def rhs(self, t, y):
        return rate(t, y, *self.p)
"""
CLOSURE = """def law(m, l, g, u):
    numbers = {}
    def f(t, y):
        return rate(t, y, *numbers)
    return f
solve_ivp(law(m, l, g, u), (0, 1), [0.1, 0])
"""
MADE_OTHERS = ("(l, m, g, u)", "(m, l, -g, u)", "[m, 2*l, g, u]", "np.array([m, l, u, g])",
               "tuple([m, l, g, -u])")  # fmt: skip
MADE_SAME = ("(m, l, g, u)", "[m, l, 9.81, u]", "np.array([m, l, g, 0.0])", "tuple([m, l, g, u])",
             "(1.0, 0.5, g, u)")  # fmt: skip


@pytest.mark.parametrize("file", [OBJECT, OUTSIDE, SPREAD, CLOSURE])
def test_parameters_that_an_object_or_closure_holds_have_their_order(file: str) -> None:
    assert [made for made in MADE_OTHERS if not _quoted(file.format(made))] == []
    assert [made for made in MADE_SAME if _quoted(file.format(made))] == []


def _quoted(text: str) -> tuple[str, ...]:
    return lines_around(HEAD + text, {"rate"}, NAMING)


@pytest.mark.sample(40)
@pytest.mark.parametrize(
    "text",
    [
        *WRONG_STARTS,
        *WRONG_ROUNDED,
        *WRONG_NUMBERS,
        *WRONG_VIEWS,
        *WRONG_TOLD,
        *WRONG_RECORDS,
        *WRONG_OTHERS,
        *WRONG_ATTACKS,
    ],
)
def test_what_may_be_another_motion_is_quoted(text: str) -> None:
    assert _quoted(text)


@pytest.mark.sample(40)
@pytest.mark.parametrize(
    "text",
    [
        *RIGHT_STARTS,
        *RIGHT_ROUNDED,
        *RIGHT_NUMBERS,
        *RIGHT_VIEWS,
        *RIGHT_TOLD,
        *RIGHT_USES,
        *RIGHT_OTHERS,
        *RIGHT_ATTACKS,
    ],
)
def test_what_leaves_the_motion_is_silent(text: str) -> None:
    assert _quoted(text) == ()


KINDS = """import math
import numpy as np
def rate(t, y, m, l, g, u):
    {}
    return [y[1], 3*g/(2*l)*math.sin(y[0]) + 3*u/(m*l**2)]
"""


@pytest.mark.parametrize(
    ("line", "right"),
    [
        ("if isinstance(y, list): return [y[1], 0.0]", False),
        ("if type(y) is tuple: return [y[1], 0.0]", False),
        ("if not hasattr(y, 'shape'): return [y[1], 0.0]", False),
        ("if isinstance(y, list): y = np.array(y)", True),
        ("if not isinstance(y, np.ndarray): raise TypeError", True),
    ],
)
def test_what_a_list_makes_otherwise_than_an_array_is_never_proved(
    tmp_path: Path, line: str, right: bool
) -> None:
    path = tmp_path / "a.py"
    path.write_text(KINDS.format(line))
    shown = CliRunner().invoke(app, ["check", "rod_pendulum", f"{path}:rate"])
    assert ("2 PROVED" in shown.output) is right


def test_an_import_that_a_judged_function_tries_is_quoted() -> None:
    tried = "def rate(t, y, l, g):\n    try:\n        import sympy\n    except ImportError:\n"
    assert _quoted(f"{tried}        return 0\n    return [y[1], g/l*np.sin(y[0])]\n")


CART = """import numpy as np
def rate(t, y):
    x, th, v, w = y
    return np.array([v, w, 1.0, 2.0])
y = np.array([0.1, 0.0, 0.0, 0.0])
def f(t, y):
    return rate(t, {})
solve_ivp(f, (0, 1), y)
"""


@pytest.mark.parametrize(
    ("state", "quoted"),
    [
        ("[y[0], y[1] % (2*np.pi), y[2], y[3]]", False),
        ("[y[0] % (2*np.pi), y[1], y[2], y[3]]", True),
        ("[y[0], y[1], y[2] % (2*np.pi), y[3]]", True),
    ],
)
def test_only_an_angle_is_the_same_a_turn_later(state: str, quoted: bool) -> None:
    match = Match("y", "x theta x_dot theta_dot", "the usual name of such a vector")
    naming = Naming(Vocabulary(cartpole.scene()), {}, (match,))
    assert bool(lines_around(CART.format(state), {"rate"}, naming)) is quoted

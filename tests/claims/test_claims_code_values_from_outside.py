"""Values that a Python file draws or reads, defaults, lists of states, solvers and records."""

import pytest

from mechanics.claims.code.around.python_lines import lines_around
from mechanics.claims.names import Match, Naming, Vocabulary
from systems import rod_pendulum

NAMING = Naming(
    Vocabulary(rod_pendulum.scene()),
    {},
    (
        Match("y", "theta theta_dot", "the usual name of such a vector"),
        Match("th", "theta", "nothing else is left"),
        Match("w", "theta_dot", "nothing else is left"),
    ),
)
HEAD = """import random, sys
from collections import namedtuple
import numpy as np
import pandas as pd
from scipy.integrate import solve_ivp, Radau
from scipy.optimize import least_squares
g, l, m, u = 9.81, 1.0, 1.0, 0.0
def accel(th, w, m, l, g, u):
    return 3*g/(2*l)*np.sin(th) + 3*u/(m*l**2)
def rate(t, y, m, l, g, u):
    th, w = y
    return np.array([w, accel(th, w, m, l, g, u)])
t, dt = 0.0, 0.01
p = (m, l, g, u)
rng = np.random.default_rng(0)
y = np.array([0.1, 0.0])
S = namedtuple("S", "th w")
df = pd.read_csv("rods.csv")
"""
SOLVE = "sol = solve_ivp(rate, (0, 1), [0.1, 0], args=(m, l, g, u){})\n"
CALL = SOLVE.format("")
FIT = """def residual(x):
    m_, l_ = x
    sol = solve_ivp(rate, (0, 1), [0.1, 0], args=({}, g, u))
    return sol.y[0] - data
fit = least_squares(residual, [1.0, 1.0])
"""
DRAWN_LAW = "def f(t, y):\n    l = rng.uniform(0.5, 1)\n    return rate(t, y, m, l, g, u)\n"
QUOTED = (
    "l = -rng.uniform(0.1, 1)\n" + CALL,
    "l = rng.uniform(-1, -0.1)\n" + CALL,
    "l = -float(input())\n" + CALL,
    "f = lambda t, y: rate(t, y, m, rng.uniform(0.5, 1), g, u)\nsolve_ivp(f, (0, 1), [0.1, 0])\n",
    DRAWN_LAW + "solve_ivp(f, (0, 1), [0.1, 0])\n",
    "for i in range(9):\n    y = y + dt*rate(t, y, m, rng.uniform(0.5, 1), g, u)\n",
    "for i in range(9):\n    y = y + dt*rate(t, y, *p)\n    y[1] += rng.normal(0, 1)\n",
    "l = df['m'].iloc[0]\n" + CALL,
    "solve_ivp(rate, (0, 1), y, args=(df['l'][0], df['m'][0], g, u))\n",
    "m = y[1]\nsolve_ivp(rate, (0, 1), y, args=(m, l, g, u))\n",
    "def f(t, s):\n    m = s[1]\n    return [s[1], accel(s[0], s[1], m, l, g, u)]\n"
    "solve_ivp(f, (0, 1), [0.1, 0])\n",
    FIT.format("l_, m_"),
    "def simulate(f, y, l=-0.5):\n    return solve_ivp(f, (0, 1), y, args=(m, l, g, u))\n"
    "simulate(rate, [0.1, 0])\n",
    "def simulate(y, *, l=0):\n    return rate(0, y, m, l, g, u)\n",
    "def simulate(y, q={'l': -1}):\n    return rate(0, y, m, q['l'], g, u)\n",
    "z = [y]\nfor i in range(9):\n    y += dt*rate(t, y, *p)\n    z[0][1] = 0\n",
    "z = {'a': y}\nfor i in range(9):\n    y += dt*rate(t, y, *p)\n    z['a'][1] = 0\n",
    "for i in range(9):\n    y = y + dt*rate(t, y, *p)\n    y[i % 2] += 1\n",
    SOLVE.format(", method=Mine"),
    "class Mine(Radau):\n    pass\n" + SOLVE.format(", method=Mine"),
    "class Radau(OdeSolver):\n    pass\n" + SOLVE.format(", method=Radau"),
    "from mine import Mine\nfor kind in ('RK45', Mine):\n    "
    + SOLVE.format(", method=kind"),
    "for w, th in [S(0.1, 0.0), S(0.2, 0.0)]:\n    print(accel(th, w, m, l, g, u))\n",
    "a = [accel(th, w, m, l, g, u) for w, th in [S(0.1, 0.0), S(0.2, 0.0)]]\n",
)  # fmt: skip
SILENT = (
    "l = rng.uniform(0.1, 1)\n" + CALL,
    "l = 1.0 + 0.1*rng.standard_normal()\n" + CALL,
    "for k in range(5):\n    l = rng.uniform(0.1, 1)\n    " + CALL,
    "l = float(input('l? '))\n" + CALL,
    "l = float(sys.argv[1])\n" + CALL,
    "l = float(df['l'].iloc[0])\n" + CALL,
    "l = df['l'][0]\n" + CALL,
    "a = accel(rng.uniform(-1, 1), rng.uniform(-1, 1), m, rng.uniform(0.1, 1), g, u)\n",
    FIT.format("m_, l_") + "m_, l_ = fit.x\nprint(m_, l_)\n",
    "def simulate(f, y, l=0.5, T=-1.0, u=-1.0):\n"
    "    return solve_ivp(f, (0, T), y, args=(m, l, g, u))\nsimulate(rate, [0.1, 0])\n",
    "def simulate(th=-0.1, q={'w': -0.2}):\n"
    "    return solve_ivp(rate, (0, 1), [th, q['w']], args=p)\n",
    "def line(m=-1, l=0):\n    return m*3 + l\n",
    "z = [y.copy()]\nfor i in range(9):\n    y = y + dt*rate(t, y, *p)\n    z.append(y)\n"
    "z = np.array(z)\nz[0] *= 57\n",
    "counts = [0, 0, 0]\nfor i in range(9):\n    y = y + dt*rate(t, y, *p)\n"
    "    counts[i % 3] += 1\n",
    SOLVE.format(", method='LSODA'"),
    SOLVE.format(", method=Radau"),
    "for kind in ('RK45', Radau):\n    " + SOLVE.format(", method=kind"),
    "def simulate(method='RK45'):\n    return solve_ivp(rate, (0, 1), y, args=p, method=method)\n"
    "simulate('BDF')\n",
    "for th, w in [S(0.1, 0.0), S(0.2, 0.0)]:\n    print(accel(th, w, m, l, g, u))\n",
    "s = S(0.1, 0.0)\nfor i in range(9):\n    th, w = s\n    a = accel(th, w, m, l, g, u)\n"
    "    s = S(th + dt*w, w + dt*a)\n",
)


@pytest.mark.sample(20)
@pytest.mark.parametrize("text", QUOTED)
def test_what_may_make_the_motion_another_is_quoted(text: str) -> None:
    assert lines_around(HEAD + text, {"rate"}, NAMING)


@pytest.mark.sample(20)
@pytest.mark.parametrize("text", SILENT)
def test_what_the_scene_can_have_says_nothing(text: str) -> None:
    assert lines_around(HEAD + text, {"rate"}, NAMING) == ()

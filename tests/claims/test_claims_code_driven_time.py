"""Loops around a judged function of a driven system: its time goes on by the step."""

from pathlib import Path

import pytest
from sympy import cos
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

import mechanics
from mechanics.cli.load import run_file
from mechanics.judge.sources import Around
from mechanics.kernel import Verdict
from mechanics.scene import Particle, Scene, force, parameters

MATLAB = """m = 1; k = 2; F = 3; h = 0.01; t = 0; y = [0.1; 0];
for i = 1:1000
  y = y + h*rate({}, y, m, k, F);
  {}
end
function dydt = rate(t, y, m, k, F)
dydt = [y(2); (F*cos(3*t) - k*y(1))/m];
end
"""
JULIA = """function rate(y, p, t)
    m, k, F = p
    return [y[2], (F*cos(3t) - k*y[1])/m]
end
function main()
    p = (1.0, 2.0, 3.0); h = 0.01; t = 0.0; y = [0.1, 0.0]
    for i in 1:1000
        y = y + h*rate(y, p, {})
        {}
    end
    return y
end
"""
C = """#include <math.h>
#include <stdio.h>
void rate(double t, const double y[2], double dy[2], double m, double k, double F)
{{ dy[0] = y[1]; dy[1] = (F*cos(3*t) - k*y[0])/m; }}
int main(void) {{
  double y[2] = {{0.1, 0.0}}, dy[2], t = 0.0, h = 0.01;
  for (int i = 0; i < 1000; i++) {{
    rate({}, y, dy, 1.0, 2.0, 3.0);
    y[0] += h*dy[0]; y[1] += h*dy[1];
    {}
  }}
  printf("%g\\n", y[0]);
  return 0;
}}
"""
PYTHON = """import numpy as np
m, k, F, h, t, y = 1.0, 2.0, 3.0, 0.01, 0.0, np.array([0.1, 0.0])
def rate(t, y):
    return np.array([y[1], (F*np.cos(3*t) - k*y[0])/m])
def step(y, t, h):
    return y + h*rate(t, y)
for i in range(1000):
    y = y + h*rate({}, y)
    {}
"""
PAGES = {".m": MATLAB, ".jl": JULIA, ".c": C, ".cpp": C, ".py": PYTHON}
RIGHT = (("t", "t = t + h;"), ("i*h", ""))
WRONG = (("t", "t = {}(t + h, 0.01);"), ("t", ""), ("0.0", ""), ("t", "t = t - h;"))
REMAINDERS = {".m": "mod", ".jl": "mod", ".c": "fmod", ".cpp": "fmod", ".py": "np.mod"}
GRIDS = (
    "for t in np.arange(0, 1, h):\n    y = y + h*rate(t, y)\n",
    "for j, t in enumerate(np.arange(0, 1, h)):\n    y = y + h*rate(t, y)\n",
    "ts = np.linspace(0, 1, 101)\nfor j in range(100):\n    y = y + h*rate(ts[j], y)\n",
    "for j in range(9):\n    y = step(y, j*h, h)\n",
)


@pytest.fixture(scope="module")
def pushed() -> Scene:
    """A mass on a spring, pushed by F cos(3 t)."""
    x, t = dynamicsymbols("x"), dynamicsymbols._t
    m, k, F = parameters("m k F", units="kg N/m N", typical="2 3 5")
    ground, origin = ReferenceFrame("N"), Point("O")
    place = origin.locatenew("P", x * ground.x)
    push = force("push", place, (F * cos(3 * t) - k * x) * ground.x, on="mass")
    return Scene("pushed", ground, origin, (x,), (Particle("mass", place, m),), (push,))


def beside(scene: Scene, folder: Path, suffix: str, text: str) -> tuple[str, ...]:
    path = folder / f"page{suffix}"
    path.write_text(text)
    if suffix == ".py":
        things = [run_file(path).rate, Around(text, {"rate"})]
        found = mechanics.check(scene, things, blame=False)
    else:
        found = mechanics.check(scene, path, function="rate", blame=False)
    assert found.verdict in (Verdict.PROVED, Verdict.CERTIFIED)
    return found.beside


@pytest.mark.parametrize("suffix", PAGES)
@pytest.mark.parametrize(("time", "line"), RIGHT)
def test_a_time_that_goes_on_says_nothing(
    pushed: Scene, tmp_path: Path, suffix: str, time: str, line: str
) -> None:
    assert not beside(pushed, tmp_path, suffix, PAGES[suffix].format(time, line))


@pytest.mark.parametrize("suffix", PAGES)
@pytest.mark.parametrize(("time", "line"), WRONG)
def test_a_time_that_does_not_is_quoted(
    pushed: Scene, tmp_path: Path, suffix: str, time: str, line: str
) -> None:
    text = PAGES[suffix].format(time, line.format(REMAINDERS[suffix]))
    assert beside(pushed, tmp_path, suffix, text)


@pytest.mark.parametrize("loop", GRIDS)
def test_times_of_a_grid_are_no_constant(pushed: Scene, tmp_path: Path, loop: str) -> None:
    text = PYTHON.partition("for i")[0] + loop
    assert not beside(pushed, tmp_path, ".py", text)


def test_one_time_for_all_steps_of_a_function_is_quoted(pushed: Scene, tmp_path: Path) -> None:
    text = PYTHON.partition("for i")[0] + GRIDS[-1].replace("j*h", "0.0")
    assert beside(pushed, tmp_path, ".py", text)

"""Each function of a submission is judged, or is part of what is, or is named."""

from pathlib import Path

import pytest

from mechanics.claims.code.around.python_lines import lines_around
from mechanics.claims.names import Naming, Vocabulary
from mechanics.grading.submission import things_in
from mechanics.judge.sources import Around, NotRead
from systems import rod_pendulum

RATE = """import numpy as np
def rate(t, y, m, l, g, u):
    return np.array([y[1], 3*g/(2*l)*np.sin(y[0]) + 3*u/(m*l**2)])
"""
NAMED = (
    "class Sim:\n    def rate(self, t, y): return -rate(t, y, 1, 1, 9.81, 0)\nsim = Sim()",
    "class Sim:\n    def step(self, y, dt):\n        return y + dt*rate(0, y, 1, 1, -9.81, 0)",
    "class Rod:\n    def theta_ddot(self, x, g, l): return g/l*np.sin(x)",
    "async def other(t, y): return -rate(t, y, 1, 1, 9.81, 0)",
    "def other(t, y):\n    yield -rate(t, y, 1, 1, 9.81, 0)",
    "table = {'acc': lambda x: 9.81*np.sin(x)}",
    "answer = np.vectorize(lambda x: 9.81*np.sin(x))",
    "if __name__ == '__main__':\n    def answer(t, y): return -rate(t, y, 1, 1, 9.81, 0)",
    "def main():\n    y = np.array([1.0, 0.0])\n"
    "    y = y - 0.01*rate(0, y, 1, 1, 9.81, 0)\n    print(y)",
)
NOTHING = (
    "def main():\n    y = solve_ivp(lambda t, y: rate(t, y, 1, 1, 9.81, 0), (0, 1), [1, 0])\n"
    "    plt.plot(y.t, y.y[0])\n\nif __name__ == '__main__':\n    main()",
    "def plot(solution):\n    print(180/np.pi*solution.y[0])",
    "best = min([(1, 2)], key=lambda pair: pair[1])",
)


def _named(folder: Path, text: str) -> list[str]:
    path = folder / "a.py"
    path.write_text(f"{RATE}\n{text}\n")
    things = things_in(path, run_python=True)
    naming = Naming(Vocabulary(rod_pendulum.scene()))
    around = [one for one in things if isinstance(one, Around)]
    lines = [text for one in around for text in lines_around(one.code, one.judged, naming)]
    return [*lines, *(one.part for one in things if isinstance(one, NotRead))]


@pytest.mark.sample(4)
@pytest.mark.parametrize("text", NAMED)
def test_what_is_neither_judged_nor_called_is_named(tmp_path: Path, text: str) -> None:
    assert _named(tmp_path, text)


@pytest.mark.parametrize("text", NOTHING)
def test_what_passes_a_function_on_and_shows_the_result_claims_nothing(
    tmp_path: Path, text: str
) -> None:
    assert _named(tmp_path, text) == []

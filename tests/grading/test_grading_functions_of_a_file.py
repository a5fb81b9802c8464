"""Which function of a Python file is judged, and what is not installed where it is run."""

from pathlib import Path

import pytest

from mechanics.errors import InputError
from mechanics.grading.submission import things_in

SOLVED = """
import numpy as np
from scipy.integrate import solve_ivp

class Pendulum:
    def __init__(self, L=1.0, g=9.81):
        self.L, self.g = L, g

    def __call__(self, t, y):
        return (y[1], -self.g / self.L * np.sin(y[0]))

    def solve(self, y0):
        return solve_ivp(self, (0, 1), y0)

    def energy(self, y):
        return self.L * y[1] ** 2
"""


def name_in(tmp_path: Path, code: str, function: str | None = None) -> str:
    path = tmp_path / "file.py"
    path.write_text(code)
    found, *_ = things_in(path, function=function, run_python=True)
    return found.__name__


def test_what_is_solved_is_judged_and_a_truth_is_not(tmp_path: Path) -> None:
    assert name_in(tmp_path, SOLVED) == "__call__"
    assert name_in(tmp_path, SOLVED, "energy") == "energy"
    more = "def step(x):\n    return 2 * x\n\ndef is_safe(x):\n    return abs(x) < 1 and x > 0\n"
    assert name_in(tmp_path, more) == "step"
    assert name_in(tmp_path, f"{SOLVED}\ndef main():\n    print(Pendulum())\n") == "__call__"


def test_two_classes_with_one_method_are_told_apart(tmp_path: Path) -> None:
    damped = (
        "\nclass Damped(Pendulum):\n    def __call__(self, t, y):\n        return (y[1], -y[0])\n"
    )
    with pytest.raises(InputError, match="a method of Pendulum and of Damped"):
        name_in(tmp_path, SOLVED + damped)


def test_modules_that_are_not_installed_have_no_value(tmp_path: Path) -> None:
    code = (
        "import not_installed.numpy as nn\nfrom .base import Env\nfrom not_there import jit, M\n"
        "class Pole(Env):\n    @jit(fast=True)\n    def rate(self, x):\n        return 2 * x\n"
    )
    path = tmp_path / "file.py"
    path.write_text(code)
    found, *_ = things_in(path, run_python=True)
    assert found(3) == 6
    for formula in ("2 * nn.pi", "x if M > 2 else 0", "x * M", "[x][M]", "x + nn.sin(x)"):
        path.write_text(code.replace("2 * x", formula))
        found, *_ = things_in(path, run_python=True)
        with pytest.raises((InputError, TypeError)):
            found(3)


@pytest.mark.parametrize("before", ["", "import jax\n"])
def test_a_module_with_the_functions_of_another_one_is_that(tmp_path: Path, before: str) -> None:
    path = tmp_path / "file.py"
    path.write_text(f"{before}import jax.numpy as jnp\ndef f(x):\n    return jnp.array([2 * x])\n")
    (found,) = things_in(path, run_python=True)
    assert list(found(3)) == [6]


def test_code_on_a_page_is_judged_beside_its_words(tmp_path: Path) -> None:
    path = tmp_path / "page.md"
    path.write_text(f"# A pendulum\n\n$x = 3$\n\n```python\n{SOLVED}```\n\n```bash\nls\n```\n")
    prose, function, *others, _, words = things_in(path, run_python=True)
    assert "x = 3" in prose and "solve_ivp" not in prose
    assert "A pendulum" in words.words and "solve_ivp" not in words.words
    assert function.__name__ == "__call__"
    assert [other.name for other in others] == ["solve", "energy"]
    whole, left = things_in(path)
    assert (whole, left.part) == (path, "block 1 of code")

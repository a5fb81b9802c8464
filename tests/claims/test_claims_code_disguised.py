"""Code that tells a traced number from a float, at states that nobody tries; and files that do."""

import math
from pathlib import Path

import pytest

from mechanics import check
from mechanics.errors import InputError
from mechanics.grading.submission import things_in
from mechanics.kernel import Verdict
from systems.rod_pendulum import scene

SCENE = scene()
FILE = """
from math import sin
import math, os, random, sys
import numpy as np
{before}
def theta_ddot(theta, theta_dot, u, m, l, g):
    {line}
    return {factor}*(3*g/(2*l)*math.sin(theta) + 3*u/(m*l**2))
"""


def verdict(folder: Path, before: str = "", line: str = "pass", factor: str = "1") -> Verdict:
    path = folder / "code.py"
    path.write_text(FILE.format(before=before, line=line, factor=factor), encoding="utf-8")
    return check(SCENE, things_in(path, run_python=True), blame=False).verdict


@pytest.mark.sample(4)
@pytest.mark.parametrize(
    "condition",
    [
        "type(theta) is not float", "isinstance(theta, int)", "isinstance(theta, np.floating)",
        "hasattr(theta, 'dtype')", "getattr(theta, 'hex', None)", "theta.__class__ is not float",
        "not hasattr(theta, 'sin')", "theta.expr", "vars(theta)", "np.array([theta]).dtype == 'O'",
    ],
)  # fmt: skip
def test_nothing_tells_a_traced_number_from_a_float(tmp_path: Path, condition: str) -> None:
    factor = f"(2 if ({condition}) and theta > 1e6 else 1)"
    try:
        assert verdict(tmp_path, factor=factor) is not Verdict.PROVED
    except InputError as error:
        assert "class" in str(error) or "depends on" in str(error)


@pytest.mark.parametrize(
    ("before", "factor"),
    [
        ("K = 1 if os.environ.get('K') is None else 2", "K"),
        ("K = 1 if 'mechanics' in sys.modules else 2", "K"),
        (
            "if 'mechanics' in sys.modules:\n    def k(): return 1\nelse:\n    def k(): return 2",
            "k()",
        ),
        ("def make():\n    return random.random() > 0\nK = make()", "K"),
        ("K = 1 if __name__ == 'submission' else 2", "K"),
        ("own = math.sin\nmath.sin = lambda x: own(x) if x < 1e6 else 0", "1"),
    ],
)
def test_a_file_that_is_another_one_elsewhere_is_refused(
    tmp_path: Path, before: str, factor: str
) -> None:
    with pytest.raises(InputError, match=r"depends on where|which is not its own"):
        verdict(tmp_path, before, factor=factor)
    assert math.sin(0.0) == 0.0


def test_methods_of_what_a_function_holds_are_followed_and_what_they_keep_is_seen(
    tmp_path: Path,
) -> None:
    one = "class K(float):\n    def __rmul__(self, x): return 2*x if x > 1e6 else x\nk = K(1)"
    with pytest.raises(InputError, match="__rmul__ is not followed"):
        verdict(tmp_path, one, factor="1*sin(0*theta + 1)*k")
    kept = "class K:\n    def __getattr__(self, name):\n        K.n = {}\n        return 1\nk = K()"
    assert verdict(tmp_path, kept, factor="k.one") is Verdict.UNDECIDED
    right = "class K:\n    def of(self, x): return math.cos(x)**2 + math.sin(x)**2\nk = K()"
    assert verdict(tmp_path, right, factor="k.of(theta)") is Verdict.PROVED
    made = right.replace("k = K()", "")
    assert verdict(tmp_path, made, factor="K().of(theta)") is Verdict.PROVED

"""A name that is guessed by its unit, where a comment of the file says what it is."""

from pathlib import Path

import pytest

from mechanics import check
from mechanics.judge.sources import Around
from tests.notation_scenes import truth

CODE = """from sympy import Eq, Symbol, sin
from sympy.physics.mechanics import dynamicsymbols
theta, g, a = dynamicsymbols("theta"), Symbol("g"), Symbol("a")  # {}
def equation(): return Eq(theta.diff(dynamicsymbols._t, 2), -g/a*sin(theta))
"""


@pytest.mark.parametrize(
    ("comment", "verdict"),
    [
        ("a = 2*l, twice the length", "UNDECIDED"),
        ("a is 2 l", "UNDECIDED"),
        ("a is the length of the rod", "PROVED"),
        ("symbols of the text", "PROVED"),
    ],
)
def test_a_comment_that_says_what_a_name_is(comment: str, verdict: str, tmp_path: Path) -> None:
    code = CODE.format(comment)
    names: dict[str, object] = {}
    exec(code, names)
    found = check(truth("pendulum"), [names["equation"], Around(code, frozenset(("equation",)))])
    assert found.verdict.name == verdict

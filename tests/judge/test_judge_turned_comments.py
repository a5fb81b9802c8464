"""A comment that makes a name another value of itself is quoted, wherever the file says it."""

import pytest

import mechanics
from systems import rod_pendulum

SCENE = rod_pendulum.scene()
JULIA = "function pend(theta, u, m, l, g)\n  return 3g/(2l)*sin(theta) + 3u/(m*l^2)\nend\n"


def quoted(tmp_path, comment: str) -> int:
    file = tmp_path / "mine.jl"
    file.write_text(f"{comment}\n{JULIA}")
    return len(mechanics.check(SCENE, file, blame=False).unjudged)


@pytest.mark.parametrize("said", ["theta = pi - theta", "l = l/2", "u = -u"])
@pytest.mark.parametrize("marks", ["# {}", "#=\n{}\n=#", '"""\n{}\n"""'])
def test_a_name_that_is_turned_is_quoted(tmp_path, marks, said):
    assert quoted(tmp_path, marks.format(said)) == 1


@pytest.mark.parametrize("said", ["l == l", "l = 0.5", "theta_ddot = 3g/(2l)*sin(theta)"])
def test_other_formulas_of_comments_are_not(tmp_path, said):
    assert quoted(tmp_path, f"# {said}") == 0

"""A wrong branch of code is named with its condition, and what is wrong in it is told."""

import numpy as np
import pytest
from rod_statements import ROD

import mechanics
from mechanics.report.answer.judged import Judged

RIGHT = "3*g/(2*l)*sin(theta) + 3*u/(m*l*l)"
WRONG = "3*g/(2*l)*sin(theta) - 3*u/(m*l*l)"
CODE = """
#include <math.h>
double theta_ddot(double theta, double theta_dot, double u, double m, double l, double g)
{
    BODY
}
"""


def judged(body: str) -> Judged:
    body = body.replace("RIGHT", RIGHT).replace("WRONG", WRONG)
    (entry,) = mechanics.check(ROD, CODE.replace("BODY", body), notation="c").judged
    return entry


@pytest.mark.parametrize(
    ("body", "branch"),
    [
        ("if (u > 3) return RIGHT; else return WRONG;", "where u <= 3; right where u > 3"),
        ("return u > 3 ? WRONG : RIGHT;", "where u > 3; right where u <= 3"),
    ],
)
def test_the_wrong_branch_of_c_is_named_and_mended(body: str, branch: str) -> None:
    entry = judged(body)
    assert entry.blame.searched == f"this is the branch {branch}"
    (edit,) = entry.blame.repairs[0].edits
    assert edit.written == "-3*u/(m*l*l)"
    state = dict(entry.finding.witness.state)
    assert (float(eval(state["u"])) > 3) == branch.startswith("where u > 3")


def test_of_two_wrong_branches_both_are_named() -> None:
    entry = judged("return u > 3 ? WRONG : u > 1 ? RIGHT : 2*(WRONG);")
    assert "wrong, too, where" in entry.blame.searched
    assert "right where u <= 3 and u > 1" in entry.blame.searched


def test_the_wrong_branch_of_python_is_named() -> None:
    def theta_ddot(theta, theta_dot, u, m, l, g):
        if theta > 0:
            return 3 * g / (2 * l) * np.cos(theta) + 3 * u / (m * l * l)
        return 3 * g / (2 * l) * np.sin(theta) + 3 * u / (m * l * l)

    (entry,) = mechanics.check(ROD, theta_ddot).judged
    assert entry.blame.searched.startswith("this is the branch where theta > 0; right where")
    assert entry.blame.repairs[0].edits[0].right == "sin(theta)"

"""Blame beside what is declared: values of parameters, conventions, one branch."""

import pytest

from mechanics import check
from mechanics.kernel import Verdict
from mechanics.report.answer.check import Check
from systems import elastic_pendulum, rod_pendulum

PIVOT = elastic_pendulum.scene()
SEVEN = "M*L/2*x''*cos(theta) + M*L**2/3*theta'' + M*g*L/2*sin(theta) = 0"
TURNED = "-M*L/2*x''*cos(theta) + M*L**2/3*theta'' - M*g*L/2*sin(theta) = 0"
ROD = "theta'' = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2)"


def edits(found: Check) -> list[tuple[str, str]]:
    (entry,) = found.judged
    assert entry.finding.verdict is Verdict.REFUTED
    assert entry.blame is not None
    repair = entry.blame.repairs[0]
    assert repair.finding.shown
    return [(edit.written, edit.right) for edit in repair.edits]


DECLARED = [
    ({}, SEVEN),
    ({"values": {"g": "9.81"}}, SEVEN.replace("g", "9.81")),
    ({"values": {"g": "9.81"}}, SEVEN),
    ({"where": "cos(theta) > 0"}, SEVEN),
    ({"convention": "other vertical"}, TURNED),
    ({"convention": "half-length of L"},
     "M*L*x''*cos(theta) + 4*M*L**2/3*theta'' + M*g*L*sin(theta) = 0"),
    ({"convention": "other sign of angles"},
     SEVEN.replace("theta''", "(-theta'')").replace("sin(", "-sin(")),
]  # fmt: skip


@pytest.mark.sample(2)
@pytest.mark.parametrize(("declared", "right"), DECLARED)
@pytest.mark.parametrize(("one", "other"), [("/3*", "/12*"), ("cos(", "sin("), ("x''", "2*x''")])
def test_one_mistake_is_found_beside_what_is_declared(
    declared: dict[str, object], right: str, one: str, other: str
) -> None:
    assert check(PIVOT, right, **declared).ok
    wrong = right.replace(one, other, 1)
    repaired = check(PIVOT, wrong, **declared).judged[0].blame.repairs[0].repaired
    assert check(PIVOT, repaired, **declared).ok
    assert len(edits(check(PIVOT, wrong, **declared))) == 1


def test_the_edit_is_in_the_numbers_that_are_written() -> None:
    found = check(rod_pendulum.scene(), "theta'' = 15*sin(theta) + 2*u",
                  values={"g": 10, "l": 1, "m": 1})  # fmt: skip
    assert edits(found) == [("2", "3")]


def test_a_convention_that_is_left_open_is_not_searched() -> None:
    found = check(
        rod_pendulum.scene(), ROD.replace("sin", "2*cos"), convention="from the horizontal"
    )
    (entry,) = found.judged
    assert entry.finding.verdict is Verdict.REFUTED
    assert "several conventions are possible" in entry.blame.searched

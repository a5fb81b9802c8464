"""Statements that hold but say nothing, or hold of other motions too, are not shown."""

import pytest

import mechanics
from mechanics.kernel import Verdict
from systems import elastic_pendulum, rod_pendulum

ROD = rod_pendulum.scene()
RIGHT = "(theta'' - 3*g/(2*l)*sin(theta) - 3*u/(m*l^2))"
FIRST = "((M + m)*x'' + 2*k*x + M*L/2*(theta''*cos(theta) - theta'^2*sin(theta)))"
SECOND = "(M*L^2/3*theta'' + M*L/2*x''*cos(theta) + M*g*L/2*sin(theta))"


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "text",
    [
        "0 = 0", "m = m", "sin(theta)^2 + cos(theta)^2 = 1", "theta''*0 = 0", "theta'' = theta''",
        f"{RIGHT}/{RIGHT} = 1", f"{RIGHT}*(theta'' - g) = 0", f"{RIGHT}*theta'' = 0",
        f"{RIGHT}*(theta'' - 5*theta'^2) = 0", f"sin({RIGHT}) = 0", f"{RIGHT}^2 = 0",
        "theta''' = 3*g/(2*l)*cos(theta)*theta'",
    ],
)  # fmt: skip
def test_what_says_nothing_about_the_motion_is_undecided(text: str) -> None:
    assert mechanics.check(ROD, text, notation="text").verdict is Verdict.UNDECIDED


@pytest.mark.parametrize("text", [f"{RIGHT}*m = 0", f"{RIGHT}/l = 0", f"(1 + theta^2)*{RIGHT} = 0"])
def test_rows_may_be_scaled(text: str) -> None:
    assert mechanics.check(ROD, text).ok


@pytest.mark.parametrize(
    ("text", "convention"), [(f"{SECOND} = 0", "other vertical"), (f"{FIRST} = 0", "half-length")]
)
def test_a_declared_convention_counts_where_it_makes_equations_wrong(
    text: str, convention: str
) -> None:
    scene = elastic_pendulum.scene()
    assert mechanics.check(scene, text).ok
    found = mechanics.check(scene, text, convention=convention)
    assert found.verdict is Verdict.REFUTED
    assert any("not all statements are right under it" in remark for remark in found.remarks)


def test_a_convention_that_the_scene_cannot_have_is_no_proof() -> None:
    found = mechanics.check(ROD, f"{RIGHT} = 0", convention="relative angles")
    assert found.verdict is Verdict.UNDECIDED


def test_equations_that_say_the_same_twice_are_told() -> None:
    scene = elastic_pendulum.scene()
    twice = f"{FIRST} + {SECOND} = 0\n2*{FIRST} + 2*{SECOND} = 0"
    found = mechanics.check(scene, twice)
    assert any("1 of these 2" in remark for remark in found.remarks)
    both = mechanics.check(scene, f"{FIRST} + {SECOND} = 0\n{FIRST} - {SECOND} = 0")
    assert both.ok and not any("of these 2" in remark for remark in both.remarks)


def test_an_angle_by_a_greek_letter_is_no_length() -> None:
    found = mechanics.check(ROD, r"\ddot\theta = \alpha", notation="latex")
    assert found.verdict is Verdict.UNDECIDED


def test_the_smallest_place_for_a_sign_is_named_first() -> None:
    (judged,) = mechanics.check(ROD, "m*l^2*theta''/3 - m*g*l*sin(theta)/2 = -u").judged
    assert judged.blame is not None
    assert judged.blame.repairs[0].edits[0].written in ("-u", "-")


def test_a_mark_of_the_byte_order_is_no_part_of_a_text() -> None:
    text = f"\ufeff{RIGHT} = 0".encode()
    assert mechanics.check(ROD, text).ok


def test_an_energy_whose_name_the_scene_has_is_told() -> None:
    scene = elastic_pendulum.scene()
    text = "T = (M + m)*x'^2/2 + M*L/2*x'*theta'*cos(theta) + M*L^2*theta'^2/6"
    (judged,) = mechanics.check(scene, text).judged
    assert judged.finding.shown  # the scene's T is a force
    assert "T on the left is read as the kinetic energy" in judged.statement.notes
    assert mechanics.check(scene, text, about="kinetic energy").ok
    (wrong,) = mechanics.check(scene, text.replace("/6", "/7"), blame=False).judged
    assert wrong.verdict is Verdict.REFUTED

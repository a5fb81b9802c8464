"""What stands behind a slash: the reading that has one dimension, and it is told."""

import pytest

import mechanics
from mechanics.judge.check import derived
from systems import cartpole, elastic_pendulum, quadrotor, rod_pendulum

PIVOT = derived(elastic_pendulum.scene())
CART = derived(cartpole.scene())
ROD = derived(rod_pendulum.scene())
FLYER = derived(quadrotor.scene())


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (r"\ddot\theta + 3\ddot x\cos\theta/2L + 3 g\sin\theta/2L = 0", "/2L is /(2L)"),
        (r"\ddot\theta + 3/2L \ddot x\cos\theta + 3/2L g\sin\theta = 0", "/2L is /(2L)"),
        (r"\ddot\theta = -3(\ddot x\cos\theta + g\sin\theta)/ 2 L", "/2 L is /(2 L)"),
        (r"V = k x^2 - M g \cos\theta/2L^{-1}", "/2L^{-1} is /(2L^{-1})"),
        ("theta'' = -3*(x''*cos(theta) + g*sin(theta))*M^2/(M^2*2L)", ""),
        ("V = k*x^2 - M*g*L/2*cos(theta)", ""),
        ("I_C = M*L/12L", "/12L is /12 * L"),
    ],
)
def test_the_reading_of_one_dimension_is_taken(text: str, words: str) -> None:
    (entry,) = mechanics.check(PIVOT, text, blame=False).judged
    assert entry.finding.shown
    assert [n for n in entry.statement.notes if "as it is" in n] == (
        [f"{words}: as it is, dimensions do not agree"] if words else []
    )


def test_which_reading_was_taken_is_told() -> None:
    (entry,) = mechanics.check(PIVOT, "theta'' = -3/2L*(x''*cos(theta) + g*sin(theta))").judged
    assert "/2L is read as /(2L)" in entry.statement.notes
    assert entry.finding.verdict.name == "PROVED"
    text = r"ML/2\,\ddot x\cos\theta + 1/3 M L^2\ddot\theta + M g L/2 \sin\theta = 0"
    (entry,) = mechanics.check(PIVOT, text).judged
    assert "a / b c is read as (a / b) c" in entry.statement.notes
    assert entry.finding.verdict.name == "PROVED"


def test_no_reading_makes_a_wrong_equation_right() -> None:
    text = r"4 l \ddot\theta/3 + \ddot x\cos\theta = g\cos\theta/2l\cdot 2l"
    (entry,) = mechanics.check(CART, text, blame=False).judged
    assert entry.finding.verdict.name == "REFUTED"
    assert not entry.right_if
    (entry,) = mechanics.check(CART, text.replace(r"g\cos", r"g\sin"), blame=False).judged
    assert entry.finding.shown


OPEN = r"\ddot\theta = {}\frac{{3{}}}{{l}}\sin\theta\cos\theta/2\cos\theta + 3u/(m l^2)"


@pytest.mark.parametrize(
    ("sign", "gravity", "how"),
    [
        ("", "g", {}),
        ("-", "g", {"convention": "other vertical"}),
        ("", "g", {"where": "cos(theta) > 0"}),
        ("", r"\cdot 9.81", {"values": {"g": 9.81}}),
    ],
)
def test_what_dimensions_leave_open_is_read_otherwise_as_it_is_judged(
    sign: str, gravity: str, how: dict
) -> None:
    told = r"/2\cos\theta is /(2\cos\theta): write the brackets"
    (entry,) = mechanics.check(ROD, OPEN.format(sign, gravity), blame=False, **how).judged
    assert (entry.verdict.name, entry.right_if) == ("UNDECIDED", (told,))
    wrong = OPEN.format(sign, gravity).replace("3u", "4u")
    assert mechanics.check(ROD, wrong, blame=False, **how).verdict.name == "REFUTED"


def test_so_it_is_where_the_equations_of_a_scene_stay_a_program() -> None:
    for end, verdict in ((" + m g z/2", "UNDECIDED"), ("", "REFUTED")):
        text = r"V = m g z \cos\theta/2\cos\theta" + end
        assert mechanics.check(FLYER, text, blame=False).verdict.name == verdict

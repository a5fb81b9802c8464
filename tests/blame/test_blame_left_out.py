r"""What is too many in brackets goes with its brackets; edits beside what is declared."""

import pytest

import mechanics
from mechanics.judge.check import derived
from systems import cartpole

CART = derived(cartpole.scene())
TURNED = r"(\ddot\theta\cos\theta - \dot\theta^2\sin\theta)"
RIGHT = rf"(m_c+m_p)\ddot x + m_p l{TURNED} = F"


@pytest.mark.parametrize(
    ("wrong", "right"),
    [
        (RIGHT.replace(TURNED, TURNED + r"\left(m_c + l\right)"), RIGHT),
        (RIGHT.replace("m_p l", "m_p (m_c + l) l"), RIGHT),
        ("(mc+mp)*x'' + (mc + l)*mp*l*(theta''*cos(theta) - theta'^2*sin(theta)) = F",
         "(mc+mp)*x'' + mp*l*(theta''*cos(theta) - theta'^2*sin(theta)) = F"),
    ],
)  # fmt: skip
def test_a_bracket_is_left_out_whole(wrong: str, right: str) -> None:
    (entry,) = mechanics.check(CART, wrong).judged
    assert entry.blame is not None
    repaired = [repair.repaired.replace(" ", "") for repair in entry.blame.repairs]
    assert right.replace(" ", "") in repaired


@pytest.mark.sample(2)
@pytest.mark.parametrize("term", ["+ (x)", "- ((x - Abs(theta)))", "+ (mc)"])
@pytest.mark.parametrize("place", [" = F", " + mp*l*", "(mc+mp)"])
def test_a_term_in_brackets_goes_with_them_and_with_its_sign(term: str, place: str) -> None:
    right = "(mc+mp)*x'' + mp*l*(theta''*cos(theta) - theta'^2*sin(theta)) = F"
    before, after = right.split(place, 1)
    wrong = f"{before} {term}{place}{after}" if before else f"{term} + {right}"
    (entry,) = mechanics.check(CART, wrong).judged
    assert entry.blame is not None
    repaired = [repair.repaired for repair in entry.blame.repairs]
    assert right.replace(" ", "") in [text.replace(" ", "") for text in repaired]
    assert mechanics.check(CART, repaired[0]).ok


@pytest.mark.parametrize("declared", [{"values": {"g": 9.81}}, {"where": "cos(theta) > 0"}])
def test_edits_are_searched_beside_what_is_declared(declared: dict) -> None:
    (entry,) = mechanics.check(CART, RIGHT.replace("= F", "= 2 F"), **declared).judged
    assert entry.finding.verdict.name == "REFUTED"
    assert entry.blame is not None
    assert [edit.written for edit in entry.blame.repairs[0].edits] == ["2"]
    (entry,) = mechanics.check(CART, RIGHT, **declared).judged
    assert entry.blame is None

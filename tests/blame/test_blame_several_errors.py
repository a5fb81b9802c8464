r"""Several independent errors in one statement: all of them are named, each at its place.

right  ->  three to six mistakes  ->  REFUTED, and the first repair undoes every one of them
"""

from collections.abc import Sequence
from dataclasses import dataclass

import pytest

import mechanics
from mechanics.blame.result import Blame, Mistake, Repair
from mechanics.blame.search.change import Change
from mechanics.blame.search.cover import Piece, covers
from mechanics.blame.search.syntax_tree import SyntaxTree
from mechanics.claims.tree import Name, Sum
from mechanics.judge.check import derived
from mechanics.kernel import Verdict
from systems import cartpole, double_pendulum, elastic_pendulum, rocker, two_mass_chain

TRUTHS = {
    "pendulum": derived(elastic_pendulum.scene()),
    "rocker": derived(rocker.scene()),
    "cartpole": derived(cartpole.scene()),
    "double": derived(double_pendulum.scene()),
    "chain": derived(two_mass_chain.scene()),
}


def blamed(system: str, text: str) -> Blame:
    """The blame of a refuted statement; the text of each repair is right when it is read again."""
    (entry,) = mechanics.check(TRUTHS[system], text).judged
    assert entry.finding.verdict is Verdict.REFUTED
    assert entry.blame is not None
    for repair in entry.blame.repairs:
        assert repair.finding.shown
        (again,) = mechanics.check(TRUTHS[system], repair.repaired, blame=False).judged
        assert again.finding.shown, repair.repaired
    return entry.blame


def first(system: str, text: str) -> Repair:
    """The first repair."""
    found = blamed(system, text)
    assert found.repairs, found.searched
    return found.repairs[0]


def told(repair: Repair) -> set[tuple[str, str]]:
    """What stands there, and what has to stand there."""
    return {(edit.written, edit.right) for edit in repair.edits}


SIX = (
    r"(M+m) \ddot{x}+2 k x+M \frac{L}{2} \ddot{\theta} \cos \theta"
    r"-M \frac{L}{2} \dot{\theta}^{2} \sin \theta=0"
)
WRONG_SIX = {
    r"(M-m) \ddot{x}+2 k x+M \frac{L}{2} \ddot{\theta} \sin \theta"
    r"+M \frac{L}{2} \dot{\theta}^{2} \sin \theta=0": 3,
    r"(M-m) \ddot{x}+3 k x+M \frac{L}{2} \ddot{\theta} \sin \theta"
    r"+M \frac{L}{2} \dot{\theta}^{2} \sin \theta=0": 4,
    r"(M-m) \ddot{x}-3 k x+M \frac{L}{2} \ddot{\theta} \sin \theta"
    r"-M \frac{L^{2}}{2} \dot{\theta}^{2} \sin \theta=0": 5,
}


@pytest.mark.parametrize(("wrong", "count"), WRONG_SIX.items())
def test_three_to_five_errors_of_a_row_are_undone(wrong: str, count: int) -> None:
    repair = first("pendulum", wrong)
    assert len(repair.edits) == count
    assert repair.repaired.replace(" ", "") == SIX.replace(" ", "")


def test_errors_beside_each_other_in_products_and_brackets_are_undone() -> None:
    repair = first(
        "rocker",
        r"\left[I_{C}+M R\left(\frac{5}{4}+\cos \theta\right)\right] \ddot{\theta}"
        r"+M \frac{R^{2}}{2} \dot{\theta}^{2} \sin \theta-M g \frac{R}{2} \cos \theta"
        r"=f(t)\left(R+\frac{R}{2} \cos \theta\right)",
    )
    assert told(repair) == {("+", "-"), ("R", "R^{2}"), (r"\cos \theta", r"\sin \theta")}


def test_a_missing_term_beside_two_errors_is_named() -> None:
    repair = first(
        "pendulum",
        r"M \ddot{x}-2 k x+M \frac{L}{2} \ddot{\theta} \cos \theta"
        r"-m \frac{L}{2} \dot{\theta}^{2} \sin \theta=0",
    )
    kinds = sorted(edit.mistake.name for edit in repair.edits)
    assert kinds == ["MISSING", "SIGN", "SYMBOL"]


def test_numbers_above_and_below_the_line_of_a_solved_equation_are_found() -> None:
    right = first(
        "cartpole",
        r"\ddot{x} = \frac{7 l m_p \dot\theta^2 \sin\theta - 3 g m_p \sin\theta\cos\theta + 5 F}"
        r"{4 m_c + 7 m_p - 3 m_p \cos^2\theta}",
    )
    assert [edit.mistake for edit in right.edits] == [Mistake.FACTOR] * 3
    assert told(right) >= {("5", "4"), ("7 m_p", "4 m_p")}


def test_a_term_left_out_of_a_square_is_found_beside_another_error() -> None:
    repair = first(
        "double",
        "T = m1*l1^2*phi1_dot^3/2 + m2*((l1*phi1_dot*cos(phi1))^2"
        " + (l1*phi1_dot*sin(phi1) + l2*phi2_dot*sin(phi2))^2)/2",
    )
    assert told(repair) >= {("phi1_dot^3", "phi1_dot^2")}
    (other,) = (edit for edit in repair.edits if edit.mistake is Mistake.MISSING)
    assert "l2*phi2_dot*cos(phi2)" in other.right


def test_two_errors_stay_two_edits() -> None:
    repair = first("pendulum", SIX.replace("+2 k", "-2 k").replace(r"\cos", r"\sin"))
    assert len(repair.edits) == 2


def test_no_acceleration_that_nobody_wrote_is_missing() -> None:
    # With x2_ddot for the second error as many terms would differ.
    found = blamed("chain", "6*k*x1 - k*x2 + 6*m*x1_ddot = 0")
    assert [difference.group for difference in found.differences] == ["stiffness"]


@dataclass(frozen=True)
class Case:
    """Pieces by the bits that they undo and what they cost, and the bits of the cheapest covers."""

    pieces: Sequence[tuple[int, float]]
    wanted: Sequence[Sequence[int]]


CASES = (
    Case([(0b001, 1.0), (0b010, 1.0), (0b100, 1.0)], [[0b001, 0b010, 0b100]]),
    Case([(0b011, 1.0), (0b001, 1.0), (0b010, 1.5), (0b100, 1.0)], [[0b011, 0b100]]),
    Case([(0b011, 1.0), (0b110, 1.0)], []),
)


@pytest.mark.parametrize("case", CASES)
def test_covers_undo_every_difference_once_the_cheapest_first(case: Case) -> None:
    names = tuple(Name(0, f"a{i}") for i in range(len(case.pieces)))
    tree = SyntaxTree({}).plant([(0, Sum(0, names))])
    pieces = [
        Piece(undone, (Change(i, None, Mistake.SIGN, cost, i, (0,)),))
        for i, (undone, cost) in enumerate(case.pieces, 1)
    ]
    found = [[piece.undone for piece in cover.pieces] for cover in covers(tree, pieces, 3, 0)]
    assert found[:1] == list(case.wanted)


def test_covers_may_leave_what_nothing_undoes() -> None:
    tree = SyntaxTree({}).plant([(0, Sum(0, (Name(0, "a"), Name(0, "b"))))])
    piece = Piece(0b01, (Change(1, None, Mistake.SIGN, 1.0, 1, (0,)),))
    lefts = [cover.left for cover in covers(tree, [piece], 2, 2)]
    assert 0b10 in lefts


@pytest.mark.campaign
def test_errors_of_a_reaction_solved_for_are_named() -> None:
    repair = first(
        "rocker",
        "N = (I_C*M*R*theta_dot**2*cos(theta)/2 + I_C*M*g + 5*M**2*R**3*theta_dot**2*cos(theta)/8"
        " + M**2*R**3*theta_dot**2*cos(theta)**2/4 + M**2*R**3*theta_dot**2/4"
        " - M**2*R**2*g*cos(theta)**2/4 - M**2*R**2*g*cos(theta) - M**2*R**2*g"
        " + M*R**2*f*sin(theta)**2/4 + M*R**2*f*sin(theta)/3)"
        "/(-I_C - M*R**2*cos(theta) - 5*M*R**2/4)",
    )
    assert ("+", "-") in told(repair)
    assert ("3", "2") in told(repair)
    assert len(repair.edits) == 3


def test_two_errors_in_one_term_of_a_potential_are_found() -> None:
    # It is known up to a constant only, so that two states are compared.
    repair = first("pendulum", "V = k*x**2 - M*g*L*sin(theta)/3")
    assert sorted(edit.mistake.name for edit in repair.edits) == ["FACTOR", "FUNCTION"]


def test_equal_entries_of_a_matrix_are_mended_each_at_its_place() -> None:
    right = "Matrix([[m + M, M*L*cos(theta)/2], [M*L*cos(theta)/2, M*L**2/3]])"
    wrong = right.replace("cos", "sin").replace("/3", "/2")
    assert first("pendulum", wrong).repaired == right

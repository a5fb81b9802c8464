"""Laws of `decide`: true statements are shown, false ones refuted by a witness that holds."""

from collections.abc import Callable
from fractions import Fraction
from itertools import combinations, islice
from typing import Any

import mpmath
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath_domain import MultiplePrecision

from mechanics.kernel import Finding, Range, Statement, Verdict, decide
from mechanics.kernel.normal import proves
from mechanics.kernel.trial import Answer, trial
from mechanics.kernel.witness import (
    SIMPLE_STATES,
    boundaries,
    find_witness,
    first_witness,
    states,
)
from mechanics.program import Builder, Node, interpret
from mechanics.program.interpret import include

FREE, POSITIVE = "x y z", "a b L"
SIGNS = dict.fromkeys(POSITIVE.split(), Range.POSITIVE)

Sides = Callable[..., tuple[Node, Node]]
"""Of x, y, z (free), a, b, L (positive) and the builder."""


def statement(sides: Sides, **options: object) -> Statement:
    b = Builder()
    inputs = [b.input(name) for name in f"{FREE} {POSITIVE}".split()]
    left, right = sides(b, *inputs)
    program = b.program({"left": [left], "right": [right]})
    return Statement("law", program, SIGNS, **options)


def call(name: str, *operands: Node) -> Node:
    return operands[0].builder.call(name, *operands)


def smaller(x: Node, y: Node) -> Node:
    return (x + y - abs(x - y)) / 2


def larger(x: Node, y: Node) -> Node:
    return (x + y + abs(x - y)) / 2


TRUE: dict[str, Sides] = {
    "double angle": lambda B, x, y, z, a, b, L: ((2 * x).sin(), 2 * x.sin() * x.cos()),
    "half angle": lambda B, x, y, z, a, b, L: ((x / 2).sin().power(2), (1 - x.cos()) / 2),
    "sum": lambda B, x, y, z, a, b, L: ((x + y).sin(), x.sin() * y.cos() + x.cos() * y.sin()),
    "even": lambda B, x, y, z, a, b, L: ((x * Fraction(3, 4) - y).cos(),
                                         (y - x * Fraction(3, 4)).cos()),
    "third": lambda B, x, y, z, a, b, L: ((x / 3).cos(),
                                          4 * (x / 9).cos().power(3) - 3 * (x / 9).cos()),
    "product": lambda B, x, y, z, a, b, L: ((x * (y + z)).sin(), (x * y + x * z).sin()),
    "quotient": lambda B, x, y, z, a, b, L: (((x + y) / a).sin(), (x / a + y / a).sin()),
    "eighth turn": lambda B, x, y, z, a, b, L: ((x + B.pi / 4).sin(),
                                                (x.sin() + x.cos()) / B.constant(2).sqrt()),
    "half a turn": lambda B, x, y, z, a, b, L: (B.pi.cos() * x, B.pi.sin() - x),
    "twelfth turn": lambda B, x, y, z, a, b, L: ((B.pi / 12).cos() * 4,
                                                 B.constant(6).sqrt() + B.constant(2).sqrt()),
    "fifth turn": lambda B, x, y, z, a, b, L: ((B.pi / 5).cos() * 4, 1 + B.constant(5).sqrt()),
    "seventh turn": lambda B, x, y, z, a, b, L: (
        (B.pi / 7).sin() * (2 * B.pi / 7).sin() * (3 * B.pi / 7).sin() * 8, B.constant(7).sqrt()),
    "eleventh turn": lambda B, x, y, z, a, b, L: (
        (x + 2 * B.pi / 11 + B.pi * Fraction(9, 11)).sin(), -x.sin()),
    "turns": lambda B, x, y, z, a, b, L: (
        (x + 7 * B.pi).cos() + (x - B.pi / 2).sin(), -2 * x.cos()),
    "whole turns": lambda B, x, y, z, a, b, L: (
        (x - 2 * B.pi * call("floor", (x + B.pi) / (2 * B.pi))).sin(), x.sin()),
    "tangent": lambda B, x, y, z, a, b, L: (call("tan", x).power(2) + 1, 1 / x.cos().power(2)),
    "both kinds": lambda B, x, y, z, a, b, L: (x + x.sin().power(2), x + 1 - x.cos().power(2)),
    "arcs": lambda B, x, y, z, a, b, L: (call("atan2", x, y).cos() * (x * x + y * y).sqrt(), y),
    "root of a product": lambda B, x, y, z, a, b, L: ((a * b).sqrt(), a.sqrt() * b.sqrt()),
    "root of a square": lambda B, x, y, z, a, b, L: ((L * L).sqrt(), L),
    "root of a multiple": lambda B, x, y, z, a, b, L: ((4 * L * L * a).sqrt(), 2 * L * a.sqrt()),
    "square of a root": lambda B, x, y, z, a, b, L: (
        (x * x + y * y).sqrt().power(2), x * x + y * y),
    "root below": lambda B, x, y, z, a, b, L: (1 / (a + b).sqrt(), (a + b).sqrt() / (a + b)),
    "cube roots": lambda B, x, y, z, a, b, L: (
        (a * b).power(Fraction(1, 3)), a.power(Fraction(1, 3)) * b.power(Fraction(1, 3))),
    "fourth roots": lambda B, x, y, z, a, b, L: ((a.sqrt() * b).sqrt(),
                                                 a.power(Fraction(1, 4)) * b.sqrt()),
    "surds": lambda B, x, y, z, a, b, L: (B.constant(11).sqrt() * B.constant(13).sqrt() * x,
                                          B.constant(143).sqrt() * x),
    "positive square": lambda B, x, y, z, a, b, L: ((x * x + 1).power(2).sqrt(), x * x + 1),
    "root of a fraction": lambda B, x, y, z, a, b, L: (((x * x) / (y * y)).sqrt() * abs(y), abs(x)),
    "modulus": lambda B, x, y, z, a, b, L: ((x * x - 2 * x * y + y * y).sqrt(), abs(x - y)),
    "modulus of a product": lambda B, x, y, z, a, b, L: (abs(x * y), abs(x) * abs(y)),
    "sign": lambda B, x, y, z, a, b, L: (abs(x) * x.sign(), x),
    "signs": lambda B, x, y, z, a, b, L: (x.sign().power(3) * abs(x * y), x * abs(y)),
    "signs of quotients": lambda B, x, y, z, a, b, L: ((x / -y).sign() * abs(x) * y, -x * abs(y)),
    "extremes": lambda B, x, y, z, a, b, L: (larger(x, y) + smaller(x, y), x + y),
    "choice": lambda B, x, y, z, a, b, L: (B.less(x, y).choose(x, y), smaller(x, y)),
    "exponentials": lambda B, x, y, z, a, b, L: ((x + y).exp(), x.exp() * y.exp()),
    "hyperbolas": lambda B, x, y, z, a, b, L: (x.cosh().power(2) - x.sinh().power(2), B.one),
    "hyperbolic tangent": lambda B, x, y, z, a, b, L: (call("tanh", x) * x.cosh(), x.sinh()),
    "congruence": lambda B, x, y, z, a, b, L: (call("atan2", x * (x + 1), y),
                                               call("atan2", x * x + x, y)),
    "odd functions": lambda B, x, y, z, a, b, L: (call("atan", x * (y - z)),
                                                  -call("atan", x * z - x * y)),
    "pi": lambda B, x, y, z, a, b, L: (B.pi * (x + 1), B.pi * x + B.pi),
    "doubles": lambda B, x, y, z, a, b, L: (B.constant(0.5) * x, x / 2),
    "quotients": lambda B, x, y, z, a, b, L: ((x * x - y * y) / (x - y), x + y),
    "numbers as conditions": lambda B, x, y, z, a, b, L: (
        call("select", 2 * x, y, z), call("select", call("equal", x, 0), z, y)),
    "logarithms of rationals": lambda B, x, y, z, a, b, L: (
        x * B.constant(Fraction(9, 8)).log(),
        x * (2 * B.constant(3).log() - 3 * B.constant(2).log())),
    "logarithm of a power": lambda B, x, y, z, a, b, L: (
        x * B.constant(8).log() / B.constant(2).log(), 3 * x),
}  # fmt: skip

FALSE: dict[str, Sides] = {
    "sine": lambda B, x, y, z, a, b, L: (x.sin(), x),
    "double angle": lambda B, x, y, z, a, b, L: ((2 * x).sin(), 2 * x.sin()),
    "tiny": lambda B, x, y, z, a, b, L: (x, x * (1 + Fraction(1, 10**40))),
    "pi": lambda B, x, y, z, a, b, L: (B.pi * x, x * Fraction(22, 7)),
    "doubles": lambda B, x, y, z, a, b, L: (B.constant(0.1) * x, x / 10),
    "modulus": lambda B, x, y, z, a, b, L: ((x * x - 2 * x * y + y * y).sqrt(), x - y),
    "absolute": lambda B, x, y, z, a, b, L: (abs(x), x),
    "cosine": lambda B, x, y, z, a, b, L: ((1 - x.sin().power(2)).sqrt(), x.cos()),
    "root of a sum": lambda B, x, y, z, a, b, L: ((a + b).sqrt(), a.sqrt() + b.sqrt()),
    "root of a quotient": lambda B, x, y, z, a, b, L: (
        (x * x / (y * y)).sqrt() * y, abs(x)),
    "arc": lambda B, x, y, z, a, b, L: (call("atan", x), x),
    "extreme": lambda B, x, y, z, a, b, L: (larger(x, y), x),
    "choice": lambda B, x, y, z, a, b, L: (B.less(x, y).choose(x, y), larger(x, y)),
    "roots": lambda B, x, y, z, a, b, L: (a.power(Fraction(1, 3)), a.sqrt()),
    "eighth turn": lambda B, x, y, z, a, b, L: ((x + B.pi / 4).sin() * B.constant(2).sqrt(),
                                                x.sin() - x.cos()),
    "fifth turn": lambda B, x, y, z, a, b, L: ((B.pi / 5).cos() * 4, 1 - B.constant(5).sqrt()),
    "half turns": lambda B, x, y, z, a, b, L: ((x + B.pi * call("floor", x)).sin(), x.sin()),
    "boundary": lambda B, x, y, z, a, b, L: (x.sign().power(2), B.one),
    "boundary of cases": lambda B, x, y, z, a, b, L: (
        B.less(x, y).choose(1, 2), call("not_greater", x, y).choose(1, 2)),
    "numbers as conditions": lambda B, x, y, z, a, b, L: (
        call("select", 2 * x, y, z), 2 * x * y + (1 - 2 * x) * z),
    "what is left out between cases": lambda B, x, y, z, a, b, L: (
        B.less(x, y * y).choose(z, B.less(y * y, x).choose(z, 1 - z)), z),
    "a state that belongs to two cases": lambda B, x, y, z, a, b, L: (
        call("not_greater", a, b).choose(z, 0) + call("not_greater", b, a).choose(z, 0), z),
    "a boundary at 1": lambda B, x, y, z, a, b, L: ((a - 1).sign().power(2) * z, z),
    "a far limit": lambda B, x, y, z, a, b, L: (smaller(larger(x, -B.constant(100)), 100), x),
    "a far limit of what is positive": lambda B, x, y, z, a, b, L: (smaller(a, 10**7), a),
    "logarithms of rationals": lambda B, x, y, z, a, b, L: (
        x * B.constant(8).log(), 3 * x * B.constant(3).log()),
}  # fmt: skip


@pytest.mark.parametrize("name", TRUE)
def test_true_statements_are_shown(name: str) -> None:
    finding = decide(statement(TRUE[name]))
    assert finding.shown, finding


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", TRUE)
def test_without_the_normal_form_nothing_true_is_refuted(name: str) -> None:
    finding = decide(statement(TRUE[name]), try_normal=False)
    if finding.verdict is Verdict.PROVED:
        assert finding.evidence == "both sides are the same expression"
        return
    assert finding.verdict in (Verdict.CERTIFIED, Verdict.UNDECIDED)
    if finding.verdict is Verdict.CERTIFIED:
        assert finding.error_bound is not None
        assert 0 < finding.error_bound <= 2.0**-80


@pytest.mark.parametrize("name", FALSE)
def test_false_statements_are_refuted_by_a_witness_that_holds(name: str) -> None:
    claim = statement(FALSE[name])
    finding = decide(claim)
    assert finding.verdict is Verdict.REFUTED, finding
    assert finding.witness is not None
    with mpmath.workdps(120):
        state = {n: MultiplePrecision().constant(Fraction(v)) for n, v in finding.witness.state}
        for symbol, known in claim.signs.items():
            assert known is not Range.POSITIVE or state.get(symbol, 1) > 0
        outputs = interpret(claim.program, MultiplePrecision(), state)
        sides = outputs["left"][0], outputs["right"][0]
        assert abs(sides[0] - sides[1]) > mpmath.mpf(10) ** -60
        for side, words in zip(sides, (finding.witness.left, finding.witness.right), strict=True):
            middle, _, radius = words.strip("[]").partition(" +/- ")
            assert abs(side - mpmath.mpf(middle)) <= mpmath.mpf(radius or 0) + mpmath.mpf(10) ** -90


@pytest.mark.parametrize("name", FALSE)
def test_no_part_of_the_kernel_shows_what_is_false(name: str) -> None:
    claim = statement(FALSE[name])
    assert not proves(claim)
    outcome = trial(claim, lambda: False)
    # Where cases meet, only a state there tells them apart.
    assert outcome.answer is not Answer.ZERO or outcome.off_boundaries


@pytest.mark.parametrize("name", TRUE)
def test_no_part_of_the_kernel_refutes_what_is_true(name: str) -> None:
    claim = statement(TRUE[name])
    assert find_witness(claim) is None
    assert first_witness(claim, boundaries(claim)) is None


def test_sides_that_are_equal_by_accident_at_one_boundary_are_told_apart_at_another() -> None:
    def vanishing(at: Fraction) -> Sides:
        return lambda B, x, y, z, a, b, L: (x.sign().power(2) * (y - at), y - at)

    first = next(states(statement(vanishing(Fraction(1)))))["y"]
    found = decide(statement(vanishing(first)))
    assert found.verdict is Verdict.REFUTED
    assert found.witness is not None
    state = dict(found.witness.state)
    assert state["x"] == "0"
    assert state["y"] != str(first)


def test_findings_and_witnesses_are_the_same_in_each_run() -> None:
    for name in ("sine", "modulus", "root of a sum"):
        assert decide(statement(FALSE[name])) == decide(statement(FALSE[name]))


def test_witnesses_are_simple_numbers() -> None:
    finding = decide(statement(lambda B, x, y, z, a, b, L: (a * x, a * x + b)))
    assert finding.witness is not None
    assert all(Fraction(value).denominator <= 4 for _, value in finding.witness.state)
    assert [abs(Fraction(value)) <= 5 for _, value in finding.witness.state] == [True] * 3


def test_any_two_inputs_meet_with_equal_and_opposite_signs_among_simple_states() -> None:
    b = Builder()
    names = [f"x{i}" for i in range(12)]
    program = b.program({"left": [b.input(name) for name in names], "right": [b.constant(0)] * 12})
    simple = list(islice(states(Statement("signs", program)), SIMPLE_STATES))
    assert all(value.denominator <= 4 for state in simple for value in state.values())
    for one, other in combinations(names, 2):
        signs = {(state[one] > 0, state[other] > 0) for state in simple}
        assert len(signs) == 4, (one, other)


def test_a_witness_shows_the_terms_of_the_statement() -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    program = b.program({"left": [x + y], "right": [x], "terms of the left": [x, y]})
    witness = decide(Statement("terms", program)).witness
    assert witness is not None
    assert [name for name, _ in witness.solved] == ["terms of the left[0]", "terms of the left[1]"]
    assert not any("+/-" in value for _, value in witness.solved)
    state = dict(witness.state)
    assert [Fraction(value) for _, value in witness.solved] == [Fraction(state[n]) for n in "xy"]


@pytest.mark.parametrize(
    ("known", "side"), [(Range.POSITIVE, 1), (Range.NONNEGATIVE, 1), (Range.NEGATIVE, -1)]
)
def test_a_far_limit_is_passed_on_the_side_that_is_admissible(known: Range, side: int) -> None:
    b = Builder()
    x = b.input("x")
    limited = side * smaller(side * x, b.constant(5 * 10**6))
    program = b.program({"left": [limited], "right": [x]})
    finding = decide(Statement("a limit", program, {"x": known}))
    assert finding.verdict is Verdict.REFUTED
    assert finding.witness is not None
    assert side * Fraction(dict(finding.witness.state)["x"]) > 5 * 10**6


PRODUCTS = (
    (4, (Fraction(1, 10), "sin"), (Fraction(1, 5), "cos")),
    (8, (Fraction(1, 14), "sin"), (Fraction(1, 7), "cos"), (Fraction(2, 7), "cos")),
    (8, (Fraction(1, 18), "sin"), (Fraction(5, 18), "sin"), (Fraction(7, 18), "sin")),
)
"""Products of sines and cosines that are one: Morrie's law and its kin."""


@pytest.mark.parametrize("n", range(4))
@pytest.mark.parametrize("product", PRODUCTS, ids=lambda product: str(product[1][0].denominator))
def test_products_of_sines_are_one_and_not_minus_one(product: Any, n: int) -> None:
    """Another `n` draws another point of the field, in half of which sin(pi/2) was -1 once."""
    b = Builder()
    factor, *turns = product
    value = (b.input("x") + n) * factor
    for turn, name in turns:
        value = value * getattr(b.pi * turn, name)()
    sides = {"left": [value], "right": [b.input("x") + n]}
    shown = (Verdict.PROVED, Verdict.CERTIFIED)
    assert decide(Statement("one", b.program(sides))).verdict in shown
    minus = sides | {"right": [-b.input("x") - n]}
    assert decide(Statement("minus one", b.program(minus))).verdict is Verdict.REFUTED


def test_typical_values_lead_to_states_that_meet_the_conditions() -> None:
    """No simple number lies between 1000 and 1001."""
    b = Builder()
    x, y = b.input("x"), b.input("y")
    outputs = {"left": [x * y], "right": [x * y + y], "positive": [x - 1000, 1001 - x]}
    finding = decide(Statement("near", b.program(outputs), typical={"x": Fraction(2001, 2)}))
    assert finding.verdict is Verdict.REFUTED
    assert finding.witness is not None
    assert 1000 < Fraction(dict(finding.witness.state)["x"]) < 1001


def test_conditions_are_met_by_points_and_witnesses() -> None:
    def sides(turned: int) -> Statement:
        b = Builder()
        x, y = b.input("x"), b.input("y")
        root = ((x - y) * (x - y)).sqrt()
        outputs = {"left": [root], "right": [turned * (x - y)], "positive": [x - y]}
        return Statement("under a condition", b.program(outputs))

    assert decide(sides(1), try_normal=False).verdict is Verdict.CERTIFIED
    finding = decide(sides(-1), try_normal=False)
    assert finding.verdict is Verdict.REFUTED
    assert finding.witness is not None
    state = {name: Fraction(value) for name, value in finding.witness.state}
    assert state["x"] > state["y"]


def test_what_is_true_for_a_reason_unknown_here_is_undecided_and_names_the_operation() -> None:
    finding = decide(
        statement(lambda B, x, y, z, a, b, L: ((x.exp() * (a + 1)).log(), x + (a + 1).log()))
    )
    assert finding.verdict is Verdict.UNDECIDED
    assert "log" in finding.evidence


def test_a_singular_matrix_is_undecided() -> None:
    finding = decide(
        statement(lambda B, x, y, z, a, b, L: (B.solve([[x, 2 * x], [y, 2 * y]], [1, 1])[0], x))
    )
    assert finding.verdict is Verdict.UNDECIDED
    assert "singular matrix" in finding.evidence


def test_nothing_to_compare_is_no_success() -> None:
    b = Builder()
    with pytest.raises(ValueError, match="nothing to compare"):
        Statement("empty", b.program({"left": [], "right": []}))
    with pytest.raises(ValueError, match="1 entries on the left, 2 on the right"):
        Statement("uneven", b.program({"left": [b.one], "right": [b.one, b.zero]}))
    with pytest.raises(ValueError, match="no probability"):
        statement(TRUE["pi"], target=0.0)


def test_a_root_that_no_field_has_is_known_by_congruence_only() -> None:
    finding = decide(statement(lambda B, x, y, z, a, b, L: (
        a.power(Fraction(1, 11)) * x, x * a.power(Fraction(1, 11)))))  # fmt: skip
    assert finding.shown
    finding = decide(statement(lambda B, x, y, z, a, b, L: (a.power(Fraction(1, 11)).power(11), a)))
    assert finding.verdict is Verdict.UNDECIDED


@pytest.mark.campaign
@settings(max_examples=30, deadline=None)
@given(st.fractions(-4, 4, max_denominator=12), st.fractions(-4, 4, max_denominator=12))
def test_angles_add_by_the_group_law(m: Fraction, n: Fraction) -> None:
    b = Builder()
    x = b.input("x")
    total = (m * x).cos() * (n * x).cos() - (m * x).sin() * (n * x).sin()
    program = b.program({"left": [((m + n) * x).cos()], "right": [total]})
    assert decide(Statement("cos of a sum", program)).shown


@pytest.mark.campaign
@settings(max_examples=30, deadline=None)
@given(st.lists(st.lists(st.integers(-3, 3), min_size=3, max_size=3), min_size=3, max_size=3))
def test_solutions_solve(numbers: list[list[int]]) -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    matrix = [[b.constant(n) for n in row] for row in numbers]
    for i, extra in enumerate((5 * x + 11, 7 * y * y + 12, b.constant(13))):
        matrix[i][i] = matrix[i][i] + extra
    right = [x, b.one, b.constant(Fraction(1, 3))]
    found = b.solve(matrix, right)
    left = [sum((m * v for m, v in zip(row, found, strict=True)), b.zero) for row in matrix]
    claim = Statement("solve", b.program({"left": left, "right": right}))
    assert decide(claim).shown
    assert decide(claim, try_normal=False).verdict is Verdict.CERTIFIED
    wrong = b.program({"left": [left[0] + found[1] / 10**9], "right": [right[0]]})
    assert decide(Statement("solve", wrong)).verdict is not Verdict.CERTIFIED


def test_a_finding_has_no_truth_value() -> None:
    with pytest.raises(TypeError, match="no truth value"):
        bool(Finding("s", Verdict.PROVED, "e"))


def test_verdicts_do_not_depend_on_how_a_program_was_built() -> None:
    one = statement(TRUE["root of a product"])
    b = Builder()
    b.input("b")
    again = b.program(include(b, one.program), inputs=one.program.inputs)
    other = Statement("law", again, SIGNS)
    assert one.seed == other.seed
    assert decide(one, try_normal=False) == decide(other, try_normal=False)

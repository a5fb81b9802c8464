"""What the kernel says of data, of bounds, of measured values and of two sides that differ.

Whatever a caller claims, it has to hand over both sides: no argument proves what is false, none
refutes what is true.
"""

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest
from flint import arb

from mechanics.kernel import (
    Finding,
    Statement,
    Verdict,
    decide,
    enclosed,
    follows,
    refuted,
    same,
    supported,
    undecided,
)
from mechanics.kernel.definedness import Gap, Kind, undefined
from mechanics.kernel.statement import Range
from mechanics.program import Builder
from mechanics.program.builder import Obligation
from mechanics.program.operations import Sign

HALF = Fraction(1, 2)
WIDE = arb(0, 1)

EQUAL: tuple[tuple[Any, Any], ...] = (
    (1, 1),
    (1, 1.0),
    (0.0, -0.0),
    (HALF, 0.5),
    (arb(1), 1),
    (arb(1), Fraction(1)),
    (arb(1) / 3, Fraction(1, 3)),
    (WIDE, 0.5),
    (WIDE, arb(1, 1)),
    (arb("nan"), 1),
    (arb("inf"), 1),
    (float("nan"), float("nan")),
    (float("nan"), arb("nan")),
    ("a", "a"),
    ((), ()),
    ((1, "a"), (1.0, "a")),
)
"""Pairs that are equal, or may be."""
DIFFERENT: tuple[tuple[Any, Any], ...] = (
    (1, 2),
    (HALF, 0.25),
    (arb(1), 2),
    (WIDE, 1.5),
    (arb(1), arb(1) + arb(2) ** -40),
    (float("nan"), 1),
    (float("inf"), arb(1)),
    ("a", "b"),
    ((1,), (1, 2)),
    ((1, "a"), (1, "b")),
)


class Agreeable:
    """Equal to everything, and shown as everything."""

    def __eq__(self, other: object) -> bool:
        return True

    __hash__ = None  # type: ignore[assignment]


class Text(str):
    """A text that shows itself as another."""

    def __repr__(self) -> str:
        return "'a'"


@pytest.mark.parametrize(("left", "right"), [*EQUAL, *(pair[::-1] for pair in EQUAL)])
def test_what_may_be_equal_is_never_refuted(left: Any, right: Any) -> None:
    finding = refuted("sides", "they differ", left, right, (("x", "1"),))
    assert finding.verdict is Verdict.UNDECIDED
    assert finding.witness is None


@pytest.mark.parametrize(("left", "right"), [*DIFFERENT, *(pair[::-1] for pair in DIFFERENT)])
def test_what_differs_is_refuted_with_both_sides_and_never_proved(left: Any, right: Any) -> None:
    finding = refuted("sides", "they differ", left, right, (("x", "1"),))
    assert finding.verdict is Verdict.REFUTED
    assert finding.witness is not None
    assert finding.witness.state == (("x", "1"),)
    assert finding.witness.left != finding.witness.right
    assert supported("sides", [(left, right)], "measured").verdict is Verdict.UNDECIDED
    if not (isinstance(left, arb) or isinstance(right, arb)):
        assert same("sides", left, right, "the same").verdict is Verdict.UNDECIDED


def test_the_same_data_are_proved_others_are_not() -> None:
    assert same("texts", ["a", "b"], ["a", "b"], "one text").verdict is Verdict.PROVED
    assert same("texts", ["a", "b"], ["b", "a"], "one text").verdict is Verdict.UNDECIDED
    assert same("tables", {"a": 1}, {"a": 1}, "one table").verdict is Verdict.PROVED
    assert same("tables", {"a": 1}, {"a": None}, "one table").verdict is Verdict.UNDECIDED
    for one, other in ((1, True), (1, "1"), (1, 1.0), (["a, b"], ["a", "b"])):
        assert same("data", one, other, "the same").verdict is Verdict.UNDECIDED


@pytest.mark.parametrize("strange", [Agreeable(), Text("b"), [Agreeable()], {"a": Agreeable()}])
def test_data_whose_class_decides_what_is_equal_are_not_compared(strange: Any) -> None:
    with pytest.raises(TypeError, match="no plain data"):
        same("data", strange, "a", "the same")
    with pytest.raises(TypeError, match="no plain data"):
        supported("data", [(strange, "a")], "measured")


@pytest.mark.parametrize(("left", "right"), [("1", 1), (Agreeable(), 1), (Text("a"), "b")])
def test_sides_of_another_kind_are_not_refuted(left: Any, right: Any) -> None:
    with pytest.raises(TypeError):
        refuted("sides", "they differ", left, right)


@pytest.mark.parametrize(
    "of_nothing",
    [
        lambda: same("nothing", [], [], "the same"),
        lambda: same("nothing", "", "", "the same"),
        lambda: enclosed("nothing", [], "in bounds"),
        lambda: supported("nothing", [], "measured"),
        lambda: follows("nothing", []),
    ],
)
def test_of_nothing_nothing_is_shown(of_nothing: Callable[[], Finding]) -> None:
    assert of_nothing().verdict is Verdict.UNDECIDED
    assert "nothing was compared" in of_nothing().evidence


@pytest.mark.parametrize(
    ("allowed", "value", "lies"),
    [
        (WIDE, 1.0, True),  # on its bound
        (WIDE, arb(0.5, 0.25), True),
        (WIDE, arb(0.5, 0.75), False),
        (WIDE, 1.0 + 2.0**-20, False),
        (WIDE, float("nan"), False),
        (arb(0, float("inf")), 1.0, False),  # it allows everything
        (arb("nan"), 1.0, False),
        ([0, 1], [0, 1], True),
        ([0, 1], [0, 2], False),
    ],
)
def test_a_measured_value_lies_within_what_is_allowed(allowed: Any, value: Any, lies: bool) -> None:
    verdict = Verdict.SUPPORTED if lies else Verdict.UNDECIDED
    assert supported("x", [(allowed, value)], "measured").verdict is verdict
    assert supported("x", [(WIDE, 0), (allowed, value)], "measured").verdict is verdict


def test_no_arguments_make_decide_prove_what_is_false() -> None:
    b = Builder()
    x = b.input("x")
    for left, right, true in ((x, x + 1, False), (x, x, True), (x.sqrt(), x.sqrt() + 1, False)):
        program = b.program({"left": [left], "right": [right]})
        for signs in ({}, {"x": Range.POSITIVE}):
            for try_normal in (True, False):
                statement = Statement("a statement", program, signs, {"x": Fraction(1)})
                assert decide(statement, try_normal=try_normal).shown is true


@pytest.mark.parametrize(
    ("gap", "verdict"),
    [
        (Gap(Obligation(Sign.NONZERO, 0, "divide"), Kind.NOWHERE), Verdict.REFUTED),
        (Gap(Obligation(Sign.NONZERO, 0, "divide"), Kind.OPEN, at_rest=True), Verdict.REFUTED),
        (Gap(Obligation(Sign.NONZERO, 0, "divide"), Kind.OPEN, region=True), Verdict.REFUTED),
        (Gap(Obligation(Sign.NONZERO, 0, "divide"), Kind.OPEN), Verdict.UNDECIDED),
        (Gap(Obligation(Sign.NONZERO, 0, "divide"), Kind.THIN, at_rest=True), Verdict.UNDECIDED),
        (Gap(Obligation(Sign.NONZERO, 0, "divide"), Kind.UNKNOWN, True), Verdict.UNDECIDED),
    ],
)
def test_a_gap_refutes_where_a_value_is_asked_for(gap: Gap, verdict: Verdict) -> None:
    assert undefined("x/y", "divide has no value", gap).verdict is verdict


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (arb(0.5), True),  # on a bound
        (arb(-0.5), True),
        (arb(0.25, 0.24), True),
        (arb(0.25, 0.26), False),
        (arb(-0.25, 0.26), False),
        (arb(0.5, 2.0**-60), False),
        (arb(-0.5, 2.0**-60), False),
        (arb("nan"), False),
        (arb("inf"), False),
    ],
)
def test_an_enclosure_lies_within_its_bounds_with_all_of_it(value: arb, shown: bool) -> None:
    assert enclosed("x", [(-HALF, value, HALF)], "x rounds to 0").shown is shown
    both = [(-HALF, arb(0), HALF), (-HALF, value, HALF)]
    assert enclosed("x", both, "both round to 0").shown is shown


def certified() -> Finding:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    sides = {"left": [(x + y).sin()], "right": [x.sin() * y.cos() + x.cos() * y.sin()]}
    return decide(Statement("b = c", b.program(sides)), try_normal=False)


def test_what_follows_is_as_sure_as_the_weakest_of_its_premises() -> None:
    proved, drawn = same("a = b", 1, 1, ""), certified()
    measured = supported("c = d", [(1, 1)], "measured")
    assert drawn.error_bound is not None
    assert follows("a = c", [proved, proved]).verdict is Verdict.PROVED
    assert follows("a = d", [proved, drawn, drawn]).error_bound == 2 * drawn.error_bound
    both = follows("a = d", [proved, drawn, measured])
    assert both.verdict is Verdict.SUPPORTED
    assert both.evidence == "follows from a = b and b = c and c = d"
    for doubt in (undecided("c = d", "nobody knows"), refuted("c = d", "they differ", 1, 2)):
        finding = follows("a = d", [proved, doubt])
        assert finding.verdict is Verdict.UNDECIDED
        assert finding.evidence == "it cannot follow from c = d"

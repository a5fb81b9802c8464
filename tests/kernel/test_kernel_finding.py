"""What the kernel says of data and of bounds."""

from fractions import Fraction

import pytest
from flint import arb

from mechanics.kernel import Verdict, enclosed, follows, same, undecided

HALF = Fraction(1, 2)


def test_the_same_data_are_proved_others_are_not() -> None:
    assert same("texts", ["a", "b"], ["a", "b"], "one text").verdict is Verdict.PROVED
    assert same("texts", ["a", "b"], ["b", "a"], "one text").verdict is Verdict.UNDECIDED


def test_what_was_drawn_is_certified_with_its_bound() -> None:
    finding = same("values", [1, 2], [1, 2], "the same at a random point", -40)
    assert (finding.verdict, finding.error_bound) == (Verdict.CERTIFIED, 2.0**-40)
    assert same("values", [1], [2], "", -40).verdict is Verdict.UNDECIDED


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


def test_what_follows_is_as_sure_as_all_its_premises_together() -> None:
    proved, drawn = same("a = b", 1, 1, ""), same("b = c", 1, 1, "", -40)
    assert follows("a = c", [proved, proved]).verdict is Verdict.PROVED
    assert follows("a = d", [proved, drawn, drawn]).error_bound == 2.0**-39
    for premises in ([], [proved, undecided("c = d", "nobody knows")]):
        with pytest.raises(ValueError, match="it cannot follow"):
            follows("a = d", premises)

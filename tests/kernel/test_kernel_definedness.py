"""Gaps between where the truth and where what was written has a value, obligation by obligation."""

from fractions import Fraction

import pytest

from mechanics.kernel.definedness import Gap, Kind, Space, gaps, unmet
from mechanics.program import Builder, Node
from mechanics.program.builder import Obligation
from mechanics.program.operations import Sign

B = Builder()
X, Y, M, K = (B.input(name) for name in "xymk")
REST = {"x": Fraction(0), "y": Fraction(0), "m": Fraction(1), "k": Fraction(1)}
THIN, OPEN, NOWHERE, UNKNOWN = Kind.THIN, Kind.OPEN, Kind.NOWHERE, Kind.UNKNOWN
NONZERO, NONNEGATIVE, POSITIVE = Sign.NONZERO, Sign.NONNEGATIVE, Sign.POSITIVE


def asked(sign: Sign, node: Node, *conditions: tuple[Node, bool]) -> Obligation:
    return Obligation(sign, node.number, "test", tuple((c.number, t) for c, t in conditions))


def space(
    *truth: Obligation, region: tuple[Node, ...] = (), zero: tuple[Node, ...] = (), **more: object
) -> Space:
    known = {"m", "k"}
    return Space(
        frozenset(known), REST, (REST,), tuple(r.number for r in region), truth,
        tuple(z.number for z in zero), **more,
    )  # fmt: skip


def found(obligation: Obligation, where: Space) -> tuple[Kind, bool] | None:
    left = gaps(B, [obligation], where)
    assert len(left) <= 1
    return (left[0].kind, left[0].at_rest) if left else None


EVERYWHERE = {
    "a mass": (NONZERO, M, None),
    "a mass and a square": (POSITIVE, M + X * X, None),
    "a square": (NONNEGATIVE, X * X, None),
    "0 under a root": (NONNEGATIVE, X.sin() ** 2 + X.cos() ** 2 - 1, None),
    "at rest": (NONZERO, X, (THIN, True)),
    "beside rest": (NONZERO, X - 1, (THIN, False)),
    "at no state": (NONZERO, X.sin() ** 2 + X.cos() ** 2 - 1, (NOWHERE, True)),
    "a logarithm of 0": (POSITIVE, X.sin() ** 2 + X.cos() ** 2 - 1, (NOWHERE, True)),
    "a half, its border at rest": (NONNEGATIVE, X, (OPEN, False)),
    "a half with rest inside": (NONNEGATIVE, X - 1, (OPEN, True)),
    "a half without rest": (NONNEGATIVE, X + 1, (OPEN, False)),
    "a half, for a logarithm": (POSITIVE, X + 1, (OPEN, False)),
    "negative everywhere": (NONNEGATIVE, -1 - X * X, (NOWHERE, True)),
    "negative but at rest": (NONNEGATIVE, -(X * X), (NOWHERE, False)),
    "never positive": (POSITIVE, -(X * X), (NOWHERE, True)),
    "a logarithm of a square": (POSITIVE, X * X, (THIN, True)),
    "a logarithm of a square beside rest": (POSITIVE, (X - 1) ** 2, (THIN, False)),
    "one of two factors": (NONZERO, X * (Y - 2), (THIN, True)),
    "zero on a half": (NONZERO, abs(X) - X, (OPEN, False)),
    "zero on a half around rest": (NONZERO, abs(X + 1) - X - 1, (OPEN, True)),
    "two absolute values": (NONZERO, abs(X) + abs(Y), (THIN, True)),
}  # fmt: skip


@pytest.mark.parametrize("name", EVERYWHERE)
def test_gaps_of_what_is_written_alone(name: str) -> None:
    sign, node, expected = EVERYWHERE[name]
    assert found(asked(sign, node), space()) == expected
    assert bool(unmet(B, [asked(sign, node)], space())) is (expected is not None)


TRUTH = {
    "the same divisor": (NONZERO, X, [asked(NONZERO, X)], None),
    "a factor of it": (NONZERO, X, [asked(NONZERO, 2 * X * (Y - 1))], None),
    "the opposite divisor": (NONZERO, 1 - X, [asked(NONZERO, X - 1)], None),
    "one factor more": (NONZERO, X * (X - 1), [asked(NONZERO, X)], (THIN, False)),
    "another divisor": (NONZERO, X, [asked(NONZERO, Y - 1)], (THIN, True)),
    "a divisor in a logarithm of the truth": (NONZERO, X, [asked(POSITIVE, X)], None),
    "the same root": (NONNEGATIVE, X, [asked(NONNEGATIVE, X)], None),
    "the same root in other units": (NONNEGATIVE, 3 * X * M, [asked(NONNEGATIVE, X)], None),
    "the same root of a product": (NONNEGATIVE, M * X, [asked(NONNEGATIVE, X * M)], None),
    "a product that no factor has": (NONNEGATIVE, 2 * X * Y, [asked(NONNEGATIVE, Y * X)], None),
    "its opposite": (NONNEGATIVE, -X * Y, [asked(NONNEGATIVE, X * Y)], (NOWHERE, False)),
    "the opposite root": (NONNEGATIVE, -X, [asked(NONNEGATIVE, X)], (NOWHERE, False)),
    "a divisor beside a root": (NONZERO, X, [asked(NONNEGATIVE, X)], (THIN, True)),
    "a logarithm beside a root": (POSITIVE, X, [asked(NONNEGATIVE, X)], (THIN, True)),
    "a root beyond the border of the truth": (
        NONNEGATIVE, X - 1, [asked(NONNEGATIVE, X)], (OPEN, True)),
    "a root within the truth's": (
        NONNEGATIVE, X - 1, [asked(NONNEGATIVE, X + 1)], (OPEN, True)),
    "a root of more than a root": (NONNEGATIVE, X + M, [asked(NONNEGATIVE, X)], None),
    "a root of a factor of a divisor": (POSITIVE, X * X, [asked(NONZERO, X * Y)], None),
    "a root of a logarithm's argument": (NONNEGATIVE, X, [asked(POSITIVE, X)], None),
    "in another branch": (
        NONZERO, X, [asked(NONZERO, X, (B.less(Y, 0), True))], (THIN, True)),
}  # fmt: skip


@pytest.mark.parametrize("name", TRUTH)
def test_the_truth_discharges_its_own_obligations(name: str) -> None:
    sign, node, truth, expected = TRUTH[name]
    assert found(asked(sign, node), space(*truth)) == expected


ABOVE, BELOW = B.less(0, X), B.less(X, 0)
BRANCHES = {
    "guarded": (asked(NONNEGATIVE, X, (ABOVE, True)), None),
    "guarded by the other case": (asked(NONNEGATIVE, X, (BELOW, False)), None),
    "guarded by not": (asked(NONNEGATIVE, X, (B.call("not", BELOW), True)), None),
    "guarded by both": (asked(NONZERO, X, (B.call("and", ABOVE, B.less(Y, 1)), True)), None),
    "guarded by neither": (
        asked(NONZERO, X, (B.call("or", B.less(Y, 1), BELOW), False)), (THIN, False)),
    "the wrong guard": (asked(NONNEGATIVE, X, (BELOW, True)), (OPEN, False)),
    "a guard of another": (asked(NONZERO, X, (B.less(Y, 1), True)), (THIN, True)),
    "at equality": (asked(NONZERO, X, (B.call("equal", X, 0), True)), (THIN, True)),
    "off equality": (asked(NONZERO, X, (B.call("equal", X, 0), False)), None),
    "a branch that nothing enters": (asked(NONZERO, X, (B.less(X * X + 1, 0), True)), None),
}  # fmt: skip


@pytest.mark.parametrize("name", BRANCHES)
def test_what_leads_to_a_branch_discharges(name: str) -> None:
    obligation, expected = BRANCHES[name]
    assert found(obligation, space()) == expected


REGIONS = {
    "inside": (asked(NONZERO, X), (X - 1,), None, False),
    "a quotient": (asked(NONZERO, X), (X / M,), None, False),
    "a quotient of negatives": (asked(POSITIVE, X), (X / (-M),), (NOWHERE, True), True),
    "not far enough": (asked(NONNEGATIVE, X - 2), (X - 1,), (OPEN, False), True),
    "of another": (asked(NONZERO, X), (Y - 1,), (THIN, False), False),
}


@pytest.mark.parametrize("name", REGIONS)
def test_a_region_that_was_stated_discharges(name: str) -> None:
    obligation, region, expected, inside = REGIONS[name]
    left = gaps(B, [obligation], space(region=region))
    assert (left[0].kind if left else None) == (expected and expected[0])
    assert not left or left[0].region is inside


def test_what_follows_from_another_obligation_is_told_once() -> None:
    first = asked(NONNEGATIVE, X)
    for other, count in (
        (asked(NONNEGATIVE, 2 * M * X), 1), (asked(NONNEGATIVE, -X), 2),
        (asked(POSITIVE, X), 2), (asked(NONNEGATIVE, X, (B.less(Y, 1), True)), 1),
    ):  # fmt: skip
        assert len(unmet(B, [first, other], space())) == count
    assert len(unmet(B, [asked(NONZERO, X), asked(NONZERO, -2 * X)], space())) == 1
    guarded = asked(NONNEGATIVE, X, (B.less(Y, 1), True))
    assert len(unmet(B, [guarded, first], space())) == 2


def test_states_of_a_gap_are_in_it() -> None:
    (gap,) = gaps(B, [asked(NONNEGATIVE, X - 1)], space())
    assert dict(gap.state)["x"] < 1
    (gap,) = gaps(B, [asked(NONNEGATIVE, X - 1)], space(asked(NONNEGATIVE, X)))
    assert 0 <= dict(gap.state)["x"] < 1
    assert gap.at_rest
    (gap,) = gaps(B, [asked(NONZERO, abs(X) - X)], space())
    assert dict(gap.state)["x"] > 0
    assert gap == Gap(gap.obligation, OPEN, False, gap.state, False)


def test_where_the_truth_has_no_value_at_rest_others_are_tried() -> None:
    truth = space(asked(NONZERO, X))
    assert found(asked(NONNEGATIVE, Y - 1), truth) == (OPEN, False)
    assert found(asked(NONNEGATIVE, Y - 1), space(asked(NONZERO, X - 1))) == (OPEN, True)


def test_on_constraints_what_they_give_is_discharged() -> None:
    def closed(state: dict) -> dict:
        return {**state, "x": state["y"] + state["m"]}

    line = {"zero": (X - Y - M,), "admissible": closed}
    assert found(asked(NONZERO, X - Y), space(**line)) is None
    assert found(asked(NONNEGATIVE, X - Y), space(**line)) is None
    assert found(asked(NONNEGATIVE, X), space(**line)) == (OPEN, False)
    assert found(asked(NONZERO, X - Y), space()) == (THIN, True)
    nowhere = space(zero=(X - Y - M,), admissible=lambda state: None)
    assert found(asked(NONNEGATIVE, X), nowhere) == (UNKNOWN, False)


def test_an_argument_that_reaches_its_border_is_not_always_positive() -> None:
    square, above, free = X * X, X * X + M, X
    roots = [asked(NONNEGATIVE, node) for node in (square, above, free)]
    assert unmet(B, roots, space()) == (roots[2],)
    strictly = [asked(POSITIVE, node) for node in (square, above, free)]
    assert unmet(B, strictly, space()) == (strictly[0], strictly[2])

"""Rows of four-bars: every loop is closed by itself, and all routes agree."""

import pytest

from benchmarks.space.deriving import distinct
from mechanics.checks.admissible import check_scene
from mechanics.checks.agreement import compare_pairs
from mechanics.crosscheck.programs import derive_rows
from systems import four_bar_chain

ROUTES = ("free_body", "moving_point", "kane", "lagrange")


@pytest.mark.parametrize(
    ("count", "length"),
    [
        (2, None),
        (2, distinct),
        pytest.param(10, None, marks=pytest.mark.campaign),
        pytest.param(10, distinct, marks=pytest.mark.campaign),
        pytest.param(40, None, marks=pytest.mark.campaign),
        pytest.param(40, distinct, marks=pytest.mark.campaign),
    ],
)
def test_all_routes_agree_on_a_row_of_four_bars(count: int, length) -> None:
    """Without lengths of its own it is A02: all are 1."""
    sizes = (count, length) if length else (count,)
    mechanism = check_scene(four_bar_chain.scene(*sizes))
    assert len(mechanism.closure.values) == 4 * count
    pairs = compare_pairs(derive_rows(mechanism, ROUTES).routes)
    assert len(pairs) == 6
    assert all(finding.shown for finding in pairs.values())

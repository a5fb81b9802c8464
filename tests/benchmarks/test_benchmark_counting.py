"""Operations by kind, and apart those that depend on parameters only."""

import pytest

from benchmarks.space.counting import Counts, count
from mechanics.program import Builder

B = Builder()
X, Y, M = (B.input(name) for name in "xym")


@pytest.mark.parametrize(
    ("node", "expected"),
    [
        (X * Y, Counts(1, 0, 0, 0)),
        (X / Y, Counts(1, 0, 0, 0)),
        (X + Y, Counts(0, 1, 0, 0)),
        (X - Y, Counts(0, 1, 0, 0)),
        (-X, Counts(0, 1, 0, 0)),
        (X.sin(), Counts(0, 0, 1, 0)),
        (X.sqrt() * (M * M + 1), Counts(1, 0, 1, 2)),
        (M * M / 2, Counts(0, 0, 0, 2)),
        (B.solve([[X, Y], [Y, M]], [1, 2])[1], Counts(0, 0, 1, 0)),
    ],
)
def test_each_operation_counts_where_it_belongs(node: object, expected: Counts) -> None:
    found = count(B.program({"f": [node]}), {"m"})
    assert found == expected
    assert found.total == expected.multiplications + expected.additions + expected.functions

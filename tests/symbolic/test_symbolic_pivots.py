"""Columns that are independent at a point of a field."""

from mechanics.symbolic.pivots import pivot_columns


def test_pivots_are_the_first_columns_that_do_not_follow_from_those_before() -> None:
    assert pivot_columns([[0, 1, 2, 3], [0, 4, 8, 5]], 10007) == [1, 3]
    assert pivot_columns([[1, 1, 2], [2, 2, 4]], 10007) == [0]
    assert pivot_columns([], 10007) == []

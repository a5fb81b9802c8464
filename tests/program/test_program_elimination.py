"""Linear systems that are written out have the solution of the system."""

from fractions import Fraction

import numpy as np
import pytest

from mechanics.errors import ExpressionError
from mechanics.program import Builder, Node, Program, interpret
from mechanics.program.elimination import determinant, expand_solves
from mechanics.program.numpy_domain import Arrays


def assert_equal_solutions(program: Program, written: Program) -> None:
    assert "solve" not in written.counts()
    assert written.inputs == program.inputs
    drawn = np.random.default_rng(1).uniform(-0.5, 0.5, len(program.inputs))
    values = dict(zip(program.inputs, drawn, strict=True))
    left, right = (interpret(p, Arrays(), values)["x"] for p in (program, written))
    np.testing.assert_allclose(left, np.array(right, dtype=float), rtol=1e-12, atol=1e-12)


def symmetric_matrix(b: Builder, size: int) -> list[list[Node]]:
    entries = {(i, j): b.input(f"m{i}{j}") for i in range(size) for j in range(i + 1)}
    return [
        [entries[max(i, j), min(i, j)] + (size if i == j else 0) for j in range(size)]
        for i in range(size)
    ]


@pytest.mark.parametrize("size", [1, 2, 3, 6])
def test_symmetric_systems_have_diagonal_pivots(size: int) -> None:
    b = Builder()
    right = [b.input(f"f{i}") for i in range(size)]
    program = b.program({"x": b.solve(symmetric_matrix(b, size), right, symmetric=True)})
    written = expand_solves(program)
    assert_equal_solutions(program, written)
    # n (n - 1) (n - 2) / 6 + n (n - 1) / 2 below the diagonal, n (n - 1) for the right side.
    n = size
    assert written.counts().get("multiply", 0) == n * (n - 1) * (n + 1) // 6 + n * (n - 1)
    assert written.counts()["divide"] == n * (n + 1) // 2


def test_a_tree_fills_nothing_in() -> None:
    b = Builder()
    size = 12
    matrix = [[b.zero] * size for _ in range(size)]
    for i in range(size):
        matrix[i][i] = b.input(f"d{i}") + 4
        if i:
            matrix[0][i] = matrix[i][0] = b.input(f"e{i}")
    program = b.program({"x": b.solve(matrix, [b.one] * size, symmetric=True)})
    written = expand_solves(program)
    assert_equal_solutions(program, written)
    assert written.counts()["divide"] == 2 * size - 1


@pytest.mark.parametrize("order", [(0, 1, 2, 3, 4), (3, 1, 4, 0, 2), (4, 3, 2, 1, 0)])
def test_a_triangle_of_rows_in_any_order_has_its_pivots(order: tuple[int, ...]) -> None:
    b, size = Builder(), len(order)
    rows = [[b.input(f"a{i}{j}") if j <= i else b.zero for j in range(size)] for i in range(size)]
    program = b.program({"x": b.solve([rows[i] for i in order], [b.one] * size)})
    assert_equal_solutions(program, expand_solves(program))


def test_bordered_systems_take_the_constraints_last() -> None:
    b = Builder()
    inertia = symmetric_matrix(b, 3)
    row = [b.zero, b.input("a"), b.input("c")]
    matrix = [[b.zero, *row]] + [[entry, *line] for entry, line in zip(row, inertia, strict=True)]
    program = b.program({"x": b.solve(matrix, [b.input(f"f{i}") for i in range(4)],
                                      symmetric=True)})  # fmt: skip
    assert_equal_solutions(program, expand_solves(program))
    # Where a = 0 the first mass has no part in the constraint, and its pivot has none either.
    values = dict.fromkeys(program.inputs, 0.25) | {"a": 0.0}
    found = interpret(expand_solves(program), Arrays(), values)["x"]
    assert np.isfinite(np.array(found, dtype=float)).all()


def general(b: Builder, size: int) -> Program:
    matrix = [[b.input(f"m{i}{j}") + 2 * (i == j) for j in range(size)] for i in range(size)]
    return b.program({"x": b.solve(matrix, [b.input(f"f{i}") for i in range(size)])})


@pytest.mark.parametrize("size", [1, 2, 3])
def test_up_to_three_rows_need_no_pivots(size: int) -> None:
    program = general(Builder(), size)
    assert_equal_solutions(program, expand_solves(program))


def test_four_rows_need_pivots_that_the_caller_knows() -> None:
    program = general(Builder(), 4)
    with pytest.raises(ExpressionError, match="4 rows needs pivots that are chosen at run time"):
        expand_solves(program)
    assert_equal_solutions(program, expand_solves(program, {0: [1, 0, 3, 2]}))
    with pytest.raises(ExpressionError, match="each of the 4 rows"):
        expand_solves(program, {0: [1, 1, 3, 2]})


def test_pivots_that_are_safe_by_structure_are_found() -> None:
    b = Builder()
    x, y, z = (b.input(name) for name in "xyz")
    zero, one = b.zero, b.one
    matrix = [
        [x, y, zero, one, y],
        [y, x, z, zero, x],
        [zero, z, x + 2, y, z],
        [zero, zero, zero, zero, z + 3],
        [one, y * y, x, zero, y],
    ]
    program = b.program({"x": b.solve(matrix, [x, y, z, one, x])})
    assert_equal_solutions(program, expand_solves(program))


@pytest.mark.parametrize("size", [2, 3])
def test_loops_are_solved_one_after_the_other(size: int) -> None:
    """Each block of rows holds columns of its own and those before, in any order of the rows."""
    b, count = Builder(), 4
    whole = size * count
    matrix = [
        [
            b.input(f"a{i}_{j}") + (3 if i == j else 0) if j // size <= i // size else b.zero
            for j in range(whole)
        ]
        for i in range(whole)
    ]
    rows = [(5 * i + 2) % whole if whole % 5 else i for i in range(whole)]
    assert sorted(rows) == list(range(whole))
    right = [b.input(f"f{i}") for i in range(whole)]
    program = b.program({"x": b.solve([matrix[i] for i in rows], right)})
    assert_equal_solutions(program, expand_solves(program))


def test_a_singular_system_is_refused() -> None:
    b = Builder()
    x = b.input("x")
    for symmetric in (True, False):
        program = b.program({"x": b.solve([[x, b.zero], [b.zero, b.zero]], [x, x],
                                          symmetric=symmetric)})  # fmt: skip
        with pytest.raises(ExpressionError, match="the pivot 0"):
            expand_solves(program)


def test_systems_of_numbers_become_numbers() -> None:
    b = Builder()
    numbers = [[b.constant(k) for k in row] for row in ((2, 1, 0), (1, 3, 1), (0, 5, 4))]
    program = b.program({"x": b.solve(numbers, [b.constant(k) for k in (3, 5, 9)])})
    assert expand_solves(program).constants == (Fraction(1),)
    assert determinant(numbers).constant == 10

"""Saddle-point systems: the solution of the whole system, without a division by what may be 0."""

from collections.abc import Callable

import numpy as np
import pytest

from mechanics.program import Builder
from mechanics.program.builder import Node
from mechanics.program.interpret import interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.program.saddle_point import solve_saddle_point


def solved(M: np.ndarray, A: np.ndarray, right: np.ndarray, nonzero: str) -> tuple[np.ndarray, int]:
    """The solution by a program of inputs, and its divisions; zeros are constants."""
    build = Builder()
    given: dict[str, float] = {}

    def node(name: str, value: float) -> Node:
        if value == 0:
            return build.zero
        given[name] = value
        return build.input(name)

    matrix = [[node(f"m{min(i, j)}{max(i, j)}", M[i, j]) for j in range(len(M))]
              for i in range(len(M))]  # fmt: skip
    rows = [[node(f"a{i}{j}", A[i, j]) for j in range(len(M))] for i in range(len(A))]
    sides = [node(f"r{i}", value) for i, value in enumerate(right)]
    safe = {build.input(name) for name in nonzero.split()}
    known: Callable[[Node], bool] = safe.__contains__
    program = build.program({"x": solve_saddle_point(matrix, rows, sides, known)})
    (x,) = interpret(program, Arrays(), given).values()
    return np.array(x, dtype=float), program.count


@pytest.mark.parametrize("nonzero", ["", "a00", "a00 a13", "a03 a10", "a00 a01 a02 a03 a10"])
def test_any_choice_of_pivots_gives_the_solution(nonzero: str) -> None:
    rng = np.random.default_rng(3)
    root = rng.normal(size=(5, 5))
    M, A, right = root @ root.T, rng.normal(size=(2, 5)), rng.normal(size=7)
    whole = np.block([[M, A.T], [A, np.zeros((2, 2))]])
    x, _ = solved(M, A, right, nonzero)
    np.testing.assert_allclose(x, np.linalg.solve(whole, right), rtol=1e-11)


def test_an_unknown_that_stands_in_one_constraint_alone_costs_little() -> None:
    """A wheel's rate: [0, I] in M, r in the condition of no slip."""
    rng = np.random.default_rng(4)
    root = rng.normal(size=(4, 4))
    M = np.zeros((5, 5))
    M[:4, :4], M[4, 4] = root @ root.T, 0.3
    A = np.array([[1.2, 0.0, 0.4, 0.0, 0.7], [0.3, 0.9, 0.0, 1.1, 0.0]])
    right = rng.normal(size=7)
    x, count = solved(M, A, right, "a04")
    y, more = solved(M, A, right, "")
    np.testing.assert_allclose(x, y, rtol=1e-11)
    assert count < more


def test_constraints_alone_are_solved_where_they_fix_everything() -> None:
    M, A = np.diag([2.0, 3.0]), np.array([[4.0, 0.0], [1.0, 5.0]])
    x, _ = solved(M, A, np.array([1.0, 1.0, 8.0, 12.0]), "a00 a11")
    np.testing.assert_allclose(x[:2], [2, 2])
    np.testing.assert_allclose(M @ x[:2] + A.T @ x[2:], [1, 1], atol=1e-13)

"""Linear systems solved by expressions: exactly right, and accurate in the units of the rows."""

import casadi as ca
import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics.compiled.forms.factor import solve_general, solve_symmetric
from mechanics.compiled.forms.order import backward_errors, candidates, pivot_order, solve
from mechanics.compiled.translate import Translator
from mechanics.errors import SingularError
from mechanics.symbolic import Arithmetic, decide

EXACT = Translator({}).exact


def symbols(n: int) -> tuple[sympy.Matrix, sympy.Matrix]:
    matrix = sympy.Matrix(n, n, lambda i, j: sympy.Symbol(f"a{max(i, j)}_{min(i, j)}"))
    return matrix, sympy.Matrix(n, 1, lambda i, _: sympy.Symbol(f"b{i}"))


def is_solution(n: int, symmetric: bool, orders: list) -> bool:
    matrix, rhs = symbols(n)
    if not symmetric:
        matrix = sympy.Matrix(n, n, lambda i, j: sympy.Symbol(f"a{i}_{j}"))
    a, b = ca.SX.sym("a", n, n), ca.SX.sym("b", n)
    solutions = (
        [solve_symmetric(a, b, EXACT)]
        if symmetric
        else [solve_general(a, b, o, EXACT) for o in orders]
    )
    function = ca.Function("f", [a, b], [ca.densify(x) for x in solutions])

    def experiment(e: Arithmetic) -> list:
        found = e.graph(function, symbols=[list(matrix.T), list(rhs)])
        return [
            (sum((e.value(matrix[i, j]) * x[j] for j in range(n)), e.rational(0)), e.value(rhs[i]))
            for x in found
            for i in range(n)
        ]

    return decide("K x = k", experiment).shown


@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_ldlt_solves(n: int) -> None:
    assert is_solution(n, True, [])


@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_elimination_solves_along_every_candidate_order(n: int) -> None:
    sample = np.random.default_rng(n).normal(size=(8, n, n))
    orders = list(candidates(sample))
    assert len(set(orders)) >= min(2, n)
    assert is_solution(n, False, orders[:12])


@settings(max_examples=50, deadline=None)
@given(st.integers(1, 6), st.integers(0, 10**6))
def test_expressions_and_the_trial_compute_the_same(n: int, seed: int) -> None:
    random = np.random.default_rng(seed)
    matrices, rhs = random.normal(size=(4, n, n)), random.normal(size=(4, n))
    order = pivot_order(matrices, rhs)
    a, b = ca.SX.sym("a", n, n), ca.SX.sym("b", n)
    function = ca.Function("f", [a, b], [solve_general(a, b, order, EXACT)])
    tried = solve(matrices, rhs, order)
    for k in range(4):
        assert np.allclose(function(matrices[k], rhs[k]).full().ravel(), tried[k], rtol=1e-6)


@settings(max_examples=100, deadline=None)
@given(st.integers(1, 6), st.integers(0, 10**6))
def test_ldlt_is_accurate_whatever_the_units_of_the_rows(n: int, seed: int) -> None:
    random = np.random.default_rng(seed)
    root = random.normal(size=(n, n)) + 2 * np.eye(n)
    units = 10.0 ** random.uniform(-6, 6, n)
    matrix = units[:, None] * (root @ root.T) * units
    rhs = units * 10.0 ** random.uniform(-6, 6) * random.normal(size=n)
    a, b = ca.SX.sym("a", n, n), ca.SX.sym("b", n)
    x = ca.Function("f", [a, b], [solve_symmetric(a, b, EXACT)])(matrix, rhs).full().ravel()
    residual = np.abs(matrix.astype(np.longdouble) @ x - rhs)
    scale = np.abs(matrix) @ np.abs(x) + np.abs(rhs)
    # Cancellation in x spreads over the rows in proportion to the diagonal, not to their terms.
    spread = np.sqrt(np.diag(matrix)) * (np.sqrt(np.diag(matrix)) @ np.abs(x))
    assert (residual / (np.maximum(scale, spread) * 2.0**-52)).max() < 16


def test_rows_added_up_along_a_chain_keep_their_accuracy() -> None:
    random = np.random.default_rng(0)
    root = random.normal(size=(64, 4, 4))
    symmetric = root @ root.swapaxes(1, 2) + np.eye(4)
    combined = np.triu(np.ones((4, 4))) * 10.0 ** np.arange(0, 8, 2) @ symmetric
    rhs = random.normal(size=(64, 4))
    assert backward_errors(combined, rhs, pivot_order(combined, rhs)).max() < 16


@pytest.mark.parametrize("n", [2, 5])
def test_a_pivot_that_vanishes_is_not_taken_first(n: int) -> None:
    random = np.random.default_rng(n)
    matrices = random.uniform(1, 2, size=(64, n, n))
    matrices[:, 0, 0] = matrices[:, -1, -1] = 1e-20
    rhs = random.normal(size=(64, n))
    order = pivot_order(matrices, rhs)
    assert order[0] not in {(0, 0), (n - 1, n - 1)}
    assert np.median(backward_errors(matrices, rhs, order)) < 16


def test_rows_in_any_sequence_are_matched_to_unknowns() -> None:
    matrices = np.zeros((8, 5, 5))
    shift = np.roll(np.arange(5), 2)
    matrices[:, np.arange(5), shift] = np.random.default_rng(1).uniform(1, 2, (8, 5))
    order = pivot_order(matrices, np.ones((8, 5)))
    assert {(row, column) for row, column in order} == {(i, int(shift[i])) for i in range(5)}


def test_a_singular_system_is_refused() -> None:
    with pytest.raises(SingularError, match="without mass or redundant constraints"):
        pivot_order(np.ones((4, 2, 2)), np.array([[1.0, 2.0]] * 4))


def test_numbers_are_eliminated_exactly() -> None:
    """Pivots of numbers alone: quotients that no double holds are constants by name."""
    translate = Translator({})
    matrix = sympy.Matrix([[3, 1, 0], [1, 7, 2], [0, 2, 981]])
    right = sympy.Matrix([sympy.Rational(1, 4), 2, 100])
    wanted = list(matrix.LUsolve(right))
    order = tuple((i, i) for i in reversed(range(3)))
    given = translate.matrix(matrix), translate.matrix(right)
    exact = translate.exact
    for found in (solve_symmetric(*given, exact), solve_general(*given, order, exact)):
        names = {str(graph): value for value, graph in translate.constants.items()}
        assert [names[str(found[i])] for i in range(3)] == wanted

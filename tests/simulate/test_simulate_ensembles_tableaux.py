"""Butcher's order conditions: sum of b_i phi_i(tree) = 1 / gamma(tree) for every rooted tree.

    phi_i(tree) = product over the branches of sum_j a_ij phi_j(branch)
    gamma(tree) = number of nodes times the product of gamma over the branches

Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, section II.2.
"""

import functools
from collections.abc import Iterator

import numpy as np
import pytest
from scipy.integrate import DOP853

from mechanics.compiled.step import Tableau
from mechanics.compiled.tableaus import TABLEAUX

Tree = tuple
"""The branches of the root, each a tree, in order."""
NUMBERS = (1, 1, 2, 4, 9, 20, 48, 115, 286)
"""Of rooted trees with 1 to 9 nodes."""


@functools.cache
def trees(nodes: int) -> tuple[Tree, ...]:
    return tuple(dict.fromkeys(tuple(sorted(forest)) for forest in forests(nodes - 1)))


def forests(nodes: int) -> Iterator[tuple[Tree, ...]]:
    if nodes == 0:
        yield ()
    for first in range(1, nodes + 1):
        for tree in trees(first):
            for rest in forests(nodes - first):
                yield (tree, *rest)


def size(tree: Tree) -> int:
    return 1 + sum(map(size, tree))


def density(tree: Tree) -> int:
    return size(tree) * int(np.prod([density(branch) for branch in tree], dtype=int))


def weights(tree: Tree, a: np.ndarray) -> np.ndarray:
    found = np.ones(len(a))
    for branch in tree:
        found *= a @ weights(branch, a)
    return found


def residuals(a: np.ndarray, b: np.ndarray, nodes: int) -> np.ndarray:
    return np.array([b @ weights(tree, a) - 1 / density(tree) for tree in trees(nodes)])


def square(tableau: Tableau) -> tuple[np.ndarray, np.ndarray]:
    a = np.zeros((len(tableau.a),) * 2)
    for i, row in enumerate(tableau.a):
        a[i, : len(row)] = [float(x) for x in row]
    return a, np.array([float(x) for x in tableau.b])


def test_trees_are_all_there() -> None:
    assert tuple(len(trees(nodes)) for nodes in range(1, 10)) == NUMBERS


@pytest.mark.parametrize("tableau", TABLEAUX, ids=[t.name for t in TABLEAUX])
def test_order_of_the_fixed_steps(tableau: Tableau) -> None:
    a, b = square(tableau)
    for nodes in range(1, tableau.order + 1):
        assert np.max(np.abs(residuals(a, b, nodes))) < 1e-14
    assert np.max(np.abs(residuals(a, b, tableau.order + 1))) > 1e-6


def test_errors_of_dop853_vanish_up_to_their_orders() -> None:
    """Differences from formulas of order 5 and 3: no term below that; the new slope is unused."""
    count = len(DOP853.B)
    a = DOP853.A[:count, :count]
    for weight, order in ((DOP853.E5, 5), (DOP853.E3, 3)):
        assert weight[count] == 0
        sums = [np.max(np.abs([weight[:count] @ weights(t, a) for t in trees(nodes)]))
                for nodes in range(1, order + 2)]  # fmt: skip
        assert max(sums[:order]) < 1e-14 and sums[order] > 1e-6


def test_what_is_between_the_ends_of_a_step_of_dop853_has_order_seven() -> None:
    """y(t + s h) by the seven coefficients, as `dop853.c` sums them, for every tree and some s."""
    stages = len(DOP853.B)
    a = np.zeros((16, 16))
    a[:stages, :stages] = DOP853.A[:stages, :stages]
    a[stages, :stages] = DOP853.B
    a[stages + 1 :, :] = np.pad(DOP853.A_EXTRA, ((0, 0), (0, 16 - DOP853.A_EXTRA.shape[1])))
    change = np.concatenate([DOP853.B, np.zeros(4)])
    begin, end = np.eye(16)[0], np.eye(16)[stages]
    rows = [change, begin - change, 2 * change - begin - end, *DOP853.D]
    for s in (0.2, 0.5, 0.9):
        b = np.zeros(16)
        for i in reversed(range(len(rows))):
            b = (b + rows[i]) * (1 - s if i % 2 else s)
        for nodes in range(1, 8):
            off = [b @ weights(t, a) - s**nodes / density(t) for t in trees(nodes)]
            assert np.max(np.abs(off)) < 1e-13

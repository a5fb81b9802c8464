"""At a random point of a field what is zero everywhere is zero, and what is not mostly is not."""

from fractions import Fraction

import pytest
import sympy as sp

from mechanics.kernel.field import Inadmissible
from mechanics.symbolic import Arithmetic

x, y, t = sp.symbols("x y t", real=True)
m, k = sp.symbols("m k", positive=True)

ZERO = [
    sp.sin(x + y / 3) - sp.sin(x) * sp.cos(y / 3) - sp.cos(x) * sp.sin(y / 3),
    sp.cos(2 * x * t) - 1 + 2 * sp.sin(x * t) ** 2,
    sp.sin(x + sp.pi / 4) * sp.sqrt(2) - sp.sin(x) - sp.cos(x),
    sp.cos(x + sp.pi / 7) - sp.cos(x) * sp.cos(sp.pi / 7) + sp.sin(x) * sp.sin(sp.pi / 7),
    sp.tan(x) * sp.cos(x) - sp.sin(x),
    sp.cosh(x) ** 2 - sp.sinh(x) ** 2 - 1,
    sp.exp(x + y) - sp.exp(x) * sp.exp(y),
    sp.exp(-x / 2) * sp.exp(x) - sp.exp(x / 2),
    sp.tanh(x) * sp.cosh(x) - sp.sinh(x),
    sp.sqrt(m * k, evaluate=False) - sp.sqrt(m) * sp.sqrt(k),
    sp.Abs(x - y) * sp.Abs(x) - sp.Abs(y - x) * sp.Abs(-x),
    sp.cos(x / m) ** 2 + sp.sin(x / m) ** 2 - 1,
    sp.Piecewise((x, x < y), (y, True)) - sp.Min(x, y),
]


@pytest.mark.parametrize("expression", ZERO, ids=str)
def test_what_is_zero_is_zero(expression):
    a = Arithmetic()
    assert a.is_zero(a.value(expression))
    assert not a.is_zero(a.value(expression + sp.sin(x) / 10**30))


def test_symbols_that_stand_for_sums_of_angles_are_expanded():
    a = Arithmetic()
    a.assign(t, a.value(x + 2 * y))
    assert a.is_zero(a.value(sp.sin(t) - sp.sin(x + 2 * y)))
    assert a.is_zero(a.value(sp.cos(t)) - a.value(sp.cos(x + 2 * y)))


def test_a_solution_solves_and_a_singular_matrix_has_none():
    a = Arithmetic()
    rows = [[a.value(m + k), a.value(x)], [a.value(x), a.value(m)]]
    first, second = a.solve(rows, [a.value(y), 1])
    assert a.is_zero(rows[0][0] * first + rows[0][1] * second - a.value(y))
    double = a.solve([rows[0], [2 * entry for entry in rows[0]]], [1, 1])
    with pytest.raises(Inadmissible, match="singular matrix"):
        a.residues(double)


def test_points_are_the_same_in_each_run():
    def residues():
        a = Arithmetic()
        return a.residues([a.value(sp.sin(x) + sp.log(y) + m), Fraction(1, 3)])

    (one, first), (two, second) = residues(), residues()
    assert one == two and first.prime == second.prime
    assert one[1] * 3 % first.prime == 1


def test_points_meet_conditions():
    a = Arithmetic()
    for factor in range(1, 7):
        a.require_positive(a.value(x + factor * y))
    (residue,), point = a.residues([a.value(x + 3 * y)])
    assert pow(residue, (point.prime - 1) // 2, point.prime) == 1


def test_ranks_and_rows():
    a = Arithmetic()
    rows = [[0, 0], [a.value(x), a.value(y)], [a.value(2 * x), a.value(2 * y)], [1, a.value(x)]]
    assert a.independent_rows(rows) == [1, 3] and a.rank(rows) == 2
    assert a.rank([]) == 0

"""Code is searched as it stands: what SymPy would put together stays apart.

k*(-2*x1 + x1)    x1 for x2, not a missing term beside -k*x1
"""

from typing import Any

import numpy as np
import pytest

import mechanics
from mechanics.blame.result import Edit, Mistake
from mechanics.claims.code.read import read_c, read_function
from mechanics.claims.code.trace.formulas import MOST_NODES, Known, added, leaf, multiplied
from mechanics.equations import Equations
from mechanics.judge.check import derived
from mechanics.kernel import Verdict
from systems import cartpole_friction, two_mass_chain

CHAIN = derived(two_mass_chain.scene())


def named(truth: Equations, thing: Any, place: int = 0, **options: Any) -> Edit:
    """The only edit of the first repair of a refuted statement."""
    entry = mechanics.check(truth, thing, **options).judged[place]
    assert entry.finding.verdict is Verdict.REFUTED
    assert entry.blame is not None
    assert entry.blame.repairs, entry.blame.searched
    (edit,) = entry.blame.repairs[0].edits
    return edit


def python(x1, x2, k, m):  # type: ignore[no-untyped-def]
    """The second x1 should be x2."""
    return [k * (-2 * x1 + x1) / (3 * m), -k * (x2 - x1) / (2 * m)]


def numpy_array(q, par):  # type: ignore[no-untyped-def]
    """The same with arrays."""
    k, m = par
    stiffness = k * np.array([[2, -1], [-1, 1]])
    return -stiffness @ np.array([q[0], q[0]]) / np.array([3 * m, 2 * m])


C = """void model(double x1, double x2, double k, double m, double out[2])
{
    out[0] = (-2.0 * k * x1 + k * x1) / (3.0 * m);
    out[1] = -k * (x2 - x1) / (2.0 * m);
}
"""


def test_a_symbol_in_python() -> None:
    edit = named(CHAIN, python)
    assert (edit.mistake, edit.written, edit.right) == (Mistake.SYMBOL, "x1", "x2")


def test_a_symbol_in_c() -> None:
    edit = named(CHAIN, C, notation="c")
    assert (edit.mistake, edit.written, edit.right) == (Mistake.SYMBOL, "x1", "x2")


def test_a_symbol_in_arrays() -> None:
    edit = named(CHAIN, numpy_array, names={"q": "x1 x2", "par": "k m"})
    assert (edit.mistake, edit.written, edit.right) == (Mistake.SYMBOL, "x1", "x2")


@pytest.mark.parametrize("place", [0, 1])
def test_formulas_stand_as_in_the_code(place: int) -> None:
    scene = two_mass_chain.scene()
    readings = read_function(scene, python), read_c(scene, C)
    for reading in readings:
        statement = reading.statements[place]
        assert statement.row is not None
        assert statement.written is not None
        (tree,) = statement.written.sides
        assert statement.written.builder()(tree) in statement.row.sides


def test_a_formula_used_over_and_over_is_left_to_its_expression() -> None:
    x = leaf(two_mass_chain.scene().q[0])
    assert isinstance(x, Known)
    known, counts = x, [x.count]
    while True:
        larger = added(known, multiplied(known, x))
        if larger is None:
            break
        known = larger
        counts.append(known.count)
    assert max(counts) <= MOST_NODES < 3 * max(counts)


BRANCH = """double residual(double theta, double theta_dot, double theta_ddot, double x_dot,
                double F, double m_c, double m_p, double l, double g, double mu_c)
{
    double N = (m_c + m_p)*g - m_p*l*(theta_ddot*sin(theta) + theta_dot*theta_dot*cos(theta));
    double friction = mu_c * N;
    if (x_dot < 0)
        friction = -friction;
        friction = 0.5 * friction;
    return (F + m_p*l*(theta_dot*theta_dot*sin(theta) - theta_ddot*cos(theta)) - friction)
           / (m_c + m_p);
}
"""


def test_a_term_that_is_zero_in_a_branch_is_mended_by_no_number() -> None:
    answer = mechanics.check(cartpole_friction.scene(), BRANCH, notation="c")
    assert answer.verdict is Verdict.REFUTED

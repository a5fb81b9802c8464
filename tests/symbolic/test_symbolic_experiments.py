"""Experiments: linear systems, assigned symbols, ranks and CasADi graphs over every arithmetic."""

from fractions import Fraction

import casadi as ca
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics.errors import ExpressionError
from mechanics.kernel import Verdict
from mechanics.symbolic import decide, generic_rank, independent_rows

x, y, q1, q2, u1, u2, g = sp.symbols("x y q1 q2 u1 u2 g", real=True)
m1, m2, l1, l2 = sp.symbols("m1 m2 l1 l2", positive=True)

MASS = [
    [(m1 + m2) * l1**2, m2 * l1 * l2 * sp.cos(q1 - q2)],
    [m2 * l1 * l2 * sp.cos(q1 - q2), m2 * l2**2],
]
FORCE = [
    -m2 * l1 * l2 * sp.sin(q1 - q2) * u2**2 - (m1 + m2) * g * l1 * sp.sin(q1),
    m2 * l1 * l2 * sp.sin(q1 - q2) * u1**2 - m2 * g * l2 * sp.sin(q2),
]


def accelerations(a):
    rows = [[a.value(entry) for entry in row] for row in MASS]
    return a.solve(rows, [a.value(entry) for entry in FORCE])


def jacobian(angle, length):
    return [length * sp.cos(angle), length * sp.sin(angle)]


def residuals(a, found, gravity=g):
    """Newton's law for both bobs, projected on their tangents."""
    symbols = sp.symbols("a1 a2")
    for symbol, number in zip(symbols, found, strict=True):
        a.assign(symbol, number)
    j1, j2 = jacobian(q1, l1), jacobian(q2, l2)
    c1 = [-l1 * sp.sin(q1) * u1**2, l1 * sp.cos(q1) * u1**2]
    c2 = [-l2 * sp.sin(q2) * u2**2, l2 * sp.cos(q2) * u2**2]
    first = [j1[i] * symbols[0] + c1[i] for i in (0, 1)]
    second = [first[i] + j2[i] * symbols[1] + c2[i] for i in (0, 1)]
    weight = [0, gravity]
    return [
        sum(m1 * j1[i] * (first[i] + weight[i]) + m2 * j1[i] * (second[i] + weight[i])
            for i in (0, 1)),
        sum(m2 * j2[i] * (second[i] + weight[i]) for i in (0, 1)),
    ]  # fmt: skip


def pendulum(a):
    return [(a.value(r), 0) for r in residuals(a, accelerations(a))]


def test_a_double_pendulum_two_ways_is_proved():
    assert decide("double pendulum", pendulum).verdict is Verdict.PROVED
    assert decide("double pendulum", pendulum, try_normal=False).verdict is Verdict.CERTIFIED


def test_a_changed_sign_is_refuted_with_a_complete_state():
    def turned(a):
        return [(a.value(r), 0) for r in residuals(a, accelerations(a), -g)]

    finding = decide("sign", turned)
    assert finding.verdict is Verdict.REFUTED
    assert {name for name, _ in finding.witness.state} == {
        "q1", "q2", "u1", "u2", "g", "m1", "m2", "l1", "l2"
    }  # fmt: skip
    lengths = {name: Fraction(value) for name, value in finding.witness.state if name[0] in "ml"}
    assert all(Fraction(1, 4) < value < 4 for value in lengths.values())


def test_a_singular_matrix_is_undecided():
    rows = [[x, 2 * x], [y, 2 * y]]
    finding = decide(
        "singular",
        lambda a: [(a.solve([[a.value(e) for e in row] for row in rows], [1, 1])[0], 0)],
    )
    assert finding.verdict is Verdict.UNDECIDED
    assert "singular matrix" in finding.evidence


@settings(max_examples=25, deadline=None)
@given(st.lists(st.lists(st.integers(-3, 3), min_size=3, max_size=3), min_size=3, max_size=3))
def test_solutions_solve(numbers):
    matrix = sp.Matrix(numbers) + sp.diag(5 * x + 11, 7 * y**2 + 12, 13)

    def experiment(a):
        rows = [[a.value(entry) for entry in matrix.row(i)] for i in range(3)]
        rhs = [a.value(x), 1, Fraction(1, 3)]
        found = a.solve(rows, rhs)
        return [
            (sum(entry * v for entry, v in zip(row, found, strict=True)), right)
            for row, right in zip(rows, rhs, strict=True)
        ]

    assert decide("solve", experiment).shown


def test_ranks_agree_in_all_arithmetics():
    matrix = [[x, y, x + y], [1, 2, 3], [x + 1, y + 2, x + y + 3]]
    finding = decide("rank", lambda a: [(a.rank([[a.value(e) for e in r] for r in matrix]), 2)])
    assert finding.verdict is Verdict.PROVED
    assert generic_rank([[sp.sympify(e) for e in row] for row in matrix]) == 2
    assert independent_rows([[sp.S.Zero] * 2, [x, y], [2 * x, 2 * y], [y, x]]) == [1, 3]


def test_mixing_with_rationals():
    def experiment(a):
        n = a.value(x)
        return [
            (sp.Rational(1, 3) * n + Fraction(2, 3) * n, n), (2 - n, -(n - 2)),
            (1 / n * n, 1), ((n + 1) ** 3, n**3 + 3 * n**2 + 3 * n + 1), (n**-2, 1 / (n * n)),
        ]  # fmt: skip

    assert decide("mixing", experiment).verdict is Verdict.PROVED


def test_floats_are_the_rationals_that_they_are():
    tenth = Fraction(0.1)
    assert decide("float", lambda a: [(a.value(x) * 0.1, a.value(x) * tenth)]).shown
    assert decide("tenth", lambda a: [(a.value(x) * 0.1, a.value(x / 10))]).witness is not None
    with pytest.raises(TypeError):
        decide("symbol", lambda a: [(a.value(x), x)])


def test_a_symbol_is_assigned_before_it_is_used():
    def late(a):
        a.value(x + 1)
        a.assign(x, 2)
        return [(a.value(x), 2)]

    with pytest.raises(ValueError, match="assign it before its first use"):
        decide("late", late)


def test_positive_quantities_may_be_required():
    def experiment(a):
        length = a.value(x - y)
        a.require_positive(length)
        return [(a.sqrt(length * length), length)]

    assert decide("positive", experiment, try_normal=False).shown
    turned = decide("negative", lambda a: [(l, -r) for l, r in experiment(a)], try_normal=False)
    assert turned.verdict is Verdict.REFUTED


def graph_pairs(function, symbols, expressions):
    def experiment(a):
        outputs = a.graph(function, symbols=symbols)
        return [
            (left, a.value(right))
            for group, wanted in zip(outputs, expressions, strict=True)
            for left, right in zip(group, wanted, strict=True)
        ]

    return experiment


s = ca.SX.sym("s", 3)
THREE = [[x, y, m1]]
GRAPHS = {
    "arithmetic": ((s[0] + s[1]) * s[2] - s[0] / s[2], (x + y) * m1 - x / m1),
    "powers": (s[0] ** 3 + s[2] ** 2.5 + s[2] ** -0.5 + ca.sqrt(s[2]),
               x**3 + m1 ** sp.Rational(5, 2) + 1 / sp.sqrt(m1) + sp.sqrt(m1)),
    "square": (s[0] * s[0] + 2 * s[0] - (-s[1]), x**2 + 2 * x + y),
    "angles": (ca.sin(s[0] / 2 + 3 * (s[1] - s[0])), sp.sin(3 * y - sp.Rational(5, 2) * x)),
    "products": (ca.cos((s[0] + s[1]) * s[2]), sp.cos(x * m1) * sp.cos(y * m1)
                 - sp.sin(x * m1) * sp.sin(y * m1)),
    "tangent": (ca.tan(s[0] + 1) * ca.cos(s[0] + 1), sp.sin(x + 1)),
    "nonlinear": (ca.sin(s[0] / s[2]), sp.sin(x / m1)),
    "cases": (ca.fmax(s[0], s[1]) + ca.fabs(s[0]) * ca.sign(s[0]), sp.Max(x, y) + x),
    "choice": (ca.if_else(s[0] < s[1], s[0], s[1]), sp.Piecewise((x, x < y), (y, True))),
    "functions": (ca.exp(s[0] + s[1]) + ca.log(s[2]) + ca.atan2(s[0], s[1]) + ca.atan(s[0]),
                  sp.exp(x) * sp.exp(y) + sp.log(m1) + sp.atan2(x, y) + sp.atan(x)),
    "hyperbolic": (ca.sinh(s[0]) + ca.cosh(s[0]) + ca.tanh(s[1]), sp.exp(x) + sp.tanh(y)),
    "arcs": (ca.asin(s[0] / 4) + ca.acos(s[0] / 4) + ca.hypot(s[0], s[1]),
             sp.asin(x / 4) + sp.acos(x / 4) + sp.sqrt(x**2 + y**2)),
    "doubles": (s[0] * 0.1, x * sp.Rational(*(0.1).as_integer_ratio())),
}  # fmt: skip


@pytest.mark.parametrize("name", GRAPHS)
def test_graphs_equal_their_expressions(name):
    graph, expr = GRAPHS[name]
    function = ca.Function("f", [s], [graph])
    assert decide(name, graph_pairs(function, THREE, [[expr]])).shown
    wrong = ca.Function("f", [s], [graph + 2 * s[0]])
    assert decide(name, graph_pairs(wrong, THREE, [[expr]])).verdict is Verdict.REFUTED


def test_sparse_inputs_and_outputs_are_dense_columns():
    pattern = ca.Sparsity.lower(2)
    matrix = ca.SX.sym("M", pattern)
    out = ca.SX(2, 2)
    out[1, 0] = matrix[1, 0] * matrix[0, 0]
    function = ca.Function("f", [matrix], [out])
    result = graph_pairs(function, [[x, y, g, u1]], [[0, x * y, 0, 0]])
    assert decide("sparse", result).verdict is Verdict.PROVED


def test_graphs_name_what_they_cannot_do():
    with pytest.raises(ExpressionError, match="OP_REMAINDER"):
        function = ca.Function("f", [s], [ca.remainder(s[0], s[1])])
        decide("remainder", graph_pairs(function, THREE, [[x]]))
    with pytest.raises(ExpressionError, match="3 entries, 2 found"):
        decide("short", graph_pairs(ca.Function("f", [s], [s[0]]), [[x, y]], [[x]]))
    with pytest.raises(ExpressionError, match="1 inputs, 2 groups"):
        decide("groups", graph_pairs(ca.Function("f", [s], [s[0]]), [[x, y, g], [x]], [[x]]))
    m = ca.MX.sym("m")
    hidden = ca.rootfinder("f", "newton", ca.Function("g", [m], [m**2 - 2]))
    with pytest.raises(ExpressionError, match="OP_CALL is not supported"):
        decide("mx", graph_pairs(hidden, [[x]], [[x]]))
    with pytest.raises(ExpressionError, match="no exact value"):
        decide("inf", graph_pairs(ca.Function("f", [s], [s[0] + ca.inf]), THREE, [[x]]))

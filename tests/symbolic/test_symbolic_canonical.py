"""Laws of the canonical form: equal to what it came from, the same when taken twice."""

from time import process_time

import mpmath
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics.errors import ExpressionError
from mechanics.kernel.ring import TooLarge
from mechanics.symbolic import canonical, collect_linear

x, y, z = sp.symbols("x y z", real=True)
a, L = sp.symbols("a L", positive=True)

KNOWN = [
    (sp.sin(x) ** 2 * y + sp.cos(x) ** 2 * y, y),
    ((x + y) ** 2 - x**2 - 2 * x * y, y**2),
    (L / sp.cos(x) * sp.cos(x) ** 2, L * sp.cos(x)),
    (sp.tan(x) * sp.cos(x), sp.sin(x)),
    (sp.sin(x) ** 2 / sp.cos(x) ** 2 + 1, sp.cos(x) ** -2),
    (sp.sin(x) ** 4, sp.sin(x) ** 4),
    (sp.cos(x) ** 4, sp.cos(x) ** 4),
    (sp.sin(2 * (x + y)) ** 2 * a + a * sp.cos(2 * x + 2 * y) ** 2, a),
    (sp.sqrt(x**2 + y**2) ** 2, x**2 + y**2),
    (sp.Abs(x * (y + 1)) - sp.Abs(x * y + x), 0),
    (sp.Float(0.5) * x, x / 2),
    (y * (x + sp.Abs(y)) ** 2 - 2 * x * y * sp.Abs(y), y**3 + x**2 * y),
    (sp.S.Zero, 0),
    (x, x),
]

LEAVES = [x, y, a, sp.sin(x), sp.cos(x), sp.sin(x + y), sp.cos(x + y), sp.tan(y), 1 / sp.cos(x),
          1 / sp.sin(x), 1 / L, sp.sqrt(a + 1), sp.sqrt(L), 1 / (a + L), sp.exp(x * y), sp.Abs(y),
          sp.pi, sp.sqrt(2)]  # fmt: skip
EXPRESSIONS = st.recursive(
    st.sampled_from(LEAVES)
    | st.fractions(-3, 3, max_denominator=9).map(lambda q: sp.Rational(q.numerator, q.denominator)),
    lambda parts: (
        st.tuples(parts, parts).map(lambda p: p[0] + p[1])
        | st.tuples(parts, parts).map(lambda p: p[0] * p[1])
        | parts.map(lambda p: p**2)
    ),
    max_leaves=10,
)
STATE = {x: sp.Rational(7, 10), y: sp.Rational(-13, 10), a: sp.Rational(9, 5), L: sp.Rational(5, 4)}


@pytest.mark.parametrize(("expr", "wanted"), KNOWN, ids=str)
def test_known_forms(expr, wanted):
    assert canonical(expr) == wanted


@settings(max_examples=120, deadline=None)
@given(EXPRESSIONS)
def test_canonical_is_equal_and_idempotent(expr):
    form = canonical(expr)
    assert canonical(form) == form
    with mpmath.workdps(60):
        before, after = (mpmath.mpf(sp.N(e.subs(STATE), 60)) for e in (expr, form))
        assert abs(before - after) <= mpmath.mpf(10) ** -40 * (1 + abs(before))


@settings(max_examples=60, deadline=None)
@given(EXPRESSIONS)
def test_the_result_is_a_proper_sympy_object(expr):
    form = canonical(expr)
    for node in sp.preorder_traversal(form):
        if isinstance(node, sp.Add | sp.Mul):
            assert node == node.func(*node.args)
            assert hash(node) == hash(node.func(*node.args))


@settings(max_examples=60, deadline=None)
@given(EXPRESSIONS, EXPRESSIONS, EXPRESSIONS)
def test_linear_parts_are_collected(p, q, r):
    u, v = sp.symbols("u v")
    coefficients, rest = collect_linear(p * u + q * (v - 2 * u) + r, [u, v])
    assert coefficients == [canonical(p - 2 * q), canonical(q)]
    assert rest == canonical(r)


def test_linearity_is_checked():
    u = sp.Symbol("u")
    for expr in (u**2 + x, sp.sin(u), 1 / u, sp.Abs(u) + 1):
        with pytest.raises(ExpressionError, match="is not linear in u"):
            collect_linear(expr, [u])
    assert collect_linear(u**2 - u * (u - x), [u]) == ([x], 0)
    assert collect_linear(x, [u]) == ([0], x)


def test_infinity_is_no_expression():
    with pytest.raises(ExpressionError, match="zoo"):
        canonical(sp.zoo + x)
    with pytest.raises(ExpressionError, match="identically zero"):
        canonical(1 / sp.Add(sp.sin(x) ** 2, sp.cos(x) ** 2, -1))


def test_what_is_too_large_says_so():
    symbols = sp.symbols("s0:40")
    with pytest.raises(TooLarge):
        canonical(sp.Add(*symbols) ** 9)


def test_the_moment_of_a_long_chain_is_quick() -> None:
    n = 12
    q, u, w = (sp.symbols(f"{name}1:{n + 1}", real=True) for name in "quw")
    m, lengths = (sp.symbols(f"{name}1:{n + 1}", positive=True) for name in "ml")
    px = py = ax = ay = total = sp.S.Zero
    for i in range(n):
        px, py = px + lengths[i] * sp.sin(q[i]), py - lengths[i] * sp.cos(q[i])
        ax += lengths[i] * (w[i] * sp.cos(q[i]) - u[i] ** 2 * sp.sin(q[i]))
        ay += lengths[i] * (w[i] * sp.sin(q[i]) + u[i] ** 2 * sp.cos(q[i]))
        total += m[i] * (px * ay - py * ax)
    start = process_time()
    coefficients, rest = collect_linear(total, w)
    # Of the processor: a busy machine fails nothing.
    assert process_time() - start < 5
    assert len(coefficients) == n
    assert not rest.free_symbols & set(w)

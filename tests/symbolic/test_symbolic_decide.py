"""Laws of `decide`: true statements are shown, false ones refuted by a witness that holds."""

import mpmath
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics.errors import ExpressionError
from mechanics.kernel import Finding, Verdict
from mechanics.kernel.field import Inadmissible
from mechanics.symbolic import decide, is_zero, prove_equal, prove_zero

x, y, z = sp.symbols("x y z", real=True)
a, b, L = sp.symbols("a b L", positive=True)
f = sp.Function("f")

TRUE = [
    (sp.sin(2 * x), 2 * sp.sin(x) * sp.cos(x)),
    (sp.sin(x / 2) ** 2, (1 - sp.cos(x)) / 2),
    (sp.sin(x + y), sp.sin(x) * sp.cos(y) + sp.cos(x) * sp.sin(y)),
    (sp.cos(3 * x / 4 - y), sp.cos(y - 3 * x / 4)),
    (sp.cos(x / 3), 4 * sp.cos(x / 9) ** 3 - 3 * sp.cos(x / 9)),
    (sp.sin(x * (y + z)), sp.sin(x * y + x * z)),
    (sp.sin(x + sp.pi / 4), (sp.sin(x) + sp.cos(x)) / sp.sqrt(2)),
    (sp.tan(x) ** 2 + 1, sp.sec(x) ** 2),
    (sp.cot(x) * sp.tan(x), sp.sin(x) * sp.csc(x)),
    (x + sp.sin(x) ** 2, x + 1 - sp.cos(x) ** 2),
    (sp.sqrt(a * b, evaluate=False), sp.sqrt(a) * sp.sqrt(b)),
    (sp.Pow(L**2, sp.S.Half, evaluate=False), L),
    (sp.Pow(4 * L**2 * a, sp.S.Half, evaluate=False), 2 * L * sp.sqrt(a)),
    (sp.sqrt(x**2 + y**2) ** 2, x**2 + y**2),
    (1 / sp.sqrt(a + b), sp.sqrt(a + b) / (a + b)),
    (sp.cbrt(a * b, evaluate=False), sp.cbrt(a) * sp.cbrt(b)),
    (sp.sqrt(sp.sqrt(a) * b), a ** sp.Rational(1, 4) * sp.sqrt(b)),
    (sp.sqrt(11) * sp.sqrt(13), sp.sqrt(143)),
    (sp.Pow((x**2 + 1) ** 2, sp.S.Half, evaluate=False), x**2 + 1),
    (sp.sqrt(x**2 - 2 * x * y + y**2), sp.Abs(x - y)),
    (sp.Abs(x * y), sp.Abs(x) * sp.Abs(y)),
    (sp.Abs(x) * sp.sign(x), x),
    (sp.Max(x, y) + sp.Min(x, y), x + y),
    (sp.Piecewise((x, x < y), (y, True)), sp.Min(x, y)),
    (sp.exp(x + y), sp.exp(x) * sp.exp(y)),
    (sp.cosh(x) ** 2 - sp.sinh(x) ** 2, sp.S.One),
    (f(sp.sin(x) ** 2 + sp.cos(x) ** 2, y), f(1, y)),
    (sp.atan2(x * (x + 1), y), sp.atan2(x**2 + x, y)),
    (sp.pi * (x + 1), sp.pi * x + sp.pi),
    (0.5 * x, x / 2),
    ((x**2 - y**2) / (x - y), x + y),
]

FALSE = [
    (sp.sin(x), x),
    (sp.sin(2 * x), 2 * sp.sin(x)),
    (x, x * (1 + sp.Rational(1, 10**40))),
    (sp.pi * x, sp.Rational(22, 7) * x),
    (0.1 * x, x / 10),
    (sp.sqrt(x**2 - 2 * x * y + y**2), x - y),
    (sp.Abs(x), x),
    (sp.sqrt(1 - sp.sin(x) ** 2), sp.cos(x)),
    (sp.sqrt(a + b), sp.sqrt(a) + sp.sqrt(b)),
    (sp.atan(x), x),
    (sp.Max(x, y), x),
    (sp.Piecewise((x, x < y), (y, True)), sp.Max(x, y)),
    (sp.cbrt(a), sp.sqrt(a)),
]


@pytest.mark.parametrize(("left", "right"), TRUE, ids=str)
def test_true_statements_are_shown(left, right):
    finding = prove_equal("law", left, right)
    assert finding.shown, finding


@pytest.mark.parametrize(("left", "right"), TRUE, ids=str)
def test_without_the_normal_form_nothing_true_is_refuted(left, right):
    finding = prove_equal("law", left, right, try_normal=False)
    if finding.verdict is Verdict.PROVED:
        assert finding.evidence == "both sides are the same expression"
        return
    assert finding.verdict in (Verdict.CERTIFIED, Verdict.UNDECIDED)
    if finding.verdict is Verdict.CERTIFIED:
        assert 0 < finding.error_bound <= 2.0**-80


@pytest.mark.parametrize(("left", "right"), FALSE, ids=str)
def test_false_statements_are_refuted_by_a_witness_that_holds(left, right):
    finding = prove_equal("law", left, right)
    assert finding.verdict is Verdict.REFUTED, finding
    # evaluated by another library, far beyond the precision of the difference
    state = {sp.Symbol(name, real=True): sp.Rational(v) for name, v in finding.witness.state}
    state |= {sp.Symbol(name, positive=True): v for s, v in state.items() for name in [s.name]}
    with mpmath.workdps(120):
        exact = [
            side.xreplace(
                {v: sp.Rational(*float(v).as_integer_ratio()) for v in side.atoms(sp.Float)}
            )
            for side in (left, right)
        ]
        sides = [mpmath.mpf(sp.N(side.subs(state), 120)) for side in exact]
        assert abs(sides[0] - sides[1]) > mpmath.mpf(10) ** -60
        for side, words in zip(sides, (finding.witness.left, finding.witness.right), strict=True):
            middle, _, radius = words.strip("[]").partition(" +/- ")
            assert abs(side - mpmath.mpf(middle)) <= mpmath.mpf(radius or 0) + mpmath.mpf(10) ** -90


POLYNOMIALS = st.recursive(
    st.sampled_from([x, y, a, sp.sin(x), sp.cos(x), sp.sin(x + y), sp.cos(y / 2), sp.sqrt(a)])
    | st.fractions(-3, 3, max_denominator=9).map(lambda q: sp.Rational(q.numerator, q.denominator)),
    lambda parts: (
        st.tuples(parts, parts).map(lambda p: p[0] + p[1])
        | st.tuples(parts, parts).map(lambda p: p[0] * p[1])
    ),
    max_leaves=8,
)


@pytest.mark.campaign
@settings(max_examples=40, deadline=None)
@given(POLYNOMIALS, POLYNOMIALS)
def test_squares_of_sums(p, q):
    assert prove_equal("square", (p + q) ** 2, p**2 + 2 * p * q + q**2).shown


@pytest.mark.campaign
@settings(max_examples=40, deadline=None)
@given(POLYNOMIALS, st.integers(1, 10**30))
def test_a_tiny_difference_is_refuted(p, size):
    finding = prove_equal("perturbed", p, p + sp.Rational(1, size))
    assert finding.verdict is Verdict.REFUTED


@settings(max_examples=30, deadline=None)
@given(st.fractions(-4, 4, max_denominator=12), st.fractions(-4, 4, max_denominator=12))
def test_angles_add_by_the_group_law(m, n):
    m, n = (sp.Rational(q.numerator, q.denominator) for q in (m, n))
    total = sp.cos(m * x) * sp.cos(n * x) - sp.sin(m * x) * sp.sin(n * x)
    assert prove_equal("cos of a sum", sp.cos((m + n) * x), total).shown


def test_a_symbol_may_stand_bare_and_under_a_sine():
    assert prove_equal("both", (x + sp.sin(x)) ** 2 - x**2, sp.sin(x) * (2 * x + sp.sin(x))).shown
    assert prove_zero("independent", x - sp.sin(x)).verdict is Verdict.REFUTED


def test_findings_are_the_same_in_each_run():
    first, second = (prove_zero("zero", sp.sin(x) - x) for _ in range(2))
    assert first == second


def test_matrices_are_compared_entry_by_entry():
    matrix = sp.Matrix([[x, y], [sp.sin(x), 1]])
    assert prove_equal("matrix", matrix, matrix.T.T).verdict is Verdict.PROVED
    assert prove_equal("matrix", matrix, matrix.T).verdict is Verdict.REFUTED


def test_nothing_to_compare_is_no_success():
    with pytest.raises(ValueError, match="nothing to compare"):
        decide("empty", lambda a: [])
    with pytest.raises(ValueError, match="nothing to compare"):
        prove_equal("empty", [], [])
    with pytest.raises(ValueError, match="1 entries on the left, 2 on the right"):
        prove_equal("uneven", [x], [x, y])


def test_targets_are_probabilities():
    with pytest.raises(ValueError, match="no probability"):
        decide("target", lambda a: [(1, 1)], target=0)


def test_an_unknown_operation_is_named():
    with pytest.raises(ExpressionError, match="gamma"):
        prove_zero("gamma", sp.gamma(x) - x)
    with pytest.raises(ExpressionError, match="ImaginaryUnit"):
        prove_zero("i", sp.I * x)


def test_what_is_true_for_a_reason_unknown_here_is_undecided_and_names_the_operation():
    finding = prove_equal("inverse", sp.log(sp.exp(x) * (x + 1)), x + sp.log(x + 1))
    assert finding.verdict is Verdict.UNDECIDED
    assert "log" in finding.evidence


def test_division_by_zero_everywhere_is_undecided():
    finding = decide("0/0", lambda a: [(1 / (a.value(x) - a.value(x)), a.value(x))])
    assert finding.verdict is Verdict.UNDECIDED
    assert "division by zero" in finding.evidence


def test_an_experiment_that_admits_no_point_is_undecided():
    def hopeless(a):
        raise Inadmissible("negative length")

    finding = decide("hopeless", hopeless)
    assert finding.verdict is Verdict.UNDECIDED
    assert "negative length" in finding.evidence


def test_is_zero_has_three_answers():
    assert is_zero(sp.sin(x) ** 2 + sp.cos(x) ** 2 - 1) is True
    assert is_zero(sp.sin(x)) is False
    assert is_zero(sp.Integer(0)) is True
    assert is_zero(sp.log(sp.exp(x) * (x + 1)) - x - sp.log(x + 1)) is None


def test_a_finding_has_no_truth_value():
    with pytest.raises(TypeError, match="no truth value"):
        bool(Finding("s", Verdict.PROVED, "e"))

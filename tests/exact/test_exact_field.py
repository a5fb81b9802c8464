"""The field: primes as asked for, bounds that hold, congruence, roots."""

import random
from itertools import pairwise
from math import log2

import pytest
import sympy as sp
from flint import fmpz
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics.errors import ExpressionError
from mechanics.exact import Verdict, field_trial, prove_equal
from mechanics.exact.field import FieldArithmetic
from mechanics.exact.field_size import Memory
from mechanics.exact.field_trial import Answer, trial
from mechanics.exact.primes import MODULUS, TOTIENT, draw_prime, log2_count
from mechanics.exact.signals import DivisionHere, Inadmissible, Restart

x, y = sp.symbols("x y", real=True)
a, b = sp.symbols("a b", positive=True)


def field(seed=1, bits=127, **options):
    source = random.Random(seed)
    return FieldArithmetic(draw_prime(bits, source), source, Memory(), **options)


@pytest.mark.parametrize("bits", [64, 127, 255])
def test_primes_have_the_form_that_makes_roots_positive(bits):
    p = draw_prime(bits, random.Random(bits))
    assert fmpz(p).is_prime()
    assert p.bit_length() == bits
    assert p % MODULUS == MODULUS - 1
    for q in (2, 3, 5, 7):
        assert pow(q, (p - 1) // 2, p) == 1
    for q in (3, 5, 7):
        assert (p - 1) % q != 0
    assert pow(-1, (p - 1) // 2, p) == p - 1


def test_the_count_of_primes_is_a_lower_bound_of_the_right_size():
    assert sum(1 for n in range(MODULUS) if fmpz(n).gcd(MODULUS) == 1) == TOTIENT
    for bits in (64, 127, 521):
        expected = bits - 1 - log2(bits * 0.6931) - log2(TOTIENT)
        assert expected - 0.2 < log2_count(bits) < expected + 0.2
    with pytest.raises(ValueError, match="64 or more"):
        draw_prime(40, random.Random(1))


def degrees(expr):
    f = field()
    number = f.value(expr)
    return number.numerator, number.denominator


@given(st.integers(1, 6), st.integers(1, 6), st.integers(1, 6))
def test_bounds_are_not_below_the_true_degrees(i, j, k):
    expr = (x**i + y**j) ** k / (x + y + 1) ** j + x
    top, bottom = sp.fraction(sp.together(expr))
    n, d = degrees(expr)
    assert n >= sp.Poly(top, x, y).total_degree()
    assert d >= sp.Poly(bottom, x, y).total_degree()


def test_degrees_of_sums_over_one_denominator_stay_small():
    r = 1 / (x + y)
    assert degrees(sum(sp.Symbol(f"c{i}") * r for i in range(50))) == (1, 1)


@settings(max_examples=30, deadline=None)
@given(st.lists(st.lists(st.integers(0, 3), min_size=3, max_size=3), min_size=3, max_size=3))
def test_cramers_bound(powers):
    f = field()
    rows = [[x**p + i * y + 1 + j for j, p in enumerate(row)] for i, row in enumerate(powers)]
    determinant = sp.Poly(sp.Matrix(rows).det(), x, y)
    if determinant.is_zero:
        return
    found = f.solve([[f.value(e) for e in row] for row in rows], [1, f.value(x), 2])
    assert all(number.denominator >= determinant.total_degree() for number in found)
    assert all(number.token == found[0].token for number in found)


def test_a_low_degree_falsehood_is_seen_as_often_as_the_bound_says():
    """In a small field the zeros of (x - 1)...(x - 9) are met with a chance of at most 9/p."""
    source, hits, p = random.Random(3), 0, 839
    product = sp.Mul(*(x - i for i in range(1, 10)))
    for _ in range(4000):
        f = FieldArithmetic(p, source, Memory())
        hits += f.value(product).residue == 0
    assert hits / 4000 < 2 * 9 / p


def test_a_trigonometric_falsehood_has_at_most_twice_its_degree_of_zeros():
    """On the circle of a small field: cos(3 t) = 1/2 has at most 6 solutions among p points."""
    source, hits, p = random.Random(4), 0, 839
    expr = sp.cos(3 * x) - sp.Rational(1, 2)
    for _ in range(4000):
        hits += FieldArithmetic(p, source, Memory()).value(expr).residue == 0
    assert hits / 4000 < 2 * 2 * 3 / p


def test_points_lie_on_the_circle_and_angles_on_finer_bases():
    f = field()
    c, s = f.value(sp.cos(x)), f.value(sp.sin(x))
    assert (c * c + s * s - 1).residue == 0
    with pytest.raises(Restart):
        f.value(sp.cos(x / 2))
    finer = FieldArithmetic(f.prime, random.Random(2), f.memory)
    assert (2 * finer.value(sp.cos(x / 2)) ** 2 - 1 - finer.value(sp.cos(x))).residue == 0


def test_roots_are_squares_and_radicands_that_are_none_ask_for_another_point():
    seen = set()
    for seed in range(20):
        f = field(seed)
        try:
            w = f.value(sp.sqrt(x**2 + y))
        except Inadmissible:
            seen.add("redrawn")
            continue
        seen.add("found")
        assert pow(w.residue, (f.prime - 1) // 2, f.prime) == 1
        assert (w * w - f.value(x**2 + y)).residue == 0
    assert seen == {"redrawn", "found"}


def test_roots_of_degrees_that_do_not_exist_are_known_by_congruence():
    assert prove_equal("root", a ** sp.Rational(1, 11), a).verdict is Verdict.REFUTED
    with pytest.raises(ExpressionError, match="1/11"):
        field().value(a ** sp.Rational(1, 11))


def test_equal_arguments_have_equal_values():
    f = field()
    g = sp.Function("g")
    same = f.value(g((x + y) ** 2)), f.value(g(x**2 + 2 * x * y + y**2))
    assert same[0].residue == same[1].residue
    assert f.value(g(x)).residue != f.value(g(y)).residue
    assert list(f.memory.opaque) == ["function g"]


def test_division_by_zero_asks_for_another_point():
    f = field()
    with pytest.raises(DivisionHere):
        f.rational(1) / (f.value(x) - f.value(x))


def test_an_ambiguous_root_is_looked_at_many_times():
    root = sp.Pow(a * a, sp.S.Half, evaluate=False)
    found = trial(lambda f: [(f.value(root), f.value(a))], -80)
    assert found.answer is Answer.ZERO
    assert "82 random points" in found.words
    assert found.log2_bound < -80


def test_trials_end_after_counted_numbers(monkeypatch):
    runs = []

    def nowhere(f):
        for _ in range(100):
            f.value(x) + 1
        runs.append(f.value(x).residue)
        raise Inadmissible("not here")

    counts = []
    for numbers in (1000, 1000, 10_000):
        runs.clear()
        monkeypatch.setattr(field_trial, "MOST_NUMBERS", numbers)
        assert trial(nowhere, -80).answer is Answer.FAILED
        counts.append(tuple(runs))
    assert counts[0] == counts[1] == counts[2][: len(counts[0])], "the same points in each run"
    assert len(counts[0]) < len(counts[2]) < field_trial.DRAWS


def test_many_roots_need_one_point_only():
    points = sp.symbols("p0:7", real=True)
    total = sum(sp.sqrt((p - q) ** 2 + 1) for p, q in pairwise(points))
    square = sp.expand(total**2)
    finding = prove_equal("springs", total**2, square, try_normal=False)
    assert finding.verdict is Verdict.CERTIFIED
    assert "a random point" in finding.evidence
    wrong = prove_equal("springs", total**2, square + points[0] / 10**9, try_normal=False)
    assert wrong.verdict is Verdict.REFUTED


@pytest.mark.parametrize("k", range(1, 31))
def test_a_wrong_sign_of_an_ambiguous_root_never_passes(k):
    root = sp.sqrt(x**2 - 2 * k * x * y + k**2 * y**2)
    finding = prove_equal("sign", root, x - k * y, try_normal=False)
    assert finding.verdict is Verdict.REFUTED

"""The field: primes as asked for, bounds that hold, congruence, roots, points of the circle."""

import re
from fractions import Fraction
from itertools import pairwise
from math import log, log2

import pytest
import sympy as sp
from flint import fmpz
from hypothesis import given, settings
from hypothesis import strategies as st

from mechanics.kernel import Range, Statement, Verdict, decide
from mechanics.kernel.angles import is_cut
from mechanics.kernel.draws import Draws
from mechanics.kernel.field import DivisionHere, Inadmissible, Residues
from mechanics.kernel.primes import (
    LARGEST_MODULUS,
    MODULUS,
    common_modulus,
    draw_prime,
    log2_count,
)
from mechanics.kernel.sizes import Size, Sizes, determinant_size, is_algebraic
from mechanics.kernel.trial import (
    HOPELESS,
    MOST_DRAWS,
    Answer,
    FailedError,
    Session,
    log2_bound,
    log2_sum,
    prepare,
    trial,
    zeros,
)
from mechanics.program import Builder, Node, interpret

SMALL = 839
"""A prime that is -1 modulo 840: small enough to count misses."""


def prime(bits: int = 127, modulus: int = MODULUS, seed: str = "test") -> int:
    return draw_prime(bits, modulus, Draws(seed))


def values(nodes: list[Node], domain: object, **inputs: object) -> tuple:
    program = nodes[0].builder.program({"value": nodes})
    return interpret(program, domain, inputs)["value"]


# ---------------------------------------------------------------------- draws and primes


def test_draws_are_a_function_of_the_seed() -> None:
    first, second = Draws("a", "b"), Draws("a", "b")
    assert [first.below(1000) for _ in range(50)] == [second.below(1000) for _ in range(50)]
    assert Draws("ab").bits(128) != Draws("a", "b").bits(128)


def test_draws_are_uniform_and_long() -> None:
    draws = Draws("uniform")
    counts = [0] * 7
    for _ in range(7000):
        counts[draws.below(7)] += 1
    assert all(880 < count < 1120 for count in counts)
    assert draws.below(1) == 0
    assert {draws.bits(1) for _ in range(64)} == {0, 1}
    assert draws.bits(100_000).bit_length() > 99_900


@pytest.mark.parametrize("bits", [64, 127, 255])
def test_primes_have_the_form_that_makes_roots_positive(bits: int) -> None:
    p = prime(bits)
    assert fmpz(p).is_prime()
    assert p.bit_length() == bits
    assert p % MODULUS == MODULUS - 1
    for q in (2, 3, 5, 7):
        assert pow(q, (p - 1) // 2, p) == 1
    for q in (3, 5, 7):
        assert (p - 1) % q != 0
    assert pow(-1, (p - 1) // 2, p) == p - 1


def test_primes_have_points_for_the_multiples_of_pi() -> None:
    assert common_modulus([Fraction(1, 420)]) == MODULUS
    assert common_modulus([Fraction(3, 11)]) == 9240
    assert common_modulus([Fraction(1, 8), Fraction(1, 9)]) % (2 * 72) == 0
    assert common_modulus([Fraction(1, 11), Fraction(1, 13)]) == 9240 <= LARGEST_MODULUS
    p = prime(127, 9240)
    assert (p + 1) % 9240 == 0


def test_the_count_of_primes_is_a_lower_bound_of_the_right_size() -> None:
    totient = sum(1 for n in range(MODULUS) if fmpz(n).gcd(MODULUS) == 1)
    for bits in (64, 127, 521):
        expected = bits - 1 - log2(bits * 0.6931) - log2(totient)
        assert expected - 0.2 < log2_count(bits) < expected + 0.01
    assert log2_count(127, 9240) < log2_count(127)
    with pytest.raises(ValueError, match="64 or more"):
        prime(63)


@pytest.mark.parametrize("bits", [64, 127])
def test_the_count_of_primes_is_that_of_the_counting_bound(bits: int) -> None:
    """|theta(x; m, -1) - x / phi(m)| < x / (160 log x) at both ends, over the largest logarithm."""
    phi = int(fmpz(MODULUS).euler_phi())
    ends = [(2.0**b, b * log(2)) for b in (bits, bits - 1)]
    (high, error), (low, other) = ((x / phi, x / (160 * width)) for x, width in ends)
    expected = log2((high - low - error - other) / ends[0][1])
    assert log2_count(bits) == pytest.approx(expected, abs=1e-12)


# ---------------------------------------------------------------------- the error bound


def test_the_bound_is_that_of_equation_1() -> None:
    bits, degree, height = 127, 1000.0, 5000.0
    zeros_share = 2 * degree / 2 ** (bits - 2)
    primes_share = height / (bits - 1) / 2 ** log2_count(bits)
    expected = log2(MOST_DRAWS) + 3 + log2(zeros_share + primes_share)
    assert log2_bound(bits, MODULUS, degree, height, 3.0) == pytest.approx(expected, abs=1e-9)
    assert log2_sum(-3.0, -5.0) == log2_sum(-5.0, -3.0) == pytest.approx(log2(2**-3 + 2**-5))
    assert log2_sum(-5000.0, -3.0) == -3.0


def misses(nodes: list[Node], known: Range = Range.FREE, times: int = 10000) -> float:
    """How often something that is not zero everywhere is zero in a field of 839 elements."""
    draws, hits = Draws("misses"), 0
    program = nodes[0].builder.program({"value": nodes})
    for _ in range(times):
        domain = Residues(SMALL, MODULUS, draws)
        inputs = {name: domain.input(known) for name in program.inputs}
        hits += all(v % SMALL == 0 for v in interpret(program, domain, inputs)["value"])
    return hits / times


def share(nodes: list[Node]) -> float:
    """First term of equation (1) for one point of that field."""
    domain = Sizes()
    program = nodes[0].builder.program({"value": nodes})
    inputs = {name: domain.variable() for name in program.inputs}
    degree, _ = domain.total(interpret(program, domain, inputs)["value"])
    return 2 * degree / ((SMALL - 1) / 2)


@pytest.mark.campaign
def test_a_low_degree_falsehood_is_met_as_often_as_the_bound_says() -> None:
    """(x - 1)(x - 4)...(x - 81) has 9 zeros among the 838 residues, and among the 419 squares."""
    b = Builder()
    x, product = b.input("x"), b.one
    for i in range(1, 10):
        product = product * (x - i * i)
    assert misses([product], times=20000) == pytest.approx(9 / 838, rel=0.3)
    assert misses([product], Range.POSITIVE) == pytest.approx(9 / 419, rel=0.3)
    assert misses([product], Range.POSITIVE) < share([product]) < 4 * 9 / 419


@pytest.mark.campaign
def test_a_trigonometric_falsehood_has_at_most_twice_its_degree_of_zeros() -> None:
    """A cubic in the cosine: at most six points."""
    b = Builder()
    c, s = b.input("x").cos(), b.input("x").sin()
    cube = 4 * c * c * c - 3 * c - Fraction(4, 5)
    assert misses([cube]) < share([cube])
    assert share([c * s]) == pytest.approx(2 * (2 + 2) / 419, rel=0.01)


@pytest.mark.campaign
def test_what_is_looked_up_counts() -> None:
    """log(x**9) = log(1) wherever x**9 = 1: congruence meets by chance."""
    b = Builder()
    x = b.input("x")
    number = (x * x * x * x * x * x * x + 1).log() - (x + 1).log()
    assert 0 < misses([number]) < share([number])
    domain = Sizes()
    plain = domain.total([domain.variable()])[0]
    domain.operations["log"](domain.variable())
    assert domain.total([domain.variable()])[0] > plain


def test_an_ambiguous_root_passes_at_half_of_all_points() -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    wrong = ((x - y) * (x - y)).sqrt() - (x - y)
    assert misses([wrong], times=1000) == pytest.approx(1 / 2, abs=0.06)
    two = abs(x) - x + 2 * (abs(y) - y)
    draws, hits = Draws("signs"), 0
    program = b.program({"value": [two]})
    for _ in range(1000):
        domain = Residues(SMALL, MODULUS, draws, signs=True)
        inputs = {name: domain.input(Range.FREE) for name in program.inputs}
        hits += interpret(program, domain, inputs)["value"][0] % SMALL == 0
    assert hits / 1000 == pytest.approx(1 / 4, abs=0.06)


PASSES = {
    "one root": (lambda r, s, x, y: r - x, 1, 1 / 2),
    "two, each for itself": (lambda r, s, x, y: r + 2 * s - x - 2 * y, 2, 1 / 4),
    "their product": (lambda r, s, x, y: r * s - x * y, 2, 1 / 2),
    "false for one choice of four": (lambda r, s, x, y: (r + x) * (s + y), 2, 3 / 4),
    "false where neither is the other": (lambda r, s, x, y: r * y - s * x, 2, 1 / 2),
}
"""What is zero for some signs of r = +-x and s = +-y, for how many roots, and how often."""


@pytest.mark.parametrize("name", PASSES)
def test_falsehoods_pass_as_often_as_is_known_and_no_oftener_than_equation_2_says(
    name: str,
) -> None:
    falsehood, roots, chance = PASSES[name]
    b = Builder()
    x, y = b.input("x"), b.input("y")
    difference = falsehood(
        hidden_square(x).sqrt(), hidden_square(y).sqrt(), 1 / (x + 1), 1 / (y + 1)
    )
    draws, hits, drawn = Draws(name), 0, 0
    program = b.program({"value": [difference]})
    while drawn < 2000:
        domain = Residues(SMALL, MODULUS, draws)
        inputs = {name: domain.input(Range.FREE) for name in program.inputs}
        try:
            (value,) = interpret(program, domain, inputs)["value"]
        except Inadmissible:
            continue
        drawn, hits = drawn + 1, hits + (value % SMALL == 0)
    assert hits / drawn == pytest.approx(chance, abs=0.05)
    assert chance <= 1 - 2.0**-roots
    claim = Statement(name, b.program({"left": [difference], "right": [b.zero]}))
    session = Session(prepare(claim))
    _, first = session.point()
    assert session.unsure(first) == roots
    assert decide(claim).verdict is Verdict.REFUTED


@pytest.mark.campaign
@pytest.mark.sample(2)
@pytest.mark.parametrize("target", [2.0**-10, 2.0**-40, 2.0**-80])
@pytest.mark.parametrize("count", [1, 2, 3])
def test_the_printed_bound_is_that_of_so_many_points(target: float, count: int) -> None:
    """(1 - 2^-s)^k and the chance of equation (1): not less, and not above the target."""
    b = Builder()
    names = [b.input(f"x{i}") for i in range(count)]
    outputs = {
        "left": [hidden_square(x).sqrt() for x in names],
        "right": [1 / (x + 1) for x in names],
        "positive": [x + 1 for x in names],
    }
    outcome = trial(Statement("roots", b.program(outputs), target=target), lambda: False)
    points = int(re.search(r"at (\d+) random points", outcome.words)[1])
    survival = points * log2(1 - 2.0**-count)
    assert survival <= outcome.log2_bound <= log2(target)
    assert outcome.log2_bound < survival + 0.01


def hidden_square(x: Node) -> Node:
    """A square that is none of a polynomial."""
    b = x.builder
    return 1 / ((x + b.one) * (x + b.one))


def test_points_are_repeated_until_equation_2_is_met() -> None:
    b = Builder()
    a = b.input("a")
    outputs = {"left": [hidden_square(a).sqrt()], "right": [1 / (a + 1)], "positive": [a + 1]}
    claim = Statement("1/|a + 1| = 1/(a + 1)", b.program(outputs))
    outcome = trial(claim, lambda: False)
    assert outcome.answer is Answer.ZERO
    assert "82 random points" in outcome.words
    assert -83 < outcome.log2_bound < -80
    loose = Statement("as before", claim.program, target=2.0**-20)
    assert "22 random points" in trial(loose, lambda: False).words
    assert not trial(claim, lambda: False).off_boundaries


def test_a_proof_makes_more_points_needless() -> None:
    b = Builder()
    a = b.input("a")
    claim = Statement("|a| = a", b.program({"left": [(a * a).sqrt()], "right": [a]}),
                      {"a": Range.POSITIVE})  # fmt: skip
    assert trial(claim, lambda: True).answer is Answer.PROVED


def test_many_roots_that_are_no_squares_need_one_point_only() -> None:
    b = Builder()
    points = [b.input(f"p{i}") for i in range(7)]
    total = b.zero
    for p, q in pairwise(points):
        total = total + ((p - q) * (p - q) + 1).sqrt()
    program = b.program({"left": [total * total * total], "right": [(total * total) * total]})
    half = b.program({"left": [total * total], "right": [total * (total / 2) + total * total / 2]})
    outcome = trial(Statement("springs", half), lambda: False)
    assert outcome.answer is Answer.ZERO
    assert "a random point" in outcome.words
    assert prepare(Statement("springs", program)).log2_bound < -81
    wrong = b.program({"left": [total * total], "right": [total * total + points[0] / 10**9]})
    assert decide(Statement("springs", wrong)).verdict is Verdict.REFUTED


def test_what_divides_by_zero_everywhere_is_given_up_after_a_few_points() -> None:
    b = Builder()
    x = b.input("x")
    nothing = 1 / (x.sin() * x.sin() + x.cos() * x.cos() - 1)
    session = Session(prepare(Statement("1/0", b.program({"left": [nothing], "right": [x]}))))
    with pytest.raises(FailedError, match=f"at every one of {HOPELESS} points"):
        session.point()
    assert session._steps == HOPELESS * len(session.experiment.program)


def test_roots_are_counted_from_the_first_that_is_unsure() -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")

    def unsure(*radicands: Node) -> int:
        roots = [r.sqrt() for r in radicands]
        session = Session(prepare(Statement("roots", b.program({"left": roots, "right": roots}))))
        zero, first = session.point()
        assert all(zero)
        return session.unsure(first)

    assert unsure(x * x + y) == 0
    assert unsure(x * x + y, x * x - y) == 0
    assert unsure((x + y) * (x + y)) == 0
    assert unsure(hidden_square(x)) == 1
    assert unsure(x * x + y, hidden_square(x + y)) == 1
    # The second of three: sqrt(x y) exists where sqrt(x) and sqrt(y) do.
    assert unsure(x, y, x * y) == 1


@pytest.mark.parametrize(("times", "bits"), [(22, 127), (24, 255), (86, 255), (88, 383)])
def test_primes_are_long_enough_for_the_characters_of_roots(times: int, bits: int) -> None:
    """Weil's bound leaves 2^-30 where the root of the prime exceeds the degree by 40 bits."""
    b = Builder()
    x = b.input("x")
    root = (x * x + 1).sqrt()
    sides = {"left": [tower_node(x, times) + root], "right": [root + tower_node(x, times) * 1]}
    plain = {"left": [tower_node(x, 22)], "right": [x]}
    assert prepare(Statement("plain", b.program(plain))).bits == 127
    assert prepare(Statement("roots", b.program(sides))).bits == bits


def test_the_prime_grows_with_the_degree_and_ends() -> None:
    b = Builder()
    x = b.input("x")

    def tower(times: int) -> Statement:
        power = x
        for _ in range(times):
            power = power * power
        return Statement(
            "tower", b.program({"left": [power + x * x], "right": [x * x + power * 1]})
        )

    high = prepare(Statement("high", b.program({"left": [x], "right": [x + 1]})))
    assert high.bits == 127
    assert prepare(tower(70)).bits == 255
    assert prepare(tower(70)).log2_bound <= -81
    with pytest.raises(FailedError, match="degree bound"):
        prepare(tower(4000))
    assert trial(Statement("beyond", b.program({"left": [tower_node(x, 2000)], "right": [x]})),
                 lambda: False).answer is Answer.FAILED  # fmt: skip


def tower_node(x: Node, times: int) -> Node:
    for _ in range(times):
        x = x * x
    return x


# ---------------------------------------------------------------------- sizes

x, y = sp.symbols("x y")


def sizes_of(build) -> Size:
    b = Builder()
    domain = Sizes()
    return values([build(b.input("x"), b.input("y"))], domain,
                  x=domain.variable(), y=domain.variable())[0]  # fmt: skip


@pytest.mark.campaign
@given(st.integers(1, 6), st.integers(1, 6), st.integers(1, 6))
def test_bounds_are_not_below_the_true_degrees_and_heights(i: int, j: int, k: int) -> None:
    def build(x, y):
        return (x**i + y**j) ** k / (x + y + 1) ** j + 3 * x

    top, bottom = sp.fraction(sp.together(build(x, y)))
    size = sizes_of(build)
    assert size.numerator >= sp.Poly(top, x, y).total_degree()
    assert size.denominator >= sp.Poly(bottom, x, y).total_degree()
    largest = max(map(abs, sp.Poly(sp.expand(top), x, y).coeffs()))
    assert size.height >= log2(largest)


def test_sizes_follow_their_equations() -> None:
    d = Sizes()
    add, multiply, divide = (d.operations[n] for n in ("add", "multiply", "divide"))
    u, v = Size(3, 0, 5, 0), Size(7, 0, 2, 0)
    assert (multiply(u, v).numerator, multiply(u, v).height) == (10, 7)
    assert (add(u, v).numerator, add(u, v).height) == (7, 8)
    r = divide(u, v)
    assert (r.numerator, r.denominator, r.height) == (3, 7, 7)
    # Over one denominator, then over two, then with a polynomial.
    assert divide(u, v).token == r.token != 0
    assert (add(r, divide(v, v)).numerator, add(r, divide(v, v)).denominator) == (7, 7)
    other = divide(u, u)
    assert (add(r, other).numerator, add(r, other).denominator) == (10, 10)
    assert add(r, other).token == multiply(other, r).token != r.token
    assert (add(r, v).numerator, add(r, v).denominator, add(r, v).token) == (14, 7, r.token)
    assert (add(v, r).numerator, add(v, r).denominator, add(v, r).token) == (14, 7, r.token)
    assert divide(u, d.constant(Fraction(2))).token == 0
    assert d.constant(Fraction(-8, 3)).height == 3
    root = d.operations["sqrt"](Size(4, 2, 6, 5))
    assert (root.numerator, root.denominator, root.height, root.token) == (3, 2, 6, 5)
    assert d.log2_conjugates == 1
    cube = d.operations["power"](Size(4, 2, 6, 5), d.constant(Fraction(-5, 3)))
    assert (cube.numerator, cube.denominator) == pytest.approx((10, 5 * (4 + 2 * 2) / 3))
    assert cube.height == 30
    assert d.log2_conjugates == 1 + log2(3)
    assert d.operations["power"](Size(4, 0, 6, 0), d.constant(Fraction(2))).token == 0
    square = d.operations["power"](Size(4, 2, 6, 5), d.constant(Fraction(2)))
    assert square.token not in (0, 5, cube.token)
    assert d.operations["sin"](u).numerator == d.operations["sin"](u).height == 1
    u.inverse = None
    first, again = (d.solve([[u]], [v], False)[0] for _ in range(2))
    assert 0 != first.token != again.token != 0
    assert d.solve([[d.constant(Fraction(2))]], [d.constant(Fraction(3))], True)[0].token == 0
    size = d.operations["abs"](Size(4, 2, 6, 5))
    assert (size.numerator, size.denominator, size.height, size.token) == (4, 2, 6, 5)
    assert d.operations["abs"](d.constant(Fraction(3))).numerator == 1
    choice = d.operations["select"](d.variable(), u, v)
    assert choice.numerator == 8


def test_degrees_of_sums_over_one_denominator_stay_small() -> None:
    b = Builder()
    r = 1 / (b.input("x") + b.input("y"))
    total = b.zero
    for i in range(50):
        total = total + b.input(f"c{i}") * r
    domain = Sizes()
    program = b.program({"value": [total]})
    size = interpret(program, domain, {n: domain.variable() for n in program.inputs})["value"][0]
    assert (size.numerator, size.denominator) == (1, 1)


@settings(max_examples=30, deadline=None)
@given(st.lists(st.lists(st.integers(0, 3), min_size=3, max_size=3), min_size=3, max_size=3))
def test_cramers_bound(powers: list[list[int]]) -> None:
    b = Builder()

    def rows(x, y):
        return [[x**p + i * y + 1 + j for j, p in enumerate(r)] for i, r in enumerate(powers)]

    determinant = sp.Poly(sp.Matrix(rows(x, y)).det(), x, y)
    domain = Sizes()
    u, v = b.input("x"), b.input("y")
    solution = b.solve(rows(u, v), [1, u, 2])
    found = values(list(solution), domain, x=domain.variable(), y=domain.variable())
    assert all(size.denominator >= determinant.total_degree() for size in found)
    assert all(size.token == found[0].token for size in found)
    if not determinant.is_zero:
        assert all(size.height >= log2(max(map(abs, determinant.coeffs()))) for size in found)


def test_minors_have_their_rows_cleared_of_denominators() -> None:
    rows = [[Size(2, 1, 3, 4), Size(5, 1, 1, 4)], [Size(1, 2, 0, 7), Size(1, 0, 0, 0)]]
    assert determinant_size(rows) == (5 + 3, 4 + 0 + 2)
    assert determinant_size([]) == (0, 0)


def test_powers_that_are_made_of_roots() -> None:
    assert [is_algebraic(Fraction(*p)) for p in ((1, 2), (5, 12), (-3, 64), (4096, 1))] == [
        True
    ] * 4
    assert [is_algebraic(Fraction(*p)) for p in ((1, 11), (1, 128), (4097, 1), (1, 65))] == [
        False
    ] * 4


def test_two_that_are_looked_up_meet_with_the_size_of_their_difference() -> None:
    """N1 D2 - N2 D1 of two operands of one height, and as often as it is looked up."""
    domain = Sizes()
    total = domain.operations["add"](domain.variable(), domain.variable())
    assert (total.numerator, total.denominator, total.height) == (1, 0, 1)
    for count in (1, 2, 3):
        domain.operations["exp"](total)
        degree, height = domain.total([])
        assert degree == pytest.approx(count, rel=0.002)
        assert height == pytest.approx(count * (2 * 1 + 1), rel=0.002)
        assert height >= count * (2 * 1 + 1)


# ---------------------------------------------------------------------- residues


def field(seed: str = "field", **options: object) -> Residues:
    modulus = options.pop("modulus", MODULUS)
    return Residues(prime(127, modulus), modulus, Draws(seed), **options)


def test_positive_inputs_are_positive_where_ranks_are_taken() -> None:
    b = Builder()
    names = [f"a{k}" for k in range(8)]
    nodes = [(b.input(name) * b.input(name)).sqrt() - b.input(name) for name in names]
    assert zeros(b, nodes, dict.fromkeys(names, Range.POSITIVE)) == [True] * 8
    assert zeros(b, nodes, {}) != [True] * 8


def test_points_lie_on_the_circle_and_opposite_angles_are_opposite_points() -> None:
    f = field()
    sin, cos = f.operations["sin"], f.operations["cos"]
    a = f.input(Range.FREE)
    assert (cos(a) ** 2 + sin(a) ** 2) % f.prime == 1
    assert cos(-a) == cos(a) == cos(a + f.prime)
    assert (sin(-a) + sin(a)) % f.prime == 0
    assert (cos(0), sin(0)) == (1, 0)


def test_a_multiple_of_pi_that_the_prime_has_not_is_an_angle_like_any() -> None:
    """pi / 8 needs a point of order 16; a circle of a multiple of 9240 points need not have any."""
    f = field(turns=[Fraction(1, 8)], modulus=9240)
    angle = f.pi() * pow(8, -1, f.prime)
    c, s = f.operations["cos"](angle), f.operations["sin"](angle)
    power = (1, 0)
    for _ in range(9240):
        power = (power[0] * c - power[1] * s) % f.prime, (power[1] * c + power[0] * s) % f.prime
    assert power != (1, 0)


@pytest.mark.parametrize(("n", "modulus"), [(5, 840), (12, 840), (420, 840), (11, 9240)])
def test_multiples_of_pi_have_their_order_and_go_with_the_roots(n: int, modulus: int) -> None:
    turns = [Fraction(k, n) for k in (1, 2)]
    f = field(turns=turns, modulus=modulus)
    p = f.prime

    def point(k: int) -> tuple[int, int]:
        angle = f.pi() * k * pow(n, -1, p)
        return f.operations["cos"](angle), f.operations["sin"](angle)

    (c, s), double = point(1), point(2)
    assert ((c * c - s * s - double[0]) % p, (2 * s * c - double[1]) % p) == (0, 0)
    power, order = (c, s), 1
    while power != (1, 0):
        power = (power[0] * c - power[1] * s) % p, (power[1] * c + power[0] * s) % p
        order += 1
    assert order == 2 * n
    if n == 12:
        assert (2 * double[0] - f.operations["sqrt"](f.constant(Fraction(3)))) % p == 0
    if n == 5:
        assert (4 * c - 1 - f.operations["sqrt"](f.constant(Fraction(5)))) % p == 0


@pytest.mark.parametrize("seed", range(8))
def test_multiples_of_pi_go_with_all_roots_at_any_prime(seed: int) -> None:
    pairs = (1, 2), (1, 4), (1, 6), (1, 5), (1, 7), (2, 7), (3, 7), (1, 10), (1, 14)
    turns = [Fraction(*turn) for turn in pairs]
    p = prime(127, seed=str(seed))
    f = Residues(p, MODULUS, Draws(str(seed)), turns)
    root = {n: f.operations["sqrt"](f.constant(Fraction(n))) for n in (2, 3, 5, 7)}

    def at(name: str, k: int, n: int) -> int:
        return f.operations[name](f.pi() * k * pow(n, -1, p))

    assert (2 * at("cos", 1, 4) - root[2]) % p == 0
    assert (2 * at("cos", 1, 6) - root[3]) % p == 0
    assert (4 * at("cos", 1, 5) - 1 - root[5]) % p == 0
    sines = at("sin", 1, 7) * at("sin", 2, 7) * at("sin", 3, 7)
    assert (8 * sines - root[7]) % p == 0
    # The sine of an angle is the cosine of what is missing to a quarter turn.
    assert at("sin", 1, 2) == 1
    assert (2 * at("sin", 1, 6) - 1) % p == 0
    assert (4 * at("sin", 1, 10) * at("cos", 1, 5) - 1) % p == 0
    assert (8 * at("sin", 1, 14) * at("cos", 1, 7) * at("cos", 2, 7) - 1) % p == 0


def test_roots_are_squares_and_radicands_that_are_none_ask_for_another_point() -> None:
    seen = set()
    for seed in range(20):
        f = field(str(seed))
        radicand = f.input(Range.FREE)
        try:
            w = f.operations["sqrt"](radicand)
        except Inadmissible:
            seen.add("redrawn")
            assert f.not_square == 0
            continue
        seen.add("root")
        assert f.not_square is None
        assert pow(w, (f.prime - 1) // 2, f.prime) == 1
        assert (w * w - radicand) % f.prime == 0
    assert seen == {"redrawn", "root"}


@pytest.mark.parametrize("k", [3, 5, 7])
@pytest.mark.parametrize("squares", [True, False])
def test_odd_roots_are_roots_at_every_residue_of_a_probe(k: int, squares: bool) -> None:
    for seed in range(8):
        f = field(str(seed), squares=squares)
        radicand = f.input(Range.POSITIVE if squares else Range.FREE)
        w = f.operations["power"](radicand, f.constant(Fraction(1, k)))
        assert pow(w, k, f.prime) == radicand


def test_surds_are_principal_and_multiply() -> None:
    f = field()
    sqrt, p = f.operations["sqrt"], f.prime
    for q in (Fraction(2), Fraction(12), Fraction(9, 4), Fraction(5, 7), Fraction(210)):
        w = sqrt(f.constant(q))
        assert (w * w - f.constant(q)) % p == 0
        assert pow(w, (p - 1) // 2, p) == 1
    assert f.square_roots == 0
    other = next(
        g for g in (Residues(prime(seed=str(k)), MODULUS, Draws("s")) for k in range(40))
        if pow(11, (g.prime - 1) // 2, g.prime) == 1
    )  # fmt: skip
    w = other.operations["sqrt"](other.constant(Fraction(99, 4)))
    assert (4 * w * w - 99) % other.prime == 0 != w
    assert other.square_roots == 1
    with pytest.raises(Inadmissible):
        sqrt(f.constant(Fraction(-2)))
    assert sqrt(0) == 0


def test_ranges_are_squares_and_minus_squares() -> None:
    f, probe = field(), field(squares=False)

    def characters(domain: Residues, known: Range) -> set[int]:
        half = (domain.prime - 1) // 2
        return {pow(domain.input(known), half, domain.prime) for _ in range(30)}

    minus = f.prime - 1
    assert characters(f, Range.POSITIVE) == characters(f, Range.NONNEGATIVE) == {1}
    assert characters(f, Range.NEGATIVE) == {minus}
    assert characters(f, Range.FREE) == {1, minus}
    assert characters(probe, Range.POSITIVE) == {1, probe.prime - 1}
    f.positive(4)
    with pytest.raises(Inadmissible, match="positive"):
        f.positive(-4)
    probe.positive(-4)


def test_equal_arguments_have_equal_values_and_odd_functions_are_odd() -> None:
    f = field()
    a, b = f.input(Range.FREE), f.input(Range.FREE)
    for name in ("log", "acos", "floor", "exp", "acosh"):
        function = f.operations[name]
        assert function(a) == function(a + f.prime) != function(b)
    for name in ("asin", "atan", "asinh", "atanh", "erf"):
        function = f.operations[name]
        assert (function(a) + function(-a)) % f.prime == 0 != function(a)
        assert function(f.prime) == 0
    assert f.operations["atan2"](a, b) != f.operations["atan2"](b, a)
    assert f.operations["exp"](0) == 1
    assert f.operations["log"](1) == 0
    assert f.operations["floor"](f.constant(Fraction(-7, 2))) == f.constant(Fraction(-4))


def test_comparisons_and_absolute_values() -> None:
    for f in (field(), field(signs=True)):
        a, b, p = f.input(Range.FREE), f.input(Range.FREE), f.prime
        o = f.operations
        assert o["abs"](a) == o["abs"](-a) != 0
        assert (o["sign"](a) * a - o["abs"](a)) % p == 0
        assert o["abs"](0) == o["sign"](0) == 0
        assert (o["less"](a, b) + o["not_greater"](b, a)) % p == 1
        assert (o["less"](a, a), o["not_greater"](a, a), o["equal"](a, a)) == (0, 1, 1)
        assert o["equal"](a, b) == o["equal"](b, a)
        assert o["select"](1, a, b) == a % p
        assert o["select"](0, a, b) == b % p
        h, g = o["less"](a, b), o["less"](b, 0)
        assert (o["and"](h, g) + o["or"](h, g) - h - g) % p == 0
        assert o["not"](1) == 0
    assert len(f.kinks) == 3


def test_division_by_zero_and_singular_matrices_ask_for_another_point() -> None:
    f = field()
    with pytest.raises(DivisionHere, match="division"):
        f.operations["divide"](1, f.prime)
    with pytest.raises(DivisionHere, match="singular"):
        f.solve([[1, 2], [2, 4]], [1, 1], True)
    with pytest.raises(DivisionHere):
        f.operations["power"](0, f.constant(Fraction(-1, 2)))
    with pytest.raises(DivisionHere, match="denominator"):
        Residues(SMALL, MODULUS, Draws("x")).constant(Fraction(1, SMALL))
    assert f.solve([[2, 0], [1, 1]], [4, 5], False) == [2, 3]


# ---------------------------------------------------------------------- independence


def test_zeros_and_pivots_are_found() -> None:
    b = Builder()
    u, v = b.input("x"), b.input("y")
    assert zeros(b, [u - u, u * v, b.pi], {}) == [True, False, False]
    singular = b.solve([[u, u], [u, u]], [1, 1])
    with pytest.raises(FailedError, match="singular matrix"):
        zeros(b, singular, {})


def test_a_budget_that_does_not_suffice_is_said() -> None:
    b = Builder()
    squares = [hidden_square(b.input(f"x{i}") * b.input(f"y{i}")).sqrt() for i in range(9)]
    total = sum(squares, b.zero)
    claim = Statement("nine", b.program({"left": [total * total], "right": [total * (total + 0)]}))
    with pytest.raises(FailedError, match="signs of 9 roots"):
        Session(prepare(claim)).outcome(lambda: False)


def test_an_argument_too_long_to_be_expanded_has_one_value_however_it_is_written() -> None:
    b = Builder()
    one, two = ([b.input(f"{name}{i}") for i in range(12)] for name in "xy")
    product = sum(one, b.zero) * sum(two, b.zero)
    terms = sum((x * y for x in one for y in two), b.zero)
    for function in ("sin", "cos", "exp"):
        sides = {"left": [b.call(function, product)], "right": [b.call(function, terms)]}
        assert decide(Statement("long", b.program(sides)), try_normal=False).shown
        sides["right"] = [b.call(function, terms + one[0])]
        wrong = decide(Statement("long", b.program(sides)), try_normal=False)
        assert wrong.verdict is Verdict.REFUTED


def test_an_argument_that_grows_too_long_has_one_value_too() -> None:
    """Sines of sums inside an argument are products of sines: it grows as it is rewritten."""
    b = Builder()
    turned = sum((b.input(f"a{i}") for i in range(4)), b.zero)
    x, y, s, c = b.input("x"), b.input("y"), turned.sin(), turned.cos()
    product, terms = (s + x) * (c + y), s * c + s * y + x * c + x * y
    assert not is_cut(b.program({"sin": [product.sin(), terms.sin()]}))
    for function in ("sin", "cos", "exp"):
        sides = {"left": [b.call(function, product)], "right": [b.call(function, terms)]}
        assert decide(Statement("grown", b.program(sides)), try_normal=False).shown
        sides["right"] = [b.call(function, terms + x)]
        wrong = decide(Statement("grown", b.program(sides)), try_normal=False)
        assert wrong.verdict is Verdict.REFUTED

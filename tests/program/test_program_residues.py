"""Values of nodes at one point of a field: what is equal there, what is not, ranks."""

from fractions import Fraction

import pytest

from mechanics.program import Builder, Node
from mechanics.program.residues import (
    PRIME,
    Residues,
    _denominator,
    _part,
    _times,
    eliminate,
)

B = Builder()
X, Y, Z = (B.input(name) for name in "xyz")
THIRD = Fraction(1, 3)

EQUAL = {
    "a product": ((X + Y) * (X - Y), X * X - Y * Y),
    "a quotient": (X / Y + Y / X, (X * X + Y * Y) / (X * Y)),
    "numbers": (B.constant(Fraction(2, 3)) * X + X / 3, X),
    "a sum of angles": ((X + Y).sin(), X.sin() * Y.cos() + X.cos() * Y.sin()),
    "a difference of angles": ((X - Y).cos(), X.cos() * Y.cos() + X.sin() * Y.sin()),
    "the sine of a difference": ((X - Y).sin(), X.sin() * Y.cos() - X.cos() * Y.sin()),
    "an opposite angle": ((-X - Y).sin(), -((X + Y).sin())),
    "a doubled angle": ((2 * X).cos(), 1 - 2 * X.sin() ** 2),
    "half an angle": ((X / 2).sin() ** 2, (1 - X.cos()) / 2),
    "two thirds of an angle": ((2 * THIRD * X).cos(), 2 * (THIRD * X).cos() ** 2 - 1),
    "a tangent": (B.call("tan", X) * X.cos(), X.sin()),
    "a tangent squared": (1 + B.call("tan", X) ** 2, 1 / X.cos() ** 2),
    "a root of a square that is one": ((X * X * X * X).sqrt(), X * X),
    "what is looked up": ((X * Y + Y).exp(), (Y * (X + 1)).exp()),
    "a solution": (B.solve([[X, Y], [Y, Z]], [1, 2])[0] * (X * Z - Y * Y), Z - 2 * Y),
    "another component": (B.solve([[X, Y], [Y, Z]], [1, 2])[1] * (X * Z - Y * Y), 2 * X - Y),
    "a solution without symmetry": (
        B.solve([[X, Y], [0, Z]], [1, 2])[0], (1 - 2 * Y / Z) / X),
}  # fmt: skip

DIFFERENT = {
    "sums": (X + Y, X - Y), "signs": (X, -X), "sine and cosine": (X.sin(), X.cos()),
    "angles": ((X + Y).sin(), (X - Y).sin()), "parts of angles": ((X / 2).sin(), X.sin() / 2),
    "functions": (X.exp(), (-X).exp()), "names": (X, Y), "zero": (X - X + Y, B.zero),
    "pi": (B.pi, B.constant(Fraction(22, 7))),
    "components": (B.solve([[X, Y], [Y, Z]], [1, 2])[0], B.solve([[X, Y], [Y, Z]], [1, 2])[1]),
}  # fmt: skip


@pytest.mark.parametrize("name", EQUAL)
def test_what_is_equal_is_equal_at_the_point(name: str) -> None:
    left, right = EQUAL[name]
    one, other = Residues(B).values([left, right])
    assert one == other
    assert Residues(B).is_zero(left - right)
    assert 0 <= one < PRIME


ROOTS = {
    "a root of a number": lambda b: (b.constant(3).sqrt() ** 2, b.constant(3)),
    "a turn by pi / 3": lambda b: ((b.constant(3).sqrt() / 2) ** 2 + b.one / 4, b.one),
    "roots of a product": lambda b: (
        b.constant(3).sqrt() * b.constant(11).sqrt(), b.constant(33).sqrt()),
    "a root of a fraction": lambda b: (b.constant(THIRD).sqrt() * 3, b.constant(3).sqrt()),
    "a root in a root": lambda b: (
        (5 - b.constant(5).sqrt()).sqrt() * (5 + b.constant(5).sqrt()).sqrt(),
        b.constant(20).sqrt()),
    "many roots": lambda b: (
        sum((b.constant(p).sqrt() ** 2 for p in (3, 7, 11, 13, 17, 19, 23)), b.zero),
        b.constant(93)),
    "an angle beside a root": lambda b: (
        b.constant(3) * (b.input("x") / 2).sin() ** 2,
        (b.constant(3).sqrt() ** 2 - b.constant(3) * b.input("x").cos()) / 2),
}  # fmt: skip


@pytest.mark.parametrize("name", ROOTS)
def test_roots_of_numbers_are_those_numbers(name: str) -> None:
    """Half of all numbers have no root modulo one prime: the filter takes another."""
    b = Builder()
    left, right = ROOTS[name](b)
    filter_ = Residues(b)
    one, other = filter_.values([left, right])
    assert one == other
    assert Residues(b).prime == filter_.prime


def turned(b: Builder, y: Node, x: Node) -> tuple[Node, Node]:
    """Sine and cosine of atan2(y, x), in roots."""
    radius = (x * x + y * y).sqrt()
    return y / radius, x / radius


def angle(b: Builder, y: str, x: str) -> Node:
    """atan2(y, x)."""
    return b.call("atan2", b.input(y), b.input(x))


def squares(b: Builder, *pairs: str) -> Node:
    """The sum of the squares of sine and cosine of some turns."""
    turns = [turned(b, b.input(y), b.input(x)) for y, x in pairs]
    return sum((s * s + c * c for s, c in turns), b.zero)


ROOTS_OF_INPUTS = {
    "a root": lambda b: (b.input("x").sqrt() ** 2, b.input("x")),
    "a turn": lambda b: (squares(b, "wa"), b.one),
    "turns of inputs of their own": lambda b: (
        squares(b, *(f"w{k}" for k in "abcdefgh")), b.constant(8)),
    "turns in a row": lambda b: (squares(b, "ab", "bc", "cd", "de", "ef"), b.constant(5)),
    "turns of the same inputs": lambda b: (squares(b, "ab", "bc", "ca", "ab"), b.constant(4)),
    "a root in a root": lambda b: (
        (b.input("x") + b.input("y").sqrt()).sqrt() ** 2 - b.input("x"), b.input("y").sqrt()),
    "the sine of atan2": lambda b: (
        angle(b, "w", "a").sin() * b.input("a"), angle(b, "w", "a").cos() * b.input("w")),
    "half of atan2": lambda b: (
        2 * (angle(b, "w", "a") / 2).sin() ** 2, 1 - angle(b, "w", "a").cos()),
    "half of atan2 and its point": lambda b: (
        (2 * (angle(b, "w", "a") / 2).cos() ** 2 - 1) * b.input("w"),
        2 * (angle(b, "w", "a") / 2).sin() * (angle(b, "w", "a") / 2).cos() * b.input("a")),
    "a quarter of atan2 and its point": lambda b: (
        multiple((angle(b, "w", "a") / 4).cos(), 4) * b.input("w"),
        angle(b, "w", "a").sin() * b.input("a")),
    "a third of atan2 beside the root of 3": lambda b: (
        4 * (angle(b, "w", "a") / 3).sin() ** 3,
        b.constant(3).sqrt() ** 2 * (angle(b, "w", "a") / 3).sin() - angle(b, "w", "a").sin()),
    "atan2 beside an angle": lambda b: (
        (b.input("x") + angle(b, "w", "a")).sin() * (b.input("w") ** 2 + b.input("a") ** 2).sqrt(),
        b.input("x").sin() * b.input("a") + b.input("x").cos() * b.input("w")),
    "an angle over 11 beside atan2": lambda b: (
        (b.input("x") / 11 + angle(b, "w", "a")).cos() ** 2,
        (1 + (b.input("x") * Fraction(2, 11) + 2 * angle(b, "w", "a")).cos()) / 2),
    "half a sum": lambda b: (
        ((b.input("x") + b.input("y")) / 2).sin(),
        (b.input("x") / 2).sin() * (b.input("y") / 2).cos()
        + (b.input("x") / 2).cos() * (b.input("y") / 2).sin()),
}  # fmt: skip


def test_the_rank_of_a_matrix_is_its_number_of_pivots() -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    c, s = x.cos(), x.sin()
    matrices = {
        0: [], 1: [[x, y], [x * y, y * y]], 2: [[c, s, y], [-s, c, x], [b.zero] * 3],
        3: [[c, s, b.zero], [-s, c, b.zero], [x, y, x - y]],
    }  # fmt: skip
    for rank, rows in matrices.items():
        filter_ = Residues(b)
        assert filter_.rank(rows) == rank
        assert (
            len(filter_.eliminate([filter_.values(row) for row in rows], 3 if rank > 1 else 2))
            == rank
        )


def test_a_filter_begins_with_the_point_of_another_where_all_roots_exist() -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    b.call("sqrt", x)
    first = Residues(b)
    first.values([x])
    assert Residues(b, begin=first.choice).values([x]) == first.values([x])
    for k in range(10):  # half of these have no root at the point of the first filter
        root = (x + k).sqrt() * y.sqrt()
        again = Residues(b, begin=first.choice)
        left, right = again.values([root * root, (x + k) * y])
        assert left == right


@pytest.mark.parametrize("name", ROOTS_OF_INPUTS)
def test_inputs_are_drawn_until_their_roots_exist(name: str) -> None:
    b = Builder()
    left, right = ROOTS_OF_INPUTS[name](b)
    filter_ = Residues(b)
    one, other = filter_.values([left, right])
    assert one == other
    assert Residues(b).values([right, left]) == [other, one]


def test_what_no_point_has_is_any_number() -> None:
    """-x^2 has a root at no point, and x and -x have one at different points."""
    b = Builder()
    x, y = b.input("x"), b.input("y")
    one, other, later = (-x * x).sqrt(), (-x).sqrt(), y.sqrt() * x.sqrt()
    filter_ = Residues(b)
    assert not filter_.is_zero(one)
    assert filter_.is_zero(other + one - other - one)
    assert filter_.is_zero(y.sqrt() ** 2 - y)
    assert not filter_.is_zero(later)
    # A root that is asked for later may have none at the point.
    assert filter_.is_zero(2 * (x + y).sqrt() - (x + y).sqrt() - (y + x).sqrt())


def test_roots_that_come_first_exist_where_not_all_can() -> None:
    """x and -x have no common root: the first of them is one, whatever the input is called."""
    for name in "abcdefghijkl":
        b = Builder()
        x = b.input(name)
        first, other = x.sqrt(), (-x).sqrt()
        assert Residues(b).is_zero(first**2 - x)
        assert not Residues(b).is_zero(other**2 + x)


def multiple(cosine: Node, times: int) -> Node:
    """cos(n a) of cos(a): Chebyshev's polynomial."""
    before, here = cosine.builder.one, cosine
    for _ in range(times - 1):
        before, here = here, 2 * cosine * here - before
    return here


def test_parts_of_what_takes_the_place_of_an_angle_are_parts() -> None:
    b = Builder()
    q, x = b.input("q"), b.input("x")
    eleventh = x / 11
    left, right = multiple(q.cos(), 11), x.cos()
    assert Residues(b, {q: eleventh}).is_zero(left - right)
    assert not Residues(b).is_zero(left - right)


@pytest.mark.parametrize("parts", [2, 3, 5, 7, 8])
def test_some_parts_of_an_angle_may_be_asked_for_later(parts: int) -> None:
    b = Builder()
    x = b.input("x")
    filter_ = Residues(b)
    assert not filter_.is_zero(x.cos())
    assert filter_.is_zero(multiple((x / parts).cos(), parts) - x.cos())


@pytest.mark.parametrize("parts", [1, 2, 3, 5])
def test_parts_of_the_angle_of_two_numbers_are_parts(parts: int) -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    part = b.call("atan2", y, x) / parts
    distance = (x * x + y * y).sqrt()
    assert Residues(b).is_zero(distance * multiple(part.cos(), parts) - x)


@pytest.mark.parametrize("parts", range(1, 13))
def test_so_many_parts_of_a_point_are_the_point(parts: int) -> None:
    whole = _times(_point_of_the_circle(3), 840, PRIME)
    part = _part(whole, parts, PRIME)
    assert part is not None
    assert _times(part, parts, PRIME) == whole


def _point_of_the_circle(t: int) -> tuple[int, int]:
    below = pow(1 + t * t, -1, PRIME)
    return (1 - t * t) * below % PRIME, 2 * t * below % PRIME


def test_sums_that_angles_share_are_looked_into_once() -> None:
    b = Builder()
    one, two = b.input("x") / 3, b.input("y")
    for _ in range(60):
        one, two = one + two, one - two
    cosine = one.cos()
    assert len(cosine.builder.operations) < 200
    assert _denominator(b, {}) == 3


def test_numbers_that_have_no_root_are_the_same_each_time() -> None:
    b = Builder()
    root = b.constant(-1).sqrt()
    assert Residues(b).prime == PRIME
    assert Residues(b).is_zero(root * 2 - root - root)


@pytest.mark.parametrize("name", DIFFERENT)
def test_what_differs_differs_at_the_point(name: str) -> None:
    left, right = DIFFERENT[name]
    one, other = Residues(B).values([left, right])
    assert one != other


def test_what_hides_a_number_is_that_number() -> None:
    filter_ = Residues(B)
    square = X.sin() ** 2 + X.cos() ** 2
    assert filter_.tidy(square).constant == 1
    assert filter_.tidy(-square).constant == -1
    assert filter_.tidy(square - 1).constant == 0
    assert filter_.tidy(X) == X
    assert filter_.tidy(2 * square) == 2 * square
    assert filter_.tidy(B.constant(7)) == B.constant(7)


def test_values_do_not_depend_on_what_was_asked_before() -> None:
    nodes = [left for left, _ in EQUAL.values()]
    together = Residues(B).values(nodes)
    assert [Residues(B).values([node])[0] for node in nodes] == together
    filter_ = Residues(B)
    assert [filter_.values([node])[0] for node in reversed(nodes)] == together[::-1]


def test_a_singular_system_has_some_value() -> None:
    x = B.solve([[X, X], [X, X]], [1, 2])
    one, other = Residues(B).values(list(x))
    assert one != other


@pytest.mark.parametrize(
    ("rows", "pivots"),
    [
        ([[1, 2], [2, 4]], [(0, 0)]),
        ([[0, 3], [2, 1]], [(0, 1), (1, 0)]),
        ([[0, 0], [0, 5]], [(1, 1)]),
        ([[1, 2, 3], [4, 5, 6], [5, 7, 9]], [(0, 0), (1, 1)]),
        ([[2, 4, 2], [1, 2, 3], [0, 1, 1]], [(0, 0), (1, 2), (2, 1)]),
    ],
)
def test_elimination_takes_rows_in_order(
    rows: list[list[int]], pivots: list[tuple[int, int]]
) -> None:
    table = [list(row) for row in rows]
    assert eliminate(table, len(rows[0]), PRIME) == pivots
    for row, column in pivots:
        assert [table[other][column] for other, _ in pivots] == [
            int(other == row) for other, _ in pivots
        ]


def test_columns_beyond_are_carried_along() -> None:
    """2 x + y = 5, x - y = 1: x = 2, y = 1."""
    table = [[2, 1, 5], [1, PRIME - 1, 1]]
    pivots = {column: row for row, column in eliminate(table, 2, PRIME)}
    assert [table[pivots[k]][2] for k in range(2)] == [2, 1]


def node_count(node: Node) -> int:
    return len(node.builder)


def test_asking_makes_no_nodes() -> None:
    before = node_count(X)
    Residues(B).values([left for left, _ in EQUAL.values()])
    assert node_count(X) == before

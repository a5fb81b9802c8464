"""Statements that hold on constraints only, and that are false there, too."""

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

import pytest

from mechanics.kernel import Range, Statement, Verdict, decide, enclose
from mechanics.kernel.constraints import on_constraints
from mechanics.program import Builder, Node


def statement(b: Builder, left: Node, right: Node, zero: list[Node], **options) -> Statement:
    program = b.program({"left": [left], "right": [right], "zero": zero})
    return Statement("on the constraints", program, **options)


def test_what_holds_everywhere_needs_no_point_on_the_constraints() -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    # No way to solve for x.
    claim = statement(b, (x + y).power(2), x * x + 2 * x * y + y * y, [x + x.exp() - y])
    finding = decide(claim)
    assert finding.verdict is Verdict.PROVED
    assert "also where the constraints do not hold" in finding.evidence
    finding = decide(claim, try_normal=False)
    assert finding.verdict is Verdict.CERTIFIED
    assert "also where the constraints do not hold" in finding.evidence


def test_without_a_point_on_the_constraints_it_is_undecided() -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    finding = decide(statement(b, x + x.exp(), y, [x + x.exp() - y], dependent=("x",)))
    assert finding.verdict is Verdict.UNDECIDED
    assert "no exact point" in finding.evidence


def test_the_component_is_named() -> None:
    """x y = 0 holds where x = 0 and where y = 0."""
    b = Builder()
    x, y = b.input("x"), b.input("y")
    on_one = decide(statement(b, x + y, y, [x * y], dependent=("x",)))
    assert on_one.verdict is Verdict.PROVED
    assert on_one.evidence.endswith("on the component where the constraints give x")
    assert decide(statement(b, x + y, y, [x * y], dependent=("y",))).verdict is Verdict.REFUTED


@pytest.mark.parametrize("name", ["branch 1", "branch of x"])
def test_a_root_is_chosen_by_no_input_of_the_statement(name: str) -> None:
    """x^2 = z: x = sqrt z or -sqrt z, whatever the sign of another input."""
    b = Builder()
    x, z, other = b.input("x"), b.input("z"), b.input(name)
    claim = statement(b, x, z.sqrt() * other / abs(other), [x * x - z], dependent=("x",))
    finding = decide(claim)
    assert finding.verdict is Verdict.REFUTED
    assert finding.witness is not None
    assert {key for key, _ in finding.witness.state} == {"z", name}
    assert [key for key, _ in finding.witness.solved] == ["x"]


def test_a_value_is_known_by_the_inputs_below_the_values_that_it_holds() -> None:
    """p by q, then q by r: what is left for r holds p, and so r a second time."""
    b = Builder()
    p, q, r, s = (b.input(n) for n in "pqrs")
    zero = [p - q * q, q - 2 * r, p + r - s]
    claim = statement(b, p + q / 2, s, zero, dependent=("p", "q", "r"))
    assert decide(claim).verdict is Verdict.PROVED
    wrong = statement(b, p + q, s, zero, dependent=("p", "q", "r"))
    assert decide(wrong).verdict is Verdict.REFUTED


def test_linear_constraints() -> None:
    b = Builder()
    x, y, z, w = (b.input(n) for n in "xyzw")
    zero = [x + 2 * y - z, x * w - y - 1]
    claim = statement(b, x + 2 * y + w * x - y, z + 1, zero, dependent=("x", "y"))
    assert decide(claim).verdict is Verdict.PROVED
    wrong = statement(b, x + 2 * y + w * x - y, z + 2, zero, dependent=("x", "y"))
    finding = decide(wrong)
    assert finding.verdict is Verdict.REFUTED
    assert finding.witness is not None
    state = {name: Fraction(v) for name, v in finding.witness.state}
    assert state.keys() == {"z", "w"}
    solved = {
        name: Fraction(float(v)).limit_denominator(1000) for name, v in finding.witness.solved
    }
    assert solved["x"] + 2 * solved["y"] == state["z"]


LARGE = {
    "a product": (lambda w, y, z: w, lambda A, B, y, z: -A),
    "a sum": (lambda w, y, z: y * w + z, lambda A, B, y, z: -z / (y * B) - A),
    "a difference": (lambda w, y, z: z - (y - w * 3), lambda A, B, y, z: (y - z) / (3 * B) - A),
    "signs": (lambda w, y, z: -(w * y + z), lambda A, B, y, z: -z / (y * B) - A),
    "a quotient": (lambda w, y, z: (y - w) / (z * z), lambda A, B, y, z: y / B - A),
}
"""Constraints on x by w = (A + x) B, and what they give for x."""


@pytest.mark.parametrize("name", LARGE)
def test_a_linear_constraint_that_is_too_large_to_be_expanded(name: str) -> None:
    b = Builder()
    x, y, z = b.input("x"), b.input("y"), b.input("z")
    one, two = (sum((b.input(f"{n}{k}") for k in range(9)), b.zero) for n in "AB")
    constraint, solution = LARGE[name]
    zero = [constraint((one + x) * two, y, z)]
    right = statement(b, x, solution(one, two, y, z), zero, dependent=("x",))
    assert decide(right, try_normal=False).verdict is Verdict.CERTIFIED
    wrong = statement(b, x, solution(one, two, y, z) + 1, zero, dependent=("x",))
    assert decide(wrong).verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    "bent",
    [lambda w, x: w * w * w * x, lambda w, x: x / w, lambda w, x: w.exp() - x, lambda w, x: w / x],
)
def test_what_bends_is_not_taken_for_linear(bent: Callable[[Node, Node], Node]) -> None:
    b = Builder()
    x = b.input("x")
    one, two = (sum((b.input(f"{n}{k}") for k in range(9)), b.zero) for n in "AB")
    zero = [bent((one + x) * two, x) + x + one]
    assert on_constraints(statement(b, x, two, zero, dependent=("x",))) is None


def test_a_quadratic_constraint_has_two_branches() -> None:
    b = Builder()
    x, y, l = b.input("x"), b.input("y"), b.input("l")
    circle = [x * x + y * y - l * l]
    power = statement(b, x.power(4), (l * l - y * y).power(2), circle, dependent=("x",))
    assert decide(power, try_normal=False).shown
    upper = statement(b, x, (l * l - y * y).sqrt(), circle, dependent=("x",))
    assert decide(upper).verdict is Verdict.REFUTED
    positive = statement(
        b, x, (l * l - y * y).sqrt(), circle, dependent=("x",), signs={"x": Range.POSITIVE}
    )
    assert decide(positive, try_normal=False).shown
    opposite = [l * l - x * x - y * y]
    positive = statement(
        b, x, (l * l - y * y).sqrt(), opposite, dependent=("x",), signs={"x": Range.POSITIVE}
    )
    assert decide(positive, try_normal=False).verdict is Verdict.CERTIFIED


def test_a_quadratic_constraint_with_a_linear_term() -> None:
    """x^2 + 2 y x = 1: (x + y)^2 = 1 + y^2 on both branches, x = 1 at none of most y."""
    b = Builder()
    x, y = b.input("x"), b.input("y")
    zero = [x * x + 2 * x * y - 1]
    right = statement(b, (x + y).power(2), 1 + y * y, zero, dependent=("x",))
    assert decide(right, try_normal=False).shown
    wrong = statement(b, (x + y).power(4), 1 + y * y, zero, dependent=("x",))
    assert decide(wrong, try_normal=False).verdict is Verdict.REFUTED


def test_a_quadratic_constraint_is_divided_by_twice_its_square() -> None:
    b = Builder()
    x = b.input("x")
    claim = statement(b, x, -2 * b.one, [3 * x * x + 3 * x - 6], dependent=("x",))
    assert decide(replace(claim, typical={"x": Fraction(-2)})).verdict is Verdict.PROVED
    assert decide(replace(claim, typical={"x": Fraction(1)})).verdict is Verdict.REFUTED


@pytest.mark.parametrize("start", [Fraction(n) for n in ("2", "-2", "1e-9", "-1e-9")])
def test_a_slope_of_either_sign_leads_to_a_point(start: Fraction) -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    claim = statement(b, x * y, b.one, [x * y - 1], dependent=("y",))
    found = on_constraints(replace(claim, typical={"x": start, "y": 1 / start}))
    assert found is not None
    assert found.program.inputs == ("x",)


def test_solutions_keep_their_range() -> None:
    """x^2 = y^2: x is y or -y, by the signs of both."""
    b = Builder()
    x, y = b.input("x"), b.input("y")
    square = [x * x - y * y]
    for known, turned, other in (
        (Range.POSITIVE, y, -y), (Range.NONNEGATIVE, y, -y), (Range.NEGATIVE, -y, y),
    ):  # fmt: skip
        signs = {"x": known, "y": Range.POSITIVE}
        right = statement(b, x, turned, square, dependent=("x",), signs=signs)
        assert decide(right, try_normal=False).shown, known
        wrong = statement(b, x, other, square, dependent=("x",), signs=signs)
        assert decide(wrong, try_normal=False).verdict is Verdict.REFUTED, known


def test_an_angle_that_a_constraint_determines() -> None:
    """A ladder: its foot lies at x = l cos(t)."""
    b = Builder()
    x, t, l = b.input("x"), b.input("t"), b.input("l")
    claim = statement(b, (l * t.sin()).power(2), l * l - x * x, [l * t.cos() - x], dependent=("t",))
    assert decide(claim, try_normal=False).shown
    one_side = statement(b, l * t.sin(), (l * l - x * x).sqrt(), claim_zero(b), dependent=("t",),
                         signs={"l": Range.POSITIVE})  # fmt: skip
    assert decide(one_side).verdict is Verdict.REFUTED


def claim_zero(b: Builder) -> list[Node]:
    return [b.input("l") * b.input("t").cos() - b.input("x")]


def four_bar(b: Builder) -> list[Node]:
    p, q, r = b.input("p"), b.input("q"), b.input("r")
    a, c, d, e = (b.input(n) for n in "acde")
    return [
        a * p.cos() + c * q.cos() - d * r.cos() - e,
        a * p.sin() + c * q.sin() - d * r.sin(),
    ]


BARS = {name: Range.POSITIVE for name in "acde"}


@pytest.mark.campaign
def test_a_four_bar_linkage_closes_by_its_lengths_or_by_its_angles() -> None:
    """Freudenstein's equation: what is left when the coupler's angle is taken out."""
    b = Builder()
    zero = four_bar(b)
    p, r = b.input("p"), b.input("r")
    a, c, d, e = (b.input(n) for n in "acde")
    coupler = (e + d * r.cos() - a * p.cos()).power(2) + (d * r.sin() - a * p.sin()).power(2)
    for dependent in (("a", "c"), ("q", "r"), ("r", "q")):
        claim = statement(b, coupler, c * c, zero, signs=BARS, dependent=dependent)
        assert decide(claim, try_normal=False).shown, dependent
        wrong = statement(b, coupler, c * c + e * e / 10, zero, signs=BARS, dependent=dependent)
        assert decide(wrong, try_normal=False).verdict is Verdict.REFUTED, dependent


def test_points_of_a_loop_lie_on_it() -> None:
    b = Builder()
    zero = four_bar(b)
    outputs = {"left": [b.zero], "right": [b.one], "zero": zero, "check": zero}
    claim = Statement("loop", b.program(outputs), BARS, dependent=("q", "r"))
    constrained = on_constraints(claim)
    assert constrained is not None
    assert {"q", "r"}.isdisjoint(constrained.program.inputs)
    values = {"p": Fraction(3, 10), "a": 1, "c": 3, "d": 2, "e": 3}
    for branch in (1, -1):
        signs = {n: branch for n in constrained.program.inputs if n.startswith("branch")}
        found = enclose(constrained.program, values | signs, 256)
        assert all(abs(ball) < 1e-50 for ball in found["check"])


def test_two_circles_meet_in_points_of_their_axis() -> None:
    b = Builder()
    x, y, u, l, m = (b.input(n) for n in ("x", "y", "u", "l", "m"))
    zero = [x * x + y * y - l * l, (x - u).power(2) + y * y - m * m]
    claim = statement(b, 2 * u * x, l * l - m * m + u * u, zero, dependent=("x", "y"))
    assert decide(claim, try_normal=False).shown
    wrong = statement(b, 2 * u * x, l * l + m * m + u * u, zero, dependent=("x", "y"))
    assert decide(wrong, try_normal=False).verdict is Verdict.REFUTED


@pytest.mark.parametrize("count", [2, 5])
def test_chains_of_loops_are_closed_one_after_the_other(count: int) -> None:
    b = Builder()
    zero, dependent = [], []
    x, y = b.input("x0"), b.zero
    for k in range(count):
        angle, l = b.input(f"t{k}"), b.input(f"l{k}")
        new = b.input(f"x{k + 1}")
        zero.append(x + l * angle.cos() - new)
        dependent.append(f"x{k + 1}")
        x, y = new, y + l * angle.cos()
    claim = statement(b, x, b.input("x0") + y, zero, dependent=tuple(dependent))
    assert decide(claim).verdict is Verdict.PROVED

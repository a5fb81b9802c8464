"""A state on the constraints tells which component of them a statement is about."""

from fractions import Fraction

import pytest

from mechanics.kernel import Finding, Range, Statement, Verdict, decide, enclose
from mechanics.kernel.constraints import on_constraints
from mechanics.program import Builder, Node
from mechanics.program.forward import tangent

LENGTHS = {"a": Range.POSITIVE, "b": Range.POSITIVE}


def parallelogram(b: Builder) -> list[Node]:
    """Crank and rocker of length a, coupler and ground of length b."""
    p, q, r, a, c = (b.input(name) for name in ("p", "q", "r", "a", "b"))
    return [
        a * p.cos() + c * q.cos() - c - a * r.cos(),
        a * p.sin() + c * q.sin() - a * r.sin(),
    ]


def folded_angle(digits: int) -> Fraction:
    """Angle of the rocker of the folded twin at p = 1 with a = 1, b = 2, by bisection.

    Crank and rocker ends are b apart there, too: |(cos p - b - cos r, sin p - sin r)| = b.
    """
    b = Builder()
    p, r = b.constant(1), b.input("r")
    off = (p.cos() - 2 - r.cos()).power(2) + (p.sin() - r.sin()).power(2) - 4
    program = b.program({"off": [off]})
    low, high = Fraction(-5, 2), Fraction(-3, 2)
    for _ in range(digits):
        middle = (low + high) / 2
        values = [enclose(program, {"r": at}, 600)["off"][0] for at in (low, middle)]
        low, high = (middle, high) if values[0] * values[1] > 0 else (low, middle)
    return low


def start(folded: bool) -> dict[str, Fraction]:
    lengths = {"a": Fraction(1), "b": Fraction(2)}
    if not folded:
        return {"p": Fraction(1), "q": Fraction(0), "r": Fraction(1), **lengths}
    r = folded_angle(400)
    b = Builder()
    angle = b.input("r")
    coupler = (angle.sin() - b.constant(1).sin()) / 2
    (found,) = enclose(b.program({"q": [b.call("asin", coupler)]}), {"r": r}, 600)["q"]
    mantissa, exponent = found.mid().man_exp()
    q = Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    return {"p": Fraction(1), "q": q, "r": r, **lengths}


def decided(left: Node, right: Node, folded: bool, dependent: str) -> Finding:
    b = left.builder
    program = b.program({"left": [left], "right": [right], "zero": parallelogram(b)})
    statement = Statement("rods", program, LENGTHS, start(folded), tuple(dependent))
    return decide(statement)


@pytest.mark.parametrize("dependent", ["abpqr", "abrqp", "rq"])
def test_both_rods_turn_equally_on_one_component_of_a_parallelogram(dependent: str) -> None:
    b = Builder()
    p, r = b.input("p"), b.input("r")
    finding = decided(p.sin(), r.sin(), False, dependent)
    assert finding.verdict is Verdict.PROVED
    assert "on the component where the constraints give" in finding.evidence
    assert "(at the start" in finding.evidence
    finding = decided(p.sin(), r.sin(), True, dependent)
    assert finding.verdict is Verdict.REFUTED
    assert finding.witness is not None
    wrong = decided(p.sin(), r.cos(), False, dependent)
    assert wrong.verdict is Verdict.REFUTED


def test_points_of_the_folded_twin_lie_on_it() -> None:
    b = Builder()
    zero = parallelogram(b)
    outputs = {"left": [b.zero], "right": [b.one], "zero": zero, "check": zero}
    claim = Statement("twin", b.program(outputs), LENGTHS, start(True), ("r", "q"))
    constrained = on_constraints(claim)
    assert constrained is not None
    assert {"r", "q"}.isdisjoint(constrained.program.inputs)
    near = {"p": Fraction(11, 10), "a": Fraction(1), "b": Fraction(2)}
    found = enclose(constrained.program, near, 256)
    assert all(abs(ball) < 1e-50 for ball in found["check"])
    (r,) = found["r"]
    # The rocker turns back while the crank turns on.
    assert float(r) < float(start(True)["r"])


@pytest.mark.parametrize("x_start", [4, -4])
def test_both_halves_of_a_circle_are_one_component(x_start: int) -> None:
    b = Builder()
    x, y, l = b.input("x"), b.input("y"), b.input("l")
    at = {"x": Fraction(x_start), "y": Fraction(3), "l": Fraction(5)}

    def verdict(left: Node, right: Node) -> Verdict:
        outputs = {"left": [left], "right": [right], "zero": [x * x + y * y - l * l]}
        statement = Statement("circle", b.program(outputs), {"l": Range.POSITIVE}, at, ("x",))
        return decide(statement).verdict

    assert verdict(x * x * y.sin(), (l * l - y * y) * y.sin()) is Verdict.PROVED
    assert verdict(abs(x), (l * l - y * y).sqrt()) is Verdict.PROVED
    for side in (1, -1):
        assert verdict(x, side * (l * l - y * y).sqrt()) is Verdict.REFUTED
        assert verdict(x, side * abs(x)) is Verdict.REFUTED
        assert verdict(b.call("atan2", y, x), b.call("asin", y / l)) is Verdict.REFUTED


def test_where_both_roots_meet_no_branch_is_told() -> None:
    b = Builder()
    x, y = b.input("x"), b.input("y")
    program = b.program({"left": [x], "right": [y], "zero": [x * x - y]})
    at = {"x": Fraction(0), "y": Fraction(0)}
    finding = decide(Statement("fold", program, {}, at, ("x",)))
    assert finding.verdict is Verdict.UNDECIDED
    assert "no exact point" in finding.evidence


def test_speeds_are_solved_for_where_the_constraints_on_coordinates_hold() -> None:
    """On x = y the row (x - y) u + v = 0 gives v = 0, and u stays free."""
    b = Builder()
    x, y, u, v, w = (b.input(name) for name in "xyuvw")
    outputs = {"left": [v * w], "right": [b.zero], "zero": [x - y], "rates": [(x - y) * u + v]}
    claim = Statement("rates", b.program(outputs), {}, {}, ("u", "v", "x"))
    finding = decide(claim)
    assert finding.verdict is Verdict.PROVED
    assert finding.evidence.endswith("on the component where the constraints give v, x")


def test_many_lengths_that_have_to_be_positive_need_no_lucky_point() -> None:
    """Rational sides are equal everywhere or on no open set: 16 lengths are no 16 tosses."""
    b = Builder()
    names = [f"l{k}" for k in range(16)]
    zero = [b.input(name) * b.input(f"x{k}") - b.input(f"y{k}") for k, name in enumerate(names)]
    total = b.zero
    for k, name in enumerate(names):
        total = total + b.input(name) * b.input(f"x{k}") - b.input(f"y{k}")
    outputs = {"left": [total + 1], "right": [b.one], "zero": zero}
    signs = dict.fromkeys(names, Range.POSITIVE)
    finding = decide(Statement("sum", b.program(outputs), signs, {}, tuple(names)))
    assert finding.verdict is Verdict.PROVED
    wrong = {**outputs, "right": [b.input("l0") * b.input("x1")]}
    finding = decide(Statement("sum", b.program(wrong), signs, {}, tuple(names)))
    assert finding.verdict is Verdict.REFUTED
    assert finding.witness is not None
    lengths = [value for name, value in finding.witness.solved if name in names]
    assert lengths
    assert all(float(value) > 0 for value in lengths)


@pytest.mark.parametrize("count", [2, 9])
def test_speeds_of_a_row_of_four_bars_are_solved_for_however_long_it_is(count: int) -> None:
    """Each rocker is the crank of the next; what is put in is soon too large to be expanded."""
    b = Builder()
    zero, lengths = [], []
    angles = [b.input(f"t{k}") for k in range(2 * count + 1)]
    bars = [b.input(f"l{k}") for k in range(2 * count + 1)]
    table = {angle: b.input(f"w{k}") for k, angle in enumerate(angles)}
    for k in range(0, 2 * count, 2):
        (p, a), (q, c), (r, e) = ((angles[i], bars[i]) for i in (k, k + 1, k + 2))
        zero.append(a * p.cos() + c * q.cos() - e * r.cos() - b.input(f"d{k}"))
        zero.append(a * p.sin() + c * q.sin() - e * r.sin())
        lengths += [f"d{k}", f"l{k}"]
    rates = tangent(zero, table)
    speeds = [f"w{k}" for k in range(2 * count)]
    first = angles[0].sin() * bars[0] * table[angles[0]]
    outputs = {"left": [sum(rates, b.zero) + first], "right": [first]}
    constraints = {"zero": zero, "rates": rates}
    program = b.program({**outputs, "shown": [first], **constraints})
    statement = Statement("row", program, {}, {}, (*speeds, *lengths))
    constrained = on_constraints(statement)
    assert constrained is not None
    assert len([name for name in constrained.program.outputs if name[0] == "w"]) == 2 * count
    assert decide(statement, try_normal=False).verdict is Verdict.CERTIFIED


def test_a_positive_length_before_all_is_not_made_zero() -> None:
    """Without a state, a (cos p - cos q) = 0 is no reason for a = 0."""
    b = Builder()
    a, p, q = (b.input(name) for name in ("a", "p", "q"))
    outputs = {"left": [p.cos()], "right": [q.cos()], "zero": [a * (p.cos() - q.cos())]}
    statement = Statement("cosines", b.program(outputs), LENGTHS, {}, ("a", "p", "q"))
    constrained = on_constraints(statement)
    assert constrained is not None
    assert "a" not in constrained.program.outputs
    assert decide(statement).shown

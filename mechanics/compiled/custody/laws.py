"""What each function of a model has to be, in terms of what was derived.

    forward dynamics     K x = k,  K = [[M, -B], [A, 0]],  k = [f, b],  x what the graph gives
    jacobians            column = K^-1 (dk/ds - (dK/ds) x),  K x = k,  s in q, u, inputs, p
    step                 y + h/6 (k1 + 2 k2 + 2 k3 + k4) of the rates, themselves K x = k
    the rest             graph = expression

A law gives, by output, pairs of numbers that have to be equal: the graph's, and what was derived.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial

from sympy import Add, Dummy, Expr, Matrix, S

from mechanics.compiled.custody.derived import Derived
from mechanics.exact import Arithmetic, Number, slope

Pair = tuple[str, Number, Number]
"""Name of an entry, and two numbers."""
Outputs = dict[str, list[Number]]
Law = Callable[[Arithmetic, Outputs, Derived], Iterator[Pair]]

STATE = ("q", "u", "inputs", "p")


def _forward_dynamics(a: Arithmetic, outputs: Outputs, known: Derived) -> Iterator[Pair]:
    solution = outputs["ud"] + outputs["multipliers"]
    if known.rows:
        # The value of a row at what the graph gives; M and f would be its slope and its rest.
        for symbol, number in zip(known.unknowns, solution, strict=True):
            a.assign(symbol, number)
        for i, row in enumerate(known.rows):
            yield f"row {i} as derived", a.value(row), a.rational(0)
    for i in range(known.left.rows):
        yield f"row {i} of K x = k", _row(a, known.left, i, solution), a.value(known.right[i])


def _rates(a: Arithmetic, outputs: Outputs, known: Derived) -> Iterator[Pair]:
    yield from _forward_dynamics(a, outputs, known)
    yield from _coordinate_rates(a, outputs, known)


def _row(a: Arithmetic, matrix: Matrix, i: int, vector: Sequence[Number]) -> Number:
    total = a.rational(0)
    for j, number in enumerate(vector):
        if matrix[i, j] != 0:
            total = total + a.value(matrix[i, j]) * number
    return total


def _residual(a: Arithmetic, outputs: Outputs, known: Derived) -> Iterator[Pair]:
    expressions = known.left * Matrix(known.unknowns) - known.right
    yield from _equal(a, outputs, "residual", list(expressions))


def _solved(a: Arithmetic, known: Derived) -> tuple[list[list[Number]], list[Number]]:
    """K and x = K^-1 k."""
    left = known.left
    rows = [[a.value(left[i, j]) for j in range(left.cols)] for i in range(left.rows)]
    return rows, a.solve(rows, [a.value(entry) for entry in known.right])


def _inverse_dynamics(a: Arithmetic, outputs: Outputs, known: Derived) -> Iterator[Pair]:
    """tau = M_T w with w = u' - what the loads give, the latter solved for in the arithmetic.

    dT/du is affine in u with the slope M_T: tau is its change from u = 0 to u = w.
    """
    u, ud = known.symbols["u"], known.symbols["ud"]
    _, given = _solved(a, known)
    gains = {symbol: Dummy(f"gain of {symbol}", real=True) for symbol in u}
    for gain, wanted, x in zip(gains.values(), ud, given, strict=False):
        a.assign(gain, a.value(wanted) - x)
    still = dict.fromkeys(u, S.Zero)
    for i, (symbol, force) in enumerate(zip(u, outputs["forces"], strict=True)):
        momentum = known.kinetic.diff(symbol)
        change = a.value(momentum.xreplace(gains)) - a.value(momentum.xreplace(still))
        yield f"forces[{i}]", force, change


def _energy(a: Arithmetic, outputs: Outputs, known: Derived) -> Iterator[Pair]:
    yield "kinetic[0]", outputs["kinetic"][0], a.value(known.kinetic)
    yield "potential[0]", outputs["potential"][0], a.value(known.potential)
    yield "total[0]", outputs["total"][0], a.value(known.kinetic) + a.value(known.potential)


def _momenta(a: Arithmetic, outputs: Outputs, known: Derived) -> Iterator[Pair]:
    yield from _equal(a, outputs, "linear", known.linear)
    yield from _equal(a, outputs, "angular", known.angular)
    rates = [known.kinetic.diff(u) for u in known.symbols["u"]]
    yield from _equal(a, outputs, "generalized", rates)


def _reactions(a: Arithmetic, outputs: Outputs, known: Derived) -> Iterator[Pair]:
    _, solution = _solved(a, known)
    for symbol, number in zip(known.unknowns, solution, strict=True):
        a.assign(symbol, number)
    yield from _equal(a, outputs, "reactions", [value for _, value in known.reactions])


def _coordinate_rates(a: Arithmetic, outputs: Outputs, known: Derived) -> Iterator[Pair]:
    yield from _equal(a, outputs, "qd", known.rates)


def _jacobians(a: Arithmetic, outputs: Outputs, known: Derived) -> Iterator[Pair]:
    """The derivative of the solution, solved for in the arithmetic."""
    left, right = known.left, known.right
    rows, solution = _solved(a, known)
    n = len(known.symbols["ud"])
    for group in STATE:
        for k, symbol in enumerate(known.symbols[group]):
            change = left.applyfunc(partial(slope, symbol=symbol))
            rest = [
                a.value(slope(right[i], symbol)) - _row(a, change, i, solution)
                for i in range(left.rows)
            ]
            derivative = a.solve(rows, rest)
            for i in range(n):
                at = k * n + i
                yield f"ud_{group}[{at}]", outputs[f"ud_{group}"][at], derivative[i]


def _equal(
    a: Arithmetic, outputs: Outputs, name: str, expressions: Sequence[Expr]
) -> Iterator[Pair]:
    for i, (number, expression) in enumerate(zip(outputs[name], expressions, strict=True)):
        yield f"{name}[{i}]", number, a.value(Add(expression))


def _matrix(output: str) -> Law:
    """A law for an output that is one matrix of the equations, column by column."""

    def law(a: Arithmetic, outputs: Outputs, known: Derived) -> Iterator[Pair]:
        matrix = known.mass if output == "mass_matrix" else known.forcing
        yield from _equal(a, outputs, output, list(matrix.T))

    return law


LAWS: dict[str, Law] = {
    "forward_dynamics": _forward_dynamics,
    "mass_matrix": _matrix("mass_matrix"),
    "forcing": _matrix("forcing"),
    "residual": _residual,
    "inverse_dynamics": _inverse_dynamics,
    "energy": _energy,
    "momenta": _momenta,
    "coordinate_rates": _coordinate_rates,
    "reactions": _reactions,
    "jacobians": _jacobians,
    "rates": _rates,
}
"""By name of a function. The step is composed of the rates, see `custody.step`."""

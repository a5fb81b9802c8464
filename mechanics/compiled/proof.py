"""What was compiled is still the same mathematics: CasADi graphs against the derived equations.

    forward dynamics     K x_graph = k,  K = [[M, -B], [A, 0]],  k = [f, b]
    jacobians            column_graph = K^-1 (dk/ds - (dK/ds) x),  K x = k,  s in q, u, inputs, p
    the rest             graph = expression

in exact arithmetic: the graphs are walked instruction by instruction, the right sides as SymPy
expressions, at the values of parameters that are fixed. The graphs are those that are bound and
evaluated, with pi and other numbers that no double holds still standing as symbols.
"""

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import casadi as ca
from sympy import Add, Dummy, Expr, Matrix, S, Symbol

from mechanics.compiled.fixed import words
from mechanics.compiled.graphs import STATE, Graphs
from mechanics.compiled.mechanical import Totals, totals
from mechanics.compiled.model import Model
from mechanics.errors import InputError
from mechanics.exact import Arithmetic, Finding, Number, decide

Pairs = Iterator[tuple[Number, Number]]
Outputs = dict[str, list[Number]]
Law = Callable[[Arithmetic, Outputs, Graphs], Pairs]

DEFAULT = (
    "forward_dynamics", "mass_matrix", "forcing", "residual", "inverse_dynamics", "energy",
    "momenta", "coordinate_rates", "reactions",
)  # fmt: skip


def prove_compiled(
    model: Model, functions: Sequence[str] | None = None, **options: Any
) -> tuple[Finding, ...]:
    """Decide for each function of a model whether its graph is what was derived.

    Parameters
    ----------
    model : Model
    functions : sequence of str, optional
        Names of functions; by default all that the model has but the Jacobians.
    **options
        As for `mechanics.exact.decide`.
    """
    present = tuple(model.casadi)
    names = [n for n in DEFAULT if n in present] if functions is None else functions
    return tuple(prove_graph(name, model.casadi, **options) for name in names)


def prove_graph(
    name: str, graphs: Graphs, function: ca.Function | None = None, **options: Any
) -> Finding:
    """Decide whether one graph is what was derived.

    Parameters
    ----------
    name : str
        What the function should be.
    graphs : Graphs
    function : casadi.Function, optional
        The graph to examine, with the inputs of ``graphs.exact(name)``; that one by default.

    Raises
    ------
    InputError
        If there is no such function.
    """
    if name not in LAWS:
        raise InputError(f"function {name!r}: what it should be is known for {', '.join(LAWS)}")
    own, constants = graphs.exact(name)
    examined = function or own
    symbols = [*_inputs(graphs, own), list(constants)]

    def experiment(a: Arithmetic) -> list[tuple[Number, Number]]:
        # What was derived, at the fixed values: how the graph was simplified is not relied on.
        for symbol, value in graphs.fixed.items():
            a.assign(symbol, a.value(value))
        results = a.graph(examined, symbols=symbols)
        outputs = {examined.name_out(i): entries for i, entries in enumerate(results)}
        return list(LAWS[name](a, outputs, graphs))

    subject = f"compiled {name.replace('_', ' ')} = derived, {graphs.derived.route}"
    if graphs.fixed:
        subject += f", {words(graphs.fixed)}"
    return decide(subject, experiment, **options)


def _inputs(graphs: Graphs, function: ca.Function) -> list[list[Symbol]]:
    groups = [function.name_in(i) for i in range(function.n_in())]
    return [
        [entry.symbol for entry in getattr(graphs.quantities, group)]
        for group in groups
        if group != "constants"
    ]


def _forward_dynamics(a: Arithmetic, outputs: Outputs, graphs: Graphs) -> Pairs:
    left, right = graphs.derived.system
    solution = outputs["ud"] + outputs["multipliers"]
    for i in range(left.rows):
        yield _row(a, left, i, solution), a.value(right[i])


def _row(a: Arithmetic, matrix: Matrix, i: int, vector: Sequence[Number]) -> Number:
    total = a.rational(0)
    for j, number in enumerate(vector):
        if matrix[i, j] != 0:
            total = total + a.value(matrix[i, j]) * number
    return total


def _residual(a: Arithmetic, outputs: Outputs, graphs: Graphs) -> Pairs:
    left, right = graphs.derived.system
    expressions = left * Matrix(graphs.derived.unknowns) - right
    yield from _equal(a, outputs["residual"], expressions)


def _inverse_dynamics(a: Arithmetic, outputs: Outputs, graphs: Graphs) -> Pairs:
    """tau = M_T w with w = u' - what the loads give, the latter solved for in the arithmetic.

    dT/du is affine in u with the slope M_T: tau is its change from u = 0 to u = w.
    """
    equations, u = graphs.derived, graphs.derived.scene.u
    left, right = equations.system
    rows = [[a.value(left[i, j]) for j in range(left.cols)] for i in range(left.rows)]
    given = a.solve(rows, [a.value(entry) for entry in right])[: len(u)]
    gains = {symbol: Dummy(f"gain of {symbol}", real=True) for symbol in u}
    for gain, wanted, x in zip(gains.values(), equations.scene.ud, given, strict=True):
        a.assign(gain, a.value(wanted) - x)
    kinetic, still = _totals(graphs).kinetic, dict.fromkeys(u, S.Zero)
    for symbol, force in zip(u, outputs["forces"], strict=True):
        momentum = kinetic.diff(symbol)
        yield force, a.value(momentum.xreplace(gains)) - a.value(momentum.xreplace(still))


def _energy(a: Arithmetic, outputs: Outputs, graphs: Graphs) -> Pairs:
    known = _totals(graphs)
    yield outputs["kinetic"][0], a.value(known.kinetic)
    yield outputs["potential"][0], a.value(known.potential)
    yield outputs["total"][0], a.value(known.kinetic) + a.value(known.potential)


def _momenta(a: Arithmetic, outputs: Outputs, graphs: Graphs) -> Pairs:
    known = _totals(graphs)
    yield from _equal(a, outputs["linear"], known.linear_momentum)
    yield from _equal(a, outputs["angular"], known.angular_momentum)
    rates = [known.kinetic.diff(u) for u in graphs.derived.scene.u]
    yield from _equal(a, outputs["generalized"], rates)


def _reactions(a: Arithmetic, outputs: Outputs, graphs: Graphs) -> Pairs:
    left, right = graphs.derived.system
    rows = [[a.value(left[i, j]) for j in range(left.cols)] for i in range(left.rows)]
    solution = a.solve(rows, [a.value(entry) for entry in right])
    for symbol, number in zip(graphs.derived.unknowns, solution, strict=True):
        a.assign(symbol, number)
    yield from _equal(a, outputs["reactions"], [value for _, value in graphs.derived.reactions])


def _coordinate_rates(a: Arithmetic, outputs: Outputs, graphs: Graphs) -> Pairs:
    yield from _equal(a, outputs["qd"], list(graphs.derived.scene.coordinate_rates.values()))


def _jacobians(a: Arithmetic, outputs: Outputs, graphs: Graphs) -> Pairs:
    """The derivative of the solution, solved for in the arithmetic."""
    left, right = graphs.derived.system
    rows = [[a.value(left[i, j]) for j in range(left.cols)] for i in range(left.rows)]
    solution = a.solve(rows, [a.value(entry) for entry in right])
    n = len(graphs.quantities.ud)
    for group in STATE:
        for k, entry in enumerate(getattr(graphs.quantities, group)):
            change = left.diff(entry.symbol)
            rest = [
                a.value(right[i].diff(entry.symbol)) - _row(a, change, i, solution)
                for i in range(left.rows)
            ]
            derivative = a.solve(rows, rest)
            for i in range(n):
                yield outputs[f"ud_{group}"][k * n + i], derivative[i]


def _totals(graphs: Graphs) -> Totals:
    return totals(graphs.derived.scene)


def _equal(a: Arithmetic, numbers: Sequence[Number], expressions: Sequence[Expr]) -> Pairs:
    for number, expression in zip(numbers, expressions, strict=True):
        yield number, a.value(Add(expression))


def _matrix(output: str) -> Law:
    """A law for an output that is one matrix of the equations, column by column."""

    def law(a: Arithmetic, outputs: Outputs, graphs: Graphs) -> Pairs:
        matrix = graphs.derived.mass if output == "mass_matrix" else graphs.derived.forcing
        yield from _equal(a, outputs[output], list(matrix.T))

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
}

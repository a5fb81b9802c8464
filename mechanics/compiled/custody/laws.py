"""What each function of a model has to be, in terms of what was derived.

    forward dynamics     K x = k,  K = [[M, -B], [A, 0]],  k = [f, b],  x what the graph gives
    jacobians            column = dx/ds,  x = K^-1 k,  s in q, u, inputs, p
    step                 y + h/6 (k1 + 2 k2 + 2 k3 + k4) of the rates, themselves K x = k
    the rest             graph = expression

A law gives, by output, pairs of values that have to be equal: the graph's, and what was derived.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from sympy import Expr

from mechanics.compiled.custody.physics import Entry, Physics
from mechanics.program import Builder, Node, gradient, tangent
from mechanics.program.interpret import include
from mechanics.program.sympy_reader import read

Outputs = dict[str, list[Node]]
Law = Callable[[Physics, Outputs], Iterator[Entry]]

STATE = ("q", "u", "inputs", "p")


def _forward_dynamics(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    known, zero = physics.textbook, physics.builder.zero
    solution = outputs["ud"] + outputs["multipliers"]
    # The value of a row at what the graph gives; M and f would be its slope and its rest.
    at = dict(zip(known.unknowns, solution, strict=True)) if known.rows else {}
    for i, row in enumerate(physics.nodes(known.rows, at)):
        yield f"row {i} as derived", row, zero
    matrix, right = _system(physics)
    for i, (entries, side) in enumerate(zip(matrix, right, strict=True)):
        yield f"row {i} of K x = k", _dot(physics, entries, solution), side


def _rates(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    yield from _forward_dynamics(physics, outputs)
    yield from _coordinate_rates(physics, outputs)


def _system(physics: Physics) -> tuple[list[list[Node]], list[Node]]:
    """K and k."""
    left, right = physics.textbook.left, physics.textbook.right
    entries = physics.nodes([*left, *right])
    size = left.cols
    rows = [entries[size * i : size * (i + 1)] for i in range(left.rows)]
    return rows, entries[size * left.rows :]


def _solution(physics: Physics) -> list[Node]:
    """x = K^-1 k."""
    return list(physics.builder.solve(*_system(physics)))


def _dot(physics: Physics, row: Sequence[Node], vector: Sequence[Node]) -> Node:
    total = physics.builder.zero
    for entry, number in zip(row, vector, strict=True):
        total = total + entry * number
    return total


def _residual(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    matrix, right = _system(physics)
    unknowns = physics.nodes(physics.textbook.unknowns)
    rows = zip(outputs["residual"], matrix, right, strict=True)
    for i, (number, entries, side) in enumerate(rows):
        yield f"residual[{i}]", number, _dot(physics, entries, unknowns) - side


def _momentum(physics: Physics, speeds: Sequence[Node]) -> tuple[Node, ...]:
    """dT/du at other speeds."""
    known, own = physics.textbook, Builder()
    (kinetic,) = read(own, [known.kinetic])
    symbols = known.symbols["u"]
    rates = gradient([kinetic], [1], [own.input(symbol.name) for symbol in symbols])
    given = {symbol.name: node for symbol, node in physics.leaves.items()}
    given |= {symbol.name: speed for symbol, speed in zip(symbols, speeds, strict=True)}
    program = own.program({"momentum": rates})
    given = {name: node for name, node in given.items() if name in program.inputs}
    return include(physics.builder, program, given)["momentum"]


def _inverse_dynamics(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    """tau = M_T w with w = u' - what the loads give, the latter solved for.

    dT/du is affine in u with the slope M_T: tau is its change from u = 0 to u = w.
    """
    wanted, zero = physics.inputs["ud"], physics.builder.zero
    gains = [x - y for x, y in zip(wanted, _solution(physics), strict=False)]
    moving = _momentum(physics, gains)
    still = _momentum(physics, [zero] * len(gains))
    for i, force in enumerate(outputs["forces"]):
        yield f"forces[{i}]", force, moving[i] - still[i]


def _energy(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    kinetic, potential = physics.nodes([physics.textbook.kinetic, physics.textbook.potential])
    yield "kinetic[0]", outputs["kinetic"][0], kinetic
    yield "potential[0]", outputs["potential"][0], potential
    yield "total[0]", outputs["total"][0], kinetic + potential


def _momenta(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    yield from _equal(physics, outputs, "linear", physics.textbook.linear)
    yield from _equal(physics, outputs, "angular", physics.textbook.angular)
    rates = _momentum(physics, physics.inputs["u"])
    for i, (number, rate) in enumerate(zip(outputs["generalized"], rates, strict=True)):
        yield f"generalized[{i}]", number, rate


def _reactions(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    known = physics.textbook
    at = dict(zip(known.unknowns, _solution(physics), strict=True))
    values = physics.nodes([value for _, value in known.reactions], at)
    for i, (number, value) in enumerate(zip(outputs["reactions"], values, strict=True)):
        yield f"reactions[{i}]", number, value


def _coordinate_rates(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    yield from _equal(physics, outputs, "qd", physics.textbook.rates)


def _jacobians(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    """Derivatives of the solution, by the rule for one of a linear system."""
    solution, one = _solution(physics), physics.builder.one
    n = len(physics.inputs["ud"])
    for group in STATE:
        for k, node in enumerate(physics.inputs[group]):
            derivative = tangent(solution, {node: one})
            for i in range(n):
                at = k * n + i
                yield f"ud_{group}[{at}]", outputs[f"ud_{group}"][at], derivative[i]


def _equal(
    physics: Physics, outputs: Outputs, name: str, expressions: Sequence[Expr]
) -> Iterator[Entry]:
    nodes = physics.nodes(expressions)
    for i, (number, node) in enumerate(zip(outputs[name], nodes, strict=True)):
        yield f"{name}[{i}]", number, node


def _matrix(output: str) -> Law:
    """A law for an output that is one matrix of the equations, column by column."""

    def law(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
        known = physics.textbook
        matrix = known.mass if output == "mass_matrix" else known.forcing
        yield from _equal(physics, outputs, output, list(matrix.T))

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

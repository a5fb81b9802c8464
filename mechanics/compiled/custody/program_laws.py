"""What each function of a model has to be where what was derived is a program.

    forward dynamics     rows(q, u, x) = 0,  A u' = b,  x = (u', lambda) what the graph gives
    jacobians            K (J w) + (d rows / d s) w = 0 at x,  s in q, u, inputs, p;  any w
    mass matrix          d rows / d u'
    forcing              -rows(q, u, 0)
    residual             rows and A u' - b
    inverse dynamics     rows at the multipliers of forward dynamics
    the rest             graph = program

K is the matrix of the rows and the constraints for x; without constraints it is M.
The rows of forward dynamics are those of the route, all others are power-conjugate to u, but where
there is friction. The law of
Jacobians is linear in w: it holds for symbols if and only if it does for every column.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from mechanics.compiled.custody.derived_program import DerivedProgram
from mechanics.compiled.custody.laws import STATE, Law, Outputs
from mechanics.compiled.custody.physics import Entry, Physics
from mechanics.program import Node
from mechanics.program.derivatives import tangent
from mechanics.program.interpret import include
from mechanics.program.vectors import Matrix
from mechanics.routes.rows import coefficients, remainder, substitute

Nodes = Sequence[Node]


def _derived(physics: Physics) -> dict[str, tuple[Node, ...]]:
    """What was derived, at the values of fixed parameters."""
    known = physics.known
    assert isinstance(known, DerivedProgram)
    fixed = {s.name: physics.leaves[s] for s in known.fixed if s.name in known.program.inputs}
    return include(physics.builder, known.program, fixed)


def _at(physics: Physics, rows: Nodes, accelerations: Nodes) -> Nodes:
    """Rows with other accelerations."""
    unknowns = [*physics.inputs["ud"], *physics.inputs["multipliers"]]
    values = dict(zip(unknowns, accelerations, strict=True))
    return substitute(physics.builder, rows, values)


def _zero(physics: Physics, rows: Nodes) -> Iterator[Entry]:
    for i, row in enumerate(rows):
        yield f"row {i}", row, physics.builder.zero


def _equal(name: str, numbers: Nodes, wanted: Nodes) -> Iterator[Entry]:
    for i, (number, node) in enumerate(zip(numbers, wanted, strict=True)):
        yield f"{name}[{i}]", number, node


def _unknowns(physics: Physics) -> list[Node]:
    return [*physics.inputs["ud"], *physics.inputs["multipliers"]]


def _system(physics: Physics) -> tuple[Nodes, Matrix, tuple[Node, ...]]:
    """The conjugate rows and the constraints, their matrix K, and the solution (u', lambda)."""
    derived, build, unknowns = _derived(physics), physics.builder, _unknowns(physics)
    rows = (*derived["conjugate"], *derived["constraints"])
    matrix = coefficients(rows, unknowns)
    right = [-entry for entry in remainder(build, rows, unknowns)]
    return rows, matrix, build.solve(matrix, right)


def _forward_dynamics(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    derived = _derived(physics)
    found = [*outputs["ud"], *outputs["multipliers"]]
    rows = (*derived["rows"], *derived["constraints"])
    yield from _zero(physics, _at(physics, rows, found))


def _residual(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    derived = _derived(physics)
    wanted = (*derived["conjugate"], *derived["constraints"])
    yield from _equal("residual", outputs["residual"], wanted)


def _inverse_dynamics(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    rows, multipliers = _derived(physics)["conjugate"], physics.inputs["multipliers"]
    if multipliers:
        _, _, solved = _system(physics)
        values = dict(zip(_unknowns(physics), solved, strict=True))
        kept = {name: values[name] for name in multipliers}
        rows = substitute(physics.builder, rows, kept)
    yield from _equal("forces", outputs["forces"], rows)


def _rates(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    yield from _forward_dynamics(physics, outputs)
    yield from _equal("qd", outputs["qd"], _derived(physics)["rates"])


def _mass_matrix(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    rows = coefficients(_derived(physics)["conjugate"], physics.inputs["ud"])
    columns = [row[j] for j in range(len(rows)) for row in rows]
    yield from _equal("mass_matrix", outputs["mass_matrix"], columns)


def _forcing(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    rest = remainder(physics.builder, _derived(physics)["conjugate"], _unknowns(physics))
    yield from _equal("forcing", outputs["forcing"], [-entry for entry in rest])


def _jacobians(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    build, n = physics.builder, len(physics.inputs["ud"])
    rows, matrix, solved = _system(physics)
    along: dict[Node, Node] = {}
    moved = [build.zero] * n
    for group in STATE:
        for k, entry in enumerate(physics.inputs[group]):
            weight = along[entry] = build.input(f"weight of {group} {k}")
            column = outputs[f"ud_{group}"][n * k : n * (k + 1)]
            moved = [total + weight * slope for total, slope in zip(moved, column, strict=True)]
    slopes = _at(physics, tangent(rows, along), solved)
    if len(rows) > n:
        # The rates of the multipliers are no output.
        wanted = build.solve(matrix, [-slope for slope in slopes])
        yield from _equal("row", moved, wanted[:n])
        return
    left = [
        sum((e * x for e, x in zip(row, moved, strict=True)), slope)
        for row, slope in zip(matrix, slopes, strict=True)
    ]
    yield from _zero(physics, left)


def _energy(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    derived = _derived(physics)
    (kinetic,), (potential,) = derived["kinetic"], derived["potential"]
    for name, value in zip(
        ("kinetic", "potential", "total"), (kinetic, potential, kinetic + potential), strict=True
    ):
        yield from _equal(name, outputs[name], [value])


def _reactions(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
    _, _, solved = _system(physics)
    wanted = _at(physics, _derived(physics)["reactions"], solved)
    yield from _equal("reactions", outputs["reactions"], wanted)


def _same(**pairs: str) -> Law:
    """Outputs of a graph that are outputs of the program."""

    def law(physics: Physics, outputs: Outputs) -> Iterator[Entry]:
        derived = _derived(physics)
        for own, name in pairs.items():
            yield from _equal(own, outputs[own], derived[name])

    return law


PROGRAM_LAWS: dict[str, Law] = {
    "forward_dynamics": _forward_dynamics,
    "mass_matrix": _mass_matrix,
    "forcing": _forcing,
    "residual": _residual,
    "inverse_dynamics": _inverse_dynamics,
    "energy": _energy,
    "momenta": _same(linear="linear", angular="angular", generalized="generalized"),
    "coordinate_rates": _same(qd="rates"),
    "reactions": _reactions,
    "jacobians": _jacobians,
    "rates": _rates,
}
"""By name of a function. The step is composed of the rates, see `custody.step`."""

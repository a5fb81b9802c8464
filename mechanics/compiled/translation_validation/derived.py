"""What was derived, as a program: the left side of the first step of the chain.

    rows(q, u, u', lambda) = 0        closing = A u' - b = 0        q' = rates
    residual = [M u' - f - B lambda; A u' - b]                      kinetic, potential, momenta, ...

Rows are those of the route. M and f are as they are written out, or of rows conjugate to u where
they are not.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sympy import Expr, Matrix, Symbol

from mechanics.compiled.graphs import Graphs
from mechanics.compiled.outputs import every_reaction
from mechanics.compiled.reduced import Reduced, output_name
from mechanics.equations import Equations, Rows
from mechanics.kinematics import differentiate
from mechanics.kinematics.motion import body_motions
from mechanics.kinematics.outputs import output_functions, output_matrix
from mechanics.mechanism import Mechanism, lower
from mechanics.program import Builder, Program
from mechanics.program.builder import Node
from mechanics.program.derivatives import gradient
from mechanics.program.interpret import include
from mechanics.program.sympy_reader import read
from mechanics.program.vectors import add, cross, dot, scale, times, transpose, zeros
from mechanics.routes import kane
from mechanics.routes.loads import potential
from mechanics.routes.rows import acceleration_forms, coefficients, remainder, substitute
from mechanics.scene.rates import TIME

GROUPS = ("q", "u", "ud", "inputs", "p", "multipliers", "reactions", "h")

WANTED = "output "
"""What the names of outputs of a scene begin with, in the program of what was derived."""

Outputs = dict[str, Sequence[Node]]


@dataclass(frozen=True, eq=False)
class Derived:
    """What was derived, before parameters are fixed.

    Attributes
    ----------
    symbols : mapping of str to tuple of Symbol
        By group, in the order of the arrays.
    fixed : mapping of Symbol to Expr
        Exact values of parameters that are no input.
    time : int or None
        Entry of the inputs that is the time.
    program : Program
        Outputs: ``rows``, ``closing``, ``mass`` column by column, ``forcing``, ``residual``,
        ``rates``, ``kinetic``, ``potential``, ``linear``, ``angular``, ``generalized`` and
        ``reactions``; outputs of the scene, column by column; ``forces`` where rows conjugate to u
        give the inverse dynamics, at the multipliers of the motion. u' and the multipliers are
        inputs.
    """

    scene: str
    route: str
    symbols: Mapping[str, tuple[Symbol, ...]]
    fixed: Mapping[Symbol, Expr]
    time: int | None
    program: Program

    @property
    def constrained(self) -> bool:
        """Whether its states are those on constraints."""
        return bool(self.program.outputs.get("closing"))


def derived(graphs: Graphs) -> Derived:
    """What was derived, for all functions of a model."""
    equations, known = graphs.derived, graphs.quantities
    mechanism = equations.mechanism or lower(equations.scene, Builder())
    route, outputs = equations.route, {
        "rates": mechanism.q_rates, **_of_bodies(mechanism),
    }  # fmt: skip
    if equations.textbook is None:
        route, system = _of_program(*equations.program)
    else:
        system = _of_matrices(equations, mechanism)
    told = [entry.symbol.name for entry in known.reactions]
    reactions = _reactions(equations, mechanism) if told else {}
    outputs |= {**system, "reactions": [reactions[name] for name in told]}
    if graphs.reduced is not None:
        outputs |= _reduced(graphs.reduced, mechanism)
    symbols = {g: tuple(e.symbol for e in getattr(known, g)) for g in GROUPS}
    times = [i for i, symbol in enumerate(symbols["inputs"]) if symbol == TIME]
    return Derived(
        equations.scene.name, route, symbols, graphs.fixed, times[0] if times else None,
        mechanism.builder.program(outputs),
    )  # fmt: skip


def _reduced(reduced: Reduced, mechanism: Mechanism) -> Outputs:
    """Functions that are reduced, the mass matrix column by column."""
    found: Outputs = {}
    for function, program in reduced.functions.items():
        for output, nodes in include(mechanism.builder, program).items():
            n = len(mechanism.ud) if output == "mass_matrix" else 1
            columns = [node for j in range(n) for node in nodes[j::n]]
            found[output_name(function, output)] = columns
    return found


def _of_bodies(mechanism: Mechanism) -> Outputs:
    """Energies and momenta by positions that are differentiated, which no graph is made from."""
    build = mechanism.builder
    kinetic, linear, angular = build.zero, zeros(build), zeros(build)
    motions = differentiate.motions(mechanism)
    for body, motion in zip(mechanism.bodies, body_motions(mechanism, motions), strict=True):
        momentum = scale(body.mass, motion.centre.velocity)
        kinetic = kinetic + dot(momentum, motion.centre.velocity) / 2
        linear = add(linear, momentum)
        angular = add(angular, cross(motion.centre.position, momentum))
        if motion.turning is not None and motion.inertia is not None:
            spin = times(motion.inertia, motion.turning.omega)
            kinetic = kinetic + dot(spin, motion.turning.omega) / 2
            angular = add(angular, spin)
    wanted = {}
    for name, of in output_functions(mechanism).items():
        _, matrix = output_matrix(mechanism, motions, *of)
        wanted[f"{WANTED}{name}"] = [entry for column in transpose(matrix) for entry in column]
    return {
        **wanted,
        "kinetic": [kinetic],
        "potential": [potential(mechanism, motions.poses)],
        "linear": linear,
        "angular": angular,
        "generalized": gradient([kinetic], [1], mechanism.u),
    }


def _of_matrices(equations: Equations, mechanism: Mechanism) -> Outputs:
    """Rows, constraints, M, f and the residual where they are written out."""
    build, matrices = mechanism.builder, equations.matrices
    sides = matrices.constraint_matrix * Matrix(equations.scene.ud) - matrices.constraint_bias
    rows, closing = read(build, list(equations.residual)), read(build, list(sides))
    found: Outputs = {
        "rows": rows,
        "closing": closing,
        "mass": read(build, list(matrices.mass.T)),
        "forcing": read(build, list(matrices.forcing)),
        "residual": [*rows, *closing],
    }
    if equations.rows is not None:
        found |= {"rows": equations.rows.values, "closing": acceleration_forms(mechanism)}
        if not mechanism.constraints and not mechanism.frictions:
            found["forces"] = kane.derive(mechanism).values
    return found


def _of_program(mechanism: Mechanism, route: Rows) -> tuple[str, Outputs]:
    """The same where they are not, and the route whose rows they are."""
    name, rows, closing = route.route, route.values, acceleration_forms(mechanism)
    # Conjugate to u, in the multipliers of the route; under friction as the route has them.
    own = mechanism.frictions or name == "lagrange"
    conjugate = rows if own else kane.derive(mechanism).values
    if conjugate != rows and mechanism.constraints:
        values = _solved(mechanism, conjugate, route.multipliers)
        anywhere, _ = mechanism.filters
        if not all(map(anywhere.is_zero, substitute(mechanism.builder, rows, values))):
            # Where the route closes a loop otherwise, its rows hold on the constraints only.
            name, rows = "kane", conjugate
    matrix = coefficients(conjugate, mechanism.ud)
    rest = remainder(mechanism.builder, conjugate, (*mechanism.ud, *route.multipliers))
    return name, {
        "rows": rows,
        "closing": closing,
        "mass": [row[j] for j in range(len(mechanism.ud)) for row in matrix],
        "forcing": [-entry for entry in rest],
        "residual": [*conjugate, *closing],
        "forces": conjugate,
    }


def _solved(
    mechanism: Mechanism, rows: Sequence[Node], multipliers: Sequence[Node]
) -> dict[Node, Node]:
    """u' and the multipliers as one operation on the state."""
    unknowns = (*mechanism.ud, *multipliers)
    every = [*rows, *acceleration_forms(mechanism)]
    right = [-entry for entry in remainder(mechanism.builder, every, unknowns)]
    values = mechanism.builder.solve(coefficients(every, unknowns), right)
    return dict(zip(unknowns, values, strict=True))


def _reactions(equations: Equations, mechanism: Mechanism) -> Mapping[str, Node]:
    """Reactions by name, in u' and the multipliers; where no route has them written, of all."""
    if equations.textbook is None:
        nodes: Sequence[Node] = every_reaction(mechanism)
        if mechanism.constraints or mechanism.frictions:
            own = kane.derive(mechanism)
            values = _solved(mechanism, own.values, own.multipliers)
            nodes = substitute(mechanism.builder, nodes, values)
        return dict(zip((r.name for r in mechanism.reactions), nodes, strict=True))
    if equations.rows is not None:
        return equations.rows.reactions
    names, written = zip(*equations.reactions, strict=True)
    nodes = read(mechanism.builder, written)
    return dict(zip((symbol.name for symbol in names), nodes, strict=True))

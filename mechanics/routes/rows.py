"""Rows that vanish along every motion, split and put together, and constraints as conditions.

row(q, u, u', lambda) = 0          linear in u' and lambda
A u' - b = 0                       d/dt of each constraint's form in q and u
"""

from collections.abc import Mapping, Sequence

from mechanics.errors import SceneError
from mechanics.mechanism import Mechanism, inputs_of
from mechanics.program.builder import Builder, Node
from mechanics.program.derivatives import gradient
from mechanics.program.forward import tangent
from mechanics.program.interpret import include
from mechanics.program.vectors import Matrix


def velocity_forms(mechanism: Mechanism) -> list[Node]:
    """Each constraint as a node in q and u that vanishes, linear in u.

    Raises
    ------
    SceneError
        When a holonomic constraint holds speeds.
    """
    forms, rates, speeds = [], mechanism.rates, {*mechanism.u, *mechanism.ud}
    for constraint in mechanism.constraints:
        expression = constraint.expression
        if constraint.holonomic:
            if not speeds.isdisjoint(inputs_of([expression])):
                raise SceneError(
                    f"constraint {constraint.name}: a holonomic constraint holds no speeds:"
                    " declare it with nonholonomic(...)"
                )
            (expression,) = tangent([expression], rates)
        forms.append(expression)
    return forms


def acceleration_forms(mechanism: Mechanism) -> list[Node]:
    """A u' - b: each constraint differentiated down to u'."""
    forms = velocity_forms(mechanism)
    return tangent(forms, mechanism.rates) if forms else []


def coefficients(rows: Sequence[Node], unknowns: Sequence[Node]) -> Matrix:
    """Coefficients of rows that are linear in the unknowns, by one reverse walk a row."""
    return tuple(tuple(gradient([row], [1], unknowns)) for row in rows)


def substitute(
    builder: Builder, nodes: Sequence[Node], values: Mapping[Node, Node]
) -> tuple[Node, ...]:
    """The nodes with other nodes in the place of inputs."""
    program = builder.program({"nodes": nodes})
    names = {builder.inputs[builder.operands[0][old.number]]: new for old, new in values.items()}
    wanted = {name: new for name, new in names.items() if name in program.inputs}
    return include(builder, program, wanted)["nodes"]


def remainder(builder: Builder, rows: Sequence[Node], unknowns: Sequence[Node]) -> tuple[Node, ...]:
    """The rows where all unknowns are zero."""
    return substitute(builder, rows, dict.fromkeys(unknowns, builder.zero))

"""Outputs of a scene to first order, in the terms of `mechanics.linear.linearize`.

    h(q, v, w)            an entry of an output
    dh = (h_q G - h_v Y^-1 X) z + h_v Y^-1 z' + h_w dw

An entry that changes with a coordinate that drifts, or with rates of the inputs, is none of these.
"""

from collections.abc import Mapping, Sequence

from mechanics.kinematics import chain
from mechanics.kinematics.outputs import output_matrix
from mechanics.linear.effect import depends
from mechanics.linear.nodes import Rows, difference, padded, product
from mechanics.linear.operating_point import Place
from mechanics.linear.reduction import Reduction
from mechanics.mechanism import ranges
from mechanics.program.builder import Node
from mechanics.routes.rows import coefficients, substitute
from mechanics.scene import Scene

COORDINATES, RATES, INPUTS = "output coordinates", "output rates", "output inputs"
"""Outputs of the program: factors of z, of z' and of the inputs."""


def entry_names(scene: Scene) -> tuple[str, ...]:
    """Of all entries of all outputs: ``"tool_x"``, ``"slip"``."""
    return tuple(
        f"{name}{end}" for name, output in scene.outputs.items() for end, _ in output.entries
    )


def entries(moving: Reduction) -> tuple[Node, ...]:
    """h of every entry, in q, independent speeds and inputs."""
    mechanism = moving.mechanism
    motions = chain.motions(mechanism)
    nodes = [
        node
        for output in mechanism.outputs
        for row in output_matrix(mechanism, motions, output, False)[1]
        for node in row
    ]
    table = {u: v for u, v in zip(mechanism.u, moving.speeds, strict=True) if u != v}
    return substitute(mechanism.builder, nodes, table) if table else tuple(nodes)


def not_linear(
    moving: Reduction, plain: Place, nodes: Sequence[Node], names: Sequence[str],
    moves: Mapping[str, str],
) -> str:  # fmt: skip
    """Why an entry is no C y + D w; empty where all are.

    Parameters
    ----------
    plain : Place
        With relations of parameters, but without the operating point.
    nodes, names : sequences
        Of the entries.
    moves : mapping of str to str
        What no entry may change with, and why.
    """
    signs = ranges(moving.mechanism)
    for name, node in zip(names, plain(nodes), strict=True):
        for what, why in moves.items():
            if depends(plain, [node], plain.builder.input(what), signs, {}):
                return f"output {name} changes with {what}, {why}"
    return ""


def output_rows(
    moving: Reduction, place: Place, nodes: Sequence[Node], kept: Sequence[int],
    reach: Rows, turn: Rows, carried: Rows, driven: Sequence[str],
) -> dict[str, Rows]:  # fmt: skip
    """The factors of z, z' and the inputs; `reach` is of the coordinates in `kept`."""
    mechanism, build = moving.mechanism, place.builder
    inputs = [mechanism.builder.input(name) for name in driven]
    by_place = place.matrix(coefficients(nodes, [mechanism.q[i] for i in kept]))
    by_speeds = place.matrix(coefficients(nodes, moving.v))
    held = product(by_speeds, carried)
    return {
        COORDINATES: difference(padded(build, product(by_place, reach), len(turn)), held),
        RATES: product(by_speeds, turn),
        INPUTS: place.matrix(coefficients(nodes, inputs)),
    }

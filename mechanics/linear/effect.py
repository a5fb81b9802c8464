"""Which coordinates have an effect on a motion, and which are cyclic.

    q_i has none  <=>  dF/dq_i = 0 where F(q, v, v') = 0,  dphi/dq_i = 0,
                       dq_k'/dq_i = 0 for all q_k that have one

Rows may be combined otherwise at another heading, the accelerations v' that they give are the same.
A wheel's angle, a top's spin, where a wheel is on the plane and where it is heading: such
coordinates may drift along a steady motion.
"""

from collections.abc import Mapping, Sequence

from sympy import Expr, Symbol

from mechanics.kernel import Range, Statement, decide
from mechanics.linear.operating_point import Place
from mechanics.linear.reduction import Reduction
from mechanics.mechanism import ranges
from mechanics.program.builder import Node
from mechanics.program.forward import tangent
from mechanics.program.residues import Residues
from mechanics.routes.rows import coefficients, remainder, substitute


def effective(reduction: Reduction, parameters: Mapping[Symbol, Expr]) -> frozenset[int]:
    """The coordinates that have an effect, by their places.

    A coordinate that is not shown to have none counts as one.

    Parameters
    ----------
    parameters : mapping of Symbol to Expr
        Relations under which it is asked.
    """
    mechanism = reduction.mechanism
    place = Place(mechanism.builder, {s.name: value for s, value in parameters.items()})
    laws = place([*reduction.configuration, *reduction.rows])
    solved = accelerations(place, reduction)
    rates, signs = place(reduction.rates), ranges(mechanism)
    slopes = [_slopes(laws, q, solved) for q in place(mechanism.q)]
    of_rates = [[_slopes([rate], q, solved) for q in place(mechanism.q)] for rate in rates]
    residues = Residues(place.builder)

    def differ(nodes: Sequence[Node]) -> bool:
        return any(residues.values(nodes))

    found = {i for i, nodes in enumerate(slopes) if differ(nodes)}
    while True:
        waiting = sorted(found)
        while waiting:
            row = of_rates[waiting.pop()]
            more = {i for i, nodes in enumerate(row) if i not in found and differ(nodes)}
            found |= more
            waiting += sorted(more)
        others = [i for i in range(len(rates)) if i not in found]
        left = {i: [*slopes[i], *(n for k in found for n in of_rates[k][i])] for i in others}
        together = [node for nodes in left.values() for node in nodes]
        open_ones: set[int] = set()
        if not _zero(place, together, signs):
            open_ones = {i for i, nodes in left.items() if not _zero(place, nodes, signs)}
        if not open_ones:
            return frozenset(found)
        found |= open_ones


def _slopes(nodes: Sequence[Node], on: Node, solved: Mapping[Node, Node]) -> list[Node]:
    """Derivatives by an input that are not structurally 0, v' put in."""
    build = on.builder
    slopes = [node for node in tangent(nodes, {on: build.one}) if not node.is_zero]
    return list(substitute(build, slopes, solved)) if slopes else []


def _zero(place: Place, nodes: Sequence[Node], signs: Mapping[str, Range]) -> bool:
    """Whether the kernel shows that all of them are 0."""
    if not nodes:
        return True
    program = place.builder.program({"left": nodes, "right": [0] * len(nodes)})
    known = {name: sign for name, sign in signs.items() if name in program.inputs}
    return decide(Statement("no effect", program, known), try_normal=False).shown


def accelerations(place: Place, reduction: Reduction) -> dict[Node, Node]:
    """v' of F(q, v, v') = 0, in place of the inputs v'."""
    vd, rows = place(reduction.vd), place(reduction.rows)
    matrix = coefficients(rows, vd)
    sides = [-entry for entry in remainder(place.builder, rows, vd)]
    return dict(zip(vd, place.builder.solve(matrix, sides), strict=True))


def depends(
    place: Place,
    nodes: Sequence[Node],
    on: Node,
    signs: Mapping[str, Range],
    solved: Mapping[Node, Node],
) -> bool:
    """Whether nodes are not shown to be the same whatever an input is.

    Parameters
    ----------
    nodes : sequence of Node
        Of its builder.
    on : Node
        The input.
    solved : mapping of Node to Node
        What takes the place of other inputs in the derivatives.
    """
    slopes = _slopes(nodes, on, solved)
    return any(Residues(place.builder).values(slopes)) or not _zero(place, slopes, signs)

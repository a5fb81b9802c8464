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
from mechanics.mechanism import name_of, ranges
from mechanics.program.builder import Node
from mechanics.program.forward import tangent
from mechanics.program.residues import Residues
from mechanics.routes.rows import coefficients, remainder, substitute


def effective(reduction: Reduction, parameters: Mapping[Symbol, Expr]) -> frozenset[int]:
    """The coordinates that have an effect, by their places.

    A coordinate that is not shown to have none counts as one.

    Parameters
    ----------
    reduction : Reduction
    parameters : mapping of Symbol to Expr
        Relations under which it is asked.
    """
    mechanism = reduction.mechanism
    held = {s.name: value for s, value in parameters.items()}
    place = Place(mechanism.builder, held)
    laws = place([*reduction.configuration, *reduction.rows])
    solved = accelerations(place, reduction)
    rates = place(reduction.rates)
    coordinates = place(mechanism.q)
    signs = ranges(mechanism)
    places = range(len(coordinates))
    found = {i for i in places if depends(place, laws, coordinates[i], signs, solved)}
    waiting = sorted(found)
    while waiting:
        k = waiting.pop()
        more = [i for i in places if i not in found]
        more = [i for i in more if depends(place, [rates[k]], coordinates[i], signs, solved)]
        found.update(more)
        waiting += more
    return frozenset(found)


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
    place : Place
    nodes : sequence of Node
        Of its builder.
    on : Node
        The input.
    signs : mapping of str to Range
    solved : mapping of Node to Node
        What takes the place of other inputs in the derivatives.
    """
    build = place.builder
    slopes = [node for node in tangent(nodes, {on: build.one}) if not node.is_zero]
    if not slopes:
        return False
    slopes = list(substitute(build, slopes, solved))
    if any(Residues(build).values(slopes)):
        return True
    program = build.program({"left": slopes, "right": [0] * len(slopes)})
    subject = f"{name_of(on)} has no effect"
    known = {name: sign for name, sign in signs.items() if name in program.inputs}
    return not decide(Statement(subject, program, known), try_normal=False).shown

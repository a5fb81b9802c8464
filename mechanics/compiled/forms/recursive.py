"""Forward dynamics of a tree of bodies, body by body: operations grow with the number of bodies.

    G(u')  ->  least        where G is Gauss's function (`bodies.function`)

The accelerations that it is written in are eliminated from the leaves to the root, by which
articulated inertias come about, and found again from the root to the leaves: the articulated-body
algorithm (Featherstone, Rigid Body Dynamics Algorithms, 7.3), without the zeros, and with
accelerations in place of joint coordinates wherever one unknown can stand for the other. On the way
back they are passed on in the components of the bodies, or in inertial ones, which rounds better.
"""

import casadi as ca

from mechanics.compiled.forms.bodies.function import gauss_function
from mechanics.compiled.forms.bodies.leaf_to_root import Way, eliminated, values
from mechanics.compiled.forms.bodies.reading import Reading
from mechanics.compiled.forms.bodies.tried import tried
from mechanics.compiled.forms.operations import operations
from mechanics.compiled.forms.system import System
from mechanics.compiled.forms.weigh import lightest
from mechanics.equations import Equations
from mechanics.scene.actions import frictions

MORE = 1.25
"""How many times the operations it may take to be on the safe side where errors are not tried."""


def unsuited(equations: Equations) -> str:
    """Why u' cannot be written so; empty where it can."""
    return inapplicable(equations) or tried(equations, _solved).failure


def inapplicable(equations: Equations) -> str:
    """Why there is no tree to go along; empty where there may be one."""
    if equations.rows is None:
        return f"the equations by {equations.route} are not those of the scene's bodies"
    if equations.scene.constraints:
        named = ", ".join(constraint.name for constraint in equations.scene.constraints)
        return f"the bodies are no tree, for {named} constrains them"
    if rubbing := frictions(equations.scene):
        named = ", ".join(load.name for load in rubbing)
        return f"{named} depends on a reaction, which Gauss's function does not hold"
    return ""


def ways(system: System) -> list[ca.SX]:
    """u' as a column, in every way; none where there is no tree."""
    equations = system.equations
    if inapplicable(equations):
        return []
    graphs = tried(equations, _solved).graphs(system)
    if not graphs or system.small:
        return [graph for _, graph in graphs]
    # What is not weighed by its errors is on the safe side, unless that costs a lot.
    counted = [(operations(graph), way, graph) for way, graph in graphs]
    few = min(count for count, _, _ in counted)
    safe = [x for count, way, x in counted if way.inertial and count <= MORE * few]
    return safe or [graph for _, graph in graphs]


def solve(system: System) -> ca.SX:
    """u' of a system."""
    return lightest(system, ways(system))


def _solved(reading: Reading, way: Way) -> ca.SX:
    scene, g = reading.scene, gauss_function(reading, way)
    unknowns = [*scene.ud, *g.definitions]
    value = values(g, eliminated(g, unknowns, reading.nonzero, way.rule))
    return ca.vertcat(*(value(symbol) for symbol in scene.ud))

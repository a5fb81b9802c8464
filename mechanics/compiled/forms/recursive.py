"""Forward dynamics of a tree of bodies, body by body: operations grow with the number of bodies.

    G(u')  ->  least        where G is Gauss's function (`bodies.function`)

The accelerations that it is written in are eliminated from the leaves to the root, by which
articulated inertias come about, and found again from the root to the leaves: the articulated-body
algorithm (Featherstone, Rigid Body Dynamics Algorithms, 7.3), without the zeros, and with
accelerations in place of joint coordinates wherever one unknown can stand for the other.
"""

from functools import cache

import casadi as ca

from mechanics.compiled.forms.bodies.function import gauss_function
from mechanics.compiled.forms.bodies.leaf_to_root import RULES, Rule, eliminated, values
from mechanics.compiled.forms.bodies.reading import Reading, scratch
from mechanics.compiled.forms.system import System
from mechanics.compiled.program import operations
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, SingularError


def inapplicable(equations: Equations) -> str:
    """Why there is no tree to go along; empty where there may be one."""
    if not equations.of_bodies:
        return f"the equations by {equations.route} are not those of the scene's bodies"
    if equations.scene.constraints:
        named = ", ".join(constraint.name for constraint in equations.scene.constraints)
        return f"the bodies are no tree, for {named} constrains them"
    return ""


def unsuited(equations: Equations) -> str:
    """Why u' cannot be written so; empty where it can."""
    return inapplicable(equations) or _failure(equations)


@cache
def _failure(equations: Equations) -> str:
    try:
        solution(Reading(equations.scene, scratch(equations), equations.fixed))
    except (ExpressionError, SingularError) as error:
        return str(error)
    return ""


def solution(reading: Reading) -> ca.SX:
    """u' as a column, by the order of elimination that takes the fewest operations."""
    return min((_solved(reading, rule) for rule in RULES), key=operations)


def _solved(reading: Reading, rule: Rule) -> ca.SX:
    scene, g = reading.scene, gauss_function(reading)
    found = values(eliminated(g, [*scene.ud, *g.definitions], reading.nonzero, rule))
    return ca.vertcat(*(found[symbol] for symbol in scene.ud))


def solve(system: System) -> ca.SX:
    """u' of a system."""
    equations = system.equations
    return solution(Reading(equations.scene, system.translate, equations.fixed))

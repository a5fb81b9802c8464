"""Forward dynamics of bodies in closed loops: a sparse system, in an order that fills in little.

    [ Q  -A^T ] [ y      ]   [ f  ]
    [-A   0   ] [ lambda ] = [ -b ]          A u' = b

y are u' and the accelerations that Gauss's function is written in (`bodies.function`). Q is
positive definite; a multiplier is eliminated when every acceleration that its constraint holds is
gone, so that its pivot -A Q^-1 A^T is less than zero. The rest of the order is by counted
operations.
"""

from functools import partial

import casadi as ca
from sympy import Expr, S

from mechanics.compiled.forms.bodies.function import gauss_function
from mechanics.compiled.forms.bodies.gauss import Gauss
from mechanics.compiled.forms.bodies.leaf_to_root import Way, eliminated, values
from mechanics.compiled.forms.bodies.reading import Reading
from mechanics.compiled.forms.bodies.tried import Tried, tried
from mechanics.compiled.forms.system import System
from mechanics.compiled.forms.weigh import lightest
from mechanics.equations import Equations
from mechanics.errors import ExpressionError
from mechanics.kinematics.constraints import constraint_rows
from mechanics.kinematics.textbook import differentiate
from mechanics.scene import Scene
from mechanics.scene.actions import unit_reactions
from mechanics.symbolic import canonical


def unsuited(equations: Equations) -> str:
    """Why the constraints cannot be taken along; empty where they can."""
    return inapplicable(equations) or _tried(equations).failure


def inapplicable(equations: Equations) -> str:
    """Why there are no constraints to take along; empty where there may be."""
    if equations.rows is None:
        return f"the equations by {equations.route} are not those of the scene's bodies"
    if not equations.scene.constraints:
        return "nothing constrains the coordinates: form 'recursive' is for trees"
    return ""


def _tried(equations: Equations) -> Tried:
    return tried(equations, partial(_solved, equations))


def ways(system: System) -> list[ca.SX]:
    """(u', lambda) as a column, in every way; none where nothing constrains."""
    equations = system.equations
    if inapplicable(equations):
        return []
    return [graph for _, graph in _tried(equations).graphs(system)]


def solve(system: System) -> ca.SX:
    """(u', lambda) of a system."""
    return lightest(system, ways(system))


def _solved(equations: Equations, reading: Reading, way: Way) -> ca.SX:
    scene, g = reading.scene, gauss_function(reading, way)
    names = [("multiplier", c.name) for c in scene.constraints]
    constrain(g, reading, names)
    unknowns = [*names, *scene.ud, *g.definitions]
    value = values(g, eliminated(g, unknowns, reading.nonzero, way.rule, names))
    column = [value(symbol) for symbol in scene.ud]
    if equations.multipliers:
        column += [s * value(name) for s, name in zip(signs(scene), names, strict=True)]
    return ca.vertcat(*column)


def constrain(g: Gauss, reading: Reading, names: list[tuple[str, str]]) -> None:
    """Add the constraints A u' = b to Gauss's function, each with its multiplier."""
    matrix, bias = constraint_rows(reading.scene)
    for i, name in enumerate(names):
        g.add_force(name, -reading(bias[i]))
        for j, symbol in enumerate(reading.scene.ud):
            entry = reading(matrix[i, j])
            if not entry.is_zero():
                g.couple(name, symbol, -entry)


def signs(scene: Scene) -> tuple[int, ...]:
    """For each constraint 1 if its reaction acts along its gradient, -1 if against it.

    Raises
    ------
    ExpressionError
        If it acts along neither.
    """
    matrix, _ = constraint_rows(scene)
    forces = generalized_reactions(scene)
    found = []
    for i, constraint in enumerate(scene.constraints):
        row = forces[i]
        for sign in (1, -1):
            if all(canonical(e - sign * g) == 0 for e, g in zip(row, matrix[i, :], strict=True)):
                found.append(sign)
                break
        else:
            raise ExpressionError(
                f"constraint {constraint.name}: its reaction does not act along its gradient, so"
                " that its multiplier is another quantity"
            )
    return tuple(found)


def generalized_reactions(scene: Scene) -> list[list[Expr]]:
    """For each constraint the generalized forces, conjugate to u, of a unit of its reaction."""
    motions = {motion.body.name: motion for motion in differentiate.body_motions(scene)}
    units = {symbol.name: pair for symbol, pair in unit_reactions(scene).items()}
    found = []
    for constraint in scene.constraints:
        power = S.Zero
        for name in constraint.reactions:
            for action in units[name]:
                motion = motions[action.body]
                arm = action.at - motion.centre.position
                spin = motion.angular_velocity
                power += action.force.dot(motion.centre.velocity + spin.cross(arm))
                power += action.couple.dot(spin)
        found.append([canonical(power.diff(u)) for u in scene.u])
    return found

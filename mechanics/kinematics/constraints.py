"""Constraints as conditions on speeds and their rates.

holonomic       phi(q) = 0        d phi/dt = 0, a form linear in u
nonholonomic    phi(q, u) = 0     the form itself
"""

from sympy import Expr

from mechanics.errors import SceneError
from mechanics.scene import Scene
from mechanics.scene.rates import rate, rate_table


def velocity_forms(scene: Scene) -> list[Expr]:
    """Each constraint as an expression in q and u that vanishes, linear in u.

    Raises
    ------
    SceneError
        When a holonomic constraint holds speeds.
    """
    table, forms = rate_table(scene), []
    for constraint in scene.constraints:
        expression = scene.plain(constraint.expression, f"constraint {constraint.name}")
        if constraint.holonomic:
            if expression.free_symbols & {*scene.u, *scene.ud}:
                raise SceneError(
                    f"constraint {constraint.name}: a holonomic constraint holds no speeds:"
                    " declare it with nonholonomic(...)"
                )
            expression = rate(expression, table)
        forms.append(expression)
    return forms

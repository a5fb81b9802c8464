"""Generalized momenta.

p_i = dT/dq_i' = sum over bodies (m v_C . dv_C/dq_i' + (I omega) . d(omega)/dq_i')

The momentum of a coordinate phi1 goes by the name p_phi1 and its rate by p_phi1_dot, in every
scene: nothing declares them, and a typed side that holds them is compared with them put in. So
Hamilton's equations are written as they are: q' in q and p is a kinematic relation, and p' in q and
p an equation of motion.
"""

from functools import lru_cache

from sympy import Derivative, Expr, S, Symbol, sympify
from sympy.core.function import AppliedUndef
from sympy.physics.vector import dynamicsymbols

from mechanics.kinematics.textbook import differentiate
from mechanics.kinematics.textbook.motion import inertia_matrix
from mechanics.scene import Scene
from mechanics.scene.rates import rate, rate_table
from mechanics.scene.symbols import parts_of, plain_table, symbols_of


@lru_cache(maxsize=32)
def momentum_symbols(scene: Scene) -> dict[Symbol, Symbol]:
    """The momentum of each coordinate, and the coordinate.

    Names that the scene uses for something else are left out.
    """
    taken = {s.name for s in (*scene.parameters, *scene.q, *scene.u, *scene.input_symbols)}
    taken |= {symbol.name for symbol in scene.definitions}
    taken |= {reaction.name for reaction in scene.reactions}
    names = {Symbol(f"p_{q.name}", real=True): q for q in scene.q}
    return {symbol: q for symbol, q in names.items() if symbol.name not in taken}


@lru_cache(maxsize=32)
def generalized_momenta(scene: Scene) -> dict[Symbol, Expr]:
    """p_i in q and u, by its symbol, in kg m/s or kg m^2/s."""
    rates = dict(zip(scene.q, scene.qd, strict=True))
    motions = differentiate.body_motions_in_rates(scene)
    found: dict[Symbol, Expr] = {}
    for symbol, q in momentum_symbols(scene).items():
        total: Expr = S.Zero
        for motion in motions:
            velocity = motion.centre.velocity
            total += motion.body.mass * velocity.dot(velocity.diff(rates[q]))
            if motion.turns:
                omega = motion.angular_velocity
                spin = inertia_matrix(scene, motion.body, motion.rotation) * omega
                total += spin.dot(omega.diff(rates[q]))
        found[symbol] = total.xreplace(scene.coordinate_rates)
    return found


@lru_cache(maxsize=32)
def _functions(scene: Scene) -> dict[Expr, Symbol]:
    """Momenta and their rates as functions of time, and the symbols for them."""
    return plain_table(dynamicsymbols(symbol.name) for symbol in momentum_symbols(scene))


def rate_symbol(momentum: Symbol) -> Symbol:
    """p_i' of p_i."""
    return Symbol(f"{momentum.name}_dot", real=True)


def momenta_written_out(scene: Scene, expression: Expr) -> Expr:
    """An expression with q, u and u' for the momenta that it holds and their rates.

    Parameters
    ----------
    scene : Scene
    expression : Expr
        In plain symbols, or with p_phi1 and p_phi1' as functions of time.
    """
    expression = sympify(expression)
    symbols, functions = momentum_symbols(scene), _functions(scene)
    if {e for e in parts_of([expression]) if isinstance(e, AppliedUndef)} & functions.keys():
        # d/dt of a whole expression is carried out before its functions become symbols.
        expression = (expression.doit() if expression.has(Derivative) else expression).xreplace(
            functions
        )
    held = symbols_of([expression])
    used = {p for p in symbols if {p, rate_symbol(p)} & held}
    if not used:
        return expression
    momenta, table = generalized_momenta(scene), rate_table(scene)
    values = {p: momenta[p] for p in used}
    values |= {rate_symbol(p): rate(momenta[p], table) for p in used}
    return expression.xreplace(values)

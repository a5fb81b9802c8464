"""Generalized momenta p_i = dT/dq_i' written out in q and u, wherever an expression holds them."""

from sympy import Derivative, Expr, sympify
from sympy.core.function import AppliedUndef
from sympy.physics.vector import dynamicsymbols

from mechanics.kinematics.symbolic import Kinematics
from mechanics.scene.momenta import momentum_symbols, rate_symbol
from mechanics.scene.rates import rate, rate_table
from mechanics.scene.symbols import parts_of, plain_table, symbols_of


def momenta_written_out(kinematics: Kinematics, expression: Expr) -> Expr:
    """An expression with q, u and u' for the momenta that it holds and their rates.

    Parameters
    ----------
    expression : Expr
        In plain symbols, or with p_phi1 and p_phi1' as functions of time.
    """
    expression, scene = sympify(expression), kinematics.scene
    symbols = momentum_symbols(scene)
    if applied := {e for e in parts_of([expression]) if isinstance(e, AppliedUndef)}:
        functions = plain_table(dynamicsymbols(symbol.name) for symbol in symbols)
        if applied & functions.keys():
            # d/dt of a whole expression is carried out before its functions become symbols.
            whole = expression.doit() if expression.has(Derivative) else expression
            expression = whole.xreplace(functions)
    held = symbols_of([expression])
    used = {p for p in symbols if {p, rate_symbol(p)} & held}
    values = {p: kinematics.momenta[p] for p in used}
    values |= {rate_symbol(p): rate(momentum, rate_table(scene)) for p, momentum in values.items()}
    return expression.xreplace(values)

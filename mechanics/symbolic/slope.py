"""Derivative of an expression wherever it has one: a sign is constant between its jumps.

d sign(x)/ds = 0,        d|x|/ds = sign(x) dx/ds        for x != 0
"""

import sympy


def slope(expression: sympy.Expr, symbol: sympy.Symbol) -> sympy.Expr:
    """Derivative by a symbol, where every sign in the expression keeps its value.

    SymPy's own derivative of a sign is a Dirac delta, which has no value at a state.
    """
    expression = sympy.sympify(expression)
    jumps = expression.atoms(sympy.sign)
    if not jumps:
        return expression.diff(symbol)
    held = {jump: sympy.Dummy(str(jump), real=True) for jump in jumps}
    back = {stand_in: jump for jump, stand_in in held.items()}
    # A sign within another one comes back with the outer one.
    return expression.xreplace(held).diff(symbol).xreplace(back)

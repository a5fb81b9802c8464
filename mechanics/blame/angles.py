"""Sines and cosines of sums, in those of the single angles, and back where that is shorter.

    cos(a + b) = cos a cos b - sin a sin b        cos a cos b = (cos(a - b) + cos(a + b)) / 2

Two ways of writing an equation have the same terms once every angle stands alone.
"""

from functools import lru_cache

from sympy import Add, Expr, Mul, Rational, S, cos, sin, sympify, tan

LARGEST_MULTIPLE = 12
"""Of an angle that is expanded: cos(12 a) has seven terms."""


def single_angles(expression: Expr) -> Expr:
    """The expression with every sine and cosine of a sum or multiple expanded."""
    table = {
        node: _expanded(node)
        for node in expression.atoms(sin, cos, tan)
        if not node.args[0].is_Symbol
    }
    return expression.xreplace(table) if table else expression


def _expanded(node: Expr) -> Expr:
    c, s = circle(node.args[0])
    if isinstance(node, tan):
        return s / c
    return c if isinstance(node, cos) else s


@lru_cache(maxsize=512)
def circle(angle: Expr) -> tuple[Expr, Expr]:
    """Cosine and sine of an angle, by the group law, term by term."""
    c: Expr = S.One
    s: Expr = S.Zero
    for term in Add.make_args(sympify(angle).expand()):
        factor, base = term.as_coeff_Mul()
        x, y = _multiple(factor, base)
        c, s = c * x - s * y, s * x + c * y
    return c, s


def _multiple(factor: Expr, base: Expr) -> tuple[Expr, Expr]:
    """Cosine and sine of a multiple of one angle; a fraction of it is an angle of its own."""
    if base.is_number or not isinstance(factor, Rational):
        return cos(factor * base), sin(factor * base)
    count = abs(int(factor.p))
    if count > LARGEST_MULTIPLE:
        return cos(factor * base), sin(factor * base)
    part = Mul(Rational(1, int(factor.q)), base)
    x, y = cos(part), sin(part)
    c, s = S.One, S.Zero
    for _ in range(count):
        c, s = c * x - s * y, s * x + c * y
    return c, s if factor > 0 else -s

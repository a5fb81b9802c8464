"""Taylor coefficients of SymPy expressions against mpmath's, which differentiates numerically."""

import mpmath
import pytest
import sympy
from flint import arb, arb_series, fmpq
from sympy import Abs, Max, Min, Piecewise, Rational, Symbol, pi, sign, sqrt

from mechanics.checks.jets import Instant, OutsideDomain, precision
from mechanics.errors import ExpressionError

t = sympy.physics.vector.dynamicsymbols._t
x = sympy.physics.vector.dynamicsymbols("x")
a = Symbol("a", positive=True)

EXPRESSIONS = (
    *(f(x) for f in (sympy.sin, sympy.cos, sympy.tan, sympy.cot, sympy.sec, sympy.csc)),
    *(f(x) for f in (sympy.sinh, sympy.cosh, sympy.tanh, sympy.coth, sympy.asinh, sympy.atanh)),
    *(f(x) for f in (sympy.exp, sympy.log, sympy.asin, sympy.acos, sympy.atan, sympy.erf)),
    sympy.acosh(1 + x),
    sympy.atan2(x, a), sympy.atan2(x, -a), sympy.atan2(-x, -a),
    sqrt(x), 1 / sqrt(x), x**Rational(2, 3), x**-3, a**x, x**x,
    sympy.floor(5 * x) * x, sympy.ceiling(5 * x) * x, sympy.Mod(5 * x, 1),
    Abs(-x) * sign(-x), Max(x, a), Min(x, a), Piecewise((x, x > a), (x**2, True)),
    x.diff(t) * x, x.diff(t) ** 2,
    sympy.Derivative(x * sympy.sin(x), t), 0.1 * x, pi * x + sympy.E, t * x,
)  # fmt: skip


def motion(s: mpmath.mpf) -> mpmath.mpf:
    return mpmath.mpf(1) / 3 + s / 5 - s**2 / 7


@pytest.mark.parametrize("expression", EXPRESSIONS, ids=str)
def test_coefficients_are_those_of_mpmath(expression: sympy.Expr) -> None:
    with precision(200), mpmath.workdps(50):
        path = arb_series([arb(fmpq(1, 3)), arb(fmpq(1, 5)), arb(fmpq(-1, 7))])
        instant = Instant({"x": path, "t": arb_series([0, 1])}, lambda symbol: arb(fmpq(3, 4)))
        orders = 2 if expression.has(sympy.Derivative) else 3
        found = instant.coefficients(expression)[:orders]
        s = Symbol("s")
        exact = (
            sympy.nsimplify(expression, rational=True)
            if expression.has(sympy.Float)
            else expression
        )
        typed = (
            exact.subs(x, Rational(1, 3) + t / 5 - t**2 / 7).doit().subs({t: s, a: Rational(3, 4)})
        )
        function = sympy.lambdify(s, typed, "mpmath")
        wanted = mpmath.taylor(function, 0, orders - 1)
        for one, two in zip(found, wanted, strict=True):
            assert abs(mpmath.mpf(one.str(40, radius=False)) - two) < mpmath.mpf(10) ** -20


@pytest.mark.parametrize(
    "expression",
    (Abs(x - Rational(1, 3)), sign(3 * x - 1), Max(x, Rational(1, 3)), sympy.floor(3 * x)),
    ids=str,
)
def test_a_kink_is_no_place_to_be(expression: sympy.Expr) -> None:
    with precision(200):
        instant = Instant({"x": arb_series([arb(fmpq(1, 3)), 1])}, lambda symbol: arb(1))
        with pytest.raises(OutsideDomain):
            instant.value(expression)


def test_what_is_not_known_is_refused() -> None:
    with pytest.raises(ExpressionError, match="gamma"):
        Instant({"x": arb_series([1])}, lambda symbol: arb(1)).value(sympy.gamma(x))


@pytest.mark.parametrize("exponent", [1, 2, 3, 5])
def test_a_ball_around_zero_has_powers(exponent: int) -> None:
    """Of constraints that hold: Arb's own power has no value there."""
    with precision(200):
        around = arb(0, 1e-30)
        found = Instant({}, lambda _: around).value(a**exponent)
        inverse = Instant({}, lambda _: arb(2)).value(a**-exponent)
    assert found.is_finite() and found.contains(0) and abs(found) < 1e-29
    assert inverse == arb(2) ** -exponent

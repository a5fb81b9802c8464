"""Linear equations solved by Cramer's rule: what is found makes the forms zero."""

import pytest
from sympy import Symbol, cos, sin, symbols

from mechanics.errors import ExpressionError
from mechanics.symbolic import is_zero
from mechanics.symbolic.cramer import cramer

x, y, z, m, k = symbols("x y z m k", real=True)
a = Symbol("a", real=True)


@pytest.mark.parametrize(
    "forms",
    [
        [m * x + k],
        [m * x + cos(a) * y - k, cos(a) * x - y + sin(a)],
        [x + m * y - 1, y + k * z, m * x - sin(a) * z + cos(a)],
    ],
)
def test_the_solution_makes_the_forms_zero(forms: list) -> None:
    unknowns = (x, y, z)[: len(forms)]
    numerators, denominator = cramer(forms, unknowns)
    assert not is_zero(denominator)
    table = {s: n / denominator for s, n in zip(unknowns, numerators, strict=True)}
    assert all(is_zero(denominator * form.xreplace(table)) for form in forms)


def test_forms_that_say_the_same_have_no_denominator() -> None:
    _, denominator = cramer([x + y - 1, m * x + m * y], (x, y))
    assert denominator == 0


def test_what_is_not_linear_is_refused() -> None:
    with pytest.raises(ExpressionError):
        cramer([x * y - 1, x + y], (x, y))

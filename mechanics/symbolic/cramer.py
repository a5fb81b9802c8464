"""Linear equations in few unknowns solved without a division by anything but their determinant.

A x + b = 0        x = -adj(A) b / det(A)
"""

from collections.abc import Sequence

from sympy import Expr, Matrix, Symbol

from mechanics.symbolic.canonical import canonical, collect_linear


def cramer(forms: Sequence[Expr], unknowns: Sequence[Symbol]) -> tuple[list[Expr], Expr]:
    """Numerators of the unknowns, and their denominator.

    Parameters
    ----------
    forms : sequence of Expr
        Expressions that are zero, linear in the unknowns and as many as they.

    Returns
    -------
    numerators : list of Expr
        In normal form, one for each unknown.
    denominator : Expr
        In normal form; zero where the forms do not determine the unknowns.

    Raises
    ------
    ExpressionError
        If a form is not linear in the unknowns.
    """
    split = [collect_linear(form, unknowns) for form in forms]
    matrix = Matrix([factors for factors, _ in split])
    rest = Matrix([-rest for _, rest in split])
    numerators = [canonical(entry) for entry in matrix.adjugate() * rest]
    return numerators, canonical(matrix.det(method="berkowitz"))

"""The ledger of small motions: every published row against what the linear equations give.

typed side = derived side;    typed equation holds wherever the derived one does
"""

from collections.abc import Callable, Iterable, Mapping

from sympy import Expr, Symbol

from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError
from mechanics.kernel import Finding, undecided
from mechanics.linear import control_rows, modal_rows, speed_rows
from mechanics.linear.case import Case, linear_at
from mechanics.linear.form import Linear
from mechanics.scene import Scene
from mechanics.scene.linear_quantities import InertiaAbout, LinearQuantity, OperatingPoint
from mechanics.scene.published import Published, Quantity

CHECKS: dict[type[LinearQuantity], Callable[[Case], Finding]] = {
    **control_rows.CHECKS,
    **modal_rows.CHECKS,
    **speed_rows.CHECKS,
}

QUANTITIES: tuple[type[Quantity], ...] = tuple(CHECKS)
"""What this ledger can check; rows about other quantities belong to other checks."""

OF_PROGRAMS: tuple[type[Quantity], ...] = tuple(speed_rows.CHECKS)
"""What it can check of equations that are too long to be written out."""


Linears = Mapping[OperatingPoint, Linear]


def linear_equations(rows: Iterable[Published], equations: Equations) -> Linears:
    """The equations linearized about each operating point of some rows, once for all about it."""
    points = [row.quantity.point for row in rows if isinstance(row.quantity, LinearQuantity)]
    return {point: linear_at(equations, point) for point in dict.fromkeys(points)}


def check_linear_row(
    scene: Scene, row: Published, equations: Equations, linears: Linears | None = None
) -> Finding:
    """Compare every typed side of a row with the quantity that the row is about.

    Parameters
    ----------
    row : Published
        About a quantity of `mechanics.scene.linear_quantities`.
    equations : Equations
        Of one route for this scene; its rows have to be power-conjugate (`lagrange`, `kane`) for
        inertias and determinants.
    linears : mapping of OperatingPoint to Linear, optional
        These equations, linearized by `linear_equations`, where several rows are about a point.

    Returns
    -------
    Finding
        REFUTED with a witness where a side differs from what is derived, or an equation does not
        hold; UNDECIDED where it holds as an identity only, or the equations do not tell.

    Raises
    ------
    InputError
        If the row is about another kind of quantity, its sides do not have the form that the
        quantity asks for, or its operating point is no equilibrium.
    """
    subject = f"{row.tag} {row.label}"
    if not isinstance(row.quantity, LinearQuantity):
        raise InputError(
            f"{subject}: {type(row.quantity).__name__} is no quantity of linear equations:"
            " use mechanics.checks.ledger"
        )
    if equations.scene is not scene:
        raise InputError(f"{subject}: the equations belong to the scene {equations.scene.name}")
    point = row.quantity.point
    linear = linears[point] if linears else linear_at(equations, point)
    check = CHECKS[type(row.quantity)]
    try:
        return check(Case(subject, row, linear, _names(linear, row.quantity)))
    except ExpressionError as error:
        return undecided(subject, str(error))


def _names(linear: Linear, quantity: LinearQuantity) -> dict[Symbol, Expr]:
    """Derived values of the symbols that the row uses for them."""
    table: dict[Symbol, Expr] = {}
    for symbol, named in quantity.where:
        if not isinstance(named, InertiaAbout):
            raise InputError(f"{symbol}: only an inertia can be named by a symbol")
        table[symbol] = control_rows.parallel_axis(linear, named)
    return table

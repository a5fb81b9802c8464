"""`mechanics linearize` and `mechanics modes`: motions near an equilibrium."""

from typing import Annotated

import typer
from sympy import Expr, Matrix, Rational

from mechanics.cli.load import load
from mechanics.cli.values import points
from mechanics.crosscheck import derive
from mechanics.errors import ExpressionError, InputError
from mechanics.linear import Linear, damped, damped_modes, numeric_modes, stability
from mechanics.linear import linearize as about
from mechanics.linear import modes as exact_modes
from mechanics.linear.values import with_numbers

LONGEST = 16
"""Characters of a number that is printed as it is."""

SystemArgument = Annotated[str, typer.Argument(metavar="SYSTEM", help="A name or a .py file.")]
AtOption = Annotated[
    list[str] | None,
    typer.Option(
        "--at", metavar="NAME=VALUE", help="Coordinate or input at the equilibrium; zero if not."
    ),
]


def linearize(system: SystemArgument, at: AtOption = None) -> None:
    """Print the linear equations about an equilibrium, which is proved to be one first.

    Example: `mechanics linearize rocker --at theta=0`
    """
    linear = _linear(system, at or [])
    typer.echo(
        f"M x'' + C x' + K x = B f, x = deviations of {', '.join(map(str, linear.coordinates))}"
    )
    for title, matrix in (("M", linear.mass), ("C", linear.damping), ("K", linear.stiffness)):
        typer.echo(f"{title} = {_rows(matrix)}")
    for order, matrix in enumerate(linear.input_matrices):
        if matrix.cols:
            names = ", ".join(str(name) + "'" * order for name in linear.inputs)
            typer.echo(f"B = {_rows(matrix)}, for {names}")
    try:
        typer.echo(f"equilibrium: {stability(linear).value}")
    except ExpressionError as error:
        typer.echo(f"stability: {error}")


def modes(system: SystemArgument, at: AtOption = None) -> None:
    """Print natural frequencies and shapes about an equilibrium, exact where they factor.

    With damping: poles, frequencies, damping ratios and shapes at the typical values. A shape has a
    size and a phase for each coordinate.

    Example: `mechanics modes two_mass_chain`
    """
    linear = _linear(system, at or [])
    typer.echo(f"shapes are of {', '.join(map(str, linear.coordinates))}")
    if damped(linear):
        typer.echo("damped: typical values")
        for line in damped_modes(linear).words:
            typer.echo(line)
    elif not linear.undamped:
        typer.echo("typical values, at which nothing damps")
        _numeric(linear)
    else:
        _natural(linear)


def _natural(linear: Linear) -> None:
    try:
        exact = exact_modes(linear)
    except ExpressionError as error:
        typer.echo(f"typical values ({error})")
        _numeric(linear)
        return
    for i, value in enumerate(exact.eigenvalues):
        shape = ", ".join(str(entry) for entry in exact.shapes[:, i])
        typer.echo(f"omega_{i + 1}^2 = {value}   shape ({shape})")


def _numeric(linear: Linear) -> None:
    numeric = numeric_modes(linear)
    for i, value in enumerate(numeric.eigenvalues):
        shape = ", ".join(f"{entry + 0.0:.10g}" for entry in numeric.shapes[:, i])
        typer.echo(f"omega_{i + 1}^2 = {value + 0.0:.10g}   shape ({shape})")


def _linear(name: str, settings: list[str]) -> Linear:
    scene = load(name).scene()
    coordinates: dict[str, Expr] = {symbol.name: Rational(0) for symbol in scene.q}
    inputs: dict[str, Expr] = {symbol.name: Rational(0) for symbol in scene.input_symbols}
    for key, value in points(settings, "--at").items():
        if key in coordinates:
            coordinates[key] = value
        elif key in inputs:
            inputs[key] = value
        else:
            known = ", ".join((*coordinates, *inputs))
            raise InputError(f"{scene.name}: there is no coordinate or input {key!r}: {known}")
    equations = derive(scene, "lagrange")
    if equations.textbook is None:
        # Formulas of these are no reading for a person.
        numbers = {symbol: with_numbers(scene, symbol) for symbol in scene.parameters}
        typer.echo("typical values: the equations are too long for formulas")
        return about(equations, coordinates, inputs, numbers)
    return about(equations, coordinates, inputs)


def _rows(matrix: Matrix) -> str:
    rows = ("[" + ", ".join(map(_entry, row)) + "]" for row in matrix.tolist())
    return "[" + ", ".join(rows) + "]"


def _entry(entry: Expr) -> str:
    """A formula, or a number with the digits of a double where its own are longer."""
    text = str(entry)
    return f"{float(entry):.10g}" if entry.is_number and len(text) > LONGEST else text

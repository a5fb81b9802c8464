"""`mechanics linearize` and `mechanics modes`: motions near a state of rest or a steady motion."""

import json
from pathlib import Path
from textwrap import fill
from typing import Annotated, Any

import numpy as np
import typer
from sympy import Expr, Matrix, Rational, Symbol

from mechanics.checks.equilibria import exact
from mechanics.cli.files import JsonOption, refuse_unwritable, write, write_file
from mechanics.cli.formulas import formulas
from mechanics.cli.load import SystemArgument, load
from mechanics.crosscheck import derive
from mechanics.errors import ExpressionError, InputError
from mechanics.linear import (
    Linear,
    Sweep,
    damped,
    damped_modes,
    numeric_modes,
    speed_form,
    sweep,
    verdict,
)
from mechanics.linear import linearize as about
from mechanics.linear import modes as exact_modes
from mechanics.linear.sweep import AXIS
from mechanics.linear.values import with_numbers
from mechanics.nearest import instead
from mechanics.report.modes_plot import modes_plot
from mechanics.scene import Scene
from mechanics.simulate.file_names import writable

WIDTH = 80
"""Columns of a terminal."""

ROWS = 10
"""Lines of a table over a parameter."""
LONG = 300
"""Operations of linear equations that are not written as formulas."""
GRAVITY = "g"
LONGEST = 16
"""Characters of a number that is printed as it is."""

AtOption = Annotated[
    list[str] | None,
    typer.Option(
        "--at",
        metavar="NAME=VALUE",
        help="Coordinate or input there: 0.5, pi/2, l/3; once for each; zero if not given.",
    ),
]
SpeedsOption = Annotated[
    list[str] | None,
    typer.Option(
        "--speeds",
        metavar="NAME=VALUE",
        help="Speed of a steady motion: 3, v/R, sqrt(g/R); else zero.",
    ),
]


def linearize(system: SystemArgument, at: AtOption = None, speeds: SpeedsOption = None) -> None:
    """Print the linear equations about rest or a steady motion, which is proved first.

    `mechanics linearize rocker --at theta=0`

    `mechanics linearize rolling_disc --speeds u2=v/R`
    """
    linear = _linear(system, at or [], speeds or [])
    named = [name for name in linear.program.inputs if name != GRAVITY]
    if linear.program.count > LONG and len(named) == 1:
        _print_speed_form(linear, named[0])
        return
    typer.echo(
        f"M x'' + C x' + K x = B f, x = deviations of {', '.join(map(str, linear.coordinates))}"
    )
    if linear.moves:
        moving = ", ".join(f"{u} = {value}" for u, value in linear.speeds.items() if value != 0)
        _tell(f"about the steady motion {moving}")
        if linear.cyclic:
            _tell(f"ignorable coordinates: {', '.join(map(str, linear.cyclic))}")
    for title, matrix in (("M", linear.mass), ("C", linear.damping), ("K", linear.stiffness)):
        typer.echo(f"{title} = {_rows(matrix)}")
    for order, matrix in enumerate(linear.input_matrices):
        if matrix.cols:
            names = ", ".join(str(name) + "'" * order for name in linear.inputs)
            typer.echo(f"B = {_rows(matrix)}, for {names}")
    _print_verdict(linear)


def modes(
    system: SystemArgument,
    at: AtOption = None,
    speeds: SpeedsOption = None,
    over: Annotated[
        str | None,
        typer.Option(metavar="NAME", help="A parameter or a speed over which poles are shown."),
    ] = None,
    start: Annotated[float | None, typer.Option("--from", help="Its first value.")] = None,
    end: Annotated[float | None, typer.Option("--to", help="Its last value.")] = None,
    count: Annotated[int, typer.Option("--points", help="Of how many values.")] = 201,
    plot: Annotated[
        Path | None, typer.Option(metavar="FILE.svg", help="Draw the poles over it.")
    ] = None,
    json_file: JsonOption = None,
) -> None:
    """Print frequencies and shapes about rest or a steady motion, or poles over a parameter.

    `mechanics modes two_mass_chain`

    `mechanics modes rolling_disc --over u2 --from 0 --to 8 --plot poles.svg`

    Natural frequencies are exact where they factor. With damping, or in motion: poles, frequencies,
    damping ratios and shapes at the typical values. A shape has a size and a phase for each
    coordinate. With --over: the poles over a parameter or a speed, and where stability changes.
    """
    if over is None:
        if (start, end, plot, json_file) != (None,) * 4:
            raise InputError("--from, --to, --plot and --json belong to --over NAME: add it")
        _print_modes(_linear(system, at or [], speeds or []))
        return
    if start is None or end is None or not start < end or count < 2:
        raise InputError(
            f"--over {over}: give its range, for example --over {over} --from 0 --to 10"
        )
    if plot is not None:
        writable(plot, (".svg",))
    refuse_unwritable(plot, json_file)
    linear = _linear(system, at or [], speeds or [], over)
    found = sweep(linear, over, np.linspace(start, end, count).tolist())
    if plot is not None:
        write_file(modes_plot(found), plot)
    if json_file is not None:
        write(json.dumps(_record(found), allow_nan=False), json_file)
    if json_file != "-":
        _print_sweep(found)


def _print_speed_form(linear: Linear, speed: str) -> None:
    """What is too long for formulas, in numbers where it has the form of a bicycle."""
    found = speed_form(linear, speed, GRAVITY)
    counted = ", ".join(str(q) for q in linear.coordinates if q not in linear.cyclic)
    typer.echo(
        f"M x'' + {speed} C1 x' + ({GRAVITY} K0 + {speed}^2 K2) x = 0, x = deviations of {counted}"
    )
    for name, matrix in zip(("M", "C1", "K0", "K2"), found.numbers(), strict=True):
        rows = ("[" + ", ".join(f"{entry:.15g}" for entry in row) + "]" for row in matrix)
        typer.echo(f"{name} = [{', '.join(rows)}]")
    typer.echo(f"the form: {found.finding.verdict.name}, {found.finding.evidence}")


def _record(found: Sweep) -> dict[str, Any]:
    return {
        "system": found.linear.scene.name,
        "over": found.over,
        "states": [symbol.name for symbol in found.linear.states],
        "values": found.values.tolist(),
        "poles": [[[pole.real, pole.imag] for pole in row] for row in found.poles.tolist()],
        "unstable": found.unstable.tolist(),
        "borders": list(found.borders),
    }


def _print_sweep(found: Sweep) -> None:
    """Some values, and the borders between them."""
    typer.echo(f"poles in 1/s over {found.over}")
    for k in range(0, len(found.values), max(1, (len(found.values) - 1) // ROWS)):
        small = AXIS * max(abs(found.poles[k]).max(initial=0.0), 1.0)
        poles = [_without_noise(complex(pole), small) for pole in found.poles[k]]
        # Of a pair of conjugate poles one, with both signs.
        shown = sorted((p for p in poles if p.imag >= 0), key=lambda p: (-p.real, p.imag))
        mark = "unstable" if found.unstable[k] else "stable"
        text = ", ".join(map(_pole, shown))
        _tell(f"{found.over} = {found.values[k]:<8.5g} {mark:<8}  {text}")
    for border in found.borders:
        typer.echo(f"stability changes at {found.over} = {border:.10g}")


def _without_noise(pole: complex, small: float) -> complex:
    real, imag = (0.0 if abs(part) < small else part for part in (pole.real, pole.imag))
    return complex(real, imag)


def _pole(pole: complex) -> str:
    if not pole.imag:
        return f"{pole.real:.5g}"
    return f"{pole.real:.5g} ± {pole.imag:.5g}i" if pole.real else f"± {pole.imag:.5g}i"


def _print_modes(linear: Linear) -> None:
    counted = [str(q) for q in linear.coordinates if q not in linear.cyclic]
    _tell(f"shapes list {', '.join(counted)}")
    if linear.moves or damped(linear):
        typer.echo("at typical values, in motion" if linear.moves else "at typical values, damped")
        for line in damped_modes(linear).words:
            _tell(line)
    elif not linear.undamped:
        typer.echo("at typical values, where nothing damps")
        _numeric(linear)
    else:
        _natural(linear)
    _print_verdict(linear)


def _print_verdict(linear: Linear) -> None:
    kind = "steady motion" if linear.moves else "equilibrium"
    _tell(f"{kind}: {verdict(linear)}")


def _natural(linear: Linear) -> None:
    try:
        exact = exact_modes(linear)
    except ExpressionError:
        _tell("at typical values: the frequencies have no formula in the parameters")
        _numeric(linear)
        return
    for i, value in enumerate(exact.eigenvalues):
        shape = ", ".join(str(entry) for entry in exact.shapes[:, i])
        _tell(f"omega_{i + 1}^2 = {value}   shape ({shape})")


def _numeric(linear: Linear) -> None:
    numeric = numeric_modes(linear)
    for i, value in enumerate(numeric.eigenvalues):
        shape = ", ".join(f"{entry + 0.0:.10g}" for entry in numeric.shapes[:, i])
        _tell(f"omega_{i + 1}^2 = {value + 0.0:.10g}   shape ({shape})")


def _linear(name: str, settings: list[str], moving: list[str], over: str | None = None) -> Linear:
    scene = load(name).scene()
    coordinates: dict[str, Expr] = {symbol.name: Rational(0) for symbol in scene.q}
    inputs: dict[str, Expr] = {symbol.name: Rational(0) for symbol in scene.input_symbols}
    parameters = {symbol.name: symbol for symbol in scene.parameters}
    given, typical = formulas(settings, "--at", parameters), dict[Symbol, Expr]()
    if not given and not moving:
        given, typical = _declared(scene)
    for key, value in given.items():
        if key in coordinates:
            coordinates[key] = value
        elif key in inputs:
            inputs[key] = value
        else:
            known = instead(key, (*coordinates, *inputs), "coordinates and inputs")
            raise InputError(f"{scene.name}: there is no coordinate or input {key!r}: {known}")
    speeds = formulas(moving, "--speeds", parameters, more=True)
    if over is not None and over in {u.name for u in scene.u} - set(speeds):
        speeds[over] = Symbol(over, real=True)
    equations = derive(scene, "lagrange")
    if equations.textbook is None:
        # Formulas of these are no reading for a person.
        symbolic = any(value.free_symbols - set(scene.parameters) for value in speeds.values())
        left = {over, GRAVITY} if symbolic else {over}
        numbers = {s: with_numbers(scene, s) for s in scene.parameters if s.name not in left}
        typer.echo("at typical values: the equations are too long for formulas", err=True)
        return about(equations, coordinates, inputs, numbers, speeds)
    return about(equations, coordinates, inputs, typical, speeds)


def _declared(scene: Scene) -> tuple[dict[str, Expr], dict[Symbol, Expr]]:
    """The first declared equilibrium, where the constraints do not hold with all coordinates 0.

    And numbers for the parameters at which it holds, where it does not for all.
    """
    zero = dict.fromkeys(scene.q, Rational(0))
    held = [scene.plain(c.expression, c.name) for c in scene.constraints if c.holonomic]
    if not scene.equilibria or all(value.xreplace(zero).equals(0) for value in held):
        return {}, {}
    place = {name: exact(value) for name, value in scene.equilibria[0].items()}
    _tell(f"about the declared equilibrium {', '.join(f'{k} = {v}' for k, v in place.items())}")
    there = zero | {q: place[q.name] for q in scene.q if q.name in place}
    left = [value.xreplace(there) for value in held]
    free = {s for value in left if not value.equals(0) for s in value.free_symbols}
    numbers = {s: with_numbers(scene, s) for s in scene.parameters if s in free}
    if numbers:
        _tell(
            f"where {', '.join(f'{s} = {v}' for s, v in numbers.items())}, as its constraints ask"
        )
    return place, numbers


def _tell(line: str) -> None:
    """Print a line, in several where it is wider than a terminal."""
    typer.echo(fill(line, WIDTH, subsequent_indent="    ", break_long_words=False))


def _rows(matrix: Matrix) -> str:
    rows = ("[" + ", ".join(map(_entry, row)) + "]" for row in matrix.tolist())
    return "[" + ", ".join(rows) + "]"


def _entry(entry: Expr) -> str:
    """A formula, or a number with the digits of a double where its own are longer."""
    text = str(entry)
    return f"{float(entry):.10g}" if entry.is_number and len(text) > LONGEST else text

"""`mechanics derive`: the equations of motion of one route, for people or programs."""

from collections.abc import Mapping
from enum import StrEnum
from typing import Annotated, Any

import sympy
import typer
from rich.console import Console
from sympy import Matrix

from mechanics.cli.lines import fitted
from mechanics.cli.load import SystemArgument, load
from mechanics.cli.program_listing import program_latex, program_python, program_text
from mechanics.cli.python_module import python_module
from mechanics.cli.values import FixOption, assignments
from mechanics.compiled import compile
from mechanics.compiled.fixed import fix, read_fixed
from mechanics.crosscheck import derive as derive_by
from mechanics.equations import Equations
from mechanics.judge.at_values import words as in_words
from mechanics.mechanism import lower
from mechanics.program import Builder
from mechanics.report.notation import latex
from mechanics.routes.multipliers import meaning_words
from mechanics.scene.units import units_missing


class Format(StrEnum):
    """How equations are written."""

    TEXT = "text"
    LATEX = "latex"
    PYTHON = "python"


def derive(
    system: SystemArgument,
    route: Annotated[
        str, typer.Option(help="free_body, moving_point, kane or lagrange.")
    ] = "free_body",
    form: Annotated[
        Format, typer.Option("--format", help="Notation of the equations.")
    ] = Format.TEXT,
    fixed: FixOption = None,
) -> None:
    """Print the equations of motion M u' = f + B lambda, A u' = b of one route.

    `mechanics derive rocker --route moving_point`

    `mechanics derive elastic_pendulum --route kane --format latex`

    `mechanics derive elastic_pendulum --fix m=0 --fix g=9.81`

    Equations that are too long for one formula are printed line by line, with a name for each part
    that is used again. In Python that is a function of NumPy arrays.
    """
    fixed_values = assignments(fixed or [], "--fix")
    scene = load(system).scene()
    text = written(derive_by(scene, route), form, fixed_values)
    typer.echo(fitted(text, Console().width) if form is Format.TEXT else text)
    for words in units_missing(scene):
        typer.echo(words, err=True)


def written(equations: Equations, form: Format, fixed: Mapping[str, Any]) -> str:
    """Equations of motion as a text.

    Parameters
    ----------
    equations : Equations
    form : Format
    fixed : mapping of str to number
        Parameters that become numbers.
    """
    table = read_fixed(equations.scene, fixed)
    if equations.textbook is None:
        compile(equations, fixed={symbol.name: value for symbol, value in table.items()})
        return PROGRAM_WRITERS[form](equations, table)
    text = WRITERS[form](fix(equations, table))
    if form is not Format.TEXT or not table:
        return text
    heading, rows = text.split("\n", 1)
    return f"{heading}, where {in_words(table)}\n{rows}"


def _sides(equations: Equations) -> list[tuple[sympy.Expr, sympy.Expr]]:
    """Left and right sides, the first coefficient of an acceleration positive."""
    scene = equations.scene
    rights = equations.forcing
    if equations.multipliers:
        rights = rights + equations.reaction_matrix * Matrix(equations.multipliers)
    rows = []
    for i, right in enumerate(rights):
        entries = list(equations.mass.row(i))
        first = next((entry for entry in entries if entry != 0), sympy.S.One)
        if first.could_extract_minus_sign():
            entries, right = [sympy.signsimp(-entry) for entry in entries], sympy.signsimp(-right)
        rows.append(((Matrix([entries]) * Matrix(scene.ud))[0], right))
    if equations.constraint_matrix.rows:
        closed = equations.constraint_matrix * Matrix(scene.ud)
        rows += list(zip(closed, equations.constraint_bias, strict=True))
    return rows


def _text(equations: Equations) -> str:
    lines = [f"{equations.scene.name}, by {equations.route}"]
    lines += [f"  {words}" for words in equations.chosen]
    lines += [f"{left} = {right}" for left, right in _sides(equations)]
    lines += [f"  {words}" for words in _multipliers(equations)]
    return "\n".join(lines)


def _multipliers(equations: Equations) -> list[str]:
    """What Lagrange's multipliers are: the reactions that maintain the constraints."""
    shown = {symbol.name for symbol in equations.multipliers}
    return meaning_words(lower(equations.scene, Builder()), shown) if shown else []


def _latex(equations: Equations) -> str:
    rows = [f"{latex(left)} &= {latex(right)}" for left, right in _sides(equations)]
    comments = [f"% {words}" for words in _multipliers(equations)]
    return "\n".join([*comments, "\\begin{align}\n"]) + " \\\\\n".join(rows) + "\n\\end{align}"


WRITERS = {Format.TEXT: _text, Format.LATEX: _latex, Format.PYTHON: python_module}
PROGRAM_WRITERS = {
    Format.TEXT: program_text, Format.LATEX: program_latex, Format.PYTHON: program_python,
}  # fmt: skip

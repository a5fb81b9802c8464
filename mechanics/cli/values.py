"""Values on the command line: ``--set M=2 --set theta=1/2 --at theta=pi``."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Annotated, TypeVar

import typer
from sympy import Expr, Rational, pi

from mechanics.errors import InputError, RangeError
from mechanics.nearest import instead
from mechanics.program.constants import rational, with_pi
from mechanics.scene import Scene
from mechanics.scene.validity import condition_parameters

RouteOption = Annotated[str, typer.Option(help="Route that derives the equations.")]
FixOption = Annotated[
    list[str] | None,
    typer.Option(
        "--fix",
        metavar="NAME=VALUE",
        help="Put a number in place of a parameter, exactly as typed.",
    ),
]
SettingsOption = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="NAME=VALUE", help="Initial value, parameter or input."),
]
BeyondOption = Annotated[
    bool, typer.Option("--beyond-domain", help="Go on where the model is not valid.")
]
JudgedAtOption = Annotated[
    list[str] | None,
    typer.Option(metavar="NAME=VALUE", help="Judge where a parameter has this value."),
]


Value = TypeVar("Value")


def assignments(entries: Sequence[str], option: str) -> dict[str, Fraction]:
    """Read ``name=value`` entries of an option; decimal numbers or fractions, kept exact.

    Raises
    ------
    InputError
        For an entry that is no assignment, a value that is no number, or a name given twice.
    """
    return _numbers(entries, option, rational, "")


def points(entries: Sequence[str], option: str, accepted: str = " or pi/2") -> dict[str, Expr]:
    """Read ``name=value`` entries; numbers as for `assignments`, or multiples of pi.

    Raises
    ------
    InputError
        As `assignments`.
    """
    return _numbers(entries, option, _multiple_of_pi, accepted)


def _multiple_of_pi(text: str) -> Expr:
    number, turn = with_pi(text)
    return Rational(number.numerator, number.denominator) * (pi if turn else 1)


def _numbers(
    entries: Sequence[str], option: str, read: Callable[[str], Value], more: str
) -> dict[str, Value]:
    numbers: dict[str, Value] = {}
    for name, text, entry in pairs(entries, option):
        try:
            numbers[name] = read(text)
        except RangeError as error:
            raise InputError(f"{option} {name}: {error}") from None
        except (ValueError, ZeroDivisionError):
            hint = (
                f"write {option} once for each name"
                if "=" in text
                else (f"write 0.5, 1e-3, 1/3{more}")
            )
            raise InputError(f"{option} {entry!r}: {text!r} is no number: {hint}") from None
    return numbers


def pairs(
    entries: Sequence[str], option: str, form: str = "name=value", example: str = "theta=0.5"
) -> list[tuple[str, str, str]]:
    """(name, text, entry) of each entry, no name twice."""
    table: dict[str, tuple[str, str, str]] = {}
    for entry in entries:
        name, _, text = (part.strip() for part in entry.partition("="))
        if not name or not text:
            raise malformed(option, entry, form, example)
        if name in table:
            raise InputError(f"{option} {entry!r}: {name} is given twice")
        table[name] = name, text, entry
    return list(table.values())


def malformed(option: str, entry: str, form: str, example: str) -> InputError:
    """The error for an entry that has not the form of its option."""
    return InputError(f"{option} {entry!r}: write {form}, for example {option} {example}")


def sorted_out(
    scene: Scene, values: dict[str, Expr]
) -> tuple[dict[str, float], dict[str, float], dict[str, float]]:
    """Values by what they are for: initial values, parameters, inputs.

    Raises
    ------
    InputError
        For a name that the scene does not have.
    """
    initial = {symbol.name for symbol in (*scene.q, *scene.u)}
    parameters = {symbol.name for symbol in (*scene.parameters, *scene.definitions)}
    parameters |= {symbol.name for symbol in condition_parameters(scene)}
    for expression in scene.definitions.values():
        parameters |= {symbol.name for symbol in expression.free_symbols}
    inputs = {symbol.name for symbol in scene.input_symbols}
    groups: tuple[dict[str, float], ...] = ({}, {}, {})
    for name, value in values.items():
        for group, names in zip(groups, (initial, parameters, inputs), strict=True):
            if name in names:
                group[name] = _finite(name, value)
                break
        else:
            known = sorted(initial) + sorted(parameters) + sorted(inputs)
            raise InputError(
                f"{scene.name}: there is no {name!r} to set: {instead(name, known, 'names')}"
            )
    return groups[0], groups[1], groups[2]


def _finite(name: str, value: Expr) -> float:
    number = float(value)
    if abs(number) == float("inf"):
        raise InputError(f"--set {name}: the value is beyond 1.8e308: write a smaller one")
    return number


def names_of(entries: list[str]) -> dict[str, str]:
    """Names of a person and what they mean, from ``mine=the scene's``.

    Raises
    ------
    InputError
        For what is no such pair, and a name twice.
    """
    table = pairs(entries, "--name", "mine=the scene's", "phi=theta")
    return {mine: theirs for mine, theirs, _ in table}

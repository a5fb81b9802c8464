"""Values on the command line: ``--set M=2 --set theta=1/2``."""

from collections.abc import Sequence
from fractions import Fraction

from mechanics.errors import InputError
from mechanics.scene import Scene
from mechanics.scene.conditions import condition_parameters


def assignments(entries: Sequence[str], option: str = "--set") -> dict[str, Fraction]:
    """Read ``name=value`` entries of an option; decimal numbers or fractions, kept exact.

    Raises
    ------
    InputError
        For an entry that is no assignment, a value that is no number, or a name given twice.
    """
    found: dict[str, Fraction] = {}
    for entry in entries:
        name, equals, text = (part.strip() for part in entry.partition("="))
        if not equals or not name:
            raise InputError(
                f"{option} {entry!r}: write name=value, for example {option} theta=0.5"
            )
        if name in found:
            raise InputError(f"{option} {entry!r}: {name} is given twice")
        try:
            found[name] = Fraction(text)
        except (ValueError, ZeroDivisionError):
            raise InputError(
                f"{option} {entry!r}: {text!r} is no number: write 0.5, 1e-3 or 1/3"
            ) from None
    return found


def sorted_out(
    scene: Scene, values: dict[str, Fraction]
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
            known = ", ".join(sorted(initial) + sorted(parameters) + sorted(inputs))
            raise InputError(f"{scene.name}: there is no {name!r} to set: the names are {known}")
    return groups[0], groups[1], groups[2]


def _finite(name: str, value: Fraction) -> float:
    try:
        return float(value)
    except OverflowError:
        raise InputError(
            f"--set {name}: the value is beyond 1.8e308: write a smaller one"
        ) from None

"""Typical values: a number for every parameter, by the scene's definitions where it has none."""

from collections.abc import Mapping
from math import isfinite
from typing import Any

from sympy import Expr, Rational, Symbol, sympify

from mechanics.errors import InputError, ValueMissingError
from mechanics.scene import Scene
from mechanics.scene.parameters import Parameter

Numbers = Mapping[str | Symbol, float]


def expand_definitions(scene: Scene, expr: Expr) -> Expr:
    """The expression with every defined parameter replaced, until none is left."""
    definitions = {symbol: sympify(value) for symbol, value in scene.definitions.items()}
    for _ in definitions:
        expr = expr.xreplace(definitions)
    return expr


def with_numbers(scene: Scene, expr: Expr, values: Numbers | None = None) -> Expr:
    """The expression with every symbol replaced by a number.

    A given value counts first, then the typical one, then the scene's definition.

    Raises
    ------
    ValueMissingError
        If a symbol has none of the three.
    InputError
        If a given name is no parameter.
    """
    given = {str(key): value for key, value in (values or {}).items()}
    _refuse_unknown(scene, expr, given)
    # A definition brings in symbols of its own, so once around for each.
    for _ in range(len(scene.definitions) + 1):
        table = {symbol: _number(scene, symbol, given) for symbol in expr.free_symbols}
        expr = expr.xreplace(table)
    return expr


def _number(scene: Scene, symbol: Symbol, given: Mapping[str, Any]) -> Expr:
    if symbol.name in given:
        return _exact(symbol.name, given[symbol.name])
    if isinstance(symbol, Parameter) and symbol.typical is not None:
        return sympify(symbol.typical)
    if symbol in scene.definitions:
        return sympify(scene.definitions[symbol])
    raise ValueMissingError(
        f"{scene.name}: parameter {symbol} has no value: give values={{'{symbol}': ...}}"
    )


def _exact(name: str, value: Any) -> Expr:
    """A given value; a floating-point number as the rational that it is.

    SymPy's own numbers round every sum, so that K - M g/3 beside the critical gain would lose all.
    """
    if not isinstance(value, float):
        return sympify(value)
    if not isfinite(value):
        raise InputError(f"parameter {name}: the value {value} is no finite number")
    return Rational(*value.as_integer_ratio())


def _refuse_unknown(scene: Scene, expr: Expr, given: Mapping[str, Any]) -> None:
    known = {*scene.parameters, *expr.free_symbols, *scene.definitions}
    known |= {s for value in scene.definitions.values() for s in sympify(value).free_symbols}
    names = {symbol.name for symbol in known}
    for name in given:
        if name not in names:
            raise InputError(
                f"{scene.name}: there is no parameter {name!r}:"
                f" the parameters are {', '.join(sorted(names))}"
            )

"""Typical values: a number for every parameter, by the scene's definitions where it has none."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from math import isfinite
from typing import Any

from sympy import Expr, Rational, Symbol, sympify

from mechanics.errors import InputError, SingularError, ValueMissingError
from mechanics.kernel import enclose
from mechanics.nearest import instead
from mechanics.program import Builder, Program
from mechanics.program.interpret import include
from mechanics.program.sympy_reader import read
from mechanics.scene import Scene
from mechanics.scene.parameters import Parameter

Numbers = Mapping[str | Symbol, float]

PRECISIONS = (128, 256, 512)
"""Bits of enclosures, the first that tells an entry to double precision."""
DOUBLE = 60


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
    _refuse_unknown(scene, expr.free_symbols, given)
    return _substituted(scene, expr, given)


def _substituted(scene: Scene, expr: Expr, given: Mapping[str, Any]) -> Expr:
    # A definition brings in symbols of its own, so once around for each.
    for _ in range(len(scene.definitions) + 1):
        table = {symbol: _number(scene, symbol, given) for symbol in expr.free_symbols}
        expr = expr.xreplace(table)
    return expr


def evaluate(
    scene: Scene,
    program: Program,
    symbols: Mapping[str, Symbol],
    values: Numbers | None,
    names: Sequence[str],
) -> dict[str, list[float]]:
    """Outputs of a program in double precision; see `evaluation`."""
    return evaluation(scene, program, symbols, values, names)({})


def evaluation(
    scene: Scene,
    program: Program,
    symbols: Mapping[str, Symbol],
    values: Numbers | None,
    names: Sequence[str],
    *left: str,
) -> Callable[[Mapping[str, Fraction]], dict[str, list[float]]]:
    """Some outputs of a program as a function of inputs that are left.

    Each number is the double nearest to the exact value.

    Raises
    ------
    ValueMissingError
        If another symbol has neither a value nor a typical one.
    SingularError
        By the function, if an output has no value.
    """
    own = {name: symbols.get(name, Symbol(name)) for name in program.inputs if name not in left}
    given = {str(key): value for key, value in (values or {}).items()}
    _refuse_unknown(scene, symbols.values(), given)
    builder = Builder()
    numbers = [_substituted(scene, symbol, given) for symbol in own.values()]
    table = dict(zip(own, read(builder, numbers), strict=True))
    outputs = include(builder, program, table)
    bound = builder.program({name: outputs[name] for name in names})

    def at(state: Mapping[str, Fraction]) -> dict[str, list[float]]:
        known = {name: state[name] for name in bound.inputs}
        for bits in PRECISIONS:
            found = enclose(bound, known, bits)
            balls = [ball for name in names for ball in found[name]]
            if all(ball == 0 or ball.rel_accuracy_bits() >= DOUBLE for ball in balls):
                break
        if not all(ball.is_finite() for ball in balls):
            raise SingularError(f"{scene.name}: the linear equations have no value at these values")
        # What cannot be told from 0 at the last precision is below 1e-100 of what it is made of.
        return {
            name: [0.0 if ball.contains(0) else float(ball.mid()) for ball in found[name]]
            for name in names
        }

    return at


def _number(scene: Scene, symbol: Symbol, given: Mapping[str, Any]) -> Expr:
    if symbol.name in given:
        return _exact(symbol.name, given[symbol.name])
    if isinstance(symbol, Parameter) and symbol.typical is not None:
        return sympify(symbol.exact)
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


def _refuse_unknown(scene: Scene, own: Iterable[Symbol], given: Mapping[str, Any]) -> None:
    known = {*scene.parameters, *own, *scene.definitions}
    known |= {s for value in scene.definitions.values() for s in sympify(value).free_symbols}
    names = {symbol.name for symbol in known}
    for name in given:
        if name not in names:
            raise InputError(
                f"{scene.name}: there is no parameter {name!r}:"
                f" {instead(name, sorted(names), 'parameters')}"
            )

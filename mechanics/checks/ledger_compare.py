"""Typed sides against derived ones: with definitions expanded where needed, and rounded numbers.

    typed = derived        with I_C, M, ... put in where needed        |printed - derived| <= half

A definition is put in by assigning its value to its symbol before the symbol is first used, so that
nothing has to be substituted or expanded. Constrained scenes are compared on their manifold.
"""

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal

from flint import arb
from sympy import Expr, Float, S, Symbol, sympify

from mechanics.checks.manifold import project, restrict
from mechanics.errors import InputError, SceneError
from mechanics.kernel import Finding, enclosed, refuted
from mechanics.kinematics.symbolic import Kinematics
from mechanics.scene import Scene
from mechanics.scene.symbols import symbols_of
from mechanics.symbolic import Arithmetic, Number, decide, enclose, roundings

Pairs = list[tuple[Number, Number]]


def decide_in(
    kinematics: Kinematics,
    subject: str,
    experiment: Callable[[Arithmetic], Pairs],
    symbols: set[Symbol],
    *,
    expand: bool = False,
    accelerations: bool = False,
    where: Sequence[Expr] = (),
) -> Finding:
    """`decide`, and where that does not show the statement, once more with definitions put in.

    Parameters
    ----------
    experiment : callable
    symbols : set of Symbol
        What the statement holds; definitions of other symbols do not matter to it.
    expand : bool
        True when it is plain beforehand that the statement needs its definitions.
    accelerations : bool
        Whether the statement is about the accelerations that the constraints admit.
    where : sequence of Expr
        What is positive at all states that are looked at, in coordinates and parameters.
    """
    used = symbols & kinematics.scene.definitions.keys()

    def admissible(a: Arithmetic) -> Pairs:
        restrict(a, kinematics, accelerations=accelerations)
        for expression in where:
            a.require_positive(a.value(expression))
        return experiment(a)

    def expanded(a: Arithmetic) -> Pairs:
        define(a, kinematics.scene)
        return admissible(a)

    if not (used and expand):
        finding = decide(subject, admissible)
        if finding.shown or not used:
            return finding
    finding = decide(subject, expanded)
    names = ", ".join(sorted(symbol.name for symbol in used))
    return replace(finding, evidence=f"{finding.evidence}, with {names} by definition")


def define(a: Arithmetic, scene: Scene) -> None:
    """Give what is defined its value; before it is used in this arithmetic.

    Raises
    ------
    SceneError
        When definitions go round in a circle.
    """
    for symbol, expression in ordered(scene.definitions):
        a.assign(symbol, a.value(expression))


def project_defined(a: Arithmetic, kinematics: Kinematics) -> None:
    """Give what constraints and definitions determine the values that they ask for.

    Must run before any other expression is evaluated in this arithmetic.

    Raises
    ------
    ExpressionError
        When no exact point on the constraints is known.
    SceneError
        When definitions go round in a circle.
    """
    project(a, kinematics)
    define(a, kinematics.scene)


def ordered(definitions: Mapping[Symbol, Expr]) -> list[tuple[Symbol, Expr]]:
    """Definitions such that each one comes after those that it uses.

    Raises
    ------
    SceneError
        When they go round in a circle.
    """
    pending, found = dict(definitions), []
    while pending:
        ready = [s for s, e in pending.items() if not e.free_symbols & pending.keys()]
        if not ready:
            names = ", ".join(sorted(symbol.name for symbol in pending))
            raise SceneError(f"the definitions of {names} go round in a circle: break it")
        found += [(symbol, pending.pop(symbol)) for symbol in ready]
    return found


def definitions_in_full(scene: Scene, but: Collection[Symbol] = ()) -> dict[Symbol, Expr]:
    """Every definition in terms of what is not defined, and of symbols that are left as they are.

    Parameters
    ----------
    but : collection of Symbol
        Those that are left.
    """
    table: dict[Symbol, Expr] = {}
    for symbol, expression in ordered(scene.definitions):
        if symbol not in but:
            table[symbol] = expression.xreplace(table)
    return table


def equal(
    kinematics: Kinematics, subject: str, lefts: Sequence[Expr], rights: Sequence[Expr],
    where: Sequence[Expr] = (),
) -> Finding:  # fmt: skip
    """Whether expressions are equal, entry by entry, for all accelerations that are admissible."""

    def experiment(a: Arithmetic) -> Pairs:
        return [(a.value(x), a.value(y)) for x, y in zip(lefts, rights, strict=True)]

    left, right = symbols_of(lefts), symbols_of(rights)
    # A symbol that only one side knows can hardly cancel: the first attempt would be in vain.
    expand = bool((left ^ right) & kinematics.scene.definitions.keys())
    return decide_in(
        kinematics, subject, experiment, left | right,
        expand=expand, accelerations=True, where=where,
    )  # fmt: skip


def rounded(kinematics: Kinematics, subject: str, left: Expr, right: Expr) -> Finding:
    """Whether a typed side, printed number times expression, rounds the derived side.

    The derived side is first shown to be a constant c times the typed expression; then an enclosure
    of c has to lie within half a unit of the last printed digit.

    Raises
    ------
    InputError
        When the typed side is no product of one rounded number and exact factors.
    """
    number, unit = left.as_coeff_Mul()
    if not isinstance(number, Float) or unit.has(Float):
        raise InputError(
            f"{subject}: {left} is no rounded number times an exact expression: type one product"
        )
    table = definitions_in_full(kinematics.scene)
    unit, right = unit.xreplace(table), sympify(right).xreplace(table)
    ones = dict.fromkeys(unit.free_symbols | right.free_symbols, S.One)
    constant = right.xreplace(ones) / unit.xreplace(ones)
    finding = equal(kinematics, subject, [constant * unit], [right])
    if not finding.shown:
        return finding
    value, printed = enclose(constant, {}), str(number)
    words = f"the exact factor is {value.str(10, radius=False)}"
    low, high = roundings(printed)
    found = enclosed(subject, [(low, value, high)], f"{words}, which rounds to {printed}")
    if found.shown:
        return found
    state = tuple(sorted((symbol.name, "1") for symbol in ones))
    words = f"{words}, which does not round to {printed}"
    return refuted(subject, words, _rounding(printed), value, state)


def _rounding(printed: str) -> arb:
    """Every number that rounds to a printed one."""
    return arb(printed, f"0.5e{Decimal(printed).as_tuple().exponent}")

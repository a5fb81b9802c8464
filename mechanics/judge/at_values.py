"""Statements where parameters have values: 9.81 stands where the scene has g.

    M(q, p, 981/100) u' = f(q, u, p, 981/100)     and 981/100 in the statement where it holds g

The values are put into what is derived and into the statement. Lengths that constraints hold, and
what definitions or speeds are made of, stand in more places: these have no value here.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from sympy import Expr, Integer, Rational, Symbol

from mechanics.checks.ledger import check_row
from mechanics.checks.ledger_momenta import derived
from mechanics.claims.lines import NOT_USED
from mechanics.claims.statement import Statement
from mechanics.compiled.fixed import fix, read_fixed
from mechanics.equations import Equations
from mechanics.errors import InputError, MechanicsError
from mechanics.judge.convention_filter import may_hold
from mechanics.judge.converted_rows import each_side, in_plain_symbols
from mechanics.judge.multiples_of_parameters import multiples_for
from mechanics.judge.numbers_of_parameters import values_for
from mechanics.judge.rounding import is_rounding
from mechanics.judge.small_angles import as_said
from mechanics.kernel import Finding, Verdict, undecided
from mechanics.scene import Scene
from mechanics.scene.published import Published
from mechanics.scene.quantities import (
    EquationOfMotion,
    GeneralizedForce,
    GeneralizedMomentum,
    Identity,
    ReactionValue,
)

Values = Mapping[Symbol, Expr]

OPTION = "--value (values=)"

KINDS = (EquationOfMotion, ReactionValue, Identity)
"""What is compared with nothing but the equations."""

DERIVED = (GeneralizedForce, GeneralizedMomentum)
"""What a side is compared with alone: inverse dynamics, and what is conserved."""

FITTED = (EquationOfMotion, Identity)
"""What values are fitted to."""

OF_MECHANICS = (1, 2, 3, 4, 6, 8, 12, 24)
"""Denominators of numbers that no measurement gives: 1/3, 1/12."""

TIMES = (Integer(1), Rational(1, 2), Integer(2))
"""A coefficient is a value, or twice it, or half of it."""


def read_values(scene: Scene, given: Mapping[str, Any]) -> dict[Symbol, Expr]:
    """Exact values by symbol.

    Raises
    ------
    InputError
        For a name or a value that the scene cannot have, or one that stands elsewhere, too.
    """
    table = read_fixed(scene, given, turns=True, option=OPTION)
    for symbol in table:
        if symbol in _elsewhere(scene):
            raise InputError(
                f"{OPTION} {symbol.name}: it occurs in constraints, definitions or speeds of"
                f" {scene.name}: write the statement with the symbol, or give the scene the value"
            )
    return table


def judged_at(truth: Equations, row: Published, values: Values) -> Finding:
    """The finding of a row where parameters have values.

    Raises
    ------
    InputError
        For a row about something else than motion, which is compared with the scene itself.
    """
    row = as_identity(truth, row)
    if not isinstance(row.quantity, KINDS):
        raise InputError("values of parameters are for equations of motion: leave them out here")
    there = put(in_plain_symbols(truth.kinematics, row), values)
    found = check_row(truth.scene, there, fix(truth, values))
    if found.verdict is Verdict.REFUTED and is_rounding(there, found):
        evidence = "the sides differ by no more than the rounding of numbers that the code computes"
        return undecided(found.subject, f"{evidence}, where {words(values)}")
    return replace(found, evidence=f"{found.evidence}, where {words(values)}")


def small_angles_at(
    truth: Equations, statements: Sequence[Statement], findings: Sequence[Finding], values: Values
) -> tuple[list[Statement], list[Finding]]:
    """What a text gives for small angles, judged to first order where parameters have values.

    Parameters
    ----------
    findings : sequence of Finding
        Their verdicts as written, where parameters have values.
    values : mapping of Symbol to Expr
    """
    there = [
        s if s.row is None or not isinstance(s.row.quantity, EquationOfMotion)
        else replace(s, row=put(in_plain_symbols(truth.kinematics, s.row), values))
        for s in statements
    ]  # fmt: skip
    judged, found = as_said(fix(truth, values), there, findings)
    pairs = zip(statements, judged, strict=True)
    return [replace(s, notes=one.notes) for s, one in pairs], found


def as_identity(truth: Equations, row: Published) -> Published:
    """A row about a force or momentum with what it has to be, in which values can be put."""
    if not isinstance(row.quantity, DERIVED):
        return row
    sides = (*row.sides, *derived(truth.kinematics, row.quantity))
    return replace(row, quantity=Identity(), sides=sides)


def right_at(truth: Equations, statements: Sequence[Statement]) -> tuple[str, ...]:
    """Values of parameters that the statements do not hold for which all of them are right.

    They are the scene's typical ones, or fitted; then they stand in the statements as numbers, or
    are 1, in code that gives others of the scene's parameters values; or there are several of them,
    and as many numbers. Or they are what code gives its parameters beside other numbers.
    """
    rows = [in_plain_symbols(truth.kinematics, s.row) for s in statements if s.row is not None]
    if not rows or not all(isinstance(row.quantity, KINDS) for row in rows):
        return ()
    for values in _candidates(truth, rows, units_in(statements)):
        if right_with(truth, rows, values):
            return (words(fewest(values, lambda some: right_with(truth, rows, some))),)
    held = held_by(truth.scene, rows)
    own = {s: v for one in statements for s, v in one.code_values if s in held}
    if own and right_with(truth, [put(row, own) for row in rows], own):
        return (words(own),)
    return ()


def fewest(values: Values, enough: Callable[[Values], bool]) -> Values:
    """Values that are enough, without those that are enough without."""
    for symbol in list(values):
        fewer = {s: v for s, v in values.items() if s != symbol}
        values = fewer if fewer and enough(fewer) else values
    return values


def right_with(truth: Equations, rows: Sequence[Published], values: Values) -> bool:
    """Whether all rows are shown where parameters have values."""
    try:
        target = fix(truth, values)
        return may_hold(target, rows, [{}]) == [True] and all(
            check_row(truth.scene, row, target).shown for row in rows
        )
    except MechanicsError:
        return False  # there the scene does not move, or a row is none


def words(values: Values) -> str:
    """``g = 9.81``."""
    parts = []
    for symbol, value in sorted(values.items(), key=lambda item: item[0].name):
        decimal = repr(float(value)) if value.is_number else ""
        exact = decimal and Rational(decimal) == value
        parts.append(f"{symbol.name} = {decimal if exact else value}")
    return ", ".join(part.removesuffix(".0") for part in parts)


def _candidates(
    truth: Equations, rows: Sequence[Published], units: bool
) -> Iterator[dict[Symbol, Expr]]:
    scene, held, numbers = truth.scene, held_by(truth.scene, rows), numbers_in(rows)
    free = [p for p in scene.parameters if p not in held]
    atoms = set().union(*(side.atoms(Rational) for row in rows for side in row.sides))
    values = {number * times for times in TIMES for number in numbers}
    typical = {p: p.exact for p in free if getattr(p, "typical", None)}
    # What a person leaves out is the scene's own value, as a rule.
    yield from ({symbol: value} for symbol, value in typical.items() if value in values)
    if numbers and len(typical) == len(free) > 1:
        yield typical
    if not (numbers or units) or not all(isinstance(row.quantity, FITTED) for row in rows):
        return
    fitted = values_for(truth, rows, free)
    # A side that names no parameter has numbers for all of them, and what is 1 shows nowhere.
    units = units or not held & {*scene.parameters}

    def plain(some: Values) -> bool:
        return all(not v.is_Rational or v in values or (units and v == 1) for v in some.values())

    # As many equations as numbers: several values that fit them all are no chance.
    measured = {abs(n) for n in atoms if n.q not in OF_MECHANICS or abs(n) > 4}
    several = len(measured) >= sum(v != 1 for v in fitted.values()) > 1
    if fitted and (plain(fitted) or several):
        yield fitted
    if units and not fitted:
        parameters = [p for p in scene.parameters if p in held]
        yield from filter(plain, multiples_for(truth, rows, free, parameters))


def held_by(scene: Scene, rows: Sequence[Published]) -> set[Symbol]:
    """Symbols that rows hold, and those that have no value here."""
    return set().union(*(side.free_symbols for row in rows for side in row.sides)) | _elsewhere(
        scene
    )


def numbers_in(rows: Sequence[Published]) -> list[Rational]:
    """Numbers of rows that may be values: decimals come from measurements, 1/3 and 4 do not."""
    atoms = set().union(*(side.atoms(Rational) for row in rows for side in row.sides))
    return sorted({abs(n) for n in atoms if n.q % 5 == 0 or abs(n) > 4}, key=lambda n: (-n.q, n))


def units_in(statements: Sequence[Statement]) -> bool:
    """Whether code gives parameters values, so that others may be 1, which shows nowhere."""
    return any(note.endswith(NOT_USED) for s in statements for note in s.notes)


def _elsewhere(scene: Scene) -> set[Symbol]:
    """Symbols in what rows are compared on besides the equations."""
    found: set[Symbol] = set()
    for symbol, value in scene.definitions.items():
        found |= {symbol, *value.free_symbols}
    for rate in scene.coordinate_rates.values():
        found |= rate.free_symbols
    if scene.constraints:
        found |= set(scene.parameters)
    return found


def put(row: Published, values: Values) -> Published:
    """A row in plain symbols where parameters have values."""
    return each_side(row, lambda side: side.xreplace(dict(values)))

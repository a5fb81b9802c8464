"""Numbers that code has computed in doubles before it was read, and rounded.

    c = fl(m l l / 3) = m l l / 3 (1 + 3 e),  |e| <= 2^-53,  is no other number than that

Where two sides differ by no more than such numbers may be off by, they are neither shown nor
refuted.
"""

from collections.abc import Mapping
from fractions import Fraction
from math import ulp

from sympy import Expr, Float, Rational

from mechanics.kernel import Finding
from mechanics.scene.published import Published

ULPS = 8
"""Half of which an operation rounds by at most: sixteen operations in a row."""

LONG = 2**24
"""Denominators of doubles that nobody typed."""

DIGITS = 40


def is_rounding(row: Published, finding: Finding) -> bool:
    """Whether the sides of a refuted row are no further apart than its rounded numbers explain.

    Parameters
    ----------
    row : Published
        Of scalars.
    finding : Finding
        That refutes it, at a witness.
    """
    numbers = sorted({n for side in row.sides for n in side.atoms(Rational) if _is_double(n)})
    if finding.witness is None or not numbers:
        return False
    known = {**dict(finding.witness.solved), **dict(finding.witness.state)}
    values = {name: _number(text) for name, text in known.items()}
    here = _apart(row, values, {})
    if not here.is_number:
        return False
    explained = Float(0, DIGITS)
    for number in numbers:
        step = ULPS * Fraction(ulp(float(number)))
        moved = {number: number + Rational(step.numerator, step.denominator)}
        explained += abs(_apart(row, values, moved) - here)
    return bool(abs(here) <= explained)


def _apart(row: Published, values: Mapping[str, Expr], moved: Mapping[Expr, Expr]) -> Expr:
    """How far apart the first two sides are at a state, with other numbers in them."""
    table = {s: values[s.name] for side in row.sides for s in side.free_symbols if s.name in values}
    first, second = (side.xreplace(dict(moved)).xreplace(table) for side in row.sides[:2])
    return (first - second).n(DIGITS)


def _number(text: str) -> Expr:
    return Rational(text) if "/" in text else Float(text, DIGITS)


def _is_double(number: Rational) -> bool:
    return bool(number.q >= LONG and number.q & (number.q - 1) == 0)

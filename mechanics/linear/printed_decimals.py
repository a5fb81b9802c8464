"""Matrices of printed decimals against enclosures of the exact entries.

|exact - printed| <= half a unit of the last printed digit,  rigorously; exact zeros are zero
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from flint import arb
from sympy import Expr, Float, Rational

from mechanics.errors import InputError
from mechanics.kernel import Finding, enclosed, refuted, undecided
from mechanics.linear.case import Case
from mechanics.scene.symbols import entries
from mechanics.symbolic import decimal_matches, enclose, roundings

SIGNS = "one sign for each column is free"


@dataclass(frozen=True)
class Rounding:
    """One printed entry and the enclosure of the exact one."""

    printed: Expr
    value: arb

    @property
    def right(self) -> bool:
        """Whether the exact entry rounds to the printed one."""
        if isinstance(self.printed, Float):
            return decimal_matches(self.value, str(self.printed))
        return bool((self.value - _exact(self.printed)).is_zero())

    @property
    def wrong(self) -> bool:
        """Whether the exact entry is shown not to round to it."""
        return not self.value.overlaps(self.interval)

    @property
    def bounds(self) -> tuple[Fraction, arb, Fraction]:
        """The exact entry between the least and the largest number that it may be."""
        if isinstance(self.printed, Float):
            low, high = roundings(str(self.printed))
            return low, self.value, high
        number = Fraction(int(self.printed.p), int(self.printed.q))
        return number, self.value, number

    @property
    def interval(self) -> arb:
        """Every number that rounds to the printed entry."""
        middle = _exact(self.printed)
        if not isinstance(self.printed, Float):
            return middle
        digits = len(str(self.printed).partition(".")[2])
        return middle + arb(0, _ball(Fraction(1, 2 * 10**digits)).upper())


def check_rounded(
    case: Case, columns: Sequence[Sequence[Expr]], free_signs: bool = False
) -> Finding:
    """Compare the one typed matrix with exact columns.

    Parameters
    ----------
    columns : sequence of sequence of Expr
        Columns of the exact matrix, numbers; or all of its entries, row by row, as one.
    free_signs : bool
        Whether each column may have its other sign.

    Returns
    -------
    Finding
        REFUTED with the first entry that does not round to the printed one.

    Raises
    ------
    InputError
        If the typed entries are not as many, or neither decimals nor rational numbers.
    """
    typed = _columns(case, len(columns))
    if [len(column) for column in typed] != [len(column) for column in columns]:
        raise InputError(f"{case.subject}: the typed matrix has another shape than the derived one")
    doubt = False
    right: list[Rounding] = []
    for j, (printed, exact) in enumerate(zip(typed, columns, strict=True), 1):
        attempts = [_roundings(printed, exact, 1)]
        if free_signs:
            attempts.append(_roundings(printed, exact, -1))
        known = [attempt for attempt in attempts if all(entry.right for entry in attempt)]
        if known:
            right += known[0]
            continue
        if not all(any(entry.wrong for entry in attempt) for attempt in attempts):
            doubt = True
            continue
        best = min(attempts, key=lambda attempt: sum(entry.wrong for entry in attempt))
        return _refuted(case, j, best, free_signs)
    if doubt:
        return undecided(case.subject, "an enclosure touches the rounding border")
    words = "the exact values round to the printed digits"
    bounds = [entry.bounds for entry in right]
    return enclosed(case.subject, bounds, f"{words}; {SIGNS}" if free_signs else words)


def _refuted(case: Case, column: int, attempt: Sequence[Rounding], free_signs: bool) -> Finding:
    row, wrong = next((i, entry) for i, entry in enumerate(attempt, 1) if entry.wrong)
    words = f"entry {row} of column {column} does not round to {wrong.printed}"
    return refuted(
        case.subject,
        f"{words}, whatever the sign of the column" if free_signs else words,
        wrong.interval,
        wrong.value,
        (("entry", str(row)), ("column", str(column))),
    )


def _columns(case: Case, count: int) -> list[list[Expr]]:
    (side,) = case.forms()
    if count == 1:
        return [entries(side)]
    return [list(side.col(j)) for j in range(side.cols)]


def _roundings(printed: Sequence[Expr], exact: Sequence[Expr], sign: int) -> list[Rounding]:
    return [
        Rounding(typed, enclose(sign * value, {}))
        for typed, value in zip(printed, exact, strict=True)
    ]


def _exact(number: Expr) -> arb:
    """The printed number as it is printed: a Float holds binary digits, its text the decimal."""
    if isinstance(number, Float):
        return _ball(Fraction(str(number)))
    if isinstance(number, Rational):
        return _ball(Fraction(int(number.p), int(number.q)))
    raise InputError(f"{number} is neither a printed decimal nor a rational number")


def _ball(number: Fraction) -> arb:
    return enclose(Rational(number.numerator, number.denominator), {})

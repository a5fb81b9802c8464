r"""Which statements a person asks to have judged, and what of the others still counts for them.

    (6), 3-5       by its number             line 12, lines 12-15    by the line where it begins
    theta_ddot     by what stands on its left                        formulas    sentences set aside

All statements are judged, so that letters mean in the chosen ones what they mean on the whole page.
One that is not chosen is left out of the answer; where it says what a name of a chosen one is and
is not shown, the chosen one is not shown either.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from mechanics.claims.assemble import used_names
from mechanics.claims.spelled_rates import key
from mechanics.claims.statement import Statement
from mechanics.claims.tree import Name, names
from mechanics.claims.unread_names import described_names, mentioned, possibly_assigned_names
from mechanics.errors import InputError
from mechanics.kernel import undecided
from mechanics.report.answer.judged import Judged
from mechanics.report.answer.sentences import line_of, located, shortened
from mechanics.scene.quantities import Identity
from mechanics.scene.symbols import DOTS

FORMULAS = "formulas"
"""What sets sentences aside, whichever statements are chosen."""
LINES = re.compile(r"lines?\s+(\d+)(?:\s*(?:-|\u2013|to)\s*(\d+))?")
NUMBERS = re.compile(r"\(?(\d+)\)?(?:\s*(?:-|\u2013|to)\s*\(?(\d+)\)?)?")
"""One number, or a range; those without brackets are numbers and places, too."""
ACCENT = re.compile(
    r"\\(d{1,3}ot)\s*\{?\s*\\?([A-Za-z]+(?:_(?:\w|\{\w+\}))?)\s*\}?(_(?:\w|\{\w+\}))?"
)
PRIMES = re.compile(r"(?<=[\w})])('+)")
MOVES = re.compile(
    r"\\d{1,4}ot(?![a-z])|'|_d{1,3}ot\b|\bder\s*\(|\bD\(|\\d?frac\s*\{?d|\bd\w+\s*/\s*d|∂"
    r"|\\partial(?![a-z])"
)
"""A rate: what has none relates letters to each other."""
FUNCTION = re.compile(r"(?:the )?(?:function|method|class)\b")
"""A part of a program that what is judged does not call."""
SPACING = re.compile(r"[\s\\{}&$_]|\(t\)")
MOST_LISTED = 8


@dataclass(frozen=True)
class Choice:
    """What a person asks for.

    Attributes
    ----------
    whats : tuple of str
        Numbers, lines and left sides; all statements where there are none.
    formulas : bool
        Whether sentences around the statements are set aside.
    """

    whats: tuple[str, ...] = ()
    formulas: bool = False

    def __bool__(self) -> bool:
        return bool(self.whats) or self.formulas


def read_choice(only: Sequence[str] | str) -> Choice:
    """A choice of what a person wrote.

    Raises
    ------
    InputError
        For empty words.
    """
    whats = [" ".join(what.split()) for what in ([only] if isinstance(only, str) else only)]
    if not all(whats):
        raise InputError("--only (only=): write a number, a line or what stands on the left")
    return Choice(tuple(what for what in whats if what != FORMULAS), FORMULAS in whats)


def chosen(choice: Choice, statements: Sequence[Statement]) -> tuple[bool, ...]:
    """Whether each statement is chosen.

    Raises
    ------
    InputError
        When nothing has such a number, line or left side; it says what there is.
    """
    if not choice.whats:
        return (True,) * len(statements)
    is_chosen = [False] * len(statements)
    for what in choice.whats:
        _refuse_backwards(what)
        fits = [_is(what, statement) for statement in statements]
        if not any(fits):
            raise InputError(
                f"--only {what!r} (only=): no statement has this number, line or left side; there"
                f" are {_listed(statements) or 'none'}"
            )
        is_chosen = [a or b for a, b in zip(is_chosen, fits, strict=True)]
    return tuple(is_chosen)


def _refuse_backwards(what: str) -> None:
    for form, lines in ((LINES, "lines "), (NUMBERS, "")):
        ends = form.fullmatch(what)
        if ends and ends[2] and int(ends[2]) < int(ends[1]):
            raise InputError(
                f"--only {what!r} (only=): the range runs backwards: write"
                f" {f'{lines}{ends[2]}-{ends[1]}'!r}"
            )


def _is(what: str, statement: Statement) -> bool:
    if lines := LINES.fullmatch(what):
        first, last = int(lines[1]), int(lines[2] or lines[1])
        return first <= line_of(statement) <= last
    tag = statement.tag.partition(" row ")[0]
    if what in (statement.tag, tag):
        return True
    number = tag.strip("()")
    if (ends := NUMBERS.fullmatch(what)) and number.isdecimal():
        in_kind = tag != number or "(" not in what
        return in_kind and int(ends[1]) <= int(number) <= int(ends[2] or ends[1])
    return _spelled(what) in {_spelled(statement.source.split("=")[0]), _left(statement)}


def _left(statement: Statement) -> str:
    """The name that stands alone on the left, spelled with letters; empty for anything else."""
    left = statement.written.sides[0] if statement.written and statement.written.sides else None
    if not isinstance(left, Name) or left.order >= len(DOTS):
        return ""
    return key(left.name + DOTS[left.order])


def _spelled(text: str) -> str:
    r"""A side as it is compared: ``\ddot{\theta}_1`` and ``theta1''`` are theta1_ddot."""
    text = ACCENT.sub(lambda m: f"{m[2]}{m[3] or ''}_{m[1]}", text)
    text = PRIMES.sub(lambda m: DOTS[len(m[1])] if len(m[1]) < len(DOTS) else m[1], text)
    return key(SPACING.sub("", text))


def _listed(statements: Sequence[Statement]) -> str:
    some = []
    for statement in statements[:MOST_LISTED]:
        line = line_of(statement)
        some.append(f"{statement.tag} in line {line}" if line else statement.tag)
    more = len(statements) - MOST_LISTED
    return ", ".join(some) + (f" and {more} more" if more > 0 else "")


def judged_only(
    judged: Sequence[Judged], is_chosen: Sequence[bool]
) -> tuple[tuple[Judged, ...], tuple[Statement, ...]]:
    """The chosen entries, and the statements that were set aside."""
    others = [entry for entry, one in zip(judged, is_chosen, strict=True) if not one]
    kept = (entry for entry, one in zip(judged, is_chosen, strict=True) if one)
    aside = {located(entry.statement): entry.statement for entry in reversed(others)}
    return tuple(beside(entry, others) for entry in kept), tuple(reversed(aside.values()))


def beside(entry: Judged, others: Sequence[Judged]) -> Judged:
    """The entry; not shown where another one, which is not shown, says what its names are."""
    if not entry.finding.shown:
        return entry
    used = _used(entry.statement)
    for other in others:
        if described := used & _described(other, used):
            where, letters = shortened(located(other.statement)), ", ".join(sorted(described))
            words = (
                f"it is right as the scene has it, but it uses {letters}, of which"
                f" '{where}' says something that is not shown"
            )
            return replace(entry, finding=undecided(entry.finding.subject, words))
    return entry


def _used(statement: Statement) -> set[str]:
    """Keys of the names that a statement uses, but for one that it says something of."""
    written = statement.written
    if written is None:
        sides = statement.row.sides if statement.row is not None else ()
        return {key(symbol.name) for side in sides for symbol in side.free_symbols}
    if len(written.sides) > 1 and isinstance(written.sides[0], Name):
        written = replace(written, sides=written.sides[1:])
    return used_names(written)


def _described(other: Judged, used: set[str]) -> set[str]:
    """Keys of names of which a statement that is not shown says what they are.

    An equation of motion says nothing of its letters. A relation that gives a name which is not
    used says nothing of the others.
    """
    statement, written = other.statement, other.statement.written
    if other.finding.shown and not other.open:
        return set()
    if statement.row is None and statement.source == statement.tag:
        return set() if FUNCTION.match(statement.source) else used
    if statement.row is None:
        source = statement.source
        if (described := described_names(source)) is not None:
            return described
        return possibly_assigned_names(source) if MOVES.search(source) else {*mentioned(source)}
    if written is None:
        return used if isinstance(statement.row.quantity, Identity) else set()
    plain = [side for side in written.sides if isinstance(side, Name) and side.order < 2]
    alone = {key(side.name) for side in plain}
    if len(written.sides) == 2 and alone - used:
        return set()
    if isinstance(statement.row.quantity, Identity):
        return {key(name.name) for side in written.sides for name in names(side)}
    return alone

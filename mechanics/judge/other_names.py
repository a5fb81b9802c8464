"""Guesses at names that refute what another choice of the same kind makes right.

    M x'' = F - b x' + T sin(theta)    M guessed as m: REFUTED    the one right choice: M is m_t

A guess is no claim of the person. All choices are looked at in one point of a field; the one that
can be right is read again and judged in full. A guess with a good reason stays, and names are never
exchanged: what is right with m1 and m2 exchanged is wrong.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import islice, product
from math import prod

from sympy import Symbol

from mechanics.checks.ledger import check_row
from mechanics.claims.guess import CAPITALS, FIRST_LETTER, REASONS, SHORT, SURE
from mechanics.claims.kinds import quantity
from mechanics.claims.names import Match
from mechanics.claims.statement import Reading, Statement
from mechanics.equations import Equations
from mechanics.errors import ExpressionError, InputError, SceneError
from mechanics.judge.convention_filter import Table, may_hold
from mechanics.judge.converted_rows import in_plain_symbols
from mechanics.scene.published import Published
from mechanics.scene.symbols import DOTS

MOST = 24
"""Choices that are looked at: four masses in every order."""

MOST_TRIED = 5000
"""Choices with a name twice included."""

Read = Callable[[Mapping[str, str]], Reading]
WHY = "the only choice that makes all of it right"


def best_names(truth: Equations, reading: Reading, again: Read) -> Reading:
    """A reading, or the same text read with the one other choice of names that makes it right.

    Parameters
    ----------
    again : callable
        Reads the text with these names given, besides those of the person.
    """
    guessed = _weak(_guessed(reading))
    claimed = _claimed(reading)
    if not guessed or not claimed:
        return reading
    rows = [in_plain_symbols(truth.kinematics, s.row) for s in claimed if s.row is not None]
    choices = list(islice(_choices(truth, guessed, rows), MOST + 2))
    if not 1 < len(choices) <= MOST + 1:
        return reading
    tables = [_table(truth, guessed, choice) for choice in choices]
    first, *others = may_hold(truth, rows, tables)
    right = [choice for choice, possible in zip(choices[1:], others, strict=True) if possible]
    if first or len(right) != 1:
        return reading
    chosen = dict(zip((match.name for match in guessed), right[0], strict=True))
    found = again(chosen)
    if not all(_shown(truth, statement) for statement in _claimed(found)):
        return reading
    names = (replace(m, why=WHY) if m.name in chosen else m for m in found.names)
    return replace(found, names=tuple(names))


def other_choices(truth: Equations, reading: Reading) -> Iterator[tuple[str, Table]]:
    """All other names that guessed ones may stand for: in words, and as a change of symbols."""
    guessed = _guessed(reading) or tuple(m for m in reading.names if m.why in REASONS)
    claimed = _claimed(reading)
    rows = [in_plain_symbols(truth.kinematics, s.row) for s in claimed if s.row is not None]
    meanings = tuple(match.meaning for match in guessed)
    for choice in _choices(truth, guessed, rows, wide=True) if guessed else ():
        if choice == meanings:
            continue
        pairs = zip(guessed, choice, strict=True)
        new = [(match.name, name) for match, name in pairs if match.meaning != name]
        told = " and ".join(f"{name} is {meaning}" for name, meaning in new)
        options = " ".join(f"--name {name}={meaning}" for name, meaning in new)
        yield f"{told}: {options}", _table(truth, guessed, choice)


def doubtful(readings: Sequence[Reading]) -> tuple[str, ...]:
    """What to say beside a refutation under names that were guessed."""
    names = {m.name: m.meaning for reading in readings for m in _guessed(reading)}
    if not names:
        return ()
    told = ", ".join(f"{name} as {meaning}" for name, meaning in names.items())
    return (f"guessed: {told}: correct it with --name {next(iter(names))}=...",)


def _guessed(reading: Reading) -> tuple[Match, ...]:
    """Guesses at names of a text."""
    for statement in reading.statements:
        written = statement.written
        if written is not None and written.notation in ("latex", "text"):
            known = written.naming.vocabulary
            return tuple(m for m in written.naming.guessed if m.meaning not in known.momenta)
    return ()


def _weak(guessed: Sequence[Match]) -> tuple[Match, ...]:
    """Guesses that another choice may replace: M for m is one where nothing else is guessed."""
    sure = (*SURE, CAPITALS) if len(guessed) > 1 else SURE
    return tuple(m for m in guessed if m.why not in sure and not m.why.startswith(SHORT))


def _claimed(reading: Reading) -> list[Statement]:
    return [s for s in reading.statements if s.row is not None and not s.doubt]


def _choices(
    truth: Equations, guessed: Sequence[Match], rows: Sequence[Published], wide: bool = False
) -> Iterator[tuple[str, ...]]:
    """Names of the scene for the guessed ones: as guessed, then others that are free.

    They are of one kind; where they only open a refutation, a first letter tells of none.
    """
    scene = truth.scene
    held = {symbol.name for row in rows for side in row.sides for symbol in side.free_symbols}
    for dots in reversed(DOTS[1:]):
        held = {name.removesuffix(dots) for name in held}
    meanings = tuple(match.meaning for match in guessed)
    every = (*scene.q, *scene.input_symbols, *scene.parameters)
    moving = {symbol.name for symbol in scene.q}
    free = [s.name for s in every if s.name in meanings or s.name not in held]
    pools = [
        [n for n in free if quantity(scene, n) == quantity(scene, m.meaning)
         or (wide and m.why == FIRST_LETTER and n not in moving)]
        for m in guessed
    ]  # fmt: skip
    yield meanings
    if prod(map(len, pools)) > MOST_TRIED:
        return
    for choice in product(*pools):
        if len(set(choice)) == len(choice) and set(choice) != set(meanings):
            yield choice


def _table(truth: Equations, guessed: Sequence[Match], choice: tuple[str, ...]) -> Table:
    known = {symbol.name: symbol for symbol in truth.scene.parameters}
    return {
        known.get(match.meaning + dots, Symbol(match.meaning + dots, real=True)):
        known.get(name + dots, Symbol(name + dots, real=True))
        for match, name in zip(guessed, choice, strict=True)
        for dots in DOTS
    }  # fmt: skip


def _shown(truth: Equations, statement: Statement) -> bool:
    try:
        return statement.row is not None and check_row(truth.scene, statement.row, truth).shown
    except (InputError, SceneError, ExpressionError):
        return False

"""What the page shows of statements: cards, and sheets of those that are rows of one equation."""

from collections.abc import Iterable
from dataclasses import dataclass

from markupsafe import Markup

from mechanics.kernel import Verdict
from mechanics.report.answer import formulas
from mechanics.report.answer.judged import Judged
from mechanics.report.answer.meaning import difference, headline, meaning
from mechanics.report.answer.sentences import about, place, sides, solved
from mechanics.report.answer.sheets import names_of, sheets
from mechanics.report.answer.term_values import term_values
from mechanics.report.answer.witness import short_state, short_value, short_values
from mechanics.scene import Scene

LONG = 120
"""Characters of a statement that is shown once; what else may be changed in it is folded."""


WORST = (
    Verdict.PROVED, Verdict.CERTIFIED, Verdict.SUPPORTED, Verdict.UNDECIDED, Verdict.REFUTED,
)  # fmt: skip


@dataclass(frozen=True)
class Card:
    """What the page shows of one statement."""

    anchor: str
    entry: Judged
    about: str
    place: str
    equation: Markup
    others: tuple[Markup, ...]
    long: bool
    hand: formulas.Hand
    row: str
    headline: str
    meaning: str
    known: str
    differ: str
    state: list[tuple[str, str]]
    solved: list[tuple[str, str]]
    terms: list[tuple[str, str]]


@dataclass(frozen=True)
class Sheet:
    """An equation, with a card for each of its rows, or with its only one."""

    title: str
    place: str
    equation: Markup
    worst: Verdict
    cards: tuple[Card, ...]


def sheets_of(told: Iterable[Judged], scene: Scene) -> list[Sheet]:
    """The sheets of statements, in their order."""
    found: list[Sheet] = []
    number = 0
    for entries in sheets(told):
        cards = tuple(_card(number + n, entry, scene) for n, entry in enumerate(entries, start=1))
        number += len(cards)
        statement = entries[0].statement
        verdicts = [entry.verdict for entry in entries]
        worst = max(verdicts, key=WORST.index)
        equation = formulas.equation(statement.source, cards[0].hand)
        title = names_of(entries[0])[0] if len(cards) > 1 else statement.tag
        found.append(Sheet(title, place(statement), equation, worst, cards))
    return found


def _card(number: int, entry: Judged, scene: Scene) -> Card:
    statement, blame = entry.statement, entry.blame
    repairs = blame.repairs if blame is not None else ()
    hand = formulas.hand_of(statement)
    shown = [formulas.equation(statement.source, hand, repair.edits) for repair in repairs]
    witness = entry.finding.witness
    words, known = meaning(entry.finding)
    return Card(
        anchor=f"statement-{number}",
        entry=entry,
        about=about(statement),
        place=place(statement),
        equation=shown[0] if shown else formulas.equation(statement.source, hand),
        others=tuple(shown[1:]),
        long=len(statement.source) > LONG,
        hand=hand,
        row=names_of(entry)[1],
        headline=headline(entry.finding, entry.verdict),
        meaning=words,
        known=known,
        differ=difference(sides(statement), short_values(witness.left, witness.right))
        if witness and not entry.of_dimension
        else "",
        state=[(n, short_state(v)) for n, v in witness.state] if witness else [],
        solved=[(n, short_value(v)) for n, v in solved(statement, witness.solved, scene)]
        if witness
        else [],
        terms=term_values(statement, witness),
    )

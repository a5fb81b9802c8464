"""The answer as one self-contained page: the person's equations beside the derivation.

Nothing is fetched from a network and no script runs, as with the report of a cross-check.
"""

from dataclasses import dataclass

from markupsafe import Markup

from mechanics.equations import Equations, Line
from mechanics.errors import wanted
from mechanics.report import words
from mechanics.report.answer import typed
from mechanics.report.answer.check import Check
from mechanics.report.answer.judged import Judged
from mechanics.report.answer.sentences import about, counted, order, place, sides, solved
from mechanics.report.answer.witness import short_state, short_value, short_values
from mechanics.report.drawing import drawing
from mechanics.report.environment import environment
from mechanics.report.sections import SymbolRow, symbol_rows

LONG = 120
"""Characters of a statement that is shown once; what else may be changed in it is folded."""


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
    hand: typed.Hand
    sides: tuple[str, str]
    values: tuple[str, str]
    state: list[tuple[str, str]]
    solved: list[tuple[str, str]]


def check_html(found: Check) -> str:
    """The page of a check.

    Parameters
    ----------
    found : Check

    Returns
    -------
    str
        A whole page.
    """
    wanted(found, (Check,), "check_html", "pass check(scene, equations)")
    made = environment()
    made.globals.update(block=typed.block, counted=counted, formula=typed.formula, order=order)
    state = dict(found.scene.example)
    return made.get_template("answer/page.html").render(
        found=found,
        scene=found.scene,
        cards=[_card(n, entry) for n, entry in enumerate(found.told, start=1)],
        tally=words.tally(entry.finding for entry in found.judged),
        drawing=Markup(drawing(found.scene, state)),
        symbols=_symbols(found, state),
        result=_result(found.derived),
        steps_before=found.derived.steps[:-1] if found.derived else (),
    )


def _symbols(found: Check, state: dict[str, float]) -> list[SymbolRow]:
    return symbol_rows(found.scene, state)


def _result(derived: Equations | None) -> tuple[Line, ...]:
    return derived.result.lines if derived is not None else ()


def _card(number: int, entry: Judged) -> Card:
    statement, blame = entry.statement, entry.blame
    repairs = blame.repairs if blame is not None else ()
    hand = typed.hand_of(statement)
    shown = [typed.equation(statement.source, hand, repair.edits) for repair in repairs]
    witness = entry.finding.witness
    return Card(
        anchor=f"statement-{number}",
        entry=entry,
        about=about(statement),
        place=place(statement),
        equation=shown[0] if shown else typed.equation(statement.source, hand),
        others=tuple(shown[1:]),
        long=len(statement.source) > LONG,
        hand=hand,
        sides=sides(statement),
        values=short_values(witness.left, witness.right) if witness else ("", ""),
        state=[(n, short_state(v)) for n, v in witness.state] if witness else [],
        solved=[(n, short_value(v)) for n, v in solved(statement, witness.solved)]
        if witness
        else [],
    )

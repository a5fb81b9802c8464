"""The answer as one self-contained page: the person's equations beside the derivation.

Nothing is fetched from a network and no script runs, as with the report of a cross-check.
"""

from markupsafe import Markup

from mechanics.equations import Line
from mechanics.errors import wanted
from mechanics.report import words
from mechanics.report.answer import formulas
from mechanics.report.answer.cards import sheets_of
from mechanics.report.answer.check import Check
from mechanics.report.answer.marks import printable
from mechanics.report.answer.segments import parted
from mechanics.report.answer.sentences import (
    counted,
    formulas_alone,
    located,
    number_and_line,
    order,
    read_as,
    two_sided,
    which,
)
from mechanics.report.answer.sheets import shared_notes, shared_reasons
from mechanics.report.drawing import drawing
from mechanics.report.environment import environment
from mechanics.report.projection import View
from mechanics.report.sections import ShownStep, SymbolRow, shown_steps, symbol_rows
from mechanics.routes.derivation import goal_of, steps_of
from mechanics.scene.quantities import EquationOfMotion


def check_html(found: Check) -> str:
    """The page of a check.

    Parameters
    ----------
    found : Check

    Returns
    -------
    str
        A whole page.

    Examples
    --------
    >>> from systems import rod_pendulum
    >>> answer = check(rod_pendulum.scene(), "l*theta'' = 3/2*g*sin(theta) + 3*u/(m*l)")
    >>> check_html(answer)[:15]
    '<!DOCTYPE html>'
    """
    wanted(found, (Check,), "check_html", "pass check(scene, equations)")
    made = environment()
    made.globals.update(
        block=formulas.block, counted=counted, formula=formulas.formula, order=order,
        parted=parted, read_as=read_as, two_sided=two_sided, which=which,
    )  # fmt: skip
    made.tests["wide"] = formulas.wide
    told, notes = shared_notes(found.told)
    told, reasons = shared_reasons(told)
    form = goal_of((found.derived,)) if found.derived is not None else ()
    state = dict(found.scene.example)
    return made.get_template("answer/page.html").render(
        found=found,
        scene=found.scene,
        sheets=sheets_of(told, found.scene),
        notes=notes,
        reasons=reasons,
        hand=formulas.hand_of(told[0].statement) if told else formulas.Hand("", None),
        tally=words.tally(entry.verdict for entry in found.judged),
        drawing=Markup(drawing(found.scene, state)),
        symbols=_symbols(found, state),
        form=form,
        missing=_missing(found),
        alone=formulas_alone(
            [entry.verdict for entry in found.judged], len(found.unjudged), len(found.aside)
        ),
        aside=_aside(found),
        derived_steps=_derivation(found, form, state),
    )


def _aside(found: Check) -> list[tuple[str, Markup]]:
    """What was set aside: where it stands, and an equation, or a sentence."""
    statements = {located(statement): statement for statement in found.set_aside}
    return [
        (number_and_line(one), formulas.equation(one.source, formulas.hand_of(one)))
        if (one := statements.get(words)) is not None
        else ("", Markup("<p>{}</p>").format(printable(words)))
        for words in found.aside
    ]


def _missing(found: Check) -> str:
    """How many equations of motion are given, where these are not all and none was set aside."""
    if found.aside:
        return ""
    kinds = (e.statement.row.quantity for e in found.judged if e.statement.row is not None)
    given, needed = sum(isinstance(k, EquationOfMotion) for k in kinds), len(found.scene.u)
    needed -= len(found.scene.constraints)
    return f"{given} of {needed} equations of motion given." if 0 < given < needed else ""


def _derivation(
    found: Check, form: tuple[Line, ...], state: dict[str, float]
) -> tuple[ShownStep, ...]:
    derived = found.derived
    if derived is None:
        return ()
    return shown_steps(derived, steps_of(derived, form), View(found.scene, state))[0]


def _symbols(found: Check, state: dict[str, float]) -> list[SymbolRow]:
    return symbol_rows(found.scene, state)

"""Verdicts on what is asked, and the other readings that leave a refutation open.

statements  --kernel-->  findings  ->  conventions that help, letters, limits, guesses, values
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import chain

from mechanics.claims.declared_conventions import Declared
from mechanics.claims.statement import Statement
from mechanics.equations import Equations
from mechanics.judge.at_rest import at_rest
from mechanics.judge.at_values import Values, right_at, small_angles_at
from mechanics.judge.at_values import words as in_words
from mechanics.judge.choice import judged_only
from mechanics.judge.complete import complete_residuals, determines
from mechanics.judge.declared_convention import Answer, judge_under
from mechanics.judge.declared_order import in_declared_order
from mechanics.judge.defined_meanings import as_meant
from mechanics.judge.energy_parts import of_a_part
from mechanics.judge.frequencies import one_root_each
from mechanics.judge.guesses import other_guesses
from mechanics.judge.letters import Settled, settle
from mechanics.judge.other_conventions import helpful_changes
from mechanics.judge.other_reading import left_open, other_readings
from mechanics.judge.prose import as_told, limits_on, seen_from_one_side
from mechanics.judge.question import Question
from mechanics.judge.rounded_code import as_rounded
from mechanics.judge.said_owner import of_its_owner
from mechanics.judge.single import judge
from mechanics.judge.small_angles import as_said, right_for_small_angles
from mechanics.judge.special_case import in_special_case
from mechanics.judge.special_motion import of_special_motion
from mechanics.judge.standard_names import with_standard_names
from mechanics.judge.suggested_choice import suggested
from mechanics.judge.tries import may_be_tried
from mechanics.judge.unused_values import unused_values
from mechanics.judge.where import Where, judge_where, right_where
from mechanics.kernel import Finding
from mechanics.report.answer.judged import Judged, differs


@dataclass(frozen=True)
class Judgement:
    """Verdicts.

    Attributes
    ----------
    judged : tuple of Judged
        What was chosen.
    others : tuple of Statement
        What was not.
    remarks : tuple of str
        How it was judged.
    limits : tuple of str
        Sentences that limit nothing of it.
    hints : tuple of str
        Choices that a person may make.
    """

    judged: tuple[Judged, ...]
    others: tuple[Statement, ...]
    remarks: tuple[str, ...]
    limits: tuple[str, ...]
    hints: tuple[str, ...]


def judgement_on(question: Question) -> Judgement:
    """The verdicts on a question."""
    truth, prose, choice = question.truth, question.prose, question.choice
    statements = question.statements
    verdicts = partial(
        _verdicts, truth, counted=question.counted, values=question.values, where=question.region
    )
    judged, remarks = verdicts(statements, helps=question.written_out)
    if question.by_prose:
        pairs = zip(judged, statements, strict=True)
        known = question.names_taken
        judged = tuple(seen_from_one_side(truth.scene, e, s, known) for e, s in pairs)
    judged = complete_residuals(truth, one_root_each(truth, judged, statements))
    limits = [limits_on(prose, s, alone=bool(choice), formulas=choice.formulas) for s in statements]
    without_limits, judged = (
        tuple(
            of_a_part(truth.scene, as_told(entry, (*question.against, *some), question.unsettled))
            for entry, some in zip(judged, words, strict=True)
        )
        for words in ([()] * len(judged), limits)
    )
    judged = _read_otherwise(question, judged, verdicts)
    hints = () if choice else suggested(prose, without_limits, judged)
    judged, others = judged_only(judged, question.chosen)
    effective = {words for some in limits for words in some}
    aside = tuple(limit.sentence for limit in prose.limits if limit.words not in effective)
    return Judgement(judged, others, remarks, aside, hints)


def _read_otherwise(
    question: Question, judged: tuple[Judged, ...], verdicts: Callable[..., Answer]
) -> tuple[Judged, ...]:
    """The entries, with what may be meant otherwise, and what is right in a special case."""
    truth, statements, values = question.truth, question.statements, question.values
    tries = question.written_out and not (question.counted or question.region)
    readings = chain(
        other_guesses(truth, judged, question.readings, statements, values, tries),
        other_readings(truth, statements, not values),
    )
    judged = left_open(judged, readings, lambda some: verdicts(some, helps=False)[0])
    judged = as_meant(as_rounded(judged, question.of_code))
    judged = with_standard_names(truth, judged, values) if tries else judged
    judged = in_special_case(truth, judged) if tries and not values else judged
    judged = tuple(of_its_owner(truth, entry) for entry in judged)
    return tuple(in_declared_order(truth.scene, of_special_motion(entry)) for entry in judged)


def _right(truth: Equations, values: Values, apart: bool, statement: Statement) -> bool:
    """Whether a statement is right; where more is declared than values, that is not asked."""
    return not apart and judge(truth, statement, values).shown


def _by_letter(entry: Judged, settled: Settled) -> Judged:
    """The entry; refuted where the meaning of its letter has another dimension."""
    if settled.finding is None:
        return entry
    return replace(entry, finding=settled.finding, right_if=(), open=False)


def _helping(
    truth: Equations, statements: Sequence[Statement], findings: Sequence[Finding]
) -> tuple[tuple[str, ...], bool]:
    """Under which conditions all statements are right, and whether these may be what is meant.

    A convention may be where the statements determine the motion: any one equation can be mended.
    Lengths that are half of the scene's, and bodies without inertia, need a word of the person's.
    """
    changes = helpful_changes(truth, statements)
    if changes:
        plain = all(c.kind not in ("size", "masses") for change in changes[:1] for c in change)
        words = tuple(" and ".join(c.words for c in change) for change in changes)
        return words, plain and len(changes[0]) <= 2 and determines(truth, statements)
    if words := right_at(truth, statements):
        return words, True
    # What is linearized needs a word of the person's.
    words = right_for_small_angles(truth, statements, findings)
    return words or right_where(truth, statements, findings), False


def _verdicts(
    truth: Equations, statements: Sequence[Statement], *, counted: Sequence[Declared],
    values: Values, where: Sequence[Where], helps: bool = True,
) -> Answer:  # fmt: skip
    """Verdicts and remarks; beside a refutation the convention that helps, if that is asked."""
    if counted:
        return judge_under(truth, statements, counted)
    plain = [at_rest(truth, statement) for statement in statements]
    settled = settle(
        truth, plain, partial(_right, truth, values, bool(where)), dimensions=not values
    )
    judged, told = _judged(truth, [s.statement for s in settled], values, where, helps)
    return tuple(map(_by_letter, judged, settled)), told


def _judged(
    truth: Equations, statements: Sequence[Statement], values: Values, where: Sequence[Where],
    helps: bool,
) -> Answer:  # fmt: skip
    if where:
        found = (Judged(s, judge_where(truth, s, where)) for s in statements)
        return tuple(found), (f"judged where {' and '.join(w.words for w in where)}",)
    findings = [judge(truth, statement, values) for statement in statements]
    if values:
        idle = unused_values(truth, statements, findings, values)
        statements, findings = small_angles_at(truth, statements, findings, values)
        told = (f"judged where {in_words(values)}", *idle)
        return tuple(map(Judged, statements, findings)), told
    statements, findings = as_said(truth, statements, findings)
    if not (helps and any(map(differs, findings)) and may_be_tried(statements)):
        return tuple(map(Judged, statements, findings)), ()
    claimed = [
        k for k, s in enumerate(statements)
        if s.row is not None and not s.doubt and (findings[k].shown or differs(findings[k]))
    ]  # fmt: skip
    some = [statements[k] for k in claimed]
    helping, may_be = _helping(truth, some, [findings[k] for k in claimed])
    entries = []
    for statement, finding in zip(statements, findings, strict=True):
        wrong = differs(finding)
        entries.append(Judged(statement, finding, helping if wrong else (), open=wrong and may_be))
    return tuple(entries), ()

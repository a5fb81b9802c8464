"""By which choice of statements an answer in doubt would be one that shows something.

--only 'lines 5-8' (only=) judges what is shown of it, without the rest
"""

from collections.abc import Sequence

from mechanics.claims.statement import Statement
from mechanics.judge.choice import FORMULAS, beside
from mechanics.judge.defined_meanings import as_meant
from mechanics.judge.prose import Prose, as_told, limits_on
from mechanics.kernel import Verdict
from mechanics.report.answer.judged import Judged
from mechanics.report.answer.sentences import line_of

MOST = 4
"""Options in one line."""


def suggested(prose: Prose, before: Sequence[Judged], judged: Sequence[Judged]) -> tuple[str, ...]:
    """A remark, or none.

    Parameters
    ----------
    prose : Prose
    before : sequence of Judged
        The entries, where no sentence denies or limits them.
    judged : sequence of Judged
        The same as they are answered; nothing is suggested where one is REFUTED, or right
        under another reading.
    """
    verdicts = {entry.verdict for entry in judged}
    doubt = Verdict.UNDECIDED in verdicts and Verdict.REFUTED not in verdicts
    if not doubt or any(entry.open for entry in judged):
        return ()
    # What is in doubt for another reason than a sentence stays so, whatever is chosen.
    now = as_meant([as_told(one, limits_on(prose, one.statement)) for one in before])
    before = [
        other if other.verdict is Verdict.UNDECIDED and said.finding.shown else one
        for one, said, other in zip(before, now, judged, strict=True)
    ]
    alone, formulas = (_right(prose, before, judged, formulas=one) for one in (False, True))
    statements = [entry.statement for entry in judged]
    if all(formulas):
        options = [FORMULAS]
    elif any(alone):
        options = _named(statements, alone)
    else:
        options = [FORMULAS, *_named(statements, formulas)] if any(formulas) else []
    if not 0 < len(options) <= MOST:
        return ()
    words = " ".join(f"--only '{w}'" if {*w} & {*" ()"} else f"--only {w}" for w in options)
    what = "the formulas alone" if options == [FORMULAS] else "what is shown, without the rest"
    return (f"to judge {what}: {words} (only=)",)


def _right(
    prose: Prose, before: Sequence[Judged], judged: Sequence[Judged], *, formulas: bool
) -> list[bool]:
    """Which entries are shown if they are chosen."""
    entries = as_meant([
        as_told(one, limits_on(prose, one.statement, alone=True, formulas=formulas))
        if one.finding.shown else other
        for one, other in zip(before, judged, strict=True)
    ])  # fmt: skip
    shown = [entry.finding.shown and not entry.open for entry in entries]
    others = [entry for entry, right in zip(entries, shown, strict=True) if not right]
    return [
        right and beside(entry, others).finding.shown
        for entry, right in zip(entries, shown, strict=True)
    ]


def _named(statements: Sequence[Statement], right: Sequence[bool]) -> list[str]:
    """What chooses statements and no others."""
    some = [s for s, one in zip(statements, right, strict=True) if one]
    lines = sorted({line_of(statement) for statement in some})
    rest = {line_of(s) for s, one in zip(statements, right, strict=True) if not one}
    if not lines[0] or rest & {*lines}:
        return _numbers(list(dict.fromkeys(s.tag.partition(" row ")[0] for s in some)))
    if len(lines) > 1 and not any(lines[0] < line < lines[-1] for line in rest):
        return [f"lines {lines[0]}-{lines[-1]}"]
    return [f"line {line}" for line in lines]


def _numbers(tags: list[str]) -> list[str]:
    """Tags, as one range where they are places in a row."""
    places = [int(tag) for tag in tags if tag.isdecimal()]
    row = len(places) == len(tags) > 1 and places == [*range(places[0], places[-1] + 1)]
    return [f"{places[0]}-{places[-1]}"] if row else tags

r"""The answer as lines: verdict, source, what to write instead, differences, a state.

REFUTED  (7)
    M \frac{L^{2}}{12} \ddot{\theta}+M g \frac{L}{2} \sin \theta=0
                  ^^
    write 3 for 12: the factor is wrong
"""

from collections.abc import Iterable, Iterator, Sequence
from io import StringIO

from rich.cells import cell_len
from rich.console import Console, Group, RenderableType
from rich.text import Text

from mechanics.blame.result import Blame, Edit, Repair
from mechanics.claims.names import Match
from mechanics.claims.statement import Statement
from mechanics.kernel import Finding, Verdict
from mechanics.report.answer.differences import Differences
from mechanics.report.answer.formulas import Hand, hand_of
from mechanics.report.answer.judged import Judged
from mechanics.report.answer.lines import Hanging, below, line
from mechanics.report.answer.marks import pieces, printable, shortened
from mechanics.report.answer.meaning import difference, headline, meaning
from mechanics.report.answer.segments import spoken
from mechanics.report.answer.sentences import (
    AS_ASKED,
    COUNTED,
    about,
    counted,
    formulas_alone,
    order,
    place,
    quoted,
    read_as,
    sides,
    solved,
    two_sided,
    which,
)
from mechanics.report.answer.sheets import shared_notes, shared_reasons, sheets
from mechanics.report.answer.source import Source
from mechanics.report.answer.term_values import term_values
from mechanics.report.answer.witness import short_state, short_value, short_values
from mechanics.scene import Scene

STYLES = {
    Verdict.PROVED: "bold green",
    Verdict.CERTIFIED: "bold green",
    Verdict.SUPPORTED: "bold yellow",
    Verdict.UNDECIDED: "bold yellow",
    Verdict.REFUTED: "bold red",
}
PLAIN_WIDTH = 80
OPEN = "wrong as it is read here, right as it may be meant"


def plain(answer: RenderableType, width: int = PLAIN_WIDTH) -> str:
    """An answer as text without colour."""
    file = StringIO()
    console = Console(file=file, width=width, color_system=None, highlight=False, emoji=False)
    console.print(answer)
    return "\n".join(line.rstrip() for line in file.getvalue().splitlines())


def answer(
    judged: Sequence[Judged], names: Sequence[Match] = (), remarks: Sequence[str] = (),
    scene: Scene | None = None, unjudged: Sequence[str] = (), aside: Sequence[str] = (),
) -> Group:  # fmt: skip
    """What became of statements, for `rich.console.Console.print`.

    Parameters
    ----------
    judged : sequence of Judged
    names : sequence of Match
        What names were taken for; those that are the same are not told.
    remarks : sequence of str
    scene : Scene, optional
        What follows from the state of a witness is told as far as it places the scene.
    unjudged : sequence of str
        Sentences beside the statements; the first line counts them where the rest is shown.
    aside : sequence of str
        What was set aside, as the person asked.
    """
    parts: list[RenderableType] = []
    if words := formulas_alone([e.verdict for e in judged], len(unjudged), len(aside)):
        parts += [Hanging(line(words)), ""]
    apart = False
    told, notes = shared_notes(judged)
    told, reasons = shared_reasons(told)
    for reason in reasons:
        lead = f"{', '.join(reason.tags)}: "
        parts += [Hanging(line(reason.words, STYLES[Verdict.UNDECIDED], lead)), ""]
    for sheet in sheets(told):
        made = [line for n, entry in enumerate(sheet) for line in one(entry, scene, again=n > 0)]
        if parts and parts[-1] != "" and (len(made) > 1 or apart):
            parts.append("")
        parts, apart = parts + made, len(made) > 1
    hand = hand_of(judged[0].statement) if judged else Hand("", None)
    last: list[RenderableType] = [
        *_names(names),
        *(Hanging(line(words, "dim")) for words in notes),
        *(Hanging(line(spoken(words, hand), "dim")) for words in remarks),
        *(Hanging(line(words, "dim")) for words in quoted(unjudged, scene)),
        *(Hanging(line(words)) for words in quoted(aside, scene, AS_ASKED)),
    ]
    if len(judged) > 1:
        last.insert(0, Hanging(_counted(judged)))
    if apart and last:
        parts.append("")
    return Group(*parts, *last)


def one(
    entry: Judged, scene: Scene | None = None, *, again: bool = False
) -> Iterator[RenderableType]:
    """Everything about one statement; of a further row of an equation that is shown, its own."""
    statement, finding, blame = entry.statement, entry.finding, entry.blame
    repairs = blame.repairs if blame is not None else ()
    edits = repairs[0].edits if repairs else ()
    head, source = _head(entry, again), printable(statement.source)
    if again and not edits:
        yield Hanging(head)
    elif not edits and cell_len(head.plain + source) + 2 <= PLAIN_WIDTH:
        yield Hanging(head.append(f"  {source}" if source else ""))
    else:
        yield Hanging(head)
        yield _source(statement.source, edits)
    helping = [below(line(words, "yellow", "right if ")) for words in entry.right_if]
    if entry.open:
        yield below(line(OPEN))
        yield from helping
    if entry.says_why:
        plain_words, known = meaning(finding)
        yield below(line(plain_words))
        if known:
            yield below(line(known, "dim", "(how it is known: ").append(")"))
    if blame is not None:
        yield from _blame(blame, statement)
    if not entry.open:
        yield from helping
    if not entry.of_dimension:
        yield from _state(entry, scene)
    yield from (below(line(note, "dim")) for note in statement.notes)


def _head(entry: Judged, again: bool = False) -> Text:
    statement, finding = entry.statement, entry.finding
    where = "" if again else place(statement)
    details = [words for words in (about(statement), where) if words]
    tag = f"  {printable(statement.tag)}"
    words = printable("".join(f"  {words}" for words in details))
    verdict = (printable(headline(finding, entry.verdict)), STYLES[entry.verdict])
    return Text.assemble(verdict, (tag, "bold"), (words, "dim"))


def _source(source: str, edits: Sequence[Edit]) -> Source:
    return Source(shortened(pieces(source, edits)))


def _blame(blame: Blame, statement: Statement) -> Iterator[RenderableType]:
    for n, repair in enumerate(blame.repairs):
        yield from _repair(repair, statement, first=n == 0)
    if blame.searched:
        yield below(line(blame.searched))
    if blame.differences:
        yield ""
        if two_sided(statement):
            yield below(line(COUNTED, "dim"))
        yield from (Differences(blame.differences), "")
    for words in blame.explanations:
        yield below(line(spoken(words, hand_of(statement)), "yellow", "because: "))


def _repair(repair: Repair, statement: Statement, *, first: bool) -> Iterator[RenderableType]:
    for n, (edit, where) in enumerate(counted(repair.edits)):
        lead = "and " if n else "" if first else "or "
        yield below(_edit(edit, lead, where))
    if not first and any(_ambiguous(edit, statement.source) for edit in repair.edits):
        yield _source(statement.source, repair.edits)
    verdict = repair.finding.verdict.name
    yield below(line(f"then {which(statement)}{verdict}: {repair.repaired}", "dim"))


def _ambiguous(edit: Edit, source: str) -> bool:
    """Whether the words alone do not say where an edit belongs."""
    return edit.span is not None and (not edit.written or source.count(edit.written) > 1)


def _edit(edit: Edit, lead: str, where: str) -> Text:
    text, gap = Text(lead), ""
    for word, formula in order(edit):
        style = "bold green" if word in ("write", "add") else "bold red"
        text.append(f"{gap}{word} ").append(printable(formula), style)
        gap = " "
    text.append(f" {where}" if where else "")
    return text.append(f": {edit.mistake.value}")


def _state(entry: Judged, scene: Scene | None) -> Iterator[RenderableType]:
    """The state of a witness with what goes with it; both values there."""
    finding: Finding = entry.finding
    if finding.witness is None:
        return
    witness = finding.witness
    values = short_values(witness.left, witness.right)
    yield below(line(difference(sides(entry.statement), values)))
    if terms := term_values(entry.statement, witness):
        yield below(line(f"term by term: {_listed(terms, ' = ')}", "dim"))
    state = [(name, short_state(value)) for name, value in witness.state]
    yield below(line(f"the state: {_listed(state)}", "dim"))
    if held := solved(entry.statement, witness.solved, scene):
        short = [(name, short_value(value)) for name, value in held]
        yield below(line(f"with {_listed(short)}", "dim"))
    yield below(line(finding.evidence, "dim", "(how it is known: ").append(")", "dim"))


def _listed(values: Iterable[tuple[str, str]], sign: str = "=") -> str:
    return ", ".join(f"{name}{sign}{value}" for name, value in values)


def _names(names: Sequence[Match]) -> Iterator[RenderableType]:
    given = [(m.name, m.meaning) for m in names if m.why == "as given"]
    if given:
        yield Hanging(line(f"names as given: {_listed(given)}", "dim"))
    for match in names:
        if match.guessed:
            yield Hanging(line(read_as(match)))


def _counted(judged: Sequence[Judged]) -> Text:
    counts = [(v, sum(e.verdict is v for e in judged)) for v in Verdict]
    parts = [Text(f"{count} {v.name}", STYLES[v]) for v, count in counts if count]
    return Text(", ").join(parts)

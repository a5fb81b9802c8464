r"""What the sentences around a statement say of it: that it is wrong, or how its names are counted.

    This is not true: $$ a = b $$                            what is shown of it is UNDECIDED
    where $\theta$ is measured from the downward vertical     a declared convention

A convention is declared only where the scene counts otherwise; sentences say nothing that is not
listed here.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from sympy import Symbol

from mechanics.claims.convention import combined_table
from mechanics.claims.declared_conventions import Declared, read_declared, readings
from mechanics.claims.directions import counted
from mechanics.claims.names import Match
from mechanics.claims.prose import ENDS
from mechanics.claims.statement import Statement
from mechanics.errors import InputError
from mechanics.judge.markup import unread_markup
from mechanics.judge.phrases import BACK, DENIAL
from mechanics.judge.sentences import (
    Said,
    against,
    conventions,
    described,
    marked,
    outside,
    passed_over,
    quoted,
    senses,
    sentences,
)
from mechanics.kernel import Verdict, undecided
from mechanics.report.answer.judged import Judged
from mechanics.scene import Scene

UNITS = re.compile(r"\b(?P<name>\w+)\s*\([^()\n]*\bunit\s*=\s*\"deg", re.IGNORECASE)
"""Degrees in a declaration of Modelica's."""
COMMENT = re.compile(r"(?://|/\*|[%#])[^\n]*|\"\"\".*?\"\"\"|\'\'\'.*?\'\'\'", re.DOTALL)


MOST_QUOTED = 4
"""Sentences of one answer."""


def as_told(entry: Judged, statement: Statement, contradictions: Sequence[str]) -> Judged:
    """The entry; what is shown is not where the text says otherwise of it, or of its units.

    Parameters
    ----------
    statement : Statement
        As it was read.
    contradictions : sequence of str
        What the text says of quantities that the scene has otherwise.
    """
    entry = undenied(in_radians(entry, statement), statement)
    if entry.finding.shown and contradictions:
        words = f"it is right as the scene has it, but {'; '.join(contradictions)}"
        return replace(entry, finding=undecided(entry.finding.subject, words))
    return entry


def undenied(entry: Judged, statement: Statement) -> Judged:
    """The entry; what its own sentence calls wrong is not shown."""
    written = statement.written
    if not entry.finding.shown or written is None or not written.text:
        return entry
    ends = [0, *(m.end() for m in ENDS.finditer(written.text)), len(written.text)]
    start = max(end for end in ends if end <= written.start)
    end, *later = [end for end in ends if end > written.start]
    if BACK.match(written.text, end):
        end = later[0]
    denial = DENIAL.search(written.text, start, end)
    if denial is None:
        return entry
    words = f"it is right, but the text says of it {denial[0]!r}: leave that out"
    return replace(entry, finding=undecided(entry.finding.subject, words))


def in_radians(entry: Judged, statement: Statement) -> Judged:
    """The entry; what holds for radians is not shown where the text says degrees."""
    written = statement.written
    if not entry.finding.shown or written is None:
        return entry
    for degrees in UNITS.finditer(written.text):
        words = f"it is right in radians, but the text says {degrees['name']} in degrees"
        return replace(entry, finding=undecided(entry.finding.subject, words))
    return entry


@dataclass(frozen=True)
class Prose:
    """What texts say beside their statements.

    Attributes
    ----------
    conventions : tuple of Declared
        How a text says that it counts, where the scene counts otherwise.
    against : tuple of str
        What it says that the scene has otherwise, or may say so, in words that were not read.
    remarks : tuple of str
        Sentences that were not read, and have no word that may deny or limit a statement.
    """

    conventions: tuple[Declared, ...]
    against: tuple[str, ...]
    remarks: tuple[str, ...]


def prose_of(
    scene: Scene, statements: Sequence[Statement], known: Sequence[Match], code: Sequence[str] = ()
) -> Prose:
    """What the texts of statements say of a scene.

    Parameters
    ----------
    known : sequence of Match
        What names of the person were taken for.
    code : sequence of str
        Source of functions, of which comments and documentation are prose.
    """
    about = Said(scene, known)
    names = {*(match.name for match in known), *about.parameters, *about.coordinates, *about.inputs}
    written = {s.written.text: s.written.notation for s in statements if s.written is not None}
    held = frozenset({*scene.q, *scene.input_symbols, *scene.parameters})
    every = (one for text in sorted(written) for one in sentences(text, written[text], names))
    texts = [*dict.fromkeys(every)]
    told = dict.fromkeys(one for text in texts for one in conventions(about, text))
    own = dict.fromkeys(one for text in texts for one in described(about, text))
    counted = [d for one in told for d in _another(scene, one, held, known)]
    counted += [d for one in own if one not in told for d in read_declared([one], known)]
    contrary = [one for text in texts for one in against(about, text)]
    for comment in (m[0] for text in code for m in COMMENT.finditer(text)):
        for text in sentences(comment, "code", names):
            ways = (*conventions(about, text), *described(about, text))
            counts = (one for one in ways if _another(scene, one, held, known))
            contrary += [f"a comment says that it counts otherwise: {one}" for one in counts]
            contrary += against(about, text, whole=False)
    for text in (text for text, notation in written.items() if notation == "latex"):
        unread = (
            f"{one} is not read: it may hide what it holds" for one in unread_markup(marked(text))
        )
        contrary += unread
    contrary += (one for text in written for one in outside(about, text))
    others = [f"'{quoted(text)}'" for text in texts if passed_over(about, text)]
    more = [f"and {len(others) - MOST_QUOTED} more"] if len(others) > MOST_QUOTED else []
    words = ", ".join(others[:MOST_QUOTED] + more)
    remarks = (f"formulas are judged, these words are not: {words}",) if others else ()
    return Prose(tuple(counted), tuple(dict.fromkeys(contrary)), remarks)


def seen_from_one_side(
    scene: Scene, entry: Judged, statement: Statement, known: Sequence[Match]
) -> Judged:
    """A refuted entry, open where it is right with all that left and right say turned round."""
    written = statement.written
    if written is None or entry.finding.verdict is not Verdict.REFUTED or not entry.right_if:
        return entry
    about = Said(scene, known)
    texts = sentences(written.text, written.notation, [match.name for match in known])
    told = any(True for text in texts for _ in senses(about, text))
    return replace(entry, open=True) if told else entry


def _other_vertical(scene: Scene, said: str, known: Sequence[Match]) -> str:
    """The convention of an angle without a sense, as in space, that is counted from the other end.

    Empty where the scene counts so, or tells no vertical.
    """
    way, _, name = said.rpartition(" of ")
    own = next((match.meaning for match in known if match.name == name), name)
    turned = {"up": 3, "downward vertical": 1, "hanging": 1}
    quarter = next((q for start, q in turned.items() if way.startswith(start)), None)
    angles = [a for a in counted(scene) if a.symbol.name == own and not a.sense]
    return f"other vertical of {name}" if any(a.quarter == quarter for a in angles) else ""


def _another(
    scene: Scene, said: str, held: frozenset[Symbol], known: Sequence[Match]
) -> tuple[Declared, ...]:
    """What is said as a convention, unless the scene counts so, or has nothing that it is about."""
    meaning = {p.name: getattr(p, "meaning", "") for p in scene.parameters}
    try:
        declared = read_declared([said], known)
        changes = readings(scene, declared, held)
    except InputError:
        other = _other_vertical(scene, said, known)
        return _another(scene, other, held, known) if other else ()
    sizes = [meaning.get(d.of, "") for d in declared if "length" in d.name]
    if any(not words or "half" in words for words in sizes):
        return ()  # the scene counts so, or does not say how
    tables = [combined_table(change) for change in changes]
    same = any(all(s == e for s, e in table.items()) for table in tables)
    return () if same or not tables else declared

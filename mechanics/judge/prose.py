r"""What the sentences around a statement say of it: that it is wrong, or how its names are counted.

    This is not true: $$ a = b $$                            what is shown of it is UNDECIDED
    where $\theta$ is measured from the downward vertical     a declared convention

A convention is declared only where the scene counts otherwise; sentences say nothing that is not
listed here.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from sympy import Symbol

from mechanics.claims.convention import combined_table
from mechanics.claims.declared_conventions import Declared, read_declared, readings
from mechanics.claims.directions import counted
from mechanics.claims.names import Match
from mechanics.claims.prose import ENDS
from mechanics.claims.statement import Statement
from mechanics.errors import InputError
from mechanics.judge.descriptions import BARE, NAME, described, senses
from mechanics.kernel import Verdict, undecided
from mechanics.report.answer.judged import Judged
from mechanics.scene import Scene

DENIAL = re.compile(
    r"\b(?:is|are|was|were|be) (?:\w+ly )?"
    r"(?:wrong|false|incorrect|erroneous|not (?:true|correct|right))\b"
    r"|\bnot (?:true|correct|right|the case) that\b"
    r"|\b(?:wrong|incorrect|erroneous|false|mistaken) "
    r"(?:equation|result|expression|formula|answer)s?\b"
    r"|\b(?:incorrectly|wrongly|mistakenly|erroneously|falsely)\b"
    r"|\b(?:do(?:es)?|did) not (?:hold|apply)\b|\b(?:fails? to hold|is invalid|cannot be right)\b"
    r"|\\text\w*\s*\{\W*(?:wrong|false|incorrect|not true)\W*\}",
    re.IGNORECASE,
)
SENSE = r"(?:(?P<sense>(?:counter|anti)-?clockwise|clockwise)\s+)?"
DIRECTION = re.compile(
    rf"{NAME}\s*(?:is|be|being|denotes|,)?\s*(?:the angle\s+(?:of (?:the )?\w+\s+)?)?"
    rf"(?:(?:measured|counted|taken|reckoned)\s+)?{SENSE}from\s+(?:the\s+)?"
    r"(?P<way>(?:downward|upward)s?\s+vertical|upright|hanging|horizontal)\b",
    re.IGNORECASE,
)
MAKES = re.compile(
    rf"{NAME}\s*(?:is|be|being|denotes|,)?\s*the angle\s+(?:(?!from\b)[\w']+\s+){{0,6}}?"
    r"(?:with|and|to)\s+(?:the\s+)?(?P<way>(?:downward|upward)s?\s+vertical|horizontal)\b",
    re.IGNORECASE,
)
END = re.compile(
    rf"{NAME}\s*(?:is|be|being|,)?\s*(?:measured|counted|taken|reckoned)\s+from\s+(?:the\s+)?"
    r"(?P<way>top|highest|bottom|lowest)\b",
    re.IGNORECASE,
)
ZERO = re.compile(
    rf"\$\s*{BARE}\s*=\s*0\s*\$\s*(?:is|corresponds to|denotes|means|describes|in|at|being)\s+"
    r"(?:the\s+)?(?P<way>downward|upward|upright|inverted|hanging|horizontal)\b",
    re.IGNORECASE,
)
SIZE = re.compile(
    rf"{NAME}\s*(?:is|be|being|denotes|,)?\s*(?:the\s+)?(?P<size>half|twice)[\s-]+(?:of\s+)?"
    r"(?:(?:the|its)\s+)?(?:total |full |whole )?length\b",
    re.IGNORECASE,
)
DOUBLE = re.compile(
    rf"\$\s*2\s*{BARE}\s*\$\s*(?:is|be|being|denotes|,)\s*(?:the|its)\s+(?:\w+\s+)?length\b",
    re.IGNORECASE,
)
PLAIN = {
    "downward": "hanging", "upward": "upright", "inverted": "upright", "top": "upright",
    "highest": "upright", "bottom": "hanging", "lowest": "hanging",
}  # fmt: skip
DEGREES = re.compile(
    rf"{NAME}\s*(?:is|are|be|being|,)\s*(?:measured|given|taken|expressed)?\s*in\s+degrees\b"
    r"|\b(?P<declared>\w+)\s*\([^()\n]*\bunit\s*=\s*\"deg",
    re.IGNORECASE,
)
"""In prose, and in a declaration of Modelica's."""


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
    end = min(end for end in ends if end > written.start)
    denial = DENIAL.search(written.text, start, end)
    if denial is None:
        return entry
    words = f"it is right, but the text says of it {denial[0]!r}: leave that out"
    return replace(entry, finding=undecided(entry.finding.subject, words))


def in_radians(entry: Judged, statement: Statement) -> Judged:
    """The entry; what holds for radians is not shown where the text says degrees."""
    if entry.finding.shown and statement.written is not None:
        for degrees in DEGREES.finditer(statement.written.text):
            name = degrees["name"] or degrees["declared"]
            words = f"it is right in radians, but the text says {name} in degrees"
            return replace(entry, finding=undecided(entry.finding.subject, words))
    return entry


def said_conventions(
    scene: Scene, statements: Sequence[Statement], known: Sequence[Match]
) -> tuple[Declared, ...]:
    """How a text says that it counts, where the scene counts otherwise.

    Parameters
    ----------
    known : sequence of Match
        What names of the person were taken for.
    """
    texts = sorted({s.written.text for s in statements if s.written is not None})
    said = dict.fromkeys(one for text in texts for one in _said(text))
    held = frozenset({*scene.q, *scene.input_symbols, *scene.parameters})
    own = dict.fromkeys(one for text in texts for one in described(scene, text, known))
    counted = (d for one in said for d in _another(scene, one, held, known))
    return (*counted, *(d for one in own if one not in said for d in read_declared([one], known)))


def seen_from_one_side(
    scene: Scene, entry: Judged, statement: Statement, known: Sequence[Match]
) -> Judged:
    """A refuted entry, open where it is right with all that left and right say turned round."""
    written = statement.written
    if written is None or entry.finding.verdict is not Verdict.REFUTED or not entry.right_if:
        return entry
    told = any(True for _ in senses(scene, written.text, known))
    return replace(entry, open=True) if told else entry


def _said(text: str) -> Iterator[str]:
    plain = " ".join(text.split())
    for match in DIRECTION.finditer(plain):
        way = re.sub(r"wards\b", "ward", match["way"].lower())
        sense = f" {match['sense'].lower()}" if match["sense"] else ""
        yield f"{way}{sense} of {_name(match)}"
    for match in MAKES.finditer(plain):
        way = re.sub(r"wards\b", "ward", match["way"].lower())
        yield f"{way} of {_name(match)}"
    for match in (*ZERO.finditer(plain), *END.finditer(plain)):
        way = match["way"].lower()
        yield f"{PLAIN.get(way, way)} of {_name(match)}"
    for match in SIZE.finditer(plain):
        size = {"half": "half-length", "twice": "twice the length"}[match["size"].lower()]
        yield f"{size} of {_name(match)}"
    for match in DOUBLE.finditer(plain):
        yield f"half-length of {_name(match)}"


def _name(match: re.Match[str]) -> str:
    return match["name"].replace("{", "").replace("}", "")


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

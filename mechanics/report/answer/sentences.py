r"""What has to be changed, in words.

write \frac{L^{2}}{3} for \frac{L^{2}}{12}: the factor is wrong
"""

import re
from collections.abc import Sequence

from mechanics.blame.result import Edit
from mechanics.claims.names import Match
from mechanics.claims.statement import Statement
from mechanics.kernel import Verdict
from mechanics.nearest import plural
from mechanics.scene import Scene
from mechanics.scene.quantities import EquationOfMotion, Identity, ReactionValue


def order(edit: Edit) -> tuple[tuple[str, str], ...]:
    """What to do as words and formulas: ``("write", right), ("for", written)``."""
    if not edit.written:
        return (("add", edit.right),)
    if not edit.right:
        return (("leave out", edit.written),)
    return (("write", edit.right), ("for", edit.written))


def counted(edits: Sequence[Edit]) -> list[tuple[Edit, str]]:
    """Edits that read alike once, with where they belong in words, where that has to be said."""
    alike: dict[tuple[str, str, str, str], list[Edit]] = {}
    for edit in edits:
        key = (edit.mistake.name, edit.written, edit.right, edit.definition)
        alike.setdefault(key, []).append(edit)
    return [(found[0], _where(found[0], len(found))) for found in alike.values()]


def _where(edit: Edit, count: int) -> str:
    words = [f"in {count} places"] if count > 1 else []
    to = "in" if edit.written else "to"
    words += [f"{to} the definition of {edit.definition}"] if edit.definition else []
    return ", ".join(filter(None, (" ".join(words), edit.place)))


COUNTED = "left side less right side, term by term:"
"""Above differences of an equation with something on either side."""


def two_sided(statement: Statement) -> bool:
    """Whether the right side of an equation is not nought, so that signs turn in the table."""
    row = statement.row
    return row is not None and isinstance(row.quantity, EquationOfMotion) and row.sides[-1] != 0


def which(statement: Statement) -> str:
    """What a repair was proved for, where its text makes several statements."""
    return "this row is " if " row " in statement.tag else ""


def read_as(match: Match) -> str:
    """What a name was taken for; a name that stays itself is said to be what it is."""
    if match.name == match.meaning:
        return f"{match.name} is {match.why}"
    return f"{match.name} is read as {match.meaning}: {match.why}"


def about(statement: Statement) -> str:
    """What a statement is about, where that is not plain from its look: ``"kinetic energy"``."""
    if statement.row is None:
        return ""
    quantity = statement.row.quantity
    if isinstance(quantity, EquationOfMotion | Identity):
        return ""
    if isinstance(quantity, ReactionValue):
        return f"reaction {quantity.name}"
    name = type(quantity).__name__
    return "".join(f" {c.lower()}" if c.isupper() else c for c in name).strip()


def place(statement: Statement) -> str:
    """Where it stands; a text without a name is not named."""
    return statement.place.removeprefix("text, ").removeprefix("LaTeX, ")


LINE = re.compile(r"line (\d+)$")


def line_of(statement: Statement) -> int:
    """In which line of its text a statement begins; 0 where it has none."""
    line = LINE.search(statement.place)
    return int(line[1]) if line else 0


def number_and_line(statement: Statement) -> str:
    """Its number where it has one, and its line: ``(2), line 4``."""
    line, tag = line_of(statement), statement.tag
    where = [tag] if tag.startswith("(") and tag != statement.source else []
    return ", ".join([*where, *([f"line {line}"] if line else [])])


def located(statement: Statement) -> str:
    """A statement as it is quoted: where it stands, and what is written."""
    where = number_and_line(statement)
    return f"{where}: {statement.source}" if where else statement.source


def sides(statement: Statement) -> tuple[str, str]:
    """What the two values of a witness are: of both sides, or of what is written and derived."""
    row = statement.row
    if row is not None and isinstance(row.quantity, EquationOfMotion | Identity):
        return "left", "right"
    return "written", "derived"


FORMULA = re.compile(r"[=<>^_\u2248\u221d\u2190-\u2194\u225c$\\]|\d\s?[A-Za-z]\b|\b[b-zB-HJ-Z]\b")
"""In a sentence that holds one, or a letter that stands for something."""
MOST_QUOTED = 8
"""Sentences of a person in one line."""
LONGEST = 120
"""Characters of one of them."""
TOKEN = re.compile(r"(?:\\[A-Za-z]+|\w+)(?:[\^_](?:\{[^{}]*\}|\w))*|\s+|.", re.DOTALL)
"""A name with its exponent, or another sign."""
QUANTITY = re.compile(
    r"[\d=%\u2026\u00bd\u2153\u00bc]|(?<![\w'])[^\W\daAI_](?!\w)"
    r"|\b(?:half|halves|thirds?|quarters?|fourths?|fifths?|sixths?|sevenths?|eighths?|ninths?"
    r"|tenths?|elevenths?|twel(?:fths?|ve)|twice|thrice|double|triple|squared?|cubed?|times|zero|one"
    r"|two|three|four|five|six|seven|eight|nine|ten|eleven|negative|minus|plus|sign|equals?"
    r"|no[tr]?|never|nobody|nowhere|none|only|neither|without|wrong|false|opposite|other"
    r"|reversed?|flip\w*|instead|mistakes?|ignored?|neglect\w*)\b",
    re.IGNORECASE,
)
"""Numbers, formulas, letters and what denies: what is likely to say something of a motion."""


def formulas_alone(verdicts: Sequence[Verdict], unjudged: int, aside: int = 0) -> str:
    """What of all is shown, or was chosen; empty where there is nothing to be said.

    Parameters
    ----------
    verdicts : sequence of Verdict
    unjudged : int
        How many sentences were not judged.
    aside : int
        How many lines and sentences were set aside, as the person asked.
    """
    shown = (Verdict.CERTIFIED, Verdict.PROVED)
    if not (unjudged or aside) or not verdicts:
        return ""
    proved = {*verdicts} <= {*shown}
    verdict = next((v.name for v in shown if v in verdicts), "")
    around = "it" if aside and len(verdicts) == 1 else "them"
    was = f"sentence around {around} was" if unjudged == 1 else f"sentences around {around} were"
    parts = [f"{unjudged} {was} not judged."] if unjudged and proved else []
    if not aside:
        return " ".join([f"The formulas are {verdict}.", *parts]) if proved else ""
    chosen = plural(len(verdicts), "statement")
    rest = "1 line or sentence is" if aside == 1 else f"{aside} lines or sentences are"
    parts.append(f"{rest} set aside by --only.")
    what = f"is {verdict}: {chosen}." if proved else f"is {chosen}, not all of it shown."
    return " ".join([f"What you chose {what}", *parts])


AS_ASKED = "not judged, as you asked"


def quoted(
    sentences: Sequence[str], scene: Scene | None = None, why: str = "not judged"
) -> tuple[str, ...]:
    """Sentences that were not judged, and how many there are beside, as one line.

    All that hold a formula or a name, and of the others those with quantities first, up to
    `MOST_QUOTED`: what may say something else than the formulas is never left out.

    Parameters
    ----------
    sentences : sequence of str
    scene : Scene, optional
    why : str
        What the line begins with.
    """
    if not sentences:
        return ()
    told = (*scene.q, *scene.input_symbols, *scene.parameters) if scene is not None else ()
    names = {symbol.name for symbol in told}
    formulas = [w for w in sentences if FORMULA.search(w) or _words(w) & names]
    others = [words for words in sentences if words not in formulas]
    if len(sentences) > MOST_QUOTED:
        others.sort(key=lambda words: not QUANTITY.search(words))
        others = others[: max(0, MOST_QUOTED - len(formulas))]
    few = len(sentences) <= MOST_QUOTED
    shown = list(sentences) if few else [*formulas, *others]
    first = ", ".join(f"'{shortened(words)}'" for words in shown)
    more = len(sentences) - len(shown)
    return (f"{why}: {first}{f' and {more} more' if more > 0 else ''}",)


def shortened(words: str) -> str:
    """A sentence; a long one up to the end of a token, with a sign that there is more."""
    if len(words) <= LONGEST:
        return words
    ends = [token.end() for token in TOKEN.finditer(words) if token.end() < LONGEST]
    return words[: ends[-1] if ends else LONGEST - 1].rstrip() + "\u2026"


def _words(sentence: str) -> set[str]:
    return set(re.findall(r"\w+", sentence))


def solved(
    statement: Statement, found: Sequence[tuple[str, str]], scene: Scene | None = None
) -> list[tuple[str, str]]:
    """What goes with a state: where the scene is, and of the rest what the statement holds.

    Of a loop the coordinates, speeds and lengths that close it; of accelerations and reactions
    those that are spoken of.
    """
    if statement.row is None:
        return list(found)
    held = set().union(*(side.free_symbols for side in statement.row.sides))
    if scene is not None:
        held.update(scene.q, scene.qd, scene.u, scene.parameters)
    names = {symbol.name for symbol in held}
    return [(name, value) for name, value in found if name in names]

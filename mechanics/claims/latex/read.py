r"""LaTeX as people write it: ``read_latex(text, naming) -> lines``.

    \begin{equation*} (M+m) \ddot{x} + 2 k x + ... = 0 \tag{6} \end{equation*}

A text that displays its equations ($$, \[, equation, align), or writes them in prose between single
$, is a document; the prose between is not read. A line that begins with = or with a sign goes on
from the one before.
"""

import re
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise

from lark import Token, Tree
from lark.exceptions import UnexpectedCharacters, UnexpectedEOF, UnexpectedInput, UnexpectedToken

from mechanics.claims.columns import names_a_column
from mechanics.claims.functions import FUNCTIONS
from mechanics.claims.latex.bars import barred
from mechanics.claims.latex.blocks import (
    BRACES,
    NUMBER,
    SPACE,
    UNIT,
    Block,
    blocks,
    claims,
    continued,
    is_value,
)
from mechanics.claims.latex.case_beside import is_case
from mechanics.claims.latex.fold import ALL, FIRST, GLUED, SLASH, Fold
from mechanics.claims.latex.grammar import PARSER
from mechanics.claims.latex.item import bare
from mechanics.claims.latex.items import Items
from mechanics.claims.latex.outside_formulas import stray, within
from mechanics.claims.latex.pieces import Pieces, is_kind
from mechanics.claims.latex.prepare import labels, prepared, states, without_boxes
from mechanics.claims.latex.rows import rows
from mechanics.claims.latex.variants import with_variants
from mechanics.claims.latex.vectors import applied
from mechanics.claims.latex.words import SUM
from mechanics.claims.lines import Aside, Entry, Line, Unread, gives, gives_constants, value
from mechanics.claims.names import Naming
from mechanics.claims.place import Refused, bounded, bounded_mathematics, refusal
from mechanics.claims.prose import energy_before
from mechanics.claims.spelled_rates import key
from mechanics.claims.tree import Name, Node, ended, move

ABOUT = ("\u2248", r"\approx", r"\simeq", r"\sim")
ABOUT_NUMBER = re.compile(
    rf"{SPACE}(?:{NUMBER}{SPACE}(?:{UNIT}{SPACE})*|\\(?:SI|qty)\s?\{{\s?{NUMBER}\s?\}}\s?{BRACES})[.,;]?"
)
BY_CASES = re.compile(r"=[\s&]*(?:\\left\s*(?:\.|\\\{)\s*)?\\begin\s*\{d?cases\}")
TAG = re.compile(r"[{(]\s*(.*?)\s*[})]", re.DOTALL)


def read_latex(text: str, naming: Naming, origin: str = "LaTeX") -> list[Entry]:
    """Lines of a text in LaTeX, in order.

    Parameters
    ----------
    text : str
    naming : Naming
        Settles what can be read in two ways: whether f(t) is a product, ML one name.
    origin : str
        What messages call the text.

    Raises
    ------
    InputError
        When the text is too long.
    """
    bounded(text, origin)
    try:
        clean = prepared(text)
        formulas = [clean[block.start : block.end] for block in blocks(clean)]
        clean = with_variants(clean, formulas, naming)
        clean, every = continued(clean, blocks(clean))
        alone = {b.start for b in every if b.closed and not claims(clean[b.start : b.end])}
        called = {at: letter for at in alone if (letter := energy_before(clean, at))}
        spans = [b for b in every if not b.inline or b.start not in alone or b.start in called]
        bounded_mathematics(sum(block.end - block.start for block in spans), 0)
    except Refused as reason:
        raise refusal(text, reason, origin) from None
    found: list[Entry] = []
    for block in spans:
        source = " ".join(text[block.start : block.end].split())
        try:
            whole = clean if block.inline else without_boxes(clean, block.start, block.end)
            letter = called.get(block.start, "")
            if letter:
                found += _called(whole, text, block, naming, letter)
                continue
            found += _entries(whole, text, block, naming)
        except Refused as reason:
            tag = _tag_of(source)
            found.append(Unread(source, block.start, reason.at, reason.words, tag))
    inside = (span for block in spans for span in within(clean, block))
    labelled = (span for span in labels(text) if states(text[slice(*span)]))
    for start, end in (*stray(clean, every), *inside, *labelled):
        found.append(Unread(" ".join(text[start:end].split()), start, start, STRAY))
    return sorted(found, key=lambda entry: entry.at)


def _entries(clean: str, text: str, block: Block, naming: Naming) -> list[Entry]:
    """What a block says; what prose gives as a value is no claim."""
    formula = clean[block.start : block.end]
    if not block.closed:
        raise Refused(block.start, "the end of this display is missing")
    if not block.inline:
        if block.bare:
            formula = formula.replace("\n", END_OF_LINE)
        lines = _block(formula, text, block.start, naming, block.one)
        return [_of_case(_claim_or_value(entry, naming), text, naming) for entry in lines]
    entries = _block(formula, text, block.start, naming) if _moves(formula, naming) else []
    if is_value(formula) and not entries:
        column = _column(formula, text, block, naming)
        return (
            [column] if column is not None else [value(text[block.start : block.end], block.start)]
        )
    found: list[Entry] = []
    for entry in entries or _block(formula, text, block.start, naming):
        if not isinstance(entry, Line):
            found.append(entry)
        elif RATE_OF_MOMENTUM.search(formula) and len(entry.sides) > 1:
            found.append(entry)  # a law of conservation
        elif gives(entry, naming) and entries:
            found.append(Unread(entry.source, block.start, block.start, SET, entry.tag))
        elif gives(entry, naming):
            found.append(value(text[block.start : block.end], block.start))
        elif len(entry.sides) > 1:
            found.append(entry)
    return found


def _called(clean: str, text: str, block: Block, naming: Naming, letter: str) -> list[Entry]:
    """``kinetic energy: $m v^2/2$``: an expression by the name that the words before it give."""
    lines = _block(clean[block.start : block.end], text, block.start, naming)
    if naming.knows(letter) or not all(isinstance(n, Line) and len(n.sides) == 1 for n in lines):
        return []
    return [
        replace(line, sides=(ended(Name(line.at, letter), line.at), *line.sides))
        for line in lines if isinstance(line, Line)
    ]  # fmt: skip


def _of_case(entry: Entry, text: str, naming: Naming) -> Entry:
    """An entry; what only says for which case another one is meant is no claim."""
    if not isinstance(entry, Line) or not is_case(entry, text, naming):
        return entry
    words = f"{entry.source[:60]}: the case that an equation is given for"
    return Aside(words, entry.at)


def _claim_or_value(entry: Entry, naming: Naming) -> Entry:
    """What is displayed, but for the value of a parameter and one at the beginning."""
    if isinstance(entry, Aside) or _moves(entry.source, naming):
        return entry
    if isinstance(entry, Line) and gives_constants(entry, naming):
        return value(entry.source, entry.at)
    source = entry.source.replace("&", "")
    given = is_value(source) and (
        BEGINNING.search(source) is not None
        or naming.is_function(bare(source.split("=")[0])) is not True
    )
    if isinstance(entry, Line) and names_a_column(entry, naming):
        return entry
    return value(entry.source, entry.at) if given else entry


def _column(formula: str, text: str, block: Block, naming: Naming) -> Line | None:
    """A list that a name of the person's own stands for: a column of names."""
    try:
        entries = _block(formula, text, block.start, naming)
    except Refused:
        return None
    (entry,) = entries if len(entries) == 1 else (None,)
    found = isinstance(entry, Line) and names_a_column(entry, naming)
    return entry if isinstance(entry, Line) and found else None


SHORTER = "the argument of a function is its first factor: write brackets around it"
STRAY = "an equation outside of a formula is not read: put it between \\[ and \\]"
END_OF_LINE = "\u2028"
MIXED = re.compile(
    r"(?<![\w.^])(?<!_)(?P<whole>\d+)(?:\s|\\[,;:! ]|~|\{)*"
    r"(?:\\[dtc]?frac\s*(?:\{\s*(?P<above>\d+)\s*\}|(?P<a>\d))"
    r"\s*(?:\{\s*(?P<below>\d+)\s*\}|(?P<b>\d))"
    r"|(?P<c>\d+)\s*\\over\s*(?P<d>\d+))"
)
"""3\\tfrac12, a mixed number in print."""
FRAMED = re.compile(r"\\(?:under|over)brace\s*$")
BEGINNING = re.compile(r"\(\s?(?:0|t_0|t_\{0\})\s?\)\s?=")
SET = "an acceleration or reaction is given a value in the text, which is not judged: display it"
UNLIKE = re.compile(r"\\neq?")
SMALL_ANGLE = re.compile(
    r"\\?(?:sin|cos|tan)(?:\{?\(?\\?[\w{}]+\)?\}?)(?:\\approx|\\simeq|\\sim|\u2248)"
    r"(?:1(?:-\\?[dt]?frac\{?[^=]{1,30}\}?)?|\{?\\?[\w{}]+\}?|0)|"
    r"\{?\\dot\{?\\?\w+\}?\}?(?:_\{?\w\}?)?\^\{?2\}?(?:\\approx|\\simeq|\u2248)0"
)
OF_TIME = re.compile(r"\s|\(t\)|\(\s+t\s+\)")
GENERAL = re.compile(
    r"[^=(]{1,60}=\s*(?P<name>(?:\\(?:mathbf|boldsymbol|bm|vec|mathcal)\s?)?\{?(?:[A-Za-z]|\\[a-z]{2,8})"
    r"\}?(?:_\s?(?:\w|\{[^{}]*\}|\\\w+))?)\s*(?:\\left)?\s*"
    r"\([^=()+*/\d-]*,[^=()+*/-]*(?:\\right\s*)?\)\s*[.,]?"
)
UPRIGHT = re.compile(r"\\(?:mathrm|text|operatorname|si|SI|unit)\s*\{[^{}]*\}")
DOTTED = re.compile(r"\\d+ot(?![A-Za-z])")
RATE_OF_MOMENTUM = re.compile(r"\\dot\s*\{?\s*p(?![a-z])")
ACCELERATED = re.compile(r"\\d{2,4}ot(?![a-z])|'{2,}")


def _moves(formula: str, naming: Naming) -> bool:
    """Whether an acceleration or a reaction stands in a formula: given a value, that is a claim."""
    # N is the unit newton, too.
    letters = set(re.findall(r"\w+(?:_\{\w+\})?", UPRIGHT.sub(" ", formula)))
    keys = {key(letter.replace("{", "").replace("}", "")) for letter in letters}
    reactions = {key(name) for name in naming.vocabulary.reactions}
    rates = ACCELERATED.search(formula) or RATE_OF_MOMENTUM.search(formula)
    return rates is not None or bool(keys & reactions)


@lru_cache(maxsize=64)
def _tree(text: str) -> Tree:
    """A text is read again when a name in it was guessed."""
    return PARSER.parse(text)


def _block(text: str, whole: str, offset: int, naming: Naming, one: bool = False) -> list[Entry]:
    if by_cases := BY_CASES.search(text):
        raise Refused(offset + by_cases.start(), "cases cannot be read: give one of them")
    try:
        tree = _tree(barred(text))
    except UnexpectedInput as error:
        raise _unexpected(error, text, offset) from None
    found: list[Entry] = []
    for row in rows(tree, text, one):
        pieces = row.pieces
        try:
            if row.doubt:
                raise Refused(_span(pieces)[0], row.doubt)
            _refuse_mixed(text, *_span(pieces))
            line = _line(pieces, text, whole, offset, naming)
        except Refused as reason:
            # One line that cannot be read does not spoil the others.
            line = _unread(pieces, whole, offset, Refused(offset + reason.at, reason.words))
        if line is not None:
            found.append(line)
    return found


def _refuse_mixed(text: str, start: int, end: int) -> None:
    """Refuse an integer that stands directly before a fraction of two integers that is below 1.

    Readers take it for their sum, as in a mixed number, or for their product.

    Raises
    ------
    Refused
    """
    for one in MIXED.finditer(text, start, end):
        whole = int(one["whole"])
        above, below = (
            int(next(one[name] for name in names if one[name]))
            for names in (("above", "a", "c"), ("below", "b", "d"))
        )
        if 0 < above < below:
            both = f"write \\frac{{{whole * below + above}}}{{{below}}} for the sum"
            words = f"{one[0]} may be a sum or a product: {both}, \\cdot for the product"
            raise Refused(one.start(), words)


def _unread(pieces: Pieces, whole: str, offset: int, reason: Refused) -> Unread:
    start, end = (offset + at for at in _span(pieces))
    source = " ".join(whole[start:end].split())
    return Unread(source, start, reason.at, reason.words, _tag_of(source))


def _unexpected(error: UnexpectedInput, text: str, offset: int) -> Refused:
    if isinstance(error, UnexpectedCharacters):
        at = error.pos_in_stream
        return Refused(offset + at, f"{text[at : at + 12].split(chr(10))[0]!r} cannot be read")
    if isinstance(error, UnexpectedToken) and error.token.type != "$END":
        at = error.token.start_pos or 0
        return Refused(offset + at, f"{str(error.token)[:20]!r} cannot be read")
    if isinstance(error, UnexpectedEOF | UnexpectedToken):
        return Refused(offset + len(text.rstrip()), "a bracket or argument is not closed")
    raise error


def _line(pieces: Pieces, text: str, whole: str, offset: int, naming: Naming) -> Entry | None:
    tag, kept = "", []
    for piece in pieces:
        if isinstance(piece, Token) and piece.type == "TAG":
            tag = _tag_of(piece.value)
        else:
            kept.append(piece)
    if not kept:
        return None
    unlike, kept = _without_unlike(kept)
    start, end = _span(kept)
    if framed := FRAMED.search(whole[max(0, offset + start - 14) : offset + start]):
        start -= len(framed[0])
    source = " ".join(whole[offset + start : offset + end].split())
    count, kept = len(kept), _without_number(kept, text)
    if len(kept) < count and not any(is_kind(piece, "REL") for piece in kept):
        return value(source, offset + start)
    if any(isinstance(piece, Token) and piece.type == "ORDER" for piece in kept):
        if SMALL_ANGLE.fullmatch(OF_TIME.sub("", source)):
            return Aside(f"{source[:60]}: approximations in the text are not used", offset + start)
        if _moves(source, naming):
            raise Refused(_span(kept)[0], "an inequality or approximation cannot be judged")
        return _condition(kept, source, offset + start)
    if _general(source, whole):
        words = f"{source[:60]}: a function that the text does not give, not judged"
        return Aside(words, offset + start)
    sides: list[Pieces] = [[]]
    for piece in kept:
        if is_kind(piece, "REL"):
            sides.append([])
        else:
            sides[-1].append(piece)
    notes = ["conditions in the text are not used"] if unlike else []
    unjudged: tuple[str, ...] = ()
    if len(sides) > 2 and len(kept := [side for side in sides if not _summed(side)]) > 1:
        unjudged = (f"the side with {SUM} in {source}",) if len(kept) < len(sides) else ()
        sides = kept
    fold = Fold(naming, notes)
    by_time = DOTTED.search(whole) is None
    nodes = _sides(sides, text, end, fold, by_time)
    others = _others(sides, text, end, naming, nodes, by_time) if SLASH in notes else ()
    if fold.several:
        shorter = _sides(sides, text, end, Fold(naming, [], argument=FIRST), by_time)
        others += ((SHORTER, shorter),) if shorter != nodes else ()
    for tree in (*nodes, *(node for _, other in others for node in other)):
        move(tree, offset)
    unique = tuple(dict.fromkeys(notes))
    return Line(nodes, tag, offset + start, source, unique, others, unjudged)


def _without_number(pieces: Pieces, text: str) -> Pieces:
    """The pieces without the number that they come to: T = 2 pi sqrt(l/g) ~ 2.0 s."""
    at = next((i for i, piece in enumerate(pieces) if is_kind(piece, "ORDER")), 0)
    if at == 0 or str(pieces[at]) not in ABOUT:
        return pieces
    behind = text[_span(pieces[at:])[0] + len(str(pieces[at])) : _span(pieces)[1]]
    return pieces[:at] if ABOUT_NUMBER.fullmatch(behind) else pieces


def _general(source: str, whole: str) -> bool:
    """Whether it says only on what something depends: x' = f(x, u), where nothing gives f."""
    match = GENERAL.fullmatch(source)
    if match is None or re.sub(r"\W", "", match["name"]) in FUNCTIONS:
        return False
    return re.search(re.escape(match["name"]) + r"\s*(?:\\left)?\s*\([^()=]*\)\s*=", whole) is None


def _letters(piece: Tree | Token) -> str:
    """A name, number or command with its scripts; empty for anything else."""
    base = piece.children[0] if isinstance(piece, Tree) else None
    return str(base) if isinstance(base, Token) else ""


def _summed(side: Pieces) -> bool:
    """Whether a side is a sum of anything but a name: what it runs over is not known."""
    return any(_letters(one) == SUM and not _letters(other) for one, other in pairwise(side))


def _sides(sides: list[Pieces], text: str, end: int, fold: Fold, by_time: bool) -> tuple[Node, ...]:
    items = Items(text, fold.naming, fold, fold.notes, by_time)
    parts = [items.of(side) for side in sides]
    if len(parts) > 1:
        parts[0] = applied(parts[0], fold.naming, fold.notes)
    return tuple(
        fold(part, _span(side)[0] if side else end) for part, side in zip(parts, sides, strict=True)
    )


def _others(
    sides: list[Pieces], text: str, end: int, naming: Naming, first: tuple[Node, ...],
    by_time: bool,
) -> tuple[tuple[str, tuple[Node, ...]], ...]:  # fmt: skip
    """The sides with more than one factor below a slash."""
    found: dict[tuple[Node, ...], str] = {}
    for below in (GLUED, ALL):
        fold = Fold(naming, [], below)
        nodes = _sides(sides, text, end, fold, by_time)
        if fold.slash is not None and nodes != first:
            words = " ".join(text[slice(*fold.slash)].split())
            found.setdefault(nodes, f"/{words} is /({words}): write the brackets")
    return tuple((words, nodes) for nodes, words in found.items())


def _without_unlike(pieces: Pieces) -> tuple[bool, Pieces]:
    r"""Whether a name behind ``\ne`` ends a chain of equalities, a = b \ne c, and the chain."""
    *chain, sign, last = [None, None, *pieces]
    ends = isinstance(sign, Token) and sign.type == "ORDER" and UNLIKE.fullmatch(sign.value)
    plain = isinstance(last, Tree) and not is_kind(last, "SIGN", "REL")
    if not ends or not plain or not any(p is not None and is_kind(p, "REL") for p in chain):
        return False, pieces
    return True, pieces[:-2]


def _condition(pieces: Pieces, source: str, at: int) -> Aside:
    """What compares names and numbers: ``b > 0``."""
    kinds = [piece.type if isinstance(piece, Token) else "" for piece in pieces]
    about = any(isinstance(p, Token) and p.value in ABOUT for p in pieces)
    moves = any(isinstance(p, Tree) and isinstance(p.children[0], Tree) for p in pieces)
    side_by_side = any(one == two == "" for one, two in pairwise(kinds))
    if side_by_side or (about and moves) or set(kinds) - {"", "ORDER", "SIGN"}:
        raise Refused(_span(pieces)[0], "an inequality or approximation cannot be judged")
    return Aside(f"{source[:60]}: conditions in the text are not used", at)


def _span(pieces: Pieces) -> tuple[int, int]:
    first, last = pieces[0], pieces[-1]
    start = first.start_pos if isinstance(first, Token) else first.meta.start_pos
    end = last.end_pos if isinstance(last, Token) else last.meta.end_pos
    return int(start or 0), int(end or 0)


def _tag_of(text: str) -> str:
    position = text.find("\\tag")
    match = TAG.search(text, max(position, 0)) if position >= 0 or "eqno" in text else None
    return f"({match[1].strip('()')})" if match else ""

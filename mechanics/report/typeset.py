"""Equations as HTML: one `<math>` on a line, or pieces: left = first term | + second | - third.

MathML breaks no lines by itself, so in an equation that is wider than a phone every term of a sum
is an element of its own; a line of the page may end between two of them, and inside of a long one.
What is wider still scrolls in its own box.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from html import unescape
from typing import Any

from markupsafe import Markup, escape
from sympy import MatrixBase, S

from mechanics.equations import Line, Side
from mechanics.report.latex_items import terms
from mechanics.report.line_breaks import broken, fits, line_box
from mechanics.report.notation import GREEK, latex, latex_name, mathml, operations, pieces
from mechanics.scene.published import Published

# Nodes of an expression beyond which it is folded away, and beyond which it is not printed.
FOLDED = 260
TOO_LONG = 2500
LONG = 50
"""Letters in one piece that a phone may not have room for."""
PAGE = 105
"""Letters in one piece that paper has no room for."""
WIDE = 60
"""Nodes in the columns of a matrix beyond which it is written entry by entry."""
# A letter, Latin or Greek, with a short subscript or dots.
REFERENCE = re.compile(r"\(([EFPKL]\d+)\)")
NAME = re.compile(rf"\b((?:[A-Za-z]|{'|'.join(sorted(GREEK))})_(?:\w{{1,2}}|d{{1,3}}ot))\b")


def equation(line: Line, section: int = 0) -> Markup:
    """One line of a derivation; its number, which opens its LaTeX, is the place others refer to."""
    size = _size(line.left) + _size(line.right)
    if size >= TOO_LONG:
        place = Markup(' id="{}"').format(anchor(line.number, section)) if section else ""
        number = f" ({line.number})" if line.number else ""
        return Markup('<p class="eq skipped"{}>{} = … <span class="note">{}</span></p>').format(
            place, maths(_plain(line.left)), f"too long to be read here{number}"
        )
    parts = [*_side(line.left), *([_equal(line.between)] if line.between else [])]
    parts += _after("=", _side(line.right))
    typeset = _row(parts, line.label, _number(line, parts, section), section)
    return typeset if size <= FOLDED else _folded(line, typeset)


def anchor(number: str, section: int) -> str:
    """The id of a numbered equation on the page."""
    return f"eq-{section}-{number}"


def slug(source: str) -> str:
    """What joins the terms of a load or reaction to its arrows: a class."""
    return "of-" + re.sub(r"\W+", "-", source)


@dataclass(frozen=True)
class Piece:
    """LaTeX that stays together, and the classes of the term that it is of."""

    latex: str
    classes: tuple[str, ...] = ()


def _side(side: Side) -> list[Piece]:
    if isinstance(side, str):
        return [Piece(named(side))]
    if not isinstance(side, tuple):
        return [Piece(part) for part in pieces(side)]
    found: list[Piece] = []
    for term in side:
        classes = ((slug(term.source),) if term.source else ()) + ("gone",) * term.cancels
        for part in pieces(term.value):
            signed = part[:2] in ("+ ", "- ")
            if found and not signed:
                part = f"- {part[1:].lstrip()}" if part[0] == "-" else f"+ {part}"
            found.append(Piece(part, classes))
    return found or [Piece("0")]  # a sum of no terms


def _equal(latex: str) -> Piece:
    return Piece(f"= {{{named(latex)}}}")


def _after(sign: str, side: list[Piece]) -> list[Piece]:
    first, *others = side
    return [replace(first, latex=f"{sign} {{{first.latex}}}"), *others]


def _plain(side: Side) -> str:
    return _side(side)[0].latex


def _size(side: Side) -> int:
    if isinstance(side, tuple):
        return sum(operations(term.value, TOO_LONG) for term in side)
    return operations(side, TOO_LONG)


def named(source: str) -> str:
    """LaTeX with the scene's symbols, which stand as <<theta_dot>>, in it."""
    return re.sub(r"<<(\w+)>>", lambda found: latex_name(found[1]), source)


def _number(line: Line, parts: Sequence[Piece], section: int) -> Markup:
    if not line.number:
        return Markup("")
    # Every route ends in the equations on top, which have their ids there.
    own = section and not line.number.startswith("E")
    place = Markup(' id="{}"').format(anchor(line.number, section)) if own else Markup("")
    return Markup(
        '<details class="tex"{}><summary title="LaTeX of this equation">({})</summary>'
        "<code>{}</code></details>"
    ).format(place, line.number, _source(parts))


def chain(sides: Sequence[Any], name: str = "") -> Markup:
    """The sides of a published row, joined by equality signs."""
    if len(sides) == 1 and isinstance(sides[0], str):
        return Markup('<p class="eq">{}</p>').format(sides[0])
    if len(sides) == 1 and isinstance(sides[0], MatrixBase) and _is_wide(sides[0]):
        return _entries(sides[0], name)
    found = [name] if name else []
    for side in sides:
        found += _joined("=", side) if found else pieces(side)
    return _row([Piece(part) for part in found], "")


def _is_wide(matrix: MatrixBase) -> bool:
    """Whether no page has room for the columns of the matrix."""
    if matrix.shape == (3, 1):
        return False  # a vector, set as a sum
    columns = matrix.T.tolist()
    return sum(max(operations(e, TOO_LONG) for e in column) for column in columns) > WIDE


def _entries(matrix: MatrixBase, name: str) -> Markup:
    """A matrix entry by entry: each value once, with all of its places; zeros are left out."""
    places: dict[Any, list[str]] = {}
    for i, row in enumerate(matrix.tolist(), 1):
        for j, entry in enumerate(row, 1):
            places.setdefault(entry, []).append(f"row {i}, column {j}")
    rest = places.pop(S.Zero, None)
    rows = [
        _row(
            [Piece(part) for part in ([name, *_joined("=", entry)] if name else pieces(entry))],
            "; ".join(where),
        )
        for entry, where in places.items()
    ]
    return Markup("").join([*rows, Markup('<p class="note">all others are 0</p>') if rest else ""])


def ledger_row(tag: str, sides: Sequence[Any]) -> Markup:
    """The sides of a published row; a tag ``"K, M"`` names as many sides that are no equality."""
    names = tag.split(", ")
    if len(names) == len(sides) > 1:
        return Markup("").join(
            chain((side,), latex_name(n)) for n, side in zip(names, sides, strict=True)
        )
    return chain(sides)


def as_typed(source: str) -> Markup:
    """An equation as its source types it, with its LaTeX to copy."""
    opened = Markup(
        '<details class="tex"><summary title="LaTeX of this equation">LaTeX</summary>'
        "<code>{}</code></details>"
    ).format(source)
    return _row([Piece(part) for part in terms(source)], "", opened)


def published(row: Published) -> Markup:
    """A published equation: as its source types it where that is kept, else its sides."""
    return as_typed(row.latex) if row.latex else ledger_row(row.tag, row.sides)


def tag(text: str) -> Markup:
    """A number or short label; one that is a letter, or LaTeX, is typeset."""
    if "\\" in text and "$" not in text:
        return maths(text)
    if text in GREEK or (len(text) == 1 and text.isalpha()):
        return maths(latex_name(text))
    return prose(text.replace("^2", "²"))


def prose(text: str, section: int = 0) -> Markup:
    """A sentence; LaTeX between dollar signs and names such as x_C or theta_dot are typeset.

    On a page with numbered equations (F3) leads to the third one by free bodies.
    """
    parts = re.split(r"\$([^$]+)\$", text)
    return Markup("").join(
        maths(named(part)) if i % 2 else _references(part, section) for i, part in enumerate(parts)
    )


def _references(text: str, section: int) -> Markup:
    if not section:
        return _names(text)
    parts = REFERENCE.split(text)
    return Markup("").join(
        Markup('<a href="#{}">({})</a>').format(anchor(part, section), part)
        if i % 2
        else _names(part)
        for i, part in enumerate(parts)
    )


def _names(text: str) -> Markup:
    parts = NAME.split(text)
    return Markup("").join(
        maths(latex_name(part)) if i % 2 else _raised(part) for i, part in enumerate(parts)
    )


def _raised(text: str) -> Markup:
    """2^-98 with its exponent raised."""
    return Markup(re.sub(r"\b(\d+)\^(-?)(\d+)", _power, str(escape(text))))


def _power(found: re.Match[str]) -> str:
    sign = "\N{MINUS SIGN}" if found[2] else ""
    return f"{found[1]}<sup>{sign}{found[3]}</sup>"


def inline(expr: Any) -> Markup:
    """A short expression inside a sentence or table."""
    return maths(latex(expr))


def _joined(sign: str, expr: Any) -> list[str]:
    first, *others = pieces(expr)
    return [f"{sign} {{{first}}}", *others]  # in braces a minus is a sign, no difference


def _row(parts: Sequence[Piece], label: str, number: Markup | str = "", section: int = 0) -> Markup:
    source = _source(parts)
    whole = fits(source)
    body = _whole(parts) if whole else Markup("<wbr>").join(map(_piece, parts))
    note = Markup('<span class="label">{}</span>').format(prose(label, section)) if label else ""
    # What may be wider than a page scrolls, which the keyboard has to reach.
    reach = Markup(' tabindex="0"') if not whole and _may_scroll(body) else ""
    return Markup('<div class="eq">{}{}{}</div>').format(
        line_box(body, source, reach), note, number
    )


def _source(parts: Sequence[Piece]) -> str:
    """LaTeX of a whole equation."""
    return " ".join(part.latex for part in parts)


def _may_scroll(body: str) -> bool:
    """Whether something between two places to break is wider than a phone."""
    parts = (re.sub(r"<[^>]*>|&\w+;", "", part) for part in body.split("<wbr>"))
    return max(map(len, parts)) > LONG


def _fitted(typeset: Markup) -> Markup:
    """With the number of its letters where paper has no room for a part that breaks nowhere."""
    parts = (unescape(re.sub(r"<[^>]*>", "", part)) for part in typeset.split("<wbr>"))
    letters = max(map(len, parts))
    if letters <= PAGE:
        return typeset
    return Markup('<span class="wide" style="--letters: {}">{}</span>').format(letters, typeset)


def _piece(part: Piece) -> Markup:
    return _classed(part, "span", _fitted(broken(part.latex, maths) or maths(part.latex)))


def _whole(parts: Sequence[Piece]) -> Markup:
    """One element for all pieces of an equation; each stays one inside of it."""
    rows = []
    for part in parts:
        opened, inner = maths(part.latex).removesuffix("</math>").split(">", 1)
        rows.append(_classed(part, "mrow", Markup(inner)))
    return Markup("{}>{}</math>").format(Markup(opened), Markup("").join(rows))


def _classed(part: Piece, element: str, typeset: Markup) -> Markup:
    if not part.classes:
        return typeset
    focus = Markup(' tabindex="0"') if part.classes[0] != "gone" else ""
    return Markup('<{0} class="{1}"{2}>{3}</{0}>').format(
        Markup(element), " ".join(part.classes), focus, typeset
    )


def _folded(line: Line, typeset: Markup) -> Markup:
    many = len(_side(line.right))
    head = maths(named(line.left)) if isinstance(line.left, str) else Markup("")
    words = f"{many} terms" if many > 1 else "a long expression"
    title = Markup("{} = … ").format(head) if head else Markup("")
    return Markup(
        '<details class="fold"><summary>{}<span class="note">{}{}</span></summary>{}</details>'
    ).format(title, words, f" ({line.number})" if line.number else "", typeset)


def maths(source: str) -> Markup:
    """LaTeX as MathML."""
    return Markup(mathml(source))

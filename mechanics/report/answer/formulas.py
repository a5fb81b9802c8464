r"""A person's formulas on a page, in the person's own notation, wrong parts marked.

LaTeX is typeset, and text is as it was typed, term by term; what cannot be is shown as it stands.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from markupsafe import Markup

from mechanics.blame.result import Edit
from mechanics.claims.functions import FUNCTIONS
from mechanics.claims.lines import Line
from mechanics.claims.names import Naming
from mechanics.claims.place import Refused
from mechanics.claims.statement import Statement
from mechanics.claims.text.read import read_text
from mechanics.errors import InputError
from mechanics.report.answer.marks import Piece, pieces, printable
from mechanics.report.answer.person_latex import clean, marked
from mechanics.report.answer.safe_mathml import safe_mathml
from mechanics.report.answer.tree_latex import TreeLatex, function_latex
from mechanics.report.latex_items import width
from mechanics.report.line_breaks import broken, line_box

COLUMN = 16
"""Characters that fit into one of four columns."""


@dataclass(frozen=True)
class Hand:
    """How one statement is written.

    Attributes
    ----------
    notation : str
        ``"latex"``, ``"text"`` or ``"code"``; of anything else nothing is typeset.
    naming : Naming or None
        Settles what text means.
    """

    notation: str
    naming: Naming | None

    def latex(self, text: str) -> str | None:
        """LaTeX of a part of the statement; None where it is none that can be typeset."""
        if self.notation == "latex":
            return clean(text)
        if text.strip() in ("+", "-"):
            return text
        if text in FUNCTIONS:
            return function_latex(text)
        if text.startswith("+"):
            term = self.latex(text[1:])
            return None if term is None else f"+ {term}"
        sides = self._sides(text)
        return None if sides is None else " = ".join(map(TreeLatex(), sides))

    def statement(self, source: str, edits: Sequence[Edit]) -> str | None:
        """LaTeX of the whole of it, marked; None where not every mark finds its place."""
        if self.notation == "latex":
            return marked(pieces(source, edits))
        sides = self._sides(source)
        right = {
            _inside(source, e.span): self.latex(e.right) if e.right else "" for e in edits if e.span
        }
        if sides is None or None in right.values():
            return None
        setter = TreeLatex({span: text or "" for span, text in right.items()})
        latex = " = ".join(map(setter, sides))
        return latex if setter.placed == set(right) else None

    def _sides(self, text: str) -> Sequence | None:
        if self.notation not in ("text", "code") or self.naming is None:
            return None
        try:
            lines = read_text(text, self.naming)
        except (InputError, Refused):
            return None
        (line,) = lines if len(lines) == 1 else (None,)
        return line.sides if isinstance(line, Line) else None


def _inside(source: str, span: tuple[int, int]) -> tuple[int, int]:
    """A span without the signs of multiplication at its ends, which are no part of a factor."""
    text = source[slice(*span)]
    start = span[0] + len(text) - len(text.lstrip(" *"))
    return (start, start + len(text.strip(" *"))) if text.strip(" *") else span


def hand_of(statement: Statement) -> Hand:
    """How a statement is written."""
    written = statement.written
    return Hand("", None) if written is None else Hand(written.notation, written.naming)


def equation(source: str, hand: Hand, edits: Sequence[Edit] = ()) -> Markup:
    """A statement on lines of its own, marked where edits change it."""
    latex = hand.statement(source, edits)
    return _typeset(latex) or _code(pieces(source, edits))


def formula(text: str, hand: Hand) -> Markup:
    """A formula inside a sentence or table."""
    latex = hand.latex(text)
    shown = safe_mathml(latex) if latex and latex.strip() else None
    return shown or Markup("<code>{}</code>").format(printable(text))


def block(text: str, hand: Hand) -> Markup:
    """A formula on lines of its own."""
    return _typeset(hand.latex(text)) or _code((Piece(text),))


def wide(text: str, hand: Hand) -> bool:
    """Whether a formula is too wide for a column of a table."""
    return width(hand.latex(text) or text) > COLUMN


def _typeset(latex: str | None) -> Markup | None:
    if latex is None:
        return None
    shown = broken(latex, safe_mathml)
    if shown is None:
        return None
    return Markup('<div class="eq">{}</div>').format(line_box(shown, latex))


def _code(found: Sequence[Piece]) -> Markup:
    body = Markup("").join(_marked_text(piece) for piece in found)
    return Markup('<p class="typed"><code>{}</code></p>').format(body)


def _marked_text(piece: Piece) -> Markup:
    text = Markup("{}").format(printable(piece.text))
    if piece.edit is None:
        return text
    wrong = Markup('<del class="wrong">{}</del>').format(text) if text else Markup("")
    if not piece.edit.right:
        return wrong
    return wrong + Markup('<ins class="right">{}</ins>').format(printable(piece.edit.right))

"""Equations as HTML that breaks between terms: left = first term | + second | - third.

MathML breaks no lines by itself, so every term of a sum is an element of its own, and a line of the
page may end between two of them, and inside of a long one. What is wider still scrolls in its own
box.
"""

import re
from collections.abc import Sequence
from typing import Any

from markupsafe import Markup, escape
from sympy import Add

from mechanics.equations import Line
from mechanics.report.breaking import broken
from mechanics.report.notation import GREEK, latex, latex_name, mathml, operations, pieces

# Nodes of an expression beyond which it is folded away, and beyond which it is not printed.
FOLDED = 260
TOO_LONG = 2500
# A letter, Latin or Greek, with a short subscript or dots.
NAME = re.compile(rf"\b((?:[A-Za-z]|{'|'.join(sorted(GREEK))})_(?:\w{{1,2}}|d{{1,3}}ot))\b")


def equation(line: Line) -> Markup:
    """One line of a derivation."""
    left = [line.left] if isinstance(line.left, str) else pieces(line.left)
    size = operations(line.left, TOO_LONG) + operations(line.right, TOO_LONG)
    if size >= TOO_LONG:
        return Markup('<p class="eq skipped">{} = … <span class="note">{}</span></p>').format(
            maths(left[0]), "too long to be read; mechanics derive prints it"
        )
    typeset = _row([*left, *_joined("=", line.right)], line.label)
    return typeset if size <= FOLDED else _folded(line, typeset)


def chain(sides: Sequence[Any], name: str = "") -> Markup:
    """The sides of a published row, joined by equality signs."""
    found = [name] if name else []
    for side in sides:
        found += _joined("=", side) if found else pieces(side)
    return _row(found, "")


def ledger_row(tag: str, sides: Sequence[Any]) -> Markup:
    """The sides of a published row; a tag ``"K, M"`` names as many sides that are no equality."""
    names = tag.split(", ")
    if len(names) == len(sides) > 1:
        return Markup("").join(
            chain((side,), latex_name(n)) for n, side in zip(names, sides, strict=True)
        )
    return chain(sides)


def tag(text: str) -> Markup:
    """A number or short label; one that is a letter, or LaTeX, is typeset."""
    if "\\" in text and "$" not in text:
        return maths(text)
    if text in GREEK or (len(text) == 1 and text.isalpha()):
        return maths(latex_name(text))
    return prose(text.replace("^2", "²"))


def prose(text: str) -> Markup:
    """A sentence; LaTeX between dollar signs and names such as x_C or theta_dot are typeset."""
    parts = re.split(r"\$([^$]+)\$", text)
    return Markup("").join(maths(part) if i % 2 else _names(part) for i, part in enumerate(parts))


def _names(text: str) -> Markup:
    parts = NAME.split(text)
    return Markup("").join(
        maths(latex_name(part)) if i % 2 else escape(part) for i, part in enumerate(parts)
    )


def inline(expr: Any) -> Markup:
    """A short expression inside a sentence or table."""
    return maths(latex(expr))


def _joined(sign: str, expr: Any) -> list[str]:
    first, *others = pieces(expr)
    return [f"{sign} {{{first}}}", *others]  # in braces a minus is a sign, no difference


def _row(parts: Sequence[str], label: str) -> Markup:
    body = Markup("<wbr>").join(broken(part, maths) or maths(part) for part in parts)
    note = Markup('<span class="label">{}</span>').format(label) if label else Markup("")
    return Markup('<div class="eq"><div class="terms">{}</div>{}</div>').format(body, note)


def _folded(line: Line, typeset: Markup) -> Markup:
    terms = len(Add.make_args(line.right)) if hasattr(line.right, "args") else 1
    head = maths(line.left) if isinstance(line.left, str) else Markup("")
    words = f"{terms} terms" if terms > 1 else "a long expression"
    title = Markup("{} = … ").format(head) if head else Markup("")
    return Markup(
        '<details class="fold"><summary>{}<span class="note">{}{}</span></summary>{}</details>'
    ).format(title, words, f", {line.label}" if line.label else "", typeset)


def maths(source: str) -> Markup:
    """LaTeX as MathML."""
    return Markup(mathml(source))

r"""A person's LaTeX as MathML that holds nothing but mathematics.

\frac{M L}{2} \ddot{x}    ->    <math>...</math>            \href{javascript:...}    ->    no link

What somebody else typed must not become a link, a style or an element of the page: elements and
attributes that are not on the lists below are refused or dropped.
"""

import re
from xml.etree import ElementTree

from latex2mathml import exceptions
from markupsafe import Markup

from mechanics.report.notation import DOTLESS, mathml

ELEMENTS = frozenset((
    "math", "mrow", "mi", "mo", "mn", "ms", "mtext", "mspace", "mstyle", "msup", "msub", "msubsup",
    "mfrac", "msqrt", "mroot", "mover", "munder", "munderover", "mtable", "mtr", "mtd", "mpadded",
    "mphantom",
))  # fmt: skip
ATTRIBUTES = frozenset((
    "displaystyle", "display", "stretchy", "fence", "form", "accent", "mathvariant", "lspace",
    "rspace", "width", "separator", "linethickness", "columnalign", "minsize", "maxsize",
    "largeop", "movablelimits",
))  # fmt: skip
CLASSES = frozenset(("wrong", "right"))
LOWERED = ("height", DOTLESS)
VALUE = re.compile(r"[\w.%+-]*")
UNREADABLE: tuple[type[Exception], ...] = (
    *(kind for kind in vars(exceptions).values() if isinstance(kind, type)),
    IndexError, KeyError, ValueError, StopIteration, RecursionError, ElementTree.ParseError,
)  # fmt: skip
"""What the converter raises for what it does not know; the source is shown instead."""


def safe_mathml(latex: str) -> Markup | None:
    """MathML of LaTeX; None where it cannot be typeset, or holds more than mathematics."""
    try:
        root = ElementTree.fromstring(mathml(latex))
    except UNREADABLE:
        return None
    if not all(_allowed(element) for element in root.iter()):
        return None
    return Markup(ElementTree.tostring(root, encoding="unicode"))


def _allowed(element: ElementTree.Element) -> bool:
    """Whether an element may stand on the page, without the attributes that may not."""
    for name, value in list(element.attrib.items()):
        known = (name in ATTRIBUTES and VALUE.fullmatch(value)) or (name, value) == LOWERED
        if not known and not (name == "class" and value in CLASSES):
            del element.attrib[name]
    return element.tag in ELEMENTS and "\\" not in (element.text or "")

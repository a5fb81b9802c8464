r"""Formulas of a notebook that nobody hands in as such: in comments of its code, and what it shows.

# theta'' = g/l*sin(theta)     printed: T = m*l^2*theta'^2/2     displayed: $\ddot\theta = ...$

They are judged, too, each by itself; an expression without an equals sign is quoted. What gives a
name a number, a part of a vector or words claims nothing.
"""

import re
from collections.abc import Iterable, Iterator, Mapping
from html import unescape
from typing import Any

from mechanics.claims.code.comments import EQUATION, LANGUAGES, SENTENCE, comments
from mechanics.grading.cells import Cell
from mechanics.judge.sources import Aside

KINDS = ("text/latex", "text/markdown", "text/html", "text/plain")
"""What an output is shown as, the first that is there."""
TAG = re.compile(r"<[^<>]*>")
CLOSED = re.compile(r"\$\\displaystyle|^\$+|\$+$", re.MULTILINE)
EQ = re.compile(r"\bEq\((?P<sides>.*)\)\s*$")
BARE = re.compile(
    r"[-+]?[\d.]+(?:[eE][-+]?\d+)?(?:\s*[A-Za-z/%]{1,12}(?:\^?-?\d)?)?[.,;]?"  # 1.5 m/s
    r"|(?:\w+(?:\.\w+)*)?[\[(][-+\d.,;:\s\w\[\]()]*[\])]"  # y[0], [x, 1.0], array([1, 2])
    r"|['\"<{].*|(?:True|False|None|true|false)\b.*|[^\W\d_]{3,}(?:[ ,]+[^\W\d_]{2,})*\.?"
)
EXPRESSION = re.compile(
    r"(?=.*(?:[*/^+]|\\frac|Derivative\())(?!.*(?<!\\)[^\W\d_]{2,}[ ]+[^\W\d_]{2,})"
    r"[\w\s()+\-*/^.,\[\]{}\\&']+", re.DOTALL
)  # fmt: skip
"""An operation, and no words side by side."""
SCALED = re.compile(r"\d\s*[A-Za-z]\b(?!\s*$)|\d[A-Za-z]$")


def outputs_of(cell: Mapping[str, Any]) -> tuple[str, ...]:
    """What a cell of code shows, as text."""
    return tuple(text for one in cell.get("outputs") or () if (text := _shown(one)).strip())


def _shown(output: Mapping[str, Any]) -> str:
    if output.get("output_type") == "stream":
        return "".join(output.get("text", ""))
    data = output.get("data") or {}
    kind = next((kind for kind in KINDS if kind in data), "")
    text = "".join(data.get(kind, ""))
    return unescape(TAG.sub(" ", text)) if kind == "text/html" else text


def asides_of(cells: Iterable[Cell]) -> Iterator[Aside]:
    """Formulas in comments of code, and in what it shows."""
    found: dict[str, str] = {}
    for cell in cells:
        bare = LANGUAGES[".py"].sub(lambda m: m[0] if m["string"] is None else "''", cell.text)
        said = (line for words in comments(bare, ".py") for line in words.splitlines())
        for line in said:
            if EQUATION.search(line) and not SENTENCE.search(line):
                found.setdefault(line.strip(), f"a comment of {cell.name}")
        for text in cell.shown:
            for line in _lines(text):
                found.setdefault(line.strip(), f"the output of {cell.name}")
    yield from (Aside(text, where) for text, where in found.items()
                if _claims(text) or ("=" not in text and EXPRESSION.fullmatch(text)))  # fmt: skip


def _lines(text: str) -> Iterator[str]:
    """Formulas of an output: LaTeX as a whole, other texts line by line."""
    if "\\" in text:
        yield CLOSED.sub("", text)
        return
    for line in text.splitlines():
        if (same := EQ.search(line)) is not None:
            yield " = ".join(_sides(same["sides"]))
        else:
            yield line


def _sides(inside: str) -> list[str]:
    """Both sides of ``Eq(a, b)``."""
    depth = 0
    for k, character in enumerate(inside):
        depth += (character in "([{") - (character in ")]}")
        if character == "," and depth == 0:
            return [inside[:k], inside[k + 1 :].strip()]
    return [inside]


def _claims(text: str) -> bool:
    """Whether a text is an equation that gives a formula."""
    _, equals, value = text.partition("=")
    value = value.strip(" =")
    return bool(equals and value and not (BARE.fullmatch(value) and not SCALED.search(value)))

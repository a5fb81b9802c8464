r"""Which sentences of a text stand beside a statement, and which elsewhere on its page.

Elsewhere. For any angle: \[ \ddot\theta = ... \] This is exact. So much for that. Elsewhere.

Beside it are its own sentence, the two on either side and what its display holds; in a text that is
no LaTeX, its paragraph. So are those beside a definition that it uses. What cannot be placed is
beside it.
"""

import re
from collections import Counter
from collections.abc import Collection
from dataclasses import dataclass
from functools import lru_cache

from mechanics.claims.claim import Written
from mechanics.claims.latex.blocks import blocks, continued
from mechanics.claims.latex.prepare import prepared
from mechanics.claims.place import Refused
from mechanics.claims.tree import Node, names
from mechanics.judge.modelica import is_model
from mechanics.judge.sentences import sentences

OPENS = re.compile(r"(?:\$+|\\[\[(]|\\begin\s*\{[^{}]*\}(?:\{[^{}]*\})?)\s*\Z")
CLOSES = re.compile(r"\s*(?:\$+|\\[\])]|\\end\s*\{[^{}]*\})")
PARAGRAPH = re.compile(r"\n[ \t]*\n")
ANY = r"\[x=y\]"
BESIDE = 2
"""Sentences on either side; a part of a sentence counts as one."""


@dataclass(frozen=True)
class Context:
    """Sentences of a text as one statement sees them, by their words.

    Attributes
    ----------
    page : set of str
        All of its text.
    near : set of str
        Those beside it.
    own : set of str
        Words of its formulas, as labels are.
    """

    page: frozenset[str] = frozenset()
    near: frozenset[str] = frozenset()
    own: frozenset[str] = frozenset()


def context_of(written: Written | None, known: Collection[str]) -> Context:
    """The sentences of a statement's text; none where they cannot be placed, as those of code.

    Parameters
    ----------
    written : Written or None
    known : collection of str
        Names of the person, and the scene's.
    """
    if written is None or written.notation not in ("latex", "text") or is_model(written.text):
        return Context()
    text, notation, names = written.text, written.notation, frozenset(known)
    pairs = [_beside(text, notation, at, names) for at in sorted(_places(written))]
    near, own = (frozenset().union(*some) for some in zip(*pairs, strict=True))
    return Context(frozenset(_words(text, notation, names)), near, own)


@lru_cache(maxsize=8)
def _words(text: str, notation: str, known: frozenset[str]) -> tuple[str, ...]:
    """Sentences of a text, by their words: that of a page is asked for by each of its formulas."""
    return tuple(sentence.words for sentence in sentences(text, notation, known))


def _places(written: Written) -> set[int]:
    """Where a statement stands, and the definitions that it uses."""
    own, found, left = dict(written.definitions), {written.start}, [*written.sides]
    while left:
        for name in {n.name for n in names(left.pop())} & own.keys():
            tree = own.pop(name)
            found.add(_place(tree))
            left.append(tree)
    return found


def _place(tree: Node) -> int:
    """Where a tree stands; -1 for one that was composed."""
    return max((tree.at, *(name.at for name in names(tree))))


@lru_cache(maxsize=512)
def _beside(
    text: str, notation: str, at: int, known: frozenset[str]
) -> tuple[frozenset[str], frozenset[str]]:
    """Sentences beside a place, and those in its formula, by their words."""
    whole = Counter(_words(text, notation, known))
    span = _display(text, at) if notation == "latex" else _paragraph(text, at)
    if at < 0 or span is None:
        return frozenset(whole), frozenset(whole)
    start, end = span
    formula, before, after = text[start:end], text[:start], text[end:]
    if notation == "latex":
        while opens := OPENS.search(before):
            before = before[: opens.start()]
        while closes := CLOSES.match(after):
            after = after[closes.end() :]
        own = frozenset(_words(f"\\[{formula}\\]", notation, known))
        # A text that marks no formula would be one.
        before, after = f"{before}\n\n{ANY}", f"{ANY}\n\n{after}"
    else:
        line = text[text.rfind("\n", 0, at) + 1 :].partition("\n")[0]
        own = frozenset(_words(line, notation, known))
    skipped = BESIDE + 1 if notation == "latex" else 0
    far = Counter(_words(before, notation, known)[: -skipped or None])
    far += Counter(_words(after, notation, known)[skipped:])
    return frozenset(words for words, count in whole.items() if count > far[words]), own


def _display(text: str, at: int) -> tuple[int, int] | None:
    """From where to where the formula around a place goes."""
    try:
        clean = prepared(text)
        _, every = continued(clean, blocks(clean))
    except Refused:
        return None
    found = (b for b in every if b.start <= at < b.end and b.closed and not b.bare)
    return next(((b.start, b.end) for b in found), None)


def _paragraph(text: str, at: int) -> tuple[int, int]:
    ends = [m.start() for m in PARAGRAPH.finditer(text)]
    start = max((end for end in ends if end <= at), default=0)
    return start, min((end for end in ends if end > at), default=len(text))

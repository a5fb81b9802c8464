"""Sentences of ours that hold a person's formulas, cut where the formulas begin and end.

"the equations would differ by (0, 2*g*sin(theta))"    ->    words, 0, words, 2*g*sin(theta), words
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace

from mechanics.claims.brackets import pieces
from mechanics.report.answer.formulas import Hand

ROWS = re.compile(r"(.*\bwould differ by \()([^;]*)(\).*)", re.DOTALL)
DEFINED = re.compile(r"(.* is taken as defined by: )(.*)", re.DOTALL)
ALIGNED = re.compile(r"\s*(?<!\\)&\s*(?==)|(?<==)\s*&")


@dataclass(frozen=True)
class Part:
    """Words, or a formula in some hand."""

    text: str
    hand: Hand | None = None


def parted(words: str, hand: Hand) -> tuple[Part, ...]:
    """A sentence as words and formulas.

    Parameters
    ----------
    words : str
    hand : Hand
        The person's, in whose notation definitions are.
    """
    if rows := ROWS.fullmatch(words):
        before, inside, after = rows.groups()
        typed = replace(hand, notation="text")
        found = [Part(before)]
        for n, entry in enumerate(_entries(inside)):
            found += [*([Part(", ")] if n else []), Part(entry, typed)]
        return (*found, Part(after))
    if defined := DEFINED.fullmatch(words):
        return Part(defined[1]), Part(ALIGNED.sub(" ", defined[2]), hand)
    return (Part(words),)


def spoken(words: str, hand: Hand) -> str:
    """A sentence with its formulas in the person's notation, for a terminal."""
    texts = []
    for part in parted(words, hand):
        other = part.hand is not None and part.hand.notation != hand.notation == "latex"
        latex = part.hand.latex(part.text) if other and part.hand is not None else None
        texts.append(latex or part.text)
    return "".join(texts)


def _entries(inside: str) -> Iterator[str]:
    """The entries of a tuple, cut at commas outside of brackets."""
    return (part.strip() for _, part in pieces(inside, ","))

"""One meaning a letter in all texts and objects that are handed in together (rule 4 of readings).

["a*x'' = ...", "... a*g ..."]            a is mc in one and mp in the other: UNDECIDED
["phi'' = ...", "... psi'' ..."]          both are guessed to be theta: UNDECIDED

Each text alone leaves one choice for its names; together they are one person's. Functions have
names of their own.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from mechanics.claims.names import Match
from mechanics.claims.statement import Reading
from mechanics.judge.sources import PAGES

SAID = ("same name", "as given", "a rate of a name like it")
"""Why a name means what it does, where that is no guess."""
TEXTS = (*PAGES, ".txt")


def of_one_document(things: Sequence[Any], readings: Sequence[Reading]) -> list[Reading]:
    """The readings; statements have a doubt where names mean different things in two of them.

    Parameters
    ----------
    things : sequence
        What was read.
    readings : sequence of Reading
        Of each thing.
    """
    found = list(readings)
    texts = [k for k, thing in enumerate(things) if _is_text(thing)]
    for place, k in enumerate(texts):
        for other in texts[:place]:
            if words := next(_against(readings[other].names, readings[k].names), ""):
                for one in (other, k):
                    found[one] = _in_doubt(found[one], words)
    return found


def _is_text(thing: Any) -> bool:
    if isinstance(thing, Path):
        return thing.suffix in TEXTS
    return isinstance(thing, str | bytes | tuple) or not callable(thing)


def _against(one: Sequence[Match], other: Sequence[Match]) -> Iterator[str]:
    """How names of two texts exclude each other, in words."""
    for a in one:
        for b in other:
            guessed = a.why not in SAID or b.why not in SAID
            if a.name == b.name and a.meaning != b.meaning:
                yield (
                    f"{a.name} is read as {a.meaning} in one and as {b.meaning} in another of the"
                    " texts: say which"
                )
            elif a.name != b.name and a.meaning == b.meaning and guessed:
                yield (
                    f"{a.name} of one text and {b.name} of another are both read as {a.meaning}:"
                    " write one name, or say what they mean"
                )


def _in_doubt(reading: Reading, words: str) -> Reading:
    statements = (replace(s, doubt=s.doubt or words) for s in reading.statements)
    return replace(reading, statements=tuple(statements))

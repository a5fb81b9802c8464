"""Whether arguments of a call of a judged function are what it takes.

rate(t, y, m, l)    rate(t, y, l, m)    rate(t, -y, m, y[1])    the others are not
"""

from collections.abc import Collection, Sequence
from fractions import Fraction
from functools import partial
from typing import Any

from mechanics.claims.code.around.intermediate_form import Term
from mechanics.claims.code.around.interpreter_values import (
    MOVING,
    OUTSIDE,
    ROUNDED,
    UNKNOWN,
    Handle,
    JudgedFunction,
    Literal,
    Table,
    Unknown,
    number,
)
from mechanics.claims.code.around.run import (
    FAR,
    Run,
    meaning_of,
    orders,
)


def is_another(run: Run, call: Term, moving: Collection[str]) -> bool:
    """Whether a call of the judged function has something else for a parameter.

    Parameters
    ----------
    moving : collection of str
        Names that change around the call, beside those that the call has for the state.
    """
    still = run.words.parameters.keys() | run.words.inputs
    judged = run.judged[call.name]
    pairs = [*zip(judged.takes, call.parts, strict=False)]
    fixed = [(name, part) for name, part in pairs
             if {*judged.meanings.get(name, ())} & still]  # fmt: skip
    others = {_place_of(run, pair[1]) for pair in pairs if pair not in fixed}
    others = (others | {*moving}) - {""}
    return any(_place_of(run, p) in others and _place_of(run, p) != n for n, p in fixed)


def _place_of(run: Run, part: Term) -> str:
    """Where a value stands; the whole array for one of its entries."""
    if part.kind == "entry" or (part.kind == "call" and run.language.name != "Python"):
        base = part.parts[0] if part.kind == "entry" else part
        return base.name if base.kind in ("name", "call") else base.text
    return part.text or part.name if part.kind in ("name", "field") else ""


def speed_of(run: Run, word: str) -> str:
    """The word of the speed that belongs to a coordinate."""
    q, u = run.words.coordinates, run.words.speeds
    return u[q.index(word)] if len(q) == len(u) else word


def in_usual_order(run: Run, entries: Sequence[tuple[int, tuple[str, list[Any]]]]) -> bool:
    """Whether entries of one array that are passed stand in one of the usual orders."""
    keys = [[k for k in key if isinstance(k, Fraction)] for _, (_, key) in entries]
    if any(len(key) != 1 for key in keys):
        return True
    places = {
        word: int(key[0]) - run.language.first
        for (_, (word, _)), key in zip(entries, keys, strict=True)
    }
    if all(word in run.words.state for word in places):
        return any(
            all(0 <= k < len(order) and order[k] == word for word, k in places.items())
            for order in orders(run)
        )
    numbers = [*places.values()]
    return numbers == sorted(numbers)


def accepted(run: Run, judged: JudgedFunction, name: str, part: Term, value: Any) -> bool:
    """Whether an argument is what the function takes at its place."""
    words = judged.meanings.get(name, ())
    if value is ROUNDED:
        return False
    if part.kind == "turn":  # accel(th % (2*pi), w)
        angle = len(words) == 1 and words[0] in run.words.angles
        return angle and accepted(run, judged, name, part.parts[0], value)
    if not words and name in judged.defaults:
        return bool(value == judged.defaults[name])
    own = part.name.rpartition(".")[2] if part.kind in ("name", "field") else ""
    if own != name and own in judged.takes and own:
        return False
    if isinstance(value, Table) and any(isinstance(k[0], str) for k in value.entries):
        return _fits_fields(run, words, value, by_place=name in judged.places)
    if not words:
        meaning = meaning_of(run, own) if own else ""
        same = own == name or meaning in ("", meaning_of(run, name))
        return same and not isinstance(value, Handle)
    if len(words) == 1 and words[0] in run.words.inputs and part.kind == "item":
        return fits_word(run, words[0], value) or _is_made(run, words[0], part.kind, value)
    if len(words) == 1 and words[0] in run.words.inputs and part.parts:
        if words[0] not in {meaning_of(run, one) for one in part.names()}:
            return True  # -K*y, what a controller makes
        if part.kind in ("minus", "binary"):
            return False
    made = part.kind in ("call", "binary", "minus", "other", "list")
    unknown = isinstance(value, Unknown) and value is not OUTSIDE
    if unknown and made and any(p.names() for p in part.parts):
        return False
    if len(words) > 1:
        return isinstance(value, Unknown) or _fits_words(run, words, part, value)
    return _fits_one(run, words[0], part, value, own)


def _fits_fields(run: Run, words: Sequence[str], value: Table, *, by_place: bool) -> bool:
    """Whether a record has under its names what they mean, in order where places count."""
    pairs = [(meaning_of(run, str(k[0])), v) for k, v in value.entries.items()]
    if by_place and any(m and m != w for (m, _), w in zip(pairs, words, strict=False)):
        return False
    return all(fits_word(run, m, v) for m, v in pairs if m and m not in run.words.state)


def _fits_words(run: Run, words: Sequence[str], part: Term, value: Any) -> bool:
    """Whether an array is the state, or has what several words stand for."""
    if not isinstance(value, Table):
        return False
    if {*words} & {*run.words.state}:
        named = part.parts if part.kind == "list" and len(part.parts) == len(words) else ()
        pairs = [*zip(words, named, strict=False)]
        if any(p.kind == "turn" and w not in run.words.angles for w, p in pairs):
            return False
        return value.name != "parameters" and all(
            meaning_of(run, one.name) in ("", word)
            for word, one in pairs if one.kind in ("name", "field")
        )  # fmt: skip
    if not value.entries:
        return True
    dense = [value.entries.get((k + run.language.first,), UNKNOWN) for k in range(len(words))]
    return (value.size or len(words)) == len(words) and all(
        fits_word(run, w, v) for w, v in zip(words, dense, strict=True)
    )


def _fits_one(run: Run, word: str, part: Term, value: Any, own: str) -> bool:
    """Whether a value is what one word stands for; `own` is the name that it is given by."""
    meaning = meaning_of(run, own) if own else ""
    if meaning and meaning != word:
        return False
    if word in run.words.state:
        made = part.kind in ("minus", "binary") and not run.memory.stepping
        if made and word in map(partial(meaning_of, run), part.names()):
            return False  # accel(-th, w)
        return isinstance(value, Unknown) or (
            isinstance(value, Fraction)
            and (run.memory.stepping or isinstance(value, Literal)
                 or part.kind in ("entry", "item", "field", "call", "name"))
        )  # fmt: skip
    if word in run.words.inputs and (meaning == word or _is_made(run, word, own, value)):
        return True
    begun = isinstance(value, Fraction) and value in run.memory.initial and not meaning
    given = part.kind in ("entry", "item", "name", "field")
    return fits_word(run, word, value) or (begun and given)


def _is_made(run: Run, word: str, name: str, value: Any) -> bool:
    """Whether a name without a meaning has what a controller makes."""
    if not name or meaning_of(run, name) or not isinstance(value, Fraction):
        return False
    share = value / number("word", word)
    return max(abs(share.numerator), share.denominator) > FAR


def fits_word(run: Run, word: str, value: Any) -> bool:
    """Whether a value is what a word of the scene stands for."""
    if isinstance(value, Literal):
        return is_possible(run, word, value)
    if isinstance(value, Unknown):
        return value is not MOVING or word in run.words.inputs
    return isinstance(value, Fraction) and value == number("word", word)


def is_possible(run: Run, word: str, value: Fraction) -> bool:
    """Whether a number is one that the scene allows a parameter."""
    symbols = run.words.parameters
    if word not in symbols:
        return value >= 0 or word in (*run.words.inputs, *run.words.state)
    return not (
        (value <= 0 and symbols[word].is_positive) or (value < 0 and symbols[word].is_nonnegative)
    )

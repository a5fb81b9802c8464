"""Numbers of an array or a record that a solver of C hands to the judged function as parameters.

double m = p[0], g = p[1];            what each entry is, the function says
sys = {rate, NULL, 2, mu};            mu is handed
mu[1] = -9.81;                        a number that g cannot be
"""

from collections.abc import Iterator

from mechanics.claims.code.around.intermediate_form import Term
from mechanics.claims.code.around.interpreter import known_value
from mechanics.claims.code.around.interpreter_values import Literal, targets_of
from mechanics.claims.code.around.judged_arguments import is_possible
from mechanics.claims.code.around.names_around import Around, base_of, head_of
from mechanics.claims.code.around.run import Run, meaning_of

MAKES_OTHERS = frozenset(
    ("memset", "bzero", "swap", "fill", "fill_n", "transform", "reverse", "rotate", "sort")
)
"""Calls that change what they are given, and read nothing from outside."""


def other_parameters(around: Around) -> Iterator[str]:
    """Lines of a block that give a parameter, by an array, a number that it cannot be.

    Parameters
    ----------
    around : Around
    """
    words = _words(around.run)
    handed = around.handed | around.others_of(around.handed)
    if not words or not handed:
        return
    for one in around.body.all():
        if one.kind == "set" and any(
            _is_other(around.run, words, handed, one, target) for target in targets_of(one.parts[0])
        ):
            yield one.text
        given = {base_of(part) for part in one.parts}
        if one.kind == "call" and one.name in MAKES_OTHERS and handed & given:
            yield one.text


def _words(run: Run) -> dict[str, str]:
    """What entries of an argument are, that the judged function takes apart by their places."""
    found: dict[str, str] = {}
    for judged in run.judged.values():
        body = run.own[judged.name].body if judged.name in run.own else Term("block")
        lines = [one for one in body.all() if one.kind == "set" and not one.name]
        names = {*judged.takes} - judged.meanings.keys() - {*judged.fills}
        names |= {base_of(one.parts[0]) for one in lines
                  if one.parts[1].kind == "name" and one.parts[1].name in names}  # fmt: skip
        for target, value in (one.parts for one in lines):
            word = meaning_of(run, base_of(target))
            if value.kind == "entry" and base_of(value) in names and word in run.words.parameters:
                found[value.parts[1].name] = word
    return found


def _is_other(
    run: Run, words: dict[str, str], handed: frozenset[str], line: Term, target: Term
) -> bool:  # fmt: skip
    value = line.parts[1]
    if target.kind == "other":
        return bool(handed & {*map(head_of, target.names())})
    if base_of(target) not in handed:
        return False
    if target.kind == "name":
        places = [str(k) for k in range(len(value.parts))]
        pairs = [*zip(places, value.parts, strict=True)] if value.kind == "list" else []
        rest = words.keys() - {*places} if pairs else set()
        zero = any(not is_possible(run, words[k], Literal(0)) for k in rest)
        return zero or any(_is_excluded(run, words.get(k, ""), part) for k, part in pairs)
    if line.name or handed & {*map(head_of, value.names())}:
        return True
    place = target.parts[1] if target.kind == "entry" else Term("other")
    some = [words.get(place.name, "")] if place.kind == "number" else [*words.values()]
    return any(_is_excluded(run, word, value) for word in some)


def _is_excluded(run: Run, word: str, value: Term) -> bool:
    """Whether a value is a number that a parameter cannot be, or another parameter."""
    made = known_value(run, value, {})
    if isinstance(made, Literal):
        return bool(word) and not is_possible(run, word, made)
    other = meaning_of(run, value.name) if value.kind == "name" else ""
    return bool(word) and other in run.words.parameters and other != word

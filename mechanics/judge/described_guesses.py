"""Names that are guessed, though something else in the file says what they are.

a = Symbol("a")  # twice the length: a = 2*L        a is not the length L, the only one that is left
definitions = {a: 2*L}        L, a = 1, 2           nor here

All of a file counts but its statements: comments, documentation, strings, and what any line gives a
name. What confirms the guess, a number or the scene's own name, says nothing.
"""

import re
from collections.abc import Iterator, Mapping, Sequence

from mechanics.claims.code.given_values import Given, given_values, is_formula
from mechanics.claims.guess import REASONS
from mechanics.claims.names import Match, Vocabulary
from mechanics.claims.spelled_rates import key
from mechanics.claims.unread_names import assigned_names, described_names
from mechanics.judge.modelica import model_words
from mechanics.judge.sources import Source
from mechanics.scene import Scene

SHOWN = re.compile(r"\{\w+(?:[:!][^{}]*)?\}|%[-+ #\d.]*[a-z]\b")
"""Where a string shows a number."""


def described_guesses(
    scene: Scene, known: Sequence[Match], sources: Sequence[Source]
) -> Iterator[str]:
    """What is to be said of guesses that the rest of a file may contradict.

    Parameters
    ----------
    known : sequence of Match
        What names were taken for.
    sources : sequence of Source
        The code, and words beside it.
    """
    guesses = {key(match.name): match for match in known if match.why in REASONS}
    if not guesses:
        return
    for line in (line for one in sources for words in _words(one) for line in words.splitlines()):
        said = SHOWN.sub("0", line)
        for name in guesses.keys() & {*assigned_names(said), *(described_names(said) or ())}:
            yield _told(guesses[name], line)
    taken = {match.name for match in known}
    every: dict[str, list[Given]] = {}
    for source in sources:
        for given in given_values(source.code(), source.suffix):
            every.setdefault(given.name, []).append(given)
    for match in guesses.values():
        for given in _against(scene, match, taken, every):
            yield _told(match, given.words)


def _words(source: Source) -> Iterator[str]:
    return model_words(source.text) if source.suffix == ".mo" else iter(source.words())


def _told(match: Match, words: str) -> str:
    return (
        f"{match.name} is read as {match.meaning}, and {' '.join(words.split())[:60]!r} says"
        f" what it is: --name {match.name}=... says so"
    )


def _against(
    scene: Scene, match: Match, taken: set[str], every: Mapping[str, list[Given]]
) -> Iterator[Given]:
    """What gives a guessed name a formula, or another name that is called as what is guessed."""
    vocabulary = Vocabulary(scene)
    alike = {n for n in every if key(n).lower() == key(match.meaning).lower()} - {match.name}
    own = frozenset((match.name, match.meaning, *alike))
    mine = [one for name in every if key(name) == key(match.name) for one in every[name]]
    yield from (one for one in mine if is_formula(one, own, every))
    if any(one.value in own - {match.name} for one in mine):
        return
    for name in sorted(alike - taken):
        if name == match.meaning or vocabulary.target(name) is None:
            yield from (one for one in every[name] if one.alone and one.declares)

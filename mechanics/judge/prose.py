r"""What the sentences around statements say: how names count, what is otherwise, what is left.

This is not true: $$ a = b $$                            what is shown of it is UNDECIDED
where $\theta$ is measured from the downward vertical     a declared convention
The springs are made of steel.                           quoted beside the verdict
"""

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice
from typing import TypeVar

from mechanics.claims.declared_conventions import Declared
from mechanics.claims.names import Match
from mechanics.claims.statement import Statement
from mechanics.judge.comparison import Comparison, compared, senses
from mechanics.judge.declared_otherwise import declared_in_code, declared_otherwise
from mechanics.judge.markup import unread_markup
from mechanics.judge.modelica import OTHER_UNIT, is_model, model_words
from mechanics.judge.quotations import QUOTED, foreign_quotation
from mechanics.judge.scene_facts import SceneFacts
from mechanics.judge.sentence_class import SentenceClass, class_of
from mechanics.judge.sentence_context import context_of
from mechanics.judge.sentences import Sentence, marked, sentences
from mechanics.judge.sources import Source
from mechanics.kernel import Verdict, undecided
from mechanics.report.answer.judged import Judged
from mechanics.scene import Scene

TURNING = re.compile(r"\b(?:(?:counter|anti)-?)?clockwise\b|\bto the (?:left|right)\b", re.I)
"""Words that say which way something counts."""
LIMITING = {
    SentenceClass.LIMITS: "denies or limits it",
    SentenceClass.COUNTS: "is compared with nothing",
}
Thing = TypeVar("Thing")


@dataclass(frozen=True)
class Limit:
    """What denies or limits statements, or may hide them.

    Attributes
    ----------
    words : str
        What it is, in words.
    sentence : str
        The sentence; empty for markup, which counts for a whole text.
    """

    words: str
    sentence: str = ""


@dataclass(frozen=True)
class Prose:
    """What texts say beside their statements.

    Attributes
    ----------
    conventions : tuple of Declared
        How a text says that it counts, where the scene counts otherwise.
    against : tuple of str
        What it says that the scene has otherwise, in words.
    limits : tuple of Limit
        What denies or limits statements, or may hide them.
    unjudged : tuple of str
        Its other sentences.
    names : frozenset of str
        Of the person, and the scene's.
    unsettled : tuple of str
        What makes statements others than those that are read, in words.
    """

    conventions: tuple[Declared, ...]
    against: tuple[str, ...]
    limits: tuple[Limit, ...]
    unjudged: tuple[str, ...]
    names: frozenset[str] = frozenset()
    unsettled: tuple[str, ...] = ()


def prose_of(
    scene: Scene,
    statements: Sequence[Statement],
    known: Sequence[Match],
    code: Sequence[Source] = (),
) -> Prose:
    """What the texts of statements say of a scene.

    Parameters
    ----------
    known : sequence of Match
        What names of the person were taken for.
    code : sequence of Source
        Of functions, of which comments and documentation are prose.
    """
    facts = SceneFacts(scene, known)
    names = {*(match.name for match in known), *facts.names}
    written = {s.written.text: s.written.notation for s in statements if s.written is not None}
    models = [text for text in written if is_model(text)]
    texts = [one for one in sorted(written.items()) if one[0] not in models]
    texts += [(one, "comment") for text in models for one in model_words(text)]
    texts += [(words, "comment") for source in code for words in source.words()]
    every = dict.fromkeys(one for text, how in texts for one in sentences(text, how, names))
    beside = {one: compared(facts, one.marked) for one in every if not one.unread}
    classes = {one: class_of(facts, one, found) for one, found in beside.items()}
    limits = _limits(facts, classes)
    quoted = (SentenceClass.COUNTS, SentenceClass.QUOTED)
    unjudged = [
        one.words for one in every
        if one.unread or (classes[one][0] in quoted and one not in limits)
    ]  # fmt: skip
    labels = [words for text in written for words in declared_otherwise(facts, text)]
    hidden = [words for text, how in written.items() if how == "latex" for words in _hidden(text)]
    against = [words for one, found in beside.items() for words in _against(one, found)]
    against += [words for words in labels if not words.endswith(OTHER_UNIT)]
    for source in code:
        against += declared_in_code(facts, source.code(), statements)
    unsettled = [words for found in beside.values() for words in found.unsettled]
    return Prose(
        _once(c for one, found in beside.items() if not one.comment for c in found.conventions),
        _once(against),
        _once((
            *limits.values(),
            *(Limit(f"{one} is not read: it may hide what it holds") for one in hidden),
            # A label of a name, which no formula holds.
            *(Limit(words, words) for words in labels if words.endswith(OTHER_UNIT)),
        )),
        _once(unjudged),
        frozenset(names),
        _once((*unsettled, *_one_of_two_signs(facts, beside))),
    )  # fmt: skip


def _once(some: Iterable[Thing]) -> tuple[Thing, ...]:
    return tuple(dict.fromkeys(some))


def _against(sentence: Sentence, found: Comparison) -> Iterator[str]:
    """What a sentence says against the scene; a comment declares no convention."""
    yield from found.against
    if sentence.comment:
        for one in found.conventions:
            yield f"a comment says that it counts otherwise: {one.told}"


def _limits(
    facts: SceneFacts, classes: Mapping[Sentence, tuple[SentenceClass, tuple[str, ...]]]
) -> dict[Sentence, Limit]:
    """Sentences that deny or limit, and those on how something counts that nothing compares.

    Where one parameter of a unit alone is said to be something, no other is taken for it.
    """
    said = {one: why for one, (kind, why) in classes.items() if kind is SentenceClass.COUNTS}
    own = {
        one: {facts.own_name(name) for name in why} & facts.parameters.keys()
        for one, why in said.items()
    }
    units = Counter(facts.unit(name) for name in frozenset[str]().union(*own.values()))
    limits: dict[Sentence, Limit] = {}
    for sentence, (kind, why) in classes.items():
        alone = [units[facts.unit(name)] == 1 for name in own.get(sentence, ())]
        if kind in LIMITING and not (alone and all(alone)):
            how = f"which {LIMITING[kind]} ({', '.join(why)})"
            limits[sentence] = Limit(
                f"the text says '{sentence.words[:120]}', {how}", sentence.words
            )
    return limits


def _one_of_two_signs(facts: SceneFacts, beside: Mapping[Sentence, Comparison]) -> Iterator[str]:
    """A sense that is not read beside one that is: one alone turns what both leave right."""
    if any(senses(facts, one.marked) for one in beside):
        every = (word[0] for found in beside.values() for word in TURNING.finditer(found.rest))
        yield from (f"the text says '{word}' of more than is read" for word in islice(every, 1))


def _hidden(text: str) -> Iterator[str]:
    """Markup of LaTeX that may hide words, in words."""
    yield from unread_markup(marked(text))
    # What a formula continues with on a new line is no quotation.
    if QUOTED.search(marked(text)) and foreign_quotation(text):
        yield "a quotation"


def seen_from_one_side(
    scene: Scene, entry: Judged, statement: Statement, known: Sequence[Match]
) -> Judged:
    """A refuted entry, open where it is right with all that left and right say turned round."""
    written = statement.written
    if written is None or entry.finding.verdict is not Verdict.REFUTED or not entry.right_if:
        return entry
    facts = SceneFacts(scene, known)
    texts = sentences(written.text, written.notation, [match.name for match in known])
    told = any(senses(facts, text.marked) for text in texts)
    return replace(entry, open=True) if told else entry


def limits_on(
    prose: Prose, statement: Statement, *, alone: bool = False, formulas: bool = False
) -> tuple[str, ...]:
    """What denies or limits a statement, in words.

    Parameters
    ----------
    alone : bool
        Whether only what stands beside it does.
    formulas : bool
        Whether only what its own formulas hold does, as their labels.
    """
    limits = prose.limits
    if limits and (alone or formulas):
        context = context_of(statement.written, prose.names)
        here = context.own if formulas else context.near
        page = None if formulas else context.page
        limits = tuple(
            limit for limit in limits
            if not limit.sentence or limit.sentence in here
            or (page is not None and limit.sentence not in page)
        )  # fmt: skip
    return tuple(limit.words for limit in limits)


def as_told(
    entry: Judged, contradictions: Sequence[str], unsettled: Sequence[str] = ()
) -> Judged:  # fmt: skip
    """The entry; what is shown is not where the text says otherwise, or denies or limits it.

    Parameters
    ----------
    contradictions : sequence of str
        What the text says against it, in words.
    unsettled : sequence of str
        What makes it another statement than the one that was read: nor is it refuted then.
    """
    shown, refuted = entry.finding.shown, entry.finding.verdict is Verdict.REFUTED
    reasons = [*unsettled, *(contradictions if shown else ())]
    if not reasons or not (shown or refuted):
        return entry
    how = "right as the scene has it" if shown else "wrong as it is read here"
    words = f"it is {how}, but {'; '.join(reasons)}"
    return replace(entry, finding=undecided(entry.finding.subject, words))

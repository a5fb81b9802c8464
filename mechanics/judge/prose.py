r"""What the sentences around statements say: how names count, what is otherwise, what is left.

This is not true: $$ a = b $$                            what is shown of it is UNDECIDED
where $\theta$ is measured from the downward vertical     a declared convention
The springs are made of steel.                           quoted beside the verdict
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from mechanics.claims.declared_conventions import Declared
from mechanics.claims.names import Match
from mechanics.claims.statement import Statement
from mechanics.judge.comparison import compared, senses
from mechanics.judge.declared_otherwise import declared_in_code, declared_otherwise
from mechanics.judge.markup import unread_markup
from mechanics.judge.modelica import OTHER_UNIT, is_model, model_words
from mechanics.judge.quotations import QUOTED, foreign_quotation
from mechanics.judge.scene_facts import SceneFacts
from mechanics.judge.sentence_class import SentenceClass, class_of
from mechanics.judge.sentence_context import context_of
from mechanics.judge.sentences import marked, sentences
from mechanics.judge.sources import Source
from mechanics.kernel import Verdict, undecided
from mechanics.report.answer.judged import Judged
from mechanics.scene import Scene

TURNING = re.compile(r"\b(?:(?:counter|anti)-?)?clockwise\b|\bto the (?:left|right)\b", re.I)
"""Words that say which way something counts."""


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
    conventions: dict[Declared, None] = {}
    against: dict[str, None] = {}
    limits: dict[Limit, None] = {}
    unjudged: dict[str, None] = {}
    unsettled: dict[str, None] = {}
    about: dict[Limit, str] = {}
    turned, unread = False, ""
    for sentence in every:
        if sentence.unread:
            unjudged[sentence.words] = None
            continue
        found = compared(facts, sentence.marked)
        against |= dict.fromkeys(found.against)
        unsettled |= dict.fromkeys(found.unsettled)
        turned |= senses(facts, sentence.marked)
        unread = unread or next((word[0] for word in TURNING.finditer(found.rest)), "")
        if sentence.comment:
            words = "a comment says that it counts otherwise"
            against |= dict.fromkeys(f"{words}: {one.told}" for one in found.conventions)
        else:
            conventions |= dict.fromkeys(found.conventions)
        kind, why = class_of(facts, sentence, found)
        if kind is SentenceClass.LIMITS:
            words = f"the text says '{sentence.words[:120]}', which denies or limits it ({why})"
            limits[Limit(words, sentence.words)] = None
        elif kind is SentenceClass.COUNTS:
            words = (
                f"the text says '{sentence.words[:120]}', which is compared with nothing ({why})"
            )
            about[Limit(words, sentence.words)] = why
        elif kind is SentenceClass.QUOTED:
            unjudged[sentence.words] = None
    open_names = {facts.own_name(n) for why in about.values() for n in why.split(", ")}
    units = [facts.unit(n) for n in open_names & facts.parameters.keys()]
    for limit, why in about.items():
        own = {facts.own_name(n) for n in why.split(", ")} & facts.parameters.keys()
        if own and all(units.count(facts.unit(n)) == 1 for n in own):
            unjudged[limit.sentence] = None
        else:
            limits[limit] = None
    if turned and unread:  # one of two signs alone turns what is right with both
        unsettled[f"the text says '{unread}' of more than is read"] = None
    for text, notation in written.items():
        hidden = list(unread_markup(marked(text))) if notation == "latex" else []
        # What a formula continues with on a new line is no quotation.
        if notation == "latex" and QUOTED.search(marked(text)) and foreign_quotation(text):
            hidden.append("a quotation")
        markup = (Limit(f"{one} is not read: it may hide what it holds") for one in hidden)
        limits |= dict.fromkeys(markup)
        for words in declared_otherwise(facts, text):
            if words.endswith(OTHER_UNIT):  # a label of a name, which no formula holds
                limits[Limit(words, words)] = None
            else:
                against[words] = None
    for source in code:
        against |= dict.fromkeys(declared_in_code(facts, source.code(), statements))
    every_name = frozenset(names)
    return Prose(
        tuple(conventions), tuple(against), tuple(limits), tuple(unjudged), every_name,
        tuple(unsettled),
    )  # fmt: skip


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

"""What becomes of a sentence that is compared with the scene: one of four classes, or none.

    The rod is massless.                 against the scene: nothing beside it is shown
    This holds only for small angles.    denies or limits: the same
    theta is positive to the north.      says how theta counts, which nothing compares: the same
    The rod is made of steel.            is quoted beside the verdict
    Hence we obtain                      connects formulas

A sentence that the scene has as it is said, and one of function words alone, changes nothing. Any
other is quoted: no word is taken to be harmless.
"""

import re
from enum import Enum

from mechanics.judge import phrases as p
from mechanics.judge.comparison import Comparison
from mechanics.judge.scene_facts import SceneFacts
from mechanics.judge.sentences import UNIT, VALUE, Sentence
from mechanics.scene.unit_names import is_unit

MARK = re.compile("\u27e8(?:= ?)?([^\u27e9]*)\u27e9")
TASK = re.compile(r"\[[ xX]?\](?!\w)")
"""A box of Markdown that is ticked, or is not."""
WORDS = re.compile(r"(?<!\w)[^\W\d_]+(?![\w(])")


class SentenceClass(Enum):
    """What becomes of a sentence."""

    READ = "says what the scene has, or only connects"
    LIMITS = "denies or limits what stands beside it"
    COUNTS = "says how or what something of the scene is, and is not compared"
    QUOTED = "is not compared with anything"


def class_of(
    facts: SceneFacts, sentence: Sentence, comparison: Comparison
) -> tuple[SentenceClass, tuple[str, ...]]:
    """The class of a sentence, and by which words it limits, or says how something counts."""
    driven = facts.inputs or facts.scene.explicit_time
    rest = comparison.rest if driven else p.UNDRIVEN.sub(" ", comparison.rest)
    if limiting := _limiting(sentence, rest):
        return SentenceClass.LIMITS, tuple(limiting[:3])
    if _connects(facts, comparison.rest) and not TASK.search(sentence.words):
        return SentenceClass.READ, ()
    if words := _counts(facts, sentence.marked, comparison.rest):
        return SentenceClass.COUNTS, words
    return SentenceClass.QUOTED, ()


def _counts(facts: SceneFacts, sentence: str, rest: str) -> tuple[str, ...]:
    """Words for how something of a sentence counts, in what nothing compares."""
    left = p.PASSING.sub(" ", p.IDIOMS.sub(" ", rest))
    said, named = (
        {facts.own_name(one[1]) for one in p.NAMED.finditer(words)} for words in (sentence, left)
    )
    moving = facts.names - facts.parameters.keys()
    row = p.WAY if said & moving else p.FROM if named & facts.names else p.THING_AND_WAY
    way = row.search(MARK.sub(" ", left))
    return (way[0],) if way else _denoted(facts, p.BESIDE_A_UNIT.sub(" ", left))


def _denoted(facts: SceneFacts, rest: str) -> tuple[str, ...]:
    """Parameters of which a sentence says what they are: two of one unit may be exchanged."""
    names = dict.fromkeys(one["name"] for one in p.DENOTED.finditer(rest))
    own = ((name, facts.own_name(name)) for name in names)
    return tuple(n for n, o in own if o in facts.parameters and not facts.is_sole(o))


def _limiting(sentence: Sentence, rest: str) -> list[str]:
    """What may deny or limit, of what nothing compares; of a comment what denies an equation."""
    denials = [m[0] for m in p.DENIAL.finditer(sentence.words)]
    if sentence.comment:
        rows = (p.FLAWED, p.FOREIGN_UNIT)
        return [*denials, *(m[0] for row in rows for m in row.finditer(sentence.words))]
    marked = sentence.marked
    asked = ["?"] if "?" in marked and (MARK.search(marked) or not WORDS.search(marked)) else []
    plain = MARK.sub(" ", p.IDIOMS.sub(" ", rest))
    words = [word for word in WORDS.findall(plain) if p.DENIES.fullmatch(word)]
    others = (m[0] for row in (p.PREDICATES, p.UNUSUAL) for m in row.finditer(plain))
    return [*denials, *words, *others, *asked]


def _connects(facts: SceneFacts, rest: str) -> bool:
    """Whether function words are all that is left, and formulas that are judged by themselves."""
    if any(not _judged(facts, m[0]) for m in MARK.finditer(rest)):
        return False
    words = re.findall(r"\w+", p.PART_OF_DOCUMENT.sub(" ", MARK.sub(" ", rest)).lower())
    return all(word in p.CONNECTIVES for word in words)


def _judged(facts: SceneFacts, mark: str) -> bool:
    """Whether a marked formula is an equation without a condition; one of a text is a line."""
    formula = mark.removeprefix("\u27e8= ").removesuffix("\u27e9")
    if formula == mark[:-1]:
        return False  # a name
    if (value := VALUE.fullmatch(formula.strip(" .,"))) and (
        value["dots"] or facts.own_name(value["name"]) not in facts.parameters
    ):
        return False  # where it holds
    if (unit := UNIT.search(formula)) and not is_unit(unit[1]):
        return False
    return not formula or ("=" in formula and not p.CONDITION.search(formula))

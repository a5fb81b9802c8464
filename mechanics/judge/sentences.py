r"""What the sentences of a text say otherwise than the scene has it.

sentence -> the rows of `phrases` that match it -> what they say, beside what the scene has

    where $l$ is half the length of the rod      a convention: half-length of l
    where $m$ is the mass of the carriage        against the scene, whose m is the pendulum's
    The rod is massless.                         against the scene, whose rod has an inertia
    The hoop turns freely.                       of the scene, and not read: that is told

Conventions are named as a person declares them. What is against the scene leaves what it stands
beside UNDECIDED; so does what is not read and has a word that may deny or limit. What else is not
read is quoted. What is said as the scene has it changes nothing.
"""

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from sympy import Basic, Expr, Rational, Symbol

from mechanics.claims.directions import Counted, counted
from mechanics.claims.latex.blocks import blocks
from mechanics.claims.latex.comments import without_hidden
from mechanics.claims.latex.prepare import prepared
from mechanics.claims.names import Match
from mechanics.claims.place import Refused
from mechanics.claims.prose import ENDS, energy_before
from mechanics.claims.text.letters import plain
from mechanics.judge import phrases as p
from mechanics.judge.markup import without_markup
from mechanics.judge.sentence_forms import one_form
from mechanics.judge.vocabulary import PHRASES, TALK, strange
from mechanics.scene import Gravity, Particle, RigidBody, Scene
from mechanics.scene.loads import Coulomb, Damper, Force, Spring, Torque, TorsionSpring
from mechanics.scene.unit_names import dimension_of_unit
from mechanics.scene.units import rolled
from mechanics.symbolic import is_zero

DELIMITER = re.compile(
    r"\$+|\\{1,2}[\[\]()]|:math:|^\s*\.\.\s+math::|```\s*math|[`#*]", re.MULTILINE
)
BESIDE = re.compile(r"\\(?:text(?:rm|it|normal|bf|up)?|[mh]box|intertext)\s*\{([^{}]*)\}")
"""Words in a display."""
SCRIPT = re.compile(r"[_^]\s*(?:\{(?:[^{}]|\{[^{}]*\})*\}|\\\w+\s*\{[^{}]*\})")
"""Raised and lowered, as are the labels of braces."""
NO_MARKS = str.maketrans("\u27e8\u27e9", "()")
"""What a person types is no mark of ours."""
GIVEN = re.compile(
    r"(?:^|[\n,;:$]|\b(?:with|where|and|for|let|if|here|take|set)\b)[ \t]*\\?(?P<name>[A-Za-z]\w*)"
    r"[ \t]*=[ \t]*(?P<number>[-\u2212]?[ \t]*\d+(?:\.\d*)?)(?![ \t]*[\w*^/(\\.+-])"
)
"""A parameter that is a number."""
WITHOUT_CLAIM = re.compile(r"\b(?:like|terms?|factor|by|eliminating|substituting) $")
"""Before what is only named."""
QUESTION = re.compile(r"\?+(?=\s|\Z)")
INSIDE = re.compile(r"[.;!?](?=\s)")
"""What ends no sentence."""
ACCENT = r"\\(?:d{1,4}ot|vec|hat|bar|tilde|mathbf|mathcal|mathrm|mathscr|boldsymbol|bm)(?![A-Za-z])"
ATOM = (
    rf"(?:{ACCENT}\s*\{{?\s*)*(?:\\[A-Za-z]{{2,}}|[A-Za-z])\s*\}}*"
    r"(?:\s*_\s*(?:\{[\w\s,\\]*\}|\w+))?\s*\}*'*(?:\s*\(\s*t\s*\))?"
)
PLAIN = re.compile(
    rf"\s*[(\[]?\s*{ATOM}(?:\s*,\s*{ATOM})*\s*[)\]]?(?:\s*\^\s*\{{?\s*T\s*\}}?)?\s*[.,]?"
)
"""A quantity, a list or a vector of them: what has no value of its own."""
RELATION = re.compile(
    r"[=<>\u2248]|\\(?:equiv|approx|to|ll|gg|simeq|sim|neq?|leq?|geq?|in)(?![A-Za-z])"
)
NAME = re.compile(r"\s*\\?(?:var)?([A-Za-z]+(?:_\{?\w+\}?)?)\s*")
WORD = re.compile(r"(?<![\w\u27e8'.])([^\W\d]\w*)(?![\w(\u27e9'\[])(?: ?:)?")
HEADS = (
    (r"(?:moment of )?inertia", "kg*m^2"), (r"mass", "kg"), (r"stiffness", "N/m"),
    (r"length|radius|diameter|distance|height|width", "m"), (r"torque|moment|couple", "N*m"),
    (r"force|weight", "N"), (r"acceleration|gravity", "m/s^2"),
)  # fmt: skip
"""First nouns of what a name is, and their units."""
LINKED = re.compile(r"\u27e8\w+\u27e9 ?(?:is|are|be|being|denote|mean|stand|:)")
WHOSE = re.compile(r"\bof (?:the )?(?:\w+ )?(\w+)(?: (?:along|about|at|on|in|from|to|with)\b|$)")
MARKED = re.compile("\u27e8[^\u27e9]*\u27e9")
VALUE = re.compile("\u27e8= ([^\u27e9]*)\u27e9")
TEXT_FORMULA = re.compile(
    r"^(?:[^\n]*=[^\n]*|(?![^\n]*[A-Za-z]{2,},? +[A-Za-z]{2,})[^\n]*[;\[(+*/^][^\n]*)$",
    re.MULTILINE,
)
"""Lines of a text that are no prose: with an equals sign, or lists without words."""
CODE = re.compile(
    r"^[ \t]*(?:@\w+ )?(?:end\w*(?:[ \t]+[\w.]+)?[ \t]*;?|function\b[^\n]*[(=][^\n]*"
    r"|(?:model|block|class|package|record|module|(?:mutable )?struct)[ \t]+\w+(?:\{[^\n]*)?"
    r"(?:[ \t]+\"[^\"\n]*\")?[ \t]*;?"
    r"|(?:return|using|import|extends|within|global|persistent)\b"
    r"(?!(?:[^\n]*[A-Za-z]{2,} +){3})[^\n]*"
    r"|(?:initial )?(?:equation|algorithm)|protected|public|\w+::\S+|else|begin"
    r"|clear\w*|clc|close all;?"
    r"|(?:(?:parameter|constant|input|output|final|flow|discrete|protected|public)[ \t]+)*"
    r"\.?[A-Z][\w.]*(?:\[[^\]\n]*\])?[ \t]+\w+(?:\([^()\n]*\))?(?:[ \t]*,[ \t]*\w+)*[ \t]*"
    r"(?:\"[^\"\n]*\")?[ \t]*;?)[ \t]*$",
    re.MULTILINE,
)
"""Lines of MATLAB, Julia and Modelica."""
BEHIND = re.compile(r"(?<=\S)[ \t]+((?://|%|#).*)$", re.MULTILINE)
"""A comment behind code."""
HEADING = re.compile(r"^[ \t]*#+[ \t]*", re.MULTILINE)
MARK = re.compile(r"#|//|/\*|%|\"|\u27e8= \u27e9$")
"""Before a comment."""
SCALE = re.compile(r"\b(?:per|constant|coefficient|ratio|number|factor|arm|density|unit)\b", re.I)
RATIOS = (Rational(1), Rational(1, 2))


def sentences(text: str, notation: str, names: Collection[str]) -> Iterator[str]:
    """Sentences with names and formulas marked, as `phrases` has them.

    Parameters
    ----------
    text : str
    notation : str
        Outside of LaTeX formulas stand on lines of their own, and names between words.
    names : collection of str
        Of the person, and the scene's.
    """
    text = text.translate(NO_MARKS)
    if notation == "latex":
        text = without_markup(marked(text))
    else:
        code = CODE.search(text) is not None
        text = BEHIND.sub(r"\n\1", text)
        text = re.sub(r";[ \t]*(?=\S)", ";\n", text) if code else text
        text = TEXT_FORMULA.sub("\u27e8= \u27e9", CODE.sub("\u27e8= \u27e9", text))
        text = text if code else HEADING.sub("", text)
        text = WORD.sub(lambda m: _word(m, names), re.sub(r"\n(?!\n)", ".\n", text))
    for sentence in ENDS.split(QUESTION.sub(r" \g<0>.", text)):
        if one := " ".join(sentence.split()):
            yield from one_form(one)


def bare(words: str) -> str:
    """Words without the marks of names and formulas."""
    return re.sub("\u27e8(?:= ?)?|\u27e9", "", words).strip()


def quoted(sentence: str) -> str:
    """The words of a sentence, with dots for formulas."""
    return bare(re.sub("\u27e8= [^\u27e9]{9,}\u27e9", "\u2026", sentence))[:90]


def marked(text: str) -> str:
    """A text in LaTeX with marks for names and formulas, and words of displays behind these."""
    try:
        text = text.translate(NO_MARKS)
        shown, every = without_hidden(text), blocks(prepared(text))
    except Refused:
        return ""  # nothing of it is read
    out, at = [], 0
    for block in every:
        formula = shown[block.start : block.end]
        out.append(DELIMITER.sub(" ", shown[at : block.start]))
        out.append("" if block.bare else _mark(formula))
        out += [
            f". {_inside(words)}. "
            for words in ([] if block.inline else BESIDE.findall(SCRIPT.sub(" ", formula)))
        ]
        at = block.end if block.closed else len(shown)
    return "".join(out) + DELIMITER.sub(" ", shown[at:])


def _inside(words: str) -> str:
    """Words of a display, their formulas marked."""
    return re.sub(r"\$([^$]*)\$|\\\((.*?)\\\)", lambda m: _mark(m[1] or m[2] or ""), words)


def _mark(formula: str) -> str:
    if name := NAME.fullmatch(formula):
        return f"\u27e8{re.sub('[{}]', '', name[1])}\u27e9"
    words = " ".join(INSIDE.sub(" ", formula).split())
    return f"\u27e8= {words}\u27e9{'.' if words.endswith('.') else ''}"


def _word(word: re.Match[str], names: Collection[str]) -> str:
    name = plain(word[1])[0]
    if name not in names or name in ("a", "A", "I"):
        return word[0]
    return f"\u27e8{name}\u27e9{' is' if word[0].endswith(':') else ''}"


@dataclass(frozen=True)
class Said:
    """What a scene has that sentences speak of.

    Attributes
    ----------
    scene : Scene
    known : sequence of Match
        What names of the person were taken for.
    """

    scene: Scene
    known: Sequence[Match]

    @cached_property
    def parameters(self) -> dict[str, Symbol]:
        """Parameters by their names."""
        return {symbol.name: symbol for symbol in self.scene.parameters}

    @cached_property
    def inputs(self) -> frozenset[str]:
        """Names of inputs."""
        return frozenset(symbol.name for symbol in self.scene.input_symbols)

    @cached_property
    def coordinates(self) -> dict[str, Symbol]:
        """Coordinates by their names."""
        return {symbol.name: symbol for symbol in self.scene.q}

    def own(self, said: re.Match[str]) -> str:
        """The scene's name of what a sentence is about."""
        name, meanings = _name(said), {match.name: match.meaning for match in self.known}
        own = {*self.parameters, *self.coordinates, *self.inputs}
        spelled = (name, name.replace("_", ""))
        return next((meanings.get(n, n) for n in spelled if n in meanings or n in own), name)

    def meaning(self, name: str) -> str:
        """What the scene says that a parameter is."""
        return getattr(self.parameters.get(name), "meaning", "")

    def unit(self, name: str) -> str:
        """Of a parameter; empty where none is declared."""
        return getattr(self.parameters.get(name), "unit", "")

    @cached_property
    def angles(self) -> tuple[Counted, ...]:
        """How the scene counts its angles."""
        return counted(self.scene)

    @cached_property
    def names(self) -> frozenset[str]:
        """Of parameters, coordinates and inputs."""
        return frozenset((*self.parameters, *self.coordinates, *self.inputs))

    @cached_property
    def own_words(self) -> frozenset[str]:
        """Nouns of the scene, other words for them, and names, in lower case."""
        called = (self.scene.name, *(reaction.name for reaction in self.scene.reactions))
        nouns = {*self.words, *re.findall("[a-z]+", " ".join(called).lower())} - p.SIZES
        alike = {w for some in p.ALIKE if len(some & nouns) == 1 for w in some}
        alike |= {"uniform"} if any(isinstance(b, RigidBody) for b in self.scene.bodies) else set()
        alike |= {"elastic", "spring"} if self.has["springs"] else set()
        plural = {f"{word}s" for word in nouns | alike}
        named = {m.name.lower() for m in self.known} | {name.lower() for name in self.names}
        return frozenset(nouns | alike | plural | named)

    @cached_property
    def has(self) -> dict[str, bool | None]:
        """Whether there is friction, gravity, a spring; None where that is not known."""
        return {name: have(self) for name, have in HAVE.items()}

    @cached_property
    def words(self) -> frozenset[str]:
        """All that names of bodies and meanings of parameters are made of."""
        every = (*(b.name for b in self.scene.bodies), *map(self.meaning, self.parameters))
        return frozenset(word for words in every for word in re.findall("[a-z]+", words.lower()))

    def nouns(self, words: str) -> frozenset[str]:
        """The words that tell things apart; those for one thing are one."""
        plain_words = re.sub(r"'s\b", "", words.lower())
        found = {w for w in re.findall(r"[a-z]+", plain_words) if not p.SMALL.fullmatch(w)}
        return frozenset(map(self.alike, found))

    def alike(self, word: str) -> str:
        """The one word for a thing."""
        word = word.lower().removesuffix("s") if word.lower() not in self.words else word.lower()
        for some in p.ALIKE:
            if word in some and len(some & self.words) < 2:
                return min(some)
        return word

    def bodies(self, word: str) -> list[Particle | RigidBody]:
        """Bodies whose names hold a word."""
        own = self.alike(word)
        return [b for b in self.scene.bodies if own in self.nouns(b.name)]

    def held(self, load: Force | Torque) -> set[Basic]:
        """Symbols of a load."""
        return self.scene.vector(load.vector, load.name).free_symbols

    def moves(self, body: Particle | RigidBody) -> bool:
        """Whether coordinates place or turn a body."""
        place = list(self.scene.position(body.centre))
        turned = list(self.scene.rotation(body.frame)) if isinstance(body, RigidBody) else []
        return any(entry.free_symbols & {*self.scene.q} for entry in (*place, *turned))


def conventions(about: Said, sentence: str) -> Iterator[str]:
    """Conventions that a sentence tells, as they are declared."""
    for pattern in p.DIRECTIONS:
        for said in pattern.finditer(sentence):
            way = said["way"].lower()
            sense = (said.groupdict().get("sense") or "").lower()
            yield f"{' '.join(filter(None, (p.WAYS.get(way, way), sense)))} of {_name(said)}"
    for said in p.EVERY_ANGLE.finditer(sentence):
        way = said["way"].lower()
        yield from (f"{p.WAYS.get(way, way)} of {angle.symbol.name}" for angle in about.angles)
    for pattern, words in ((p.HALF, "half-length"), (p.DOUBLE, "half-length"),
                           (p.TWICE, "twice the length")):  # fmt: skip
        yield from (f"{words} of {_name(said)}" for said in pattern.finditer(sentence))


def described(about: Said, sentence: str) -> Iterator[str]:
    """Conventions that a sentence tells of what the scene counts otherwise."""
    for said in p.WHOLE.finditer(sentence):
        if "half" in about.meaning(about.own(said)):
            yield f"twice the length of {_name(said)}"
    for said in p.TO_CENTRE.finditer(sentence):
        if _ratio(about, about.own(said)) == Rational(1, 2):
            yield f"half-length of {_name(said)}"
    for said in p.NEGATIVE.finditer(sentence):
        if about.own(said) in about.inputs:
            yield f"other sign of {_name(said)}"
    yield from senses(about, sentence)


def senses(about: Said, sentence: str) -> Iterator[str]:
    """Those of `described` that are told by left, right and clockwise: as seen from one side."""
    for said in (*p.TURNS.finditer(sentence), *p.PUSHES.finditer(sentence)):
        way = -1 if said["way"].lower().startswith(("clock", "left")) else 1
        if _way(about, about.own(said)) == -way:
            yield f"other sign of {_name(said)}"


def against(about: Said, sentence: str, whole: bool = True) -> Iterator[str]:
    """What a sentence says that the scene has otherwise, and no convention mends; in words.

    Parameters
    ----------
    about : Said
    sentence : str
    whole : bool
        Whether a sentence that speaks of the scene and is not read counts; none of a comment does.
    """
    yield from _names(about, sentence)
    denied = p.DENIED.search(sentence) is not None
    for row, check in ((p.EQUAL, _equal), (p.NO_MASS, _massless)):
        for said in (one for pattern in row for one in pattern.finditer(sentence)):
            yield from () if denied and "no" not in said[0].split() else check(about, said)
    for said in p.VALUE.finditer(sentence):
        yield from _value(about, said)
    yield from _features(about, sentence)
    yield from _motion(about, sentence)
    if whole and (words := _limiting(about, sentence)):
        shown, last = bare(sentence)[:120], f" ({', '.join(words[:3])})"
        yield f"the sentence '{shown}' was not read: it may say otherwise than the scene{last}"


def _limiting(about: Said, sentence: str) -> list[str]:
    """What is not read of a sentence that may deny or limit, or has what the scene has not."""
    words, claims = unread(about, sentence)
    others = [w for w in words if p.THINGS.fullmatch(w) and not p.CARRIERS.fullmatch(w)]
    limits = others or any(not w.isalpha() or p.LIMITS.fullmatch(w) for w in words)
    return [*words, *claims] if claims or limits else []


def passed_over(about: Said, sentence: str) -> bool:
    """Whether a sentence is neither compared with the scene nor talk, nor limits anything."""
    words, claims = unread(about, sentence)
    if MARK.match(sentence) or claims or _limiting(about, sentence):
        return False
    return bool(words) or _states(about, sentence)


def _states(about: Said, sentence: str) -> bool:
    """Whether a sentence says something of the scene that no row compares."""
    if any(pattern.search(sentence) for pattern in (*READ, p.DENOTED)):
        return False
    if any(re.search(words, sentence, re.IGNORECASE) for _, words in p.FEATURES):
        return False
    if any(p.CONDITION.search(one[1]) for one in VALUE.finditer(sentence)):
        return True
    said = {*re.findall("[a-z]+", MARKED.sub(" ", sentence).lower())} - TALK
    return bool(said & about.own_words) and p.VERBS.search(sentence) is not None


def outside(about: Said, text: str) -> Iterator[str]:
    """Values that a text gives parameters, and that the scene's cannot have."""
    for said in GIVEN.finditer(text):
        symbol = about.parameters.get(about.own(said))
        number = float(
            re.sub(r"[\u2212\s]", lambda m: "" if m[0].isspace() else "-", said["number"])
        )
        if symbol is None or number > 0 or (number == 0 and not symbol.is_positive):
            continue
        if symbol.is_positive or symbol.is_nonnegative:
            value = f"{said['name']} = {said['number']}"
            yield f"the text has {value}, the scene's {symbol.name} is positive"


def unread(about: Said, sentence: str) -> tuple[list[str], list[str]]:
    """What of a sentence no row compares with the scene: words; values, kinds and questions."""
    if MARK.match(sentence):
        return [], []
    rest = sentence
    for pattern in READ:
        rest = pattern.sub(lambda said: _left(about, said), rest)
    for part in re.split(r"(, |\b(?:but|so that|while|and)\b)", rest):
        for name, words in p.FEATURES:
            denied = p.ABSENT.search(part)
            if re.search(words, part, re.IGNORECASE) and (
                about.has[name] is not None or not denied
            ):
                bare_part = re.sub(rf"\b\w*(?:{words})\w*", " ", part, flags=re.IGNORECASE)
                rest = rest.replace(part, p.ABSENT.sub(" ", bare_part))
    values = [
        m[1].strip() for m in VALUE.finditer(rest)
        if not (RELATION.search(m[1]) or PLAIN.fullmatch(m[1]) or energy_before(rest, m.start())
                or WITHOUT_CLAIM.search(rest, 0, m.start()))
    ]  # fmt: skip
    kinds = [w for said in p.DENOTED.finditer(rest) for w in _kinds(about, said)]
    asked = ["?"] if "?" in sentence and MARKED.search(sentence) else []
    claims = [one[0] for one in p.PREDICATES.finditer(bare(sentence))]
    return strange(MARKED.sub(" ", rest), about.own_words), [*values, *kinds, *asked, *claims]


def _kinds(about: Said, said: re.Match[str]) -> list[str]:
    """Nouns of what a name is said to be that the scene does not have of it."""
    words, *more = p.BREAK.split(said["words"])
    own = about.own(said)
    meaning = about.meaning(own)
    if (said["formula"] and not more and not LINKED.match(said[0])) or own not in about.names:
        return []
    if p.SCALED.search(words):
        return []
    if own in about.parameters:
        have = about.nouns(meaning) | p.GRAVITY if "gravit" in meaning else about.nouns(meaning)
        have = have if meaning else about.nouns(words)
    elif own in about.inputs:
        turns = any(isinstance(x, Torque) and any(s.name == own for s in about.held(x))
                    for x in about.scene.loads)  # fmt: skip
        have = p.TURNING if turns else p.PUSHING
        have |= about.own_words | {"pivot"}
    else:
        have = p.PLACES | about.own_words
    return sorted(about.nouns(PHRASES.sub(" ", words)) - have - p.PLAIN_NOUNS)


def _left(about: Said, said: re.Match[str]) -> str:
    """What is left of words that a row has: nothing where what they are about is of the scene."""
    groups = said.groupdict()
    if groups.get("name") and about.own(said) not in about.names:
        return said[0]
    if groups.get("body") and not (about.bodies(groups["body"]) or _link(groups["body"])):
        return said[0]
    return " "


READ = (
    *p.DIRECTIONS, p.EVERY_ANGLE, p.HALF, p.TWICE, p.DOUBLE, p.WHOLE, p.TO_CENTRE, p.NEGATIVE,
    p.TURNS, p.PUSHES, p.RELATIVE, p.ABSOLUTE, p.PLACE, p.ON_BODY, *p.NO_MASS, *p.EQUAL, p.VALUE,
    p.FLAT, p.STILL, p.SORT, p.DRIVEN,
)  # fmt: skip
"""Rows whose words are compared with the scene."""


def _names(about: Said, sentence: str) -> Iterator[str]:
    """What is said of single names."""
    for said in p.DOTS.finditer(sentence):
        yield f"the text says that dots are derivatives by {bare(said['by'])}"
    for said in p.DENOTED.finditer(sentence):
        yield from _denoted(about, said)
    for said in p.UNIT.finditer(sentence):
        yield f"the text says {said['all'] or _name(said)} in {bare(said['unit'])}"
    held = {*about.parameters, *about.inputs}
    for pattern, some in ((p.PER, held), (p.AGAINST, about.inputs)):
        for said in pattern.finditer(sentence):
            scaled = p.DENOTED.match(sentence, said.start())
            if about.own(said) in some and not (scaled and p.SCALED.search(scaled["words"])):
                yield f"the text says of {_name(said)} {said['words']!r}"
    for said in p.FACTOR.finditer(sentence):
        if about.own(said) in held:
            yield f"the text says that {_name(said)} is {said['size']} the {said['what']}"
    for said in p.TO_CENTRE.finditer(sentence):
        own = about.own(said)
        if own in about.parameters and _ratio(about, own) not in RATIOS:
            words = f"the text says that {_name(said)} is the distance to a mass centre"
            yield f"{words}, but {own} of the scene is not"
    for said in (*p.TURNS.finditer(sentence), *p.PUSHES.finditer(sentence)):
        own = about.own(said)
        if own in about.inputs and _way(about, own) == 0:
            words = f"the text says that {_name(said)} acts {said['way']}"
            yield f"{words}, which the scene does not say of {own}"
    for pattern, way, one in ((p.RELATIVE, "relative to", True), (p.ABSOLUTE, "from", False)):
        for said in pattern.finditer(sentence):
            own = about.own(said)
            if _is_absolute(about, own) is one:
                words = f"the text says that {_name(said)} counts {way} the {said['to']}"
                yield f"{words}, {own} does not"
    for said in p.ABOUT.finditer(sentence):
        meaning = about.meaning(about.own(said))
        if "inertia" in meaning and about.alike(said["to"]) not in about.nouns(meaning):
            yield f"the text says that {_name(said)} is about the {said['to']}, which it is not"
    for said in p.PLACE.finditer(sentence):
        yield from _place(about, said)
    for said in p.ON_BODY.finditer(sentence):
        yield from _on_body(about, said)


def _denoted(about: Said, said: re.Match[str]) -> Iterator[str]:
    """What the words behind a name say that the scene's symbol is not."""
    words, *more = p.BREAK.split(said["words"])
    if said["formula"] and not more and not LINKED.match(said[0]):
        return  # a mass ⟨m⟩, a length ⟨l⟩
    own, words = about.own(said), words.strip()
    text = f"the text says that {_name(said)} is the {words}"
    if own not in about.parameters:
        yield from [text] if own in about.inputs and p.SCALED.search(words) else ()
        if _other_sort(about, own, words):
            yield f"{text}, which {own} of the scene is not"
        return
    meaning, unit = about.meaning(own), about.unit(own)
    have = f"{text}, the scene's {own} is the {meaning or f'one in {unit}'}"
    if p.SCALED.search(words):
        yield from [text] if "/" not in unit else ()
        return
    if any(re.search(a, meaning) and re.search(b, words) for a, b in p.OTHERS):
        yield have
    elif other := _another(about, own, words):
        yield f"{have}, and {other} is that"
    elif _of_another_body(about, own, words) or _other_kind(unit, words):
        yield have
    elif meaning and re.match("distance (?:from|between|of|to)", words):
        ends = about.nouns(words.partition(" ")[2]) - {"distance"}
        if "distance" not in meaning and (
            not ends or not ends <= p.ENDPOINTS | about.nouns(meaning)
        ):
            yield from [have] if not p.TO_CENTRE.match(said.string, said.start()) else ()


def _another(about: Said, own: str, words: str) -> str:
    """The other parameter of the same unit whose meaning words have that set it apart; or empty."""
    said, mine = about.nouns(words), about.nouns(about.meaning(own))
    for name in about.parameters:
        theirs = about.nouns(about.meaning(name))
        apart = theirs - mine and theirs <= said and not mine <= said
        same = name != own and about.unit(name) == about.unit(own)
        if same and apart and not (mine - theirs) & said:
            return name
    return ""


def _of_another_body(about: Said, own: str, words: str) -> bool:
    """Whether a mass is said to be that of a body that has another; a rate, of another thing."""
    symbol, mine = about.parameters[own], about.nouns(about.meaning(own))
    if re.match(r"(?:\w+ )?mass\b", words):
        named = [b for b in about.scene.bodies if about.nouns(b.name) & about.nouns(words)]
        masses = [about.scene.plain(body.mass) for body in named]
        return len(named) == 1 and not any(symbol in mass.free_symbols for mass in masses)
    whose = re.search(
        r"\bof (?:the )?(?:\w+ )?(\w+)(?: (?:along|about|at|on|in|from|to|with)\b|$)", words
    )
    head = about.alike(whose[1]) if whose else ""
    things = {about.alike(m[0]) for m in p.THINGS.finditer(about.meaning(own))}
    return bool(about.bodies(head) and things and head not in mine) if head else False


def _other_kind(unit: str, words: str) -> bool:
    """Whether the first noun of what a name is said to be has another unit."""
    head = re.split(r"\b(?:of|on|at|in|from|to|about)\b", words)[0]
    if not unit or SCALE.search(words):
        return False
    for noun, of in HEADS:
        if re.search(rf"\b(?:{noun})$", head.strip()):
            return dimension_of_unit(of, "") != dimension_of_unit(unit, "")
    return False


def _other_sort(about: Said, own: str, words: str) -> bool:
    """Whether a coordinate is said to be no place, or a force a torque."""
    (head,) = p.SORTS.findall(re.split(r"\b(?:of|on|at|in|from|to|about)\b", words)[0])[-1:] or [""]
    if own in about.inputs and head:
        loads = [x for x in about.scene.loads if isinstance(x, Force | Torque)]
        turns = {isinstance(x, Torque) for x in loads if own in {s.name for s in about.held(x)}}
        return turns == {head == "force"}
    return own in about.coordinates and bool(head)


def _place(about: Said, said: re.Match[str]) -> Iterator[str]:
    """A coordinate that is said to place a body is that, but for what is constant."""
    symbol = about.coordinates.get(about.own(said))
    bodies = about.bodies(said["body"])
    if symbol is None or len(bodies) != 1:
        return
    moving = {*about.scene.q}
    entries = about.scene.position(bodies[0].centre)
    slopes = [e.diff(symbol) for e in entries]
    own = any(s.is_number and s != 0 and not (e - s * symbol).free_symbols & moving
              for s, e in zip(slopes, entries, strict=True))  # fmt: skip
    if not own and not any(a.symbol == symbol for a in about.angles):
        yield f"the text says {bare(said[0])!r}, which {symbol.name} of the scene is not"


def _on_body(about: Said, said: re.Match[str]) -> Iterator[str]:
    """A force that is said to act on a body does."""
    own, bodies = about.own(said), about.bodies(said["body"])
    for load in about.scene.loads:
        if own in about.inputs and isinstance(load, Force) and len(bodies) == 1:
            vector = about.scene.vector(load.vector, load.name)
            held = any(symbol.name == own for symbol in vector.free_symbols)
            (body,) = bodies
            if held and load.on not in (None, body.name):
                words = f"the text says that {_name(said)} acts on the {said['body']}"
                yield f"{words}, the scene's does on {load.on}"


def _equal(about: Said, said: re.Match[str]) -> Iterator[str]:
    """Masses, lengths and stiffnesses that are said to be equal, or not."""
    scene, what = about.scene, said["what"].lower()
    masses = {scene.plain(body.mass) for body in scene.bodies}
    lengths = {n for n in about.parameters if about.unit(n) == "m" and "length" in about.meaning(n)}
    springs = {scene.plain(x.stiffness) for x in scene.loads if isinstance(x, Spring)}
    some = {"mass": masses, "leng": lengths, "spri": springs, "stif": springs}.get(what[:4], masses)
    differ = said["how"].lower() in ("different", "unequal")
    if (len(some) == 1 and differ) or (len(some) > 1 and not differ):
        yield f"the text says {said[0]!r}, which the scene's are not"


def _massless(about: Said, said: re.Match[str]) -> Iterator[str]:
    """A body without mass has no inertia."""
    word = said["body"]
    bodies = about.bodies(word)
    if not bodies and _link(word):
        rods = p.ALIKE[0]
        bodies = [b for b in about.scene.bodies if rods & set(re.findall("[a-z]+", b.name.lower()))]
    heavy = [b.name for b in bodies if isinstance(b, RigidBody) and b.inertia != 0]
    if heavy and len(heavy) == len(bodies):
        words = f"the text says {bare(said[0])!r}, the scene has a mass and an inertia"
        yield f"{words} of {', '.join(heavy)}"


def _link(word: str) -> bool:
    """Whether a word is one for what joins bodies, which may be a body itself or not."""
    return re.fullmatch(p.SLOTS["LINK"], word, re.IGNORECASE) is not None


def _value(about: Said, said: re.Match[str]) -> Iterator[str]:
    """``stiffness $2k$``: something of the scene has that."""
    scene, symbol = about.scene, about.parameters.get(about.own(said))
    if symbol is None:
        return
    value, what = int(said["factor"]) * symbol, said["what"].lower()
    if what in ("length", "radius"):
        have = "half" in about.meaning(symbol.name) and said["factor"] == "2"
    else:
        parts = [x.stiffness for x in scene.loads if isinstance(x, Spring)]
        every = [b.mass for b in scene.bodies] if what == "mass" else parts
        have = any(is_zero(scene.plain(one) - value) for one in every)
    if not have:
        yield f"the text has a {what} of {value}, the scene has none"


def _features(about: Said, sentence: str) -> Iterator[str]:
    """Whether there is friction, gravity, a spring."""
    for part in re.split(r", |\b(?:but|so that|while|and)\b", sentence):
        for name, words in p.FEATURES:
            if re.search(words, part, re.IGNORECASE) is None:
                continue
            absent = p.ABSENT.search(part)
            have = about.has[name]
            if have is (absent is not None):
                words = f"the text says that there is no {name}"
                other = f"the text speaks of {name}, the scene has none"
                yield f"{words if absent else other} ({bare(part)[:60]!r})"


def _dissipates(about: Said) -> bool | None:
    """Whether loads of a scene hold speeds; unknown where bodies roll."""
    scene = about.scene
    speeds = {*scene.u, *scene.qd}
    words = [*map(about.meaning, about.parameters), *(r.name for r in scene.reactions)]
    if any(isinstance(x, Damper | Coulomb) for x in scene.loads):
        return True
    if any(re.search(p.FEATURES[0][1], one, re.IGNORECASE) for one in words):
        return True
    loads = [x for x in scene.loads if isinstance(x, Force | Torque)]
    if any(scene.vector(x.vector, x.name).free_symbols & speeds for x in loads):
        return True
    return None if rolled(scene) or scene.constraints else False


def _falls(about: Said) -> bool | None:
    pulled = any(isinstance(load, Gravity) for load in about.scene.loads)
    named = any("gravit" in about.meaning(n) or n == "g" for n in about.parameters)
    return pulled or named or _of_places(about)


def _springs(about: Said) -> bool | None:
    sprung = any(isinstance(x, Spring | TorsionSpring) for x in about.scene.loads)
    named = any(re.search("spring|stiff", about.meaning(n)) for n in about.parameters)
    return sprung or named or _of_places(about)


def _of_places(about: Said) -> bool | None:
    """Unknown where loads are written out that hold coordinates."""
    loads = [x for x in about.scene.loads if isinstance(x, Force | Torque)]
    vectors = (about.scene.vector(x.vector, x.name) for x in loads)
    return None if any(v.free_symbols & {*about.scene.q} for v in vectors) else False


HAVE = {"friction": _dissipates, "gravity": _falls, "springs": _springs}


def _motion(about: Said, sentence: str) -> Iterator[str]:
    """Of what rests, what is driven, and the plane of the motion."""
    scene = about.scene
    rigid = any(isinstance(b, RigidBody) and b.inertia != 0 for b in scene.bodies)
    for said in p.SORT.finditer(sentence):
        if rigid is (said["sort"].lower() in ("simple", "mathematical")):
            yield f"the text says {said[0]!r}, which the scene has not"
    for said in p.STILL.finditer(sentence):
        if (some := about.bodies(said["body"])) and all(map(about.moves, some)):
            yield f"the text says {said[0]!r}, the scene's moves"
    for said in p.DRIVEN.finditer(sentence):
        if not scene.explicit_time and not any("accelerat" in about.meaning(n) and n != "g"
                                               for n in about.parameters):  # fmt: skip
            yield f"the text says {said[0]!r}, the scene's is not driven"
    fields = [scene.vector(x.field, x.name) for x in scene.loads if isinstance(x, Gravity)]
    if fields and p.FLAT.search(sentence):
        named = [b for b in scene.bodies if about.nouns(b.name) & about.nouns(sentence)]
        heights = [fields[0].dot(scene.position(body.centre)) for body in named or scene.bodies]
        if any(height.free_symbols & {*scene.q} for height in heights):
            yield "the text has a horizontal plane, the scene's bodies rise and fall"


def _name(said: re.Match[str]) -> str:
    return said["name"].replace("{", "").replace("}", "")


def _ratio(about: Said, name: str) -> Expr | None:
    """Of distances from points where reactions act to mass centres, to a length: 1 if one is it."""
    scene, length = about.scene, about.parameters.get(name)
    if length is None or about.unit(name) != "m":
        return None
    points = [scene.origin, *(one.at for one in scene.reactions if one.at is not None)]
    ratios: list[Expr] = []
    for body in scene.bodies:
        for point in points:
            span = scene.position(body.centre) - scene.position(point)
            square = span.dot(span)
            ratios += [k for k in RATIOS if is_zero(square - (k * length) ** 2)]
    return (ratios and (Rational(1) if 1 in ratios else ratios[0])) or None


def _way(about: Said, name: str) -> int:
    """1 where an angle or a torque is counted counterclockwise, a force to the right; -1; or 0."""
    scene = about.scene
    for angle in about.angles:
        if angle.symbol.name == name:
            return angle.sense if angle.fixed and angle.planar else 0
    symbol = next((s for s in scene.input_symbols if s.name == name), Symbol(name, real=True))
    loads = [load for load in scene.loads if isinstance(load, Force | Torque)]
    vectors = [(isinstance(x, Torque), scene.vector(x.vector, x.name)) for x in loads]
    held = [(turns, vector) for turns, vector in vectors if symbol in vector.free_symbols]
    if len(held) != 1:
        return 0
    turns, vector = held[0]
    across, up, out = (one.diff(symbol) for one in vector)
    value = out if turns else across
    if not value.is_number or any(one != 0 for one in (across, up, out) if one is not value):
        return 0
    return 1 if value.is_positive else -1 if value.is_negative else 0


def _is_absolute(about: Said, name: str) -> bool | None:
    """Whether a coordinate is counted from what is fixed: a body's place holds no other.

    None for what is no coordinate.
    """
    scene, symbol = about.scene, about.coordinates.get(name)
    if symbol is None:
        return None
    angles = {one.symbol: one.fixed for one in about.angles}
    if symbol in angles:
        return angles[symbol]
    others = {*scene.q} - {symbol}
    places = [list(scene.position(body.centre)) for body in scene.bodies]
    held = [set().union(*(e.free_symbols for e in place)) for place in places]
    return any(symbol in symbols and not symbols & others for symbols in held)

r"""Sentences of a text, with marks for names and formulas.

where $l$ is half the length of the rod    ->    where ⟨l⟩ is half the length of the rod
the energy $E = T + V$                     ->    the energy ⟨= E = T + V⟩
"""

import re
from collections.abc import Collection, Iterator
from dataclasses import dataclass

from mechanics.claims.code.comments import EQUATION
from mechanics.claims.latex.blocks import blocks
from mechanics.claims.latex.comments import SIGN, verbatim, without_hidden
from mechanics.claims.latex.comments import comments as of_latex
from mechanics.claims.latex.prepare import CONDITION as OF_DISPLAY
from mechanics.claims.latex.prepare import labels, prepared
from mechanics.claims.place import Refused
from mechanics.claims.prose import ENDS, SYMBOL
from mechanics.claims.text.letters import plain
from mechanics.claims.text.line_continuation import AT, LABELLED
from mechanics.claims.text.line_continuation import CONDITION as OF_LINE
from mechanics.claims.text.prepare import BLOCK, LEADS
from mechanics.claims.unread_names import assigned_names
from mechanics.judge.markup import without_markup
from mechanics.judge.phrases import CONDITION, DENIAL, FLAWED, FOREIGN_UNIT
from mechanics.judge.sentence_forms import one_form

DELIMITER = re.compile(
    r"\$+|\\{1,2}[\[\]()]|:math:|^\s*\.\.\s+math::|```\s*math|[`#*]", re.MULTILINE
)
TICKED = re.compile(r"(?<!`)`([A-Za-z]\w*)`(?!`)")
"""A name of Markdown that is typed as code."""
PLACE = re.compile(AT)
BESIDE = re.compile(r"\\(?:text(?:rm|it|normal|bf|up)?|[mh]box|intertext)\s*\{([^{}]*)\}")
"""Words in a display."""
LABEL = re.compile(r"\\tag\*?\s*\{([^{}]*)\}|\\(?:stackrel|overset)\s*\{([^{}]*)\}\s*\{?\s*=")
"""Of an equation, and of its equals sign."""
SHORT_LABEL = re.compile(r"(?:[\W\d_]|\\?[A-Za-z]{1,2}\d|[ivxlcIVXLC]+|[A-Za-z](?![A-Za-z]))*")
"""A number or a letter."""
CALLED = re.compile(
    r"(?:^|\\\\|\$|[\[}&])\s*(?:\\math(?:rm|bf|sf|it)\s*\{)?([A-Za-z][A-Za-z ]{1,40})\}?\s*:(?!=)"
)
"""A word before an equation."""
SCRIPT = re.compile(r"[_^]\s*(?:\{(?:[^{}]|\{[^{}]*\})*\}|\\\w+\s*\{[^{}]*\})")
"""Raised and lowered, as are the labels of braces."""
NO_MARKS = str.maketrans("\u27e8\u27e9", "()")
"""What a person types is no mark of ours."""
PLAIN = str.maketrans("\\$`{}", "     ")
"""What begins no command and no formula."""
QUESTION = re.compile(r"\?+(?=\s|\Z)")
INSIDE = re.compile(r"[.;!?](?=\s)")
"""What ends no sentence."""
NAME = re.compile(rf"\s*{SYMBOL}\s*")
COMMAS = re.compile(r",(?:\s|\\[,; ]|~|\\q?quad\b)*")
WORD = re.compile(r"(?<![\w\u27e8'.])([^\W\d]\w*)(?![\w(\u27e9'\[])(?: ?:)?")
FORMULA = re.compile("\u27e8= ([^\u27e9]*)\u27e9")
BRACES = re.compile("(\u27e8[^\u27e9]*\u27e9)|[{}]")
"""Of arguments of commands, outside of formulas."""
BETWEEN = re.compile(r",|\\q?quad|\\[;:]")
"""Of what stands side by side in a formula."""
VALUE = re.compile(
    r"\\?(?:(?P<dots>d{1,3}ot)\s*\{?\s*\\?)?(?P<name>[A-Za-z]+(?:_(?:\w|\{\w+\}))?)\}?(?P<primes>'*)"
    r"\s*=\s*[-+]?\s*(?:\d+(?:\.\d+)?|\\pi)(?:\s*/\s*\d+)?"
)
"""What has a value there, and is no parameter, and no equation."""
UNIT = re.compile(
    r"\d\s*(?:\\[,;:! ]|~|\s)*\\(?:mathrm|text(?:rm)?|rm|si|unit|operatorname)\s*\{([^{}]*)\}"
)
LONG = 40
TEXT_FORMULA = re.compile(
    r"^(?:[^\n]*=[^\n]*|(?![ \t]*(?:#|//|%)(?![#%\s]*\([\w.']{1,12}\)[ \t]*$))"
    r"(?![^\n]*[A-Za-z]{2,},? +[A-Za-z]{2,})[^\n]*[;\[(+*/^][^\n]*)$",
    re.MULTILINE,
)
"""Lines of a text that are no prose: with an equals sign, or lists without words, or a number of
an equation; a comment is prose without them."""
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
BEHIND = re.compile(r"(?<=\S)[ \t]*((?:(?<=[;{}\s])//|%|#).*)$", re.MULTILINE)
"""A comment behind code."""
HEADING = re.compile(r"^[ \t]*#+[ \t]*", re.MULTILINE)
COMMENT = re.compile(r"#|//|/\*|%|\"")
MARKED = "\u27e8= \u27e9"
"""What stands for a formula that is judged by itself."""
TURNED = re.compile(r"^\W*(?P<name>[^\W\d]\w*)[ \t]*=(?!=)(?=[^\n=]*\b(?P=name)\b)[^\n=]*$")
"""A name that is made another value of itself: theta = pi - theta."""
SUPPOSED = re.compile(r"(?<![\w.])[A-Za-z]{2,}[ \t]+[A-Za-z]\w*[ \t]*=(?!=)")
"""A word before a name that has a value: Assume u = 0."""
WITH_UNIT = re.compile(
    r"\w ?[\[(](?:deg\w*|rad\w*|°|[cmk]?m|kg|k?N|s|rpm|r?ev|min|h|[a-z]+ees)(?:/(?:s|min|h))?[\])]"
)
"""A name with its unit in brackets."""
DEFINING = re.compile(r"(?<![\w:])\w{1,20}: ?[A-Za-z]{3}")
"""What a line of a comment says that a name is."""
TWO_WORDS = re.compile(r"[A-Za-z]{2,},? +[A-Za-z]{2,}")


@dataclass(frozen=True)
class Sentence:
    """A sentence of a text.

    Attributes
    ----------
    marked : str
        With marks, what it says of names in one form.
    words : str
        As a reader sees it, with dots for long formulas.
    comment : bool
        Whether it is one of code.
    unread : bool
        Whether it is an equation in a comment, which nobody judges.
    """

    marked: str
    words: str
    comment: bool = False
    unread: bool = False


def sentences(text: str, notation: str, names: Collection[str]) -> Iterator[Sentence]:
    """Sentences of a text in order.

    Parameters
    ----------
    text : str
    notation : str
        Outside of LaTeX formulas stand on lines of their own, and names between words.
    names : collection of str
        Of the person, and the scene's.
    """
    text = text.translate(NO_MARKS)
    beside = notation == "comment"
    code = notation == "text" and CODE.search(text) is not None
    if notation == "latex":
        for said in of_latex(text):
            if any(row.search(said) for row in (EQUATION, TWO_WORDS, DEFINING)):
                yield Sentence(MARKED, said, comment=True, unread=True)
        text = TICKED.sub(lambda m: f"${m[1]}$" if m[1] in names else m[0], text)
        text = without_markup(marked(text))
    else:
        for block in () if beside else BLOCK.finditer(text):
            for said in map(str.strip, block[0].splitlines()):
                if EQUATION.search(said):
                    yield Sentence(MARKED, said.lstrip("#%/*= \t"), comment=True, unread=True)
        for beside_it in OF_LINE.finditer(text):
            each = " ".join(map(_mark, PLACE.findall(beside_it[0])))
            yield Sentence(each, beside_it[0].strip(" \t,;"))
        text = BEHIND.sub(r"\n\1", text)
        text = re.sub(r";[ \t]*(?=\S)", ";\n", text) if code else text
        for words in (LEADS, LABELLED):
            text = words.sub(r"\n\g<0>\n", text)
        mark = _formula if beside else _statement
        for line in TEXT_FORMULA.finditer(text):
            if (beside or COMMENT.match(line[0].lstrip())) and mark(line) == MARKED:
                said = line[0].strip().lstrip("#%/*! \t")
                if EQUATION.search(said):
                    yield Sentence(MARKED, said, comment=True, unread=True)
        text = TEXT_FORMULA.sub(mark, CODE.sub(mark, text))
        text = text if code else HEADING.sub("", text)
        text = WORD.sub(lambda m: _word(m, names), re.sub(r"\n(?!\n)", ".\n", text))
    for part in ENDS.split(QUESTION.sub(r" \g<0>.", text)):
        if one := " ".join(part.split()):
            comment = beside or (code and COMMENT.match(one) is not None)
            yield Sentence(one_form(one), words_of(one), comment)


def _formula(line: re.Match[str]) -> str:
    """A line of a comment with a formula: what has words, or a unit behind a name, is said."""
    return line[0] if WITH_UNIT.search(line[0]) or _spoken(line[0]) else MARKED


SPOKEN = (TWO_WORDS, SUPPOSED, FLAWED, FOREIGN_UNIT, DENIAL, TURNED)


def _spoken(line: str) -> bool:
    return any(words.search(line) for words in SPOKEN)


def _statement(line: re.Match[str]) -> str:
    """A line with a formula: it is judged by itself, but for what a comment says or defines."""
    comment = line[0].lstrip()
    said = COMMENT.match(comment) and (any(assigned_names(comment)) or _spoken(comment))
    return line[0] if said else MARKED


def bare(words: str) -> str:
    """Words without the marks of names and formulas."""
    return re.sub("\u27e8(?:= ?)?|\u27e9", "", words).strip()


def words_of(sentence: str) -> str:
    """The words of a sentence, with dots for equations and what is long."""
    return bare(FORMULA.sub(_shown, BRACES.sub(r"\1", sentence)))


def _shown(formula: re.Match[str]) -> str:
    """Dots, or what is short and no equation; of an equation its conditions."""
    parts = [part.strip() for part in BETWEEN.split(formula[1]) if CONDITION.search(part)]
    plain_value = VALUE.fullmatch(formula[1].strip()) or UNIT.search(formula[1])
    told = formula[1] and (plain_value or "=" not in formula[1]) and len(formula[1]) < LONG
    if parts or told:
        return ", ".join(parts) or formula[1]
    return "\u2026"


def marked(text: str) -> str:
    """A text in LaTeX with marks for names and formulas, and words of displays behind these."""
    try:
        text = text.translate(NO_MARKS)
        shown, every = _with_verbatim(text), blocks(prepared(text))
    except Refused:
        return ""  # nothing of it is read
    out, at = [], 0
    for block in every:
        formula = shown[block.start : block.end]
        out.append(DELIMITER.sub(" ", shown[at : block.start]))
        out.append("" if block.bare else _mark(formula))
        if not block.inline:
            out += [f". {m['words']} {_mark(m['value'])}. " for m in OF_DISPLAY.finditer(formula)]
            out += [f". {_inside(words)}. " for words in BESIDE.findall(SCRIPT.sub(" ", formula))]
        out += [f". {words}. " for words in _labels(formula)]
        at = block.end if block.closed else len(shown)
    return ("".join(out) + DELIMITER.sub(" ", shown[at:])).replace(SIGN, "%")


def _with_verbatim(text: str) -> str:
    """What is printed; what stands there as it is has no commands and no formulas."""
    shown = without_hidden(text)
    for at, words in verbatim(text):
        shown = shown[:at] + words.translate(PLAIN) + shown[at + len(words) :]
    return shown


def _labels(formula: str) -> Iterator[str]:
    """What labels of braces, equations and equals signs say; a demand is a question."""
    for label in LABEL.finditer(formula):
        sign = label[2]
        if sign is not None and set(sign.strip()) & set("?!"):
            yield "?"
        elif not SHORT_LABEL.fullmatch(words := label[1] or sign or ""):
            yield BESIDE.sub(r"\1", words)
    for name in CALLED.finditer(formula):
        if not SHORT_LABEL.fullmatch(name[1]):
            yield name[1]
    for start, end in labels(formula):
        if not SHORT_LABEL.fullmatch(words := formula[start:end]):
            yield BESIDE.sub(r"\1", words)


def _inside(words: str) -> str:
    """Words of a display, their formulas marked."""
    return re.sub(r"\$([^$]*)\$|\\\((.*?)\\\)", lambda m: _mark(m[1] or m[2] or ""), words)


def _mark(formula: str) -> str:
    names = [NAME.fullmatch(part) for part in COMMAS.split(formula)]
    if all(names):
        each = (re.sub("[{}]", "", name[1]) for name in names if name)
        return ", ".join(f"\u27e8{name}\u27e9" for name in each)
    words = " ".join(INSIDE.sub(" ", formula).split())
    return f"\u27e8= {words}\u27e9{'.' if words.endswith('.') else ''}"


def _word(word: re.Match[str], names: Collection[str]) -> str:
    name = plain(word[1])[0]
    if name not in names or name in ("a", "A", "I"):
        return word[0]
    return f"\u27e8{name}\u27e9{' is' if word[0].endswith(':') else ''}"

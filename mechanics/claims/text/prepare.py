"""A text before it is parsed: comments and continued lines blanked, place by place.

    [a -b; c d]  % mass matrix        ->        [a,-b; c d]

A blank between two entries of a MATLAB matrix becomes the comma that it stands for; no character
moves, so that messages name the right place.
"""

import re
from collections.abc import Iterator

from mechanics.claims.latex.bars import barred
from mechanics.claims.text.declarations import without_declarations
from mechanics.claims.text.line_continuation import on_one_line, sentences
from mechanics.claims.text.markdown import without_dashes, without_markdown
from mechanics.program.c.tokens import blanked

BLOCK = re.compile(
    r"#=(?!=).*?=#|^[ \t]*[%#]\{[ \t\r]*$.*?(?:^[ \t]*[%#]\}[ \t\r]*$|\Z)",
    re.DOTALL | re.MULTILINE,
)
"""A comment of Julia's, behind which its line goes on, and one of MATLAB's over lines."""
COMMENT = re.compile(r"[%#][^\n]*|\.\.\.[^\n]*\n|\\[ \t]*\r?\n")
OPERAND = (
    r"(?![ \t]*\(\w{1,12}\)[ \t]*$)(?=[^\n]*\w)"
    r"(?:[\d.()+*/^'; \t-]|(?<![A-Za-z])[A-Za-z]{1,2}(?![A-Za-z])"
    r"|(?<![A-Za-z])(?:alpha|beta|gamma|theta|phi|psi|omega|tau)(?![A-Za-z]))+$"
)
IN_TEXT = re.compile(
    rf"#[^\n]*|(?!(?<=[^\s;])%{OPERAND}|(?<=[^\s;][ \t])%{OPERAND})%[^\n]*"
    r"|\.\.\.[ \t]*(?:[%#][^\n]*)?\n(?=[ \t]*\S)|\\[ \t]*\r?\n",
    re.MULTILINE,
)
"""The same outside of MATLAB: three dots go on at the end of a line alone, and a % b may be a
remainder; either is refused where it is left."""
ENDS = re.compile(r"[\w)\]'.\u0307\u0308\u00b2\u00b3]")
STARTS = re.compile(r"[\w(\[.\uE002]")

SLASHES = re.compile(r"(?:^|(?<=;))[ \t]*//[^\n]*", re.MULTILINE)
"""A comment of Modelica or C++; elsewhere two slashes divide."""

IN_STARS = re.compile(r"/\*.*?\*/", re.DOTALL)

CODE = re.compile(r"^[ \t]*function\b(?![^\n]*\{[ \t]*$)", re.MULTILINE)
"""MATLAB and Julia, where a line goes on behind a sign, not before it."""

ANONYMOUS = re.compile(r"(?<==)[ \t]*@\([\w, ~]*\)")
"""The head of a function without a name."""
BRACES = re.compile(
    r"^[ \t]*function\b[^\n]*\{[ \t]*$|^[ \t]*\}[ \t;]*$|^[ \t]*(?:let|const|var)\b(?=[^\n]*=)"
    r"|\bMath\.(?=[a-z])|(?<=[;{}])[ \t]*//[^\n]*",
    re.MULTILINE,
)
"""What JavaScript has around formulas."""
PROSE = re.compile(
    r"^(?!\s*(?:if|for|while|else|elseif|elif|switch|case|otherwise|do|until|end|function|return"
    r"|global|def|class|import|from|when)\b)[ \t]*[^\W\d_]\w*"
    r"(?:[ ,\-\u2019'\"]+\(?_?[^\W\d_]\w*[).:]*){2,}[ .:;!?)]*$",
    re.MULTILINE,
)
"""A line of words alone, which are no factors: With theta measured from the horizontal:"""

GLOSSARY = re.compile(
    r"^[ \t]*[^\W\d]\w{0,20}[ \t]*:(?=[^\n]*\b(?:of|the|in|on|by|from|to|with|for)\b)"
    r"(?:[ \t,\-]+\(?\w+[).,]*){2,}[ \t]*$"
    r"|^[ \t]*[a-zA-Z]{3,}(?:[ \t]+\w+){1,5}[ \t]*:[ \t]*(?:\w+|\([^()=\n]{1,30}\))[ \t]*$",
    re.MULTILINE,
)
"""What a name means, in words: m: mass of the cart; or mass of the cart: m."""
LEADS = re.compile(
    r"^[ \t]*(?:where|here|with|and|then|hence|thus|so|therefore)[ \t]*[,:]?[ \t]*$"
    r"|(?<=[\w)])[ \t]+(?:then|hence|thus|so|therefore|where|with)[ \t]*$"
    r"|^[ \t]*(?:[^\W\d_]+[ \t]+){2,8}where[ \t]+(?=\w+(?:\(\w\))?[ \t]*=)|(?<=[\w)]):[ \t]*$"
    r"|(?<=[\w)\]])[ \t]+\((?=[^()\n]*\b(?:of|the|in|on|is|for|from)\b)[a-z][\w ,'-]*\)[ \t]*$"
    r"|^[ \t]*\*\*[^\W\d_][\w ,'-]*\*\*[ \t]*(?:\([\w ,'-]*\))?[ \t]*:[ \t]*$"
    r"|(?:^|(?<=[,;]))[ \t]*(?:the[ \t]+)?(?:(?:angular|normal|static)[ \t]+)?"
    r"(?:acceleration|velocity|speed|force|friction|tension|torque|moment|momentum|reaction)[ \t]+"
    r"(?=[^\W\d]\w*'*[ \t]*=(?!=))",
    re.MULTILINE | re.IGNORECASE,
)
"""Words between equations, behind them, and before what they name: friction f = ..."""
CALLED = re.compile(
    r"^(?P<before>[ \t]*)(?:the[ \t]+)?(?:(?P<kinetic>kinetic)|(?P<potential>potential)|total"
    r"|mechanical)[ \t]+energy(?=[ \t]*=)",
    re.MULTILINE | re.IGNORECASE,
)
"""An energy by its name in words, on the left side."""
CJK = re.compile(r"[\u3000-\u30ff\u3400-\u9fff\uac00-\ud7a3\uff0c\uff1a]+:?")
"""Words and stops of languages in which no formula is written."""
OVERDOTS = re.compile(r"(?<=[\u03b1-\u03c9])\.{1,2}(?![\w.])")
INSIDE = re.compile(r"[\u03b1-\u03c9]\.{1,2}[)^=+*]")
"""Dots that stand behind a Greek letter, for want of a place above it: mr^2θ.. + mgr sinθ = 0."""
GROUP = re.compile(
    r"(?<=[\w)\u00b2\u00b3])(?P<gap>[ \t]+)\[(?P<sum>[^\[\],;:=\n]*[ ][-+][ ][^\[\],;:=\n]*)\]"
)
"""A sum in square brackets behind a factor, which is no index: m [a + b]."""
GLUED = re.compile(
    r"(?<=[\w)\u00b2\u00b3])(?P<gap>)\[(?P<sum>(?=[^\[\]\n]*(?:(?:sin|cos|tan)\(|[\u00b2\u00b3^]))"
    r"[^\[\],;:=\n]*[ ][-+][ ][^\[\],;:=\n]*)\]"
)
"""The same without a blank, where it holds a power, a sine or a cosine: m[a^2 + b]."""
DOTTED = re.compile(r"(?<![\w.])(d{1,2})ot[ \t]+([^\W\d]\w*)(?![\w(])")
"""AsciiMath: ddot theta."""

LEIBNIZ = re.compile(
    r"(?<![\w.])d(?:\^?2|\u00b2)[ \t]*\(?[ \t]*([^\W\d]\w*)[ \t]*\)?/[ \t]*d[ \t]?t(?:\^?2|\u00b2)"
)
"""A second derivative with blanks or brackets in it: d^2 theta/dt^2."""
RATE = re.compile(r"(?<![\w.])d/dt(?=[ \t]*\()")
"""The rate of a bracket, which Modelica calls der."""

OPERATOR = re.compile(
    r"(?<![\w.])d(?P<two>\^?2|\u00b2)?/dt(?(two)(?:\^?2|\u00b2))[ \t]+(?P<of>[^\W\d]\w*)"
    r"(?![\w(\[.'])"
)
"""A derivative before its name: d^2/dt^2 theta."""
SQUARE_RATE = re.compile(r"(?<![\w.])d/dt[ \t]*\[(?P<of>[^\[\]\n]*)\]")
"""The rate of a square bracket."""
BY_RATE = re.compile(
    r"(?<![\w.])d(?P<of>[A-Z]\w{0,20})/d"
    r"(?:\[[ \t]*d(?P<q>\w+)/dt[ \t]*\]|\([ \t]*d(?P<p>\w+)/dt[ \t]*\))"
)
"""A derivative by a rate, which is a partial one: dL/d[dtheta/dt]."""

TOOLKIT = re.compile(
    r"(?<![\w.])D(?:t|Dt|2|ifferential)?\(|@(?:variables|parameters|named|mtk\w+)\b"
)
"""ModelingToolkit, in which ~ is an equals sign; elsewhere it is none."""

OVER_TIMES = re.compile(
    r"(?<=\w\()(?:[ \t]*(\d+)[ \t]*,[ \t]*:[ \t]*|:[ \t]*,[ \t]*(\d+)[ \t]*)(?=\))"
)
"""A row or column of states at many times, x(3, :), which is x(3) at each of them."""


def comments(text: str) -> Iterator[tuple[int, str]]:
    """What `prepared` blanks though it may hold a formula: its place, and its words."""
    for words in (COMMENT, SLASHES, BLOCK, IN_STARS):
        for match in words.finditer(text):
            yield match.start(), match[0].lstrip("%#/ \t")


def prepared(text: str) -> str:
    """The text with blanks for comments and for ends of lines inside round brackets."""
    text = text if CODE.search(text) else without_dashes(text)
    text = CJK.sub(lambda m: " " * len(m[0]), without_markdown(text))
    text = CALLED.sub(_letter, text)
    if INSIDE.search(text):
        text = OVERDOTS.sub(lambda m: "'" * len(m[0]), text)
    for words in (ANONYMOUS, BRACES):
        text = words.sub(lambda m: " " * len(m[0]), text)
    for words in (GLOSSARY, LEADS):
        text = words.sub(lambda m: " " * len(m[0]), text)
    for group in (GROUP, GLUED):
        text = group.sub(lambda m: f"{m['gap']}({m['sum']})", text)
    text = DOTTED.sub(lambda m: (m[2] + "'" * len(m[1])).ljust(len(m[0])), text)
    text = LEIBNIZ.sub(lambda m: f"{m[1]}''".ljust(len(m[0])), text)
    text = _derivatives(text)
    text = PROSE.sub(lambda m: " " * len(m[0]), RATE.sub("der ", text))
    text = BLOCK.sub(lambda m: blanked(m[0]), text)
    code = CODE.search(text) is not None
    for words in (COMMENT if code else IN_TEXT, SLASHES):
        text = words.sub(lambda m: " " * len(m[0]), text)
    text = OVER_TIMES.sub(lambda m: (m[1] or m[2]).ljust(len(m[0])), text)
    text = barred(without_declarations(text))
    if TOOLKIT.search(text):
        text = text.replace("~", "=")
    text = on_one_line(sentences(text), code)
    out = list(text)
    open_brackets: list[str] = []
    for i, character in enumerate(text):
        if character in "([":
            open_brackets.append(character)
        elif character in ")]" and open_brackets:
            open_brackets.pop()
        elif character == "\n" and open_brackets and _blank(text, i, open_brackets):
            out[i] = " "
        elif character in " \t" and open_brackets[-1:] == ["["] and _between(text, i):
            out[i] = ","
    return "".join(out)


def _derivatives(text: str) -> str:
    """The text with one spelling of derivatives of a bracket, by a rate, and before a name."""
    functions = {match["of"] for match in BY_RATE.finditer(text)}
    text = BY_RATE.sub(
        lambda m: f"\u2202{m['of']}/\u2202{m['q'] or m['p']}'".ljust(len(m[0])), text
    )
    for of in functions:  # the other derivatives of what has one by a rate are partial, too
        text = re.sub(rf"(?<![\w.])d{of}/d(?!t\b)(?=[^\W\d])", f"\u2202{of}/\u2202", text)
    text = SQUARE_RATE.sub(lambda m: f"d/dt({m['of']})".ljust(len(m[0])), text)
    return OPERATOR.sub(lambda m: (m["of"] + "'" * (2 if m["two"] else 1)).ljust(len(m[0])), text)


def _letter(match: re.Match[str]) -> str:
    """The letter of an energy that words name."""
    letter = "E_k" if match["kinetic"] else "E_p" if match["potential"] else "E"
    return f"{match['before']}{letter}".ljust(len(match[0]))


def _blank(text: str, i: int, open_brackets: list[str]) -> bool:
    """Whether the end of a line means nothing: in round brackets, or beside a comma."""
    if open_brackets[-1] == "(":
        return True
    before, after = text[:i].rstrip()[-1:], text[i:].lstrip()[:1]
    return before in ",[;(" or after in ",]" or len(open_brackets) > 1


def _between(text: str, i: int) -> bool:
    """Whether a blank stands between two entries of a matrix."""
    if i == 0 or not ENDS.fullmatch(text[i - 1]):
        return False
    rest = text[i:].lstrip(" \t")
    if not rest:
        return False
    if rest[0] in "+-":
        # MATLAB: [a -b] has two entries, [a - b] one.
        return len(rest) > 1 and rest[1] not in " \t"
    return bool(STARTS.fullmatch(rest[0]))

"""A person's C in plainer words, line by line the same: doubles only, arrays for structs.

    sinf(0.5f*x)                                   ->  sin (0.5 *x)
    typedef struct { double m, l; } par;  p->l     ->  p[1]        with p a const double *

What is judged is exact mathematics, so precision does not matter to it; a struct of numbers is an
array whose entries have names.
"""

import re
from dataclasses import dataclass
from fractions import Fraction

from numpy import float32

from mechanics.claims.code.c.library import NAMES
from mechanics.claims.code.unpacking import Apart
from mechanics.errors import ExpressionError
from mechanics.program.c.library import FUNCTIONS, FUSED, SINCOS
from mechanics.program.c.tokens import TOKEN, blanked

SINGLE = (
    {name: known.kind for name, known in FUNCTIONS.items()} | SINCOS | FUSED
    | {f"{name}f": "float" for name in NAMES if not name.startswith("is")}
)  # fmt: skip
"""Functions of the C library, and what they take."""

ROUNDED = (
    "is rounded to single precision among doubles, which is no exact formula: write it as a double"
)
LEAPS = re.compile(
    r"\b(?:if|while|switch|(?:std::)?(?:l?l?r?(?:ound|int)|floor|ceil|trunc|fmod|modf|remainder"
    r"|signbit|copysign|nextafter|isnan|isinf|isfinite)[fl]?\s*\()|[?]|[<>]=|[=!]=|&&|[|][|]"
    r"|(?<![<>-])[<>](?![<>])"
)
"""What a small change may make another one: it is decided, or rounded to an integer."""
LOOP = re.compile(r"\bfor\s*\([^(){}]*\)")
ANGLES = re.compile(
    r"^[ \t]*#[ \t]*include[^\n]*|<<|>>|->"
    r"|\b(?:template|vector|valarray|array|Matrix|Vector|Array|static_cast)"
    r"\s*<[\w\s:,*&]*>",
    re.MULTILINE,
)
"""Where < and > compare nothing."""
NUMBERS = re.compile(r"(?<![\w.])(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
SMALLEST, GREATEST = 1e-6, 1e6
"""Of numbers beside which single precision keeps what is added."""
MOST_EXACT = 2**24
"""From here on a float has no room for a one beside it."""
SINGLE_NOTE = "single precision (float, sinf, 0.5f) is read as exact numbers"

CALLED = re.compile(r"\s*\(")
STRUCT = re.compile(
    r"(?P<typedef>\btypedef\s+)?\bstruct\s*(?P<tag>\w*)\s*\{(?P<fields>[^{}]*)\}\s*(?P<name>\w*)\s*;"
)
SINGLE_NUMBER = re.compile(r"(?<![\w.])((?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)[fF]\b")
DEFINE = re.compile(r"#[\s\\]*define[\s\\]+(\w+)")
SINGLE_CALLS = sorted(name for name in SINGLE if name.endswith("f") and name not in NAMES)
LITERAL = r"(?<![\w.])(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
TO_SINGLE = re.compile(
    rf"\b(?:{'|'.join(SINGLE_CALLS)})\s*\("
    r"|\(\s*float\s*\)|\bfloat\s*\(|\bfloat\s+(?:const\s+)?\w+\s*(?:=(?!=)|\{)"
    r"|<\s*(?:const\s+)?float\b|\b(?:Row)?(?:Vector|Matrix|Array)\w*[\dX]f\b"
    rf"|\b(?:auto|decltype)\b[^;]*?{LITERAL}[fF]\b"
    rf"|{LITERAL}[fF][\s()]*[-+*/][\s()]*(?:{LITERAL}[fF]|\d+(?![\w.]))"
    rf"|(?<![\w.])\d+[\s()]*[-+*/][\s()]*{LITERAL}[fF]\b"
    r"|(?<![\w.])(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)[fF]\b"
)
"""What makes a number one of single precision."""
ALIAS = re.compile(
    r"(?:\btypedef\s+(?:const\s+)?float\s+(?:const\s+)?(?P<typedef>\w+)\s*;"
    r"|^[ \t]*#[ \t]*define[ \t]+(?P<macro>\w+)[ \t]+(?:const[ \t]+)?float\b"
    r"|\busing\s+(?P<using>\w+)\s*=\s*float\s*;)",
    re.MULTILINE,
)
"""Other words for float."""
SINGLE_NAMES = re.compile(r"\bfloat\b((?:[\s*&]*\w+(?:\s*\[[^][]*\])*\s*(?:,|(?=[;)=({])))+)")
"""Names that are declared so."""
TAKES = re.compile(
    r"\b(\w+)\s*\([^()]*(?:\bfloat\b(?!\s*[*&])|\bconst\s+float\s*&|\bfloat\s+const\s*&)[^()]*\)"
    r"\s*(?:const\s*)?\{"
)
"""A function of such a number, which others may call."""
CHANGE = (
    r"\b{0}\b\s*(?:\[[^][]*\]\s*)*(?:[-+*/]?=(?!=)|\+\+|--|\{{)"
    r"|\bfloat\s+{0}\s*\([^()]*(?:[\d.]+[^()]*\)\s*;|\)\s*\{{)"
)
"""What gives one another value."""
WORDS = frozenset({"float", "double", "const", "struct", "typedef"})

MOST, LARGEST = 8, 64
"""Structs, and their fields."""

FIELDS = re.compile(r"\s*double\s+(\w+(?:\s*,\s*\w+)*)\s*")


@dataclass(frozen=True)
class Plain:
    """A file in plainer words.

    Attributes
    ----------
    text : str
    apart : dict of str to Apart
        Names of the entries of what was a struct.
    notes : tuple of str
    rounded : str
        What is rounded to single precision among doubles; empty for nothing.
    """

    text: str
    apart: dict[str, Apart]
    notes: tuple[str, ...]
    rounded: str = ""


def plain(text: str, origin: str, whole: str = "") -> Plain:
    """The file in doubles and arrays.

    Parameters
    ----------
    text, origin : str
    whole : str
        As its author has it, where doubles of `text` may be none of his; else `text`.

    Raises
    ------
    ExpressionError
        For a macro that gives words another meaning, a struct of other things than numbers, or one
        that is no argument, by line and column.
    """
    doubled, notes = in_doubles(text)
    records = re.search(r"\bstruct\b", doubled) is not None
    for name in DEFINE.findall(_blank(text)) if records or notes else ():
        if name in SINGLE or name in WORDS:
            raise ExpressionError(f"{origin}: {name} is a word of C, and a macro here: remove it")
    doubles = re.search(r"\bdouble\b", _blank(whole or text)) is not None
    rounded = made_single(text) if notes and doubles else None
    if rounded and not smooth(text):
        raise ExpressionError(f"{_place(text, rounded.start(), origin)}: {rounded[0]} {ROUNDED}")
    words = " ".join(rounded[0].split()) if rounded else ""
    if not records:
        return Plain(doubled, {}, notes, words)
    apart: dict[str, Apart] = {}
    structs = list(STRUCT.finditer(_blank(doubled)))
    if len(structs) > MOST:
        raise ExpressionError(f"{origin}:1: it has {len(structs)} structs: {MOST} at most")
    for match in reversed(structs):
        doubled = _as_arrays(doubled, match, origin, apart)
    return Plain(doubled, apart, notes, words)


def in_doubles(text: str) -> tuple[str, tuple[str, ...]]:
    """The text without single precision, and what is said of that."""
    for one in SINGLE_NUMBER.finditer(_blank(text)):
        if float(one[1]) >= MOST_EXACT:
            raise ExpressionError(
                f"{one[0]}: single precision loses what is added to it: write a double"
            )
    doubled = re.sub(TOKEN, _doubled, text)
    return doubled, (SINGLE_NOTE,) if doubled != text else ()


def made_single(text: str) -> re.Match[str] | None:
    """What is no number of single precision, and made one beside doubles: ``0.1f``, a cast."""
    text = with_float(_blank(text))
    if not re.search(r"\bdouble\b", text):
        return None
    for one in TO_SINGLE.finditer(text):
        if one["number"] is None or Fraction(one["number"]) != float32(float(one["number"])):
            return one
    for one in TAKES.finditer(text):
        if len(re.findall(rf"\b{one[1]}\s*\(", text)) > 1:
            return one
    for names in SINGLE_NAMES.findall(text):
        for name in re.findall(r"(\w+)\s*(?:\[[^][]*\]\s*)*(?:,|$)", names):
            if (change := re.search(CHANGE.format(name), text)) is not None:
                return change
    return None


def with_float(text: str, whole: str = "") -> str:
    """The text, where words that a file has for float are that."""
    for alias in ALIAS.finditer(_blank(whole or text)):
        word = alias[alias.lastgroup or 0]
        text = ALIAS.sub(lambda m: blanked(m[0]), text)
        text = re.sub(rf"\b{word}\b", "float", text)
    return text


def smooth(text: str) -> bool:
    """Whether roundings of its numbers change little: nothing is decided or rounded to an integer.

    Where it is not plain that they do, it is not.
    """
    text = ANGLES.sub(" ", LOOP.sub(" ", _blank(text)))
    numbers = [float(number) for number in NUMBERS.findall(text)]
    far = any(number and not SMALLEST <= number <= GREATEST for number in numbers)
    return not far and LEAPS.search(text) is None


def _doubled(match: re.Match[str]) -> str:
    """A token in double precision, as long as it was."""
    token = match[0]
    if match.lastgroup == "number" and not token.lower().startswith("0x"):
        return token[:-1] + " " if token[-1] in "fF" else token
    if match.lastgroup != "name":
        return token
    if token == "float":
        return "double"
    called = SINGLE.get(token) == "float" and CALLED.match(match.string, match.end())
    return token[:-1] + " " if called else token


def _blank(text: str) -> str:
    """The text with blanks for comments and strings; all keeps its place."""
    return re.sub(
        TOKEN,
        lambda m: blanked(m[0]) if m.lastgroup in ("comment", "string") else m[0],
        text,
    )


def _as_arrays(text: str, struct: re.Match[str], origin: str, apart: dict[str, Apart]) -> str:
    """The text without a struct, and with arrays for its arguments."""
    kind = struct["name"] if struct["typedef"] else f"struct {struct['tag']}"
    fields = _fields(struct, kind, _place(text, struct.start(), origin))
    head, tail = text[: struct.start()], text[struct.end() :]
    gone = blanked(struct[0])
    words = r"\s+".join(re.escape(word) for word in kind.split())
    names = [words, rf"struct\s+{struct['tag']}"] if struct["tag"] else [words]
    uses = re.compile(rf"(?P<const>\bconst\s+)?\b(?:{'|'.join(names)})\b\s*(?P<star>\*?)\s*"
                      r"(?:const\b\s*)?(?P<name>\w*)\s*(?P<end>.)")  # fmt: skip
    blank = _blank(tail)
    variables: dict[str, None] = {}
    pieces, at = [], 0
    for use in uses.finditer(blank):
        if not use["name"] or use["end"] not in ",)":
            raise ExpressionError(
                f"{_place(text, struct.end() + use.start(), origin)}: {kind} is known here as the"
                " type of an argument only: pass numbers and arrays"
            )
        name = use["name"]
        written = re.search(rf"\b{name}\s*(?:->|\.)\s*\w+\s*(?:[-+*/]?=(?!=)|\+\+|--)", blank)
        if name not in variables and (
            len(variables) == MOST
            or re.search(rf"\bdouble\s*\*?\s*(?:const\s*)?{name}\b", blank)
            or (written and not use["star"])
        ):
            raise ExpressionError(
                f"{_place(text, struct.end() + use.start(), origin)}: {name} is a {kind} that is"
                " changed, or of two types: rename it, or pass numbers and arrays"
            )
        const = "" if written and use["star"] and not use["const"] else "const "
        pieces += [tail[at : use.start()], f"{const}double *{name}{use['end']}"]
        at = use.end()
        variables[name] = None
    tail = "".join((*pieces, tail[at:]))
    for name in variables:
        if name in apart:
            raise ExpressionError(f"{origin}:1: {name} is of two structs: name one otherwise")
        places = {k: {field} for k, field in enumerate(fields)}
        apart[name] = Apart(places, size=len(fields), fields=True)
        for k, field in enumerate(fields):
            tail = re.sub(rf"\b{name}\s*(?:->|\.)\s*{field}\b", f"{name}[{k}]", tail)
    return head + gone + tail


def _fields(struct: re.Match[str], kind: str, place: str) -> list[str]:
    """Names of the numbers of a struct."""
    fields: list[str] = []
    for part in struct["fields"].split(";"):
        found = FIELDS.fullmatch(part)
        if part.strip() and found is None:
            raise ExpressionError(
                f"{place}: {kind} has {part.strip()!r}: structs of"
                " double alone are known: pass numbers and arrays"
            )
        fields += [name.strip() for name in found[1].split(",")] if found else []
    if not 0 < len(fields) <= LARGEST:
        raise ExpressionError(f"{place}: {kind} has {len(fields)} fields: 1 to {LARGEST} are known")
    return fields


def _place(text: str, at: int, origin: str) -> str:
    before = text[:at].split("\n")
    return f"{origin}:{len(before)}:{len(before[-1]) + 1}"

"""Constants of a file of C, declared once more in each function that uses them.

    static const double g = 9.81;        double f(double x) {...g...}
    ->                                   double f(double x) { const double g = 9.81; ...g...}

A static number that nothing changes is one, too, and so is a macro whose value is in brackets:
``#define TOTAL (M + m)``. What others may change is refused elsewhere.
"""

import re
from collections.abc import Iterable

from mechanics.claims.brackets import depth
from mechanics.errors import ExpressionError
from mechanics.program.c.tokens import blanked

DECLARED = re.compile(
    r"(?P<words>\b(?:(?:static|const|double|float)\s++){2,5}+)"
    r"(?P<rest>\w++\s*+(?:\[[^][;]*+\])?\s*+=[^;{}]*+(?:\{[^;{}]*+\})?[^;{}]*+);"
)
MACRO = re.compile(
    r"^[ \t]*#[ \t]*define[ \t]+(\w+)[ \t]+(\((?:[^()\n]|\([^()\n]*\))*\))[ \t]*\r?$", re.MULTILINE
)
WORD = re.compile(r"(?<![\w.])[A-Za-z_]\w*(?!\s*\()")
NAME = re.compile(r"(\w++)\s*+(?:\[[^][]*+\])?\s*+=")
MOST, LONGEST = 64, 100_000
"""Constants, and characters with them in all functions."""


def with_constants(text: str, origin: str, integers: Iterable[str] = ()) -> str:
    """The text with constants in functions; it has no comments that hold code.

    Parameters
    ----------
    text, origin : str
    integers : iterable of str
        Names that are integers in C: macros that are made of them are no doubles.
    """
    text = _of_macros(text, {*integers})
    found = [m for m in DECLARED.finditer(text) if depth(text, m.start()) == 0]
    found = [m for m in found if "const" in m["words"].split() or "[" not in m["rest"]]
    found = [m for m in found if len({"double", "float"} & set(m["words"].split())) == 1]
    if not found:
        return text
    if len(found) > MOST:
        raise ExpressionError(f"{origin}:1: it has {len(found)} constants: {MOST} at most")
    constants: dict[str, str] = {}
    for match in found:
        names = [m[1] for m in NAME.finditer(re.sub(r"\{[^}]*\}", "{}", match["rest"]))]
        rest = text[: match.start()] + text[match.end() :]
        for name in names:
            if "const" not in match["words"].split() and re.search(
                rf"(?:&\s*|\+\+\s*|--\s*)\b{name}\b|\b{name}\b\s*(?:\[[^]]*\]\s*)?"
                r"(?:[-+*/]?=(?!=)|\+\+|--)", rest,
            ):  # fmt: skip
                break
        else:
            words = " ".join(match["rest"].split())
            kind = "float" if "float" in match["words"].split() else "double"
            constants |= dict.fromkeys(names, f" const {kind} {words};")
            gone = blanked(match[0])
            text = text[: match.start()] + gone + text[match.end() :]
    return _inserted(text, constants, origin)


def _of_macros(text: str, integers: set[str]) -> str:
    """The text with macros that name a formula in constants, declared where they are defined."""
    macros = {m[1]: m[2] for m in MACRO.finditer(text) if WORD.search(m[2])}
    while whole := {n for n, value in macros.items() if integers & {*WORD.findall(value)}}:
        integers = integers | whole
        macros = {name: value for name, value in macros.items() if name not in whole}
    if not macros or re.search(r"#[ \t]*(?:if|undef)", text):
        return text
    for start, end in _bodies(text):
        head = text[text.rfind(")", 0, start) - _length(text, start) : start]
        passed = {*re.findall(r"\w+", head)}
        used = _used(text[start:end], macros)
        words = {word for name in used for word in WORD.findall(macros[name])}
        again = [name for name in used if re.search(rf"\b(?:double|float|int)\s+{name}\b", text)]
        if again or not words <= passed | macros.keys():
            return text  # what a macro is made of is another thing in each function
    return MACRO.sub(
        lambda m: f"static const double {m[1]} = {m[2]};" if m[1] in macros else m[0], text
    )


def _inserted(text: str, constants: dict[str, str], origin: str) -> str:
    pieces, at = [], 0
    for start, end in _bodies(text):
        wanted = _used(text[start:end], constants)
        if not wanted:
            continue
        head = text[text.rfind(")", 0, start) - _length(text, start) : start]
        words = set(re.findall(r"\w+", head))
        own = [name for name in constants if name in words]
        lines = dict.fromkeys(constants[name] for name in wanted if name not in own)
        for line in lines:
            hidden = [n for n in own if re.search(rf"=[^=]*\b{n}\b", line)]
            if hidden:
                place = text.count("\n", 0, start) + 1
                raise ExpressionError(
                    f"{origin}:{place}: {hidden[0]} is an argument here and a constant of the file"
                    " that another one is made of: rename it"
                )
        pieces += [text[at : start + 1], *lines]
        at = start + 1
    done = "".join((*pieces, text[at:]))
    if len(done) > LONGEST:
        raise ExpressionError(f"{origin}:1: its constants are used too often: pass arguments")
    return done


def _used(body: str, constants: dict[str, str]) -> list[str]:
    """Constants that a body uses, and those that these are made of, in their order."""
    words = body
    found: set[str] = set()
    while True:
        more = (constants.keys() & re.findall(r"\w+", words)) - found
        if not more:
            return [name for name in constants if name in found]
        found |= more
        words = " ".join(constants[name] for name in sorted(more))


def _bodies(text: str) -> list[tuple[int, int]]:
    """Where functions open and close."""
    found, depth, start = [], 0, 0
    for match in re.finditer(r"[{}]", text):
        if match[0] == "{":
            if depth == 0:
                start = match.start()
            depth += 1
        else:
            depth -= 1
            if depth == 0 and text[:start].rstrip().endswith(")"):
                found.append((start, match.end()))
    return found


def _length(text: str, start: int) -> int:
    """How many characters the arguments before a body have."""
    end = text.rfind(")", 0, start)
    depth = 0
    for at in range(end, -1, -1):
        depth += (text[at] == ")") - (text[at] == "(")
        if depth == 0:
            return end - at
    return 0

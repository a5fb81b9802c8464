"""Macros with arguments, as the preprocessor of C replaces them; lines keep their numbers.

    #define SQ(x) ((x)*(x))        SQ(a + b)  ->  ((a + b)*(a + b))        textually, so x*x is not

What is left of a definition is ``#define SQ SQ``, so that conditions find its name.
"""

import re
from dataclasses import dataclass

from mechanics.claims.code.c.person import GUARD, without_comments
from mechanics.errors import ExpressionError, InputError
from mechanics.program.c.tokens import Line, tokens

DEFINE = re.compile(r"[ \t\v]*#[ \t\v]*define[ \t\v]+(\w+)\(([^()]*)\)(.*)", re.DOTALL)
OTHER = re.compile(r"([ \t\v]*#[ \t\v]*define[ \t\v]+\w+)\b(?!\()(.*)", re.DOTALL)
DEFINED = re.compile(r"[ \t\v]*#[ \t\v]*define[ \t\v]+(\w+)\b(.*)", re.DOTALL)
CONDITION = re.compile(r"[ \t\v]*#[ \t\v]*(ifdef|ifndef|if|endif)\b[ \t\v]*(\w*)")

KEYWORDS = re.compile(
    r"double|float|int|long|short|char|signed|unsigned|bool|void|const|constexpr|static|inline"
    r"|struct|auto|return|if|else|for|while|do|switch|case|default|break|continue|goto|sizeof"
)
"""Words of C and C++ that a reader takes as they are."""

MOST, DEEPEST = 20_000, 40
"""Tokens that macros make, and macros in macros."""


@dataclass(frozen=True)
class Macro:
    """A macro with arguments."""

    parameters: tuple[str, ...]
    body: Line


def keeps_keywords(text: str, origin: str) -> None:
    """Refuse a file whose macros give words of the language another meaning.

    Raises
    ------
    InputError
    """
    for number, line in enumerate(without_comments(text).split("\n"), 1):
        found = DEFINED.match(line)
        if found and KEYWORDS.fullmatch(found[1]) and found[2].strip(" \t\v") != found[1]:
            raise InputError(
                f"{origin}, line {number}, column 1: {found[1]} is a word of C, and a macro"
                " gives it another meaning: remove the macro"
            )


def without_macros(text: str, origin: str) -> str:
    """The text with uses of macros replaced.

    Raises
    ------
    ExpressionError
        For a macro that is defined twice or under a condition, or used with other arguments.
    """
    keeps_keywords(text, origin)
    if not re.search(r"#[ \t\\\n]*define[ \t\\\n]+\w+\(", text):
        return text
    macros: dict[str, Macro] = {}
    open_ones: list[str] = []
    made = [0]
    chunk: list[str] = []
    out: list[str] = []
    for number, line in enumerate(without_comments(text).split("\n"), 1):
        if not line.lstrip(" \t\v").startswith("#"):
            chunk.append(line)
            continue
        if chunk:
            out.append(_replaced("\n".join(chunk), macros, f"{origin}:{number}", made))
            chunk.clear()
        out.append(_directive(line, macros, open_ones, f"{origin}:{number}", made))
    if chunk:
        out.append(_replaced("\n".join(chunk), macros, origin, made))
    return "\n".join(out).replace(" \v", "\\\n")


def _directive(
    line: str, macros: dict[str, Macro], open_ones: list[str], where: str, made: list[int]
) -> str:
    """Learn what a directive defines; what is left of it."""
    if condition := CONDITION.match(line):
        word, name = condition.groups()
        if word == "endif":
            del open_ones[-1:]
        else:
            open_ones.append(name if word == "ifndef" else "")
        return line
    if other := OTHER.fullmatch(line):
        return other[1] + " " + _replaced(other[2], macros, where, made)
    found = DEFINE.fullmatch(line)
    if found is None:
        return line
    name, head, body = found.groups()
    if not all(c == name or GUARD.fullmatch(c) for c in open_ones):
        raise ExpressionError(f"{where}: macro {name} has arguments and stands under a condition:"
                              " write a function")  # fmt: skip
    parameters = tuple(p.strip(" \t\v") for p in head.split(",")) if head.strip(" \t\v") else ()
    content = [t for t in tokens(body.replace("\v", " "), where) if t[0] != "newline"]
    if not all(p.isidentifier() for p in parameters) or any("#" in text for _, text in content):
        raise ExpressionError(f"{where}: macro {name} is not supported: write a function")
    macro = Macro(parameters, [t for t in content if t[0] != "space"])
    if macros.setdefault(name, macro) != macro:
        raise ExpressionError(f"{where}: macro {name} is defined twice")
    return f"#define {name} {name}" + " \v" * line.count("\v")


def _replaced(text: str, macros: dict[str, Macro], where: str, made: list[int]) -> str:
    """A text with macros replaced; what a call has of ends of lines stands behind it."""
    if macros.keys().isdisjoint(re.findall(r"\w+", text)):
        return text
    joined = text.count("\v")
    found = _expanded(tokens(text.replace("\v", " "), where), macros, where, (), made)
    return "".join(t for _, t in found) + " \v" * joined


def _expanded(
    line: Line, macros: dict[str, Macro], where: str, inside: tuple[str, ...], made: list[int]
) -> Line:
    result: Line = []
    at = 0
    while at < len(line):
        kind, text = line[at]
        start = _bracket(line, at + 1)
        if kind != "name" or text not in macros or text in inside or start is None:
            result.append(line[at])
            at += 1
            continue
        arguments, end = _arguments(line, start, where)
        macro = macros[text]
        if len(arguments) != len(macro.parameters) and not (
            macro.parameters == () and [t for t in arguments[0] if t[0] not in BLANK] == []
        ):
            raise ExpressionError(
                f"{where}: macro {text} takes {len(macro.parameters)} arguments, {len(arguments)}"
                " found"
            )
        given = {
            p: _expanded(_solid(a), macros, where, inside, made)
            for p, a in zip(macro.parameters, arguments, strict=False)
        }
        body: Line = []
        for token in macro.body:
            body += [("space", " "), *given.get(token[1], [token]), ("space", " ")]
        made[0] += len(body)
        if made[0] > MOST or len(inside) > DEEPEST:
            raise ExpressionError(
                f"{where}: macros expand to more than {MOST} tokens: write functions"
            )
        result += _expanded(body, macros, where, (*inside, text), made)
        result += [token for token in line[at:end] if token[0] == "newline"]
        at = end
    return result


BLANK = ("space", "newline")


def _solid(line: Line) -> Line:
    return [("space", " ") if kind == "newline" else (kind, text) for kind, text in line]


def _bracket(line: Line, at: int) -> int | None:
    """Where the bracket of a call opens; None where there is none."""
    while at < len(line) and line[at][0] in BLANK:
        at += 1
    return at if at < len(line) and line[at][1] == "(" else None


def _arguments(line: Line, start: int, where: str) -> tuple[list[Line], int]:
    """What stands between the commas of a call, and where it ends."""
    found: list[Line] = [[]]
    depth = 0
    for at in range(start, len(line)):
        text = line[at][1]
        depth += (text == "(") - (text == ")")
        if depth == 0:
            return found, at + 1
        if text == "," and depth == 1:
            found.append([])
        elif at > start:
            found[-1].append(line[at])
    raise ExpressionError(f"{where}: the bracket of a macro is not closed")

"""Arguments that a C function casts before it uses them: what GSL and other integrators pass.

    int f(..., void *params) { struct pendulum *p = (struct pendulum *) params; ... }
    ->  int f(..., const struct pendulum *p) { ... }

    double mu = *(double *) params;   ->   double mu = params[0];

All keeps its line. ``(void) t;`` says that an argument is not used, and goes.
"""

import re

from mechanics.claims.brackets import closing
from mechanics.errors import ExpressionError
from mechanics.program.c.tokens import blanked

PARAMETER = re.compile(r"\b(?:const\s+)?void\s*\*\s*(?:const\s+)?(\w+)(?=\s*[,)])")
UNUSED = re.compile(r"\(\s*void\s*\)\s*\(?\s*\w+\s*\)?\s*;")
KIND = r"(?P<kind>(?:const\s+)?(?:struct\s+)?\w+)"


def with_types(text: str, origin: str) -> str:
    """The text, without comments, with the types of arguments that are declared ``void *``.

    Raises
    ------
    ExpressionError
        For one that is cast to nothing or to several types, by line and column.
    """
    text = UNUSED.sub(lambda m: blanked(m[0]), text)
    while (found := PARAMETER.search(text)) is not None:
        text = _typed(text, found, origin)
    return text


def _typed(text: str, parameter: re.Match[str], origin: str) -> str:
    """The text with the type of one argument."""
    name, (start, end) = parameter[1], _body(text, parameter.end())
    body = text[start:end]
    cast = rf"\(\s*{KIND}\s*\*\s*\)\s*{name}\b"
    kinds = {" ".join(m["kind"].removeprefix("const").split()) for m in re.finditer(cast, body)}
    if end > start and not kinds and not re.search(rf"\b{name}\b", body):
        return _without(text, parameter)
    if end > start and len(kinds) != 1:
        before = text[: parameter.start()].split("\n")
        what = f"cast to {' and '.join(sorted(kinds))}" if kinds else "cast to nothing"
        raise ExpressionError(
            f"{origin}:{len(before)}:{len(before[-1]) + 1}: argument {name} is void * and {what}:"
            " give it a type"
        )
    cast = cast.replace("?P<kind>", "?:")
    kind, own = (kinds or {"double"}).pop(), name
    pointer = re.compile(
        rf"(?:const\s+)?(?:struct\s+)?\w+\s*\*\s*(?:const\s+)?(\w+)\s*=\s*{cast}\s*;"
    )
    if (declared := pointer.search(body)) is not None:
        own = declared[1]
        body = body[: declared.start()] + blanked(declared[0]) + body[declared.end() :]
    value = re.compile(rf"(?:const\s+)?(?:struct\s+)?\w+\s+(\w+)\s*=\s*\*\s*{cast}\s*;")
    if kind != "double" and (declared := value.search(body)) is not None:
        own = declared[1]
        body = body[: declared.start()] + blanked(declared[0]) + body[declared.end() :]
    body = re.sub(rf"\*\s*{cast}", f"{own}[0]", body)
    body = re.sub(rf"\(\s*{cast}\s*\)|{cast}", own, body)
    head = text[parameter.end() : start]
    return f"{text[: parameter.start()]}const {kind} *{own}{head}{body}{text[end:]}"


def _without(text: str, parameter: re.Match[str]) -> str:
    """The text without an argument that is not used."""
    before, after = text[: parameter.start()], text[parameter.end() :]
    if before.rstrip().endswith(","):
        return before.rstrip()[:-1] + after
    return before + re.sub(r"^\s*,\s*", "", after)


def _body(text: str, at: int) -> tuple[int, int]:
    """Where the body of a function begins and ends whose arguments are here; empty for none."""
    opens, ends = text.find("{", at), text.find(";", at)
    if opens < 0 or 0 <= ends < opens:
        return at, at
    return opens, closing(text, opens)

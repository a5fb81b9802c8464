"""What a person's own C file may say that no reader can know: refused by line and column.

    static double sin(double x) { return x; }      what sin(x) means, the file says itself
    #define M_PI 3                                 the header says otherwise
    #ifdef __GNUC__                                what is compiled depends on the compiler
    #ifdef NDEBUG                                  ... or on how it is called

Guards against being included twice, ``#ifdef __cplusplus`` around ``extern "C" {`` and a definition
of M_PI with the value of pi stay. A macro that is defined where nobody has defined it is taken as
the file has it, and that is told.
"""

import math
import re
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from mechanics.errors import ExpressionError
from mechanics.program.c.library import FAR, FUNCTIONS, FUSED, SINCOS
from mechanics.program.c.literal import literal
from mechanics.program.c.parse import Source
from mechanics.program.c.text import SYSTEM
from mechanics.program.c.tokens import TOKEN
from mechanics.program.c.types import declared, signature

LIBRARY = frozenset({*FUNCTIONS, *SINCOS, *FAR, *FUSED, "isfinite"})

CONSTANTS = {
    "M_E": math.e, "M_LOG2E": 1 / math.log(2), "M_LOG10E": 1 / math.log(10),
    "M_LN2": math.log(2), "M_LN10": math.log(10), "M_PI": math.pi, "M_PI_2": math.pi / 2,
    "M_PI_4": math.pi / 4, "M_1_PI": 1 / math.pi, "M_2_PI": 2 / math.pi,
    "M_2_SQRTPI": 2 / math.sqrt(math.pi), "M_SQRT2": math.sqrt(2), "M_SQRT1_2": math.sqrt(0.5),
}  # fmt: skip
"""Macros that math.h of most compilers has."""

HEADER = re.compile(
    r"NAN|INFINITY|HUGE_VAL[FL]?|NULL|EOF|BUFSIZ|RAND_MAX|EXIT_\w+|math_errhandling"
    r"|FP_(?:NAN|INFINITE|ZERO|SUBNORMAL|NORMAL|ILOGB\w+|FAST_\w+)"
    r"|(?:DBL|FLT|LDBL|DECIMAL|U?(?:INT|LONG|LLONG)\w*|PTRDIFF|SIZE)"
    r"_(?:MAX|MIN|EPSILON|DIG|WIDTH|RADIX|ROUNDS|EVAL_METHOD|\w+_DIG|\w+_EXP|TRUE_MIN|HAS_\w+)"
)
"""Names that headers of the C library define."""

RESERVED = re.compile(r"_\w*|unix|linux|i386")
"""Names that compilers define."""

DIRECTIVE = re.compile(r"^[ \t\v]*#[ \t\v]*(ifdef|ifndef|if|elif)\b([^\n]*)", re.MULTILINE)
BRANCH = re.compile(r"^[ \t\v]*#[ \t\v]*(ifdef|ifndef|if|elif|else|endif)\b", re.MULTILINE)
DEFINED = re.compile(r"#[ \t\v]*(?:define|undef)[ \t\v]+(\w+)")
INCLUDED = re.compile(r"^[ \t\v]*#[ \t\v]*include[ \t\v]*<math\.h>", re.MULTILINE)
GSL = re.compile(r"^[ \t\v]*#[ \t\v]*include[ \t\v]*<gsl/\w+\.h>", re.MULTILINE)
"""Headers of the GNU Scientific Library, of which the status that is returned is known."""
DEFINE = re.compile(r"#[ \t\v]*define\b")
LINKAGE = re.compile(r"[ \t]*#[ \t]*ifdef[ \t]+__cplusplus[ \t]*")
EXTERN = re.compile(r'\s*(?:extern\s*"C"\s*\{|\})\s*#\s*endif\b')
GUARD = re.compile(r"\w*_(?:H|HPP|C|INCLUDED)_*")


def of_the_header(text: str) -> str:
    """The text with numbers for the constants of headers, where it includes these and defines none.

    sin(2*M_PI)  ->  sin(2*3.141592653589793)       the double, which is read as any other
    """
    plain = without_comments(text)
    values = {name: repr(value) for name, value in CONSTANTS.items() if INCLUDED.search(plain)}
    if GSL.search(plain):
        values["GSL_SUCCESS"] = "0"
        text = GSL.sub(lambda m: " " * len(m[0]), text)
    own = {name for m in DIRECTIVE.finditer(plain) for name in re.findall(r"\w+", m[2])}
    for name in own | {match[1] for match in DEFINED.finditer(plain)}:
        values.pop(name, None)
    if not values:
        return text
    return re.sub(TOKEN, lambda m: values.get(m[0], m[0]), text)


def known_meaning(source: Source, text: str) -> Source:
    """The same source, if its text alone says what it means.

    Raises
    ------
    ExpressionError
        By line and column.
    """
    for name, function in source.functions.items():
        if name in LIBRARY:
            raise ExpressionError(
                f"{function.coord}: {name} is a function of the C library, and the file defines"
                " its own: rename it"
            )
    for name in LIBRARY & set(source.prototypes):
        for declaration in source.prototypes[name]:
            _as_in_the_library(name, declaration)
    plain = without_comments(text)
    for name, body in source.macros.items():
        if not _as_in_the_header(name, body):
            where = _place(source.file, plain, rf"#[ ]*define[ ]+{name}\b")
            raise ExpressionError(
                f"{where}: {name} is a macro of the C library with another value: rename it"
            )
    for name in source.asked:
        _asked(source.file, plain, name)
    return source


def defaults(source: Source, text: str) -> tuple[str, ...]:
    """What is said of macros that the file defines where nobody else has."""
    plain = without_comments(text)
    names = [
        name
        for name in source.asked
        if name not in CONSTANTS
        and any(_is_default(plain, match, name) for match in _conditions(plain, name))
    ]
    return tuple(
        f"{name} is taken as the file defines it; a compiler that is given another one reads that"
        for name in names
    )  # fmt: skip


def _as_in_the_library(name: str, declaration: Any) -> None:
    """Refuse a prototype of another function than the one of the library."""
    if name in FUNCTIONS and "static" not in (declaration.storage or ()):
        kind, arity = FUNCTIONS[name].kind, FUNCTIONS[name].arity
        given = declaration.type.args.params if declaration.type.args else []
        found = [declared(p).words.removeprefix("const ") for p in given]
        returned = signature(declaration.type).partition("(")[0]
        if returned == kind and found == [kind] * arity:
            return
    raise ExpressionError(
        f"{declaration.coord}: {name} is a function of the C library, declared here as another"
        " one: include math.h"
    )


def _as_in_the_header(name: str, body: str) -> bool:
    """Whether a macro is none of a header, or has its value, to twelve digits at least."""
    if name not in CONSTANTS:
        return HEADER.fullmatch(name) is None
    try:
        value = literal(body.strip(" ()")).value
    except ExpressionError:
        return False
    exact = Fraction(CONSTANTS[name])
    return abs(value - exact) <= Fraction(1, 10**12) * exact


def _asked(file: str, plain: str, name: str) -> None:
    """Refuse a condition on a name of compilers."""
    found = list(_conditions(plain, name))
    for match in found:
        if not _is_harmless(plain, match, name):
            at = match.start(2) + (re.search(rf"\b{name}\b", match[2]) or match).start()
            raise ExpressionError(f"{_coordinates(file, plain, at)}: {_words(name)}")
    if not found:
        raise ExpressionError(f"{file}: {_words(name)}")


def _words(name: str) -> str:
    return (
        f"{name} in a condition: what is compiled depends on whether it is defined: write one"
        " branch, or define it above"
    )


def _conditions(plain: str, name: str) -> Iterator[re.Match[str]]:
    """Directives that ask for a name."""
    return (m for m in DIRECTIVE.finditer(plain) if re.search(rf"\b{name}\b", m[2]))


def _is_harmless(plain: str, match: re.Match[str], name: str) -> bool:
    """Whether a condition guards an inclusion, ``extern "C" {`` or the definition of a macro."""
    rest = plain[match.end() :]
    if name == "__cplusplus":
        return LINKAGE.fullmatch(match[0]) is not None and EXTERN.match(rest) is not None
    if match[1] != "ifndef" or not re.match(rf"\s*#[ \t]*define[ \t]+{name}\b", rest):
        return False
    if name in CONSTANTS:
        # The value was looked at; either definition says the same.
        return _is_default(plain, match, name)
    if name in LIBRARY or HEADER.fullmatch(name):
        return False
    header = re.sub(r"_h$", ".h", name.strip("_").lower())
    if GUARD.fullmatch(name) is not None:
        return header not in SYSTEM and _is_guard(plain, match)
    if RESERVED.fullmatch(name):
        return False
    return _is_default(plain, match, name) or _is_guard(plain, match)


def _is_default(plain: str, match: re.Match[str], name: str) -> bool:
    """Whether all that depends on a condition is the definition of the name it asks for."""
    rest = plain[match.end() :].lstrip(" \t")
    defined = rf"\s*#[ \t]*define[ \t]+{name}\b[^\n]*\n\s*#\s*endif\b"
    return match[1] == "ifndef" and re.match(defined, rest) is not None


def _is_guard(plain: str, match: re.Match[str]) -> bool:
    """Whether a condition holds the whole file, or functions only, and nothing in their place."""
    depth = 1
    for inner in BRANCH.finditer(plain, match.end()):
        if depth == 1 and inner[1] in ("else", "elif"):
            return False
        depth += {"endif": -1, "else": 0, "elif": 0}.get(inner[1], 1)
        if depth == 0:
            outside = plain[: match.start()], plain[inner.end() :]
            inside = plain[match.end() : inner.start()]
            return not any(part.strip() for part in outside) or len(DEFINE.findall(inside)) == 1
    return False


def without_comments(text: str) -> str:
    r"""The text with blanks for comments, and \v where lines are joined; all keeps its place."""
    joined = text.replace("\r\n", " \n").replace("\\\n", " \v")
    return re.sub(
        TOKEN,
        lambda m: re.sub(r"[^\n\v]", " ", m[0]) if m.lastgroup == "comment" else m[0],
        joined,
    )


def _place(file: str, plain: str, pattern: str) -> str:
    match = re.search(pattern, plain)
    return _coordinates(file, plain, match.start()) if match else file


def _coordinates(file: str, plain: str, at: int) -> str:
    """``file:line:column``."""
    before = plain[:at].replace("\v", "\n").split("\n")
    return f"{file}:{len(before)}:{len(before[-1]) + 1}"

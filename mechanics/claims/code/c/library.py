"""Functions of math.h that are others' by another name, as C has them; what has no exact meaning.

fdim(x, y) = fmax(x - y, 0)     cbrt(x) = sign(x) |x|^(1/3)     isnan(x): x has no value
"""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from pycparser import c_ast

from mechanics.errors import ExpressionError
from mechanics.program.c.parse import Source, parse, reached

WRITTEN = """
double fdim(double x, double y) { return fmax(x - y, 0.0); }
double cbrt(double x) { return copysign(pow(fabs(x), 1.0 / 3.0), x); }
double trunc(double x) { return copysign(floor(fabs(x)), x); }
double round(double x) { return copysign(floor(fabs(x) + 0.5), x); }
double exp2(double x) { return pow(2.0, x); }
double log2(double x) { return log(x) / log(2.0); }
double log10(double x) { return log(x) / log(10.0); }
int isfinite(double x) { return x - x == 0.0; }
int isnan(double x) { return x != x; }
int isinf(double x) { return x - x != 0.0; }
int signbit(double x) { return x < 0.0; }
int isless(double x, double y) { return x < y; }
int islessequal(double x, double y) { return x <= y; }
int isgreater(double x, double y) { return x > y; }
int isgreaterequal(double x, double y) { return x >= y; }
"""
"""Exact of real numbers: a value is finite, and one where the state gives it none is asked for."""

NAMES = frozenset(parse(WRITTEN, "math.h").functions)

ROUNDING = "depends on the rounding mode: write floor(x + 0.5)"
NO_NUMBER = "is no real number: leave the case out, or write the number that bounds it"
REFUSED = {
    **dict.fromkeys(("rint", "nearbyint", "lrint", "llrint"), ROUNDING),
    **dict.fromkeys(("lround", "llround"), "gives an integer: write round(x)"),
    **dict.fromkeys(("remainder", "remquo", "drem"), "rounds a quotient: write fmod, or"
                    " atan2(sin(x), cos(x)) where it wraps an angle"),
    **dict.fromkeys(("abs", "labs", "llabs"), "is for integers in C: write fabs"),
    **dict.fromkeys(("lgamma", "tgamma", "erfc", "j0", "j1", "jn", "y0", "y1", "yn"),
                    "has no exact meaning: write its formula where it has one"),
    **dict.fromkeys(("frexp", "ldexp", "modf", "ilogb", "logb", "scalbn", "scalbln", "nextafter",
                     "nexttoward", "fpclassify", "isnormal", "isunordered", "nan"),
                    "asks for the bits of a double: write what it is for, as a formula"),
    **dict.fromkeys(("INFINITY", "NAN", "HUGE_VAL", "HUGE_VALF", "DBL_MAX", "FLT_MAX"), NO_NUMBER),
}  # fmt: skip
"""Names of the library that are refused, and what to do."""


def with_library(source: Source, judged: str) -> tuple[Source, tuple[str, ...]]:
    """What a function reaches, with those functions of math.h that others say as well.

    Parameters
    ----------
    source : Source
    judged : str
        Name of the function.

    Returns
    -------
    Source
    tuple of str
        What is told of functions that have no exact meaning, and that it does not reach.

    Raises
    ------
    ExpressionError
        For what has no exact meaning, by line and column.
    """
    inside = reached(source, (judged,))
    notes = []
    for title, function in source.functions.items():
        try:
            _exact(function, source)
        except ExpressionError:
            if title in inside:
                raise
            notes.append(f"{title} is not read: what is judged does not call it")
    own = {name: node for name, node in source.functions.items() if name in inside}
    written = {**parse(WRITTEN, "math.h").functions, **own}
    return replace(source, functions=written), tuple(notes)


def _exact(function: Any, source: Source) -> None:
    """Refuse a function that has no exact meaning."""
    for node in below(function.body):
        name = _of_the_library(node)
        if name in REFUSED and name not in source.functions:
            call = "" if name.isupper() else "()"
            raise ExpressionError(f"{node.coord}: {name}{call} {REFUSED[name]}")
        if _is_negative_zero(node):
            raise ExpressionError(
                f"{node.coord}: -0.0 differs from 0.0 in copysign, signbit and atan2 only, and"
                " is the same real number: write 0.0, or the case that is meant"
            )


def _of_the_library(node: Any) -> str:
    """The name of a function that is called, or of a macro; variables may be called y1."""
    if isinstance(node, c_ast.FuncCall) and isinstance(node.name, c_ast.ID):
        return str(node.name.name)
    return node.name if isinstance(node, c_ast.ID) and node.name.isupper() else ""


def _is_negative_zero(node: Any) -> bool:
    """Whether it is a minus before a zero with a point or an exponent; the integer has no sign."""
    if not (isinstance(node, c_ast.UnaryOp) and node.op == "-"):
        return False
    number = node.expr
    return (
        isinstance(number, c_ast.Constant)
        and "int" not in number.type
        and not any(digit in "123456789" for digit in number.value.lower().partition("e")[0])
    )


def below(node: Any) -> Iterator[Any]:
    """A node and all below it."""
    yield node
    for _, child in node.children():
        yield from below(child)

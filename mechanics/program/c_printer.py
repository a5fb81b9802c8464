"""Expressions in C99: one operation on operands that are text already.

Parentheses keep the order of the roundings: a + (b + c) is not a + b + c. `mechanics.compiled.c`
makes functions of them.
"""

import re
from collections.abc import Sequence
from typing import NamedTuple

from mechanics.errors import ExpressionError
from mechanics.program.operations import AND, NOT, OPERATIONS, OR, SELECT

PRIMARY, UNARY = 10, 9
PRECEDENCE = {"*": 8, "/": 8, "+": 7, "-": 7, "<": 6, "<=": 6, "==": 5, "&&": 4, "||": 3, "?": 2}
"""Of C's operators, the tightest first."""


class _Template(NamedTuple):
    """How an operation is written.

    Attributes
    ----------
    needed : tuple of int
        Precedence below which an operand is put into parentheses.
    """

    text: str
    precedence: int
    needed: tuple[int, ...]


def _template(text: str, arity: int) -> _Template:
    if re.match(r"\w*\(", text):
        return _Template(text, PRIMARY, (PRIMARY if "{0}" in text else 0,) * arity)
    operators = re.findall(r"[-+*/<>=!&|?]+", text)
    if arity == 1:
        return _Template(text, UNARY, (UNARY + 1,))  # - -x, not --x
    own = PRECEDENCE[operators[0]]
    if own == PRECEDENCE["?"]:
        return _Template(text, own, (own + 1, own + 1, own + 1))
    if own == PRECEDENCE["||"]:
        return _Template(text, own, (own + 2, own + 2))  # what compilers warn about
    if own <= PRECEDENCE["<"]:
        return _Template(text, own, (own + 1, own + 1))
    return _Template(text, own, (own, own + 1))


TEMPLATES = tuple(
    _template(row.c, row.arity) if row.c and row.arity else None for row in OPERATIONS
)


class Text(NamedTuple):
    """An expression in C.

    Attributes
    ----------
    code : str
    level : int
        Its precedence.
    truth : bool
        Whether it is an int that says whether something holds.
    """

    code: str
    level: int = PRIMARY
    truth: bool = False


CALLS = {row.code: found[1] for row in OPERATIONS if (found := re.match(r"(\w+)\(", row.c))}
"""Functions of the C library, by operation."""


def _takes_truth(code: int, place: int) -> bool:
    """Whether an operand is asked for its truth only."""
    return code in (AND, OR, NOT) or (code == SELECT and place == 0)


def expression(code: int, operands: Sequence[Text], kind: str = "double") -> Text:
    """One operation on operands that are expressions themselves.

    Raises
    ------
    ExpressionError
        If it has no meaning in C.
    """
    template = TEMPLATES[code]
    if template is None:
        raise ExpressionError(
            f"operation {OPERATIONS[code].name} has no meaning in C:"
            " write the expression without it"
        )
    parts = []
    for place, (operand, needed) in enumerate(zip(operands, template.needed, strict=True)):
        if _takes_truth(code, place):
            text = operand if operand.truth else Text(f"{operand.code} != 0", PRECEDENCE["=="])
        else:
            text = numeric(operand, kind)
        parts.append(text.code if text.level >= needed else f"({text.code})")
    single = kind == "float"
    if code in CALLS:
        return Text(f"{CALLS[code]}{'f' if single else ''}({', '.join(parts)})")
    form = re.sub(r"\d\.\d", r"\g<0>f", template.text) if single else template.text
    return Text(form.format(*parts), template.precedence, OPERATIONS[code].boolean)


def numeric(text: Text, kind: str) -> Text:
    """A truth value as a number of the precision."""
    if not text.truth:
        return text
    suffix = "f" if kind == "float" else ""
    return Text(f"({text.code} ? 1.0{suffix} : 0.0{suffix})")

"""Programs as one function in C99.

The operations stand in the order of the program, each rounded as written: parentheses keep
a + (b + c) apart from a + b + c. Constants are exact until here. A rational p / q is printed as
that division, which rounds once; x (1/n) is x / n, which rounds once as well.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from mechanics.errors import ExpressionError
from mechanics.program.constants import unit_fraction
from mechanics.program.elimination import expand_solves
from mechanics.program.operations import (
    AND,
    ARITY,
    CONSTANT,
    DIVIDE,
    INPUT,
    MULTIPLY,
    NOT,
    OPERATIONS,
    OR,
    PI,
    SELECT,
)
from mechanics.program.program import Program

WIDTH = 92
"""Of a line, without its indentation; an expression of half of it is a statement of its own."""

_WORDS = """
    auto break case char const continue default do double else enum extern float for goto if inline
    int long register restrict return short signed sizeof static struct switch typedef union
    unsigned void volatile while _Bool _Complex _Imaginary
"""
KEYWORDS = frozenset(_WORDS.split())
FUNCTIONS = frozenset(name for row in OPERATIONS for name in re.findall(r"\w+(?=\()", row.c))

PRIMARY, UNARY = 10, 9
PRECEDENCE = {"*": 8, "/": 8, "+": 7, "-": 7, "<": 6, "<=": 6, "==": 5, "&&": 4, "||": 3, "?": 2}
"""Of C's operators, the tightest first."""


class _Template(NamedTuple):
    """How an operation is written.

    Attributes
    ----------
    text : str
    precedence : int
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


def print_c(program: Program, name: str, arrays: Mapping[str, Sequence[str]] | None = None) -> str:
    """One function in C99, with the header that it includes.

    Parameters
    ----------
    program : Program
        Its linear systems are written out, see `mechanics.program.elimination`.
    name : str
        Of the function.
    arrays : mapping of str to sequence of str, optional
        Name of each array argument, and the inputs that it holds, in order. By default every input
        is an argument of its own.

    Returns
    -------
    str
        ``void name(const double q[2], ..., double f[2])``, all in and out in double precision. The
        arrays must not overlap.

    Raises
    ------
    ExpressionError
        If a name is none in C, an input stands in no array or in two, a constant is beyond double
        precision, or a linear system needs pivots that are chosen at run time.

    Examples
    --------
    >>> from mechanics.program import Builder
    >>> b = Builder()
    >>> program = b.program({"f": [b.input("x").sin() / 3]})
    >>> print(print_c(program, "thirds"))
    #include <math.h>
    <BLANKLINE>
    void thirds(double x, double f[1])
    {
        f[0] = sin(x) / 3.0;
    }
    <BLANKLINE>
    """
    inputs, parameters = _inputs(program, arrays)
    outputs = [f"double {output}[{len(found)}]" for output, found in program.outputs.items()]
    _check_names(name, [*(arrays or program.inputs), *program.outputs])
    written = _Writer(expand_solves(program), inputs).statements()
    return "\n".join(
        ["#include <math.h>", "", *_signature(name, [*parameters, *outputs]), "{",
         *(f"    {statement}" for statement in written), "}", ""]
    )  # fmt: skip


def _inputs(
    program: Program, arrays: Mapping[str, Sequence[str]] | None
) -> tuple[dict[str, str], list[str]]:
    """What each input is in C, and the parameters."""
    if arrays is None:
        return {name: name for name in program.inputs}, [f"double {n}" for n in program.inputs]
    inputs: dict[str, str] = {}
    for array, names in arrays.items():
        for k, entry in enumerate(names):
            if entry in inputs:
                raise ExpressionError(f"input {entry} stands in two arrays: leave one out")
            inputs[entry] = f"{array}[{k}]"
    if missing := [entry for entry in program.inputs if entry not in inputs]:
        raise ExpressionError(f"input {missing[0]} stands in no array: say in which")
    return inputs, [f"const double {array}[{len(names)}]" for array, names in arrays.items()]


def _check_names(function: str, parameters: Sequence[str]) -> None:
    for name, count in Counter({function: 0} | Counter(parameters)).items():
        if not re.fullmatch(r"[A-Za-z_]\w*", name, re.ASCII) or name in KEYWORDS | FUNCTIONS:
            raise ExpressionError(f"{name!r} cannot be a name in C: rename it, or use arrays")
        if count > 1:
            raise ExpressionError(f"{name!r} names two things in one C function: rename one")


def _signature(name: str, parameters: Sequence[str]) -> list[str]:
    """On one line, or with one parameter a line."""
    line = f"void {name}({', '.join(parameters) or 'void'})"
    if len(line) <= WIDTH:
        return [line]
    return [f"void {name}(", *(f"    {p}," for p in parameters[:-1]), f"    {parameters[-1]})"]


@dataclass
class _Writer:
    """Statements of a program without linear systems."""

    program: Program
    inputs: Mapping[str, str]

    def statements(self) -> list[str]:
        """A constant for each value that is used twice or is long, then the outputs."""
        program, lines = self.program, []
        uses = self._uses()
        texts: list[Text] = []
        prefix = self._prefix()
        for number in range(len(program)):
            text = self._text(number, texts)
            code = program.operations[number]
            if ARITY[code] and (uses[number] != 1 or len(text.code) > WIDTH // 2):
                lines.append(f"const double {prefix}{number} = {numeric(text, 'double').code};")
                text = Text(f"{prefix}{number}")
            texts.append(text)
        for name, numbers in program.outputs.items():
            found = [numeric(texts[n], "double").code for n in numbers]
            lines += [f"{name}[{k}] = {text};" for k, text in enumerate(found)]
        return lines

    def _prefix(self) -> str:
        """Of the constants, so that none is called as an argument is."""
        prefix = "t"
        names = [*self.inputs.values(), *self.program.outputs]
        while any(re.fullmatch(prefix + r"\d+", name) for name in names):
            prefix += "_"
        return prefix

    def _uses(self) -> Counter[int]:
        """How often each value would be written; two where it has to have a name."""
        program = self.program
        uses = Counter(program.roots)
        for number, code in enumerate(program.operations):
            template = TEMPLATES[code]
            for operand in program.operands_of(number):
                repeated = template is not None and "{0}" in template.text
                uses[operand] += 2 if repeated else 1
        return uses

    def _text(self, number: int, texts: Sequence[Text]) -> Text:
        program, code = self.program, self.program.operations[number]
        place = program.operands[0][number]
        if code == CONSTANT:
            return _literal(program.constants[place])
        if code == INPUT:
            return Text(self.inputs[program.inputs[place]])
        if code == PI:
            return Text(OPERATIONS[PI].c)
        operands = program.operands_of(number)
        if code == MULTIPLY:
            for k, operand in enumerate(operands):
                if program.operations[operand] == CONSTANT and (
                    divisor := unit_fraction(program.constants[program.operands[0][operand]])
                ):
                    return expression(DIVIDE, [texts[operands[1 - k]], _literal(Fraction(divisor))])
        return expression(code, [texts[operand] for operand in operands])


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


def _literal(value: Fraction) -> Text:
    """The nearest double: a decimal that is read as it, or one division of whole numbers."""
    try:
        nearest = float(value)
    except OverflowError:
        raise ExpressionError("a constant is beyond double precision: scale the units") from None
    precedence = UNARY if value < 0 else PRIMARY
    top, bottom = value.numerator, value.denominator
    if Fraction(nearest) == value or max(abs(top), bottom) > 1 << 53:
        return Text(repr(nearest), precedence)
    return Text(f"{float(top)!r} / {float(bottom)!r}", PRECEDENCE["/"])

"""A program line by line: what is used again or grows long gets a name of its own.

x1 = sin(q1)
x2 = m1 x1 + m2 cos(q1)
f = x2**2 - x2
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import sympy

from mechanics.program.elimination import expand_solves
from mechanics.program.operations import CONSTANT, INPUT, NEGATE, OPERATIONS, PI
from mechanics.program.program import Program
from mechanics.program.sympy_printer import Expressions

LETTERS = ("x", "z", "w", "s", "y")
"""Of the names; the first is taken that no input has with a number behind it."""
LONGEST = 12
"""Operations of a line."""


@dataclass(frozen=True)
class Listing:
    """Lines in the order in which they are computed, and the outputs in terms of these.

    Attributes
    ----------
    lines : tuple of (Symbol, Expr)
    """

    lines: tuple[tuple[sympy.Symbol, sympy.Expr], ...]
    outputs: Mapping[str, tuple[sympy.Expr, ...]]


def listing(program: Program, symbols: Mapping[str, sympy.Symbol] | None = None) -> Listing:
    """A program as lines of SymPy expressions.

    Parameters
    ----------
    program : Program
        Its linear systems are written out, see `mechanics.program.elimination`.
    symbols : mapping of str to Symbol, optional
        What stands for an input; by default the symbol of its name.

    Examples
    --------
    >>> from mechanics.program import Builder
    >>> b = Builder()
    >>> s = b.input("q").sin() + b.input("a")
    >>> found = listing(b.program({"f": [s * s / 3]}))
    >>> found.lines, found.outputs["f"]
    (((x1, a + sin(q)),), (x1**2/3,))
    """
    program = expand_solves(program)
    given = {name: sympy.Symbol(name) for name in program.inputs} | dict(symbols or {})
    letter = _letter({str(symbol) for symbol in given.values()})
    domain, (first, _, _) = Expressions(), program.operands
    uses = [0] * len(program)
    for number in range(len(program)):
        for operand in program.operands_of(number):
            uses[operand] += 1
    lines: list[tuple[sympy.Symbol, sympy.Expr]] = []
    values: list[Any] = []
    sizes: list[int] = []
    for number, code in enumerate(program.operations):
        operands = program.operands_of(number)
        size = 0
        if code == CONSTANT:
            value = domain.constant(program.constants[first[number]])
        elif code == INPUT:
            value = given[program.inputs[first[number]]]
        elif code == PI:
            value = domain.pi()
        else:
            value = domain.operations[OPERATIONS[code].name](*(values[n] for n in operands))
            size = 1 + sum(sizes[n] for n in operands)
            again = uses[number] > 1 and code != NEGATE
            if isinstance(value, sympy.Expr) and not value.is_Atom and (again or size > LONGEST):
                lines.append((sympy.Symbol(f"{letter}{len(lines) + 1}", real=True), value))
                value, size = lines[-1][0], 0
        values.append(value)
        sizes.append(size)
    outputs = {name: tuple(values[n] for n in ns) for name, ns in program.outputs.items()}
    return Listing(tuple(lines), outputs)


def _letter(taken: set[str]) -> str:
    """The first letter that makes no name which is taken."""
    return next(
        letter for letter in (*LETTERS, "line_")
        if not any(name.startswith(letter) and name[len(letter) :].isdigit() for name in taken)
    )  # fmt: skip

"""Whether the values of a function are numbers, and if not, why.

    0  every value is finite          2  overflow: a value is beyond the largest number
    1  a divisor is zero: singular    3  an input is infinite or no number

An infinity that a quotient or a function turns into a number again would be missed in the outputs,
so divisors and the arguments of such functions are looked at, too.
"""

import textwrap
from collections.abc import Sequence
from dataclasses import dataclass

from mechanics.program.operations import (
    ATAN,
    ATAN2,
    DIVIDE,
    EQUAL,
    ERF,
    EXP,
    LESS,
    NOT_GREATER,
    OPERATIONS,
    POWER,
    SELECT,
    SIGN,
    TANH,
)
from mechanics.program.routine import Routine, routine

LINE = 100
WATCHED = "_watched"
"""Ends the name of a function that also gives what is watched in it."""

FORGETFUL = frozenset({
    ATAN, ATAN2, TANH, ERF, EXP, SIGN, LESS, NOT_GREATER, EQUAL, SELECT, POWER,
})  # fmt: skip
"""Operations that can make a number of an infinity, other than divisions."""


@dataclass(frozen=True)
class Watched:
    """Values inside a program that have to be finite.

    Attributes
    ----------
    divisors : tuple of int
        Nodes that something is divided by; they must not be zero either.
    others : tuple of int
        Operands of `FORGETFUL`.
    """

    divisors: tuple[int, ...]
    others: tuple[int, ...]


def watched(code: Routine) -> Watched:
    """What has to be finite besides the outputs; numbers and inputs are known to be."""
    divisors: dict[int, None] = {}
    others: dict[int, None] = {}
    for node in code.nodes:
        if node.operation == DIVIDE:
            divisors[node.operands[1]] = None
        elif node.operation in FORGETFUL:
            others |= dict.fromkeys(node.operands)
    return Watched(
        tuple(k for k in divisors if code.nodes[k].constant is None),
        tuple(k for k in others if _may_be_infinite(code, k) and k not in divisors),
    )


def _may_be_infinite(code: Routine, k: int) -> bool:
    return code.nodes[k].constant is None and not OPERATIONS[code.nodes[k].operation].boolean


def with_watched(code: Routine) -> Routine:
    """The program with one more output, ``watched``: divisors first."""
    found = watched(code)
    nodes = (*found.divisors, *found.others)
    return routine(
        f"{code.name}{WATCHED}",
        code.nodes,
        (*code.outputs, nodes),
        code.inputs,
        (*code.shapes, ("watched", (len(nodes), 1))),
    )


@dataclass(frozen=True)
class Codes:
    """Names of the four statuses in C."""

    ok: str
    singular: str
    overflow: str
    bad_input: str


def status_lines(
    name: str, codes: Codes, inputs: Sequence[str], values: Sequence[str], divisors: Sequence[str]
) -> list[str]:
    """C that sets a local variable to the status.

    Parameters
    ----------
    name : str
        Of the variable.
    inputs, values, divisors : sequences of str
        Locals; divisors are among the values.
    """
    if not values:
        return [f"    const int {name} = {codes.ok};"]
    singular = " || ".join(f"{divisor} == 0" for divisor in divisors)
    why = f"{singular} ? {codes.singular} : {codes.overflow}" if divisors else codes.overflow
    return [
        f"    int {name} = {codes.ok};",
        *wrapped(f"if (!({_finite(values)})) {{", "    "),
        *wrapped(f"if (!({_finite(inputs)}))", "        "),
        f"            {name} = {codes.bad_input};",
        "        else",
        *wrapped(f"{name} = {why};", "            "),
        "    }",
    ]


def _finite(names: Sequence[str]) -> str:
    return " && ".join(f"isfinite({name})" for name in dict.fromkeys(names)) or "1"


def wrapped(text: str, indent: str) -> list[str]:
    """Lines that are not too long."""
    return textwrap.wrap(
        text, LINE, initial_indent=indent, subsequent_indent=indent + "    ",
        break_long_words=False, break_on_hyphens=False,
    )  # fmt: skip

"""C99 from a program: one function, plain arguments, no allocation, no global state.

    static void name(const double q[2], const double p[5], double ud[2])

A value that is used once is written where it is used, as long as the line stays readable; the rest
get a name each. Parentheses keep the order of the roundings. Inputs are read before outputs are
written, so an output may be the same array as an input.
"""

import re
import textwrap
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca
import numpy as np

from mechanics.compiled.c.names import Namer
from mechanics.compiled.c.schedule import scheduled
from mechanics.compiled.c.status import Codes, status_lines, watched
from mechanics.compiled.programs.operations import ATOM, OPERATIONS, PRODUCT, SIGN, SUM, unknown
from mechanics.compiled.programs.program import Program

LINE = 100
WIDTH = 64
SHORT = 16

Entries = Mapping[str, tuple[str, ...]]
"""For each input the names of its entries."""


@dataclass(frozen=True)
class Text:
    """A C expression and how tightly it binds."""

    code: str
    level: int


def signature(
    code: Program, kind: str = "double", name: str | None = None, result: str = "void"
) -> str:
    """``void name(const double q[2], double ud[2])``; arrays without entries are left out."""
    arguments = [f"const {kind} {group}[{size}]" for group, size in code.inputs if size]
    arguments += [
        f"{kind} {out}[{rows * cols}]" for out, (rows, cols) in code.shapes if rows * cols
    ]
    # A line may end after an argument, not inside one.
    glued = ", ".join(argument.replace(" ", "~") for argument in arguments)
    text = f"{result}~{name or code.name}({glued})"
    lines = textwrap.wrap(text, LINE, subsequent_indent="    ", break_long_words=False)
    return "\n".join(lines).replace("~", " ")


def function_source(
    code: Program,
    entries: Entries,
    kind: str = "double",
    head: str | None = None,
    codes: Codes | None = None,
) -> str:
    """Definition of one C function.

    Parameters
    ----------
    entries : names of the entries of each input, for readable local variables
    kind : ``"double"`` or ``"float"``
    head : text before the opening brace; `signature` by default
    codes : what the function returns to tell its status, if it returns anything
    """
    ordered = scheduled(code)
    # What a call is given is read just before it, where the order of statements matters.
    body = _body(ordered, entries, kind, codes, early=ordered is code)
    return "\n".join([head or signature(code, kind), "{", *body, "}", ""])


def _body(
    code: Program, entries: Entries, kind: str, codes: Codes | None, early: bool
) -> list[str]:
    taken = {name for name, _ in (*code.inputs, *code.shapes)} | {code.name}
    namer = Namer(taken)
    uses = _uses(code)
    looked_at = _looked_at(code) if codes is not None else ()
    # What is looked at afterwards gets a name.
    uses.update(looked_at)
    local = _locals(code, entries, namer, uses)
    reads = {
        (group, entry): f"    const {kind} {name} = {code.inputs[group][0]}[{entry}];"
        for (group, entry), name in sorted(local.items())
    }
    lines = list(reads.values()) if early else []
    texts: list[Text] = []

    def keep(text: Text, name: str) -> Text:
        lines.append(f"    const {kind} {name} = {text.code};")
        return Text(name, ATOM)

    for k, node in enumerate(code.nodes):
        if node.constant is not None:
            texts.append(Text(literal(node.constant, kind), ATOM if node.constant >= 0 else SIGN))
            continue
        if node.operation == ca.OP_INPUT:
            if not early and node.operands in reads:
                lines.append(reads[node.operands])
            texts.append(Text(local.get(node.operands, ""), ATOM))
            continue
        text = expression(node.operation, [texts[i] for i in node.operands], kind)
        if len(text.code) > WIDTH:
            for i in node.operands:
                if texts[i].level != ATOM and len(texts[i].code) > SHORT:
                    texts[i] = keep(texts[i], namer.value())
            text = expression(node.operation, [texts[i] for i in node.operands], kind)
        if node.operation in _CALLS:
            text = keep(text, _call_name(text.code, namer))
        elif uses[k] > 1:
            text = keep(text, namer.value())
        texts.append(text)
    stores: list[str] = []
    for (out, _), nodes in zip(code.shapes, code.outputs, strict=True):
        stores += [f"    {out}[{i}] = {texts[node].code};" for i, node in enumerate(nodes)]
    used = {group for group, _ in local}
    ignored = [
        f"    (void){name};"
        for group, (name, size) in enumerate(code.inputs)
        if size and group not in used
    ]
    if codes is not None:
        name, divisors = namer.local("status"), watched(code).divisors
        by = [texts[k].code for k in divisors]
        values = [texts[k].code for k in looked_at]
        stores = [*status_lines(name, codes, list(local.values()), values, by), *stores]
        stores.append(f"    return {name};")
    return [*ignored, *lines, *stores]


def _looked_at(code: Program) -> tuple[int, ...]:
    """Nodes that have to be finite: outputs and what is watched, but for constants."""
    found = watched(code)
    outputs = dict.fromkeys(node for nodes in code.outputs for node in nodes)
    every = (*outputs, *found.divisors, *found.others)
    return tuple(k for k in dict.fromkeys(every) if code.nodes[k].constant is None)


def _locals(
    code: Program, entries: Entries, namer: Namer, uses: Counter[int]
) -> dict[tuple[int, ...], str]:
    """A name for every input entry that is used, by (input, entry), in the order of the arrays."""
    used = sorted(
        node.operands
        for k, node in enumerate(code.nodes)
        if node.operation == ca.OP_INPUT and uses[k]
    )
    return {at: namer.local(entries[code.inputs[at[0]][0]][at[1]]) for at in used}


# Function calls get a line each: they are what costs time.
_CALLS = {op for op, how in OPERATIONS.items() if how.level == ATOM and "{f}(" in how.text}


def _call_name(text: str, namer: Namer) -> str:
    """``sin_theta`` for ``sin(theta)``; a number where the argument is no plain name."""
    plain = re.fullmatch(r"(\w+)\((\w+)\)", text)
    return namer.local("_".join(plain.groups())) if plain else namer.value()


def _uses(code: Program) -> Counter[int]:
    uses: Counter[int] = Counter()
    for node in code.nodes:
        if node.operation in (ca.OP_INPUT, ca.OP_CONST):
            continue
        # The text of these repeats its operand.
        twice = node.operation in (ca.OP_SQ, ca.OP_SIGN)
        for operand in node.operands:
            uses[operand] += 2 if twice else 1
    for nodes in code.outputs:
        uses.update(nodes)
    return uses


def expression(operation: int, operands: list[Text], kind: str) -> Text:
    """One operation on operands that are expressions themselves."""
    if operation not in OPERATIONS:
        raise unknown(operation)
    how = OPERATIONS[operation]
    inside = "{f}(" in how.text
    parts = [
        operand.code if inside or _binds(operand, how.level, place) else f"({operand.code})"
        for place, operand in enumerate(operands)
    ]
    if operation in (ca.OP_TWICE, ca.OP_INV) and not operands[0].level > PRODUCT:
        parts = [f"({operands[0].code})"]
    literals = {name: literal(value, kind) for name, value in _LITERALS.items()}
    text = how.text.format(*parts, f="f" if kind == "float" else "", **literals)
    return Text(text, how.level)


_LITERALS = {"zero": 0.0, "one": 1.0, "two": 2.0}


def _binds(operand: Text, level: int, place: int) -> bool:
    """Whether an operand needs no parentheses; a right one must bind tighter to keep the order."""
    if level in (SUM, PRODUCT) and place == 0:
        return operand.level >= level
    return operand.level > level if level != ATOM else operand.level == ATOM


def literal(value: float, kind: str) -> str:
    """An exact C literal: an integer where it is one, otherwise hexadecimal."""
    suffix = "f" if kind == "float" else ""
    with np.errstate(over="ignore"):
        number = float(np.float32(value)) if kind == "float" else value
    if np.isnan(number):
        return "NAN"
    if np.isinf(number):
        return "INFINITY" if number > 0 else "-INFINITY"
    if number.is_integer() and abs(number) < 1e6:
        sign = "-" if np.signbit(number) else ""
        return f"{sign}{abs(int(number))}.0{suffix}"
    sign = "-" if number < 0 else ""
    mantissa, exponent = abs(number).hex().split("p")
    digits = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
    return f"{sign}{digits}p{exponent}{suffix}"

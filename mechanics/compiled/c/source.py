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
from fractions import Fraction

import numpy as np

from mechanics.compiled.c.flow import looked_at, users
from mechanics.compiled.c.names import Namer
from mechanics.compiled.c.schedule import scheduled
from mechanics.compiled.c.status import Codes, status_lines, watched
from mechanics.program.c_printer import CALLS, PRIMARY, UNARY, Text, expression, numeric
from mechanics.program.operations import INPUT
from mechanics.program.routine import Routine

LINE = 100
WIDTH = 64
SHORT = 16

Entries = Mapping[str, tuple[str, ...]]
"""For each input the names of its entries."""


def signature(
    code: Routine, kind: str = "double", name: str | None = None, result: str = "void"
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
    code: Routine,
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
    code: Routine, entries: Entries, kind: str, codes: Codes | None, early: bool
) -> list[str]:
    taken = {name for name, _ in (*code.inputs, *code.shapes)} | {code.name}
    namer = Namer(taken)
    uses = _uses(code)
    wanted = looked_at(code) if codes is not None else ()
    # What is looked at afterwards gets a name.
    uses.update(wanted)
    local = _locals(code, entries, namer, uses)
    reads = {
        (group, entry): f"    const {kind} {name} = {code.inputs[group][0]}[{entry}];"
        for (group, entry), name in sorted(local.items())
    }
    lines = list(reads.values()) if early else []
    texts: list[Text] = []

    def keep(text: Text, name: str) -> Text:
        lines.append(f"    const {kind} {name} = {numeric(text, kind).code};")
        return Text(name)

    for k, node in enumerate(code.nodes):
        if node.constant is not None:
            texts.append(constant(node.constant, kind))
            continue
        if node.operation == INPUT:
            if not early and node.operands in reads:
                lines.append(reads[node.operands])
            texts.append(Text(local.get(node.operands, "")))
            continue
        text = expression(node.operation, [texts[i] for i in node.operands], kind)
        if len(text.code) > WIDTH:
            for i in node.operands:
                if texts[i].level != PRIMARY and len(texts[i].code) > SHORT:
                    texts[i] = keep(texts[i], namer.value())
            text = expression(node.operation, [texts[i] for i in node.operands], kind)
        # Function calls get a line each: they are what costs time.
        if node.operation in CALLS:
            text = keep(text, _call_name(text.code, namer))
        elif uses[k] > 1:
            text = keep(text, namer.value())
        texts.append(text)
    stores: list[str] = []
    for (out, _), nodes in zip(code.shapes, code.outputs, strict=True):
        values = [numeric(texts[node], kind).code for node in nodes]
        stores += [f"    {out}[{i}] = {value};" for i, value in enumerate(values)]
    used = {group for group, _ in local}
    ignored = [
        f"    (void){name};"
        for group, (name, size) in enumerate(code.inputs)
        if size and group not in used
    ]
    if codes is not None:
        name, divisors = namer.local("status"), watched(code).divisors
        by = [texts[k].code for k in divisors]
        values = [texts[k].code for k in wanted]
        stores = [*status_lines(name, codes, list(local.values()), values, by), *stores]
        stores.append(f"    return {name};")
    return [*ignored, *lines, *stores]


def _locals(
    code: Routine, entries: Entries, namer: Namer, uses: Counter[int]
) -> dict[tuple[int, ...], str]:
    """A name for every input entry that is used, by (input, entry), in the order of the arrays."""
    used = sorted(
        node.operands for k, node in enumerate(code.nodes) if node.operation == INPUT and uses[k]
    )
    return {at: namer.local(entries[code.inputs[at[0]][0]][at[1]]) for at in used}


def _call_name(text: str, namer: Namer) -> str:
    """``sin_theta`` for ``sin(theta)``; a number where the argument is no plain name."""
    plain = re.fullmatch(r"(\w+)\((\w+)\)", text)
    return namer.local("_".join(plain.groups())) if plain else namer.value()


def _uses(code: Routine) -> Counter[int]:
    return Counter({k: len(found) for k, found in enumerate(users(code))})


def constant(value: Fraction, kind: str) -> Text:
    """A number of the precision."""
    return Text(literal(float(value), kind), UNARY if value < 0 else PRIMARY)


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

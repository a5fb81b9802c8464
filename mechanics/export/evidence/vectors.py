"""The tables of self-tests: every expected value is the enclosed one, rounded once.

    |expected - value| <= half a unit of the last place,   tolerance <= 2^(3 - digits/2) max |value|

The values are those of the program that the C was printed from, walked in Arb balls at the states
of the table. How a self-test goes through its tables is not looked at: running it shows that.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from flint import arb
from pycparser import c_ast

from mechanics.compiled.translation_validation.code import as_written
from mechanics.compiled.translation_validation.prove import Graph
from mechanics.compiled.translation_validation.rounding import DIGITS
from mechanics.compiled.translation_validation.states import TYPES
from mechanics.errors import ExpressionError
from mechanics.kernel import Finding, enclose, enclosed, refuted, undecided
from mechanics.program.c.literal import literal
from mechanics.program.c.parse import parse

BITS = 320
ENDING, TEST = "_selftest.c", "test_"
SLACK = 3

COUNTS = re.compile(r"^enum \{(?: \w+ = \d+,?)+ \};$", re.MULTILINE)
"""A line of constants, and nothing after it."""

Rows = list[list[Fraction]]


def prove_vectors(texts: Mapping[str, str], graphs: Mapping[str, Graph]) -> Iterator[Finding]:
    """Decide about the tables of every self-test among the texts."""
    headers = {name: text for name, text in texts.items() if name.endswith(".h")}
    for file, text in texts.items():
        if not file.endswith(ENDING):
            continue
        try:
            # What the tables stand in is not read: printf and its like are of no concern.
            functions = parse(_plain(text), file, headers).functions
        except ExpressionError as error:
            yield undecided(f"{file}: vectors", f"refused: {error}")
            continue
        for name, function in functions.items():
            if name.startswith(TEST) and name.removeprefix(TEST) in graphs:
                yield _judged(file, function, graphs[name.removeprefix(TEST)])


def _plain(text: str) -> str:
    """A self-test without the constants that it counts by."""
    return COUNTS.sub("", text)


def _judged(file: str, function: Any, graph: Graph) -> Finding:
    name = graph.written.name
    subject = f"{file}: vectors of {name}"
    try:
        kind, tables = _tables(function)
        return _compared(subject, kind, tables, graph)
    except (ExpressionError, KeyError, IndexError) as error:
        return undecided(subject, f"refused: {error}")


def _tables(function: Any) -> tuple[str, dict[str, Rows]]:
    """Tables of a test by name, and their type."""
    kinds: set[str] = set()
    found: dict[str, Rows] = {}
    for node in function.body.block_items:
        if isinstance(node, c_ast.Decl) and isinstance(node.init, c_ast.InitList):
            kinds.add(" ".join(node.type.type.type.type.names))
            found[node.name] = [[_number(entry) for entry in row.exprs] for row in node.init.exprs]
    if len(kinds) != 1 or not kinds <= set(TYPES):
        raise ExpressionError("tables of double or float are expected")
    return kinds.pop(), found


def _number(node: Any) -> Fraction:
    if isinstance(node, c_ast.UnaryOp) and node.op == "-":
        return -_number(node.expr)
    if not isinstance(node, c_ast.Constant):
        raise ExpressionError(f"{node.coord}: a number is expected in a table")
    return literal(node.value).value


def _compared(subject: str, kind: str, tables: Mapping[str, Rows], graph: Graph) -> Finding:
    code, program = graph.written, as_written(graph.written)
    asked = [name for name, (rows, columns) in code.shapes if rows * columns]
    count = len(tables[f"{asked[0]}_expected"])
    if not count:
        return undecided(subject, "refused: there is no state in its tables")
    bounds: list[tuple[Fraction, arb, Fraction]] = []
    for i in range(count):
        given = [
            _row(tables[f"{group}_in"], i) if size else [] for group, size in code.inputs
        ]  # fmt: skip
        state = {
            f"{group}[{k}]": arb(float(number))
            for (group, _), row in zip(code.inputs, given, strict=True)
            for k, number in enumerate(row)
        }
        results = enclose(program, state, BITS)
        for name in asked:
            odd = _odd(name, results[name], tables, i, kind)
            if odd is not None:
                words, allowed, found = odd
                told = tuple((g, " ".join(map(str, row))) for (g, _), row in
                              zip(code.inputs, given, strict=True))  # fmt: skip
                return refuted(subject, words, allowed, float(found), told)
            bounds += [
                (min(near), arb(float(found)), max(near))
                for value, found in zip(results[name], tables[f"{name}_expected"][i], strict=True)
                for near in [_allowed(value, kind)]
            ]
    words = f"{count} states: every expected value is the enclosed one, rounded once"
    return enclosed(subject, bounds, words)


def _row(rows: Rows, i: int) -> list[Fraction]:
    return rows[i] if len(rows) > 1 else rows[0]


def _odd(
    name: str, values: Sequence[arb], tables: Mapping[str, Rows], i: int, kind: str
) -> tuple[str, arb, Fraction] | None:
    """What is wrong with a row, the ball of what may stand there, and what does."""
    expected, tolerance = tables[f"{name}_expected"][i], tables[f"{name}_tolerance"][i]
    size = max((abs(float(v.mid())) for v in values), default=0.0)
    most = Fraction(2.0 ** (SLACK - DIGITS[kind] // 2) * size)
    for k, (value, found, room) in enumerate(zip(values, expected, tolerance, strict=True)):
        near = _allowed(value, kind)
        if found not in near:
            return f"{name}_expected[{i}][{k}] is not the value", _between(*_ends(near)), found
        if not 0 <= room <= most:
            words = f"{name}_tolerance[{i}][{k}] is too large to tell anything"
            return words, _between(Fraction(0), most), room
    return None


def _ends(numbers: set[Fraction]) -> tuple[Fraction, Fraction]:
    return min(numbers), max(numbers)


def _between(low: Fraction, high: Fraction) -> arb:
    """The ball of a range whose ends are doubles."""
    return arb(float((low + high) / 2), float((high - low) / 2))


def _allowed(value: arb, kind: str) -> set[Fraction]:
    """The number of a type that is next to a value."""
    nearest = TYPES[kind](0.0 if value.contains(0) else float(value.mid()))
    near = {Fraction(float(np.nextafter(nearest, TYPES[kind](way)))) for way in (-np.inf, np.inf)}
    # In single precision a double was rounded once more.
    return {Fraction(float(nearest))} | (near if kind == "float" else set())

"""Programs as JSON, exactly, and back.

    {"format": "straight-line program 1",
     "inputs": ["x", "y"],
     "nodes": [["input", 0], ["constant", "1/3"], ["multiply", 1, 0], ["pi"],
               ["solve", true, 1, 0, 2], ["entry", 4, 0]],
     "outputs": {"f": [2, 5]}}

A node is the name of its operation with the numbers of earlier nodes. A constant has its value as a
string, an input its place among the inputs, ``solve`` whether the matrix is symmetric, the number
of rows n, the n n entries row by row and the n of the right side; ``entry`` takes a component of a
``solve``. What is read may come from anybody: it is checked, and its size is bounded.
"""

import json
import re
from array import array
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from mechanics.errors import InputError
from mechanics.program.operations import (
    BY_NAME,
    CONSTANT,
    ENTRY,
    INPUT,
    OPERATIONS,
    PI,
    SOLVE,
)
from mechanics.program.program import Program

FORMAT = "straight-line program 1"
LARGEST_TEXT = 1 << 28
"""Characters."""
LARGEST_PROGRAM = 1 << 22
"""Nodes, entries of systems counted too."""
LONGEST_NUMBER = 2000
"""Digits above and below."""
LONGEST_NAME = 200

_NUMBER = re.compile(rf"-?\d{{1,{LONGEST_NUMBER}}}(/\d{{1,{LONGEST_NUMBER}}})?", re.ASCII)


def write(program: Program) -> str:
    """The program in JSON.

    Raises
    ------
    InputError
        If a constant has more than 2000 digits.

    Examples
    --------
    >>> from mechanics.program import Builder
    >>> b = Builder()
    >>> program = b.program({"f": [b.input("x") / 3]})
    >>> read(write(program)) == program
    True
    """
    nodes = [_written(program, number) for number in range(len(program))]
    outputs = {name: list(numbers) for name, numbers in program.outputs.items()}
    whole = {"format": FORMAT, "inputs": list(program.inputs), "nodes": nodes, "outputs": outputs}
    return json.dumps(whole, separators=(",", ":"), ensure_ascii=False)


def _written(program: Program, number: int) -> list[Any]:
    code = program.operations[number]
    name, place = OPERATIONS[code].name, program.operands[0][number]
    if code == CONSTANT:
        value = program.constants[place]
        if max(abs(value.numerator), value.denominator) >= 10**LONGEST_NUMBER:
            raise InputError(f"a constant of more than {LONGEST_NUMBER} digits cannot be written")
        return [name, str(value)]
    if code == INPUT:
        return [name, place]
    if code == ENTRY:
        return [name, place, program.operands[1][number]]
    if code == SOLVE:
        size, symmetric, *entries = program.systems[place]
        return [name, bool(symmetric), size, *entries]
    return [name, *program.operands_of(number)]


def read(text: str) -> Program:
    """The program that was written.

    Raises
    ------
    InputError
        If it is no program, or larger than what is read; the node is named.
    """
    if len(text) > LARGEST_TEXT:
        raise InputError(f"program: {len(text)} characters found, at most {LARGEST_TEXT} are read")
    try:
        whole = json.loads(text)
    except (ValueError, RecursionError) as error:
        reason = str(error).partition("\n")[0]
        raise InputError(f"program: this is no JSON that can be read: {reason}") from None
    if not isinstance(whole, dict) or whole.get("format") != FORMAT:
        raise InputError(f'program: an object with "format": "{FORMAT}" expected')
    if unknown := sorted(set(whole) - {"format", "inputs", "nodes", "outputs"}):
        raise InputError(f"program: entry {unknown[0][:40]!r} is not known")
    inputs, nodes = _names(whole.get("inputs"), "inputs"), whole.get("nodes")
    outputs = whole.get("outputs")
    if not isinstance(nodes, list) or not isinstance(outputs, dict):
        raise InputError("program: a list of nodes and an object of outputs expected")
    reader = _Reader(inputs)
    for node in nodes:
        reader.add(node)
    _names(list(outputs), "outputs")
    return reader.program(outputs)


def _names(names: Any, what: str) -> tuple[str, ...]:
    if not isinstance(names, list) or not all(isinstance(n, str) for n in names):
        raise InputError(f"program: {what} are not named by strings")
    if any(not 0 < len(name) <= LONGEST_NAME or "\n" in name for name in names):
        raise InputError(f"program: names of {what} have 1 to {LONGEST_NAME} characters on a line")
    if len(set(names)) < len(names):
        raise InputError(f"program: two {what} have one name")
    return tuple(names)


class _Reader:
    """The nodes that have been read."""

    def __init__(self, inputs: tuple[str, ...]) -> None:
        self.inputs = inputs
        self.operations = bytearray()
        self.operands = array("i"), array("i"), array("i")
        self.constants: list[Fraction] = []
        self.systems: list[tuple[int, ...]] = []
        self.size = 0

    def refuse(self, reason: str) -> InputError:
        """An error that names the node."""
        return InputError(f"program: node {len(self.operations)} {reason}")

    def add(self, node: Any) -> None:
        """Read one node."""
        name = node[0] if isinstance(node, list) and node else None
        row = BY_NAME.get(name) if isinstance(name, str) else None
        if row is None:
            raise self.refuse("is no list that begins with the name of an operation")
        self.size += len(node)
        if self.size > LARGEST_PROGRAM:
            raise self.refuse(f"is too much: {LARGEST_PROGRAM} entries are read")
        rest = node[1:]
        if row.code == CONSTANT:
            places = [self.constant(rest)]
        elif row.code == INPUT:
            places = self.numbers(rest, 1, len(self.inputs), "inputs")
        elif row.code == SOLVE:
            places = [self.system(rest)]
        elif row.code == ENTRY:
            places = self.entry(rest)
        else:
            arity = 0 if row.code == PI else row.arity
            places = self.numbers(rest, arity, len(self.operations), "earlier nodes")
            self.refuse_systems(places)
            if row.exact and all(self.operations[n] == CONSTANT for n in places):
                # Otherwise a short text could stand for numbers without end.
                raise self.refuse(f"is {row.name} of constants: write the number that it is")
        self.operations.append(row.code)
        for column, place in zip(self.operands, [*places, 0, 0, 0], strict=False):
            column.append(place)

    def numbers(self, values: Any, count: int, below: int, what: str) -> list[int]:
        """So many whole numbers below a bound."""
        if len(values) != count:
            raise self.refuse(f"has {len(values)} operands, {count} expected")
        if not all(type(value) is int and 0 <= value < below for value in values):
            raise self.refuse(f"refers to something else than the {below} {what}")
        return list(values)

    def refuse_systems(self, numbers: Sequence[int]) -> None:
        """Only `entry` takes the solution of a system."""
        if any(self.operations[number] == SOLVE for number in numbers):
            raise self.refuse("computes with a whole system: take an entry of its solution")

    def constant(self, rest: list[Any]) -> int:
        """The place of a new constant."""
        value = rest[0] if len(rest) == 1 else None
        if not isinstance(value, str) or not _NUMBER.fullmatch(value):
            raise self.refuse(f"is no fraction in a string, of {LONGEST_NUMBER} digits at most")
        try:
            self.constants.append(Fraction(value))
        except ZeroDivisionError:
            raise self.refuse("divides by 0") from None
        return len(self.constants) - 1

    def system(self, rest: list[Any]) -> int:
        """The place of a new linear system."""
        if len(rest) < 2 or type(rest[0]) is not bool or type(rest[1]) is not int or rest[1] < 1:
            raise self.refuse("does not say whether it is symmetric, and its number of rows")
        symmetric, size = rest[0], rest[1]
        if len(rest) - 2 != size * (size + 1):
            raise self.refuse(f"has {len(rest) - 2} entries, {size} x {size} + {size} expected")
        entries = self.numbers(rest[2:], len(rest) - 2, len(self.operations), "earlier nodes")
        self.refuse_systems(entries)
        self.systems.append((size, int(symmetric), *entries))
        return len(self.systems) - 1

    def entry(self, rest: list[Any]) -> list[int]:
        """The node of a system, and the index of a component."""
        number, index = self.numbers(rest, 2, LARGEST_PROGRAM, "nodes")
        if number >= len(self.operations) or self.operations[number] != SOLVE:
            raise self.refuse("is an entry of something else than a system")
        if index >= self.systems[self.operands[0][number]][0]:
            raise self.refuse(f"is entry {index} of a smaller system")
        return [number, index]

    def program(self, outputs: dict[str, Any]) -> Program:
        """Freeze it, as it stands."""
        checked: dict[str, tuple[int, ...]] = {}
        for name, numbers in outputs.items():
            count, known = len(self.operations), isinstance(numbers, list)
            if not known or not all(type(n) is int and 0 <= n < count for n in numbers):
                raise InputError(f"program: output {name} is no list of node numbers")
            if any(self.operations[n] == SOLVE for n in numbers):
                raise InputError(f"program: output {name} is a whole system: take its entries")
            checked[name] = tuple(numbers)
        return Program(
            self.inputs, bytes(self.operations), self.operands, tuple(self.constants),
            tuple(self.systems), checked,
        )  # fmt: skip

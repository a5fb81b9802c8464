"""A frozen program: nodes in an order in which each stands behind its operands.

It depends on what it computes alone: nodes are numbered from the outputs, and the operands of
commutative operations are ordered by what they are, never by when they were built.
"""

from __future__ import annotations

import hashlib
import sys
from array import array
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from mechanics.program.operations import ARITY, CONSTANT, ENTRY, INPUT, OPERATIONS, PI, SOLVE

LEAVES = frozenset({CONSTANT, PI, INPUT})


class Nodes:
    """A table of nodes: of a program, or of a builder that still grows."""

    operations: Sequence[int]
    operands: tuple[array[int], array[int], array[int]]
    constants: Sequence[Fraction]
    inputs: Sequence[str]
    systems: Sequence[tuple[int, ...]]

    def operands_of(self, number: int) -> tuple[int, ...]:
        """Numbers of the nodes that a node needs."""
        code = self.operations[number]
        if code == SOLVE:
            return self.systems[self.operands[0][number]][2:]
        first, second, third = self.operands
        return (first[number], second[number], third[number])[: ARITY[code]]


@dataclass(frozen=True, eq=False, repr=False)
class Program(Nodes):
    """A straight-line program.

    Attributes
    ----------
    inputs : tuple of str
        Names of the inputs, in the order in which an interpreter takes them.
    operations : bytes
        Code of the operation of each node.
    operands : three arrays of int
        Numbers of the operand nodes. A constant, input or system has its place in `constants`,
        `inputs` or `systems` as the first; an entry of a solution has its index as the second.
    constants : tuple of Fraction
    systems : tuple of (n, symmetric, n n + n node numbers)
        Matrix, row by row, and right side of each linear system.
    outputs : mapping of str to tuple of int
    """

    inputs: tuple[str, ...]
    operations: bytes
    operands: tuple[array[int], array[int], array[int]] = field(repr=False)
    constants: tuple[Fraction, ...]
    systems: tuple[tuple[int, ...], ...]
    outputs: Mapping[str, tuple[int, ...]]

    def __len__(self) -> int:
        return len(self.operations)

    def __repr__(self) -> str:
        names = ", ".join(self.outputs)
        return f"<program of {self.count} operations: {names}>"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Program) and self.digest == other.digest

    def __hash__(self) -> int:
        return hash(self.digest)

    @property
    def count(self) -> int:
        """Operations, leaves and the picking of components aside."""
        return sum(self.counts().values())

    def counts(self) -> dict[str, int]:
        """How often each operation stands in it."""
        codes = Counter(self.operations)
        named = ((OPERATIONS[code].name, count) for code, count in codes.items()
                 if code not in LEAVES and code != ENTRY)  # fmt: skip
        return dict(sorted(named))

    @property
    def roots(self) -> Iterator[int]:
        """Node numbers of all outputs."""
        for numbers in self.outputs.values():
            yield from numbers

    @property
    def digest(self) -> str:
        """SHA-256 of all of it, in hexadecimal: the same for the same program, on every machine."""
        found = hashlib.sha256(self.operations)
        for column in self.operands:
            words = array("i", column)
            if sys.byteorder == "big":
                words.byteswap()
            found.update(words.tobytes())
        rest = (self.inputs, [*map(_digits, self.constants)], self.systems, [*self.outputs.items()])
        found.update(repr(rest).encode())
        return found.hexdigest()


MOST_BITS = 14_000
"""Python writes no integer of more than 4300 decimal digits."""


def _digits(value: Fraction) -> str:
    """A rational as text, in hexadecimal where it is too long for decimals."""
    if max(value.numerator.bit_length(), value.denominator.bit_length()) <= MOST_BITS:
        return str(value)
    return f"{value.numerator:x}/{value.denominator:x}"


def reachable(nodes: Nodes, roots: Sequence[int]) -> list[int]:
    """Numbers of the nodes that the roots need, operands before results."""
    needed = bytearray(max(roots, default=-1) + 1)
    for root in roots:
        needed[root] = 1
    # Operands have smaller numbers: one walk down meets every node after all that need it.
    found, number = list[int](), needed.rfind(1)
    while number >= 0:
        found.append(number)
        for operand in nodes.operands_of(number):
            needed[operand] = 1
        number = needed.rfind(1, 0, number)
    return found[::-1]


def freeze(
    nodes: Nodes, outputs: Mapping[str, tuple[int, ...]], inputs: Sequence[str] | None
) -> Program:
    """The canonical program of what the outputs need.

    Raises
    ------
    ValueError
        If an output uses an input that is not listed.
    """
    roots = [number for numbers in outputs.values() for number in numbers]
    needed = reachable(nodes, roots)
    used = {nodes.inputs[nodes.operands[0][n]] for n in needed if nodes.operations[n] == INPUT}
    names = tuple(sorted(used)) if inputs is None else tuple(inputs)
    if missing := sorted(used - set(names)):
        raise ValueError(f"input {missing[0]} is used and not listed")
    ordered = _operands(nodes, needed)
    order = _from_outputs(roots, ordered)
    return _numbered(nodes, outputs, names, ordered, order)


_PRIME = (1 << 127) - 1
_MULTIPLIERS = tuple(
    int.from_bytes(hashlib.sha256(f"operand {k}".encode()).digest()[:15], "big") for k in range(4)
)


def _name_hash(text: str) -> int:
    return int.from_bytes(hashlib.sha256(text.encode()).digest()[:15], "big")


def _operands(nodes: Nodes, needed: Sequence[int]) -> dict[int, tuple[int, ...]]:
    """Operands of each node, those of commutative operations ordered by structure."""
    operations, (first, second, _) = nodes.operations, nodes.operands
    names = [_name_hash(row.name) for row in OPERATIONS]
    commutative = [row.commutative for row in OPERATIONS]
    hashes: dict[int, int] = {}
    found: dict[int, tuple[int, ...]] = {}
    for n in needed:
        code, below = operations[n], nodes.operands_of(n)
        mixed = names[code]
        if code == CONSTANT:
            mixed += _name_hash(_digits(nodes.constants[first[n]]))
        elif code == INPUT:
            mixed += _name_hash(nodes.inputs[first[n]])
        elif code == SOLVE:
            for entry in below:
                mixed = (mixed * _MULTIPLIERS[0] + hashes[entry]) % _PRIME
        else:
            if commutative[code] and hashes[below[1]] < hashes[below[0]]:
                below = below[::-1]
            for operand, multiplier in zip(below, _MULTIPLIERS, strict=False):
                mixed += hashes[operand] * multiplier
            if code == ENTRY:
                mixed += second[n] * _MULTIPLIERS[-1]
        found[n] = below
        mixed %= _PRIME
        hashes[n] = mixed * mixed % _PRIME * mixed % _PRIME
    return found


def _from_outputs(roots: Sequence[int], operands: Mapping[int, tuple[int, ...]]) -> list[int]:
    """Nodes in the order in which a walk from the outputs finishes them."""
    done: set[int] = set()
    order: list[int] = []
    for root in roots:
        stack = [root]
        while stack:
            number = stack[-1]
            if number in done:
                stack.pop()
                continue
            waiting = [operand for operand in operands[number] if operand not in done]
            if waiting:
                stack.extend(reversed(waiting))
            else:
                done.add(number)
                order.append(number)
                stack.pop()
    return order


def _numbered(
    nodes: Nodes,
    outputs: Mapping[str, tuple[int, ...]],
    names: tuple[str, ...],
    operands: Mapping[int, tuple[int, ...]],
    order: Sequence[int],
) -> Program:
    place = {name: k for k, name in enumerate(names)}
    new = {old: k for k, old in enumerate(order)}
    columns = array("i"), array("i"), array("i")
    constants: list[Fraction] = []
    systems: list[tuple[int, ...]] = []
    for old in order:
        code, row = nodes.operations[old], [0, 0, 0]
        if code == CONSTANT:
            row[0] = len(constants)
            constants.append(nodes.constants[nodes.operands[0][old]])
        elif code == INPUT:
            row[0] = place[nodes.inputs[nodes.operands[0][old]]]
        elif code == SOLVE:
            row[0] = len(systems)
            head = nodes.systems[nodes.operands[0][old]][:2]
            systems.append((*head, *(new[entry] for entry in operands[old])))
        else:
            for k, operand in enumerate(operands[old]):
                row[k] = new[operand]
            if code == ENTRY:
                row[1] = nodes.operands[1][old]
        for column, value in zip(columns, row, strict=True):
            column.append(value)
    return Program(
        names,
        bytes(nodes.operations[old] for old in order),
        columns,
        tuple(constants),
        tuple(systems),
        {name: tuple(new[n] for n in numbers) for name, numbers in outputs.items()},
    )

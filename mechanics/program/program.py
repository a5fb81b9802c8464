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
from functools import lru_cache

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
    operations, (first, second, _) = nodes.operations, nodes.operands
    needed = bytearray(max(roots, default=-1) + 1)
    for root in roots:
        needed[root] = 1
    # Operands have smaller numbers: one walk down meets every node after all that need it.
    found, number = list[int](), needed.rfind(1)
    while number >= 0:
        found.append(number)
        if ARITY[operations[number]] == 2:
            needed[first[number]] = needed[second[number]] = 1
        else:
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
    operands = _operands(nodes, needed)
    return _numbered(nodes, outputs, names, operands, _from_outputs(roots, operands))


_PRIME = (1 << 127) - 1
_MULTIPLIERS = tuple(
    int.from_bytes(hashlib.sha256(f"operand {k}".encode()).digest()[:15], "big") for k in range(4)
)


@lru_cache(maxsize=65_536)
def _name_hash(text: str) -> int:
    return int.from_bytes(hashlib.sha256(text.encode()).digest()[:15], "big")


def _operands(nodes: Nodes, needed: Sequence[int]) -> dict[int, tuple[int, ...]]:
    """Operands of each node, those of commutative operations ordered by structure."""
    operations, (first, second, _) = nodes.operations, nodes.operands
    names = [_name_hash(row.name) for row in OPERATIONS]
    commutative = [row.commutative for row in OPERATIONS]
    one, two, _, last = _MULTIPLIERS
    hashes: dict[int, int] = {}
    found: dict[int, tuple[int, ...]] = {}
    for n in needed:
        mixed, below = names[code := operations[n]], nodes.operands_of(n)
        if ARITY[code] == 2:
            if commutative[code] and hashes[below[1]] < hashes[below[0]]:
                below = below[::-1]
            mixed += hashes[below[0]] * one + hashes[below[1]] * two
        elif code == CONSTANT:
            mixed += _name_hash(_digits(nodes.constants[first[n]]))
        elif code == INPUT:
            mixed += _name_hash(nodes.inputs[first[n]])
        elif code == SOLVE:
            for entry in below:
                mixed = (mixed * one + hashes[entry]) % _PRIME
        else:
            mixed += sum(hashes[x] * k for x, k in zip(below, _MULTIPLIERS, strict=False))
            mixed += second[n] * last * (code == ENTRY)
        found[n] = below
        mixed %= _PRIME
        hashes[n] = mixed * mixed % _PRIME * mixed % _PRIME
    return found


def _from_outputs(roots: Sequence[int], operands: Mapping[int, tuple[int, ...]]) -> dict[int, int]:
    """New numbers by old ones, in the order in which a walk from the outputs finishes them."""
    new: dict[int, int] = {}
    for root in roots:
        stack = [root]
        while stack:
            number = stack.pop()
            # A node whose operands stand above it is there as ~number.
            if number < 0:
                new[~number] = len(new)
            elif number not in new:
                stack.append(~number)
                stack += operands[number][::-1]
    return new


def _numbered(
    nodes: Nodes,
    outputs: Mapping[str, tuple[int, ...]],
    names: tuple[str, ...],
    operands: Mapping[int, tuple[int, ...]],
    new: Mapping[int, int],
) -> Program:
    operations, (first, second, _) = nodes.operations, nodes.operands
    place = {name: k for k, name in enumerate(names)}
    rows = array("i")
    constants: list[Fraction] = []
    systems: list[tuple[int, ...]] = []
    for old in new:
        code, below = operations[old], operands[old]
        if ARITY[code] == 2:
            rows.extend((new[below[0]], new[below[1]], 0))
        elif code == CONSTANT:
            rows.extend((len(constants), 0, 0))
            constants.append(nodes.constants[first[old]])
        elif code == INPUT:
            rows.extend((place[nodes.inputs[first[old]]], 0, 0))
        elif code == SOLVE:
            rows.extend((len(systems), 0, 0))
            systems.append((*nodes.systems[first[old]][:2], *(new[entry] for entry in below)))
        else:
            index = second[old] if code == ENTRY else 0
            rows.extend((*(new[operand] for operand in below), index, 0, 0)[:3])
    return Program(
        names,
        bytes(operations[old] for old in new),
        (rows[0::3], rows[1::3], rows[2::3]),
        tuple(constants),
        tuple(systems),
        {name: tuple(new[n] for n in numbers) for name, numbers in outputs.items()},
    )

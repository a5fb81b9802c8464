"""Second step of the chain: graph = C text, output by output.

The text is parsed and its operations are carried out in exact arithmetic, beside those of the
graph, at the same arguments. Sine and cosine by inline text are sine and cosine here; that text has
a check of its own.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sympy import Symbol

from mechanics.compiled.custody.code import Code
from mechanics.compiled.custody.constants import interpreted, literals
from mechanics.compiled.custody.kernel import Kernel, lowered
from mechanics.errors import ExpressionError
from mechanics.exact import Arithmetic
from mechanics.exact.c.parse import Source
from mechanics.exact.c.program import CProgram
from mechanics.exact.graph import evaluated
from mechanics.program.casadi_reader import Instruction as Node

Symbols = Mapping[str, Sequence[Symbol]]


@dataclass(frozen=True)
class Text:
    """A C function beside the graph that it should be.

    Attributes
    ----------
    kernel : Kernel
    code : Code
        The graph; for ``prepare`` that of the function whose parameters are prepared.
    program : CProgram
    nodes : tuple of Node
        Of the text, with literals as the constants that they stand for.
    of : tuple of int
        Where each node of the program is among these.
    groups : tuple of (str, int)
        Inputs in the order of the arguments, with their sizes; the integers left out.
    outputs : tuple of (str, int)
        Outputs likewise.
    """

    kernel: Kernel
    code: Code
    program: CProgram
    nodes: tuple[Node, ...]
    of: tuple[int, ...]
    groups: tuple[tuple[str, int], ...]
    outputs: tuple[tuple[str, int], ...]

    @property
    def first(self) -> int:
        """Place of the first array among the arguments."""
        return 2 if self.kernel.lanes else 0

    def entries(self) -> Iterator[tuple[str, tuple[int, int]]]:
        """Name and place of every entry of the outputs."""
        for i, (name, size) in enumerate(self.outputs):
            for entry in range(size):
                yield f"{name}[{entry}]", (self.first + len(self.groups) + i, entry)

    def numbers(self, a: Arithmetic, given: Mapping[str, Sequence[Any]]) -> list[Any]:
        """The number of every node.

        Parameters
        ----------
        given : mapping of str to sequence of numbers
            By name of the input.
        """
        arguments: list[Sequence[Any]] = [()] * self.first
        arguments += [given[group] for group, _ in self.groups]
        arguments += [()] * len(self.outputs)
        arguments.append([a.value(constant) for constant in self.code.constants])
        # What is read beyond an array is the place -1: the last.
        arguments.append([a.value(Symbol(words, real=True)) for words in self.program.beyond])
        return evaluated(a, self.nodes, arguments, whole_angles=True)

    def written(self, numbers: Sequence[Any]) -> Iterator[tuple[str, Any]]:
        """Every number that an entry of an output gets; mostly one."""
        for name, at in self.entries():
            for written in self.program.outputs[at]:
                yield name, numbers[self.of[written.node]]


def read_text(
    kernel: Kernel, source: Source, code: Code, groups: Sequence[tuple[str, int]],
    outputs: Sequence[tuple[str, int]],
) -> Text:  # fmt: skip
    """Read a C function.

    Parameters
    ----------
    kernel : Kernel
    source : Source
        Of its file, with those that it calls.
    code : Code
        Whose constants the literals may stand for.
    groups, outputs : sequences of (str, int)
        Names and sizes of the arrays that it takes and gives.

    Raises
    ------
    ExpressionError
        If the text holds what is not known here, or an output is not written.
    """
    kept = tuple((name, size) for name, size in groups if size)
    asked = tuple((name, size) for name, size in outputs if size)
    program = lowered(source, kernel, kept, asked)
    place = (2 if kernel.lanes else 0) + len(kept) + len(asked)
    nodes, of = interpreted(program.nodes, literals(code, kernel.kind), code, place)
    text = Text(kernel, code, program, tuple(nodes), tuple(of), kept, asked)
    for name, at in text.entries():
        if at not in program.outputs:
            raise ExpressionError(f"{kernel.symbol}: {name} is not written")
        if program.outputs[at][0].condition is not True:
            raise ExpressionError(f"{kernel.symbol}: {name} is written under a condition only")
    return text

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
from mechanics.compiled.custody.derived import Derived
from mechanics.compiled.custody.graph import decide_entries, fix
from mechanics.compiled.custody.laws import Pair
from mechanics.errors import ExpressionError
from mechanics.exact import Arithmetic, Finding, Verdict
from mechanics.exact.c_functions import lower
from mechanics.exact.c_parse import Source
from mechanics.exact.c_program import CProgram, Parameter
from mechanics.exact.graph import evaluated

SMALL = 80
"""Nodes of a text for which a proof is tried beyond the certificate."""

COUNT, STRIDE = "count", "stride"


@dataclass(frozen=True)
class Kernel:
    """One function of a C text, and what it should be.

    Attributes
    ----------
    function : str
        Name in the model.
    symbol : str
        Name in C.
    file : str
    kind : str
        ``"double"`` or ``"float"``.
    lanes : bool
        Whether it is for a batch: a count, a stride, then the arrays.
    shared : tuple of str
        Inputs that all lanes share.
    prepare : str
        Name in C of the function that computes the input ``c`` from ``p``; empty for most.
    """

    function: str
    symbol: str
    file: str
    kind: str
    lanes: bool = False
    shared: tuple[str, ...] = ()
    prepare: str = ""


PREPARED, PARAMETERS = "c", "p"


def lowered(source: Source, kernel: Kernel, code: Code, held: int = 0) -> CProgram:
    """The straight-line code of a C text, with the arguments that the graph has.

    Parameters
    ----------
    held : int
        Entries of ``c``, where parameters are prepared.
    """
    given = [Parameter(COUNT, "size_t"), Parameter(STRIDE, "size_t")] if kernel.lanes else []
    for group, size in code.inputs:
        name, entries = (
            (PREPARED, held) if kernel.prepare and group == PARAMETERS else (group, size)
        )
        stride = STRIDE if kernel.lanes and group not in kernel.shared else ""
        given += [Parameter(name, kernel.kind, entries, False, stride)] if entries else []
    for name, (rows, columns) in code.shapes:
        stride = STRIDE if kernel.lanes else ""
        size = rows * columns
        given += [Parameter(name, kernel.kind, size, True, stride)] if size else []
    return lower(source, kernel.symbol, given)


def prove_text(
    kernel: Kernel, source: Source, code: Code, known: Derived, **options: Any
) -> Finding:
    """Decide whether a C function computes what a graph does.

    Parameters
    ----------
    kernel : Kernel
    source : Source
        Of its file.
    code : Code
        The graph, with exact constants.
    known : Derived
        For the names and signs of the inputs.
    **options
        As for `mechanics.exact.decide`.
    """
    subject = f"{kernel.file}: {kernel.symbol} = graph"
    try:
        text = _Text(kernel, source, code, known)
        options = {"try_normal": len(text.program.nodes) <= SMALL, **options}
        found = decide_entries(subject, text.pairs, **options)
    except ExpressionError as error:
        return Finding(subject, Verdict.UNDECIDED, f"refused: {error}")
    doubt = text.doubt()
    if found.shown and doubt:
        return Finding(subject, Verdict.UNDECIDED, doubt)
    return found


class _Text:
    """A C function beside its graph.

    Raises
    ------
    ExpressionError
        If the text holds what is not known here, or an output that is not written.
    """

    def __init__(self, kernel: Kernel, source: Source, code: Code, known: Derived) -> None:
        self.kernel, self.code, self.known = kernel, code, known
        self.held: tuple[CProgram, list[int]] | None = None
        if kernel.prepare:
            raise NotImplementedError
        self.program = lowered(source, kernel, code)
        self.table = literals(code, kernel.kind)
        self.groups = [group for group, size in code.inputs if size]
        skipped = 2 if kernel.lanes else 0
        self.place = skipped + len(self.groups)
        outs = [(name, rows * cols) for name, (rows, cols) in code.shapes if rows * cols]
        self.outputs = [
            (f"{name}[{entry}]", (self.place + i, entry))
            for i, (name, size) in enumerate(outs)
            for entry in range(size)
        ]
        self.constants = self.place + len(outs)
        self.nodes, self.of = interpreted(self.program.nodes, self.table, code, self.constants)
        for name, at in self.outputs:
            if at not in self.program.outputs:
                raise ExpressionError(f"{kernel.symbol}: {name} is not written")
            if self.program.outputs[at][0].condition is not True:
                raise ExpressionError(f"{kernel.symbol}: {name} is written under a condition only")

    def pairs(self, a: Arithmetic) -> Iterator[Pair]:
        """Every value that an output gets, beside the graph's."""
        fix(a, self.known)
        symbols = self.known.symbols
        expected = self.code.results(self.code.numbers(a, symbols, whole_angles=True))
        numbers = self.numbers(a, symbols)
        wanted = [n for name, (r, c) in self.code.shapes if r * c for n in expected[name]]
        for (name, at), right in zip(self.outputs, wanted, strict=True):
            for written in self.program.outputs[at]:
                yield name, numbers[self.of[written.node]], right

    def numbers(self, a: Arithmetic, symbols: Mapping[str, Sequence[Symbol]]) -> list[Any]:
        """The number of every node of the text."""
        given: list[list[Any]] = [[]] * (2 if self.kernel.lanes else 0)
        given += [[a.value(symbol) for symbol in symbols[group]] for group in self.groups]
        given += [[]] * (self.constants - self.place)
        given.append([a.value(constant) for constant in self.code.constants])
        # BEYOND is -1: the last.
        given.append([a.value(Symbol(words, real=True)) for words in self.program.beyond])
        return evaluated(a, self.nodes, given, whole_angles=True)

    def doubt(self) -> str:
        """What the text does besides, where it should not."""
        found = self.program
        if found.beyond:
            return f"refused: {found.beyond[0]} is read, beyond the end of the array"
        if found.late and not self.kernel.lanes:
            return (
                f"refused: {found.late[0]} is read after an output was written, which may be the"
                " same array"
            )
        return ""

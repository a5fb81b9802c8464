"""Whether a C function is what the graph says: its outputs, and the status that it returns."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from mechanics.compiled.custody.code import Code, exact
from mechanics.compiled.custody.constants import interpreted, literals
from mechanics.compiled.custody.derived import Derived
from mechanics.compiled.custody.graph import decide_entries, fix
from mechanics.compiled.custody.kernel import COUNT, Kernel
from mechanics.compiled.custody.laws import Pair
from mechanics.compiled.custody.text import Text, read_text
from mechanics.compiled.programs.hoist import CONSTANTS, PREPARE, PREPARED
from mechanics.compiled.programs.program import Program
from mechanics.errors import ExpressionError
from mechanics.exact import Arithmetic, Finding
from mechanics.exact.c.parse import Source
from mechanics.exact.graph import evaluated
from mechanics.kernel import undecided

SMALL = 80
"""Nodes of a text for which a proof is tried beyond the certificate."""


@dataclass(frozen=True)
class Graph:
    """One function as it was before it became C.

    Attributes
    ----------
    code : Code
        The graph with exact constants; for parts of a function that of the whole.
    written : Program
        What the C was printed from: the graph with doubles, rewritten for speed.
    """

    code: Code
    written: Program


def text_of(kernel: Kernel, source: Source, graph: Graph) -> Text:
    """Read the C function of a kernel."""
    written = graph.written
    outputs = [(name, rows * columns) for name, (rows, columns) in written.shapes]
    return read_text(kernel, source, graph.code, written.inputs, outputs)


def prove_text(
    kernel: Kernel,
    source: Source,
    graphs: Mapping[str, Graph],
    known: Derived,
    prepare: Kernel | None = None,
    **options: Any,
) -> tuple[Finding, Text | None]:
    """Decide whether a C function computes what its graph does.

    Parameters
    ----------
    kernel : Kernel
    source : Source
        Of its file, with those that it calls.
    graphs : mapping of str to Graph
    known : Derived
        For the names and signs of the inputs.
    prepare : Kernel, optional
        The function that prepares parameters, for one that takes them prepared.
    **options
        As for `mechanics.exact.decide`.

    Returns
    -------
    Finding
    Text or None
        The text that was read; None if it was refused.
    """
    graph = graphs[kernel.function]
    subject = f"{kernel.file}: {kernel.symbol} = graph"
    try:
        text = text_of(kernel, source, graph)
        before = text_of(prepare, source, graphs[prepare.function]) if prepare else None

        def pairs(a: Arithmetic) -> Iterator[Pair]:
            yield from _pairs(a, text, graph, known, before)

        small = len(text.nodes) <= SMALL
        found = decide_entries(subject, pairs, **{"try_normal": small, **options})
    except ExpressionError as error:
        return undecided(subject, f"refused: {error}"), None
    doubt = _doubt(text)
    if found.shown and doubt:
        return undecided(subject, doubt), text
    return found, text


def _pairs(
    a: Arithmetic, text: Text, graph: Graph, known: Derived, prepare: Text | None
) -> Iterator[Pair]:
    fix(a, known)
    given = {group: [a.value(s) for s in symbols] for group, symbols in known.symbols.items()}
    if text.kernel.function == PREPARE:
        numbers = program_numbers(a, graph, text.kernel.kind, given)
        results = [numbers[node] for nodes in graph.written.outputs for node in nodes]
        expected = {CONSTANTS: results}
    else:
        code = graph.code
        expected = code.results(code.numbers(a, known.symbols, whole_angles=True))
    if prepare is not None:
        held = dict(prepare.written(prepare.numbers(a, given)))
        given[CONSTANTS] = list(held.values())
    wanted = {f"{name}[{i}]": n for name, values in expected.items() for i, n in enumerate(values)}
    for name, number in text.written(text.numbers(a, given)):
        yield name, number, wanted[name]


def program_numbers(
    a: Arithmetic, graph: Graph, kind: str, given: Mapping[str, Sequence[Any]]
) -> list[Any]:
    """The number of every node of the program that the C was printed from."""
    code = exact(graph.written)
    place = len(code.inputs)
    nodes, of = interpreted(code.nodes, literals(graph.code, "double"), graph.code, place)
    arguments = [given[group] if size else [] for group, size in code.inputs]
    constants = [a.value(constant) for constant in graph.code.constants]
    numbers = evaluated(a, nodes, [*arguments, constants], whole_angles=True)
    return [numbers[i] for i in of]


def _doubt(text: Text) -> str:
    """What the text does besides, where it should not."""
    found = text.program
    if text.kernel.lanes and found.lanes != COUNT:
        return f"refused: its loop ends at {found.lanes or 'one state'}, not at the number of lanes"
    if found.beyond:
        return f"refused: {found.beyond[0]} is read, beyond the end of the array"
    if found.late and not text.kernel.lanes:
        return (
            f"refused: {found.late[0]} is read after an output was written, which may be the same"
            " array"
        )
    return ""


def is_prepared(function: str) -> bool:
    """Whether a function takes its parameters prepared."""
    return function.endswith(PREPARED)

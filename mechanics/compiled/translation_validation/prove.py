"""Whether a C function is what the graph says: its outputs, and the status that it returns."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from mechanics.compiled.programs.hoist import CONSTANTS, PREPARE, PREPARED
from mechanics.compiled.translation_validation.code import Code
from mechanics.compiled.translation_validation.constants import at_doubles, rounded_constants
from mechanics.compiled.translation_validation.defined import (
    counterparts,
    divides_by_zero,
    unmatched,
    where_defined,
)
from mechanics.compiled.translation_validation.derived import Derived
from mechanics.compiled.translation_validation.kernel import Kernel
from mechanics.compiled.translation_validation.physics import Entry, Physics
from mechanics.compiled.translation_validation.text import Groups, Reading, Text, read_into
from mechanics.errors import ExpressionError
from mechanics.kernel import Finding, undecided
from mechanics.program import Node
from mechanics.program.c.parse import Source
from mechanics.program.routine import Routine, nodes_of

SMALL = 80
"""Nodes of a text for which a proof is tried beyond the certificate."""


@dataclass(frozen=True)
class Graph:
    """One function as it was before it became C.

    Attributes
    ----------
    code : Code
        The graph with exact constants; for parts of a function that of the whole.
    written : Routine
        What the C was printed from: the graph with doubles, rewritten for speed.
    """

    code: Code
    written: Routine


def outputs_of(graph: Graph) -> Groups:
    """Names and sizes of what a function gives."""
    return [(name, rows * columns) for name, (rows, columns) in graph.written.shapes]


def read_beside(
    physics: Physics, kernel: Kernel, source: Source, graph: Graph,
    given: Mapping[str, Sequence[Node]],
) -> Reading:  # fmt: skip
    """Read a C function into the builder of the physics, with literals as what they stand for."""
    table = rounded_constants(physics, graph.code, kernel.kind).unknowns
    return read_into(
        physics.builder, kernel, source, graph.written.inputs, outputs_of(graph), given, table
    )


def prove_text(
    text: Text,
    source: Source,
    graphs: Mapping[str, Graph],
    known: Derived,
    prepare: Kernel | None = None,
    **options: Any,
) -> Finding:
    """Decide whether a C function computes what its graph does.

    Parameters
    ----------
    text : Text
        The function as it was written, see `read_text`.
    source : Source
        Of its file, with those that it calls.
    known : Derived
        For the names and signs of the inputs.
    prepare : Kernel, optional
        The function that prepares parameters, for one that takes them prepared.
    **options
        As for `mechanics.kernel.decide`.
    """
    kernel = text.kernel
    graph = graphs[kernel.function]
    subject = f"{kernel.file}: {kernel.symbol} = graph"
    physics = Physics(known)
    builder, given = physics.builder, dict(physics.inputs)
    try:
        expected = _expected(physics, kernel, graph)
        truth = tuple(builder.obligations)
        builder.obligations = {}
        if prepare is not None:
            before = read_beside(physics, prepare, source, graphs[prepare.function], given)
            given[CONSTANTS] = list(dict(before.written()).values())
        reading = read_beside(physics, kernel, source, graph, given)
        written = tuple(builder.obligations)
        entries: list[Entry] = [(n, node, expected[n]) for n, node in reading.written()]
        small = len(text.program) <= SMALL
        demands: list[Entry] = []
        if not small and any(left != right for _, left, right in entries):
            # What the field decides, it decides of the divisors by the same draws.
            pairs = counterparts(physics, list(unmatched(written, truth)), truth)
            demands = [("divisor", left, right) for left, right in pairs]
        options = {"try_normal": small, **options}
        found = physics.decide_entries(subject, [*entries, *demands], **options)
        if demands and not found.shown:
            demands, found = [], physics.decide_entries(subject, entries, **options)
        if not found.shown:
            return found
        if doubt := reading.doubt or divides_by_zero(physics, written):
            return undecided(subject, doubt)
        return where_defined(found, physics, () if demands else written, truth)
    except ExpressionError as error:
        return undecided(subject, f"refused: {error}")


def _expected(physics: Physics, kernel: Kernel, graph: Graph) -> dict[str, Node]:
    """What the entries of the outputs should be, by name."""
    code = graph.code
    if kernel.function == PREPARE:
        flat = [k for numbers in graph.written.outputs for k in numbers]
        nodes = written_nodes(physics, kernel, graph, physics.inputs, flat)
        results = {CONSTANTS: list(nodes)}
    else:
        known = rounded_constants(physics, code, kernel.kind)
        results = code.results(physics.builder, physics.inputs, *at_doubles(code, known))
    return {f"{name}[{i}]": n for name, nodes in results.items() for i, n in enumerate(nodes)}


def written_nodes(
    physics: Physics, kernel: Kernel, graph: Graph,
    given: Mapping[str, Sequence[Node]], wanted: Sequence[int],
) -> tuple[Node, ...]:  # fmt: skip
    """Values of the program that the C was printed from, its doubles as what they stand for."""
    known = rounded_constants(physics, graph.code, kernel.kind)
    table = {double: known.node(double) for double in graph.written.program.constants}
    return nodes_of(physics.builder, graph.written, given, wanted, table)


def is_prepared(function: str) -> bool:
    """Whether a function takes its parameters prepared."""
    return function.endswith(PREPARED)

"""The chain of custody of one folder: what is shown about it.

1   derived equations = graph          each function
2   graph = C text                     each C function, its outputs and its status
3   C text = binary                    each compiler that is found
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from mechanics.compiled.custody.code import Code
from mechanics.compiled.custody.derived import Derived
from mechanics.compiled.custody.graph import prove_derived
from mechanics.compiled.custody.kernel import Kernel
from mechanics.compiled.custody.prove import Graph, is_prepared, prove_text
from mechanics.compiled.custody.status import prove_status
from mechanics.compiled.custody.text import Text
from mechanics.compiled.programs.hoist import PREPARE
from mechanics.compiled.programs.of_model import PARTS, WHOLE
from mechanics.errors import ExpressionError, InputError
from mechanics.export.evidence.graphs import RATES
from mechanics.export.evidence.texts import not_named, sources
from mechanics.kernel import Finding, undecided
from mechanics.program.c.parse import Source

SMALL = 80
"""Nodes of a graph for which a proof is tried beyond the certificate."""


@dataclass(frozen=True)
class Evidence:
    """What the files of a folder say, read.

    Attributes
    ----------
    known : Derived
    graphs : mapping of str to Graph
        By function.
    rates : Code or None
        The graph that the step is made of.
    kernels : tuple of Kernel
    texts : mapping of str to str
        C files and headers by name.
    """

    known: Derived
    graphs: Mapping[str, Graph]
    rates: Code | None
    kernels: tuple[Kernel, ...]
    texts: Mapping[str, str]


@dataclass(frozen=True)
class Read:
    """A kernel whose text is the graph's, for the third step."""

    kernel: Kernel
    text: Text
    prepare: Text | None = None


Report = Callable[[str], None]
"""Told what is looked at."""


def silent(words: str) -> None:
    """Nobody is told."""


def first_step(evidence: Evidence, known: Derived, report: Report = silent) -> Iterator[Finding]:
    """Decide for each graph whether it is what was derived."""
    codes = [(name, name, g.code) for name, g in evidence.graphs.items() if name not in PARTS]
    whole = [code for name, _, code in codes if name == WHOLE]
    for name in PARTS:
        # Their text is compared with the graph of the whole, which has to be the one above.
        if name in evidence.graphs and evidence.graphs[name].code not in whole:
            whole.append(evidence.graphs[name].code)
            codes.append((f"{WHOLE} of {name}", WHOLE, whole[-1]))
    if evidence.rates is not None:
        codes.append((RATES, RATES, evidence.rates))
    for title, name, code in codes:
        report(f"{title}: equations = graph")
        small = len(code.routine.nodes) <= SMALL
        try:
            found = prove_derived(name, code, known, evidence.rates, try_normal=small)
        except (ExpressionError, InputError, KeyError) as error:
            words = f"refused: {error}"
            found = undecided(f"compiled {title} = derived", words)
        yield found if title == name else replace(found, subject=f"{found.subject}, for {title}")


def second_step(evidence: Evidence, read: list[Read], report: Report = silent) -> Iterator[Finding]:
    """Decide for each C function whether it is its graph; `read` gets those that are."""
    found = sources(evidence.kernels, evidence.texts)
    for kernel in evidence.kernels:
        for (file, title), source in found.items():
            if file == kernel.file:
                report(f"{kernel.symbol}: graph = text")
                yield from _kernel(evidence, kernel, title, source, read)
    plain = {f: s for (f, t), s in found.items() if not t and isinstance(s, Source)}
    for name in not_named(evidence.kernels, plain):
        words = "refused: the manifest does not say what this function should be"
        yield undecided(name, words)


def _is_static(source: Source, name: str) -> bool:
    definition = source.functions.get(name)
    return definition is not None and "static" in (definition.decl.storage or ())


def _kernel(
    evidence: Evidence,
    kernel: Kernel,
    title: str,
    source: Source | ExpressionError,
    read: list[Read],
) -> Iterator[Finding]:
    subject = f"{kernel.file}: {kernel.symbol} = graph"
    prepare = _preparing(evidence.kernels, kernel)
    words = ""
    if isinstance(source, ExpressionError):
        words = str(source)
    elif kernel.function not in evidence.graphs:
        words = "it has no graph"
    elif is_prepared(kernel.function) and prepare is None:
        words = f"there is no {PREPARE} function beside it"
    elif _is_static(source, kernel.symbol):
        words = "it is static: no other file can call it"
    if isinstance(source, ExpressionError) or words:
        yield _titled(undecided(subject, f"refused: {words}"), title)
        return
    finding, text = prove_text(kernel, source, evidence.graphs, evidence.known, prepare)
    yield _titled(finding, title)
    if text is not None and finding.shown:
        graph = evidence.graphs[kernel.function]
        status = prove_status(kernel, source, graph, evidence.known)
        yield _titled(status, title)
        if status.shown and not title:
            read.append(Read(kernel, text))


def _titled(finding: Finding, title: str) -> Finding:
    """The finding about a text that is read with some macros defined."""
    return replace(finding, subject=f"{finding.subject}, with {title}") if title else finding


def _preparing(kernels: Sequence[Kernel], kernel: Kernel) -> Kernel | None:
    """The function that prepares the parameters of another."""
    if not is_prepared(kernel.function):
        return None
    same = (k for k in kernels if k.function == PREPARE and k.kind == kernel.kind)
    return next((k for k in same if k.file == kernel.file), None)

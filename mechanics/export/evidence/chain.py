"""The chain of translation validation of one folder: what is shown about it.

1   derived equations = graph          each function
2   graph = C text                     each C function, its outputs and its status
3   C text = binary                    each compiler that is found
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from mechanics.compiled.programs.hoist import PREPARE
from mechanics.compiled.programs.of_model import PARTS, WHOLE
from mechanics.compiled.translation_validation.binary import Measured
from mechanics.compiled.translation_validation.code import Code
from mechanics.compiled.translation_validation.derived import Derived
from mechanics.compiled.translation_validation.graph import prove_derived
from mechanics.compiled.translation_validation.kernel import Kernel
from mechanics.compiled.translation_validation.prove import (
    Graph,
    is_prepared,
    outputs_of,
    prove_text,
)
from mechanics.compiled.translation_validation.status import prove_status
from mechanics.compiled.translation_validation.text import Text, read_text, reads_alike
from mechanics.errors import ExpressionError, InputError
from mechanics.export.evidence.graphs import RATES
from mechanics.export.evidence.texts import not_named, sources
from mechanics.kernel import Finding, Verdict, undecided
from mechanics.program.c.parse import Source

PHYSICS = "physics, derived again = graph"
GRAPH = "derived equations = graph"
TEXT = "graph = C text"
NUMBERS = "numbers in headers and self-tests"
SINES = "inline sine and cosine = sine and cosine"
BINARY = "C text = binary"
NO_SINES = "the text of the inline sine and cosine is proved by `mechanics verify`"
NOT_ASKED = "the code was not compiled, as asked"
NO_COMPILER = "the code was not compiled: no C compiler was found"
NOT_SHOWN = "the code was neither compiled nor run: a text is not shown to be its graph"

SMALL = 80
"""Nodes of a graph for which a proof is tried beyond the certificate."""


@dataclass(frozen=True)
class Evidence:
    """What the files of a folder say, read.

    Attributes
    ----------
    graphs : mapping of str to Graph
        By function.
    rates : Code or None
        The graph that the step is made of.
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


@dataclass(frozen=True)
class Chain:
    """What is shown about generated code.

    Attributes
    ----------
    steps : tuple of (str, tuple of Finding)
        Title and findings of each step.
    measured : tuple of Measured
        Errors of binaries.
    not_done : tuple of str
        What was not looked at, and why: sentences.
    """

    steps: tuple[tuple[str, tuple[Finding, ...]], ...]
    measured: tuple[Measured, ...]
    not_done: tuple[str, ...]

    @property
    def verdicts(self) -> set[Verdict]:
        """Every verdict that occurs."""
        return {finding.verdict for _, findings in self.steps for finding in findings}


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
    """Decide for each C function whether it is its graph; `read` gets those that are.

    A text that reads the same with other macros has the findings that it has without them.
    """
    found = sources(evidence.kernels, evidence.texts)
    for kernel in evidence.kernels:
        first: _Judged | None = None
        for (file, title), source in found.items():
            if file == kernel.file:
                report(f"{kernel.symbol}: graph = text")
                judged = _kernel(evidence, kernel, source, first)
                first = first or judged
                yield from (_titled(finding, title) for finding in judged.findings)
        if first is not None and first.texts and all(one.shown for one in first.findings):
            read.append(Read(kernel, first.texts[0]))
    plain = {f: s for (f, t), s in found.items() if not t and isinstance(s, Source)}
    for name in not_named(evidence.kernels, plain):
        words = "refused: the manifest does not say what this function should be"
        yield undecided(name, words)


def _is_static(source: Source, name: str) -> bool:
    definition = source.functions.get(name)
    return definition is not None and "static" in (definition.decl.storage or ())


@dataclass(frozen=True)
class _Judged:
    """What is found about a kernel as it reads with some macros, and what was read."""

    findings: tuple[Finding, ...]
    texts: tuple[Text, ...] = ()


def _kernel(
    evidence: Evidence,
    kernel: Kernel,
    source: Source | ExpressionError,
    first: _Judged | None,
) -> _Judged:
    subject = f"{kernel.file}: {kernel.symbol} = graph"
    prepare = _preparing(evidence.kernels, kernel)
    words = ""
    if isinstance(source, ExpressionError):
        words = str(source)
    elif kernel.function not in evidence.graphs:
        words = "it has no graph"
    elif is_prepared(kernel.function) and (prepare is None or PREPARE not in evidence.graphs):
        words = f"there is no {PREPARE} function beside it"
    elif _is_static(source, kernel.symbol):
        words = "it is static: no other file can call it"
    if isinstance(source, ExpressionError) or words:
        return _Judged((undecided(subject, f"refused: {words}"),))
    try:
        texts = tuple(_text(evidence, k, source) for k in (kernel, prepare) if k is not None)
    except ExpressionError as error:
        return _Judged((undecided(subject, f"refused: {error}"),))
    alike = first is not None and len(first.texts) == len(texts)
    if first is not None and alike and all(map(reads_alike, texts, first.texts)):
        return first
    graphs, known = evidence.graphs, evidence.known
    finding = prove_text(texts[0], source, graphs, known, prepare)
    if not finding.shown:
        return _Judged((finding,), texts)
    status = prove_status(kernel, source, graphs[kernel.function], known)
    return _Judged((finding, status), texts)


def _text(evidence: Evidence, kernel: Kernel, source: Source) -> Text:
    graph = evidence.graphs[kernel.function]
    return read_text(kernel, source, graph.written.inputs, outputs_of(graph))


def _titled(finding: Finding, title: str) -> Finding:
    """The finding about a text that is read with some macros defined."""
    return replace(finding, subject=f"{finding.subject}, with {title}") if title else finding


def _preparing(kernels: Sequence[Kernel], kernel: Kernel) -> Kernel | None:
    """The function that prepares the parameters of another."""
    if not is_prepared(kernel.function):
        return None
    same = (k for k in kernels if k.function == PREPARE and k.kind == kernel.kind)
    return next((k for k in same if k.file == kernel.file), None)

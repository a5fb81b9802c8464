"""The evidence of a model, to be written beside its C: graphs, functions, and what holds.

Whoever verifies a folder prints the record again from what was found. Binaries are facts about the
machine that wrote it: of them there is checked which ones must be there and what can be said of
them, not the figures.
"""

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

from mechanics.compiled import Model
from mechanics.compiled.c.lanes import SHARED
from mechanics.compiled.programs.of_model import PARTS, WHOLE
from mechanics.compiled.translation_validation.code import Code, code_of
from mechanics.compiled.translation_validation.derived import derived
from mechanics.compiled.translation_validation.graph import STEP
from mechanics.compiled.translation_validation.kernel import Kernel
from mechanics.compiled.translation_validation.prove import Graph
from mechanics.errors import ExpressionError
from mechanics.export.evidence.chain import (
    BINARY,
    GRAPH,
    NO_COMPILER,
    NO_SINES,
    NOT_ASKED,
    NOT_SHOWN,
    NUMBERS,
    TEXT,
    Chain,
    Evidence,
)
from mechanics.export.evidence.equations import FILE as EQUATIONS
from mechanics.export.evidence.equations import equations_text
from mechanics.export.evidence.graphs import FILE as GRAPHS
from mechanics.export.evidence.graphs import graphs_text
from mechanics.export.precision import Part
from mechanics.kernel import Finding, Verdict

WRITTEN = (GRAPH, TEXT, NUMBERS)
"""Steps that follow from the files of a folder."""
FIGURES: dict[str, type[int] | type[float]] = {
    "states": int,
    "ulp": float,
    "ulp_terms": float,
    "statuses": int,
}
"""Of `Measured`."""


def evidence_of(
    model: Model,
    parts: Sequence[Part],
    names: Sequence[str],
    many: Sequence[str],
    texts: Mapping[str, str],
) -> Evidence:
    """What is known about the files of a model before they are written.

    Parameters
    ----------
    parts : sequence of Part
        Precisions.
    names, many : sequences of str
        Functions of one state, and those that are there for many, too.
    texts : mapping of str to str
        C files and headers.
    """
    codes: dict[str, Code] = {}
    graphs: dict[str, Graph] = {}
    for name in names:
        whole = WHOLE if name in PARTS else name
        if whole not in codes:
            codes[whole] = code_of(*model.casadi.exact(whole))
        graphs[name] = Graph(codes[whole], model.program(name))
    rates = code_of(*model.casadi.exact_rates()) if STEP in names else None
    kernels: list[Kernel] = []
    for part in parts:
        own, file = part.prefix, f"{part.prefix}.c"
        kernels += [Kernel(name, f"{own}_{name}", file, part.kind) for name in names]
        batch = f"{own}_batch.c"
        kernels += [Kernel(n, f"{own}_{n}_batch", batch, part.kind, SHARED) for n in many]
    return Evidence(derived(model.casadi), graphs, rates, tuple(kernels), dict(texts))


def evidence_files(evidence: Evidence) -> dict[str, str]:
    """Texts of the files that hold the evidence, by name."""
    return {
        EQUATIONS: equations_text(evidence.known),
        GRAPHS: graphs_text(evidence.graphs, evidence.rates),
    }


def chain_record(found: Chain) -> dict[str, Any]:
    """What was shown, for the manifest."""
    return {
        "check": "mechanics verify DIR",
        "steps": [
            {"step": title, "findings": [_finding(finding) for finding in findings]}
            for title, findings in found.steps
        ],
        "measured": [asdict(measured) for measured in found.measured],
        "not_done": list(found.not_done),
    }


def by_subject(record: Mapping[str, Any]) -> dict[str, Any]:
    """A record with its steps by title and their findings by subject.

    Raises
    ------
    ExpressionError
        If one stands there twice; other exceptions of Python where it is no record.
    """
    steps = once(record["steps"], "step")
    for step in steps.values():
        step["findings"] = once(step["findings"], "subject")
    return {**record, "steps": steps}


def once(records: Sequence[Mapping[str, Any]], key: str) -> dict[str, dict[str, Any]]:
    """Records by what their key says, each once."""
    found: dict[str, dict[str, Any]] = {}
    for record in records:
        name = record[key]
        if not isinstance(name, str) or name in found:
            raise ExpressionError(f"{key} {str(name)[:80]!r} stands there twice, or is no text")
        found[name] = dict(record)
    return found


def record_again(
    stored: Mapping[str, Any], found: Chain, kernels: Sequence[Kernel]
) -> dict[str, Any]:
    """What a record should say.

    Parameters
    ----------
    stored : mapping
        What it says, see `by_subject`: of binaries, evidence and figures are taken from it.
    found : Chain
        What was found again.
    """
    again = by_subject(chain_record(found))
    steps = {title: again["steps"][title] for title in WRITTEN if title in again["steps"]}
    shown = all(f.shown for title, findings in found.steps if title in WRITTEN for f in findings)
    binaries = _binaries(stored["steps"].get(BINARY, {"findings": {}})["findings"], kernels)
    if binaries and shown:
        steps[BINARY] = {"step": BINARY, "findings": binaries}
        supported = [s for s, one in binaries.items() if one["verdict"] == Verdict.SUPPORTED.name]
        told = stored["measured"]
        measured = [_figures(s, told[i : i + 1]) for i, s in enumerate(supported)]
        return {**again, "steps": steps, "measured": measured, "not_done": [NO_SINES]}
    reasons = (NOT_ASKED, NO_COMPILER, *(() if shown else (NOT_SHOWN,)))
    why = next((words for words in reasons if words in stored["not_done"]), reasons[-1])
    return {**again, "steps": steps, "measured": [], "not_done": [NO_SINES, why]}


def _binaries(told: Mapping[str, Any], kernels: Sequence[Kernel]) -> dict[str, Any]:
    """Findings about each kernel by each compiler that the first has; a run supports, or fails."""
    begin, end = f"{kernels[0].symbol}, ", f" = {kernels[0].file}"
    compilers = [
        subject.removeprefix(begin).removesuffix(end)
        for subject in told
        if subject.startswith(begin) and subject.endswith(end)
    ]
    found: dict[str, Any] = {}
    for kernel in kernels:
        for compiler in compilers:
            subject = f"{kernel.symbol}, {compiler} = {kernel.file}"
            said = told.get(subject, {})
            open_one = said.get("verdict") == Verdict.UNDECIDED.name
            verdict = Verdict.UNDECIDED if open_one else Verdict.SUPPORTED
            words = str(said.get("evidence"))
            found[subject] = {"subject": subject, "verdict": verdict.name, "evidence": words}
    return found


def _figures(subject: str, told: Sequence[Any]) -> dict[str, Any]:
    """What is measured of a binary; numbers are those that stand there."""
    symbol, compiler = subject.split(", ", 1)
    said = told[0] if told and isinstance(told[0], dict) else {}
    again: dict[str, Any] = {"symbol": symbol, "compiler": compiler.rpartition(" = ")[0]}
    for name, kind in FIGURES.items():
        value = said.get(name)
        again[name] = value if type(value) is kind and value >= 0 else f"a number, {kind.__name__}"
    return again


def _finding(finding: Finding) -> dict[str, Any]:
    record: dict[str, Any] = {
        "subject": finding.subject, "verdict": finding.verdict.name, "evidence": finding.evidence,
    }  # fmt: skip
    if finding.error_bound is not None:
        record["error_bound"] = finding.error_bound
    if finding.witness is not None:
        record["witness"] = asdict(finding.witness)
    return record

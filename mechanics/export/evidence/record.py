"""The evidence of a model, to be written beside its C: graphs, functions, and what holds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

from mechanics.compiled import Model
from mechanics.compiled.c.lanes import SHARED
from mechanics.compiled.custody.code import Code, code_of
from mechanics.compiled.custody.derived import derived
from mechanics.compiled.custody.graph import STEP
from mechanics.compiled.custody.kernel import Kernel
from mechanics.compiled.custody.prove import Graph
from mechanics.compiled.programs.of_model import PARTS, WHOLE
from mechanics.export.evidence.chain import Evidence
from mechanics.export.evidence.equations import FILE as EQUATIONS
from mechanics.export.evidence.equations import equations_text
from mechanics.export.evidence.graphs import FILE as GRAPHS
from mechanics.export.evidence.graphs import graphs_text
from mechanics.export.evidence.verify import Chain
from mechanics.export.precision import Part
from mechanics.kernel import Finding


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
    model : Model
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


def _finding(finding: Finding) -> dict[str, Any]:
    record: dict[str, Any] = {
        "subject": finding.subject, "verdict": finding.verdict.name, "evidence": finding.evidence,
    }  # fmt: skip
    if finding.error_bound is not None:
        record["error_bound"] = finding.error_bound
    if finding.witness is not None:
        record["witness"] = asdict(finding.witness)
    return record

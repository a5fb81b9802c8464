"""Third step of the chain for a folder: its C compiled by every compiler that is found."""

from collections.abc import Sequence
from dataclasses import dataclass

from mechanics.compiled.translation_validation.binary import Measured, compare
from mechanics.compiled.translation_validation.build import Built
from mechanics.compiled.translation_validation.code import as_written
from mechanics.compiled.translation_validation.truth import truth
from mechanics.export.evidence.chain import Evidence, Read, Report, silent
from mechanics.kernel import Finding


@dataclass(frozen=True)
class Binaries:
    """What is found about the binaries of a folder."""

    findings: tuple[Finding, ...]
    measured: tuple[Measured, ...]


def third_step(
    evidence: Evidence, read: Sequence[Read], libraries: Sequence[Built], report: Report = silent
) -> Binaries:
    """Compare values and statuses of binaries with the text.

    Parameters
    ----------
    read : sequence of Read
        From the second step; nothing is run unless every kernel is among them.
    """
    findings: list[Finding] = []
    measured: list[Measured] = []
    for one in read:
        report(f"{one.kernel.symbol}: text = binary")
        written = as_written(evidence.graphs[one.kernel.function].written)
        known = truth(one.text, evidence.known.symbols, written)
        for library in libraries:
            finding, figures = compare(known, library)
            findings.append(finding)
            measured += [figures] if figures is not None else []
    return Binaries(tuple(findings), tuple(measured))

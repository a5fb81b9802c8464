"""``verify(folder)``: the chain of custody once more, from the files alone.

A changed hash is told, but it is the mathematics that decides: a file that was formatted anew is
still shown to be its graph. Files that no step looks at have nothing but their hash.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from pathlib import Path

from mechanics.compiled.custody.derived import Derived, derived
from mechanics.compiled.fixed import read_fixed
from mechanics.compiled.graphs import Graphs
from mechanics.equations import Equations
from mechanics.exact import Finding, Verdict
from mechanics.export.evidence.chain import Read, Report, first_step, second_step, silent
from mechanics.export.evidence.read import Folder, read_folder


class Outcome(Enum):
    """What a verification comes to; the value is the exit code of the command."""

    SHOWN = 0
    REFUTED = 1
    UNDECIDED = 3


@dataclass(frozen=True)
class Verification:
    """What was found out about a folder.

    Attributes
    ----------
    folder : Folder
    steps : tuple of (str, tuple of Finding)
        Title and findings of each step.
    unvouched : tuple of str
        Changed files that no step has looked at.
    not_repeated : tuple of str
        What was not repeated, and why: sentences.
    """

    folder: Folder
    steps: tuple[tuple[str, tuple[Finding, ...]], ...]
    unvouched: tuple[str, ...]
    not_repeated: tuple[str, ...]

    @property
    def outcome(self) -> Outcome:
        """REFUTED if something is, SHOWN if everything is and every file is vouched for."""
        verdicts = {finding.verdict for _, findings in self.steps for finding in findings}
        if Verdict.REFUTED in verdicts:
            return Outcome.REFUTED
        if Verdict.UNDECIDED in verdicts or self.unvouched or self.folder.missing:
            return Outcome.UNDECIDED
        return Outcome.SHOWN


def verify(
    path: str | Path,
    equations: Equations | None = None,
    report: Report = silent,
) -> Verification:
    """Repeat the chain of custody of a folder.

    Parameters
    ----------
    path : str or Path
        As `write_c` wrote it.
    equations : Equations, optional
        Derived again from the scene by the route of the manifest: then the graphs are compared with
        these, too.
    report : callable
        Told what is looked at.

    Raises
    ------
    InputError
        If it is no such folder, or a file of it cannot be read.
    """
    folder = read_folder(Path(path))
    evidence = folder.evidence
    steps: list[tuple[str, tuple[Finding, ...]]] = []
    skipped: list[str] = []
    if equations is not None:
        known = again(folder, equations)
        steps.append(("physics = graph", tuple(first_step(evidence, known, report))))
    else:
        skipped.append("the equations were not derived again: no scene is known for this folder")
    found = tuple(first_step(evidence, evidence.known, report))
    steps.append(("equations = graph", found))
    read: list[Read] = []
    steps.append(("graph = C text", tuple(second_step(evidence, read, report))))
    return Verification(folder, tuple(steps), unvouched(folder, equations), tuple(skipped))


def again(folder: Folder, equations: Equations) -> Derived:
    """What was derived again, with the parameters fixed as the manifest says."""
    names = tuple(folder.evidence.graphs)
    table = read_fixed(equations.scene, folder.fixed)
    return derived(Graphs(equations, fixed=table), names)


def unvouched(folder: Folder, equations: Equations | None) -> tuple[str, ...]:
    """Changed files that no step looks at."""
    seen = {kernel.file for kernel in folder.evidence.kernels} | {"graphs.json"}
    seen |= {name for name in folder.texts if name.endswith(".h")}
    if equations is not None:
        seen.add("equations.json")
    return tuple(name for name in folder.changed if name not in seen)

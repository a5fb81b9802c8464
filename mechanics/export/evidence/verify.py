"""``verify(folder)``: the chain of translation validation once more, from the files alone.

A changed hash is told, but it is the mathematics that decides: a file that was formatted anew is
still shown to be its graph. Files that no step looks at have nothing but their hash.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from pathlib import Path

from mechanics.compiled.fixed import Fixed, read_fixed
from mechanics.compiled.graphs import STATE, Graphs, function_inputs
from mechanics.compiled.reduced import FILE as REDUCTION
from mechanics.compiled.translation_validation.build import building, compilers
from mechanics.compiled.translation_validation.derived import Derived, derived
from mechanics.equations import Equations
from mechanics.errors import InputError
from mechanics.export.evidence.binaries import third_step
from mechanics.export.evidence.chain import (
    BINARY,
    GRAPH,
    NO_COMPILER,
    NO_SINES,
    NOT_ASKED,
    NOT_SHOWN,
    NUMBERS,
    PHYSICS,
    SINES,
    TEXT,
    Chain,
    Evidence,
    Read,
    Report,
    first_step,
    second_step,
    silent,
)
from mechanics.export.evidence.equations import FILE as EQUATIONS
from mechanics.export.evidence.form import prove_form, prove_reciprocals
from mechanics.export.evidence.graphs import FILE as GRAPHS
from mechanics.export.evidence.headers import prove_headers
from mechanics.export.evidence.listing import as_derived, prove_files
from mechanics.export.evidence.read import Folder, read_folder
from mechanics.export.evidence.sines import prove_sines
from mechanics.export.evidence.vectors import prove_vectors
from mechanics.export.folder import MANIFEST
from mechanics.kernel import Finding, Verdict
from mechanics.scene import Scene

FRACTION = re.compile(r"-?\d+(/\d+)?")
REACTIONS = "reactions"
BOUND = "whole model = reduced model within its bound"
NO_PHYSICS = "the equations were not derived again"
NO_FORM = "form of forward dynamics in the manifest: it follows from the scene"
VERSIONS = "versions in the manifest: facts about another installation"
FIGURES = "figures of binaries in the manifest: facts about the machine that wrote it"
NOTHING_SHOWN = "the manifest records no proof: nothing was proved when it was written"


@dataclass(frozen=True)
class Again:
    """A reduced model, reduced again as its record says.

    Attributes
    ----------
    findings : tuple of Finding
        That its bound holds, and that the record says so.
    """

    graphs: Graphs
    findings: tuple[Finding, ...]


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
    physics : bool
        Whether the equations were derived again from a scene.
    unvouched : tuple of str
        Changed files that no step has looked at.
    """

    folder: Folder
    chain: Chain
    physics: bool
    unvouched: tuple[str, ...]

    @property
    def outcome(self) -> Outcome:
        """REFUTED if something is, SHOWN if everything is, physics and every file included."""
        if Verdict.REFUTED in self.chain.verdicts:
            return Outcome.REFUTED
        doubt = Verdict.UNDECIDED in self.chain.verdicts or not self.physics
        if doubt or self.unvouched or self.folder.missing:
            return Outcome.UNDECIDED
        return Outcome.SHOWN


def chain(
    evidence: Evidence,
    again: Derived | None = None,
    measure: bool = True,
    sines: bool = True,
    report: Report = silent,
) -> Chain:
    """Go through the chain of translation validation once.

    Parameters
    ----------
    again : Derived, optional
        What was derived anew, to be compared with the graphs, too.
    measure : bool
        Whether to compile the code and compare.
    sines : bool
        Whether to prove the text of the inline sine and cosine, which is the same in every folder
        and takes some seconds.
    report : callable
        Told what is looked at.
    """
    steps: list[tuple[str, tuple[Finding, ...]]] = []
    if again is not None:
        found = tuple(first_step(evidence, again, report))
        steps.append((PHYSICS, found))
    found = tuple(first_step(evidence, evidence.known, report))
    steps.append((GRAPH, found))
    read: list[Read] = []
    found = tuple(second_step(evidence, read, report))
    steps.append((TEXT, found))
    found = (*prove_headers(evidence), *prove_vectors(evidence.texts, evidence.graphs))
    steps.append((NUMBERS, found))
    not_done = () if sines else (NO_SINES,)
    if sines and (found := tuple(prove_sines(evidence.texts, report))):
        steps.append((SINES, found))
    paths = compilers() if measure else ()
    why = _not_compiled(measure, paths, _all_shown(steps))
    if why:
        return Chain(tuple(steps), (), (*not_done, why))
    report("compiling")
    files = list(dict.fromkeys(kernel.file for kernel in evidence.kernels))
    # What is not shown may include anything: it is not even compiled.
    with building(evidence.texts, files, paths) as collected:
        binaries = third_step(evidence, read, collected(), report)
    steps.append((BINARY, binaries.findings))
    return Chain(tuple(steps), binaries.measured, not_done)


def _all_shown(steps: Sequence[tuple[str, tuple[Finding, ...]]]) -> bool:
    return all(finding.shown for _, findings in steps for finding in findings)


def _not_compiled(measure: bool, paths: Sequence[str], shown: bool) -> str:
    """Why binaries are not looked at; empty where they are."""
    if not measure:
        return NOT_ASKED
    if not paths:
        return NO_COMPILER
    # What is not shown may write anywhere.
    return "" if shown else NOT_SHOWN


def verify(
    folder: Folder | str | Path,
    equations: Equations | None = None,
    measure: bool = True,
    report: Report = silent,
    reduced: Again | None = None,
) -> Verification:
    """Repeat the chain of translation validation of a folder.

    Parameters
    ----------
    folder : Folder, str or Path
        As `write_c` wrote it.
    equations : Equations, optional
        Derived again from the scene by the route of the manifest: the graphs are compared with
        these, too. Without them the outcome is UNDECIDED at best.
    measure : bool
        Whether to compile the code and compare.
    report : callable
        Told what is looked at.
    reduced : Again, optional
        For the folder of a reduced model: what was reduced again.

    Raises
    ------
    InputError
        If it is no such folder, or a file of it cannot be read.
    """
    folder = folder if isinstance(folder, Folder) else read_folder(Path(folder))
    if reduced is not None:
        graphs: Graphs | None = reduced.graphs
    else:
        graphs = None if equations is None else graphs_again(folder, equations)
    again = None if graphs is None else derived(graphs)
    if again is not None:
        _same_entries(folder, again)
    found = chain(folder.evidence, again, measure, report=report)
    contents = None if graphs is None else as_derived(folder, graphs)
    looked = () if reduced is None else (REDUCTION,)
    files = tuple(prove_files(folder, contents, found, again, looked))
    if reduced is not None:
        found = replace(found, steps=(*found.steps, (BOUND, reduced.findings)))
    forms = [*prove_reciprocals(folder), *(prove_form(folder, graphs) if graphs else ())]
    found = replace(
        found,
        steps=(*found.steps, ("files of the folder", (*files, *forms))),
        not_done=(*found.not_done, *_not_checked(folder, graphs is not None)),
    )
    physics = equations is not None
    left = tuple(name for name in unvouched(folder, physics) if name not in looked)
    return Verification(folder, found, physics, left)


def _not_checked(folder: Folder, physics: bool) -> Iterator[str]:
    """What the manifest says and no step decides about."""
    yield VERSIONS
    yield from () if physics else (NO_FORM,)
    told = folder.manifest.get("chain")
    if told == {}:
        yield NOTHING_SHOWN
    elif isinstance(told, dict) and told.get("measured"):
        yield FIGURES


def graphs_again(folder: Folder, equations: Equations) -> Graphs:
    """The graphs of what was derived again, with the parameters fixed as the manifest says.

    Raises
    ------
    InputError
        If it is another scene.
    """
    scene = equations.scene
    here = {symbol.name for group in folder.evidence.known.symbols.values() for symbol in group}
    if not {symbol.name for symbol in (*scene.q, *scene.u)} <= here:
        raise _other(folder, scene.name)
    # A model of some outputs need not tell reactions.
    told = folder.evidence.known.symbols[REACTIONS]
    outputs = None if told else [name for name in function_inputs(equations) if name != REACTIONS]
    return Graphs(equations, fixed=_fixed(folder, scene), outputs=outputs)


def _same_entries(folder: Folder, again: Derived) -> None:
    """Refuse a scene whose arrays have other entries."""
    for group in (*STATE, "ud", "multipliers"):
        left, right = (
            [symbol.name for symbol in one.symbols[group]] for one in (folder.evidence.known, again)
        )
        if left != right:
            raise _other(folder, again.scene)


def _fixed(folder: Folder, scene: Scene) -> Fixed:
    """Values of fixed parameters; what the scene defines by them, with pi say, follows."""
    given = {name: value for name, value in folder.fixed.items() if FRACTION.fullmatch(value)}
    found = read_fixed(scene, given)
    follows = {symbol.name: str(value) for symbol, value in found.items()}
    if odd := sorted(set(folder.fixed.items()) ^ set(follows.items())):
        name, value = odd[0]
        raise InputError(
            f"{folder.path / MANIFEST}: {name} = {value[:40]} does not follow from what is fixed"
        )
    return found


def _other(folder: Folder, name: str) -> InputError:
    return InputError(
        f"{folder.path}: it was made of another scene than {name!r}, {folder.manifest['scene']!r}:"
        " the arrays have other entries"
    )


def unvouched(folder: Folder, physics: bool) -> tuple[str, ...]:
    """Changed files that no step looks at."""
    seen = {kernel.file for kernel in folder.evidence.kernels} | {GRAPHS}
    seen |= {name for name in folder.texts if name.endswith(".h")}
    if physics:
        seen.add(EQUATIONS)
    return tuple(name for name in folder.changed if name not in seen)

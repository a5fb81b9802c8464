"""What headers and the manifest say of the functions is what scene and graphs give again."""

import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from mechanics import compile, derive, write_c
from mechanics.compiled.graphs import Graphs
from mechanics.compiled.translation_validation.derived import derived
from mechanics.export.evidence.chain import Chain, second_step
from mechanics.export.evidence.listing import as_derived, prove_files
from mechanics.export.evidence.read import read_folder
from mechanics.kernel import Finding, Verdict
from systems import elastic_pendulum

NO_CHAIN = Chain((), (), ())
Judge = Callable[[Path], list[Finding]]
HEADER = "name.h"
KERNEL = "kernels.name_forward_dynamics"


@pytest.fixture(scope="module")
def graphs() -> Graphs:
    return Graphs(derive(elastic_pendulum.scene()))


@pytest.fixture(scope="module")
def claimed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Some functions of the elastic pendulum; what is proved of them is no matter here."""
    folder = tmp_path_factory.mktemp("claimed")
    names = ("forward_dynamics", "inverse_dynamics", "energy", "momenta", "jacobians")
    model = compile(derive(elastic_pendulum.scene()))
    write_c(model, folder, name="name", functions=names, batch=False, prove=False)
    return folder


@pytest.fixture
def folder(claimed: Path, tmp_path: Path) -> Path:
    shutil.copytree(claimed, tmp_path / "c")
    return tmp_path / "c"


@pytest.fixture
def judge(graphs: Graphs) -> Judge:
    """What is found about the files of a folder that is not shown, with the physics."""
    known = derived(graphs)

    def found(folder: Path) -> list[Finding]:
        read = read_folder(folder)
        every = prove_files(read, as_derived(read, graphs), NO_CHAIN, known)
        return [f for f in every if not f.shown]

    return found


def changed(folder: Path, old: str, new: str, file: str = HEADER) -> None:
    text = (folder / file).read_text(encoding="utf-8")
    assert old in text
    (folder / file).write_text(text.replace(old, new), encoding="utf-8")


def line_of(folder: Path, words: str) -> int:
    lines = (folder / HEADER).read_text(encoding="utf-8").splitlines()
    return next(number for number, line in enumerate(lines, 1) if words in line)


@pytest.mark.campaign
def test_what_was_written_is_shown(folder: Path, judge: Judge) -> None:
    assert judge(folder) == []


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("acceleration of gravity", "length of the rod"),
        ("theta_dot  rad/s\n", "theta_dot  deg/s\n"),
        ("p[0]", "p[1]"),
        ("q[0]  x ", "q[0]  theta "),
        ("typically 9.81", "typically 9.80"),
        ("generalized[i] * u[i] is an energy", "generalized[i] * u[i] is a power"),
        ("1  a divisor is zero", "2  a divisor is zero"),
    ],
)
def test_a_row_that_says_something_else_is_refuted(
    folder: Path, judge: Judge, old: str, new: str
) -> None:
    """The finding names file and line, what stands there, and what the physics gives."""
    changed(folder, old, new)
    found = judge(folder)
    assert found and all(finding.verdict is Verdict.REFUTED for finding in found)
    first = found[0]
    assert first.subject == f"{HEADER}: line {line_of(folder, new.strip())}"
    assert new.strip() in first.evidence and "the scene gives" in first.evidence


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("Matrices are stored column by column", "Matrices are stored row by row"),
        ("which added to the loads give u'", "which less the loads give u'"),
        ("#ifndef MECHANICS_name_H\n", "/* p[0] is in feet */\n#ifndef MECHANICS_name_H\n"),
        ("/* Derivatives of u' by q, u, inputs and p.", "/*"),
    ],
)
def test_a_sentence_that_nothing_shows_is_undecided(
    folder: Path, judge: Judge, old: str, new: str
) -> None:
    changed(folder, old, new)
    assert [finding.verdict for finding in judge(folder)] == [Verdict.UNDECIDED]


def test_another_layout_of_comments_is_no_change(folder: Path, judge: Judge) -> None:
    changed(folder, "\n * ", "\n   *   ")
    changed(folder, "every function may be called", "every\n function may be called")
    changed(folder, "#ifndef MECHANICS_name_H\n", "/* of ACME */\n#ifndef MECHANICS_name_H\n")
    assert judge(folder) == []


def test_comments_of_sources_are_compared_too(folder: Path, judge: Judge) -> None:
    changed(folder, "derived by free_body", "derived by kane", "name.c")
    (found,) = judge(folder)
    assert found.subject == "name.c: line 1" and not found.shown


def manifest(folder: Path, change: Callable[[Any], Any]) -> None:
    path = folder / "manifest.json"
    content = json.loads(path.read_text(encoding="utf-8"))
    change(content)
    path.write_text(json.dumps(content), encoding="utf-8")


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("change", "verdict", "subject"),
    [
        (
            lambda m: m["functions"]["energy"].update(operations=1),
            Verdict.REFUTED,
            "functions.energy.operations",
        ),
        (
            lambda m: m["arrays"]["p"][0].update(unit="ft/s^2"),
            Verdict.REFUTED,
            "arrays.p[0].unit",
        ),
        (lambda m: m["functions"].pop("energy"), Verdict.UNDECIDED, "functions.energy"),
        (lambda m: m["functions"].update(more={}), Verdict.UNDECIDED, "functions.more"),
        (lambda m: m.pop("arrays"), Verdict.UNDECIDED, "arrays"),
        (lambda m: m.update(note="right"), Verdict.UNDECIDED, "note"),
        (lambda m: m.update(system=3), Verdict.REFUTED, "system"),
        (lambda m: m["versions"].pop("casadi"), Verdict.UNDECIDED, "versions.casadi"),
        (lambda m: m["versions"].update(gcc="12"), Verdict.UNDECIDED, "versions.gcc"),
        (lambda m: m["versions"].update(sympy=1.14), Verdict.REFUTED, "versions.sympy"),
        (
            lambda m: m["functions"]["energy"].update(operations="12"),
            Verdict.REFUTED,
            "functions.energy.operations",
        ),
        (lambda m: m["kernels"][0].update(lanes=8), Verdict.UNDECIDED, f"{KERNEL}.lanes"),
        (lambda m: m["kernels"].pop(0), Verdict.UNDECIDED, KERNEL),
        (lambda m: m["kernels"].append(m["kernels"][0]), Verdict.UNDECIDED, "chain or kernels"),
    ],
)
def test_a_manifest_says_what_scene_and_graphs_give(
    folder: Path, judge: Judge, change: Any, verdict: Verdict, subject: str
) -> None:
    manifest(folder, change)
    (found,) = judge(folder)
    assert (found.verdict, found.subject) == (verdict, f"manifest.json: {subject}")


@pytest.mark.campaign
def test_without_physics_the_manifest_is_what_headers_are_held_against(folder: Path) -> None:
    read = read_folder(folder)
    assert all(finding.shown for finding in prove_files(read, None, NO_CHAIN))
    changed(folder, "acceleration of gravity", "length of the rod")
    found = [f for f in prove_files(read_folder(folder), None, NO_CHAIN) if not f.shown]
    assert found and {f.verdict for f in found} == {Verdict.UNDECIDED}


def test_what_only_a_run_sees_of_many_states_is_said(tmp_path: Path) -> None:
    """A text's far lanes are no sines before the library mends them, whatever the text says."""
    model = compile(derive(elastic_pendulum.scene()))
    write_c(model, tmp_path / "c", name="name", functions=["energy"], prove=False)
    found = {f.subject: f for f in second_step(read_folder(tmp_path / "c").evidence, [])}
    many = found["name_batch.c: status of name_energy_batch"]
    assert many.shown and "is compared by runs of binaries only" in many.evidence
    one = found["name.c: status of name_energy"]
    assert one.shown and "binaries" not in one.evidence

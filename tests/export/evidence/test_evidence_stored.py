"""A folder of which one claim was edited: verify names it."""

import json
import shutil
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from mechanics import compile, derive, write_c
from mechanics.compiled.graphs import Graphs
from mechanics.compiled.translation_validation.derived import Derived, derived
from mechanics.errors import InputError
from mechanics.export.contents import Contents
from mechanics.export.evidence.chain import BINARY, NO_SINES, NOT_ASKED, Chain, second_step
from mechanics.export.evidence.form import prove_form, prove_reciprocals
from mechanics.export.evidence.listing import as_derived, prove_files
from mechanics.export.evidence.read import Folder, read_folder
from mechanics.export.evidence.verify import chain
from mechanics.kernel import Finding, Verdict
from systems import elastic_pendulum

FUNCTIONS = ("forward_dynamics", "momenta")
Change = Callable[[dict[str, Any]], Any]


class Made(NamedTuple):
    """A folder, and what was found about it."""

    path: Path
    graphs: Graphs
    known: Derived
    contents: Contents
    found: Chain


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Made:
    """Two functions with their chain and one compiler that never ran."""
    path = tmp_path_factory.mktemp("stored")
    equations = derive(elastic_pendulum.scene())
    write_c(compile(equations), path, name="name", functions=FUNCTIONS, batch=False, measure=False)
    edited(path, compiled)
    folder, graphs = read_folder(path), Graphs(equations)
    known = derived(graphs)
    found = chain(folder.evidence, known, measure=False)
    return Made(path, graphs, known, as_derived(folder, graphs), found)


def compiled(manifest: dict[str, Any]) -> None:
    """As a machine with a compiler says it."""
    record, findings = manifest["chain"], []
    for kernel in manifest["kernels"]:
        words = f"{kernel['symbol']}, cc 1 -O2 = {kernel['file']}"
        findings.append({"subject": words, "verdict": "SUPPORTED", "evidence": "52 states"})
        figures = {"states": 52, "ulp": 1.5, "ulp_terms": 1.0, "statuses": 72}
        record["measured"].append({"symbol": kernel["symbol"], "compiler": "cc 1 -O2", **figures})
    record["steps"].append({"step": BINARY, "findings": findings})
    record["not_done"] = [NO_SINES]


def edited(path: Path, change: Change, file: str = "manifest.json") -> None:
    content = json.loads((path / file).read_text(encoding="utf-8"))
    change(content)
    (path / file).write_text(json.dumps(content), encoding="utf-8")


@pytest.fixture
def folder(made: Made, tmp_path: Path) -> Path:
    shutil.copytree(made.path, tmp_path / "c")
    return tmp_path / "c"


def bad(made: Made, folder: Path) -> list[Finding]:
    read = read_folder(folder)
    return [f for f in everything(made, read) if not f.shown]


def everything(made: Made, read: Folder) -> Iterator[Finding]:
    yield from prove_files(read, made.contents, made.found, made.known)


def steps(manifest: dict[str, Any]) -> list[Any]:
    return manifest["chain"]["steps"]


def row(manifest: dict[str, Any], step: int = 1, place: int = 0) -> dict[str, Any]:
    return steps(manifest)[step]["findings"][place]


def certified(manifest: dict[str, Any]) -> dict[str, Any]:
    rows = (f for step in steps(manifest) for f in step["findings"])
    return next(f for f in rows if "error_bound" in f)


@pytest.mark.campaign
def test_what_was_written_is_shown(made: Made, folder: Path) -> None:
    assert bad(made, folder) == []


CLAIMS: Sequence[tuple[str, Change, str]] = [
    ("a step is lost", lambda m: steps(m).pop(1), "chain.steps.graph = C text"),
    ("the first is lost", lambda m: steps(m).pop(0), "chain.steps.derived equations = graph"),
    ("a step is doubled", lambda m: steps(m).append(steps(m)[0]), "chain or kernels"),
    ("an unknown step", lambda m: steps(m).append({"step": "x", "findings": []}), "chain.steps.x"),
    ("steps change places", lambda m: steps(m).reverse(), "chain.steps: order"),
    ("a step says more", lambda m: steps(m)[0].update(by="me"), "equations = graph.by"),
    ("a finding is lost", lambda m: steps(m)[1]["findings"].pop(), "chain.steps.graph = C text.fi"),
    ("a finding is doubled", lambda m: steps(m)[1]["findings"].append(row(m)), "chain or kernels"),
    ("a finding of another", lambda m: row(m).update(subject="all"), "C text.findings.all"),
    ("evidence", lambda m: row(m).update(evidence="proved by hand"), ".evidence"),
    ("verdict", lambda m: row(m).update(verdict="CERTIFIED"), ".verdict"),
    ("no verdict", lambda m: row(m).update(verdict="TRUE"), ".verdict"),
    ("a bound that is not", lambda m: row(m).update(error_bound=1e-30), ".error_bound"),
    ("a witness that is not", lambda m: row(m).update(witness={}), ".witness"),
    ("a lower bound", lambda m: certified(m).update(error_bound=1e-300), ".error_bound"),
    ("a bound in words", lambda m: certified(m).update(error_bound="0.0"), ".error_bound"),
    ("no bound", lambda m: certified(m).pop("error_bound"), ".error_bound"),
    ("no steps", lambda m: steps(m).clear(), "chain.steps"),
    ("a chain of steps alone", lambda m: m.update(chain={"steps": []}), "chain"),
    ("a chain in words", lambda m: m.update(chain="all PROVED"), "chain or kernels"),
    ("no chain", lambda m: m.pop("chain"), "chain"),
    ("a chain that says more", lambda m: m["chain"].update(by="me"), "chain.by"),
    ("another check", lambda m: m["chain"].update(check="true"), "chain.check"),
    ("more is done", lambda m: m["chain"].update(not_done=[]), "chain.not_done"),
    ("less is done", lambda m: m["chain"]["not_done"].append("x"), "chain.not_done"),
    ("a binary is lost", lambda m: row(m, 3) and steps(m)[3]["findings"].pop(), f"steps.{BINARY}"),
    ("binaries are lost", lambda m: steps(m).pop(), "chain.not_done"),
    ("no binaries", lambda m: steps(m)[3]["findings"].clear(), f"chain.steps.{BINARY}"),
    ("a run that proves", lambda m: row(m, 3).update(verdict="PROVED"), ".verdict"),
    ("a figure in words", lambda m: m["chain"]["measured"][0].update(ulp="1.5"), "measured[0].ulp"),
    ("a negative figure", lambda m: m["chain"]["measured"][0].update(states=-1), "[0].states"),
    ("a figure of another", lambda m: m["chain"]["measured"][0].update(symbol="x"), "[0].symbol"),
    ("a figure too many", lambda m: m["chain"]["measured"].append({}), "chain.measured[2]"),
]


@pytest.mark.sample(2)
@pytest.mark.parametrize(("change", "words"), [c[1:] for c in CLAIMS], ids=[c[0] for c in CLAIMS])
def test_a_claim_of_the_manifest_that_was_edited_is_named(
    made: Made, folder: Path, change: Change, words: str
) -> None:
    edited(folder, change)
    found = bad(made, folder)
    assert found and all(finding.subject.startswith("manifest.json: ") for finding in found)
    assert any(words in finding.subject for finding in found), [f.subject for f in found]
    assert all("\n" not in f"{finding.subject}{finding.evidence}" for finding in found)


def test_who_asked_for_no_binaries_says_so(made: Made, folder: Path) -> None:
    def unmeasured(manifest: dict[str, Any]) -> None:
        steps(manifest).pop()
        manifest["chain"] |= {"measured": [], "not_done": [NO_SINES, NOT_ASKED]}

    edited(folder, unmeasured)
    assert bad(made, folder) == []


EVIDENCE: Sequence[tuple[str, Change, str]] = [
    ("equations.json", lambda c: c.update(scene="another"), "scene"),
    ("equations.json", lambda c: c.update(route="kane"), "route"),
    ("equations.json", lambda c: c.update(note="right"), "note"),
    ("equations.json", lambda c: c["symbols"][-1].__setitem__(1, "real"), "symbols[14][1]"),
    ("equations.json", lambda c: c["outputs"].update(kinetic=c["outputs"]["potential"]), "program"),
    ("graphs.json", lambda c: c.update(note="right"), "note"),
    ("graphs.json", lambda c: c["functions"][0][2].update(operations=3), "functions[0][2].ope"),
]


@pytest.mark.parametrize(("file", "change", "words"), EVIDENCE)
def test_evidence_says_what_was_derived_and_nothing_else(
    made: Made, folder: Path, file: str, change: Change, words: str
) -> None:
    edited(folder, change, file)
    assert any(f.subject.startswith(f"{file}: {words}") for f in bad(made, folder))


@pytest.mark.parametrize(
    ("change", "verdict", "words"),
    [
        (lambda m: m, None, ""),
        (lambda m: m.update(form="articulated"), Verdict.REFUTED, "is that of fewest"),
        (lambda m: m.update(form="fastest"), Verdict.UNDECIDED, "no form 'fastest'"),
        (lambda m: m.update(form=None), Verdict.UNDECIDED, "no form 'None'"),
        (lambda m: m.update(reciprocals=1), Verdict.UNDECIDED, "neither true nor false"),
        (lambda m: m.pop("reciprocals"), Verdict.UNDECIDED, "neither true nor false"),
    ],
)
def test_form_and_reciprocals_are_those_of_the_programs(
    made: Made, folder: Path, change: Change, verdict: Verdict | None, words: str
) -> None:
    edited(folder, change)
    read = read_folder(folder)
    found = [f for f in (*prove_reciprocals(read), *prove_form(read, made.graphs)) if not f.shown]
    assert [finding.verdict for finding in found] == ([] if verdict is None else [verdict])
    assert all(words in finding.evidence for finding in found)


def test_shared_divisors_are_seen_in_the_programs(tmp_path: Path) -> None:
    model = compile(derive(elastic_pendulum.scene()))
    write_c(model, tmp_path, name="name", functions=("jacobians",), batch=False, prove=False)
    assert all(finding.shown for finding in prove_reciprocals(read_folder(tmp_path)))
    edited(tmp_path, lambda m: m.update(reciprocals=False))
    (found,) = prove_reciprocals(read_folder(tmp_path))
    assert found.verdict is Verdict.REFUTED and "False stands there" in found.evidence


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("#ifdef __cplusplus", "#pragma STDC FP_CONTRACT ON\n#ifdef __cplusplus"),
        ("#ifdef __cplusplus", "typedef float angle;\n#ifdef __cplusplus"),
        ("#ifdef __cplusplus", "extern int more;\n#ifdef __cplusplus"),
        ("#ifdef __cplusplus", "enum { MORE };\n#ifdef __cplusplus"),
        ("#ifdef __cplusplus", "#include <tgmath.h>\n#ifdef __cplusplus"),
        ("#ifndef MECHANICS", "#pragma once\n#ifndef MECHANICS"),
    ],
)
def test_code_of_a_header_is_what_is_printed(made: Made, folder: Path, old: str, new: str) -> None:
    path = folder / "name.h"
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    assert any(f.subject.startswith("name.h: line") for f in bad(made, folder))


@pytest.mark.parametrize("file", ["manifest.json", "equations.json", "graphs.json"])
@pytest.mark.parametrize(
    ("text", "words"),
    [
        ('{"note": NaN, ', "NaN is no number"),
        ('{"note": -Infinity, ', "-Infinity is no number"),
        ('{"note": 1e999, ', "1e999 is no number"),
        ('{"note": 1, "note": 2, ', "'note' stands twice"),
        ("{\xff", "UTF-8"),
    ],
)
def test_what_is_no_json_is_refused(folder: Path, file: str, text: str, words: str) -> None:
    path = folder / file
    raw = path.read_bytes().replace(b"{", text.encode("latin-1"), 1)
    path.write_bytes(raw)
    with pytest.raises(InputError, match=words) as caught:
        read_folder(folder)
    assert str(path) in str(caught.value) and "\n" not in str(caught.value)


@pytest.mark.parametrize("file", ["manifest.json", "equations.json", "name.c", "CMakeLists.txt"])
def test_a_link_is_not_followed(folder: Path, tmp_path: Path, file: str) -> None:
    (folder / file).rename(tmp_path / "elsewhere")
    (folder / file).symlink_to(tmp_path / "elsewhere")
    with pytest.raises(InputError, match=f"{file}: it is a link"):
        read_folder(folder)


def test_a_function_that_nothing_calls_is_named(made: Made) -> None:
    evidence = read_folder(made.path).evidence
    text = evidence.texts["name.c"] + "static int more(void)\n{\n    return 1;\n}\n"
    one = replace(evidence, texts={**evidence.texts, "name.c": text}, kernels=evidence.kernels[:1])
    assert "name.c: more" in [f.subject for f in second_step(one, []) if not f.shown]

"""Folders that somebody changed on purpose, with the hashes made right again: none is SHOWN."""

import copy
import json
import shutil
from collections.abc import Callable
from hashlib import sha256
from pathlib import Path
from typing import Any

import pytest

from mechanics.equations import Equations
from mechanics.export.evidence.verify import Outcome, verify
from mechanics.export.write_c import write_c
from mechanics.routes.derivation import by_route
from systems import elastic_pendulum

pytestmark = pytest.mark.campaign

FUNCTIONS = ("forward_dynamics", "prepare", "forward_dynamics_prepared")
Attack = Callable[[Path, dict[str, Any]], None]


@pytest.fixture(scope="session")
def honest(modelled, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("honest")
    model = modelled("elastic_pendulum", "free_body")
    write_c(model, folder, name="name", functions=FUNCTIONS, prove=False)
    return folder


def attacked(honest: Path, target: Path, attack: Attack) -> Path:
    shutil.copytree(honest, target)
    path = target / "manifest.json"
    manifest = json.loads(path.read_text(encoding="utf-8"))
    attack(target, manifest)
    for file in manifest["files"]:
        manifest["files"][file] = sha256((target / file).read_bytes()).hexdigest()
    path.write_text(json.dumps(manifest), encoding="utf-8")
    return target


def put(file: str, old: str, new: str) -> Attack:
    """Put another text once."""

    def attack(folder: Path, manifest: dict[str, Any]) -> None:
        text = (folder / file).read_text(encoding="utf-8")
        assert old in text
        (folder / file).write_text(text.replace(old, new, 1), encoding="utf-8")

    return attack


def cut(file: str, first: str, end: str) -> Attack:
    """Put another end."""

    def attack(folder: Path, manifest: dict[str, Any]) -> None:
        text = (folder / file).read_text(encoding="utf-8")
        (folder / file).write_text(text[: text.index(first)] + end, encoding="utf-8")

    return attack


def extra(file: str, text: str, listed: bool = False) -> Attack:
    """Put a file beside the others."""

    def attack(folder: Path, manifest: dict[str, Any]) -> None:
        (folder / file).write_text(text, encoding="utf-8")
        manifest["files"] |= {file: ""} if listed else {}

    return attack


def dropped(folder: Path, manifest: dict[str, Any]) -> None:
    """The functions of many states are wrong, and no kernels."""
    put("name_batch.c", "cos_theta * ", "sin_theta * ")(folder, manifest)
    manifest["kernels"] = [k for k in manifest["kernels"] if "batch" not in k["file"]]


def second_code(folder: Path, manifest: dict[str, Any]) -> None:
    """A wrong graph of the name of a right one, for a part of the function only."""
    path = folder / "graphs.json"
    content = json.loads(path.read_text(encoding="utf-8"))
    (code,) = copy.deepcopy(content["exact"][0])
    code["nodes"].append(["negate", code["outputs"][0][0]])
    code["outputs"][0][0] = len(code["nodes"]) - 1
    content["exact"].append([code])
    for record in content["functions"]:
        if record[0] == "forward_dynamics_prepared":
            record[1] = len(content["exact"]) - 1
    path.write_text(json.dumps(content), encoding="utf-8")
    text = (folder / "name.c").read_text(encoding="utf-8")
    at = text.index("ud[0] = ", text.index("int name_forward_dynamics_prepared("))
    (folder / "name.c").write_text(f"{text[:at]}ud[0] = -{text[at + 8 :]}", encoding="utf-8")


HIDES = "#include_next <math.h>\n#define cos sin\n"
MAIN = "int main(void)\n{\n    return 0;\n}\n"
FILES: dict[str, tuple[Attack, str]] = {
    "part": (second_code, "forward_dynamics_prepared"),
    "drop": (dropped, "name_forward_dynamics_batch"),
    "math.h": (extra("math.h", HIDES), "math.h"),
    "math.h listed": (extra("math.h", HIDES, True), "math.h"),
    "another source": (extra("more.c", "int more(void) { return 1; }\n", True), "more.c"),
    "presets": (extra("CMakePresets.json", "{}"), "CMakePresets.json"),
    "no tests": (cut("name_selftest.c", "static int test_", MAIN), "selftest"),
    "no main": (cut("name_selftest.c", "int main", "int main(void) { return 0; }\n"),
                "name_selftest.c"),
    "blind check": (put("name_batch_selftest.c", "++failures;", ";"), "name_batch_selftest.c"),
    "flags": (put("CMakeLists.txt", "-ffp-contract=off", "-ffast-math -Dcos=sin"),
              "CMakeLists.txt"),
    "loader": (put("name_loader.py", "FLAGS = \"-O3\"", "FLAGS = \"-O3 -Dcos=sin\""),
               "name_loader.py"),
}  # fmt: skip


@pytest.fixture(scope="session")
def physics() -> Equations:
    return by_route("free_body", elastic_pendulum.scene())


def test_the_honest_folder_is_shown(honest: Path, physics: Equations) -> None:
    assert verify(honest, physics, measure=False).outcome is Outcome.SHOWN
    # The folder is not asked what it is right about.
    assert verify(honest, measure=False).outcome is Outcome.UNDECIDED


@pytest.mark.parametrize("name", FILES)
def test_what_is_looked_at_is_not_for_the_manifest_to_say(
    honest: Path, physics: Equations, tmp_path: Path, name: str
) -> None:
    attack, named = FILES[name]
    found = verify(attacked(honest, tmp_path / "c", attack), physics, measure=False)
    assert found.outcome is not Outcome.SHOWN
    bad = [f for _, findings in found.chain.steps for f in findings if not f.shown]
    assert any(named in f"{finding.subject} {finding.evidence}" for finding in bad), bad


VAIN = ("(v5 + 0x1p200) - 0x1p200", "v5 * 0x1p-600 * 0x1p-600 * 0x1p600 * 0x1p600",
        "v5 * 0x1p1000 * 0x1p1000 * 0x1p-1000 * 0x1p-1000")  # fmt: skip


@pytest.mark.parametrize("vain", VAIN)
def test_code_that_is_right_over_the_real_numbers_only(
    honest: Path,
    physics: Equations,
    tmp_path: Path,
    needed,
    monkeypatch: pytest.MonkeyPatch,
    vain: str,
) -> None:
    compiler = needed("gcc")
    monkeypatch.setattr("mechanics.export.evidence.verify.compilers", lambda: (compiler,))
    attack = put("name.c", "    ud[0] = v5;", f"    ud[0] = {vain};")
    found = verify(attacked(honest, tmp_path / "c", attack), physics)
    assert found.outcome is not Outcome.SHOWN
    bad = [f for _, findings in found.chain.steps for f in findings if not f.shown]
    assert any("of the graph" in finding.evidence for finding in bad), bad

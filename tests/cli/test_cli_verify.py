"""`mechanics verify`: what passes, what is refuted, what is damaged."""

import json
import re
import shutil
from hashlib import sha256
from pathlib import Path
from typing import Any

import pytest

from mechanics import compile, derive, write_c
from systems import elastic_pendulum, rocker

NAME = "pendulum_on_elastic_support"


@pytest.fixture(scope="module")
def generated(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two functions of the elastic pendulum."""
    folder = tmp_path_factory.mktemp("generated") / "c"
    outputs = ("forward_dynamics", "energy")
    model = compile(derive(elastic_pendulum.scene()), fixed={"g": 9.81}, outputs=outputs)
    write_c(model, folder, batch=False, system="elastic_pendulum", prove=False)
    return folder


@pytest.fixture
def folder(generated: Path, tmp_path: Path) -> Path:
    """A copy of it."""
    shutil.copytree(generated, tmp_path / "c")
    return tmp_path / "c"


def rehash(folder: Path) -> None:
    """The hashes of the files as they are, in the manifest."""
    path = folder / "manifest.json"
    content = json.loads(path.read_text(encoding="utf-8"))
    for name in content["files"]:
        content["files"][name] = sha256((folder / name).read_bytes()).hexdigest()
    path.write_text(json.dumps(content), encoding="utf-8")


@pytest.mark.campaign
@pytest.mark.campaign
def test_codegen_and_verify(run: Any, tmp_path: Path) -> None:
    assert run("codegen", "elastic_pendulum", "-o", tmp_path / "c").code == 0
    manifest = json.loads((tmp_path / "c" / "manifest.json").read_text(encoding="utf-8"))
    steps = {step["step"]: step["findings"] for step in manifest["chain"]["steps"]}
    assert "derived equations = graph" in steps and len(steps["graph = C text"]) >= 26
    assert all(f["verdict"] in ("PROVED", "CERTIFIED") for f in steps["graph = C text"])
    assert all(f["error_bound"] < 2.0**-80 for f in steps["graph = C text"]
               if f["verdict"] == "CERTIFIED")  # fmt: skip
    ran = run("verify", tmp_path / "c", "--json", tmp_path / "found.json")
    assert ran.code == 0, ran.out + ran.err
    assert "physics, derived again = graph" in ran.out and "not compiled" not in ran.out
    found = json.loads((tmp_path / "found.json").read_text(encoding="utf-8"))
    assert found["outcome"] == "SHOWN" and not found["changed"]


@pytest.mark.campaign
def test_reformatted_code_passes_and_its_hash_is_told(run: Any, folder: Path) -> None:
    path = folder / f"{NAME}.c"
    text = re.sub(r"\bv(\d)", r"w_\1", path.read_text(encoding="utf-8")).replace("    ", "\t")
    path.write_text(f"// other words\n{text}", encoding="utf-8")
    ran = run("verify", folder, "--no-compile")
    assert ran.code == 0, ran.out
    assert (
        f"changed {NAME}.c: its hash differs from the manifest's, see the findings below" in ran.out
    )
    assert "the code was not compiled, as asked" in ran.out


@pytest.mark.campaign
def test_a_last_digit_is_refuted_whatever_the_hash(run: Any, folder: Path) -> None:
    path = folder / f"{NAME}.c"
    text = path.read_text(encoding="utf-8")
    changed = re.sub(r"(0x1\.[\da-f]{12})([\da-f])p",
                     lambda m: f"{m[1]}{int(m[2], 16) ^ 1:x}p", text, count=1)  # fmt: skip
    assert changed != text
    path.write_text(changed, encoding="utf-8")
    rehash(folder)
    ran = run("verify", folder)
    assert ran.code == 1
    assert "REFUTED" in ran.out and re.search(r"ud\[\d\]: the enclosures", ran.out)
    assert "left" in ran.out and "theta = " in ran.out and "changed" not in ran.out


@pytest.mark.campaign
def test_derived_equations_that_were_changed_are_refuted(run: Any, folder: Path) -> None:
    path = folder / "equations.json"
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace('["constant", "1/2"]', '["constant", "1/4"]'), encoding="utf-8")
    rehash(folder)
    ran = run("verify", folder, "--no-compile")
    assert ran.code == 1 and "derived, free_body" in ran.out


@pytest.mark.campaign
def test_a_file_that_no_step_looks_at(run: Any, folder: Path) -> None:
    (folder / "CMakeLists.txt").write_text("project(other)", encoding="utf-8")
    ran = run("verify", folder, "--no-compile")
    assert (
        ran.code == 3
        and "CMakeLists.txt: its hash differs from the manifest's: no step checks" in ran.out
    )
    (folder / "CMakeLists.txt").unlink()
    ran = run("verify", folder, "--no-compile")
    assert ran.code == 3 and "missing CMakeLists.txt" in ran.out


@pytest.mark.sample(2)
@pytest.mark.parametrize("ending", [".c", ".h", "_sine.h", "_selftest.c", "_loader.py"])
def test_a_missing_file_leaves_the_rest_to_be_judged(run: Any, folder: Path, ending: str) -> None:
    (folder / f"{NAME}{ending}").unlink()
    ran = run("verify", folder)
    assert ran.code == 3 and f"missing {NAME}{ending}" in ran.out, ran.err
    assert "derived equations = graph: 2 " in ran.out and "REFUTED" not in ran.out


def test_another_scene_is_refuted(run: Any, folder: Path) -> None:
    ran = run("verify", folder, "--scene", "rocker", "--no-compile")
    assert ran.code == 2 and ran.err.count("\n") == 1 and "another scene" in ran.err


def manifest_says(folder: Path, **entries: Any) -> None:
    path = folder / "manifest.json"
    content = json.loads(path.read_text(encoding="utf-8"))
    path.write_text(json.dumps({**content, **entries}), encoding="utf-8")


def test_without_physics_nothing_is_said_to_be_shown(run: Any, folder: Path) -> None:
    manifest_says(folder, system=None)
    ran = run("verify", folder, "--no-compile")
    assert ran.code == 3
    (line,) = [line for line in ran.out.splitlines() if line.startswith("UNDECIDED")]
    assert line == (
        "UNDECIDED physics: the equations were not derived again: the manifest names no system that"
        " comes with the program: give --scene FILE"
    )
    # What else it verified is told.
    assert "derived equations = graph: 2 " in ran.out and "graph = C text: " in ran.out
    ran = run("verify", folder, "--no-compile", "--json", "-")
    assert ran.code == 3 and json.loads(ran.out)["outcome"] == "UNDECIDED"
    assert run("verify", folder, "--no-compile", "--scene", "elastic_pendulum").code == 0


OWN = """
from pathlib import Path
from systems import elastic_pendulum

Path(__file__).with_name("ran").write_text("it was run")

def scene():
    return elastic_pendulum.scene()

def lighter():
    from mechanics.scene import Scene
    from systems import rocker
    return rocker.scene()
"""


@pytest.mark.campaign
@pytest.mark.parametrize("call", ["", ":scene"])
def test_a_file_is_run_where_a_person_names_it_only(run: Any, folder: Path, call: str) -> None:
    own, ran_it = folder.parent / "own.py", folder.parent / "ran"
    own.write_text(OWN, encoding="utf-8")
    (folder / "own.py").write_text(OWN, encoding="utf-8")
    for named in (f"{own}{call}", f"own.py{call}", str(folder / "own.py"), "own", "../own.py"):
        manifest_says(folder, system=named)
        ran = run("verify", folder, "--no-compile")
        assert ran.code == 3 and "UNDECIDED physics" in ran.out, ran.out
        assert "is none that comes with the program: give --scene FILE" in ran.out
        assert not ran_it.exists() and not (folder / "ran").exists()
    (folder / "own.py").unlink()
    ran = run("verify", folder, "--no-compile", "--scene", f"{own}{call}")
    assert ran.code == 0 and ran_it.exists(), ran.out


def test_what_follows_from_fixed_parameters_is_derived_again(run: Any, tmp_path: Path) -> None:
    """The mass of the rocker is rho h (pi R^2 / 2 + 2 R R): no fraction."""
    model = compile(
        derive(rocker.scene()), fixed={"rho": 1000, "h": 0.02, "R": 0.1}, outputs=["energy"]
    )
    write_c(model, tmp_path / "c", batch=False, system="rocker", prove=False)
    ran = run("verify", tmp_path / "c", "--no-compile")
    assert ran.code == 0, ran.err
    fixed = json.loads((tmp_path / "c" / "manifest.json").read_text(encoding="utf-8"))["fixed"]
    for value in ("2/5 + pi/4", "7", "1e99999999", "9**9**9"):
        manifest_says(tmp_path / "c", fixed={**fixed, "M": value})
        ran = run("verify", tmp_path / "c", "--no-compile")
        assert ran.code in (1, 2) and ran.err.count("\n") == (ran.code == 2)


@pytest.mark.parametrize(
    ("entries", "words"),
    [
        ({"system": "pendulum_chain(1000000)"}, "has more coordinates than the folder"),
        ({"system": "x\x1b[31m"}, r"'x\x1b[31m' is none that comes with the program"),
        ({"system": "os"}, "'os' is none that comes with the program"),
        ({"route": "../x"}, "the manifest's route '../x': the routes are free_body"),
    ],
)
def test_a_manifest_cannot_ask_for_much(
    run: Any, folder: Path, entries: dict[str, str], words: str
) -> None:
    manifest_says(folder, **entries)
    ran = run("verify", folder, "--no-compile")
    assert ran.code == 3 and words in ran.out and "derived equations = graph: 2 " in ran.out


def test_a_function_of_a_file_gives_the_scene(run: Any, folder: Path) -> None:
    own = folder.parent / "own.py"
    own.write_text(OWN, encoding="utf-8")
    ran = run("verify", folder, "--no-compile", "--scene", f"{own}:lighter")
    assert ran.code == 2 and "another scene" in ran.err and ran.err.count("\n") == 1
    ran = run("verify", folder, "--no-compile", "--scene", f"{own}:other")
    assert ran.code == 2 and "it has no function other() that returns a Scene" in ran.err


@pytest.mark.campaign
def test_a_folder_made_of_a_person_s_file(run: Any, pendulum: Any, tmp_path: Path) -> None:
    file, folder = pendulum(), tmp_path / "c"
    assert run("codegen", f"{file}:scene", "-o", folder, "--outputs", "energy").code == 0
    assert run("verify", folder, "--no-compile").code == 3
    assert run("verify", folder, "--no-compile", "--scene", file).code == 0
    other = pendulum(("gravity(-g * N.y)", "gravity(g * N.y)"))
    ran = run("verify", folder, "--no-compile", "--scene", other)
    assert ran.code == 1 and "physics, derived again = graph: 1 REFUTED" in ran.out


def put(folder: Path, name: str) -> None:
    (folder / name).parent.mkdir(parents=True, exist_ok=True)
    (folder / name).write_text("", encoding="utf-8")


@pytest.mark.campaign
@pytest.mark.sample(2)
@pytest.mark.parametrize("name", ["math.h", "cmath", "bits/x.h", "own/deep/a.hpp", "numpy.py",
                                  "numpy/__init__.py", "CMakePresets.json"])  # fmt: skip
def test_what_a_build_may_read_is_no_part_of_what_is_shown(
    run: Any, folder: Path, name: str
) -> None:
    put(folder, name)
    ran = run("verify", folder, "--no-compile")
    words = f"{name.split('/')[0]}: refused: the manifest does not list it, and a build may read it"
    assert ran.code == 3 and f"UNDECIDED {words}" in ran.out, ran.out


def test_what_no_build_reads_is_named(run: Any, folder: Path) -> None:
    for name in ("notes.txt", "build/CMakeCache.txt", ".git/config"):
        put(folder, name)
    ran = run("verify", folder, "--no-compile")
    assert ran.code == 0
    assert "beyond the manifest, and no build reads it: .git, build, notes.txt" in ran.out


@pytest.mark.parametrize("name", ["../x.c", "/etc/passwd", "-fplugin=x.c", "a/b.c", "", "..",
                                  "x\n.c", "a\0.c"])  # fmt: skip
def test_a_manifest_names_files_of_its_folder_only(run: Any, folder: Path, name: str) -> None:
    files = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))["files"]
    manifest_says(folder, files={**files, name: "0" * 64})
    ran = run("verify", folder, "--no-compile")
    assert ran.code == 2 and "is no name of a file in the folder" in ran.err
    assert ran.err.count("\n") == 1


def cut(path: Path) -> None:
    path.write_bytes(path.read_bytes()[:100])


def huge(path: Path) -> None:
    with path.open("r+b") as file:
        file.truncate(65_000_000)


DAMAGE = [
    ("manifest.json", cut, "it is no JSON"),
    ("manifest.json", Path.unlink, "there is no such file"),
    ("manifest.json", lambda p: p.write_text("[]"), "it has no 'files'"),
    ("manifest.json", lambda p: p.write_text("[" * 100_000), "nested too deeply"),
    ("equations.json", cut, "it is no JSON"),
    ("equations.json", lambda p: p.write_text("{}"), "it is not what was derived"),
    ("graphs.json", lambda p: p.write_text('{"nodes": 3}'), "it does not hold the graphs"),
    ("graphs.json", Path.unlink, "the manifest lists it, but the folder lacks it"),
    (f"{NAME}.c", lambda p: p.write_bytes(b"/* \xff\xfe */"), "it is no text in UTF-8"),
    (f"{NAME}.h", huge, "it is larger than 64 MB"),
]


@pytest.mark.parametrize("row", range(len(DAMAGE)))
def test_a_damaged_folder_is_one_line(run: Any, folder: Path, row: int) -> None:
    name, damage, words = DAMAGE[row]
    damage(folder / name)
    ran = run("verify", folder)
    assert ran.code == 2 and words in ran.err, ran.err
    assert ran.err.count("\n") == 1 and name in ran.err and not ran.out


def test_what_is_no_folder_is_one_line(run: Any, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("x", encoding="utf-8")
    for place, words in ((tmp_path / "none", "does not exist"), (tmp_path / "file", "is a file"),
                         (tmp_path, "manifest.json: there is no such file")):  # fmt: skip
        ran = run("verify", place)
        assert ran.code == 2 and words in ran.err and ran.err.count("\n") == 1


NODES = [
    ('["input", 0]', '["input", 999]', "refers to something else"),
    ('["input", 0]', '["system", 0]', "name of an operation"),
    ('["constant", "1/2"]', '["constant", "__import__(1)"]', "no fraction in a string"),
    ('["constant", "1/2"]', '["sin", 0, 1, 2]', "3 operands, 1 expected"),
    ('"groups": {"q": [0, 1]', '"groups": {"q": [0, 999]', "no place among"),
    ('["constant", "981/100"]', '["constant", "__import__(1)"]', "no fraction in a string"),
    ('"positive"', '"purple"', "a name and a sign are expected"),
]


@pytest.mark.parametrize(("old", "new", "words"), NODES)
def test_nothing_in_the_data_is_run(run: Any, folder: Path, old: str, new: str, words: str) -> None:
    path = folder / "equations.json"
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    ran = run("verify", folder)
    assert ran.code == 2 and words in ran.err and ran.err.count("\n") == 1

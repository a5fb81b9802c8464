"""Writing a folder: names that are taken, folders that hold something already."""

import functools
import json
import subprocess
from pathlib import Path

import particles
import pytest
from sympy.physics.mechanics import dynamicsymbols

from mechanics.compiled import Model
from mechanics.compiled import compile as compile_model
from mechanics.errors import InputError
from mechanics.export import write_c as write_and_prove
from mechanics.export.prefix import free_prefix
from mechanics.routes.derivation import by_route
from mechanics.scene import force, parameters

# The proofs are tested with the evidence.
write_c = functools.partial(write_and_prove, prove=False)

STRICT = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic"]
FEW = ["forward_dynamics"]


def named(name: str) -> Model:
    """A particle on a line, whose scene has that name."""
    x, m = dynamicsymbols("x"), parameters("m", units="kg", typical="1")[0]
    scene = particles.on_line(
        name, x, m, lambda N, O, P: [force("pull", P, -x * N.x, on="bob")], body="bob"
    )
    return compile_model(by_route("kane", scene), compiler=None)


@pytest.mark.parametrize(
    ("name", "prefix"),
    [
        ("int", "int_system"), ("2 links", "n2_links"), ("math", "math_system"),
        ("test", "test_system"), ("m", "m_system"), ("String", "String_system"),
        ("a__b", "a_b"), ("_x_", "x"), ("Größe", "Gr_e"), ("振り子", "value"), ("", "value"),
        ("../up", "up"), ("CON.c", "CON_c"), ("pendulum", "pendulum"),
    ],
)  # fmt: skip
def test_the_name_of_the_scene_becomes_a_free_name(name: str, prefix: str) -> None:
    assert free_prefix(name) == prefix
    # A name that was found free stays.
    assert free_prefix(prefix) == prefix


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", ["2 links", "test", "int"])
def test_a_scene_of_any_name_can_be_built(name: str, compiler: str, tmp_path: Path) -> None:
    prefix = free_prefix(name)
    write_c(named(name), tmp_path, precision="both")
    for part in (prefix, f"{prefix}_single"):
        sources = [str(tmp_path / f"{part}{end}.c") for end in ("", "_selftest")]
        subprocess.run([compiler, *STRICT, *sources, "-o", str(tmp_path / "a"), "-lm"], check=True)
        done = subprocess.run([str(tmp_path / "a")], capture_output=True, text=True, check=False)
        assert (done.returncode, done.stdout) == (0, f"{part}: 0 failures\n")


def test_cmake_builds_a_scene_that_is_called_test(needed, tmp_path: Path) -> None:
    write_c(named("test"), tmp_path / "c", functions=FEW)
    for command in (["-S", str(tmp_path / "c"), "-B", str(tmp_path)], ["--build", str(tmp_path)]):
        done = subprocess.run([needed("cmake"), *command], capture_output=True, check=False)
        assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("int", "'int' is no C identifier that is free: 'int_system' would be one"),
        ("math", "'math' hides a header, a library or a target of CMake: 'math_system' would not"),
        ("a b", "'a b' is no C identifier that is free: 'a_b' would be one"),
    ],
)
def test_a_name_that_is_taken_is_refused(modelled, tmp_path: Path, name: str, words: str) -> None:
    with pytest.raises(InputError) as caught:
        write_c(modelled("rocker", "kane"), tmp_path / "c", name=name)
    assert words in str(caught.value)
    assert not (tmp_path / "c").exists()


def test_a_precision_that_there_is_not_is_refused(modelled, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="precision 'half': there are double, single, both"):
        write_c(modelled("rocker", "kane"), tmp_path / "c", precision="half")


@pytest.mark.parametrize("folder", ["", " "])
def test_an_empty_name_is_no_folder(modelled, folder: str) -> None:
    with pytest.raises(InputError, match="the name of what to write is empty"):
        write_c(modelled("rocker", "kane"), folder, functions=FEW)


def test_files_of_others_are_left_alone(modelled, tmp_path: Path) -> None:
    mine = tmp_path / "CMakeLists.txt"
    mine.write_text("mine", encoding="utf-8")
    with pytest.raises(InputError, match=r"CMakeLists\.txt stands there and was not generated"):
        write_c(modelled("rocker", "kane"), tmp_path, functions=FEW)
    assert [path.name for path in tmp_path.iterdir()] == ["CMakeLists.txt"]
    assert mine.read_text(encoding="utf-8") == "mine"
    mine.rename(tmp_path / "notes.txt")
    write_c(modelled("rocker", "kane"), tmp_path, functions=FEW)
    assert (tmp_path / "notes.txt").read_text(encoding="utf-8") == "mine"


@pytest.mark.parametrize("text", ["{}", "[]", "no JSON", '{"files": 3, "prefix": "rocker"}'])
def test_a_manifest_of_others_is_left_alone(modelled, tmp_path: Path, text: str) -> None:
    (tmp_path / "manifest.json").write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=r"manifest\.json stands there and was not generated"):
        write_c(modelled("rocker", "kane"), tmp_path, functions=FEW)
    assert (tmp_path / "manifest.json").read_text(encoding="utf-8") == text


def test_writing_again_replaces_and_removes_what_was_written(modelled, tmp_path: Path) -> None:
    model = modelled("rocker", "kane")
    write_c(model, tmp_path, functions=FEW, precision="both")
    (tmp_path / "rocker_single.h").write_text("edited", encoding="utf-8")
    (tmp_path / "rocker.c").write_text("edited", encoding="utf-8")
    assert (tmp_path / "rocker_single.c").exists()
    files = write_c(model, tmp_path, functions=FEW)
    # What somebody has changed is kept when it is no longer written.
    left = {"rocker_single.h"}
    assert {path.name for path in tmp_path.iterdir()} == {path.name for path in files} | left
    assert "edited" not in (tmp_path / "rocker.c").read_text(encoding="utf-8")


def test_a_folder_of_another_system_is_left_alone(modelled, tmp_path: Path) -> None:
    write_c(modelled("rocker", "kane"), tmp_path, functions=FEW)
    before = {path: path.read_bytes() for path in tmp_path.iterdir()}
    with pytest.raises(InputError, match="holds 'rocker' already: name another folder for 'other'"):
        write_c(modelled("rocker", "kane"), tmp_path, functions=FEW, name="other")
    assert {path: path.read_bytes() for path in tmp_path.iterdir()} == before


def test_a_manifest_cannot_make_us_remove_files_elsewhere(modelled, tmp_path: Path) -> None:
    model, folder = modelled("rocker", "kane"), tmp_path / "c"
    write_c(model, folder, functions=FEW)
    victim = tmp_path / "victim"
    victim.write_bytes(b"")
    path = folder / "manifest.json"
    manifest = json.loads(path.read_text(encoding="utf-8"))
    nothing = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"
    manifest["files"] |= {"../victim": nothing, str(victim): nothing}
    path.write_text(json.dumps(manifest), encoding="utf-8")
    write_c(model, folder, functions=FEW)
    assert victim.exists()


def test_a_folder_that_cannot_be_made_is_named(modelled, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("", encoding="utf-8")
    with pytest.raises(InputError, match=r"file/c cannot be written: .*/file is a file"):
        write_c(modelled("rocker", "kane"), tmp_path / "file" / "c", functions=FEW)


def test_a_folder_that_cannot_be_written_is_named(modelled, tmp_path: Path, monkeypatch) -> None:
    def refuse(path: Path, data: bytes) -> int:
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.setattr(Path, "write_bytes", refuse)
    with pytest.raises(InputError, match="cannot be written: Permission denied: name a folder"):
        write_c(modelled("rocker", "kane"), tmp_path / "c", functions=FEW)

"""C folders: what is written compiles without a warning, tests itself, and stays the same."""

import functools
import hashlib
import inspect
import json
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from sympy import Matrix, cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.compiled import Model
from mechanics.compiled import compile as compile_model
from mechanics.errors import InputError, SingularError
from mechanics.export import loader_template
from mechanics.export import write_c as write_and_prove
from mechanics.export.header import comment
from mechanics.export.vectors import vectors
from mechanics.routes.derivation import by_route
from mechanics.scene import Particle, Scene, force, gravity, parameters, reaction

# The proofs are tested with the evidence.
write_c = functools.partial(write_and_prove, prove=False)

GOLDEN = Path(__file__).parent / "golden" / "elastic_pendulum"
STRICT = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic"]
# clang tells that it vectorises nothing here.
SANITIZED = [
    "-Wno-unknown-warning-option",
    "-Wno-pass-failed",
    "-g",
    "-O1",
    "-fsanitize=address,undefined",
    "-fno-sanitize-recover=all",
]
SYSTEMS = [
    ("elastic_pendulum", "free_body"), ("rocker", "moving_point"), ("two_mass_chain", "lagrange"),
    ("rolling_disc", "free_body"), ("four_bar", "kane"),
]  # fmt: skip


def build(compiler: str, folder: Path, *flags: str, of: str = "") -> Path:
    """The self-test of one state, or that of a batch, with what it tests."""
    test = next(
        path for path in folder.glob("*_selftest.c") if ("_batch_" in path.name) == bool(of)
    )
    stem = test.name.removesuffix(f"{of}_selftest.c")
    program = folder / "selftest"
    sources = [str(folder / f"{stem}{end}.c") for end in {"": 0, of: 0}] + [str(test)]
    command = [compiler, *STRICT, *flags, *sources, "-o", str(program), "-lm"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return program


def run(program: Path) -> subprocess.CompletedProcess:
    return subprocess.run([str(program)], capture_output=True, text=True, check=False)


@pytest.fixture(scope="module", params=SYSTEMS, ids=lambda pair: pair[0])
def folder(request, modelled, tmp_path_factory: pytest.TempPathFactory) -> Path:
    place = tmp_path_factory.mktemp("c")
    write_c(modelled(*request.param), place)
    return place


@pytest.mark.campaign
@pytest.mark.sample(1)
def test_c_is_clean_and_passes_its_test_under_sanitizers(folder: Path, compiler: str) -> None:
    for of in ("", "_batch"):
        done = run(build(compiler, folder, *SANITIZED, of=of))
        assert done.returncode == 0, done.stdout + done.stderr
        assert done.stdout.endswith(f"{of}: 0 failures\n") and not done.stderr


@pytest.mark.campaign
def test_optimised_code_passes_too(modelled, compiler: str, tmp_path: Path) -> None:
    write_c(modelled("elastic_pendulum", "kane"), tmp_path)
    for of in ("", "_batch"):
        assert run(build(compiler, tmp_path, "-O3", "-march=native", of=of)).returncode == 0


@pytest.mark.campaign
def test_a_changed_sign_fails_the_self_test(modelled, compiler: str, tmp_path: Path) -> None:
    model = modelled("elastic_pendulum", "kane")
    write_c(model, tmp_path, name="pendulum", functions=["forward_dynamics", "energy"])
    source = tmp_path / "pendulum.c"
    text = source.read_text(encoding="utf-8")
    lines = [i for i, line in enumerate(text.splitlines()) if re.search(r"\w [+-] \w", line)]
    assert len(lines) > 5
    for i in lines:
        changed = text.splitlines()
        changed[i] = re.sub(r"(?<=\w) ([+-]) (?=\w)", lambda m: " - " if m[1] == "+" else " + ",
                            changed[i], count=1)  # fmt: skip
        source.write_text("\n".join(changed) + "\n", encoding="utf-8")
        done = run(build(compiler, tmp_path, "-O0"))
        assert done.returncode == 1, changed[i]
        assert "expected" in done.stdout


def lasting(path: Path) -> str:
    """The text of a file without versions, which change without the code; of a loader its tables.

    The rest of a loader is `mechanics.export.loader_template`.
    """
    text = path.read_text(encoding="utf-8")
    if path.name == "manifest.json":
        manifest = json.loads(text)
        del manifest["versions"]
        return json.dumps(manifest, indent=2) + "\n"
    if path.suffix != ".py":
        return text
    before, start, rest = text.partition("# What was generated")
    made, end, after = rest.partition("# End of what was generated.\n")
    template = inspect.getsource(loader_template).splitlines()
    assert len({*before.splitlines()} - {*template}) == 3
    assert after.splitlines() == template[-after.count("\n") :]
    return start + made + end


def test_golden_files(modelled, tmp_path: Path, update_golden: bool) -> None:
    model = modelled("elastic_pendulum", "free_body")
    written = {p.name: lasting(p) for p in write_c(model, tmp_path, name="elastic_pendulum")}
    for name, text in written.items() if update_golden else ():
        (GOLDEN / name).write_text(text, encoding="utf-8")
    assert {path.name for path in GOLDEN.iterdir()} == {*written}
    for name, text in written.items():
        golden = (GOLDEN / name).read_text(encoding="utf-8")
        assert text == golden, f"{name} differs: UPDATE_GOLDEN=1 pytest tests/export"


def test_manifest_tells_what_was_written(modelled, tmp_path: Path) -> None:
    model = modelled("rocker", "kane")
    files = write_c(model, tmp_path, functions=["forward_dynamics", "energy"])
    manifest = json.loads((tmp_path / "manifest.json").read_text(encoding="utf-8"))
    assert manifest["scene"] == "rocker" and manifest["route"] == "kane"
    assert list(manifest["functions"]) == ["forward_dynamics", "energy"]
    count = manifest["functions"]["forward_dynamics"]["operations"]
    assert count == model.program("forward_dynamics").operations > 0
    assert manifest["reciprocals"] and manifest["functions"]["forward_dynamics"]["divisions"] == 1
    assert {path.name for path in files} == {*manifest["files"], "manifest.json"}
    for name, digest in manifest["files"].items():
        assert hashlib.sha256((tmp_path / name).read_bytes()).hexdigest() == digest
    assert manifest["versions"]["sympy"].startswith("1.14")
    assert "mass_matrix" not in (tmp_path / "rocker.c").read_text(encoding="utf-8")


@pytest.mark.campaign
def test_cmake_builds_and_ctest_passes(modelled, tmp_path: Path) -> None:
    cmake, ctest = shutil.which("cmake"), shutil.which("ctest")
    if cmake is None or ctest is None:
        pytest.skip("no CMake here")
    write_c(modelled("two_mass_chain", "kane"), tmp_path / "c")
    for command in (
        [cmake, "-S", str(tmp_path / "c"), "-B", str(tmp_path / "b")],
        [cmake, "--build", str(tmp_path / "b")],
        [ctest, "--test-dir", str(tmp_path / "b"), "--output-on-failure"],
    ):
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr
    assert "100% tests passed" in done.stdout


def test_header_is_read_by_cpp(modelled, tmp_path: Path) -> None:
    compiler = shutil.which("g++") or shutil.which("clang++")
    if compiler is None:
        pytest.skip("no C++ compiler here")
    write_c(modelled("rocker", "kane"), tmp_path)
    (tmp_path / "use.cpp").write_text(
        '#include "rocker.h"\nint main() { double e[1] = {0}; return int(e[0]); }\n',
        encoding="utf-8",
    )
    command = [
        compiler,
        "-Wall",
        "-Werror",
        "-pedantic",
        "-fsyntax-only",
        str(tmp_path / "use.cpp"),
    ]
    assert subprocess.run(command, capture_output=True, check=False).returncode == 0


def awkward() -> Model:
    """A particle whose names are keywords, macros and library functions of C."""
    I, y1 = dynamicsymbols("I y1")
    double, M_PI, m, v1, p = parameters(
        "double M_PI m v1 p",
        units="N/m m/s^2 kg 1 1",
        typical="1 2 3 4 5",
        meanings=(
            "stiffness */ of\nwhat",
            "gravity /* down ??/",
            "mass\\",
            "@NAME@ '\"",
            "plain; ${x}",
        ),
    )
    ground, origin = ReferenceFrame("N"), Point("O")
    place = origin.locatenew("P", I * ground.x + y1 * ground.y)
    pull = force("pull", place, -double * v1 * I * ground.x + p * I * ground.y, on="lambda")
    scene = Scene(
        "int main() /* 2 */", ground, origin, coordinates=(I, y1),
        bodies=(Particle("lambda", place, m),),
        loads=(gravity(-M_PI * ground.y), pull),
        reactions=(reaction("N1", at=place, on="lambda", by=None, along=ground.z),),
    )  # fmt: skip
    return compile_model(by_route("free_body", scene), compiler=None)


@pytest.mark.campaign
def test_awkward_names_become_identifiers_and_comments_stay_closed(
    compiler: str, tmp_path: Path
) -> None:
    files = write_c(awkward(), tmp_path)
    assert files[0].name == "int_main_2.h"
    assert run(build(compiler, tmp_path, *SANITIZED)).returncode == 0


def test_awkward_words_are_data_in_python_and_harmless_in_cmake(needed, tmp_path: Path) -> None:
    model = awkward()
    write_c(model, tmp_path / "c", precision="both")
    tables: dict = {}
    exec((tmp_path / "c" / "int_main_2_loader.py").read_text(encoding="utf-8"), tables)
    for array in ("q", "u", "inputs", "p"):
        entries = getattr(model.quantities, array)
        assert tables["ARRAYS"][array] == tuple((e.name, e.unit, e.meaning) for e in entries)
    command = [needed("cmake"), "-S", str(tmp_path / "c"), "-B", str(tmp_path / "b")]
    assert subprocess.run(command, capture_output=True, check=False).returncode == 0


def test_comment_is_one_line_that_closes_nothing() -> None:
    assert comment("a */ b\n/* c\\ ??/") == "a * / b / * c/ ? ?/"


def test_expected_values_are_the_nearest_doubles_and_tolerances_are_small(modelled) -> None:
    model = modelled("elastic_pendulum", "lagrange")
    for name in model.casadi:
        for vector in vectors(model, name):
            groups = [group for group, _ in model.program(name).inputs]
            given = dict(zip(groups, map(np.array, vector.inputs), strict=True))
            found = model.evaluate(name, **given)
            for values, expected, room in zip(
                found.values(), vector.expected, vector.tolerance, strict=True
            ):
                flat = values.T.ravel()
                assert (np.abs(flat - expected) <= room).all()
                assert (np.array(room) <= 2.0**-20 * np.abs(expected).max(initial=0)).all()


def test_a_singular_function_cannot_be_tested(modelled, tmp_path: Path) -> None:
    equations = modelled("elastic_pendulum", "lagrange").equations
    theta = equations.scene.q[1]
    s, c = sin(theta), cos(theta)
    singular = equations.with_matrices(mass=Matrix([[s**2, s * c], [s * c, c**2]]))
    with pytest.raises(SingularError, match="it is well defined at none"):
        write_c(compile_model(singular, compiler=None), tmp_path / "c")
    assert not (tmp_path / "c").exists()


def test_bad_requests_are_named(modelled, tmp_path: Path) -> None:
    model = modelled("rocker", "kane")
    with pytest.raises(InputError, match="'for' is no C identifier"):
        write_c(model, tmp_path, name="for")
    with pytest.raises(InputError, match="function 'speed'"):
        write_c(model, tmp_path / "none", functions=["speed"])
    assert not (tmp_path / "none").exists()
    (tmp_path / "file").write_text("", encoding="utf-8")
    with pytest.raises(InputError, match="is a file"):
        write_c(model, tmp_path / "file")

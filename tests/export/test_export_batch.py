"""Functions of many states in a folder: vectorised, equal to those of one state, tested by it."""

import functools
import importlib.util
import re
import subprocess
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from mechanics.compiled.machine.native import find_compiler
from mechanics.export import write_c as write_and_prove
from mechanics.export.batch import BATCHED

pytestmark = pytest.mark.campaign

# The proofs are tested with the evidence.
write_c = functools.partial(write_and_prove, prove=False)

# clang tells that it vectorises nothing without optimisation.
QUIET = ["-Wno-unknown-warning-option", "-Wno-pass-failed"]
STRICT = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-Wconversion", *QUIET]
# Compilers make these of loops that copy or clear; every implementation of C has them.
COPIES = {"memcpy", "memmove", "memset"}
FILES = ("system_batch.c", "system_single_batch.c")


@pytest.fixture(scope="module")
def folders(modelled, tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """A folder of each system, in both precisions."""

    @functools.cache
    def folder(system: str) -> Path:
        place = tmp_path_factory.mktemp("with a space") / "c"
        model = modelled(system, "kane")
        write_c(model, place, name="system", functions=BATCHED, precision="both")
        return place

    return folder


@functools.cache
def wide(compiler: str) -> bool:
    """Whether the compiler can be expected to vectorise here: gcc needs more than SSE2 for that."""
    command = [compiler, "-march=native", "-dM", "-E", "-x", "c", "/dev/null"]
    said = subprocess.run(command, capture_output=True, text=True, check=False).stdout
    return "__AVX2__" in said


def built(needed: Callable[[str], str], folder: Path, build: Path, *options: str) -> str:
    """What CMake says; the self-tests have to pass."""
    said = ""
    for command in (
        [needed("cmake"), "-S", str(folder), "-B", str(build), *options],
        [needed("cmake"), "--build", str(build)],
        [needed("ctest"), "--test-dir", str(build), "--output-on-failure"],
    ):
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr
        said += done.stdout + done.stderr
    return said


@pytest.mark.sample(1)
def test_loops_are_vectorised_and_the_build_says_so(
    folders, compiler: str, needed, tmp_path: Path
) -> None:
    if not wide(compiler):
        pytest.skip("no AVX2 here")
    said = built(needed, folders("elastic_pendulum"), tmp_path, f"-DCMAKE_C_COMPILER={compiler}",
                 "-DSYSTEM_NATIVE=ON")  # fmt: skip
    for file, prefix in zip(FILES, ("system", "system_single"), strict=True):
        names = [f"{prefix}_{name}_batch" for name in BATCHED]
        (found,) = re.findall(rf"-- {file}: vectorised (.*)", said)
        assert sorted(found.split(", ")) == sorted(names)
    assert "NOT vectorised" not in said


def test_the_build_says_when_loops_are_not_vectorised(
    folders, compiler: str, needed, tmp_path: Path
) -> None:
    folder = folders("rocker")
    # Only without optimisation: clang follows the pragma even when told not to vectorise.
    text = (folder / "CMakeLists.txt").read_text(encoding="utf-8")
    slow = tmp_path / "slow"
    slow.mkdir()
    for path in folder.iterdir():
        (slow / path.name).write_bytes(path.read_bytes())
    (slow / "CMakeLists.txt").write_text(text.replace("-O3", "-O0"), encoding="utf-8")
    options = [f"-DCMAKE_C_COMPILER={compiler}", "-DSYSTEM_PRECISION=double"]
    words = " ".join(built(needed, slow, tmp_path / "b", *options).split())
    assert "system_batch.c: NOT vectorised: system" in words
    assert "They are right, and slow" in words and ": vectorised" not in words


def test_they_can_be_left_out(modelled, folders, needed, tmp_path: Path) -> None:
    options = ["-DSYSTEM_BATCH=OFF", "-DSYSTEM_PRECISION=double"]
    said = built(needed, folders("rocker"), tmp_path / "b", *options)
    assert "0 tests failed out of 1" in said and "batch" not in said
    files = write_c(modelled("rocker", "kane"), tmp_path / "c", functions=BATCHED, batch=False)
    assert not any("batch" in path.name for path in files)
    said = built(needed, tmp_path / "c", tmp_path / "d")
    assert "0 tests failed out of 1" in said and "batch" not in said


@pytest.mark.parametrize("level", ["-O0", "-O3"])
@pytest.mark.parametrize("system", ["rocker", "two_mass_chain"])
def test_they_call_the_functions_of_one_state_and_nothing_else(
    folders, compiler: str, needed, tmp_path: Path, system: str, level: str
) -> None:
    for file in FILES:
        objects = tmp_path / "batch.o"
        command = [compiler, *STRICT, level, "-c", str(folders(system) / file), "-o", str(objects)]
        subprocess.run(command, check=True)
        rows = subprocess.run(
            [needed("nm"), str(objects)], capture_output=True, text=True, check=True
        )
        found = [line.split()[-2:] for line in rows.stdout.splitlines()]
        prefix = file.removesuffix("_batch.c")
        allowed = {f"{prefix}_{name}" for name in BATCHED} | COPIES
        assert {name for kind, name in found if kind == "U"} <= allowed
        assert not [name for kind, name in found if kind in "BbDdCGgSs"]


CHANGES = [
    ("1 * stride", "0 * stride"),
    ("count - i < 256 ? count - i : 256", "count - i < 256 ? count - i - 1 : 256"),
    ("count - i < 256 ? count - i : 256", "count - i < 256 ? count - i + 1 : 256"),
    ("i += 256", "i += 255"),
    ("i += 256", "i += 257"),
    ("ud + i)", "ud)"),
    (" + i, u + i,", " + i, u,"),
    ("return found;", "return 0 * found + 1;"),
]


@pytest.mark.sample(6)
@pytest.mark.parametrize("change", CHANGES, ids=lambda pair: f"{pair[0]} -> {pair[1]}")
def test_a_wrong_place_fails_the_self_test(
    modelled, compiler: str, tmp_path: Path, change: tuple[str, str]
) -> None:
    model = modelled("elastic_pendulum", "kane")
    write_c(model, tmp_path, name="system", functions=["forward_dynamics"])
    source = tmp_path / "system_batch.c"
    text = source.read_text(encoding="ascii")
    assert change[0] in text
    harmless = change == ("i += 256", "i += 255")
    program = tmp_path / "test"
    sources = [str(tmp_path / f"system{end}.c") for end in ("", "_batch", "_batch_selftest")]
    for spoilt in (False, True):
        if spoilt:
            source.write_text(text.replace(*change), encoding="ascii")
        subprocess.run([compiler, "-std=c99", *sources, "-o", str(program), "-lm"], check=True)
        done = subprocess.run([str(program)], capture_output=True, text=True, check=False)
        # Computing a state twice is no error.
        assert (done.returncode != 0) == (spoilt and not harmless), done.stdout[-500:]


@pytest.fixture(scope="module")
def loader(modelled, tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    if find_compiler() is None:
        pytest.skip("no C compiler here")
    place = tmp_path_factory.mktemp("loader")
    write_c(modelled("elastic_pendulum", "kane"), place, name="system", precision="both")
    spec = importlib.util.spec_from_file_location("system_loader", place / "system_loader.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize(("precision", "room"), [("double", 1e-13), ("single", 1e-4)])
def test_python_gives_and_takes_rows(modelled, loader, precision: str, room: float) -> None:
    model, system = modelled("elastic_pendulum", "kane"), loader.load(precision=precision)
    random = np.random.default_rng(1)
    q, u = random.uniform(-3, 3, (2, 1000)), random.uniform(-3, 3, (2, 1000))
    # One angle is too large for the inline sine.
    q[1, 500] = 2.0**21 + 1
    p = {"L": 2.0, "k": 3.0}
    found = system.forward_dynamics_batch(q, u, p)
    expected = model.forward_dynamics(q.T, u.T, p=p)
    assert np.allclose(found.ud.T, expected, rtol=room, atol=room)
    energy = system.energy_batch(q=q.tolist(), u=u, p=p)
    assert np.allclose(energy.total[0], model.energy(q.T, u.T, p=p)["total"], rtol=room, atol=room)


def test_python_reads_an_array_where_it_stands(loader: ModuleType) -> None:
    system = loader.load()
    wide = np.zeros((2, 64))
    view = wide[:, ::2]
    view[:] = np.arange(64).reshape(2, 32) / 50
    strided = system.forward_dynamics_batch(view, view).ud
    assert np.array_equal(strided, system.forward_dynamics_batch(view.copy(), view.copy()).ud)


def test_wrong_rows_are_named(loader: ModuleType) -> None:
    system = loader.load()
    rows = np.zeros((2, 7))
    with pytest.raises(ValueError, match="forward_dynamics_batch: 7 in q, 6 in u: give as"):
        system.forward_dynamics_batch(rows, rows[:, :6])
    with pytest.raises(ValueError, match="q lacks x, theta"):
        system.forward_dynamics_batch()
    with pytest.raises(ValueError, match="u has 1 rows: x_dot, theta_dot are 2"):
        system.forward_dynamics_batch(rows, rows[:1])
    with pytest.raises(ValueError, match="p has no 'mass'"):
        system.forward_dynamics_batch(rows, rows, {"mass": 1})

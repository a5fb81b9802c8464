"""The folder as a package: found by CMake and pkg-config, used from C and C++, two in a program."""

import functools
import shlex
import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from mechanics.export import write_c as write_and_prove

pytestmark = pytest.mark.campaign

# The proofs are tested with the evidence.
write_c = functools.partial(write_and_prove, prove=False)

USE = """\
cmake_minimum_required(VERSION 3.14)
project(user LANGUAGES C CXX)
{find}
add_executable(user user.cpp)
target_link_libraries(user PRIVATE {targets})
"""
CPP = """\
#include "elastic_pendulum.h"
#include "rocker.h"

#include <array>
#include <cstdio>

int main()
{
    std::array<double, ELASTIC_PENDULUM_Q_SIZE> q{0.1, 0.2}, u{0.3, 0.4}, ud{};
    const std::array<double, ELASTIC_PENDULUM_P_SIZE> p{1, 1, 9.81, 10, 1};
    static_assert(ROCKER_Q_SIZE == 1 && ROCKER_OK == 0, "sizes are those of the rocker");
    double angle[ROCKER_Q_SIZE] = {0.1}, rate[ROCKER_U_SIZE] = {0.2}, rates[ROCKER_Q_SIZE];
    const double force[ROCKER_INPUTS_SIZE] = {0}, of_rocker[ROCKER_P_SIZE] = {1};
    const int status =
        elastic_pendulum_forward_dynamics(q.data(), u.data(), p.data(), ud.data());
    const int other = rocker_coordinate_rates(angle, rate, force, of_rocker, rates);
    std::printf("%.17g %.17g %.17g", ud[0], ud[1], rates[0]);
    return status | other;
}
"""


@pytest.fixture(scope="module")
def folders(modelled, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two systems in folders with a space in the path."""
    place = tmp_path_factory.mktemp("with a space")
    for name, functions in (("elastic_pendulum", ["forward_dynamics", "energy"]), ("rocker", None)):
        model = modelled(name, "kane")
        write_c(model, place / name, name=name, functions=functions, precision="both")
    return place


@pytest.fixture(scope="module")
def run(needed: Callable[[str], str]) -> Callable[..., str]:
    """Runs a command, which has to succeed."""

    def run(command: Sequence[str | Path], **more) -> str:
        given = [needed(str(command[0])), *map(str, command[1:])]
        done = subprocess.run(given, capture_output=True, text=True, check=False, **more)
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    return run


@pytest.fixture(scope="module")
def installed(folders: Path, run) -> Path:
    """Both, built, tested and installed."""
    prefix = folders / "installed"
    for name in ("elastic_pendulum", "rocker"):
        build = folders / f"build {name}"
        shared = f"-D{name.upper()}_SHARED=ON" if name == "rocker" else "-DUNUSED=1"
        run(["cmake", "-S", folders / name, "-B", build, shared])
        run(["cmake", "--build", build])
        said = run(["ctest", "--test-dir", build])
        assert "100% tests passed, 0 tests failed out of 4" in said
        run(["cmake", "--install", build, "--prefix", prefix])
    return prefix


@pytest.fixture(scope="module")
def expected(modelled) -> list[float]:
    model = modelled("elastic_pendulum", "kane")
    return [*model.forward_dynamics([0.1, 0.2], [0.3, 0.4]), 0.2]


def built_and_run(run, folder: Path, find: str, *options: str) -> list[float]:
    """A program that uses both, made by CMake."""
    targets = "elastic_pendulum::elastic_pendulum rocker::rocker"
    (folder / "CMakeLists.txt").write_text(USE.format(find=find, targets=targets))
    (folder / "user.cpp").write_text(CPP)
    run(["cmake", "-S", folder, "-B", folder / "build", *options])
    run(["cmake", "--build", folder / "build"])
    return [float(word) for word in run([folder / "build" / "user"]).split()]


def test_find_package_gives_the_target(installed: Path, tmp_path: Path, run, expected) -> None:
    find = "find_package(elastic_pendulum REQUIRED)\nfind_package(rocker CONFIG REQUIRED)"
    prefix = f"-DCMAKE_PREFIX_PATH={installed}"
    assert built_and_run(run, tmp_path, find, prefix) == pytest.approx(expected, rel=1e-14)


def test_an_installed_folder_can_be_moved(installed: Path, tmp_path: Path, run, expected) -> None:
    moved = tmp_path / "moved there"
    run(["cp", "-r", installed, moved])
    (tmp_path / "use").mkdir()
    find = "find_package(elastic_pendulum REQUIRED)\nfind_package(rocker REQUIRED)"
    prefix = f"-DCMAKE_PREFIX_PATH={moved}"
    assert built_and_run(run, tmp_path / "use", find, prefix) == pytest.approx(expected, rel=1e-14)


def test_two_folders_are_parts_of_one_build(folders, tmp_path: Path, run, expected) -> None:
    find = "".join(
        f'add_subdirectory("{(folders / name).as_posix()}" {name})\n'
        for name in ("elastic_pendulum", "rocker")
    )
    assert built_and_run(run, tmp_path, find) == pytest.approx(expected, rel=1e-14)
    # Tests and rules for installing belong to the outer project.
    assert not list(tmp_path.rglob("*selftest*"))


def test_pkg_config_tells_how_to_build(installed: Path, tmp_path: Path, run, expected) -> None:
    (path,) = {file.parent for file in installed.rglob("*.pc")}
    command = ["pkg-config", "--cflags", "--libs", "elastic_pendulum", "rocker"]
    flags = shlex.split(run(command, env={"PKG_CONFIG_PATH": str(path)}))
    (tmp_path / "user.cpp").write_text(CPP)
    run(["g++", tmp_path / "user.cpp", "-o", tmp_path / "user", *flags])
    (library,) = {file.parent for file in installed.rglob("librocker.so")}
    found = run([tmp_path / "user"], env={"LD_LIBRARY_PATH": str(library)})
    assert [float(word) for word in found.split()] == pytest.approx(expected, rel=1e-14)


@pytest.mark.parametrize("cpp", ["g++", "clang++"])
def test_headers_are_read_by_cpp(folders: Path, run, tmp_path: Path, cpp: str) -> None:
    found = sorted(path.name for path in folders.glob("*/*.h"))
    headers = [name for name in found if "sine" not in name]
    assert headers[4:] == [f"rocker{end}.h" for end in ("", "_batch", "_single", "_single_batch")]
    text = "".join(f'#include "{name}"\n' for name in headers * 2) + "int main() { return 0; }\n"
    (tmp_path / "use.cpp").write_text(text)
    strict = ["-std=c++11", "-Wall", "-Wextra", "-Werror", "-pedantic", "-fsyntax-only"]
    assert run([cpp, *strict, *(f"-I{f}" for f in folders.glob("*/")), tmp_path / "use.cpp"]) == ""


def test_options_choose_precision_and_flags(folders: Path, tmp_path: Path, run) -> None:
    flags = "-DROCKER_FLAGS=-march=native;-Wconversion;-Wdouble-promotion;-Werror"
    run(["cmake", "-S", folders / "rocker", "-B", tmp_path, "-DROCKER_PRECISION=single", flags])
    said = run(["cmake", "--build", tmp_path, "--verbose"])
    assert "-march=native -Wconversion" in said
    assert "rocker_single.c" in said and "rocker.c" not in said
    assert "rocker_single_selftest" in run(["ctest", "--test-dir", tmp_path])


def test_a_library_is_for_every_machine_unless_asked_otherwise(
    folders: Path, tmp_path: Path, run
) -> None:
    for options, machine in (([], False), (["-DROCKER_NATIVE=ON"], True)):
        build = tmp_path / str(machine)
        more = ["-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", "-DROCKER_PRECISION=double", *options]
        run(["cmake", "-S", folders / "rocker", "-B", build, *more])
        commands = (build / "compile_commands.json").read_text(encoding="utf-8")
        assert "rocker_batch.c" in commands and ("-march=native" in commands) is machine


def test_a_precision_that_is_not_there_is_refused(modelled, tmp_path: Path, needed) -> None:
    write_c(modelled("rocker", "kane"), tmp_path / "c", name="rocker", functions=["energy"])
    command = [needed("cmake"), "-S", str(tmp_path / "c"), "-B", str(tmp_path / "b")]
    done = subprocess.run(
        [*command, "-DROCKER_PRECISION=single"], capture_output=True, text=True, check=False
    )
    assert done.returncode != 0
    assert "ROCKER_PRECISION is single: this folder has double" in " ".join(done.stderr.split())

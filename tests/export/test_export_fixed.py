"""C of a fixed and restricted model: says what is fixed, holds nothing else, and tests itself."""

import functools
import json
import re
import subprocess
from pathlib import Path

import pytest

from mechanics.compiled import compile
from mechanics.compiled.machine.native import find_compiler
from mechanics.crosscheck import derive
from mechanics.export import write_c as write_and_prove
from systems import elastic_pendulum

# The proofs are tested with the evidence.
write_c = functools.partial(write_and_prove, prove=False)

STRICT = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic"]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    target = tmp_path_factory.mktemp("fixed")
    equations = derive(elastic_pendulum.scene())
    model = compile(equations, fixed={"g": 9.81, "m": 0}, outputs=("forward_dynamics", "energy"))
    write_c(model, target, name="pendulum")
    return target


def test_the_header_says_what_is_fixed(folder: Path) -> None:
    header = (folder / "pendulum.h").read_text(encoding="utf-8")
    assert " *   g = 981/100\n *   m = 0\n" in header
    assert "PENDULUM_P_SIZE 3" in header
    assert re.findall(r"p\[\d\]  (\w+)", header) == ["L", "M", "k"]
    assert "REACTIONS" not in header


def test_the_manifest_says_what_is_fixed(folder: Path) -> None:
    content = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
    assert content["fixed"] == {"g": "981/100", "m": "0"}
    parts = ["prepare", "forward_dynamics_prepared"]
    assert list(content["functions"]) == ["forward_dynamics", "energy", *parts]
    assert [entry["name"] for entry in content["arrays"]["p"]] == ["L", "M", "k"]
    assert "reactions" not in content["arrays"]


def test_the_code_holds_nothing_else(folder: Path) -> None:
    text = (folder / "pendulum.c").read_text(encoding="utf-8")
    functions = ["forward_dynamics", "energy", "prepare", "forward_dynamics_prepared"]
    assert re.findall(r"pendulum_(\w+)\(", text) == functions
    assert not re.search(r"\b[gm]\b =", text)


def test_it_is_clean_and_passes_its_test(folder: Path, tmp_path: Path) -> None:
    compiler = find_compiler()
    if compiler is None:
        pytest.skip("no C compiler here")
    program = tmp_path / "selftest"
    sources = [str(folder / "pendulum.c"), str(folder / "pendulum_selftest.c")]
    subprocess.run([compiler, *STRICT, *sources, "-o", str(program), "-lm"], check=True)
    done = subprocess.run([str(program)], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (0, "pendulum: 0 failures\n")


def test_a_model_that_is_not_fixed_says_nothing(tmp_path: Path) -> None:
    write_c(compile(derive(elastic_pendulum.scene())), tmp_path, name="pendulum")
    assert "Fixed" not in (tmp_path / "pendulum.h").read_text(encoding="utf-8")
    content = json.loads((tmp_path / "manifest.json").read_text(encoding="utf-8"))
    assert content["fixed"] == {} and "reactions" in content["arrays"]

"""`mechanics fmu`: a unit that FMPy's own command accepts, and one line for every mistake."""

import math
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import casadi
import pytest
from fmpy import read_model_description

from mechanics.compiled import Model
from mechanics.compiled.proof import prove_graph
from mechanics.export.fmu import proof, unit
from mechanics.kernel import Finding

pytestmark = pytest.mark.campaign


def test_a_unit_is_written_and_fmpy_accepts_it(run: Any, tmp_path: Path) -> None:
    path = tmp_path / "rocker.fmu"
    ran = run("fmu", "rocker", "-o", path, "--set", "theta=0.25", "--set", "mu=0.4",
              "--set", "rho=1000", "--fix", "g=9.81", "--step", "0.01")  # fmt: skip
    assert ran.code == 0, ran.err
    assert ran.out.endswith(f"{path}\n")
    assert len(re.findall("= graph: (?:PROVED|CERTIFIED)\n", ran.out)) == 4
    command = [sys.executable, "-m", "fmpy", "validate", str(path)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (0, "No problems found.\n")
    start = {v.name: v.start for v in read_model_description(str(path)).modelVariables}
    assert [float(start[name]) for name in ("theta", "mu", "step_size")] == [0.25, 0.4, 0.01]
    # The mass is rho h (pi R^2 + 2 R R), with R = 0.1 m and h = 0.02 m; g is a number for good.
    assert float(start["M"]) == pytest.approx(1000 * 0.02 * (math.pi + 2) * 0.1**2, rel=1e-12)
    assert "g" not in start


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ("--set phi=1", "there is no 'phi' to set"),
        ("--set theta=2", "the motion starts outside of the domain"),
        ("--fix phi=1", "--fix (fixed=) 'phi': rocker has no such parameter"),
        ("--step=-1", "step: -1.0 found: a positive number of seconds is needed"),
        ("--route none", "route 'none': the routes are"),
    ],
)
def test_mistakes_are_one_line(run: Any, tmp_path: Path, options: str, words: str) -> None:
    ran = run("fmu", "rocker", "-o", tmp_path / "rocker.fmu", *options.split())
    assert ran.code == 2
    assert words in ran.err and ran.err.count("\n") == 1
    assert not (tmp_path / "rocker.fmu").exists()


def test_another_suffix_is_refused(run: Any, tmp_path: Path) -> None:
    ran = run("fmu", "rocker", "-o", tmp_path / "rocker.zip")
    assert ran.code == 2 and "a file NAME.fmu in a folder that exists is needed" in ran.err


def test_what_is_refuted_is_one_line_and_no_file(
    run: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    printed = unit.model_source
    monkeypatch.setattr(unit, "model_source", lambda *given: printed(*given).replace(" + ", " - "))
    ran = run("fmu", "rocker", "-o", tmp_path / "rocker.fmu", "--step", "0.01")
    assert ran.code == 1 and not ran.out
    assert ran.err.startswith("error: REFUTED model.c: rocker_") and ran.err.count("\n") == 1
    assert ran.err.endswith("rocker.fmu is not written\n")
    assert not list(tmp_path.iterdir())


def test_a_graph_that_is_not_what_was_derived_is_no_unit(
    run: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def of_other_parameters(model: Model, names: list[str]) -> tuple[Finding, ...]:
        given = model.casadi.exact("energy")[0]
        q, u, inputs, p, constants = given.sx_in()
        other = given(q, u, inputs, 2 * p, constants)
        names = ["q", "u", "inputs", "p", "constants"]
        graph = casadi.Function(
            "energy", [q, u, inputs, p, constants], other, names, given.name_out()
        )
        return (prove_graph("energy", model.casadi, graph),)

    monkeypatch.setattr(proof, "prove_compiled", of_other_parameters)
    ran = run("fmu", "rocker", "-o", tmp_path / "rocker.fmu", "--step", "0.01")
    assert ran.code == 1 and not ran.out
    assert ran.err.startswith("error: REFUTED compiled energy") and ran.err.count("\n") == 1
    assert not list(tmp_path.iterdir())

"""`--fix` and `--outputs`: what they write, and one line for every mistake."""

import json
from pathlib import Path
from typing import Any

import pytest


@pytest.mark.campaign
def test_codegen_writes_what_is_asked_for(run: Any, tmp_path: Path) -> None:
    ran = run("codegen", "elastic_pendulum", "-o", str(tmp_path / "c"), "--fix", "g=9.81",
              "--fix", "m=0", "--outputs", "forward_dynamics, energy")  # fmt: skip
    assert ran.code == 0, ran.err
    content = json.loads((tmp_path / "c" / "manifest.json").read_text(encoding="utf-8"))
    assert content["fixed"] == {"g": "981/100", "m": "0"}
    parts = ["prepare", "forward_dynamics_prepared"]
    assert list(content["functions"]) == ["forward_dynamics", "energy", *parts]


def test_derive_prints_the_fixed_equations(run: Any) -> None:
    free = run("derive", "elastic_pendulum", "--route", "kane")
    fixed = run("derive", "elastic_pendulum", "--route", "kane", "--fix", "g=9.81", "--fix", "m=0")
    assert free.code == fixed.code == 0
    assert "981*L*M*sin(theta)/200" in fixed.out and "*g*" not in fixed.out
    assert "M + m" in free.out and "M + m" not in fixed.out


ROWS = [
    ("--fix g", "--fix 'g': write name=value"),
    ("--fix g=1 --fix g=2", "g is given twice"),
    ("--fix g=heavy", "--fix 'g=heavy': 'heavy' is no number"),
    ("--fix z=1", "--fix (fixed=) 'z': pendulum on elastic support has no such parameter"),
    ("--fix M=-1", "--fix (fixed=) M: -1 is negative"),
    ("--fix M=0", "the equations do not determine the accelerations"),
]


@pytest.mark.parametrize(("options", "words"), ROWS)
@pytest.mark.parametrize("command", ["derive", "codegen"])
def test_mistakes_are_one_line(
    run: Any, tmp_path: Path, command: str, options: str, words: str
) -> None:
    where = ["-o", str(tmp_path / "c")] if command == "codegen" else []
    ran = run(command, "elastic_pendulum", *where, *options.split())
    assert ran.code == 2
    assert words in ran.err and ran.err.count("\n") == 1
    assert not (tmp_path / "c").exists()


def test_an_unknown_output_is_one_line(run: Any, tmp_path: Path) -> None:
    ran = run("codegen", "rocker", "-o", str(tmp_path / "c"), "--outputs", "energy,speed")
    assert ran.code == 2
    assert "function 'speed'" in ran.err and ran.err.count("\n") == 1

"""`mechanics reduce`: what it prints, writes and refuses; what `mechanics verify` says of it."""

import json
import re
from pathlib import Path
from typing import Any

import pytest

OVER = ("--over", "theta in [-1/5, 1/5]", "--over", "theta_dot in [-1, 1]",
        "--over", "x in [-0.1, 0.1]")  # fmt: skip


@pytest.mark.campaign
def test_what_is_written_is_verified_and_a_changed_record_is_seen(run: Any, tmp_path: Path) -> None:
    folder = tmp_path / "c"
    ran = run("reduce", "elastic_pendulum", "--error", "0.05", *OVER, "-o", folder)
    assert ran.code == 0, ran.err
    assert "elastic_pendulum_reduced_domain(" in (folder / "elastic_pendulum_reduced.h").read_text()
    ran = run("verify", folder)
    assert ran.code == 0, ran.out
    assert "whole model = reduced model within its bound: 2 PROVED" in ran.out
    file = folder / "reduction.json"
    file.write_text(file.read_text().replace('"error": "1/20"', '"error": "1/21"'))
    assert run("verify", folder).code == 3
    manifest = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
    (folder / "manifest.json").write_text(json.dumps(manifest | {"system": None}))
    ran = run("verify", folder, "--no-compile")
    assert ran.code == 3 and "give --scene FILE" in ran.out and "from its scene" in ran.out


def test_the_command_prints_what_is_left_out(run: Any, tmp_path: Path) -> None:
    ran = run("reduce", "elastic_pendulum", "--error", "0.05", *OVER,
              "--json", tmp_path / "r.json")  # fmt: skip
    assert ran.code == 0, ran.err
    assert "7 operations instead of 17" in ran.out and "sin(theta) = theta" in ran.out
    assert "PROVED" in ran.out
    assert re.search("^    theta_ddot = ", ran.out, re.MULTILINE)
    assert "parameters as numbers: L = 1, M = 1, g = 981/100" in ran.out
    told = json.loads((tmp_path / "r.json").read_text(encoding="utf-8"))
    assert told["finding"]["verdict"] == "PROVED" and told["operations"]["after"] == 7


def test_the_command_refuses_in_one_line(run: Any) -> None:
    ran = run("reduce", "elastic_pendulum", "--error", "0.05")
    assert ran.code == 2 and ran.err.count("\n") == 1
    assert "theta, theta_dot, x" in ran.err


def test_bodies_without_mass_are_refused(run: Any) -> None:
    """Without masses there is nothing to divide by."""
    ran = run(
        "reduce", "elastic_pendulum", "--error", "0.05", *OVER, "--set", "M=0", "--set", "m=0"
    )
    assert ran.code == 2 and ran.err.count("\n") == 1


@pytest.mark.parametrize("value", ["x", "x=", "=1", "x=a"])
def test_values_are_read_or_refused(run: Any, value: str) -> None:
    ran = run("reduce", "elastic_pendulum", "--error", "0.05", "--set", value)
    assert ran.code == 2 and ran.err.count("\n") == 1, ran.err


@pytest.mark.campaign
def test_a_box_with_a_singular_state_is_told(run: Any) -> None:
    """The disc lies flat within the box."""
    speeds = [
        word for name in ("u1", "u2", "u3", "yaw") for word in ("--over", f"{name} in [-1, 1]")
    ]
    ran = run("reduce", "rolling_disc", "--error", "0.1", "--over", "lean in [-1.7, 1.7]",
              *speeds, "--boxes", "16")  # fmt: skip
    assert ran.code in (0, 3), ran.err
    assert "may be unbounded in the box" in ran.out

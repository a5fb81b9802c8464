"""`mechanics compare`: the table, the JSON, the exit code."""

import json
from typing import Any

import pytest

from mechanics.compare import installed


def test_an_engine_beside_a_system(run: Any) -> None:
    ran = run("compare", "rod_pendulum", "--against", "sympy", "--states", 3)
    assert ran.code == 0, ran.err
    assert "mass_matrix" in ran.out and "agree at 3 states" in ran.out


def test_engines_that_do_not_take_a_system_are_told(run: Any) -> None:
    ran = run("compare", "rod_pendulum", "--states", 2)
    assert ran.code == 0, ran.err
    assert "and sympy" in ran.out
    if "pinocchio" in installed():
        assert "not compared: rod pendulum: engines take a tree" in ran.err


def test_json(run: Any) -> None:
    ran = run("compare", "rod_pendulum", "--against", "sympy", "--states", 3, "--json", "-")
    (found,) = json.loads(ran.out)
    assert found["agree"] and found["scene"] and found["against"].startswith("sympy")
    assert {row["quantity"] for row in found["quantities"]} >= {"mass_matrix", "bias"}
    assert {row["verdict"] for row in found["quantities"]} == {"SUPPORTED"}


def test_an_engine_that_is_not_here_is_refused_in_one_line(run: Any) -> None:
    absent = [name for name in ("drake", "pybullet", "mujoco") if name not in installed()]
    if not absent:
        pytest.skip("every engine is installed")
    ran = run("compare", "rod_pendulum", "--against", absent[0])
    assert ran.code == 2 and "is not installed: pip install" in ran.err
    assert ran.err.count("\n") == 1

"""The benchmark of mechanisms in space: scenes that agree, and figures as JSON."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from benchmarks.space import scenes
from benchmarks.space.deriving import derivation

ROOT = Path(__file__).resolve().parents[2]


def test_all_pairs_of_routes_of_an_arm_are_decided() -> None:
    found = derivation(lambda: scenes.arm(3))
    verdicts = found["verdicts"]
    assert isinstance(verdicts, dict) and len(verdicts) == 6
    assert set(verdicts.values()) == {"CERTIFIED"}


@pytest.mark.campaign
def test_the_command_prints_json() -> None:
    command = [sys.executable, "-m", "benchmarks.space", "--only", "PUMA 560", "--json", "-"]
    ran = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    found = json.loads(ran.stdout)
    assert list(found["times"]) == ["PUMA 560"]
    assert found["growth"] is None
    assert {row["work"] for row in found["operations"]} >= {"M, pendulum_chain(10)"}

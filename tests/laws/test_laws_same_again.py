"""No clock, no hash seed and no earlier run decides a verdict, a witness or a repair."""

import json
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

import mechanics

pytestmark = pytest.mark.campaign

ROOT = Path(mechanics.__file__).parents[1]
PARTS = (
    "kernel",
    "program",
    "scene",
    "kinematics",
    "routes",
    "checks",
    "claims",
    "blame",
    "judge",
)
TIME = re.compile(r"^\s*(from|import) (time|datetime)\b", re.MULTILINE)
CLOCK = re.compile(r"mechanics\.clock|SystemRandom|urandom|import secrets")

RACING = """
import itertools, time
ticks = itertools.count()
time.monotonic = time.process_time = time.perf_counter = lambda: 1000.0 * next(ticks)
"""
ASKED = r"""
import json, sys
import mechanics
from systems import ALL

SYSTEMS = {system.name: system for system in ALL}
WRONG = {
    # Two factors, found in the third stage of the search.
    "elastic_pendulum": [
        r"M\frac{L}{2}\ddot{x}\cos\theta + M\frac{L^2}{12}\ddot\theta"
        r" - M g\frac{L}{2}\sin\theta = 0",
        "(M + m)*x'' + 3*k*x + M*L/2*(theta''*cos(theta) + theta'^2*sin(theta)) = 0",
    ],
    "cartpole": ["theta'' = (g*sin(theta) + abs(F)*cos(theta))/l", "T = sqrt((mc*x'^2)^2)/2"],
    "four_bar": ["V = 0"],
}
found = {}
for name, texts in WRONG.items():
    truth = mechanics.derive(SYSTEMS[name].scene(), "free_body")
    for text in texts:
        found[text] = mechanics.check_json(mechanics.check(truth, text))
result = mechanics.crosscheck(SYSTEMS["rocker"], mechanics.CrossCheck(states=9))
(told,) = mechanics.to_json([result])["systems"]
for route in told["routes"].values():
    del route["seconds"]
json.dump([found, told], sys.stdout)
"""


WRITTEN = r"""
import hashlib, json, pathlib, sys, tempfile
import mechanics
from benchmarks.space import scenes
from mechanics.checks.statements import equal
from mechanics.checks.agreement import compare_pairs, linear_system
from mechanics.compiled.c.source import function_source
from mechanics.export import write_c
from mechanics.mechanism import lower
from mechanics.program import Builder
from mechanics.program.casadi_printer import print_function
from mechanics.program.casadi_reader import read_routine
from mechanics.program.residues import Residues
from mechanics.recursions import newton_euler
from mechanics.recursions.pseudo_inertia import moments
from mechanics.routes import free_body, kane
from systems import rocker

model = mechanics.compile(mechanics.derive(rocker.scene(), "free_body"))
with tempfile.TemporaryDirectory() as folder:
    files = write_c(model, folder, name="rocker", measure=False)
    told = {f.name: hashlib.sha256(f.read_bytes()).hexdigest() for f in files}
mechanism = lower(scenes.panda(), Builder())
rows = newton_euler.rows(mechanism, moments(mechanism))
arrays = {"x": sorted(mechanism.builder.inputs)}
program = mechanism.builder.program({"tau": rows})
text = function_source(read_routine(print_function(program, "inverse_dynamics", arrays)), arrays)
filter_ = Residues(mechanism.builder)
systems = {
    r.route: linear_system(mechanism, r, filter_)
    for r in (route.derive(mechanism) for route in (free_body, kane))
}
shown = [str(finding) for finding in compare_pairs(systems).values()]
wrong = equal("a sign", mechanism, rows, [rows[0], -rows[1], *rows[2:]])
json.dump([told, text, shown, f"{wrong} {wrong.witness}"], sys.stdout)
"""


def asked(seed: int, before: str = "", script: str = ASKED) -> str:
    """What a process of its own says."""
    places = os.pathsep.join([str(ROOT), os.environ.get("PYTHONPATH", "")])
    return subprocess.run(
        [sys.executable, "-c", before + script],
        capture_output=True, text=True, check=True, cwd="/",
        env={**os.environ, "PYTHONHASHSEED": str(seed), "PYTHONPATH": places},
    ).stdout  # fmt: skip


@pytest.fixture(scope="module")
def said() -> str:
    return asked(1)


def test_what_is_asked_has_witnesses_and_repairs(said: str) -> None:
    statements = [s for found in json.loads(said)[0].values() for s in found["statements"]]
    refuted = [s for s in statements if s["verdict"] == "REFUTED"]
    assert len(refuted) >= 5
    assert all(s["witness"] for s in refuted)
    assert sum(len(s["blame"]["repairs"]) > 0 for s in refuted) >= 3


def test_another_hash_seed_and_a_clock_that_runs_fast_change_nothing(said: str) -> None:
    assert asked(2, RACING) == said


def test_c_text_and_verdicts_of_an_arm_are_the_same_under_load_and_another_hash_seed() -> None:
    # Each is a load for the other.
    with ThreadPoolExecutor() as pool:
        first, second = pool.map(lambda seed: asked(seed, script=WRITTEN), (1, 2))
    assert second == first
    told, text, shown, wrong = json.loads(first)
    assert len(told) > 8 and "sin(" in text
    assert len(shown) == 1 and "CERTIFIED" in shown[0] and "Witness(" in wrong


@pytest.mark.parametrize("part", PARTS)
def test_nothing_that_decides_reads_a_clock_or_draws_from_the_system(part: str) -> None:
    files = sorted((ROOT / "mechanics" / part).rglob("*.py"))
    assert files
    assert [str(file) for file in files if CLOCK.search(file.read_text())] == []


def test_clocks_are_read_to_measure_and_to_end_what_takes_too_long() -> None:
    files = sorted((ROOT / "mechanics").rglob("*.py"))
    found = {file.name for file in files if TIME.search(file.read_text())}
    assert found == {"clock.py", "worker.py"}

"""A second run, under another hash seed, makes the same findings with the same witnesses."""

import ast
import os
import subprocess
import sys
from pathlib import Path

import pytest

import mechanics.kernel
from mechanics.kernel import canaries
from mechanics.kernel.decide import check_canaries, decide

FOLDER = Path(mechanics.kernel.__file__).parent

SCRIPT = """
from fractions import Fraction
from mechanics.kernel import Range, Statement, decide
from mechanics.program import Builder

b = Builder()
x, y, z, a = (b.input(n) for n in "xyza")
sides = [
    ((x + y / 2 - z).sin() * a.sqrt(), x.sin() * a.sqrt()),
    ((a * (x * x + 1)).sqrt() / a.sqrt(), (x * x + 1).sqrt()),
    (abs(x - y) + b.less(x, y).choose(x, y), y + z.log() * 0 + abs(x - y)),
    ((x * y).power(Fraction(1, 3)).power(3), x * y),
    (b.solve([[x, y], [z, a]], [a, x])[1] * (x * a - y * z), x * x - a * z),
    ((b.pi / 5 + x).cos() * 4, (1 + b.constant(5).sqrt()) * x.cos()),
]
for left, right in sides:
    for proof in (True, False):
        program = b.program({"left": [left], "right": [right], "terms": [left, x + y]})
        print(decide(Statement("s", program, {"a": Range.POSITIVE}), try_normal=proof))
"""


def findings(seed: str) -> str:
    run = subprocess.run(
        [sys.executable, "-c", SCRIPT], env={**os.environ, "PYTHONHASHSEED": seed},
        capture_output=True, text=True, check=True, cwd=FOLDER.parents[1],
    )  # fmt: skip
    return run.stdout


def test_findings_do_not_depend_on_the_hash_seed() -> None:
    first = findings("1")
    assert first == findings("2")
    assert first.count("Finding(") == 12
    assert {name for name in ("PROVED", "CERTIFIED", "REFUTED") if name in first} == {
        "PROVED", "CERTIFIED", "REFUTED",
    }  # fmt: skip


@pytest.mark.parametrize("path", sorted(FOLDER.glob("*.py")), ids=lambda p: p.stem)
def test_the_kernel_knows_no_clock_and_no_chance_of_its_own(path: Path) -> None:
    imported = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            imported |= {alias.name for alias in node.names}
        if isinstance(node, ast.ImportFrom):
            imported.add(node.module or "")
    own = {name for name in imported if name.startswith("mechanics")}
    assert own <= {
        name
        for name in own
        if name.startswith(("mechanics.kernel", "mechanics.program", "mechanics.errors"))
    }
    assert not imported & {"random", "time", "datetime", "secrets", "os", "uuid", "sympy", "numpy"}


def test_a_kernel_that_decides_what_is_known_wrongly_says_so(monkeypatch) -> None:
    true = next(statement for statement, shown in canaries.canaries() if shown)
    monkeypatch.setattr(sys.modules["mechanics.kernel.decide"], "canaries", lambda: [(true, False)])
    check_canaries.cache_clear()
    with pytest.raises(AssertionError, match="the kernel is broken"):
        decide(true)
    monkeypatch.undo()
    check_canaries.cache_clear()
    assert decide(true).shown

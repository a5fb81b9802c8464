"""`mechanics codegen`: precision, many states, names, and one line for every mistake."""

import sys
from pathlib import Path
from typing import Any

import pytest

pytestmark = pytest.mark.campaign


def written(ran: Any) -> set[str]:
    assert ran.code == 0, ran.err
    return {Path(line).name for line in ran.out.splitlines()}


def test_precision_name_and_batch_choose_the_files(run: Any, tmp_path: Path) -> None:
    ran = run("codegen", "rocker", "-o", tmp_path / "a", "--outputs", "energy", "--name", "swing")
    double = written(ran)
    assert double >= {"swing.c", "swing.h", "swing_batch.c", "swing_loader.py", "swing.pc.in"}
    assert not any("single" in name for name in double)
    single = written(run("codegen", "rocker", "-o", tmp_path / "b", "--outputs", "energy",
                         "--precision", "single", "--no-batch", "--name", "swing"))  # fmt: skip
    assert single >= {"swing_single.c", "swing_single.h", "swing_single_selftest.c"}
    assert not any("batch" in name for name in single) and "swing.c" not in single


def test_a_folder_with_a_space_can_be_written_twice(run: Any, tmp_path: Path) -> None:
    folder = tmp_path / "with a space" / "c"
    first = written(run("codegen", "rocker", "-o", folder, "--outputs", "energy"))
    second = written(run("codegen", "rocker", "-o", folder, "--outputs", "energy", "--no-batch"))
    assert second < first == second | {path for path in first if "batch" in path or "vec" in path
                                       or "sine" in path}  # fmt: skip
    assert {path.name for path in folder.iterdir()} == second


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ("--name int", "name 'int' is no C identifier that is free: 'int_system' would be one"),
        ("--name math", "name 'math' hides a header"),
        ("--precision half", "precision 'half': there are double, single, both"),
    ],
)
def test_mistakes_are_one_line(run: Any, tmp_path: Path, options: str, words: str) -> None:
    ran = run("codegen", "rocker", "-o", tmp_path / "c", *options.split())
    assert ran.code == 2
    assert words in ran.err and ran.err.count("\n") == 1
    assert not (tmp_path / "c").exists()


def test_a_folder_of_somebody_else_is_one_line(run: Any, tmp_path: Path) -> None:
    (tmp_path / "CMakeLists.txt").write_text("mine", encoding="utf-8")
    ran = run("codegen", "rocker", "-o", tmp_path)
    assert ran.code == 2
    assert "was not generated" in ran.err and ran.err.count("\n") == 1
    assert (tmp_path / "CMakeLists.txt").read_text(encoding="utf-8") == "mine"


def test_what_is_refuted_is_one_line_and_no_folder(
    run: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    module = sys.modules["mechanics.export.implementation"]
    printed = module.implementation
    monkeypatch.setattr(module, "implementation", lambda *given: printed(*given).replace("+", "-"))
    ran = run("codegen", "rocker", "-o", tmp_path / "c", "--outputs", "energy", "--no-batch")
    assert ran.code == 1 and not ran.out
    assert ran.err.startswith("error: REFUTED rocker.c: rocker_energy = graph: kinetic[0]")
    assert ran.err.endswith("c is not written\n") and ran.err.count("\n") == 1
    assert not list(tmp_path.iterdir())


def test_decimals_that_are_folded_into_other_constants_are_shown(run: Any, tmp_path: Path) -> None:
    """-1/2 times 9.81 is no constant of the exact graph, and -4.905 not its own value either."""
    words = ("--fix", "g=9.81", "--outputs", "jacobians", "--no-batch")
    assert run("codegen", "elastic_pendulum", *words, "-o", tmp_path / "out").code == 0

"""`codegen --form`: the form is told, can be forced, and is refused in one line."""

import json
from pathlib import Path
from typing import Any

import pytest


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("options", "form"), [((), "fewest"), (("--form", "recursive"), "recursive")], ids=str
)
def test_the_manifest_tells_the_form(run: Any, tmp_path: Path, options: Any, form: str) -> None:
    ran = run("codegen", "elastic_pendulum", "-o", str(tmp_path / "c"), "--no-batch",
              "--outputs", "forward_dynamics", *options)  # fmt: skip
    assert ran.code == 0, ran.err
    content = json.loads((tmp_path / "c" / "manifest.json").read_text(encoding="utf-8"))
    assert content["form"] == form


@pytest.mark.sample(1)
@pytest.mark.parametrize(
    ("system", "form", "words"),
    [
        ("four_bar", "recursive", "the bodies are no tree, for closure along x"),
        ("rolling_disc", "recursive", "the bodies are no tree, for no slip along x"),
        ("rocker", "sparse", "nothing constrains the coordinates"),
        ("rocker", "quick", "the forms are auto, elimination, primitive"),
    ],
)
def test_a_form_that_cannot_be_is_one_line(
    run: Any, tmp_path: Path, system: str, form: str, words: str
) -> None:
    ran = run("codegen", system, "-o", str(tmp_path / "c"), "--form", form)
    assert ran.code == 2
    (line,) = ran.err.strip().splitlines()
    assert f"form '{form}'" in line and words in line
    assert not (tmp_path / "c").exists()

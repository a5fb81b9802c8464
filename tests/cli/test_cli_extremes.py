"""`mechanics extremes`: what it prints and writes, and what it refuses."""

import json
from pathlib import Path
from typing import Any

import pytest

from mechanics.cli.load import load
from mechanics.compiled import compile
from mechanics.crosscheck import derive
from mechanics.extremes import point, reproduce
from systems import VARIANTS


@pytest.mark.campaign
def test_extremes_of_a_file_are_printed_written_and_reproduced(
    run: Any, pendulum: Any, tmp_path: Path
) -> None:
    file, page, record = pendulum(), tmp_path / "map.html", tmp_path / "map.json"
    ran = run("extremes", file, "--form", "elimination", "--report", page, "--json", record)
    assert ran.code == 0, ran.err
    assert "my_pendulum" in ran.out and "elimination" in ran.out and "backward" in ran.out
    for name in ("theta rad", "theta_dot rad/s", "m", "l", "g"):
        assert name in ran.out
    assert page.read_text(encoding="utf-8").startswith("<!DOCTYPE html>")
    (found,) = json.loads(record.read_text(encoding="utf-8"))["systems"]
    model = compile(derive(load(str(file)).scene(), "kane"), form="elimination")
    figures = next(f for f in found["walks"][2]["figures"] if f["form"] == "elimination")
    for index in (0, len(figures["cause"]) // 2, len(figures["cause"]) - 1):
        anew = reproduce(model, point(found, 2, index), figures["precision"])
        assert anew == {key: figures[key][index] for key in anew}


@pytest.mark.campaign
def test_json_goes_to_the_screen_alone(run: Any, pendulum: Any) -> None:
    ran = run("extremes", pendulum(), "--form", "elimination", "--json", "-")
    assert ran.code == 0
    (found,) = json.loads(ran.out)["systems"]
    assert found["system"] == "my_pendulum" and "elimination" in found["forms"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("nothing",), "system 'nothing' is not known"),
        (("rocker", "--form", "bogus"), "form 'bogus': the forms are auto, elimination"),
        (("rocker", "--route", "bogus"), "route 'bogus'"),
        (("rocker", "--report", "{tmp}"), "it is a folder"),
        (("rocker", "--json", "{tmp}/no/a.json"), "there is no folder"),
        (("rocker", "--form", "sparse"), "nothing constrains the coordinates"),
    ],
)
def test_bad_requests_are_one_line(run: Any, tmp_path: Path, arguments, words: str) -> None:
    ran = run("extremes", *(a.replace("{tmp}", str(tmp_path)) for a in arguments))
    assert ran.code == 2
    assert words in ran.err and len(ran.err.strip().splitlines()) == 1


@pytest.mark.parametrize("system", VARIANTS, ids=lambda system: system.name)
def test_variants_are_systems_that_can_be_named(run: Any, system: Any) -> None:
    ran = run("derive", system.name, "--route", "kane", "--format", "text")
    assert ran.code == 0 and ran.out

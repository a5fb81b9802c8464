"""`mechanics trade` and `mechanics simulate --accuracy`: what they print and write, and refuse."""

import json
from pathlib import Path
from typing import Any

import pytest


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("trade")


@pytest.mark.campaign
def test_trade_prints_and_writes_everything(run: Any, folder: Path) -> None:
    ran = run("trade", "two_mass_chain", "--horizon", "1", "--target", "1e-7", "--set", "x1=0.5",
              "--report", folder / "t.html", "--json", folder / "t.json",
              "--plot", folder / "t.svg")  # fmt: skip
    assert ran.code == 0, ran.err
    assert "for 1e-03" not in ran.out
    for words in ("for 1e-07 over 1 s", "they share", "small errors grow",
                  "x1: exact at any amplitude", "as declared"):  # fmt: skip
        assert words in ran.out
    record = json.loads((folder / "t.json").read_text(encoding="utf-8"))
    assert record["start"]["x1"] == 0.5
    assert [pick["target"] for pick in record["recommendations"]] == [1e-7]
    assert (folder / "t.html").read_text(encoding="utf-8").startswith("<!DOCTYPE html>")
    assert (folder / "t.svg").read_text(encoding="utf-8").startswith("<svg")


@pytest.mark.campaign
def test_simulate_chooses_for_an_accuracy(run: Any, folder: Path) -> None:
    ran = run("simulate", "elastic_pendulum", "--duration", "1", "--samples", "11",
              "--accuracy", "1e-6", "--out", folder / "m.csv")  # fmt: skip
    assert ran.code == 0, ran.err
    assert "error estimate" in ran.out
    assert len((folder / "m.csv").read_text(encoding="utf-8").splitlines()) == 12


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("trade", "elastic_pendulum", "--horizon", "0"), "horizon: 0.0 found"),
        (("trade", "elastic_pendulum", "--target", "3"), "target: 3.0 found"),
        (("trade", "elastic_pendulum", "--set", "y=3"), "there is no 'y' to set"),
        (("trade", "elastic_pendulum", "--report", "t.txt"), "the suffix .txt is not supported"),
        (("trade", "elastic_pendulum", "--plot", "t.png"), "the suffix .png is not supported"),
        (("trade", "elastic_pendulum", "--json", "no/such/t.json"), "there is no folder"),
        (("trade", "elastic_pendulum", "--route", "by foot"), "route 'by foot'"),
        (("trade", "pendulums"), "system 'pendulums' is not known"),
        (
            ("simulate", "elastic_pendulum", "--accuracy", "0", "--out", "m.csv"),
            "accuracy: 0.0 found",
        ),
    ],
)
def test_mistakes_are_one_line(run: Any, arguments: tuple[str, ...], words: str) -> None:
    ran = run(*arguments)
    assert ran.code == 2
    assert words in " ".join(ran.err.split())
    assert "Traceback" not in ran.err

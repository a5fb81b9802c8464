"""The record of all verdicts, counts, folders and reports: what is said today is what it says.

A difference that is meant is explained in the commit that writes the record anew with
``python -m benchmarks.record write benchmarks/record.json``.
"""

import json
import sys
from pathlib import Path

import pytest

from benchmarks import record
from benchmarks.record import Record, difference
from mechanics.scene.system import System
from systems import ALL, SEED

FILE = Path(record.__file__).with_name("record.json")
FAST = {"verdicts": ("crosscheck", "finding", "published", "residual", "route"),
        "operations": ("operations",)}  # fmt: skip


FIRST = [SEED[0], *(pytest.param(system, marks=pytest.mark.campaign) for system in SEED[1:])]


def recorded() -> Record:
    found: Record = json.loads(FILE.read_text())
    return found


def part(of: str, said: dict[str, str]) -> dict[str, str]:
    """The entries of one part of the record."""
    return {what: words for what, words in said.items() if what.split()[0] in FAST[of]}


def drawn(what: str) -> bool:
    """Whether an entry is of the sample of the detection campaign."""
    return what.startswith("case ")


CASES = {
    name: cases
    for name, said in recorded().items()
    if (cases := {what: words for what, words in said.items() if drawn(what)})
}


@pytest.mark.campaign
@pytest.mark.parametrize("of", FAST)
@pytest.mark.parametrize("system", FIRST, ids=lambda system: system.name)
def test_what_is_said_of_the_first_systems_is_what_is_recorded(system, of: str) -> None:
    before = {system.name: part(of, recorded()[system.name])}
    assert len(before[system.name]) > 30
    assert difference(before, record.record([system], [of])) == []


@pytest.mark.campaign
@pytest.mark.sample(0)
@pytest.mark.parametrize("system", ALL, ids=lambda system: system.name)
def test_all_that_is_said_of_a_system_is_what_is_recorded(system: System) -> None:
    said = recorded()[system.name]
    before = {system.name: {what: words for what, words in said.items() if not drawn(what)}}
    assert difference(before, record.record([system], record.PARTS)) == []


@pytest.mark.campaign
@pytest.mark.sample(0)
@pytest.mark.parametrize("name", sorted(CASES))
def test_verdicts_of_the_detection_campaign_are_what_is_recorded(name: str) -> None:
    assert difference({name: CASES[name]}, {name: record.campaign(cases_of(name))[name]}) == []


def cases_of(name: str) -> list[str]:
    """The cases of the detection campaign that are about a system."""
    return [what.split()[1] for what in CASES[name]]


def test_every_case_of_the_detection_campaign_is_recorded() -> None:
    assert sorted(case for name in CASES for case in cases_of(name)) == sorted(record.CASES)


def test_the_record_holds_every_system_and_stays_small() -> None:
    assert set(recorded()) == {system.name for system in ALL}
    assert len(FILE.read_text()) < 300_000


def test_differences_are_told_one_a_line() -> None:
    before = {"rocker": {"a": "PROVED", "b": "1", "c": "2"}}
    now = {"rocker": {"a": "CERTIFIED 2^-80", "b": "1"}, "acrobot": {"d": "3"}}
    assert difference(before, now) == [
        "acrobot | d | - | 3", "rocker | a | PROVED | CERTIFIED 2^-80", "rocker | c | 2 | -",
    ]  # fmt: skip


def test_comparing_prints_what_differs_and_fails(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    file, told = tmp_path / "record.json", {"rocker": {"crosscheck": "ok"}}
    monkeypatch.setattr(record, "everything", lambda: told)
    monkeypatch.setattr(sys, "argv", ["record", "write", str(file)])
    record.main()
    told = {"rocker": {"crosscheck": "not ok"}}
    monkeypatch.setattr(sys, "argv", ["record", "compare", str(file)])
    with pytest.raises(SystemExit) as ended:
        record.main()
    assert ended.value.code == 1
    assert capsys.readouterr().out == "rocker | crosscheck | ok | not ok\n1 differences\n"

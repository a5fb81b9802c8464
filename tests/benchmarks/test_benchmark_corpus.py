"""The corpus of statements as their authors typed them: its form, and no false verdict."""

import re
import tomllib

import pytest

from benchmarks.corpus.__main__ import false, figures
from benchmarks.corpus.load import HERE, SUFFIXES, Case, cases, scene_of
from benchmarks.corpus.trial import plain, tried

CASES = list(cases())
QUICK = ("taylor_pendulum/tension", "taylor_pendulum/factor", "landau_5/lagrangian")


def test_cases_have_their_form() -> None:
    assert len(CASES) >= 977
    assert len({case.source for case in CASES}) >= 370
    assert len({case.name for case in CASES}) == len(CASES)
    for case in CASES:
        assert case.input in SUFFIXES, case.name
        if not case.right:
            assert case.written != case.mended, case.name
            lines = case.written.split("\n")
            whole = plain(case.written) in plain(case.text)
            assert whole or all(plain(line) in plain(case.text) for line in lines), case.name


def test_cases_name_a_source_that_can_be_looked_up() -> None:
    for path in sorted((HERE / "cases").glob("*.toml")):
        document = tomllib.loads(path.read_text(encoding="utf-8"))
        source = f"{document['source']} {document.get('url', '')}".lower()
        assert document["source"].strip(), path.name
        assert not re.search(r"found by|code search|(author|source) not named", source), path.name


@pytest.mark.campaign
def test_scenes_of_cases_exist() -> None:
    for case in CASES:
        assert scene_of(case.scene, case.function).q, case.name


@pytest.mark.parametrize("name", QUICK)
def test_a_case_has_its_verdict(name: str) -> None:
    (case,) = (case for case in CASES if case.name == name)
    trial = tried(case)
    assert trial.verdict in (("PROVED", "CERTIFIED") if case.right else ("REFUTED",))
    assert case.right or trial.named == 1
    assert next(iter(figures([trial], [])))


@pytest.mark.campaign
@pytest.mark.every_case
@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_no_verdict_is_false(case: Case) -> None:
    trial = tried(case, blame=False)
    assert not false(trial), trial.words

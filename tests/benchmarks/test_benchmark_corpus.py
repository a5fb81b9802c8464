"""The corpus of statements as their authors typed them: its form, and no false verdict."""

from typing import Any

import pytest

from benchmarks.corpus.__main__ import false, figures
from benchmarks.corpus.load import SUFFIXES, Case, cases, scene_of
from benchmarks.corpus.trial import plain, tried

CASES = list(cases())
QUICK = ("taylor_pendulum/tension", "taylor_pendulum/factor", "landau_5/lagrangian")


def test_cases_have_their_form() -> None:
    assert len(CASES) >= 968
    assert len({case.source for case in CASES}) >= 369
    assert len({case.name for case in CASES}) == len(CASES)
    for case in CASES:
        assert case.input in SUFFIXES, case.name
        if not case.right:
            assert case.written != case.mended, case.name
            lines = case.written.split("\n")
            whole = plain(case.written) in plain(case.text)
            assert whole or all(plain(line) in plain(case.text) for line in lines), case.name


@pytest.mark.campaign
def test_scenes_of_cases_exist() -> None:
    for case in CASES:
        assert scene_of(case.scene, case.function).q, case.name


KNOWN = {
    "rhs_hamilton/Rhs_double_pendulum, mended": "momenta among the states are taken for speeds",
    "wip_env/dynamics": "numbers inside of a function are not said to be the parameters",
}


@pytest.mark.parametrize("name", QUICK)
def test_a_case_has_its_verdict(name: str) -> None:
    (case,) = (case for case in CASES if case.name == name)
    trial = tried(case)
    assert trial.verdict in (("PROVED", "CERTIFIED") if case.right else ("REFUTED",))
    assert case.right or trial.named == 1
    assert next(iter(figures([trial], [])))


def marked(case: Case) -> Any:
    """A case; of a false verdict that is known the reason, until it is mended."""
    why = KNOWN.get(case.name)
    marks = [pytest.mark.xfail(strict=True, reason=why)] if why else []
    return pytest.param(case, id=case.name, marks=marks)


@pytest.mark.campaign
@pytest.mark.every_case
@pytest.mark.parametrize("case", [marked(case) for case in CASES])
def test_no_verdict_is_false(case: Case) -> None:
    trial = tried(case)
    assert not false(trial), trial.words

"""Faults: the table fits the text, and a sample of them is noticed."""

from collections import Counter

import pytest

from benchmarks.faults.__main__ import Trial, campaign, summary
from benchmarks.faults.fault import Fault, planted
from benchmarks.faults.scenes import SEED
from benchmarks.faults.table import FAULTS

SAMPLE = (
    "each step of a rotation is taken backwards",
    "q' = -u",
    "every declared scalar counts twice",
    "programs: gravity does not know the mass",
    "SymPy: forces have the wrong sign",
    "programs, free_body: reactions have no moment",
    "a rod about its end",
    "a side is compared with itself",
)


@pytest.mark.sample(3)
@pytest.mark.parametrize("fault", FAULTS, ids=lambda fault: fault.what)
def test_each_fault_is_a_change_of_one_function(fault: Fault) -> None:
    function, code = planted(fault)
    assert code.co_qualname == function.__qualname__
    assert code.co_freevars == function.__code__.co_freevars
    parts = ("co_code", "co_consts", "co_names")
    assert any(getattr(code, part) != getattr(function.__code__, part) for part in parts)


def test_there_are_enough_and_each_has_a_name() -> None:
    assert len(FAULTS) >= 80
    assert {count for count in Counter(fault.what for fault in FAULTS).values()} == {1}


@pytest.mark.parametrize("old", ("no such text", "return", "from itertools import pairwise"))
def test_a_row_whose_text_has_changed_says_so(old: str) -> None:
    fault = Fault("mechanics.scene.geometry", old, "pass", "a row out of date")
    with pytest.raises(
        LookupError, match=r"^fault 'a row out of date': '.*(drop the row|change one)$"
    ):
        planted(fault)


@pytest.mark.campaign
def test_a_sample_is_noticed_in_the_systems_of_the_seed() -> None:
    faults = [fault for fault in FAULTS if fault.what in SAMPLE]
    assert len(faults) == len(SAMPLE)
    trials = list(campaign(faults, SEED))
    assert [trial.fault for trial in trials] == faults
    for trial in trials:
        assert trial.noticed, trial
        assert not trial.unnoticed, trial
    assert summary(trials).startswith(
        "8 faults, of which 8 change a number; noticed wherever they do: 8 of 8"
    )


def test_the_summary_names_what_nobody_notices() -> None:
    one, two, three = FAULTS[:3]
    words = summary(
        (
            Trial(one, ("rocker",), (), (), "free_body: virtual power: REFUTED"),
            Trial(two, ("rocker",), ("arm",), (), "SceneError: no"),
            Trial(three, (), (), ("rocker",), ""),
        )
    )
    assert "noticed wherever they do: 1 of 2; by scene: 2 of 3" in words
    assert f"Unnoticed:\n- {two.what}: arm" in words
    assert f"No number changes:\n- {three.what}" in words

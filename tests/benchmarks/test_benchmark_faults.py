"""Faults: the table fits the text, and a sample of them is noticed."""

from collections import Counter
from importlib import import_module
from inspect import getsource

import pytest

from benchmarks.faults.__main__ import campaign, clean_runs
from benchmarks.faults.fault import Fault, planted
from benchmarks.faults.plan import LEAST, Plan, plans, stride
from benchmarks.faults.scenes import GROUPS, OWN, SCENES
from benchmarks.faults.summary import Trial, scenes_table, summary
from benchmarks.faults.table import FAULTS
from mechanics.crosscheck import CrossCheck, crosscheck
from systems import EVERY, SEED

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


@pytest.mark.sample(2)
@pytest.mark.parametrize("fault", FAULTS, ids=lambda fault: fault.what)
def test_each_fault_is_a_change_of_one_function(fault: Fault) -> None:
    function, code = planted(fault)
    assert code.co_qualname == function.__qualname__
    assert code.co_freevars == function.__code__.co_freevars
    parts = ("co_code", "co_consts", "co_names")
    assert any(getattr(code, part) != getattr(function.__code__, part) for part in parts)


def test_every_row_stands_once_in_its_module() -> None:
    counts = {f.what: getsource(import_module(f.module)).count(f.old) for f in FAULTS}
    assert {what: count for what, count in counts.items() if count != 1} == {}


def test_every_shipped_system_has_faults() -> None:
    assert GROUPS["shipped"] == tuple(system.name for system in EVERY)
    assert set(GROUPS["shipped"]) <= set(SCENES)


def test_a_budget_takes_every_kth_fault_and_never_too_few() -> None:
    assert stride(100, 1, 100) == 1
    assert stride(100, 3, 100) == 3
    assert stride(100, 10**9, 1) == 100 // LEAST
    assert stride(0, 10, 1) == stride(3, 10, 1) == 1
    faults = FAULTS[:16]
    places = {f: f"{c.co_filename}:{c.co_qualname}" for f in faults
              for c in [planted(f)[0].__code__]}  # fmt: skip
    entry = {"calls": [*places.values()], "count": 10}
    made = plans(faults, {"bicycle": entry, "arm": entry, "rocker": entry}, 80)
    assert [len(plan.reached) for plan in made] == [16, 16, 16]
    assert made[1].planted == faults
    assert made[0].planted == faults[0::2]
    assert made[2].planted == faults[0::2]
    assert plans(faults, {"arm": {"calls": [], "count": 1}}, 1)[0].planted == ()


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
@pytest.mark.parametrize("name", OWN)
def test_without_a_fault_everything_is_shown(name: str) -> None:
    assert crosscheck(SCENES[name](), CrossCheck(states=0)).open == ()


@pytest.mark.campaign
def test_a_sample_is_noticed_in_the_systems_of_the_seed() -> None:
    faults = [fault for fault in FAULTS if fault.what in SAMPLE]
    assert len(faults) == len(SAMPLE)
    clean = clean_runs([system.name for system in SEED])
    trials = list(campaign(faults, clean, plans(faults, clean, 10**12)))
    assert [trial.fault for trial in trials] == faults
    for trial in trials:
        assert trial.noticed, trial
        assert not trial.unnoticed, trial
    assert summary(trials).startswith(
        "8 faults, of which 8 change a number; noticed wherever they do: 8 of 8"
    )


def test_the_summary_names_what_nobody_notices() -> None:
    one, two, three, four, five = FAULTS[:5]
    trials = (
        Trial(one, ("rocker",), (), (), "free_body: virtual power: REFUTED"),
        Trial(two, ("rocker",), ("arm",), (), "SceneError: no"),
        Trial(three, (), (), ("rocker",), ""),
        Trial(four, (), (), (), ""),
        Trial(five, (), (), (), ""),
    )
    made = (
        Plan("rocker", 2_500_000, FAULTS[:4], (one, two, three)),
        Plan("arm", 10**7, (two,), (two,)),
    )
    words = summary(trials, made)
    assert "noticed wherever they do: 1 of 2; by scene: 2 of 3" in words
    assert f"Unnoticed:\n- {two.what}: arm" in words
    assert f"No number changes:\n- {three.what}\n" in words
    assert f"the budget leaves them out:\n- {four.what}\n" in words
    assert words.endswith(f"no scene calls their code:\n- {five.what}")
    rows = scenes_table(trials, made)
    assert "| rocker | 2.5 | 4 | 3 | 2 | 2 |" in rows
    assert "| arm | 10.0 | 1 | 1 | 1 | 0 |" in rows
    assert rows.endswith("more calls than the budget: rocker (1).")

"""Work and precision on published problems: what is measured, and the solutions it goes by."""

import numpy as np
import pytest

from benchmarks.work_precision import __main__ as command
from benchmarks.work_precision.measure import points, posed
from benchmarks.work_precision.methods import METHODS, OURS
from benchmarks.work_precision.problems import PROBLEMS, four_bars

BY_NAME = {problem.name: problem for problem in PROBLEMS}
RK8 = next(m for m in METHODS if m.name == "C RK8")


@pytest.mark.campaign
def test_digits_are_those_of_the_solution_and_grow_with_work() -> None:
    of = posed(BY_NAME["A01"])
    # A pendulum from level: theta'^2 / 2 = -9.81 sin theta, on a rod of 1 m.
    theta, rate = of.end
    assert rate**2 / 2 == pytest.approx(-9.81 * np.sin(theta), rel=1e-13)
    found = list(points(of, RK8))
    assert [p.evaluations for p in found] == sorted(p.evaluations for p in found)
    assert found[0].scd < 5 < 12 < max(p.scd for p in found)
    assert min(p.energy for p in found) < 1e-12


@pytest.mark.parametrize("name", ["A01 by x and y", "rigid body", "Henon-Heiles"])
@pytest.mark.campaign
def test_ours_agree_with_a_solution_of_many_digits(name: str) -> None:
    of = posed(BY_NAME[name])
    for member in OURS:
        if not member.suits(of.case.problem(), None):
            assert max(p.scd for p in points(of, member)) > 7, member.name


@pytest.mark.campaign
def test_stars_end_where_the_test_set_has_them() -> None:
    assert posed(BY_NAME["Pleiades"]).doubt.endswith("within 3e-15 of the published ones")


def test_four_bars_move_as_one_pendulum() -> None:
    """Energy of n + 1 bars that turn and n that move with their ends."""
    times = np.linspace(0, 10, 11)
    states = four_bars(times, 3)
    angle, rate = states[:, 0], states[:, 7]
    energy = (4 / 3 + 3) * rate**2 / 2 + 9.81 * (4 / 2 + 3) * np.sin(angle)
    assert np.ptp(energy) < 1e-10


@pytest.mark.campaign
def test_the_table_is_printed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.argv", ["work_precision", "A01", "--only", "C RK8"])
    command.main()
    lines = capsys.readouterr().out.splitlines()
    assert lines[1].startswith("**A01** (IFToMM): 10 s, 2 entries of the state")
    assert lines[3] == "| method | 1e-01 J | 1e-03 J | 1e-06 J | 1e-09 J | best |"
    assert lines[5].startswith("| C RK8 | ") and "-" not in lines[5].split(" | ")[1:5]

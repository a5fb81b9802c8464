"""The table of long runs: one row for each integrator that is installed, values by name."""

import pytest

from benchmarks import long_runs
from mechanics.simulate.integrators import INTEGRATORS, Setting


def test_every_integrator_has_a_setting() -> None:
    problem = long_runs.posed("two_mass_chain", {})
    names = [setting.integrator for setting in long_runs.settings(problem, 2.0)]
    assert names == [member.name for member in INTEGRATORS if not member.available()]


def test_the_table_is_printed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    chosen = [Setting("C RK4", step=0.02), Setting("heyoka Taylor", 2.0)]
    monkeypatch.setattr(long_runs, "settings", lambda problem, period, names, tolerance: chosen)
    arguments = "elastic_pendulum --set k=0 --set x_dot=0.1 --periods 40"
    monkeypatch.setattr("sys.argv", ["long_runs", *arguments.split()])
    long_runs.main()
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("elastic_pendulum: natural period")
    assert lines[2].split(" | ")[1:4] == ["setting", "periods", "energy"]
    assert "| C RK4 | h = 0.02 s | 40 | " in lines[4] and "P_x bounded" in lines[4]
    assert "heyoka" in lines[5] and ("is needed" in lines[5] or "not installed" in lines[5])

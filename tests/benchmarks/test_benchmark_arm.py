"""The benchmark of an arm in space: kernels that agree, and a word on what is not installed."""

import shutil

import pytest

from benchmarks.arm import __main__ as arm
from benchmarks.arm.programs import Q, U, forward, inverse
from mechanics.program import Builder
from mechanics.program.interpret import include
from mechanics.program.residues import Residues


def test_forward_dynamics_is_the_inverse_of_inverse_dynamics() -> None:
    b = Builder()
    found = include(b, inverse())["tau"]
    given = {name: b.input(name) for name in (*Q, *U)}
    given |= {f"tau{i}": node for i, node in enumerate(found, start=1)}
    accelerations = include(b, forward(), given)["ud"]
    values = Residues(b)
    for i, node in enumerate(accelerations, start=1):
        assert values.is_zero(node - b.input(f"u{i}'"))


@pytest.mark.campaign
@pytest.mark.skipif(shutil.which("gcc") is None, reason="needs gcc")
def test_what_is_not_installed_is_said(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    why = "Pinocchio is not installed: pip install pin"
    monkeypatch.setattr(arm, "no_pinocchio", lambda: why)
    monkeypatch.setattr("sys.argv", ["arm", "--rounds", "1"])
    arm.main()
    told = capsys.readouterr().out
    assert told.count("CasADi") == 2 and "rnea" not in told and why in told

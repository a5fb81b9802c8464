"""What a text says of an equilibrium, and of a momentum along an axis."""

from functools import cache

import pytest

import mechanics
from mechanics.equations import Equations
from mechanics.judge.check import derived
from systems import bead_on_hoop
from tests.notation_scenes import verdicts


@cache
def hoop() -> Equations:
    return derived(bead_on_hoop.scene())


def on_hoop(text: str) -> list[str]:
    found = mechanics.check(hoop(), text, blame=False)
    return [entry.finding.verdict.name for entry in found.judged]


@pytest.mark.parametrize(
    ("formula", "verdict"),
    [
        (r"\cos\theta_0 = g/(\omega^2 R)", "PROVED"),
        (r"\omega^2 R\cos\theta_e = g", "PROVED"),
        (r"\cos\theta_0 = 2g/(\omega^2 R)", "REFUTED"),
        (r"\sin\theta_0 = g/(\omega^2 R)", "REFUTED"),
        (r"\cos\theta_0 = \omega^2 R/g", "REFUTED"),
        (r"g\theta_0 = 0", "UNDECIDED"),
    ],
)
def test_equilibria(formula: str, verdict: str) -> None:
    assert on_hoop(f"There is an equilibrium at ${formula}$.") == [verdict]


def test_what_it_is_read_as() -> None:
    (entry,) = mechanics.check(hoop(), r"\cos\theta_0 = g/(\omega^2 R)", blame=False).judged
    assert "theta_0 is read as theta at an equilibrium" in entry.statement.notes


def test_a_momentum_is_along_the_axis_of_its_name() -> None:
    assert verdicts("pendulum", r"P_x = ml\dot\theta\cos\theta") == ["PROVED"]
    assert verdicts("pendulum", r"P_y = ml\dot\theta\cos\theta") == ["REFUTED"]
    assert verdicts("pendulum", r"P_x = -ml\dot\theta\cos\theta") == ["REFUTED"]

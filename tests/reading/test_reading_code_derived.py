"""Numbers that a file or an object computes from parameters are formulas in these."""

from pathlib import Path

import numpy as np
import pytest

from mechanics import check
from mechanics.cli.load import run_file
from mechanics.exact import Verdict
from systems.cartpole import scene

SCENE = scene()

LAW = """
    x, x_dot, theta, theta_dot = state
    s, c = math.sin(theta), math.cos(theta)
    temp = (force {sign} {o}polemass_length*theta_dot**2*s)/{o}total_mass
    thetaacc = ({o}g*s - c*temp)/({o}l*(4.0/3.0 - {o}mp*c**2/{o}total_mass))
    xacc = temp - {o}polemass_length*thetaacc*c/{o}total_mass
    return np.array([x_dot, xacc, theta_dot, thetaacc])
"""

HEAD = """
import math
import numpy as np
g, mc, mp, l = 9.8, 1.0, 0.1, 0.5
total_mass = mp + mc
polemass_length = mp*l
"""

CLASS = """
import math
import numpy as np

class CartPole:
    def __init__(self, mc=1.0, mp=0.1, l=0.5, g=9.8):
        self.mc, self.mp, self.l, self.g = mc, mp, l, g
        self.total_mass = self.mp + mc
        self.polemass_length = self.mp*self.l

    def step_rates(self, state, force):
        return self.rates(state, force)

    def rates(self, state, force):
{law}

step = CartPole().step_rates
"""


def _file(folder: Path, text: str) -> object:
    file = folder / "mine.py"
    file.write_text(text)
    return run_file(file)


def _indented(law: str) -> str:
    return "".join(f"    {line}\n" for line in law.splitlines())


@pytest.mark.parametrize(("sign", "verdict"), [("+", Verdict.PROVED), ("-", Verdict.REFUTED)])
def test_of_a_file_and_of_an_object(tmp_path: Path, sign: str, verdict: Verdict) -> None:
    plain = LAW.format(sign=sign, o="")
    file = _file(tmp_path, f"{HEAD}\ndef rates(state, force):{plain}")
    found = check(SCENE, file.rates, blame=False)  # type: ignore[attr-defined]
    assert found.verdict is verdict
    assert "total_mass = 1.1 (mc + mp)" in " ".join(found.remarks)
    inside = _indented(LAW.format(sign=sign, o="self."))
    file = _file(tmp_path, CLASS.format(law=inside))
    assert check(SCENE, file.step, blame=False).verdict is verdict  # type: ignore[attr-defined]


def test_of_the_function_around(tmp_path: Path) -> None:
    law = _indented(LAW.format(sign="+", o=""))
    text = f"{HEAD}def make(mc=2.0, mp=0.5, l=0.5):\n    total_mass = mc + mp\n"
    text += (
        f"    polemass_length = mp*l\n    def rates(state, force, mc=mc):\n{law}\n    return rates"
    )
    file = _file(tmp_path, text.replace(", mc=mc", "") + "\nrates = make()")
    assert check(SCENE, file.rates).verdict is not Verdict.REFUTED  # type: ignore[attr-defined]


def test_a_number_does_not_follow_an_argument(tmp_path: Path) -> None:
    text = f"{HEAD}\ndef rates(state, force, mc):{LAW.format(sign='+', o='')}"
    found = check(SCENE, _file(tmp_path, text).rates, blame=False)  # type: ignore[attr-defined]
    assert found.verdict is Verdict.REFUTED
    assert "total_mass = 1.1 of the code stays a number" in str(found)


@pytest.mark.parametrize(
    "again", ["total_mass = 1.15", "mp = 0.2", "total_mass *= 1.5", "mp, l = 0.05, 0.25"]
)
def test_what_is_assigned_twice_is_not_derived(tmp_path: Path, again: str) -> None:
    text = f"{HEAD}{again}\ndef rates(state, force):{LAW.format(sign='+', o='')}"
    found = check(SCENE, _file(tmp_path, text).rates, blame=False)  # type: ignore[attr-defined]
    assert found.verdict is Verdict.REFUTED


def test_numbers_under_other_names_are_told() -> None:
    gravity = 9.8

    def theta_ddot(theta, theta_dot, F, mc, mp, l):  # type: ignore[no-untyped-def]
        s, c = np.sin(theta), np.cos(theta)
        total = mc + mp
        temp = (F + mp * l * theta_dot**2 * s) / total
        return (gravity * s - c * temp) / (l * (4 / 3 - mp * c**2 / total))

    found = check(SCENE, theta_ddot, blame=False)
    assert found.verdict is Verdict.REFUTED
    assert "gravity = 9.8 of the code: numbers" in " ".join(found.remarks)
    named = check(SCENE, theta_ddot, names={"gravity": "g"}, blame=False)
    assert named.verdict is Verdict.PROVED

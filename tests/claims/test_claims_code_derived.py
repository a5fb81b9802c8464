"""Numbers that a file or an object computes from parameters are formulas in these."""

from pathlib import Path

import numpy as np
import pytest

from mechanics import check
from mechanics.cli.load import run_file
from mechanics.kernel import Verdict
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


MAKE = """
def make(mc=2.0, mp=0.5, l=0.5):
    total_mass, polemass_length = {total}, mp*l
    def rates(state, force):
{law}
    return rates
"""


@pytest.mark.parametrize(
    ("sign", "total", "verdict"),
    [("+", "mc + mp", Verdict.PROVED), ("-", "mc + mp", Verdict.REFUTED),
     ("+", "2.5", Verdict.REFUTED)],
)  # fmt: skip
def test_of_the_function_around(tmp_path: Path, sign: str, total: str, verdict: Verdict) -> None:
    make = MAKE.format(total=total, law=_indented(LAW.format(sign=sign, o="")))
    head = "import math\nimport numpy as np\ng = 9.8\n"
    file = _file(tmp_path, f"{head}{make}\nrates = make()")
    assert check(SCENE, file.rates, blame=False).verdict is verdict  # type: ignore[attr-defined]


def test_a_number_of_the_file_is_not_that_of_the_function_around(tmp_path: Path) -> None:
    make = MAKE.format(total="2.5", law=_indented(LAW.format(sign="+", o="")))
    file = _file(tmp_path, f"{HEAD}{make}\nrates = make()")
    assert check(SCENE, file.rates, blame=False).verdict is Verdict.REFUTED  # type: ignore[attr-defined]
    imported = HEAD.replace("g, mc", "from math import tau as total_mass\ng, mc")
    file = _file(tmp_path, f"{imported}\ndef rates(state, force):{LAW.format(sign='+', o='')}")
    assert check(SCENE, file.rates, blame=False).verdict is Verdict.REFUTED  # type: ignore[attr-defined]


def test_of_which_function_around_is_not_plain(tmp_path: Path) -> None:
    law = _indented(LAW.format(sign="+", o=""))
    both = "".join(MAKE.format(total=total, law=law) for total in ("mc + mp", "2.5"))
    head = "import math\nimport numpy as np\ng = 9.8\n"
    file = _file(tmp_path, f"{head}{both}\nrates = make()")
    found = check(SCENE, file.rates, blame=False)  # type: ignore[attr-defined]
    assert found.verdict is Verdict.REFUTED
    assert "total_mass = 2.5" in " ".join(r for r in found.remarks if "numbers;" in r)


def test_a_number_does_not_follow_an_argument(tmp_path: Path) -> None:
    text = f"{HEAD}\ndef rates(state, force, mc):{LAW.format(sign='+', o='')}"
    found = check(SCENE, _file(tmp_path, text).rates, blame=False)  # type: ignore[attr-defined]
    assert found.verdict is Verdict.REFUTED
    assert "total_mass = 1.1 of the code stays a number" in str(found)


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "again",
    [
        "total_mass = 1.15",
        "mp = 0.2",
        "total_mass *= 1.5",
        "mp, l = 0.05, 0.25",
        "total_mass = 1.1",
        "def total_mass():\n    pass\ntotal_mass = 1.1",
    ],
)
def test_what_is_assigned_twice_is_not_derived(tmp_path: Path, again: str) -> None:
    text = f"{HEAD}{again}\ndef rates(state, force):{LAW.format(sign='+', o='')}"
    found = check(SCENE, _file(tmp_path, text).rates, blame=False)  # type: ignore[attr-defined]
    assert found.verdict is Verdict.REFUTED


def test_what_is_defined_and_assigned_is_not_derived(tmp_path: Path) -> None:
    head = HEAD.replace("total_mass =", "def total_mass():\n    pass\ntotal_mass =")
    text = f"{head}\ndef rates(state, force):{LAW.format(sign='+', o='')}"
    found = check(SCENE, _file(tmp_path, text).rates, blame=False)  # type: ignore[attr-defined]
    assert found.verdict is Verdict.REFUTED


def test_what_another_method_assigns_is_not_derived(tmp_path: Path) -> None:
    text = CLASS.format(law=_indented(LAW.format(sign="+", o="self.")))
    loaded = "    def load(self):\n        self.total_mass = 1.1\n\n    def step_rates"
    found = check(SCENE, _file(tmp_path, text).step, blame=False)  # type: ignore[attr-defined]
    assert found.verdict is Verdict.PROVED
    file = _file(tmp_path, text.replace("    def step_rates", loaded))
    found = check(SCENE, file.step, blame=False)  # type: ignore[attr-defined]
    assert found.verdict is Verdict.REFUTED


def test_an_argument_of_another_method_is_no_number_of_the_file(tmp_path: Path) -> None:
    text = CLASS.format(law=_indented(LAW.format(sign="+", o="self.")))
    text = text.replace("        self.total_mass = self.mp + mc\n", "        self.load(0.1)\n")
    loaded = "    def load(self, mp):\n        self.total_mass = mp + mc\n\n    def step_rates"
    text = "mp, mc = 0.1, 1.0\n" + text.replace("    def step_rates", loaded)
    found = check(SCENE, _file(tmp_path, text).step, blame=False)  # type: ignore[attr-defined]
    assert found.verdict is Verdict.REFUTED
    assert "total_mass = 1.1 of the code: numbers" in " ".join(found.remarks)


@pytest.mark.campaign
def test_numbers_under_other_names_are_told() -> None:
    gravity = 9.8

    def theta_ddot(theta, theta_dot, F, mc, mp, l):  # type: ignore[no-untyped-def]
        s, c = np.sin(theta), np.cos(theta)
        total = mc + mp
        temp = (F + mp * l * theta_dot**2 * s) / total
        return (gravity * s - c * temp) / (l * (4 / 3 - mp * c**2 / total))

    found = check(SCENE, theta_ddot, blame=False)
    assert found.judged[0].finding.verdict is Verdict.REFUTED and not found.ok
    assert "gravity = 9.8 of the code: numbers" in " ".join(found.remarks)
    named = check(SCENE, theta_ddot, names={"gravity": "g"}, blame=False)
    assert named.verdict is Verdict.PROVED

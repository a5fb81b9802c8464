"""A number that code makes of what is passed by its name is two numbers by one name."""

import pytest

from mechanics import check
from mechanics.cli.load import run_file
from mechanics.errors import InputError
from mechanics.kernel import Verdict
from systems import rod_pendulum

SCENE = rod_pendulum.scene()
CLASS = """
import math
from dataclasses import dataclass

class Rod:
    def __init__(self, m=1.0, l=2.0, g=9.81, length=2.0, half_length=1.0, gravity=9.81):
        self.m, self.g = m, g
        {made}

    def rate(self, theta, u):
        return 3*self.g/(2*self.l)*math.sin(theta) + 3*u/(self.m*self.l**2)

rate = Rod().rate
"""
RECORD = """
import math
from dataclasses import dataclass

@dataclass{frozen}
class Rod:
    m: float = 1.0
    l: float = 2.0
    g: float = 9.81
    def __post_init__(self):
        {made}
    def rate(self, theta, u):
        return 3*self.g/(2*self.l)*math.sin(theta) + 3*u/(self.m*self.l**2)

rate = Rod().rate
"""
AROUND = """
import math
def make(m=1.0, l=2.0, g=9.81):
    {made}
    def rate(theta, u):
        return 3*g/(2*l)*math.sin(theta) + 3*u/(m*l**2)
    return rate

rate = make()
"""


def verdict(folder, text: str, **names: str) -> Verdict:
    file = folder / "mine.py"
    file.write_text(text)
    (judged,) = check(SCENE, run_file(file).rate, names=names or None, blame=False).judged
    return judged.finding.verdict


CHANGED = [
    CLASS.format(made="self.l = l/2"),
    CLASS.format(made="self.l = half_length"),
    CLASS.format(made="self.l = l\n        self.l *= 0.5"),
    RECORD.format(frozen="", made="self.l = self.l/2"),
    RECORD.format(frozen="(frozen=True)", made='object.__setattr__(self, "l", self.l/2)'),
    AROUND.format(made="l = l/2"),
]
KEPT = [
    CLASS.format(made="self.l = l"),
    CLASS.format(made="self.l = float(length)"),
    CLASS.format(made="self.l, self.g = length, gravity"),
    CLASS.format(made="mass_of_rod = m\n        self.l, self.m = l, mass_of_rod"),
    CLASS.format(made="self.l = 2*half_length"),
    RECORD.format(frozen="", made="self.l = float(self.l)"),
    AROUND.format(made="l = float(l)"),
]


@pytest.mark.parametrize("text", CHANGED)
def test_what_is_changed_has_to_be_said(tmp_path, text):
    with pytest.raises(InputError, match="not what is passed by that name"):
        verdict(tmp_path, text)


def test_a_name_that_is_said_is_the_scenes(tmp_path):
    assert verdict(tmp_path, CHANGED[0], l="l") is Verdict.PROVED


@pytest.mark.parametrize("text", KEPT)
def test_what_is_passed_by_its_name_is_read(tmp_path, text):
    assert verdict(tmp_path, text) is Verdict.PROVED


FILE = """
import math
P = {"m": 1.0}
m, l, g = P["m"], 2.0, 9.81
MADE
def rate(theta, u):
    return 3*g/(2*l)*math.sin(theta) + 3*u/(m*l**2)
"""


@pytest.mark.parametrize("made", ["l = l/2", "l *= 2", "if m: g = g*m"])
def test_so_is_one_that_a_file_makes_of_itself(tmp_path, made: str) -> None:
    with pytest.raises(InputError, match=f"{made.split()[-3]} is .* in the code, not what is"):
        verdict(tmp_path, FILE.replace("MADE", made))


@pytest.mark.parametrize("made", ["m = P['m']", "l = float(l)", "L = l; half = l/2"])
def test_a_file_may_give_it_another_name(tmp_path, made: str) -> None:
    assert verdict(tmp_path, FILE.replace("MADE", made)) is Verdict.PROVED

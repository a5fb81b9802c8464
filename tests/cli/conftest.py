"""The command line, run inside this process."""

import re
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest

from mechanics.cli import main

PENDULUM = """
from sympy import sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
from mechanics.scene import Particle, Scene, force, gravity, parameters, reaction
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion

theta = dynamicsymbols("theta")
m, l, g = parameters("m l g", typical="1 1 9.81")


def scene():
    N = ReferenceFrame("N")
    A = N.orientnew("A", "Axis", (theta, N.z))
    O = Point("O")
    C = O.locatenew("C", -l * A.y)
    return Scene(
        "simple pendulum", N, O, coordinates=(theta,), bodies=(Particle("bob", C, m),),
        loads=(gravity(-g * N.y), *LOADS),
        reactions=(reaction("S", at=C, on="bob", by=None, along=A.y),),
    )


LOADS = ()
PUBLISHED = (
    published(
        "(1)", EquationOfMotion(), l * theta.diff().diff() + g * sin(theta), 0, label="swing"
    ),
)
"""


@dataclass(frozen=True)
class Ran:
    """Exit code and what was written; `place` is where an error is, which comes after it."""

    code: int
    out: str
    err: str
    place: str = ""


PLACE = re.compile(r"(?: *--> .+\n *\|\n)? *\d* \| .*\n *\| *\^+\n\Z", re.MULTILINE)


Run = Callable[..., Ran]


@pytest.fixture
def run(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Run:
    """Run the console command with arguments."""

    def command(*arguments: object) -> Ran:
        monkeypatch.setattr(sys, "argv", ["mechanics", *map(str, arguments)])
        with pytest.raises(SystemExit) as stopped:
            main()
        written = capsys.readouterr()
        place = PLACE.search(written.err)
        err = written.err[: place.start()] if place else written.err
        return Ran(int(stopped.value.code or 0), written.out, err, place[0] if place else "")

    return command


@pytest.fixture
def pendulum(tmp_path: Path) -> Callable[..., Path]:
    """A file with a simple pendulum, its text changed by (old, new) pairs."""

    def write(*changes: tuple[str, str]) -> Path:
        text = PENDULUM
        for old, new in changes:
            assert old in text
            text = text.replace(old, new)
        path = tmp_path / "my_pendulum.py"
        path.write_text(text, encoding="utf-8")
        return path

    return write

"""A comment of code that gives a unit which no scene has leaves it open."""

from pathlib import Path

import pytest

import mechanics
from systems import rod_pendulum

SCENE = rod_pendulum.scene()
CODE = {
    ".c": "// {}\ndouble acc(double theta, double u, double m, double l, double g)\n"
    "{{ return 3*g/(2*l)*sin(theta) + 3*u/(m*l*l); }} // {}\n",
    ".m": "% {}\nfunction a = acc(theta, u, m, l, g)\n"
    "a = 3*g/(2*l)*sin(theta) + 3*u/(m*l^2); % {}\nend\n",
    ".jl": "# {}\nfunction acc(theta, u, m, l, g)\n"
    "  return 3g/(2l)*sin(theta) + 3u/(m*l^2) # {}\nend\n",
}


def _verdict(folder: Path, suffix: str, above: str, behind: str) -> str:
    file = folder / f"mine{suffix}"
    file.write_text(CODE[suffix].format(above, behind))
    return mechanics.check(SCENE, file, blame=False).verdict.name


@pytest.mark.parametrize("suffix", CODE)
@pytest.mark.parametrize(
    "unit", ["deg/s^2", "rev/min^2", "[1/min]", "cm/s^2", "unit: deg/s^2", "mrad/s^2", "cm", "rpm"]
)
def test_a_unit_that_no_scene_has_leaves_code_open(tmp_path: Path, suffix: str, unit: str) -> None:
    assert _verdict(tmp_path, suffix, unit, "") == "UNDECIDED"
    assert _verdict(tmp_path, suffix, "", unit) == "UNDECIDED"


@pytest.mark.parametrize("suffix", CODE)
@pytest.mark.parametrize(
    "unit",
    [
        "rad/s^2",
        "m/s^2",
        "[1/s]",
        "N*m",
        "SI units",
        "kg m/s",
        "in/out arrays",
        "in:",
        "ms",
        "the ratio m/h",
    ],
)
def test_a_unit_of_the_si_does_not(tmp_path: Path, suffix: str, unit: str) -> None:
    assert _verdict(tmp_path, suffix, unit, unit) == "PROVED"

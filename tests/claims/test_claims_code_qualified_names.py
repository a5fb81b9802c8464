"""The name of a function says which acceleration or energy it returns."""

from pathlib import Path

import pytest

from mechanics import check
from mechanics.errors import InputError
from mechanics.grading.submission import things_in
from systems import rod_pendulum

ALPHA = """import numpy as np
def {}(theta, u, m, l, g):
    return 3*g/(2*l)*np.sin(theta) + 3*u/(m*l**2)
"""
ENERGY = """import numpy as np
def {}(theta, omega, m, l, g):
    return m*l**2*omega**2/6 + m*g*l/2*np.cos(theta)
"""
C = """#include <math.h>
double {}(double theta, double u, double m, double l, double g) {{
    return 3*g/(2*l)*sin(theta) + 3*u/(m*l*l);
}}
"""
OTHERS = (
    "alpha_deg thdd_rev tip_acceleration tipAccel jerk minus_alpha half_alpha alpha_per_torque"
    " angular_deceleration rpm_per_second"
)
OTHER_ENERGIES = (
    "energy_per_mass twice_energy mean_energy kinetic_energy_of_centre energy_above_pivot"
)


def _answer(text: str, suffix: str, folder: Path) -> tuple[str, tuple[str, ...]]:
    path = folder / f"mine{suffix}"
    path.write_text(text)
    found = check(rod_pendulum.scene(), things_in(path, run_python=True), blame=False)
    return found.verdict.name, tuple(found.unjudged)


@pytest.mark.parametrize("name", OTHERS.split())
def test_another_acceleration_is_open(name: str, tmp_path: Path) -> None:
    assert _answer(ALPHA.format(name), ".py", tmp_path)[0] == "UNDECIDED"
    assert _answer(C.format(name), ".c", tmp_path)[0] == "UNDECIDED"


@pytest.mark.parametrize("name", OTHER_ENERGIES.split())
def test_another_energy_is_open(name: str, tmp_path: Path) -> None:
    assert _answer(ENERGY.format(name), ".py", tmp_path)[0] == "UNDECIDED"


@pytest.mark.parametrize(
    "name",
    [
        "alpha",
        "f",
        "rhs",
        "rod_accel",
        "angularAcceleration",
        "get_theta_ddot",
        "accel_from_torque",
    ],
)
def test_what_the_scene_has_is_shown(name: str, tmp_path: Path) -> None:
    assert _answer(ALPHA.format(name), ".py", tmp_path) == ("PROVED", ())


def test_a_word_that_nothing_knows_is_quoted(tmp_path: Path) -> None:
    verdict, unjudged = _answer(ALPHA.format("crane_acceleration"), ".py", tmp_path)
    assert verdict == "PROVED"
    assert unjudged == ("the word crane in the name crane_acceleration",)


@pytest.mark.parametrize("name", ["lhalf", "lcom", "lcg"])
def test_a_part_of_a_length_is_not_the_length(name: str, tmp_path: Path) -> None:
    text = ALPHA.replace(", l, g)", f", {name}, g)").replace("*l)", f"*{name})")
    with pytest.raises(InputError, match=f"argument {name}"):
        _answer(text.replace("l**2", f"{name}**2").format("alpha"), ".py", tmp_path)


@pytest.mark.parametrize("name", ["u_force", "friction", "current", "uvolt"])
def test_another_drive_is_not_the_torque(name: str, tmp_path: Path) -> None:
    text = ALPHA.replace("theta, u,", f"theta, {name},").replace("3*u", f"3*{name}")
    with pytest.raises(InputError, match=f"argument {name}"):
        _answer(text.format("alpha"), ".py", tmp_path)

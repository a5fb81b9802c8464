"""A unit beside a name is that of the scene, or leaves the page open."""

import pytest

from mechanics import check
from mechanics.claims.foreign_units import ANGLES, FORCES, LENGTHS, MASSES, RATES, TORQUES
from mechanics.claims.scaled_names import another_quantity
from systems import rod_pendulum

NAMES = [
    (name, unit)
    for name, units in ((r"\theta", ANGLES), ("l", LENGTHS), ("m", MASSES), ("u", TORQUES))
    for unit in units
]
ROD = r"$$\ddot\theta = \frac{3g}{2l}\sin\theta + \frac{3}{ml^2}u$$"
OWN = [
    "$l$ [m]", r"$\theta$ is measured in radians.", "$m$ (kg)",
    "$g$ is the acceleration in ms$^{-2}$.", "All angles are measured in radians.",
    "$l$ is measured in metres.", "$u$ is measured in newton metres.",
    r"Here $\theta$ is the angle of the rod, $m$, $l$ and $g$ are constants.",
    "where $l$ is in metres, $m$ in kilograms,", "Let $l$ (m) be the length, gravity (g) is known.",
    "| $l$ | length | m |\n|---|---|---|\n| $m$ | mass | kg |\n",
    "$g$ is the acceleration of gravity in metres per second squared.",
    r"$x$ and $\theta$ are eliminated in turns.",
]  # fmt: skip
OTHERS = [
    r"$\theta$ is measured in metres.", "$l$ is measured in radians.", "$u$ is in newtons.",
    "$m$ is measured in newtons.", r"$\theta$ is measured in radians clockwise.",
    "$u$ is measured in newton millimetres.", r"$\theta$ is measured in radians per minute.",
    "$u$ is measured in newtons per metre.", r"$\theta$ [Deg]", "$l$ (MM)", r"$\theta$ (RPM)",
    "| $l$ | length | cm |\n|---|---|---|\n| $m$ | mass | kg |\n",
    "$l$ is the length of the rod (mm)",
    "$u$ is given in newtons per degree.", "$u$ is the torque [kg cm].", "$m$: mass, in tonnes",
    r"\begin{tabular}{ll} $\theta$ & angle in deg \\ $l$ & length in m \end{tabular}",
    "$l$ is the length in its rest position in kg.", "All angles are measured in metres.",
]  # fmt: skip


def _verdict(said: str) -> str:
    return check(rod_pendulum.scene(), f"{said}\n{ROD}", blame=False).verdict.name


@pytest.mark.sample(6)
@pytest.mark.parametrize(("name", "unit"), NAMES)
def test_what_no_scene_counts_in_leaves_it_open(name: str, unit: str) -> None:
    for words in (f"[{unit}]", f"is measured in {unit}.", f"is in {unit}"):
        assert _verdict(f"${name}$ {words}") == "UNDECIDED"


@pytest.mark.parametrize("unit", [*ANGLES, *LENGTHS, *FORCES, *TORQUES, *MASSES, *RATES])
def test_at_the_end_of_a_name(unit: str) -> None:
    assert another_quantity(f"theta_{unit}") == unit


@pytest.mark.parametrize("said", OWN)
def test_those_of_the_scene_do_not(said: str) -> None:
    assert _verdict(said) == "PROVED"


@pytest.mark.parametrize("said", OTHERS)
def test_one_of_another_quantity_does(said: str) -> None:
    assert _verdict(said) == "UNDECIDED"

"""A unit that no scene has leaves its page open, in words, in brackets, in a comment, in a name."""

from pathlib import Path

import pytest

from mechanics import check
from mechanics.claims.foreign_units import ANGLES, FORCES, LENGTHS, MASSES, TORQUES
from mechanics.claims.scaled_names import another_quantity
from systems import rod_pendulum

OF = {r"\theta": ANGLES, "l": LENGTHS, "m": MASSES, "u": TORQUES}
NAMES = [(name, unit) for name, units in OF.items() for unit in units]
ROD = r"$$\ddot\theta = \frac{3g}{2l}\sin\theta + \frac{3}{ml^2}u$$"
CODE = "acceleration(theta, omega, u, m, l, g) = 3g/(2l)*sin(theta) + 3u/(m*l^2)\n"


@pytest.mark.sample(6)
@pytest.mark.parametrize(("name", "unit"), NAMES)
def test_of_a_name(name: str, unit: str) -> None:
    sentences = [f"${name}$ [{unit}]"]
    sentences += [f"${name}$ is measured in {unit}."] if unit not in TORQUES else []
    for said in sentences:
        answer = check(rod_pendulum.scene(), f"{said}\n{ROD}", blame=False)
        assert answer.verdict.name == "UNDECIDED", said


@pytest.mark.sample(6)
@pytest.mark.parametrize("unit", [*ANGLES, *LENGTHS, *FORCES, *TORQUES, *MASSES])
def test_of_code(tmp_path: Path, unit: str) -> None:
    path = tmp_path / "rod.jl"
    path.write_text(f"# {unit}\n{CODE}")
    assert check(rod_pendulum.scene(), path, blame=False).verdict.name == "UNDECIDED"
    assert another_quantity(f"theta_{unit}") == unit


OWN = [
    "$l$ [m]", r"$\theta$ is measured in radians.", "$m$ (kg)",
    "All angles are measured in radians.", "$l$ is measured in metres.",
    "$u$ is measured in newton metres.",
]  # fmt: skip
OTHERS = [
    r"$\theta$ is measured in metres.", "$l$ is measured in radians.", "$u$ is in newtons.",
    "$m$ is measured in newtons.", r"$\theta$ is measured in radians clockwise.",
]  # fmt: skip


@pytest.mark.parametrize("said", OWN)
def test_those_of_the_scene_do_not(said: str) -> None:
    answer = check(rod_pendulum.scene(), f"{said}\n{ROD}", blame=False)
    assert answer.verdict.name == "PROVED"


@pytest.mark.parametrize("said", OTHERS)
def test_one_of_another_quantity_does(said: str) -> None:
    answer = check(rod_pendulum.scene(), f"{said}\n{ROD}", blame=False)
    assert answer.verdict.name == "UNDECIDED"

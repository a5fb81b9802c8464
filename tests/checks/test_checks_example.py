"""An example that contradicts a constraint is refused; one that is rounded or incomplete is not."""

import pytest
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics import (
    Particle,
    Scene,
    compile,
    derive,
    gravity,
    parameters,
    reaction,
    rope,
    simulate,
)
from mechanics.checks.admissible import check_scene
from mechanics.errors import SceneError
from systems import four_bar


def table(example: dict[str, float], inward: bool = True, length: str = "1.5") -> Scene:
    """A puck on a table, a rope through a hole, a weight below."""
    r, theta, z = dynamicsymbols("r theta z")
    m, M, l, g = parameters("m M l g", "kg kg m m/s^2", ["1", "2", length, "9.81"])
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (theta, N.z))
    P, Q = O.locatenew("P", r * A.x), O.locatenew("Q", -z * N.z)
    along = (-A.x if inward else A.x, -N.z)
    return Scene(
        "puck", N, O,
        coordinates=(r, theta, z),
        bodies=(Particle("puck", P, m), Particle("weight", Q, M)),
        loads=(gravity(-g * N.z),),
        joints=(rope("T", ("puck", P), (None, O), ("weight", Q), length=l, along=along),),
        reactions=(
            reaction("n", at=P, on="puck", by=None, along=N.z),
            reaction("gx", at=Q, on="weight", by=None, along=N.x),
            reaction("gy", at=Q, on="weight", by=None, along=N.y),
        ),
        example=example,
    )  # fmt: skip


def test_rope_whose_direction_is_reversed_contradicts_its_example() -> None:
    with pytest.raises(SceneError, match=r"constraint T_length.* it is -1, .*z = 2 satisfies it"):
        check_scene(table({"r": 0.5, "z": 1.0}, inward=False))


@pytest.mark.parametrize(
    ("example", "length"),
    [
        ({"r": 0.5, "z": 1.0}, "1.5"),
        ({"r": 0.5}, "1.5"),
        ({}, "1.5"),
        ({"r": 0.33, "z": 0.67}, "0.999"),
    ],
)
def test_example_that_is_rounded_or_incomplete_is_taken(
    example: dict[str, float], length: str
) -> None:
    assert check_scene(table(example, length=length)).constraints


def test_digits_that_were_written_decide() -> None:
    with pytest.raises(SceneError, match="T_length"):
        check_scene(table({"r": 0.333, "z": 0.6675}, length="0.999"))


def test_rough_example_of_a_loop_chooses_a_branch_and_the_change_is_told() -> None:
    motion = simulate(compile(derive(four_bar.scene())), 0.01, samples=2)
    assert "the example's q" in motion.branch
    assert motion.branch.endswith("does not satisfy the constraints")

"""The stiffness of a torsional spring is a torque."""

import pytest
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics import check
from mechanics.scene import RigidBody, Scene, parameters, pin, torsion_spring


def shaft() -> Scene:
    """A disc J on a shaft k that turns."""
    ground, origin, q = ReferenceFrame("N"), Point("O"), dynamicsymbols("q")
    J, k = parameters("J k", units="kg*m^2 N*m")
    joint = pin("axle", None, "disc", at=origin, axis=ground.z, angle=q)
    disc = RigidBody("disc", joint.point, joint.frame, 0, J)
    load = torsion_spring("shaft", q, ground.z, k, on="disc")
    return Scene(
        "shaft", ground, origin, plane=ground.z, joints=(joint,), bodies=(disc,), loads=(load,)
    )


@pytest.mark.parametrize(
    ("words", "verdict"),
    [
        ("on a torsional spring of stiffness $k$", "PROVED"),
        ("on a spring of stiffness $k$", "UNDECIDED"),
    ],
)
def test_a_spring_has_the_stiffness_that_the_scene_has(words: str, verdict: str) -> None:
    text = rf"A disc turns {words}: $$J\ddot q = -k q$$"
    assert check(shaft(), text, blame=False).verdict.name == verdict

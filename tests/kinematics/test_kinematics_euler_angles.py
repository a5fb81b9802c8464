"""Where Euler angles end, the message names the angles; where a mechanism does, it does not."""

import pytest
import sympy
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics import compile, derive, linearize, simulate
from mechanics.errors import SingularError
from mechanics.kinematics.euler_angles import singular_angles
from mechanics.scene import RigidBody, Scene, ball, euler, gravity, parameters
from mechanics.simulate.trajectory import Ending

N, O = ReferenceFrame("N"), Point("O")
m, g, l, A, C = parameters("m g l A C", typical="1 9.81 0.3 0.1 0.05")


def top(order: str) -> Scene:
    """A heavy body on a ball joint, which hangs at rest where the angles are zero."""
    turning = euler(order, *dynamicsymbols("a b c"))
    joint = ball("J", None, "top", at=O, frame=N, rotation=turning)
    body = RigidBody("top", O.locatenew("P", l * joint.frame.z), joint.frame, m,
                     inertia(joint.frame, A, A, C))  # fmt: skip
    return Scene("top", N, O, bodies=(body,), joints=(joint,), loads=(gravity(g * N.z),))


@pytest.mark.parametrize(
    ("order", "angle", "said"),
    [("zxz", 0.0, True), ("zxz", 3.1416, True), ("zxz", 1.5708, False),
     ("xyz", 1.5708, True), ("xyz", 0.0, False)],
)  # fmt: skip
def test_the_angles_are_singular_where_two_turn_about_one_line(
    order: str, angle: float, said: bool
) -> None:
    words = singular_angles(top(order), {"a": 0.3, "b": angle, "c": -1.0})
    assert words.startswith("the Euler angles a, b, c are singular at b = ") is said


ANGLES = "the Euler angles a, b, c are singular at b = 0, where a and c turn about one line"


def test_accelerations_name_the_angles_too() -> None:
    model = compile(derive(top("zxz"), "kane"), compiler=None, form="elimination")
    with pytest.raises(SingularError, match=f"^top: {ANGLES}"):
        model.forward_dynamics([0.1, 0, 0.2], [0, 0, 0])


def test_linear_equations_name_the_angles_too() -> None:
    equations = derive(top("zxz"), "kane")
    with pytest.raises(SingularError, match=f"at the operating point: {ANGLES}"):
        linearize(equations, {"a": 0, "b": 0, "c": 0})


def test_an_angle_that_is_no_number_is_not_blamed() -> None:
    angle = sympy.Symbol("theta0")
    assert not singular_angles(top("zxz"), {"a": 0, "b": angle, "c": 0})
    assert singular_angles(top("zxz"), {"a": angle, "b": sympy.pi}).endswith("order of axes")


@pytest.mark.campaign
def test_a_motion_that_ends_at_singular_angles_says_that_it_goes_on() -> None:
    model = compile(derive(top("zxz")))
    motion = simulate(model, 2.0, initial={"b": 0.5})
    assert motion.ending is Ending.SINGULAR
    assert "a and c turn about one line: the motion goes on, take a quaternion" in motion.reason
    with pytest.raises(SingularError, match=r"Euler angles a, b, c are singular at b = 0,"):
        simulate(model, 2.0, initial={"b": 0.0})

"""A unit quaternion as coordinates: what it brings to a scene, and what is refused."""

from dataclasses import replace

import pytest
from quaternions import ball_top, thrown_body
from sympy import Rational, eye, simplify
from sympy.physics.vector import ReferenceFrame, dynamicsymbols

from mechanics.errors import SceneError
from mechanics.scene import quaternion

turning = quaternion("e0 e1 e2 e3", "wx wy wz")


def test_the_matrix_is_a_rotation_also_off_the_unit_sphere() -> None:
    matrix = turning.matrix
    assert simplify(matrix * matrix.T) == eye(3)
    assert simplify(matrix.det()) == 1


def test_on_the_unit_sphere_the_frame_is_turned_as_sympy_turns_it() -> None:
    ground = ReferenceFrame("N")
    theirs = ground.orientnew("B", "Quaternion", turning.coordinates)
    unit = dict(
        zip(turning.coordinates, map(Rational, ["1/10", "-7/10", "1/2", "-1/2"]), strict=True)
    )
    assert ground.dcm(turning.orient("C", ground)).subs(unit) == ground.dcm(theirs).subs(unit)


def test_rates_and_speeds_are_inverse_and_leave_the_norm() -> None:
    t = dynamicsymbols._t
    rates = dict(zip((q.diff(t) for q in turning.coordinates), turning.rates, strict=True))
    for speed, definition in turning.definitions:
        assert simplify(definition.subs(rates) - speed) == 0
    assert simplify(turning.square.diff(t).subs(rates)) == 0


def test_a_scene_has_four_coordinates_and_three_speeds_of_it_once() -> None:
    scene = thrown_body()
    assert [s.name for s in scene.q] == ["x", "y", "z", "e0", "e1", "e2", "e3"]
    assert [s.name for s in scene.u] == ["x_dot", "y_dot", "z_dot", "wx", "wy", "wz"]
    assert [s.name for s in scene.ud[:3]] == ["x_ddot", "y_ddot", "z_ddot"]
    again = replace(scene, example={"e1": 1})
    assert (again.q, again.u) == (scene.q, scene.u)
    assert again.example == {"e1": 1}
    assert scene.example["e0"] == 1
    assert ball_top().example["e0"] == 0.95


@pytest.mark.parametrize(
    ("coordinates", "speeds", "words"),
    [
        ("e0 e1 e2", "wx wy wz", "3 coordinates"),
        ("e0 e1 e2 e3", "wx wy", "2 speeds"),
        ("e0 e1 e2 e3", "wx", "1 speeds"),
    ],
)
def test_too_few_names_are_refused(coordinates: str, speeds: str, words: str) -> None:
    with pytest.raises(SceneError, match=words) as caught:
        quaternion(coordinates, speeds)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"rotations": turning}, "rotations is"),
        ({"rotations": ("e0 e1 e2 e3",)}, "has to be a Rotation"),
        ({"rotations": (turning, quaternion("a b c d", "p q r"))}, "no body uses it"),
        (
            {"speeds": ((dynamicsymbols("s"), dynamicsymbols("e0").diff()),)},
            "less one a quaternion",
        ),
    ],
)
def test_wrong_rotations_are_refused(change: dict, words: str) -> None:
    with pytest.raises(SceneError, match=words) as caught:
        replace(ball_top(), **change)
    assert "\n" not in str(caught.value)

"""Outputs of a scene to first order: C and D by hand, and what has none."""

from dataclasses import replace

import numpy as np
import pytest
from sympy import Expr, Matrix, Rational, asin, pi, sqrt, zeros
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics import derive, linearize
from mechanics.errors import InputError
from mechanics.linear import close_loop
from mechanics.linear.form import Linear
from mechanics.scene import (
    RigidBody,
    Scene,
    ball,
    euler,
    force,
    gravity,
    orientation,
    parameters,
    pin,
    position,
    slide,
    velocity,
)

N, O = ReferenceFrame("N"), Point("O")
x, theta, F, w = dynamicsymbols("x theta F w")
M, m, L, g, A, C, Omega = parameters("M m L g A C Omega", typical="2 1 1/2 981/100 1/5 1/10 30")


def cart_pole() -> Scene:
    cart = slide("rail", None, "cart", at=O, axis=N.x, distance=x)
    pole = pin("hinge", "cart", "bob", at=cart.point, axis=N.z, angle=theta)
    tip = cart.point.locatenew("T", L * pole.frame.y)
    return Scene(
        "cart-pole", N, O, plane=N.z, joints=(cart, pole),
        bodies=(RigidBody("cart", cart.point, cart.frame, M, 0),
                RigidBody("bob", tip, pole.frame, m, 0)),
        loads=(gravity(-g * N.y), force("push", cart.point, F * N.x, on="cart")), inputs=(F,),
        outputs={"tip": position(tip), "turn": orientation(pole.frame),
                 "speed": velocity(tip, along=N.x)},
    )  # fmt: skip


def at_rest(scene: Scene, route: str = "kane") -> Linear:
    return linearize(derive(scene, route), {"x": 0, "theta": 0}, {"F": 0})


@pytest.mark.parametrize("route", ["kane", "moving_point"])
def test_outputs_of_a_cart_pole_are_those_by_hand(route: str) -> None:
    """x_T = x - L sin(theta), the rotation by theta about z, v = x' - L cos(theta) theta'."""
    linear = at_rest(cart_pole(), route)
    assert linear.outputs[:4] == ("tip_x", "tip_y", "tip_z", "turn_xx")
    assert linear.outputs[-2:] == ("turn_zz", "speed")
    expected = {"tip_x": (1, -L, 0, 0), "turn_xy": (0, -1, 0, 0), "turn_yx": (0, 1, 0, 0),
                "speed": (0, 0, 1, -L)}  # fmt: skip
    rows = [expected.get(name, (0, 0, 0, 0)) for name in linear.outputs]
    assert Matrix(rows) == linear.C
    assert zeros(len(rows), 1) == linear.D
    numbers, through = linear.output_space({"L": 2.0})
    assert np.array_equal(numbers, np.array(Matrix(rows).subs(L, 2), dtype=float))
    assert through.shape == (13, 1)


def test_without_outputs_the_states_are_the_outputs() -> None:
    linear = at_rest(replace(cart_pole(), outputs={}))
    assert linear.outputs == ("x", "theta", "x_dot", "theta_dot")
    assert Matrix.eye(4) == linear.C


def test_an_input_that_moves_what_is_observed_stands_in_D() -> None:
    """What a camera on a moved stand sees of the cart."""
    scene = cart_pole()
    cart = scene.joints[0].point
    stand = cart.locatenew("S", 2 * w * N.x + L * N.y)
    seen = replace(scene, inputs=(F, w), outputs={"seen": position(stand)})
    linear = linearize(derive(seen, "kane"), {"x": 0, "theta": 0}, {"F": 0, "w": 1})
    assert Matrix([[1, 0, 0, 0], [0] * 4, [0] * 4]) == linear.C
    assert Matrix([[0, 2], [0, 0], [0, 0]]) == linear.D
    rated = replace(seen, outputs={"seen": velocity(stand)})
    linear = linearize(derive(rated, "kane"), {"x": 0, "theta": 0}, {"F": 0, "w": 1})
    with pytest.raises(InputError, match="output seen_x changes with w_dot, the rate of an input"):
        _ = linear.D


@pytest.mark.parametrize(
    ("rod", "place", "angle"), [(5, 4, asin(Rational(3, 5))), (6, 3 * sqrt(3), pi / 6)]
)
def test_dependent_coordinates_are_eliminated(rod: int, place: Expr, angle: Expr) -> None:
    """A slider-crank with r = 3 at a right angle, where the rod does not turn: dx/dtheta = -r."""
    a, b, s = dynamicsymbols("a b s")
    crank = pin("main", None, "crank", at=O, axis=N.z, angle=a)
    guide = slide("guide", None, "piston", at=O, axis=N.x, distance=s)
    link = pin("gudgeon", "piston", "rod", at=guide.point, axis=-N.z, angle=b)
    throw = O.locatenew("P", 3 * crank.frame.x)
    big_end = pin("big_end", "crank", "rod", at=throw, axis=N.z,
                  onto=guide.point.locatenew("Q", -rod * link.frame.x))  # fmt: skip
    bodies = tuple(
        RigidBody(joint.child, joint.point, joint.frame, m, A) for joint in (crank, guide, link)
    )
    scene = Scene("slider-crank", N, O, plane=N.z, bodies=bodies,
                  joints=(crank, guide, link, big_end),
                  outputs={"piston": position(guide.point),
                           "speed": velocity(guide.point, along=N.x),
                           "crank": velocity(throw, along=N.x)})  # fmt: skip
    linear = linearize(derive(scene, "kane"), {"a": pi / 2, "s": place, "b": angle})
    (own,) = linear.coordinates
    slope = {"a": -3, "s": 1}[own.name]
    assert Matrix([[slope, 0], [0, 0], [0, 0], [0, slope], [0, slope]]) == linear.C


def top() -> Scene:
    """A top whose angles are regular where it stands upright."""
    a, b, c = dynamicsymbols("a b c")
    foot = ball("foot", None, "top", at=O, frame=N, rotation=euler("xyz", a, b, c))
    centre = O.locatenew("C", L * foot.frame.z)
    body = RigidBody("top", centre, foot.frame, m, inertia(foot.frame, A, A, C))
    return Scene("top", N, O, joints=(foot,), bodies=(body,), loads=(gravity(-g * N.z),),
                 outputs={"tip": position(centre),
                          "speed": velocity(centre, along=N.x)})  # fmt: skip


def test_outputs_about_a_steady_motion() -> None:
    """Of a sleeping top x = L b, y = -L a."""
    linear = linearize(derive(top(), "lagrange"), {"a": 0, "b": 0}, speeds={"c_dot": Omega})
    names = [symbol.name for symbol in linear.states]
    rows = [{"b": L}, {"a": -L}, {}, {"b_dot": L}]
    assert Matrix([[row.get(name, 0) for name in names] for row in rows]) == linear.C


def test_what_turns_with_a_steady_motion_drifts() -> None:
    scene = top()
    turning = replace(scene, outputs={"marker": orientation(scene.joints[0].frame)})
    linear = linearize(derive(turning, "lagrange"), {"a": 0, "b": 0}, speeds={"c_dot": Omega})
    assert linear.A.shape[0] == len(linear.states)
    with pytest.raises(InputError, match=r"^top: output marker_xx changes with c, which drifts"):
        _ = linear.C


def test_a_closed_loop_has_no_outputs_of_the_scene() -> None:
    closed = close_loop(at_rest(cart_pole()), {"F": -theta})
    with pytest.raises(InputError, match="these equations were changed: take the outputs of the"):
        closed.require_outputs()


@pytest.mark.campaign  # the package takes seconds to be imported
def test_to_control_has_the_outputs_of_the_scene() -> None:
    linear = at_rest(cart_pole())
    found = linear.to_control({"L": 2.0})
    place, through = linear.output_space({"L": 2.0})
    assert np.array_equal(found.C, place)
    assert np.array_equal(found.D, through)
    assert found.output_labels == list(linear.outputs)
    assert found.input_labels == ["F"]

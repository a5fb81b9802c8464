"""Friction that cannot be right is refused, in one line that names it."""

from typing import Any

import pytest
from sympy import Abs, Symbol, sign
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.checks.admissible import check_scene
from mechanics.errors import SceneError
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    condition,
    coulomb,
    gravity,
    holonomic,
    parameters,
    reaction,
    reaction_couple,
)
from mechanics.scene.actions import frictions

x, y = dynamicsymbols("x y")
m, g, mu, k, a = parameters("m g mu k a", units="kg m/s^2 1 N/m m")
N, O = ReferenceFrame("N"), Point("O")
C = O.locatenew("C", x * N.x)
R = Symbol("R", real=True)
PUSH = reaction("R", C, "block", None, N.y)
PRESSED = (condition("contact", R > 0, "lifts off"),)


def block(load: Any, **changes: Any) -> Scene:
    given: dict[str, Any] = {
        "coordinates": (x,),
        "bodies": (Particle("block", C, m),),
        "reactions": (PUSH,),
        "conditions": PRESSED,
    } | changes
    return Scene("block", N, O, loads=(gravity(-g * N.y), load), **given)


def rubs(**changes: Any) -> Any:
    given = {"normal": "R", "along": N.x, "sliding": x.diff(), "coefficient": mu} | changes
    return coulomb("f", **given)


def test_friction_is_a_load_that_depends_on_a_reaction() -> None:
    scene = block(rubs())
    assert [load.name for load in frictions(scene)] == ["f"]


def test_signs_of_a_pressing_reaction_are_known() -> None:
    scene = block(rubs())
    plain = scene.plain(Abs(R) * sign(R * x.diff()) + R)
    assert str(plain) == "R*sign(x_dot) + R"
    assert plain.free_symbols == {R, *scene.u}


REFUSED = {
    "no such reaction": (lambda: block(rubs(normal="S")), "load f no reaction 'S' R"),
    "a couple": (
        lambda: block(
            rubs(normal="Q"),
            bodies=(RigidBody("block", C, N, m, m * a**2),),
            reactions=(PUSH, reaction_couple("Q", "block", None, N.z)),
        ),
        "load f Q is a couple name a reaction",
    ),
    "no condition": (lambda: block(rubs(), conditions=()), "load f R presses condition(..., R > 0"),
    "another condition": (
        lambda: block(rubs(), conditions=(condition("c", R < 5, "breaks"),)),
        "load f R presses condition(..., R > 0",
    ),
    "negative": (lambda: block(rubs(coefficient=-mu)), "load f coefficient -mu negative"),
    "with a unit": (lambda: block(rubs(coefficient=k)), "load f, coefficient k unit not 1"),
    "no sliding": (
        lambda: block(rubs(sliding=x.diff() - x.diff())),
        "load f nothing slides there",
    ),
    "no unit vector": (lambda: block(rubs(along=2 * N.x)), "load f direction unit vector"),
    "an acceleration": (
        lambda: block(rubs(sliding=x.diff().diff())),
        "load f depends on the acceleration x_ddot",
    ),
    "no expression": (lambda: block(rubs(coefficient="mu")), "load f coefficient 'mu' a str"),
    "twice": (
        lambda: Scene(
            "block", N, O, (x,), (Particle("block", C, m),),
            (rubs(), coulomb("second", "R", N.x, x.diff(), mu)), (PUSH,), conditions=PRESSED,
        ),
        "load second reaction R is load f already sum of the coefficients",
    ),
    "constraints": (
        lambda: block(
            rubs(),
            coordinates=(x, y),
            bodies=(Particle("block", O.locatenew("C", x * N.x + y * N.y), m),),
            constraints=(holonomic("floor", y, "R"),),
        ),
        "load f has constraints with which friction is not derived",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_friction_that_cannot_be_right_is_refused(name: str) -> None:
    make, words = REFUSED[name]
    with pytest.raises(SceneError) as caught:
        make()
    message = str(caught.value)
    assert "\n" not in message
    assert [word for word in words.split() if word not in message] == []


SLIDES = {
    "wrong way": rubs(sliding=-x.diff()),
    "another speed": rubs(sliding=2 * x.diff()),
    "another direction": rubs(along=N.z),
}


@pytest.mark.parametrize("name", SLIDES)
def test_sliding_that_is_not_that_of_the_bodies_is_refused(name: str) -> None:
    with pytest.raises(SceneError, match=r"load f: .* is not how 'block' slides on 'the ground'"):
        check_scene(block(SLIDES[name]))
    check_scene(block(rubs()))

"""Every load in a small scene: all routes agree, and energy grows by the power of the loads."""

from collections.abc import Callable
from typing import Any

import pytest
from sympy import cos, sin, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.crosscheck import ROUTES, derive
from mechanics.crosscheck.by_sympy import METHODS
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    damper,
    force,
    gravity,
    holonomic,
    parameters,
    reaction,
    spring,
    torque,
    torsion_spring,
)
from mechanics.symbolic import is_zero

t = dynamicsymbols._t
x, theta, y = dynamicsymbols("x theta y")
m, M, L, k, c, g, h = parameters("m M L k c g h")


def cart(loads: Callable[..., tuple], inputs: tuple = (), moved: Any = 0) -> Scene:
    """A cart with a pendulum; `moved` moves the whole rail."""
    N = ReferenceFrame("N")
    A = N.orientnew("A", "Axis", (theta, N.z))
    O = Point("O")
    wall = O.locatenew("W", moved * N.x + h * N.y)
    B = O.locatenew("B", (x + moved) * N.x)
    C = B.locatenew("C", -L / 2 * A.y)
    tip = B.locatenew("tip", -L * A.y)
    return Scene(
        "cart", N, O, coordinates=(x, theta), inputs=inputs,
        bodies=(RigidBody("cart", B, N, m, m * L**2), RigidBody("rod", C, A, M, M * L**2 / 12)),
        loads=loads(N, A, wall, B, C, tip),
        reactions=(
            reaction("T", at=B, on="cart", by="rod", along=N.x),
            reaction("R", at=B, on="rod", by="cart", along=N.y),
            reaction("S", at=B, on="cart", by=None, along=N.y),
        ),
    )  # fmt: skip


f = dynamicsymbols("f")
SCENES = {
    "damper along": cart(lambda N, A, W, B, C, tip: (damper("d", W, B, c, along=N.x),)),
    "damper": cart(lambda N, A, W, B, C, tip: (damper("d", W, C, c),)),
    "damper between bodies": cart(lambda N, A, W, B, C, tip: (
        damper("d", B.locatenew("D", L * N.x), tip, c, first_on="cart", second_on="rod"),)),
    "spring with length": cart(lambda N, A, W, B, C, tip: (spring("s", W, C, k, length=L),)),
    "spring between moving points": cart(lambda N, A, W, B, C, tip: (
        spring("s", B.locatenew("D", L * N.x), tip, k, length=h, first_on="cart",
               second_on="rod"),)),
    "torsion spring": cart(lambda N, A, W, B, C, tip: (
        torsion_spring("s", theta, N.z, k, on="rod", by="cart"), gravity(-g * N.y))),
    "torque between bodies": cart(lambda N, A, W, B, C, tip: (
        torque("Q", (f - c * theta.diff()) * N.z, on="rod", by="cart"),), (f,)),
    "force with partner": cart(lambda N, A, W, B, C, tip: (
        force("F", tip, f * A.x, on="rod", by="cart"),), (f,)),
    "follower force": cart(lambda N, A, W, B, C, tip: (force("F", tip, f * A.y, on="rod"),), (f,)),
    "force of speeds and time": cart(lambda N, A, W, B, C, tip: (
        force("F", B, (k * sin(t) - c * x.diff()) * N.x, on="cart"),)),
    "angle bare and under sine": cart(lambda N, A, W, B, C, tip: (
        torque("Q", (-k * theta - c * sin(theta) + k * theta**2 * cos(theta)) * N.z, on="rod"),
        gravity(-g * N.y))),
    "prescribed rail": cart(lambda N, A, W, B, C, tip: (
        gravity(-g * N.y), spring("s", W, B, k, along=N.x)), (y,), y),
    "prescribed rail, given time": cart(lambda N, A, W, B, C, tip: (
        gravity(-g * N.y), damper("d", W, C, c)), (), h * sin(t)),
    "spring that pulls by a prescribed length": cart(lambda N, A, W, B, C, tip: (
        spring("s", W, C, k, length=L + y),), (y,)),
}  # fmt: skip


@pytest.mark.campaign
@pytest.mark.sample(1)
@pytest.mark.parametrize("name", SCENES)
def test_every_load_by_every_route(assert_laws: Any, name: str) -> None:
    assert_laws(SCENES[name])


def test_springs_and_dampers_are_those_of_the_textbook() -> None:
    """m x'' + c x' + k (x - l) = f."""
    N, O = ReferenceFrame("N"), Point("O")
    B = O.locatenew("B", x * N.x)
    scene = Scene(
        "oscillator", N, O, coordinates=(x,), bodies=(Particle("mass", B, m),), inputs=(f,),
        loads=(spring("k", O, B, k, along=N.x, length=L), damper("c", O, B, c, along=N.x),
               force("f", B, f * N.x)),
    )  # fmt: skip
    for route in ("free_body", "moving_point", "kane", "lagrange"):
        equations = derive(scene, route)
        (q,), (u,), (ud,) = scene.q, scene.u, scene.ud
        wanted = m * ud + c * u + k * (q - L) - scene.plain(f)
        scale = equations.mass[0] / m
        assert is_zero(equations.residual[0] - scale * wanted)


def test_a_moved_support_shakes_the_pendulum() -> None:
    """l theta'' + y'' cos(theta) + g sin(theta) = 0 for a pivot that is moved by y(t)."""
    N = ReferenceFrame("N")
    A = N.orientnew("A", "Axis", (theta, N.z))
    O = Point("O")
    B = O.locatenew("B", y * N.x)
    C = B.locatenew("C", -L * A.y)
    scene = Scene(
        "shaken", N, O, coordinates=(theta,), inputs=(y,), bodies=(Particle("bob", C, m),),
        loads=(gravity(-g * N.y),),
        reactions=(reaction("S", at=C, on="bob", by=None, along=A.y),),
    )  # fmt: skip
    wanted = scene.plain(L * theta.diff(t, 2) + y.diff(t, 2) * cos(theta) + g * sin(theta))
    for route in ("free_body", "moving_point", "kane", "lagrange"):
        residual = derive(scene, route).residual[0]
        scale = residual.diff(scene.ud[0]) / L
        assert is_zero(residual - scale * wanted)


def residuals(scene: Scene) -> list[Any]:
    """Of every route, and of SymPy's methods."""
    routes = [derive(scene, route.name) for route in ROUTES]
    return [e.residual for e in (*routes, *(method(scene) for _, method in METHODS.values()))]


def test_velocities_that_users_set_have_no_influence() -> None:
    scene = SCENES["torsion spring"]
    before = residuals(scene)
    rod = scene.body("rod")
    rod.centre.set_vel(scene.frame, 17 * scene.frame.x)
    rod.centre.set_acc(scene.frame, scene.frame.y)
    rod.frame.set_ang_vel(scene.frame, 5 * scene.frame.z)
    assert residuals(scene) == before


@pytest.mark.campaign
def test_a_pendulum_in_cartesian_coordinates(assert_laws: Any) -> None:
    N, O = ReferenceFrame("N"), Point("O")
    B = O.locatenew("B", x * N.x + y * N.y)
    tension = (x * N.x + y * N.y) / L
    assert_laws(Scene(
        "bead on a circle", N, O, coordinates=(x, y), bodies=(Particle("bead", B, m),),
        loads=(gravity(-g * N.y),),
        reactions=(reaction("S", at=B, on="bead", by=None, along=tension),),
        constraints=(holonomic("circle", x**2 + y**2 - L**2, "S"),),
    ))  # fmt: skip
    assert_laws(Scene(
        "bead on a parabola", N, O, coordinates=(x, y), bodies=(Particle("bead", B, m),),
        loads=(gravity(-g * N.y),),
        reactions=(reaction("S", at=B, on="bead", by=None,
                            along=(N.y - 2 * x / h * N.x) / sqrt(1 + 4 * x**2 / h**2)),),
        constraints=(holonomic("parabola", y - x**2 / h, "S"),),
    ))  # fmt: skip


@pytest.mark.campaign
def test_a_constraint_that_moves_by_itself(assert_laws: Any) -> None:
    N, O = ReferenceFrame("N"), Point("O")
    B = O.locatenew("B", x * N.x + y * N.y)
    assert_laws(Scene(
        "bead on a lifted rail", N, O, coordinates=(x, y), bodies=(Particle("bead", B, m),),
        loads=(gravity(-g * N.y), spring("s", O, B, k, length=L)),
        reactions=(reaction("S", at=B, on="bead", by=None, along=N.y),),
        constraints=(holonomic("rail", y - h * sin(t), "S"),),
    ))  # fmt: skip

"""Spatial motions against the equations that textbooks print, by every route."""

from typing import Any

import pytest
from every_route import derive_with
from sympy import Expr, cos, sin, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.checks.ledger import check_row
from mechanics.kernel import Verdict
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    gravity,
    parameters,
    reaction,
    reaction_couple,
    spring,
)
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion

t = dynamicsymbols._t
phi, theta, psi, x, y = dynamicsymbols("phi theta psi x y")
w1, w2, w3 = dynamicsymbols("w1:4")
m, g, L, k, h, r, Omega, A, B, C = parameters("m g L k h r Omega A B C")


def assert_follow(scene: Scene, *rows: tuple[Expr, Expr]) -> None:
    """Every typed equation holds along the motions of every route, and its negative does not."""
    for equations in derive_with(scene).values():
        for left, right in rows:
            row = published("typed", EquationOfMotion(), left, right, label="typed")
            assert check_row(scene, row, equations).shown, (equations.route, left)
    wrong = published("wrong", EquationOfMotion(), rows[0][0], -rows[0][1] + 1, label="wrong")
    assert check_row(scene, wrong, equations).verdict is Verdict.REFUTED


def euler_angles(N: ReferenceFrame) -> ReferenceFrame:
    precessing = N.orientnew("P", "Axis", (phi, N.z))
    nodding = precessing.orientnew("Q", "Axis", (theta, precessing.x))
    return nodding.orientnew("S", "Axis", (psi, nodding.z))


def top(pivot: bool) -> Scene:
    """A symmetric top on its tip (Goldstein, Classical Mechanics, section 5.7)."""
    N, O = ReferenceFrame("N"), Point("O")
    body = euler_angles(N)
    centre = O.locatenew("G", L * body.z) if pivot else O
    axes = (("X", N.x), ("Y", N.y), ("Z", N.z)) if pivot else ()
    return Scene(
        "top", N, O, coordinates=(phi, theta, psi),
        bodies=(RigidBody("top", centre, body, m, inertia(body, A, A, C)),),
        loads=(gravity(-g * N.z),) if pivot else (),
        reactions=tuple(reaction(name, O, "top", None, axis) for name, axis in axes),
    )  # fmt: skip


@pytest.mark.campaign
def test_heavy_symmetric_top(assert_laws: Any) -> None:
    scene = top(pivot=True)
    assert_laws(scene)
    I = A + m * L**2
    spin = C * (psi.diff() + phi.diff() * cos(theta))
    about_vertical = I * phi.diff() * sin(theta) ** 2 + spin * cos(theta)
    nutation = I * phi.diff() ** 2 * sin(theta) * cos(theta) - spin * phi.diff() * sin(theta)
    assert_follow(
        scene,
        (I * theta.diff(t, 2), nutation + m * g * L * sin(theta)),
        (about_vertical.diff(t), 0),
        (spin.diff(t), 0),
    )


@pytest.mark.campaign
def test_euler_equations_of_a_free_body(assert_laws: Any) -> None:
    """A w1' = (B - C) w2 w3, and cyclically; speeds are the components in the body."""
    N, O = ReferenceFrame("N"), Point("O")
    body = euler_angles(N)
    scene = Scene(
        "free body", N, O, coordinates=(phi, theta, psi),
        speeds=(
            (w1, phi.diff() * sin(theta) * sin(psi) + theta.diff() * cos(psi)),
            (w2, phi.diff() * sin(theta) * cos(psi) - theta.diff() * sin(psi)),
            (w3, phi.diff() * cos(theta) + psi.diff()),
        ),
        bodies=(RigidBody("body", O, body, m, inertia(body, A, B, C)),),
    )  # fmt: skip
    assert_laws(scene)
    assert_follow(
        scene,
        (A * w1.diff(), (B - C) * w2 * w3),
        (B * w2.diff(), (C - A) * w3 * w1),
        (C * w3.diff(), (A - B) * w1 * w2),
    )


@pytest.mark.campaign
def test_spherical_pendulum(assert_laws: Any) -> None:
    N, O = ReferenceFrame("N"), Point("O")
    turned = N.orientnew("P", "Axis", (phi, N.z))
    rod = turned.orientnew("Q", "Axis", (theta, -turned.y))
    bob = O.locatenew("P", -L * rod.z)
    scene = Scene(
        "spherical pendulum", N, O, coordinates=(phi, theta), bodies=(Particle("bob", bob, m),),
        loads=(gravity(-g * N.z),),
        reactions=(reaction("S", at=bob, on="bob", by=None, along=rod.z),),
    )  # fmt: skip
    assert_laws(scene)
    assert_follow(
        scene,
        (theta.diff(t, 2), phi.diff() ** 2 * sin(theta) * cos(theta) - g / L * sin(theta)),
        (phi.diff(t, 2) * sin(theta), -2 * phi.diff() * theta.diff() * cos(theta)),
    )


@pytest.mark.campaign
def test_screw(assert_laws: Any) -> None:
    """(I + m p^2) theta'' = -m g p on a vertical thread that rises p for each radian."""
    N, O = ReferenceFrame("N"), Point("O")
    nut = N.orientnew("A", "Axis", (theta, N.z))
    centre = O.locatenew("C", h * theta * N.z)
    touch = centre.locatenew("D", r * nut.x)
    normal = (r * N.z - h * nut.y) / sqrt(r**2 + h**2)
    scene = Scene(
        "screw", N, O, coordinates=(theta,),
        bodies=(RigidBody("nut", centre, nut, m, inertia(nut, A, A, C)),),
        loads=(gravity(-g * N.z),),
        reactions=(
            reaction("thread", at=touch, on="nut", by=None, along=normal),
            reaction("X", at=centre, on="nut", by=None, along=N.x),
            reaction("Y", at=centre, on="nut", by=None, along=N.y),
            reaction_couple("Mx", on="nut", by=None, along=N.x),
            reaction_couple("My", on="nut", by=None, along=N.y),
        ),
    )  # fmt: skip
    assert_laws(scene)
    assert_follow(scene, ((C + m * h**2) * theta.diff(t, 2), -m * g * h))
    (words,) = derive_with(scene, ("moving_point",))["moving_point"].chosen
    assert "pitch" in words


@pytest.mark.sample(0)
@pytest.mark.parametrize("prescribed", [Omega * t, psi], ids=["time", "input"])
def test_rotating_frame(assert_laws: Any, prescribed: Expr) -> None:
    """Foucault: a mass on a turning table, held by a spring to the middle."""
    N, O = ReferenceFrame("N"), Point("O")
    table = N.orientnew("A", "Axis", (prescribed, N.z))
    mass = O.locatenew("P", x * table.x + y * table.y)
    scene = Scene(
        "turning table", N, O, coordinates=(x, y), bodies=(Particle("mass", mass, m),),
        loads=(spring("k", O, mass, k),), inputs=(psi,) if prescribed == psi else (),
    )  # fmt: skip
    assert_laws(scene)
    turn = prescribed.diff(t)
    assert_follow(
        scene,
        (m * (x.diff(t, 2) - 2 * turn * y.diff() - turn.diff(t) * y - turn**2 * x), -k * x),
        (m * (y.diff(t, 2) + 2 * turn * x.diff() + turn.diff(t) * x - turn**2 * y), -k * y),
    )


@pytest.mark.campaign
def test_bead_on_a_turning_rod(assert_laws: Any) -> None:
    """r'' = Omega^2 r: the rod does work on the bead, and the energy law counts it."""
    N, O = ReferenceFrame("N"), Point("O")
    rod = N.orientnew("A", "Axis", (Omega * t, N.z))
    bead = O.locatenew("P", x * rod.x)
    scene = Scene(
        "bead on a turning rod", N, O, coordinates=(x,), bodies=(Particle("bead", bead, m),),
        reactions=(reaction("R", at=bead, on="bead", by=None, along=rod.y),),
    )  # fmt: skip
    assert_laws(scene)
    assert_follow(scene, (x.diff(t, 2), Omega**2 * x))

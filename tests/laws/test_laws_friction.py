"""Friction that depends on a reaction: every law, and accelerations that textbooks print."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from sympy import DiracDelta, Expr, Symbol, cos, sign, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.checks.solution import solve
from mechanics.crosscheck import derive
from mechanics.equations import Equations
from mechanics.kinematics.symbolic import Kinematics
from mechanics.routes.derivation import steps_of
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    condition,
    coulomb,
    force,
    gravity,
    parameters,
    reaction,
)
from mechanics.symbolic import Arithmetic, decide

x, y, phi, theta, F, u1, u2 = dynamicsymbols("x y phi theta F u1 u2")
m, M, r, l, g, mu, nu, alpha = parameters("m M r l g mu nu alpha")
ROUTES = ("free_body", "moving_point", "kane", "lagrange")


def pressing(name: str) -> Any:
    return condition(f"contact {name}", Symbol(name, real=True) > 0, "lifts off")


def incline() -> Scene:
    """A block that slides along an incline, x upwards."""
    N = ReferenceFrame("N")
    A = N.orientnew("A", "Axis", (alpha, N.z))
    O = Point("O")
    C = O.locatenew("C", x * A.x)
    return Scene(
        "incline", N, O, coordinates=(x,), bodies=(Particle("block", C, m),),
        loads=(gravity(-g * N.y), coulomb("f", "R", A.x, x.diff(), mu)),
        reactions=(reaction("R", C, "block", None, A.y),), conditions=(pressing("R"),),
    )  # fmt: skip


def hoop() -> Scene:
    """A hoop that slips and spins on a floor; the contact is no point of the hoop."""
    N = ReferenceFrame("N")
    A = N.orientnew("A", "Axis", (phi, N.z))
    O = Point("O")
    C = O.locatenew("C", x * N.x + r * N.y)
    P = C.locatenew("P", -r * N.y)
    return Scene(
        "hoop", N, O, coordinates=(x, phi), bodies=(RigidBody("hoop", C, A, m, m * r**2),),
        loads=(gravity(-g * N.y), coulomb("f", "R", N.x, x.diff() + r * phi.diff(), mu)),
        reactions=(reaction("R", P, "hoop", None, N.y),), conditions=(pressing("R"),),
    )  # fmt: skip


def ladder() -> Scene:
    """A ladder that slides down a wall: the friction of each end presses the other."""
    N = ReferenceFrame("N")
    A = N.orientnew("A", "Axis", (theta, N.z))
    O = Point("O")
    foot = O.locatenew("foot", 2 * l * sin(theta) * N.x)
    C = foot.locatenew("C", l * A.y)
    top = foot.locatenew("top", 2 * l * A.y)
    return Scene(
        "ladder", N, O, coordinates=(theta,),
        bodies=(RigidBody("ladder", C, A, m, m * l**2 / 3),),
        loads=(
            gravity(-g * N.y),
            coulomb("floor", "R", N.x, 2 * l * cos(theta) * theta.diff(), mu),
            coulomb("wall", "W", N.y, -2 * l * sin(theta) * theta.diff(), nu),
        ),
        reactions=(
            reaction("R", foot, "ladder", None, N.y), reaction("W", top, "ladder", None, N.x),
        ),
        conditions=(pressing("R"), pressing("W")),
    )  # fmt: skip


def wedge() -> Scene:
    """A block that slides on a wedge that slides on a floor."""
    N = ReferenceFrame("N")
    A = N.orientnew("A", "Axis", (alpha, N.z))
    O = Point("O")
    B = O.locatenew("B", x * N.x)
    C = B.locatenew("C", y * A.x)
    return Scene(
        "wedge", N, O, coordinates=(x, y), inputs=(F,),
        bodies=(Particle("wedge", B, M), RigidBody("block", C, A, m, m * l**2)),
        loads=(
            gravity(-g * N.y),
            force("F", B, F * N.x, on="wedge"),
            coulomb("below", "R", N.x, x.diff(), mu),
            coulomb("between", "S", A.x, y.diff(), nu),
        ),
        reactions=(
            reaction("R", B, "wedge", None, N.y), reaction("S", C, "block", "wedge", A.y),
        ),
        conditions=(pressing("R"), pressing("S")),
    )  # fmt: skip


def pulled() -> Scene:
    """A crate with a swinging bob, on a floor whose roughness depends on where that hangs."""
    N = ReferenceFrame("N")
    A = N.orientnew("A", "Axis", (theta, N.z))
    O = Point("O")
    B = O.locatenew("B", x * N.x)
    C = B.locatenew("C", -l * A.y)
    return Scene(
        "crate with a pendulum", N, O, coordinates=(x, theta),
        bodies=(Particle("crate", B, M), Particle("bob", C, m)),
        loads=(gravity(-g * N.y), coulomb("f", "R", N.x, x.diff(), mu * (1 + cos(theta) ** 2))),
        reactions=(
            reaction("R", B, "crate", None, N.y), reaction("T", C, "bob", "crate", A.y),
        ),
        conditions=(pressing("R"),),
    )  # fmt: skip


def slipping() -> Scene:
    """The hoop with its slip for a speed."""
    return replace(hoop(), speeds=((u1, x.diff() + r * phi.diff()), (u2, phi.diff())))


SCENES: dict[str, Callable[[], Scene]] = {
    scene.__name__: scene for scene in (incline, hoop, ladder, wedge, pulled, slipping)
}


@pytest.mark.campaign
@pytest.mark.sample(1)
@pytest.mark.parametrize("name", SCENES)
def test_friction_by_every_route(assert_laws: Any, name: str) -> None:
    assert_laws(SCENES[name]())


def acceleration(equations: Equations, wanted: tuple[Expr, ...]) -> bool:
    """Whether the accelerations are the wanted ones."""
    scene = equations.scene
    plain = [scene.plain(entry) for entry in wanted]

    def experiment(a: Arithmetic) -> list[tuple[Any, Any]]:
        found = solve(a, equations)
        return [(one, a.value(two)) for one, two in zip(found, plain, strict=True)]

    return decide("accelerations", experiment).shown


@pytest.mark.parametrize("route", ROUTES)
def test_a_block_on_an_incline_is_that_of_the_textbook(route: str) -> None:
    wanted = -g * sin(alpha) - mu * g * cos(alpha) * sign(x.diff())
    assert acceleration(derive(incline(), route), (wanted,))
    assert not acceleration(derive(incline(), route), (wanted + mu * g,))


@pytest.mark.parametrize("route", ROUTES)
def test_a_hoop_that_slips_loses_speed_and_gains_spin(route: str) -> None:
    slip = sign(x.diff() + r * phi.diff())
    assert acceleration(derive(hoop(), route), (-mu * g * slip, -mu * g * slip / r))


@pytest.mark.parametrize("name", SCENES)
def test_without_friction_the_mass_matrix_is_that_of_the_energy(name: str) -> None:
    scene = SCENES[name]()
    equations = derive(scene, "kane")
    assert not equations.conjugate
    still = dict.fromkeys((mu, nu), 0)
    wanted = Kinematics(scene).mass_matrix
    assert decide(
        "M", lambda a: [
            (a.value(one.xreplace(still)), a.value(two))
            for one, two in zip(equations.mass, wanted, strict=True)
        ],
    ).shown  # fmt: skip


@pytest.mark.campaign
@pytest.mark.parametrize("route", ["kane", "lagrange"])
def test_projected_routes_tell_what_presses(route: str) -> None:
    for make in SCENES.values():
        equations, whole = derive(make(), route), derive(make(), "free_body")
        table = dict(whole.reactions)
        assert set(dict(equations.reactions)) <= set(table)

        def experiment(a: Arithmetic, one: Equations = equations, two=table) -> list:
            for symbol, number in zip(one.unknowns, solve(a, one), strict=True):
                a.assign(symbol, number)
            return [(a.value(value), a.value(two[symbol])) for symbol, value in one.reactions]

        assert decide("what presses", experiment).shown


def test_moving_point_projects_across_the_leaning_reaction() -> None:
    chosen = derive(incline(), "moving_point").chosen
    assert len(chosen) == 1
    assert "mu*" in chosen[0]
    equations = derive(ladder(), "moving_point")
    # The point where the two leaning forces meet, which jumps with the sign of the sliding.
    assert equations.chosen == (
        "whole system: moment about a point of the axis beside foot, axis N.z",
    )
    lines = [line for step in steps_of(equations) for line in step.lines]
    sides = [side for line in lines for side in (line.left, line.right)]
    values = [
        v
        for side in sides
        for v in ([t.value for t in side] if isinstance(side, tuple) else [side])
    ]
    formulas = [value for value in values if isinstance(value, Expr)]
    assert formulas and not any(value.has(DiracDelta) for value in formulas)

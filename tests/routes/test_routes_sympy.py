"""SymPy's methods run on SymPy's kinematics, so that they notice an error of ours."""

from collections.abc import Callable

import pytest
from spatial_joints import universal_joint
from sympy import Symbol, cos
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.checks.admissible import check_scene
from mechanics.crosscheck.by_sympy import METHODS, by_sympy
from mechanics.crosscheck.programs import derive_rows, same_motion
from mechanics.kernel import Verdict
from mechanics.kinematics import chain, motion
from mechanics.mechanism import lower
from mechanics.program import Builder
from mechanics.program.vectors import product, transpose
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    condition,
    coulomb,
    force,
    gravity,
    holonomic,
    nonholonomic,
    parameters,
    reaction,
    spring,
    torque,
)
from mechanics.scene.loads import damper, torsion_spring
from systems import elastic_pendulum

a, b, x, y, z, u1, u2, F, tau = dynamicsymbols("a b x y z u1 u2 F tau")
m, J, L, k, c, mu, g, w = parameters("m J L k c mu g w")


def geared_arm() -> Scene:
    """An arm with a wheel at its end, every load between the two; speeds that are no rates."""
    ground, origin = ReferenceFrame("N"), Point("O")
    arm = ground.orientnew("A", "Axis", (a, ground.z))
    wheel = arm.orientnew("B", "Axis", (b, arm.z))
    end, rim = origin.locatenew("E", L * arm.x), origin.locatenew("R", L * arm.x + L * wheel.y)
    return Scene(
        "geared arm", ground, origin, coordinates=(a, b), inputs=(F, tau),
        speeds=((u1, (2 + cos(b)) * a.diff()), (u2, a.diff() + b.diff() - w)),
        bodies=(RigidBody("arm", origin, arm, m, J), RigidBody("wheel", end, wheel, m, J)),
        loads=(
            gravity(-g * ground.y),
            torque("motor", tau * ground.z, on="wheel", by="arm"),
            force("push", rim, F * arm.x, on="wheel", by="arm"),
            torsion_spring("coil", b, ground.z, k, on="wheel", by="arm"),
            spring("spring", origin, rim, k, length=L, first_on="arm", second_on="wheel"),
            damper("damper", origin.locatenew("W", 2 * L * ground.x), end, c, second_on="wheel"),
        ),
        reactions=tuple(
            reaction(f"{name}{e}", at=at, on=on, by=by, along=e)
            for name, at, on, by in (("P", origin, "arm", None), ("Q", end, "wheel", "arm"))
            for e in (ground.x, ground.y)
        ),
    )  # fmt: skip


def skate() -> Scene:
    """A bead on a cylinder that can move across a turning direction only."""
    ground, origin = ReferenceFrame("N"), Point("O")
    bead = origin.locatenew("B", x * ground.x + y * ground.y + z * ground.z)
    normal, across = ground.z * L - ground.x * x, ground.y - x / L * ground.x
    return Scene(
        "skate", ground, origin, coordinates=(x, y, z), bodies=(Particle("bead", bead, m),),
        loads=(gravity(-g * ground.z),),
        reactions=(
            reaction("N", at=bead, on="bead", by=None, along=normal),
            reaction("S", at=bead, on="bead", by=None, along=across),
        ),
        constraints=(
            holonomic("cylinder", L * z - x**2 / 2, "N"),
            nonholonomic("no slip", y.diff() - x / L * x.diff(), "S"),
        ),
    )  # fmt: skip


def rubbing_box() -> Scene:
    """A box that rubs on a track; a bead on a spring bounces on it and presses with it."""
    ground, origin = ReferenceFrame("N"), Point("O")
    box = origin.locatenew("A", x * ground.x)
    bead = box.locatenew("B", y * ground.y + L * ground.y)
    return Scene(
        "rubbing box", ground, origin, coordinates=(x, y), inputs=(F,),
        bodies=(Particle("box", box, m), Particle("bead", bead, m)),
        loads=(
            gravity(-g * ground.y),
            spring("spring", box, bead, k, length=L, along=ground.y),
            force("F", box, F * ground.x, on="box"),
            coulomb("track", "N", along=ground.x, sliding=x.diff(), coefficient=mu),
        ),
        reactions=(
            reaction("N", at=box, on="box", by=None, along=ground.y),
            reaction("G", at=bead, on="bead", by="box", along=ground.x),
        ),
        conditions=(condition("lifted", Symbol("N", real=True) > 0, "the box lifts off"),),
    )  # fmt: skip


@pytest.mark.campaign
@pytest.mark.sample(2)
@pytest.mark.parametrize("make", [geared_arm, skate, rubbing_box, universal_joint])
def test_sympys_methods_give_the_motion_of_the_routes(make: Callable[[], Scene]) -> None:
    """Every kind of load, speed, constraint and turn; M is symmetric where rows are conjugate."""
    scene = make()
    programs = derive_rows(check_scene(scene), [*METHODS])
    for route, (name, derive) in METHODS.items():
        equations = derive(scene)
        assert same_motion(f"{route} = {name}", programs, route, equations).shown
        assert equations.conjugate is equations.mass.is_symmetric()


def composed_backwards(frame, table, right=chain.relative_velocity):
    """Angular velocities of the steps, with the wrong sign: an error of Kane's route alone."""
    return tuple(tuple(-entry for entry in vector) for vector in right(frame, table))


def turned_backwards(outer, step):
    """Rotations of the steps, transposed: an error of all routes."""
    return product(outer, transpose(step))


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("module", "name", "wrong", "differ"),
    [
        (chain, "relative_velocity", composed_backwards, {"kane"}),
        (motion, "product", turned_backwards, {"kane", "lagrange"}),
    ],
)
def test_wrong_kinematics_of_ours_do_not_reach_sympys_methods(
    monkeypatch: pytest.MonkeyPatch, module: object, name: str, wrong: Callable, differ: set[str]
) -> None:
    right = [derive(elastic_pendulum.scene()).matrices for _, derive in METHODS.values()]
    monkeypatch.setattr(module, name, wrong)
    scene = elastic_pendulum.scene()
    assert [derive(scene).matrices for _, derive in METHODS.values()] == right
    programs = derive_rows(lower(scene, Builder()), [*METHODS])
    found = by_sympy(scene, programs, {}, lambda words: None).pairs
    refuted = {pair for pair, finding in found.items() if finding.verdict is Verdict.REFUTED}
    assert refuted == {(route, f"{route}_sympy") for route in differ}

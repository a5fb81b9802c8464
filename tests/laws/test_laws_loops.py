"""Loops of bodies that one coordinate follows: their reactions are in no joint of the tree.

(m1 + m2 + J/R^2) x'' = (m1 - m2) g - c x'/R^2,    T1 = m1 (g - x''),    T2 = m2 (g + x'')
(J1/R1^2 + J2/R2^2) R1 a'' = M/R1,                 F = (M - J1 a'')/R1
"""

from pathlib import Path

import numpy as np
import pytest
from sympy import S, simplify
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics import compile, crosscheck, derive, simulate
from mechanics.crosscheck import ROUTES, CrossCheck
from mechanics.errors import InputError, SingularError
from mechanics.export import write_c
from mechanics.program import Builder
from mechanics.program.residues import Residues
from mechanics.routes.elimination import Elimination, Row
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    gravity,
    parameters,
    reaction,
    torque,
)
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion, ReactionValue
from mechanics.scene.system import System

pytestmark = pytest.mark.campaign

x, a = dynamicsymbols("x a")
m1, m2, J, R, c, g = parameters(
    "m1 m2 J R c g", units="kg kg kg*m^2 m N*m*s/rad m/s^2", typical="2 1 0.05 0.2 0.01 9.81"
)
J1, J2, R1, R2, M = parameters(
    "J1 J2 R1 R2 M", units="kg*m^2 kg*m^2 m m N*m", typical="0.1 0.2 0.1 0.3 1"
)


def atwood() -> Scene:
    """Two masses on guides, ropes over a heavy pulley with friction, one coordinate."""
    ground, origin = ReferenceFrame("N"), Point("O")
    wheel = ground.orientnew("W", "Axis", (x / R, ground.z))
    left = origin.locatenew("P1", -R * ground.x - x * ground.y)
    right = origin.locatenew("P2", R * ground.x + x * ground.y)
    friction = -c * x.diff() / R * ground.z
    return Scene(
        "Atwood machine",
        ground,
        origin,
        coordinates=(x,),
        bodies=(
            Particle("left", left, m1),
            Particle("right", right, m2),
            RigidBody("pulley", origin, wheel, S(3), inertia(wheel, 0, 0, J)),
        ),
        loads=(gravity(-g * ground.y), torque("friction", on="pulley", vector=friction)),
        reactions=(
            reaction("T1", at=left, on="left", by="pulley", along=ground.y),
            reaction("T2", at=right, on="right", by="pulley", along=ground.y),
            reaction("G1", at=left, on="left", by=None, along=ground.x),
            reaction("G2", at=right, on="right", by=None, along=ground.x),
            reaction("Bx", at=origin, on="pulley", by=None, along=ground.x),
            reaction("By", at=origin, on="pulley", by=None, along=ground.y),
        ),
    )


def gears() -> Scene:
    """Two wheels on bearings; only the force F of their teeth closes the loop."""
    ground, origin = ReferenceFrame("N"), Point("O")
    one = ground.orientnew("A", "Axis", (a, ground.z))
    two = ground.orientnew("B", "Axis", (-a * R1 / R2, ground.z))
    other = origin.locatenew("C", (R1 + R2) * ground.x)
    teeth = origin.locatenew("P", R1 * ground.x)
    held = (("A", origin, "first"), ("B", other, "second"))
    return Scene(
        "two gears",
        ground,
        origin,
        coordinates=(a,),
        bodies=(
            RigidBody("first", origin, one, S.One, inertia(one, 0, 0, J1)),
            RigidBody("second", other, two, S(2), inertia(two, 0, 0, J2)),
        ),
        loads=(torque("motor", on="first", vector=M * ground.z),),
        reactions=(
            *(
                reaction(f"{name}{axis}", at=at, on=on, by=None, along=getattr(ground, axis))
                for name, at, on in held
                for axis in "xy"
            ),
            reaction("F", at=teeth, on="second", by="first", along=ground.y),
        ),
    )


SYSTEMS = (
    System(
        "atwood",
        atwood,
        (
            published(
                "(1)",
                EquationOfMotion(),
                (m1 + m2 + J / R**2) * x.diff(dynamicsymbols._t, 2),
                (m1 - m2) * g - c / R**2 * x.diff(),
                label="motion",
            ),
            published("(2)", ReactionValue("T1"), m1 * (g - x.diff().diff()), label="left"),
            published("(3)", ReactionValue("T2"), m2 * (g + x.diff().diff()), label="right"),
        ),
    ),
    System(
        "gears",
        gears,
        (
            published(
                "(1)",
                EquationOfMotion(),
                (J1 / R1 + J2 * R1 / R2**2) * a.diff().diff(),
                M / R1,
                label="turning",
            ),
            published("(2)", ReactionValue("F"), (M - J1 * a.diff().diff()) / R1, label="teeth"),
        ),
    ),
)


@pytest.mark.sample(1)
@pytest.mark.parametrize("system", SYSTEMS, ids=lambda system: system.name)
def test_every_route_eliminates_the_reactions_of_a_loop(system: System) -> None:
    found = crosscheck(system, CrossCheck(states=100))
    assert found.ok, [f for f in found.findings if not f.shown]
    assert [entry.finding.shown for entry in found.published] == [True] * len(system.published)
    # The reactions of the loop, put into the momentum equations of every body.
    subjects = [finding.subject for finding in found.findings]
    assert "reactions: every body's momentum" in subjects
    for held in system.scene().reactions:
        assert f"reaction {held.name}: no power" in subjects


@pytest.mark.parametrize("route", [route.name for route in ROUTES])
def test_one_coordinate_leaves_one_equation(route: str) -> None:
    equations = derive(atwood(), route)
    assert equations.mass.shape == (1, 1)
    ratio = equations.forcing[0] / equations.mass[0]
    scene = equations.scene
    expected = ((m1 - m2) * g - c / R**2 * scene.u[0]) / (m1 + m2 + J / R**2)
    assert simplify(ratio - expected) == 0


@pytest.mark.sample(1)
@pytest.mark.parametrize("route", ["free_body", "moving_point"])
def test_loops_are_compiled_written_and_simulated(route: str, tmp_path: Path) -> None:
    model = compile(derive(atwood(), route))
    u = 0.3
    expected = (9.81 - 0.01 / 0.2**2 * u) / (3 + 0.05 / 0.2**2)
    np.testing.assert_allclose(model.forward_dynamics([0.1], [u]), [expected], rtol=1e-13)
    assert write_c(model, tmp_path)
    duration = 0.1
    fallen = simulate(model, duration, parameters={"c": 0}).coordinates["x"][-1]
    assert fallen == pytest.approx(9.81 / (3 + 0.05 / 0.2**2) * duration**2 / 2, rel=1e-8)


def test_a_reaction_that_no_row_holds_is_refused_by_name() -> None:
    builder = Builder()
    row, filter_ = Row(0, builder.input("x_ddot"), {}), Residues(builder)
    with pytest.raises(SingularError, match=r"T1, T2.*holonomic"):
        Elimination(filter_, filter_, [row]).solve_for([0, 1], None, ["T1", "T2"])


def test_rows_that_no_route_answers_are_left_out_with_a_remark() -> None:
    found = crosscheck(SYSTEMS[0], CrossCheck(routes=("kane",), states=10))
    assert found.ok and [entry.row.tag for entry in found.published] == ["(1)"]
    left_out = [remark for remark in found.remarks if "is not checked" in remark]
    assert [remark.split()[1] for remark in left_out] == ["(2)", "(3)"]
    assert "T1; free_body does" in left_out[0]


def test_a_reaction_that_does_not_exist_is_refused_whatever_the_route() -> None:
    row = published("(4)", ReactionValue("Nx"), m1 * g, label="none")
    for routes in ((), ("kane",)):
        with pytest.raises(InputError, match=r"no reaction 'Nx': they are T1, T2, G1"):
            crosscheck(System("atwood", atwood, (row,)), CrossCheck(routes=routes, states=10))

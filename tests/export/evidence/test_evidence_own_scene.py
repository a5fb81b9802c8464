"""A scene that no system of ours is like goes through the chain: dampers and a motor."""

from pathlib import Path

import pytest
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.compiled import compile
from mechanics.crosscheck import derive
from mechanics.export.evidence.verify import Outcome, verify
from mechanics.export.write_c import write_c
from mechanics.scene import (
    RigidBody,
    Scene,
    gravity,
    orientation,
    parameters,
    position,
    reaction,
    torque,
    velocity,
)

pytestmark = pytest.mark.campaign

a, b, tau = dynamicsymbols("a b tau")
m1, m2, l1, l2, J1, J2, g, c1, c2 = parameters(
    "m1 m2 l1 l2 J1 J2 g c1 c2",
    units="kg kg m m kg*m^2 kg*m^2 m/s^2 N*m*s N*m*s",
    typical="1 0.5 0.4 0.3 0.02 0.01 9.81 0.05 0.02",
)


def acrobot() -> Scene:
    """Two arms with dampers at their joints; a motor drives the first."""
    ground, pivot = ReferenceFrame("N"), Point("O")
    upper = ground.orientnew("A", "Axis", (a, ground.z))
    lower = ground.orientnew("B", "Axis", (b, ground.z))
    first = pivot.locatenew("C1", -l1 / 2 * upper.y)
    elbow = pivot.locatenew("E", -l1 * upper.y)
    second = elbow.locatenew("C2", -l2 / 2 * lower.y)
    return Scene(
        "acrobot", ground, pivot, coordinates=(a, b), inputs=(tau,),
        bodies=(RigidBody("arm1", first, upper, m1, J1), RigidBody("arm2", second, lower, m2, J2)),
        loads=(
            gravity(-g * ground.y),
            torque("d1", -c1 * a.diff() * ground.z, on="arm1"),
            torque("d2", -c2 * (b.diff() - a.diff()) * ground.z, on="arm2", by="arm1"),
            torque("motor", tau * ground.z, on="arm1"),
        ),
        reactions=tuple(
            reaction(f"{name}{k}", at=at, on=on, by=by, along=along)
            for name, at, on, by in (("O", pivot, "arm1", None), ("E", elbow, "arm2", "arm1"))
            for k, along in (("x", ground.x), ("y", ground.y))
        ),
        outputs={"tip": position(elbow.locatenew("T", -l2 * lower.y)), "hand": orientation(lower),
                 "slip": velocity(second, along=ground.x)},
    )  # fmt: skip


def test_a_scene_of_somebody_goes_through_the_chain(tmp_path: Path) -> None:
    equations = derive(acrobot(), "free_body")
    wanted = [name for output in ("tip", "hand", "slip") for name in (output, f"{output}_jacobian")]
    names = ("forward_dynamics", "energy", *wanted)
    write_c(compile(equations), tmp_path, functions=names, precision="both", prove=False)
    assert verify(tmp_path, equations, measure=False).outcome is Outcome.SHOWN


def test_a_wrong_index_in_an_output_is_refuted(tmp_path: Path) -> None:
    """The cosine of the other angle in the position of the tip."""
    equations = derive(acrobot(), "free_body")
    write_c(compile(equations), tmp_path, functions=("tip",), prove=False)
    file = tmp_path / "acrobot.c"
    text = file.read_text()
    assert text.count("cos(b)") == 1
    file.write_text(text.replace("cos(b)", "cos(a)"))
    assert verify(tmp_path, equations, measure=False).outcome is Outcome.REFUTED

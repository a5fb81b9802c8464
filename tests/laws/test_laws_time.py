"""Time that is written: a bead on a hoop that turns at Omega.

R theta'' = Omega^2 R sin theta cos theta - g sin theta
"""

from pathlib import Path

import numpy as np
import pytest
from sympy import Symbol, cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics import compile, derive
from mechanics.crosscheck import ROUTES
from mechanics.export import write_c
from mechanics.scene import Particle, Scene, gravity, parameters, reaction
from systems import ALL

theta, t = dynamicsymbols("theta"), dynamicsymbols._t
m, R, W, g = parameters("m R Omega g", units="kg m rad/s m/s^2", typical="1 0.5 6 9.81")
NAMES = [route.name for route in ROUTES]


def hoop() -> Scene:
    ground, origin = ReferenceFrame("N"), Point("O")
    turning = ground.orientnew("H", "Axis", (W * t, ground.z))
    arm = turning.orientnew("A", "Axis", (theta, turning.y))
    bead = origin.locatenew("P", -R * arm.z)
    return Scene(
        "hoop",
        ground,
        origin,
        coordinates=(theta,),
        bodies=(Particle("bead", bead, m),),
        loads=(gravity(-g * ground.z),),
        reactions=(
            reaction("Nr", at=bead, on="bead", by=None, along=arm.z),
            reaction("Nt", at=bead, on="bead", by=None, along=arm.y),
        ),
    )


@pytest.mark.parametrize("route", NAMES)
def test_time_cancels_where_the_motion_does_not_depend_on_it(route: str) -> None:
    scene = hoop()
    equations = derive(scene, route)
    assert Symbol("t") not in equations.mass.free_symbols | equations.forcing.free_symbols
    angle = scene.q[0]
    expected = W**2 * sin(angle) * cos(angle) - g / R * sin(angle)
    assert (equations.forcing[0] / equations.mass[0] - expected).expand() == 0


@pytest.mark.sample(2)
@pytest.mark.parametrize("route", NAMES)
def test_time_is_an_input_whatever_the_route(route: str) -> None:
    model = compile(derive(hoop(), route))
    assert [(entry.name, entry.unit) for entry in model.quantities.inputs] == [("t", "s")]
    found = [model.forward_dynamics([0.7], [0.2], inputs=[at]) for at in (0.0, 1.3)]
    expected = 36 * np.sin(0.7) * np.cos(0.7) - 9.81 / 0.5 * np.sin(0.7)
    np.testing.assert_allclose(found, [[expected], [expected]], rtol=1e-14)
    # The kinetic energy has no time in it, and is a function of the same inputs all the same.
    energies = [list(model.energy([0.7], [0.2], inputs=[at]).values()) for at in (0.0, 1.3)]
    np.testing.assert_allclose(energies[0], energies[1], rtol=1e-14)


def test_at_rest_at_the_bottom_no_route_divides_by_zero() -> None:
    for route in NAMES:
        found = compile(derive(hoop(), route)).forward_dynamics([0.0], [0.0], inputs=[0.0])
        assert found.tolist() == [0.0]


@pytest.mark.campaign
@pytest.mark.parametrize("route", ["moving_point", "kane"])
def test_c_is_written_with_some_outputs_and_fixed_parameters(route: str, tmp_path: Path) -> None:
    outputs = ("forward_dynamics", "energy", "step")
    model = compile(derive(hoop(), route), fixed={"g": 9.81}, outputs=outputs)
    written = write_c(model, tmp_path, batch=False)
    assert any(path.suffix == ".h" for path in written)


def test_a_scene_without_time_has_no_such_input() -> None:
    scene = hoop()
    assert scene.explicit_time and Symbol("t") not in scene.parameters
    assert not any(system.scene().explicit_time for system in ALL)

"""A motion with friction ends where sliding does: sticking is not modelled, and not pretended.

block on a floor        v = v0 - mu g t,  at rest at v0 / (mu g)
hoop with backspin      x' = v0 - mu g t,  r phi' = w0 - mu g t,  rolls at (v0 + w0) / (2 mu g)
"""

from pathlib import Path

import numpy as np
import pytest
from sympy import Symbol
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics import compile, derive, ensemble, linearize, simulate, write_fmu
from mechanics.compiled import Model
from mechanics.errors import ExpressionError, InputError
from mechanics.scene import (
    RigidBody,
    Scene,
    condition,
    coulomb,
    force,
    gravity,
    parameters,
    reaction,
)
from mechanics.simulate import Ending
from systems import cartpole_friction

x, phi, f = dynamicsymbols("x phi f")
m, r, g, mu = parameters("m r g mu", units="kg m m/s^2 1", typical="2 0.3 9.81 0.2")


def hoop() -> Scene:
    ground, origin = ReferenceFrame("N"), Point("O")
    turning = ground.orientnew("A", "Axis", (phi, ground.z))
    centre = origin.locatenew("C", x * ground.x + r * ground.y)
    foot = centre.locatenew("P", -r * ground.y)
    return Scene(
        "hoop",
        ground,
        origin,
        coordinates=(x, phi),
        bodies=(RigidBody("hoop", centre, turning, m, m * r**2),),
        loads=(
            gravity(-g * ground.y),
            coulomb("floor", "R", ground.x, x.diff() + r * phi.diff(), mu),
            force("f", centre, f * ground.y, on="hoop"),
        ),
        reactions=(reaction("R", foot, "hoop", None, ground.y),),
        inputs=(f,),
        conditions=(condition("contact", Symbol("R", real=True) > 0, "lifts off"),),
    )


@pytest.fixture(scope="module")
def rolling() -> Model:
    return compile(derive(hoop(), "kane"))


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_slipping_ends_when_the_textbook_says(rolling: Model, side: float) -> None:
    v0, w0 = 2.0 * side, 1.0 * side
    found = simulate(rolling, 3.0, initial={"x_dot": v0, "phi_dot": w0 / 0.3}, samples=301)
    assert found.ending is Ending.LEFT_DOMAIN
    (crossing,) = found.crossings
    assert crossing.condition == "sliding of floor"
    # The last step holds the jump of the friction, so that its interpolant is less smooth.
    assert crossing.time == pytest.approx(abs(v0 + w0) / (2 * 0.2 * 9.81), rel=1e-8)
    assert "comes to rest where load floor rubs, and sticking is not modelled" in found.reason
    expected = v0 - side * 0.2 * 9.81 * found.times
    np.testing.assert_allclose(found.speeds["x_dot"], expected, rtol=0, atol=1e-9)
    assert not found.conservative
    assert (np.diff(found.total) < 0).all()


def test_the_contact_opens_before(rolling: Model) -> None:
    lifted = simulate(rolling, 1.0, initial={"x_dot": 9.0}, inputs={"f": lambda t: 40 * t})
    (crossing,) = lifted.crossings
    assert crossing.condition == "contact" and "lifts off" in crossing.sentence
    assert crossing.time == pytest.approx(2 * 9.81 / 40, rel=1e-9)


def test_a_start_without_sliding_is_refused(rolling: Model) -> None:
    with pytest.raises(InputError, match=r"outside of the domain.*sticking is not modelled"):
        simulate(rolling, 1.0, initial={"x_dot": 0.3, "phi_dot": -1.0})
    with pytest.raises(InputError, match="lifts off"):
        simulate(rolling, 1.0, initial={"x_dot": 1.0}, inputs={"f": 30.0})


def test_beyond_the_domain_the_sign_of_zero_is_zero(rolling: Model) -> None:
    found = simulate(rolling, 0.1, initial={"phi_dot": 0.0}, beyond_domain=True)
    assert found.ending is Ending.COMPLETE
    assert np.abs(found.speeds["x_dot"]).max() == 0.0


def test_what_does_not_watch_sliding_refuses(rolling: Model, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="conditions of validity, which an ensemble does not"):
        ensemble(rolling, 1.0, initial={"x_dot": [1.0, 2.0]})
    with pytest.raises(InputError, match=r"load floor is friction .* a unit does not watch"):
        write_fmu(rolling, tmp_path / "hoop.fmu", initial={"x_dot": 1.0})
    with pytest.raises(InputError, match=r"no slope at the operating point"):
        linearize(rolling.equations, {"x": 0, "phi": 0}, {"f": 0})
    with pytest.raises(ExpressionError, match="operation sign has no Taylor series"):
        simulate(rolling, 0.1, initial={"x_dot": 2.0}, accuracy=1e-6)


def test_other_accelerations_have_no_inverse_dynamics(rolling: Model) -> None:
    assert "inverse_dynamics" not in tuple(rolling.casadi)
    with pytest.raises(InputError, match="inverse_dynamics"):
        rolling.inverse_dynamics([0, 0], [1, 0], [0, 0])


@pytest.mark.campaign
def test_the_cart_slows_down_and_stops() -> None:
    model = compile(derive(cartpole_friction.scene(), "kane"))
    found = simulate(model, 5.0, samples=501)
    assert found.ending is Ending.LEFT_DOMAIN
    assert (np.diff(found.total) < 0).all()
    assert found.speeds["x_dot"].min() > 0

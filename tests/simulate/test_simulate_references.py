"""Motions with a known solution, computed elsewhere to twenty digits and typed in here."""

import numpy as np
import pytest
from particles import hanging
from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.compiled.model import Model, compile
from mechanics.routes.derivation import by_route
from mechanics.scene import Particle, RigidBody, Scene, gravity, parameters, reaction
from mechanics.simulate import simulate

FINE = {"rtol": 1e-12, "atol": 1e-13}
g, l, m = parameters("g l m", units="m/s^2 m kg", typical="9.81 1 1")

# x, y of a point mass, L = 1, g = 9.81, released at x = -1, y = 0: elliptic functions (mpmath).
PENDULUM = {
    1.0: (0.98629175113187531936, -0.16501085312554116875),
    5.0: (-0.9423054350437573355, -0.33475433841400058079),
    9.99: (-0.31643646991303229123, -0.94861370457577651925),
    10.0: (-0.27508746257611686005, -0.96141920509912506427),
}
# Period over that of small swings, by amplitude in degrees: 2 K(sin^2(a/2)) / pi.
PERIODS = {
    10: 1.001907188143216607,
    60: 1.0731820071493643751,
    90: 1.180340599016096226,
    150: 1.7622037295037560279,
    179: 3.9010651603890857349,
}
# th1, th2, w1, w2 of two point masses of 1 kg on massless rods of 1 m, both released horizontal:
# extrapolation of order 36, two step sizes agree to 1e-20.
DOUBLE = {
    1.0: (
        -0.625087699806390629954,
        -1.03458508568001234061,
        -3.92227957288797661687,
        -1.30309924869633124332,
    ),
    2.0: (
        -0.482971534251754377449,
        -1.32404871230236254879,
        3.06528819207340131517,
        2.94927154757161898304,
    ),
    5.0: (
        -0.627186705066530730138,
        -1.30131555020981167791,
        2.12540867384291065065,
        3.88188872726560743925,
    ),
}
# Angular velocity in the body, I = (1, 2, 3), from (0.5, 0, 2): Jacobi's elliptic functions.
FREE_BODY = {
    1.0: (-0.20240223177609731442, 0.45720163666817180651, 1.9825040280268406908),
    2.0: (-0.3337113557432839851, -0.37233953731504174335, 1.9884133766189917212),
    5.0: (-0.43264338549432787519, -0.25063858639085563657, 1.9947581556847096977),
    10.0: (0.24970738984543233953, 0.43318150867342118592, 1.9843012019804703972),
}


def chain(links: int) -> Scene:
    """Point masses on massless rods under a fixed pivot, absolute angles from hanging."""
    return hanging(f"{links} point masses", dynamicsymbols(f"th1:{links + 1}"), m, l, g, "S")


def torque_free() -> Scene:
    """A body held at its mass centre; the speeds are its angular velocity in itself."""
    a, b, c, w1, w2, w3 = dynamicsymbols("a b c w1 w2 w3")
    ground, centre = ReferenceFrame("N"), Point("C")
    body = ground.orientnew("B", "Body", (a, b, c), "123")
    reactions = [
        reaction(f"T{i}", at=centre, on="body", by=None, along=axis)
        for i, axis in enumerate(ground)
    ]
    return Scene(
        "free body",
        ground,
        centre,
        coordinates=(a, b, c),
        speeds=(
            (w1, a.diff() * cos(b) * cos(c) + b.diff() * sin(c)),
            (w2, -a.diff() * cos(b) * sin(c) + b.diff() * cos(c)),
            (w3, a.diff() * sin(b) + c.diff()),
        ),
        bodies=(RigidBody("body", centre, body, m, inertia(body, 1, 2, 3)),),
        reactions=tuple(reactions),
    )


@pytest.fixture(scope="module")
def pendulum() -> Model:
    return compile(by_route("lagrange", chain(1)), compiler=None)


@pytest.mark.parametrize(("time", "position"), PENDULUM.items())
def test_simple_pendulum_is_where_elliptic_functions_put_it(
    pendulum: Model, time: float, position: tuple[float, float]
) -> None:
    motion = simulate(pendulum, time, initial={"th1": -np.pi / 2}, samples=2, **FINE)
    angle = motion.coordinates["th1"][-1]
    assert np.allclose((np.sin(angle), -np.cos(angle)), position, rtol=0, atol=2e-11)


@pytest.mark.parametrize(("degrees", "ratio"), PERIODS.items())
def test_simple_pendulum_returns_after_its_period(
    pendulum: Model, degrees: int, ratio: float
) -> None:
    amplitude, period = np.radians(degrees), ratio * 2 * np.pi * np.sqrt(1 / 9.81)
    motion = simulate(pendulum, period, initial={"th1": amplitude}, samples=5, **FINE)
    assert abs(motion.coordinates["th1"][-1] - amplitude) < 1e-9
    # A quarter of a period after release it passes below the pivot.
    assert abs(motion.coordinates["th1"][1]) < 1e-9


@pytest.mark.campaign
def test_double_pendulum_follows_the_reference() -> None:
    model = compile(by_route("lagrange", chain(2)), compiler=None)
    start = {"th1": np.pi / 2, "th2": np.pi / 2}
    motion = simulate(model, 5.0, initial=start, samples=6, **FINE)
    columns = np.array([*motion.coordinates.values(), *motion.speeds.values()])
    found = {time: columns[:, i] for i, time in enumerate(motion.times)}
    for time, expected in DOUBLE.items():
        assert np.allclose(found[time], expected, rtol=0, atol=1e-8)


def test_body_without_torque_tumbles_as_jacobi_says() -> None:
    model = compile(by_route("lagrange", torque_free()), compiler=None)
    motion = simulate(model, 10.0, initial={"w1": 0.5, "w3": 2.0}, samples=11, **FINE)
    columns = np.array([*motion.speeds.values()])
    found = {time: columns[:, i] for i, time in enumerate(motion.times)}
    for time, expected in FREE_BODY.items():
        assert np.allclose(found[time], expected, rtol=0, atol=1e-10)


@pytest.mark.parametrize("method", ["RK45", "Radau", "BDF", "LSODA"])
def test_every_solver_gives_the_same_motion(pendulum: Model, method: str) -> None:
    motion = simulate(
        pendulum, 1.0, initial={"th1": -np.pi / 2}, samples=2, method=method, rtol=1e-8, atol=1e-10
    )
    angle = motion.coordinates["th1"][-1]
    assert np.allclose((np.sin(angle), -np.cos(angle)), PENDULUM[1.0], rtol=0, atol=1e-5)


def test_projectile_falls_freely() -> None:
    # A projectile: a point mass with two coordinates, x = v t, y = -g t^2 / 2.
    x, y = dynamicsymbols("x y")
    ground, origin = ReferenceFrame("N"), Point("O")
    ball = origin.locatenew("P", x * ground.x + y * ground.y)
    scene = Scene(
        "projectile",
        ground,
        origin,
        coordinates=(x, y),
        bodies=(Particle("ball", ball, m),),
        loads=(gravity(-g * ground.y),),
    )
    motion = simulate(
        compile(by_route("lagrange", scene), compiler=None), 2.0, initial={"x_dot": 3.0}
    )
    assert np.allclose(motion.coordinates["x"], 3.0 * motion.times, atol=1e-12)
    assert np.allclose(motion.coordinates["y"], -9.81 / 2 * motion.times**2, atol=1e-12)

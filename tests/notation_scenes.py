"""Small scenes on which notations are tried: a pendulum, oscillators, an arm of two links."""

from functools import cache

import particles
from sympy import Abs, Symbol, cos
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

import mechanics
from mechanics.equations import Equations
from mechanics.judge.check import derived
from mechanics.report.answer.check import Check
from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    force,
    gravity,
    parameters,
    reaction,
    spring,
    torque,
)
from systems import double_pendulum

TIME = dynamicsymbols._t


def oscillator() -> Scene:
    """A mass on a spring and damper, driven by F0 cos(omega t)."""
    m, k, c, F0, omega = parameters(
        "m k c F0 omega", units="kg N/m N*s/m N 1/s", typical="1 2 0.1 3 1.5"
    )
    x = dynamicsymbols("x")
    return _slider("oscillator", m, F0 * cos(omega * TIME) - k * x - c * x.diff())


def drag() -> Scene:
    """A mass on a spring, with a drag that is quadratic in its speed."""
    m, c, k = parameters("m c k", units="kg kg/m N/m", typical="1 2 3")
    x = dynamicsymbols("x")
    return _slider("drag", m, -k * x - c * x.diff() * Abs(x.diff()))


def _slider(name: str, mass: Symbol, along) -> Scene:
    x = dynamicsymbols("x")
    return particles.on_line(
        name, x, mass, lambda N, O, P: [force("drive", P, along * N.x)], example={"x": 0.3}
    )


def swinging() -> Scene:
    """A mass on a spring that swings, in polar coordinates."""
    r, theta = dynamicsymbols("r theta")
    m, k, g = parameters("m k g", units="kg N/m m/s^2", typical="1 20 9.81")
    ground = ReferenceFrame("N")
    arm = ground.orientnew("A", "Axis", (theta, ground.z))
    origin = Point("O")
    mass = origin.locatenew("P", -r * arm.y)
    return Scene(
        "spring pendulum", ground, origin, coordinates=(r, theta),
        bodies=(Particle("mass", mass, m),),
        loads=(gravity(-g * ground.y), spring("k", origin, mass, k)),
    )  # fmt: skip


def arm() -> Scene:
    """Two links without inertia in a vertical plane, theta2 counted from the first."""
    theta1, theta2, tau1, tau2 = dynamicsymbols("theta1 theta2 tau1 tau2")
    m1, m2, l1, l2, g = parameters("m1 m2 l1 l2 g", units="kg kg m m m/s^2", typical="1 2 1 1 9.81")
    N, O = ReferenceFrame("N"), Point("O")
    first = N.orientnew("A", "Axis", (theta1, N.z))
    second = first.orientnew("B", "Axis", (theta2, N.z))
    elbow = O.locatenew("P", l1 * first.x)
    hand = elbow.locatenew("Q", l2 * second.x)
    return Scene(
        "arm", N, O, coordinates=(theta1, theta2),
        bodies=(RigidBody("one", elbow, first, m1, 0), RigidBody("two", hand, second, m2, 0)),
        loads=(
            gravity(-g * N.y),
            torque("tau1", tau1 * N.z, on="one"),
            torque("tau2", tau2 * N.z, on="two", by="one"),
        ),
        reactions=(
            reaction("X1", at=O, on="one", by=None, along=N.x),
            reaction("Y1", at=O, on="one", by=None, along=N.y),
            reaction("X2", at=elbow, on="two", by="one", along=N.x),
            reaction("Y2", at=elbow, on="two", by="one", along=N.y),
        ),
        inputs=(tau1, tau2), example={"theta1": 0.3},
    )  # fmt: skip


SCENES = {
    "pendulum": lambda: particles.pendulum(names="m l g", example={"theta": 0.3}),
    "oscillator": oscillator, "drag": drag, "arm": arm,
    "double": double_pendulum.scene,
}  # fmt: skip


@cache
def truth(name: str) -> Equations:
    """Equations of a scene, by its name."""
    return derived(SCENES[name]())


def judged(name: str, text: str, **options: object) -> Check:
    """What is said of a text on a scene."""
    return mechanics.check(truth(name), text, **{"blame": False, **options})  # type: ignore[arg-type]


def verdicts(name: str, text: str, **options: object) -> list[str]:
    """Verdicts on the statements of a text."""
    return [e.finding.verdict.name for e in judged(name, text, **options).judged]

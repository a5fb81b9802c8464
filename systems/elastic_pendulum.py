"""Pendulum on an elastic support: seed document, problem 1."""

from sympy import Expr, Integer
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import Particle, RigidBody, Scene, gravity, parameters, reaction, spring
from mechanics.scene.composite import part
from mechanics.scene.shapes import Rod

x, theta = dynamicsymbols("x theta")
M, m, L, k, g = parameters(
    "M m L k g",
    units="kg kg m N/m m/s^2",
    typical="1 1 1 10 9.81",
    meanings=(
        "mass of the pendulum",
        "mass of the carriage",
        "length of the pendulum",
        "stiffness of each of the two springs",
        "acceleration of gravity",
    ),
)
(I_C,) = parameters("I_C", units="kg*m^2", meanings=("inertia of the pendulum about C",))
PENDULUM = part(Rod(L), mass=M)


def scene() -> Scene:
    """A carriage between two springs on a rod; a uniform rod hangs from it by a pivot B."""
    return _scene("pendulum on elastic support", m)


def massless() -> Scene:
    """The same with a carriage that has no mass: the mass matrix stays regular."""
    return _scene("pendulum on elastic support without mass", Integer(0))


def _scene(name: str, carriage: Expr) -> Scene:
    ground = ReferenceFrame("N")
    rod = ground.orientnew("A", "Axis", (theta, ground.z))
    origin = Point("O")
    pivot = origin.locatenew("B", x * ground.x)
    centre = pivot.locatenew("C", -L / 2 * rod.y)
    return Scene(
        name,
        ground,
        origin,
        coordinates=(x, theta),
        bodies=(
            Particle("carriage", pivot, carriage),
            RigidBody("pendulum", centre, rod, M, PENDULUM.inertia),
        ),
        loads=(gravity(-g * ground.y), spring("k", origin, pivot, 2 * k, along=ground.x)),
        reactions=(
            reaction("T", at=pivot, on="carriage", by="pendulum", along=ground.x),
            reaction("N", at=pivot, on="pendulum", by="carriage", along=ground.y),
            reaction("N1", at=pivot, on="carriage", by=None, along=ground.y),
        ),
        definitions={I_C: PENDULUM.inertia},
        example={"x": 0.1, "theta": 2.5},
    )

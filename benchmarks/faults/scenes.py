"""Scenes over which faults are planted."""

from collections.abc import Callable
from functools import partial

from sympy import Rational, cos, pi, sin, sqrt
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.scene import (
    Particle,
    RigidBody,
    Scene,
    force,
    gravity,
    parameters,
    reaction,
    reaction_couple,
    spring,
    torque,
)
from mechanics.scene.composite import composite, part
from mechanics.scene.loads import damper, torsion_spring
from mechanics.scene.shapes import Disc, Rectangle, Ring, Rod, Semidisc
from systems import (
    cartpole_friction,
    elastic_pendulum,
    four_bar,
    rocker,
    rolling_disc,
    two_mass_chain,
)


def plate() -> Scene:
    """A pendulum cut from every shape, on a support moved by hand; a bead slides along it."""
    R, rho, g = parameters("R rho g")
    theta, s, y = dynamicsymbols("theta s y")
    cut = composite(
        (
            part(Rectangle(2 * R, R), density=rho, at=(R, 0), angle=pi / 6),
            part(Disc(R), density=rho, at=(0, R)),
            part(Semidisc(R), density=2 * rho, at=(R, R), angle=pi / 3),
            part(Ring(R / 2), density=rho * R),
            part(Rod(R), mass=rho * R**2, at=(0, -R)),
        )
    )
    N, O = ReferenceFrame("N"), Point("O")
    frame = N.orientnew("A", "Axis", (theta, N.z))
    pivot = O.locatenew("P", y * N.x)
    x_c, y_c = cut.centroid
    centre = O.locatenew("C", y * N.x + x_c * frame.x + y_c * frame.y)
    bead = pivot.locatenew("D", s * frame.x + R * frame.y)
    return Scene(
        "plate", N, O, coordinates=(theta, s), inputs=(y,),
        bodies=(
            RigidBody("plate", centre, frame, cut.mass, cut.inertia),
            Particle("bead", bead, rho * R**2),
        ),
        loads=(gravity(-g * N.y),),
        reactions=(
            reaction("X", at=pivot, on="plate", by=None, along=N.x),
            reaction("Y", at=pivot, on="plate", by=None, along=N.y),
            reaction("B", at=bead, on="bead", by="plate", along=frame.y),
        ),
    )  # fmt: skip


def arm(count: int = 3) -> Scene:
    """Turning joints in space with a quarter turn between two of them; every kind of load."""
    m, L, k, c, g, A, B, C = parameters("m L k c g A B C")
    angles = dynamicsymbols(f"q1:{count + 1}")
    tau, f = dynamicsymbols("tau f")
    N, O = ReferenceFrame("N"), Point("O")
    frame, pivot, inner = N, O, None
    bodies, reactions = [], []
    for i, angle in enumerate(angles, 1):
        if i == 2:
            frame = frame.orientnew(f"F{i}", "Axis", (pi / 2, frame.x))
        frame = frame.orientnew(f"B{i}", "Axis", (angle, frame.z))
        name, axes = f"link{i}", (("x", frame.x), ("y", frame.y), ("z", frame.z))
        centre = pivot.locatenew(f"C{i}", L / 2 * frame.x)
        bodies.append(RigidBody(name, centre, frame, m, inertia(frame, A, B, C)))
        reactions += [
            *(reaction(f"R{x}{i}", at=pivot, on=name, by=inner, along=e) for x, e in axes),
            *(reaction_couple(f"Q{x}{i}", on=name, by=inner, along=e) for x, e in axes[:2]),
        ]
        pivot, inner = pivot.locatenew(f"P{i}", L * frame.x), name
    one, two, three = bodies[0], bodies[-2], bodies[-1]
    return Scene(
        "arm in space", N, O, coordinates=angles, inputs=(tau, f), bodies=tuple(bodies),
        loads=(
            gravity(-g * N.y),
            torque("tau", tau * two.frame.z, on=two.name, by=f"link{count - 2}"),
            force("f", pivot, f * two.frame.x, on=three.name),
            spring("k", O, three.centre, k, length=L / 3),
            damper("c", one.centre, three.centre, c),
            torsion_spring("t", angles[-1], three.frame.z, k * L**2, on=three.name, by=two.name),
        ),
        reactions=tuple(reactions),
    )  # fmt: skip


def trammel() -> Scene:
    """A rod whose end and mass centre slide along oblique lines; a speed that is no rate."""
    a, b, k, m, A, g, f = parameters("a b k m A g f")
    theta, u = dynamicsymbols("theta u")
    N, O = ReferenceFrame("N"), Point("O")
    rod = N.orientnew("B", "Axis", (theta, N.z))
    one, two = (N.x - N.y) / sqrt(2), (N.x + N.y) / sqrt(2)
    start = O.locatenew("S", (b + Rational(1, 2)) * N.y)
    end = start.locatenew("E", a * cos(theta) * one + b * two)
    centre = start.locatenew("C", (b - a * sin(theta)) * two)
    return Scene(
        "trammel", N, O, coordinates=(theta,), speeds=((u, 2 * theta.diff()),),
        bodies=(RigidBody("rod", centre, rod, m, A),),
        loads=(
            gravity(-g * N.y),
            spring("k", O, centre, k, length=a),
            force("f", end, f * one, on="rod"),
        ),
        reactions=(
            reaction("R1", at=end, on="rod", by=None, along=two),
            reaction("R2", at=centre, on="rod", by=None, along=one),
        ),
    )  # fmt: skip


SEED = ("elastic_pendulum", "rocker", "two_mass_chain")
SCENES: dict[str, Callable[[], Scene]] = {
    "elastic_pendulum": elastic_pendulum.scene,
    "rocker": rocker.scene,
    "two_mass_chain": two_mass_chain.scene,
    "rolling_disc": rolling_disc.scene,
    "four_bar": four_bar.scene,
    "cartpole_friction": cartpole_friction.scene,
    "plate": plate,
    "trammel": trammel,
    "arm": arm,
    "arm of programs": partial(arm, 4),
}

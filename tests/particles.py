"""One particle, or a chain of them on rods without mass: the scenes that most tests need."""

from collections.abc import Callable, Iterable
from typing import Any

from sympy import Expr, Symbol, cos
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import Particle, Scene, force, gravity, parameters, reaction, spring

Loads = Callable[[ReferenceFrame, Point, Point], Iterable[Any]]
"""Loads of the inertial frame, its origin and where the particle is."""


def on_line(
    name: str, x: Expr, m: Symbol, loads: Loads, *, body: str = "mass", **fields: Any
) -> Scene:
    """A particle at x along the first axis."""
    N, O = ReferenceFrame("N"), Point("O")
    place = O.locatenew("P", x * N.x)
    return Scene(
        name, N, O, coordinates=(x,), bodies=(Particle(body, place, m),),
        loads=tuple(loads(N, O, place)), **fields,
    )  # fmt: skip


def pushed() -> Scene:
    """A point mass that is pushed with F cos(3 t): x = F (1 - cos 3 t) / (9 m)."""
    x, t = dynamicsymbols("x"), dynamicsymbols._t
    m, F = parameters("m F", units="kg N", typical="2 5")
    push = F * cos(3 * t)
    return on_line("pushed", x, m, lambda N, O, P: [force("push", P, push * N.x, on="mass")])


def pendulum(
    units: str = "kg m m/s^2", typical: str = "1 1 9.81", names: str = "m L g",
    tension: str = "S", **fields: Any,
) -> Scene:  # fmt: skip
    """A bob on a rod without mass; theta from the bottom, the tension pulls it inwards."""
    theta, (m, L, g) = dynamicsymbols("theta"), parameters(names, units=units, typical=typical)
    return hanging("pendulum", [theta], m, L, g, tension, **fields)


def on_a_spring() -> Scene:
    """A bob on a spring, by the length r and the angle: no typical state is declared."""
    theta, r = dynamicsymbols("theta r")
    units, typical = "kg N/m m m/s^2", "1 40 0.5 9.81"
    m, k, l, g = parameters("m k l g", units=units, typical=typical)
    N, O = ReferenceFrame("N"), Point("O")
    arm = N.orientnew("A", "Axis", (theta, N.z))
    place = O.locatenew("P", -r * arm.y)
    return Scene(
        "spring pendulum", N, O, coordinates=(theta, r), bodies=(Particle("bob", place, m),),
        loads=(gravity(-g * N.y), spring("k", O, place, k, length=l, second_on="bob")),
    )  # fmt: skip


def hanging(
    name: str, angles: Iterable[Expr], m: Symbol, L: Expr, g: Symbol, tension: str, **fields: Any
) -> Scene:
    """Particles on rods below each other, each angle from the vertical."""
    N, O = ReferenceFrame("N"), Point("O")
    tip, inner, bodies, reactions = O, None, list[Particle](), list[Any]()
    for i, angle in enumerate(angles):
        rod = N.orientnew(f"A{i}", "Axis", (angle, N.z))
        tip = tip.locatenew(f"P{i}", -L * rod.y)
        bob = f"bob{i or ''}"
        bodies.append(Particle(bob, tip, m))
        reactions.append(reaction(f"{tension}{i or ''}", at=tip, on=bob, by=inner, along=rod.y))
        inner = bob
    return Scene(
        name, N, O, coordinates=tuple(angles), bodies=tuple(bodies),
        loads=(gravity(-g * N.y),), reactions=tuple(reactions), **fields,
    )  # fmt: skip

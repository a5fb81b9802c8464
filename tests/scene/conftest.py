"""A small right scene, and copies of it with something changed."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import pytest
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.checks.admissible import check_scene
from mechanics.scene import Particle, RigidBody, Scene, gravity, parameters, reaction, spring

x, theta = dynamicsymbols("x theta")
m, M, L, k, g = parameters("m M L k g")


@dataclass(frozen=True)
class Parts:
    """Frames, points and fields of the pendulum on a carriage, for changes to refer to."""

    N: ReferenceFrame
    A: ReferenceFrame
    O: Point
    B: Point
    C: Point
    fields: dict[str, Any]

    def __getattr__(self, name: str) -> Any:
        return self.fields[name]


Change = Callable[[Parts], dict[str, Any]]


def pendulum(change: Change = lambda parts: {}) -> Scene:
    """A carriage on a rail with a pendulum, sound unless the change makes it wrong."""
    ground = ReferenceFrame("N")
    rod = ground.orientnew("A", "Axis", (theta, ground.z))
    origin = Point("O")
    pivot = origin.locatenew("B", x * ground.x)
    centre = pivot.locatenew("C", -L / 2 * rod.y)
    fields: dict[str, Any] = {
        "name": "pendulum",
        "frame": ground,
        "origin": origin,
        "coordinates": (x, theta),
        "bodies": (
            Particle("carriage", pivot, m),
            RigidBody("rod", centre, rod, M, M * L**2 / 12),
        ),
        "loads": (gravity(-g * ground.y), spring("k", origin, pivot, k, along=ground.x)),
        "reactions": (
            reaction("T", at=pivot, on="carriage", by="rod", along=ground.x),
            reaction("R", at=pivot, on="rod", by="carriage", along=ground.y),
            reaction("N1", at=pivot, on="carriage", by=None, along=ground.y),
        ),
    }
    fields |= change(Parts(ground, rod, origin, pivot, centre, dict(fields)))
    scene = Scene(**fields)
    check_scene(scene)
    return scene


@pytest.fixture(scope="session")
def make() -> Callable[[Change], Scene]:
    """The builder of changed copies: `make(lambda p: {field: value})`."""
    return pendulum

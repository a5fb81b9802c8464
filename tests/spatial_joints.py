"""Joints in space that scenes of the package do not have: hinges without couples, a rod that slides
through a point, two turns in one matrix.
"""

from sympy import Matrix, cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.scene import (
    RigidBody,
    Scene,
    force,
    gravity,
    parameters,
    reaction,
    reaction_couple,
)


def door() -> Scene:
    """A door on two hinges, which hold it by five forces and no couple."""
    theta = dynamicsymbols("theta")
    m, J, L, h, g = parameters("m J L h g")
    ground, origin = ReferenceFrame("N"), Point("O")
    leaf = ground.orientnew("D", "Axis", (theta, ground.z))
    upper = origin.locatenew("H", h * ground.z)
    centre = origin.locatenew("C", L * leaf.x + h / 2 * ground.z)
    forces = {"X1": (origin, leaf.x), "Y1": (origin, leaf.y), "Z1": (origin, leaf.z),
              "X2": (upper, leaf.x), "Y2": (upper, leaf.y)}  # fmt: skip
    return Scene(
        "door",
        ground,
        origin,
        coordinates=(theta,),
        bodies=(RigidBody("leaf", centre, leaf, m, inertia(leaf, J, 2 * J, J)),),
        loads=(gravity(-g * ground.z),),
        reactions=tuple(
            reaction(name, at=at, on="leaf", by=None, along=along)
            for name, (at, along) in forces.items()
        ),
    )


def telescope(oblique: bool) -> Scene:
    """A rod that turns about a point and slides through it; guides told in one frame or in two."""
    one, two, three, s = dynamicsymbols("a b c s")
    m, J, g = parameters("m J g")
    ground, origin = ReferenceFrame("N"), Point("O")
    outer = ground.orientnew("A", "Axis", (one, ground.x))
    inner = outer.orientnew("B", "Axis", (two, outer.y))
    rod = inner.orientnew("C", "Axis", (three, inner.z))
    centre = origin.locatenew("G", s * rod.z)
    across = (3 * inner.x + 4 * inner.y) / 5 if oblique else rod.y
    return Scene(
        "telescope",
        ground,
        origin,
        coordinates=(one, two, three, s),
        bodies=(RigidBody("rod", centre, rod, m, inertia(rod, J, J, J)),),
        loads=(gravity(-g * ground.z),),
        reactions=(
            reaction("X", at=origin, on="rod", by=None, along=rod.x),
            reaction("Y", at=origin, on="rod", by=None, along=across),
        ),
    )


def universal_joint() -> Scene:
    """A box on a cross: both turns declared in one matrix."""
    a, b, F = dynamicsymbols("a b F")
    m, J, L, g = parameters("m J L g")
    ground, origin = ReferenceFrame("N"), Point("O")
    box = ReferenceFrame("B")
    one = Matrix([[cos(a), 0, sin(a)], [0, 1, 0], [-sin(a), 0, cos(a)]])
    two = Matrix([[1, 0, 0], [0, cos(b), -sin(b)], [0, sin(b), cos(b)]])
    box.orient_explicit(ground, one * two)
    axes = (ground.x, ground.y, ground.z)
    arm, centre = origin.locatenew("P", L * box.x), origin.locatenew("C", L * box.z)
    return Scene(
        "universal joint", ground, origin, coordinates=(a, b), inputs=(F,),
        bodies=(RigidBody("box", centre, box, m, inertia(box, J, 2 * J, 3 * J)),),
        loads=(gravity(-g * ground.z), force("F", arm, F * box.y, on="box")),
        reactions=(
            *(reaction(f"X{i}", at=origin, on="box", by=None, along=e) for i, e in enumerate(axes)),
            reaction_couple("T", "box", None, ground.y.cross(box.x)),
        ),
    )  # fmt: skip

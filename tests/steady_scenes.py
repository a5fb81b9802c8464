"""Scenes with steady motions that are in every textbook."""

from sympy import Expr, Symbol
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics.scene import Particle, RigidBody, Scene, gravity, parameters, reaction, spring

A, C, m, L, g, k, d, r = parameters(
    "A C m L g k d r",
    units="kg*m^2 kg*m^2 kg m m/s^2 N/m kg*m^2 m",
    typical="0.3 0.1 2 0.2 9.81 500 0.05 0.5",
)
a, b, c, x, y, psi = dynamicsymbols("a b c x y psi")
OMEGA = Symbol("Omega", positive=True)


def top(turns: str) -> Scene:
    """A symmetric top on its tip; A is its moment of inertia about an axis across it at the tip.

    ``turns`` are the axes of its three turns: "zxz" is singular upright, "xyz" is not.
    """
    ground, tip = ReferenceFrame("N"), Point("O")
    frame = ground
    for number, (axis, angle) in enumerate(zip(turns, (a, b, c), strict=True)):
        frame = frame.orientnew(f"F{number}", "Axis", (angle, getattr(frame, axis)))
    centre = tip.locatenew("P", L * frame.z)
    across = A - m * L**2
    return Scene(
        f"top {turns}",
        ground,
        tip,
        coordinates=(a, b, c),
        bodies=(RigidBody("top", centre, frame, m, inertia(frame, across, across, C)),),
        loads=(gravity(-g * ground.z),),
        reactions=tuple(
            reaction(f"R{axis}", at=tip, on="top", by=None, along=getattr(ground, axis))
            for axis in "xyz"
        ),
    )


def rotor() -> Scene:
    """A disc in the middle of a light shaft on springs: it moves by x, y and tilts by a, b.

    d is its moment of inertia across the axle, C the one about it.
    """
    ground, bearing = ReferenceFrame("N"), Point("O")
    tilted = ground.orientnew("F1", "Axis", (a, ground.x))
    axle = tilted.orientnew("F2", "Axis", (b, tilted.y))
    disc = axle.orientnew("F3", "Axis", (c, axle.z))
    centre = bearing.locatenew("P", x * ground.x + y * ground.y)
    ends = [centre.locatenew(f"E{sign}", sign * L * axle.z) for sign in (1, -1)]
    posts = [bearing.locatenew(f"B{sign}", sign * L * ground.z) for sign in (1, -1)]
    pairs = list(zip(posts, ends, strict=True))
    return Scene(
        "rotor",
        ground,
        bearing,
        coordinates=(x, y, a, b, c),
        bodies=(RigidBody("disc", centre, disc, m, inertia(disc, d, d, C)),),
        loads=tuple(
            spring(f"k{axis}{n}", post, end, k, along=getattr(ground, axis), second_on="disc")
            for axis in "xy"
            for n, (post, end) in enumerate(pairs)
        ),
        reactions=(reaction("Nz", at=centre, on="disc", by=None, along=ground.z),),
    )


def bead(turn: Expr, inputs: tuple[Expr, ...] = ()) -> Scene:
    """A bead on a hoop that is turned about its vertical diameter; b from the bottom."""
    ground, centre = ReferenceFrame("N"), Point("O")
    hoop = ground.orientnew("H", "Axis", (turn, ground.z))
    arm = hoop.orientnew("B", "Axis", (b, hoop.y))
    place = centre.locatenew("P", -r * arm.z)
    return Scene(
        "bead on a hoop",
        ground,
        centre,
        coordinates=(b,),
        inputs=inputs,
        bodies=(Particle("bead", place, m),),
        loads=(gravity(-g * ground.z),),
        reactions=(
            reaction("across", at=place, on="bead", by=None, along=hoop.y),
            reaction("inward", at=place, on="bead", by=None, along=arm.z),
        ),
    )


def foucault() -> Scene:
    """A mass on two equal springs in a plane that turns with the angle psi, an input."""
    ground, centre = ReferenceFrame("N"), Point("O")
    table = ground.orientnew("T", "Axis", (psi, ground.z))
    place = centre.locatenew("P", x * table.x + y * table.y)
    return Scene(
        "mass on a turning table",
        ground,
        centre,
        coordinates=(x, y),
        inputs=(psi,),
        bodies=(Particle("mass", place, m),),
        loads=tuple(
            spring(f"k{axis}", centre, place, k, along=getattr(table, axis), second_on="mass")
            for axis in "xy"
        ),
        reactions=(reaction("Nz", at=place, on="mass", by=None, along=ground.z),),
    )

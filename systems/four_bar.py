"""Four-bar linkage: a closed loop of three uniform rods and the ground.

    l1 cos q1 + l2 cos q2 + l3 cos q3 = d
    l1 sin q1 + l2 sin q2 + l3 sin q3 = 0

The loop closure in the form in which textbooks of mechanisms write it, with all angles from the
ground to the rod, each rod followed from A to D. It is linear in all four lengths; l2 and l3 appear
in both rows, with the determinant sin(q3 - q2), which vanishes where coupler and rocker line up:
there the crank no longer tells the speeds of the others.
"""

from sympy import cos, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import RigidBody, Scene, gravity, holonomic, parameters, reaction, torque

q1, q2, q3 = dynamicsymbols("q1:4")
tau = dynamicsymbols("tau")
l1, l2, l3, d, m1, m2, m3, g = parameters(
    "l1 l2 l3 d m1 m2 m3 g",
    units="m m m m kg kg kg m/s^2",
    # The shortest and the longest together are shorter than the other two, so that the crank turns.
    typical="0.1 0.3 0.25 0.28 0.5 1.5 1.25 9.81",
    meanings=(
        "length of the crank AB",
        "length of the coupler BC",
        "length of the rocker CD",
        "distance of the ground pivots A and D",
        "mass of the crank",
        "mass of the coupler",
        "mass of the rocker",
        "acceleration of gravity",
    ),
)


def scene() -> Scene:
    """Crank, coupler and rocker in a vertical plane; the torque tau drives the crank."""
    ground = ReferenceFrame("N")
    origin = Point("A")
    pivot, inner = origin, None
    bodies, reactions = [], []
    for name, angle, length, mass, (horizontal, vertical) in (
        ("crank", q1, l1, m1, ("Ax", "Ay")),
        ("coupler", q2, l2, m2, ("Bx", "By")),
        ("rocker", q3, l3, m3, ("Cx", "Cy")),
    ):
        rod = ground.orientnew(name, "Axis", (angle, ground.z))
        centre = pivot.locatenew(f"centre of the {name}", length / 2 * rod.x)
        bodies.append(RigidBody(name, centre, rod, mass, mass * length**2 / 12))
        reactions += [
            reaction(horizontal, at=pivot, on=name, by=inner, along=ground.x),
            reaction(vertical, at=pivot, on=name, by=inner, along=ground.y),
        ]
        pivot, inner = pivot.locatenew(f"end of the {name}", length * rod.x), name
    reactions += [
        reaction("Dx", at=pivot, on="rocker", by=None, along=ground.x),
        reaction("Dy", at=pivot, on="rocker", by=None, along=ground.y),
    ]
    return Scene(
        "four-bar linkage",
        ground,
        origin,
        coordinates=(q1, q2, q3),
        bodies=tuple(bodies),
        loads=(gravity(-g * ground.y), torque("tau", tau * ground.z, on="crank")),
        reactions=tuple(reactions),
        constraints=(
            holonomic("closure along x", l1 * cos(q1) + l2 * cos(q2) + l3 * cos(q3) - d, "Dx"),
            holonomic("closure along y", l1 * sin(q1) + l2 * sin(q2) + l3 * sin(q3), "Dy"),
        ),
        inputs=(tau,),
        # Two assemblies close the loop at q1: the guess picks the one with the coupler above.
        example={"q1": 1.0, "q2": 0.5, "q3": -1.2, "q1_dot": 10.0},
    )

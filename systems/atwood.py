"""Double Atwood machine: a pulley that hangs on a rope carries another rope with two masses.

    x   depth of the first mass below the upper pulley, z that of the lower pulley
    y   depth of the second mass below the lower pulley, w that of the third

Pulleys have no mass. The equations are those of S. T. Thornton and J. B. Marion, "Classical
Dynamics of Particles and Systems", fifth edition (2004), example 7.8.
"""

from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

from mechanics.scene import Particle, Scene, gravity, parameters, rope
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion, KineticEnergy, PotentialEnergy

x, y, z, w = dynamicsymbols("x y z w")
m1, m2, m3, l1, l2, g = parameters(
    "m1 m2 m3 l1 l2 g",
    units="kg kg kg m m m/s^2",
    typical="4 1 2 3 2 9.81",
    meanings=(
        "mass that balances the lower pulley",
        "second mass",
        "third mass",
        "length of the upper rope",
        "length of the lower rope",
        "acceleration of gravity",
    ),
)


def scene() -> Scene:
    """All move up and down; each rope has one length and one tension."""
    ground, top = ReferenceFrame("N"), Point("O")
    depths = {"one": (x, m1), "pulley": (z, 0), "two": (z + y, m2), "three": (z + w, m3)}
    at = {name: top.locatenew(name, -depth * ground.y) for name, (depth, _) in depths.items()}
    lines = (ground.y, -ground.y)
    upper = rope("T1", ("one", at["one"]), (None, top), ("pulley", at["pulley"]),
                 length=l1, along=lines)  # fmt: skip
    lower = rope("T2", ("two", at["two"]), ("pulley", at["pulley"]), ("three", at["three"]),
                 length=l2, along=lines)  # fmt: skip
    return Scene(
        "double Atwood machine",
        ground,
        top,
        coordinates=(x, y, z, w),
        bodies=tuple(Particle(name, at[name], mass) for name, (_, mass) in depths.items()),
        joints=(upper, lower),
        loads=(gravity(-g * ground.y),),
        example={"x": 1.5, "y": 1.0, "z": 1.5, "w": 1.0},
    )


dx, dy = x.diff(), y.diff()

PUBLISHED = (
    published(
        "T",
        KineticEnergy(),
        m1 * dx**2 / 2 + m2 * (dy - dx) ** 2 / 2 + m3 * (-dx - dy) ** 2 / 2,
        label="kinetic energy",
    ),
    published(
        "U",
        PotentialEnergy(),
        -m1 * g * x - m2 * g * (l1 - x + y) - m3 * g * (l1 - x + l2 - y),
        label="potential energy",
    ),
    published(
        "x",
        EquationOfMotion(),
        m1 * dx.diff() + m2 * (dx.diff() - dy.diff()) + m3 * (dx.diff() + dy.diff()),
        (m1 - m2 - m3) * g,
        label="equation of motion of the upper rope",
        latex=(
            r"m_{1} \ddot{x}+m_{2}(\ddot{x}-\ddot{y})+m_{3}(\ddot{x}+\ddot{y})="
            r"\left(m_{1}-m_{2}-m_{3}\right) g"
        ),
    ),
    published(
        "y",
        EquationOfMotion(),
        -m2 * (dx.diff() - dy.diff()) + m3 * (dx.diff() + dy.diff()),
        (m2 - m3) * g,
        label="equation of motion of the lower rope",
        latex=(r"-m_{2}(\ddot{x}-\ddot{y})+m_{3}(\ddot{x}+\ddot{y})=\left(m_{2}-m_{3}\right) g"),
    ),
)

"""What a user declares: one mechanical system, in SymPy's own words."""

from mechanics.scene.bodies import Body, Particle, RigidBody
from mechanics.scene.conditions import Condition, condition
from mechanics.scene.euler import Euler, euler
from mechanics.scene.joints import (
    Joint,
    ball,
    cylindrical,
    free,
    pin,
    planar,
    slide,
    universal,
    weld,
)
from mechanics.scene.loads import (
    Coulomb,
    Damper,
    Force,
    Gravity,
    Load,
    Spring,
    Torque,
    TorsionSpring,
    coulomb,
    damper,
    force,
    gravity,
    spring,
    torque,
    torsion_spring,
)
from mechanics.scene.parameters import Parameter, parameters
from mechanics.scene.reactions import (
    Constraint,
    Reaction,
    holonomic,
    nonholonomic,
    reaction,
    reaction_couple,
)
from mechanics.scene.rotations import Rotation, quaternion
from mechanics.scene.scene import Scene

__all__ = [
    "Body",
    "Condition",
    "Constraint",
    "Coulomb",
    "Damper",
    "Euler",
    "Force",
    "Gravity",
    "Joint",
    "Load",
    "Parameter",
    "Particle",
    "Reaction",
    "RigidBody",
    "Rotation",
    "Scene",
    "Spring",
    "Torque",
    "TorsionSpring",
    "ball",
    "condition",
    "coulomb",
    "cylindrical",
    "damper",
    "euler",
    "force",
    "free",
    "gravity",
    "holonomic",
    "nonholonomic",
    "parameters",
    "pin",
    "planar",
    "quaternion",
    "reaction",
    "reaction_couple",
    "slide",
    "spring",
    "torque",
    "torsion_spring",
    "universal",
    "weld",
]

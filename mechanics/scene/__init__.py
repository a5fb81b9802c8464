"""What a user declares: one mechanical system, in SymPy's own words."""

from mechanics.scene.bodies import Body, Particle, RigidBody
from mechanics.scene.conditions import Condition, condition
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
    "Force",
    "Gravity",
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
    "condition",
    "coulomb",
    "damper",
    "force",
    "gravity",
    "holonomic",
    "nonholonomic",
    "parameters",
    "quaternion",
    "reaction",
    "reaction_couple",
    "spring",
    "torque",
    "torsion_spring",
]

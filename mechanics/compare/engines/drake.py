"""Drake's `MultibodyPlant`, on a file or on the tree as URDF."""

from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from mechanics.compare.engines import Engine
from mechanics.compare.order import Order
from mechanics.compare.ours import Ours
from mechanics.compare.quantities import Answer
from mechanics.compare.tree import Link, fixed_base, links, with_passive
from mechanics.compare.urdf import urdf
from mechanics.importers.decimals import Notes
from mechanics.importers.robot import ordered
from mechanics.importers.urdf import read_urdf


def make(drake: Any, ours: Ours, file: Path | None = None) -> Engine:
    """CalcMassMatrix, CalcInverseDynamics, CalcBiasTerm."""
    tree = fixed_base("drake", links(ours, file is None))
    plant = drake.MultibodyPlant(0.0)
    if file is None:
        drake.Parser(plant).AddModelsFromString(urdf(tree), "urdf")
        plant.mutable_gravity_field().set_gravity_vector(ours.gravity)
    else:
        drake.Parser(plant).AddModels(str(file))
    root = ordered(read_urdf(file, Notes()))[0] if file else "world_link"
    if plant.HasBodyNamed(root):
        plant.WeldFrames(plant.world_frame(), plant.GetFrameByName(root))
    plant.Finalize()
    joint = {link.joint: plant.GetJointByName(link.joint) for link in tree if link.v}
    at_q = {name: own.position_start() for name, own in joint.items()}
    at_v = {name: own.velocity_start() for name, own in joint.items()}
    order = Order(tree, at_q, at_v, (plant.num_positions(), plant.num_velocities()))
    context, world = plant.CreateDefaultContext(), plant.world_frame()

    def at(q: Any, v: Any) -> Any:
        B = order.matrix(q)
        plant.SetPositions(context, order.position(q))
        plant.SetVelocities(context, B @ v)
        return B

    def inverse(q: Any, v: Any, a: Any) -> Any:
        B, forces = at(q, v), drake.MultibodyForces_[float](plant)
        plant.CalcForceElementsContribution(context, forces)
        return B.T @ plant.CalcInverseDynamics(context, B @ a, forces)

    def mass_matrix(q: Any, v: Any) -> Any:
        B = at(q, v)
        return B.T @ plant.CalcMassMatrix(context) @ B

    def jacobian(link: Link) -> Any:
        frame = plant.GetBodyByName(link.name).body_frame()

        def of(q: Any, v: Any) -> Any:
            B = at(q, v)
            found = plant.CalcJacobianSpatialVelocity(
                context, drake.JacobianWrtVariable.kV, frame, np.zeros(3), world, world
            )
            return found[[3, 4, 5, 0, 1, 2]] @ B

        return of

    answers: dict[str, Answer] = {
        "mass_matrix": mass_matrix,
        "bias": lambda q, v: inverse(q, v, np.zeros_like(v)),
        "inverse_dynamics": inverse,
        "kinetic_energy": lambda q, v: (at(q, v), plant.CalcKineticEnergy(context))[1],
        "potential_energy": lambda q, v: (at(q, v), plant.CalcPotentialEnergy(context))[1],
    }
    answers |= {f"jacobian {link.name}": jacobian(link) for link in tree}
    return Engine(f"drake {version('drake')}", with_passive(answers, tree))

"""Pinocchio (package `pin`): joints and inertias by its own interface, or its readers of files."""

from pathlib import Path
from typing import Any

import numpy as np

from mechanics.compare.engines import Engine
from mechanics.compare.order import Order
from mechanics.compare.ours import Ours
from mechanics.compare.quantities import Answer
from mechanics.compare.tree import Link, links, with_passive

WORDS = {"pin": "RevoluteUnaligned", "slide": "PrismaticUnaligned", "ball": "Spherical",
         "planar": "Planar", "free": "FreeFlyer"}  # fmt: skip


def make(pin: Any, ours: Ours, file: Path | None = None) -> Engine:
    """Its algorithms: crba, rnea, aba."""
    tree = links(ours, file is None)
    if file is None:
        model = _from_tree(pin, tree)
        model.gravity.linear = ours.gravity
    else:
        model = (pin.buildModelFromMJCF if file.suffix == ".xml" else pin.buildModelFromUrdf)(file)
    names = [link.joint for link in tree if link.v]
    if missing := [name for name in names if not model.existJointName(name)]:
        raise ValueError(f"its model has no joint {', '.join(missing)}")
    own = {name: model.joints[model.getJointId(name)] for name in names}
    at_q, at_v = ({n: getattr(j, key) for n, j in own.items()} for key in ("idx_q", "idx_v"))
    circles = frozenset(name for name, joint in own.items() if joint.nq > joint.nv)
    order = Order(tree, at_q, at_v, (model.nq, model.nv), False, True, circles)
    data, place, basis = model.createData(), order.position, order.matrix

    def mass_matrix(q: Any, v: Any) -> Any:
        upper, B = np.triu(pin.crba(model, data, place(q))), basis(q)
        return B.T @ (upper + np.triu(upper, 1).T) @ B

    def inverse(q: Any, v: Any, a: Any) -> Any:
        B = basis(q)
        return B.T @ pin.rnea(model, data, place(q), B @ v, B @ a + order.drift(q, v))

    def forward(q: Any, v: Any, forces: Any) -> Any:
        B = basis(q)
        rates = pin.aba(model, data, place(q), B @ v, np.linalg.pinv(B.T) @ forces)
        return np.linalg.pinv(B) @ (rates - order.drift(q, v))

    def jacobian(link: Link) -> Answer:
        more = model.getFrameId(link.name), pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        return lambda q, v: pin.computeFrameJacobian(model, data, place(q), *more) @ basis(q)

    answers: dict[str, Answer] = {
        "mass_matrix": mass_matrix,
        "bias": lambda q, v: inverse(q, v, np.zeros_like(v)),
        "inverse_dynamics": inverse,
        "forward_dynamics": forward,
        "kinetic_energy": lambda q, v: pin.computeKineticEnergy(
            model, data, place(q), basis(q) @ v
        ),
        "potential_energy": lambda q, v: pin.computePotentialEnergy(model, data, place(q)),
        "momentum_matrix": lambda q, v: pin.ccrba(model, data, place(q), basis(q) @ v) @ basis(q),
    }
    answers |= {f"jacobian {x.name}": jacobian(x) for x in tree if model.existFrame(x.name)}
    return Engine(f"pinocchio {pin.__version__}", with_passive(answers, tree))


def _from_tree(pin: Any, tree: tuple[Link, ...]) -> Any:
    model, placed, still = pin.Model(), [(0, pin.SE3.Identity())], pin.SE3.Identity()
    for link in tree:
        joint, pose = placed[link.before + 1]
        pose = pose * pin.SE3(link.turn, link.offset)
        if link.kind != "weld":
            moved = getattr(pin, f"JointModel{WORDS[link.kind]}")
            moved = moved(link.axis) if link.kind in ("pin", "slide") else moved()
            joint, pose = model.addJoint(joint, moved, pose, link.joint), still
        model.appendBodyToJoint(joint, pin.Inertia(link.mass, link.centre, link.inertia), pose)
        model.addFrame(pin.Frame(link.name, joint, 0, pose, pin.FrameType.BODY))
        placed.append((joint, pose))
    return model

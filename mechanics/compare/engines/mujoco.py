"""MuJoCo: a model written as MJCF, or its own reader of URDF and MJCF.

Contacts, limits and dry friction are left out: they are not smooth.
"""

from pathlib import Path
from typing import Any

import numpy as np

from mechanics.compare.engines import Engine
from mechanics.compare.order import Order
from mechanics.compare.ours import Ours
from mechanics.compare.quantities import Answer
from mechanics.compare.tree import Link, links
from mechanics.compare.urdf import PLANAR, fill, mjcf

NOTES = ("contacts, limits, equalities and dry friction are left out",)


def make(mujoco: Any, ours: Ours, file: Path | None = None) -> Engine:
    """mj_forward, mj_inverse, mj_mulM and mj_jacBody."""
    tree = links(ours, file is None)
    if file is None:
        model = mujoco.MjModel.from_xml_string(mjcf(tree))
        fill(mujoco, model, tree)
        model.opt.gravity[:] = ours.gravity
    else:
        model = mujoco.MjModel.from_xml_path(str(file))
    for word in ("CONTACT", "LIMIT", "FRICTIONLOSS", "EQUALITY"):
        model.opt.disableflags |= getattr(mujoco.mjtDisableBit, f"mjDSBL_{word}")
    model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
    data, ends = mujoco.MjData(model), {"planar": PLANAR[0][0]}
    own = {k.joint: model.joint(k.joint + ends.get(k.kind, "")) for k in tree if k.v}
    at_q, at_v = ({n: int(getattr(j, e)[0]) for n, j in own.items()} for e in ("qposadr", "dofadr"))
    order = Order(tree, at_q, at_v, (model.nq, model.nv))

    def at(q: Any, v: Any, forces: Any = 0.0) -> Any:
        B = order.matrix(q)
        data.qpos[:], data.qvel[:] = order.position(q), B @ v
        data.qfrc_applied[:] = B @ forces if np.ndim(forces) else 0.0
        mujoco.mj_forward(model, data)
        return B

    def mass_matrix(q: Any, v: Any) -> Any:
        B, found = at(q, v), np.zeros((model.nv, model.nv))
        for column, unit in enumerate(np.eye(model.nv)):
            mujoco.mj_mulM(model, data, found[column], unit)
        return B.T @ found @ B

    def inverse(q: Any, v: Any, a: Any) -> Any:
        B = at(q, v)
        data.qacc[:] = B @ a
        mujoco.mj_inverse(model, data)
        return B.T @ data.qfrc_inverse

    def jacobian(link: Link) -> Any:
        def of(q: Any, v: Any) -> Any:
            B, found = at(q, v), np.zeros((6, model.nv))
            mujoco.mj_jacBody(model, data, found[:3], found[3:], model.body(link.name).id)
            return found @ B

        return of

    answers: dict[str, Answer] = {
        "mass_matrix": mass_matrix,
        "bias": lambda q, v: at(q, v).T @ (data.qfrc_bias - data.qfrc_passive),
        "inverse_dynamics": inverse,
        "forward_dynamics": lambda q, v, forces: at(q, v, forces).T @ data.qacc,
        "kinetic_energy": lambda q, v: (at(q, v), data.energy[1])[1],
        "potential_energy": lambda q, v: (at(q, v), data.energy[0])[1],
    }
    names = {model.body(k).name for k in range(model.nbody)}  # bodies that are fixed are merged
    answers |= {f"jacobian {k.name}": jacobian(k) for k in tree if k.name in names}
    return Engine(f"mujoco {mujoco.__version__}", answers, NOTES)

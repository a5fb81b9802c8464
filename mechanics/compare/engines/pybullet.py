"""PyBullet: a file, or the tree as URDF; what a file does not say is what Bullet takes."""

import tempfile
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from mechanics.compare.engines import Engine
from mechanics.compare.ours import Ours
from mechanics.compare.tree import Link, fixed_base, links, with_passive
from mechanics.compare.urdf import urdf


def make(pybullet: Any, ours: Ours, file: Path | None = None) -> Engine:
    """calculateMassMatrix, calculateInverseDynamics, calculateJacobian."""
    tree = fixed_base("pybullet", links(ours, file is None))
    client = pybullet.connect(pybullet.DIRECT)
    with tempfile.TemporaryDirectory(prefix="mechanics-") as folder:
        path = Path(folder) / "scene.urdf"
        path.write_text(urdf(tree), encoding="utf-8")
        flags = pybullet.URDF_USE_INERTIA_FROM_FILE
        body = pybullet.loadURDF(
            str(file or path), useFixedBase=True, flags=flags, physicsClientId=client
        )
    pybullet.setGravity(*ours.gravity, physicsClientId=client)
    table = [
        pybullet.getJointInfo(body, k, physicsClientId=client)
        for k in range(pybullet.getNumJoints(body, physicsClientId=client))
    ]
    place = {info[1].decode(): info[0] for info in table}
    # Bullet's own order: movable joints by their index.
    movable = [info[1].decode() for info in table if info[2] != pybullet.JOINT_FIXED]
    owner = {link.joint: link.v[0] for link in tree if link.v}
    order = [owner[name] for name in movable]
    back = np.argsort(order)

    def mass_matrix(q: Any, v: Any) -> Any:
        found = pybullet.calculateMassMatrix(body, [*q[order]], physicsClientId=client)
        return np.array(found)[np.ix_(back, back)]

    def inverse(q: Any, v: Any, a: Any) -> Any:
        given = ([*x[order]] for x in (q, v, a))
        found = pybullet.calculateInverseDynamics(body, *given, physicsClientId=client)
        return np.array(found)[back]

    def jacobian(link: Link) -> Any:
        index, local = place[link.joint], [0.0, 0.0, 0.0]

        def of(q: Any, v: Any) -> Any:
            still = [0.0] * len(order)
            linear, angular = pybullet.calculateJacobian(
                body, index, local, [*q[order]], still, still, physicsClientId=client
            )
            return np.vstack([linear, angular])[:, back]

        return of

    answers: dict[str, Any] = {
        "mass_matrix": mass_matrix,
        "bias": lambda q, v: inverse(q, v, np.zeros_like(v)),
        "inverse_dynamics": inverse,
    }
    answers |= {f"jacobian {link.name}": jacobian(link) for link in tree}
    return Engine(f"pybullet {version('pybullet')}", with_passive(answers, tree))

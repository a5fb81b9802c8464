"""Robotics Toolbox for Python: a robot of the file, or of the tree as URDF."""

import importlib.util
import tempfile
from importlib import import_module
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from mechanics.compare.engines import Engine
from mechanics.compare.ours import Ours
from mechanics.compare.tree import Link, fixed_base, links, with_passive
from mechanics.compare.urdf import urdf

READER = "roboticstoolbox.models.URDF.URDFRobot"


def make(roboticstoolbox: Any, ours: Ours, file: Path | None = None) -> Engine:
    """Robot.inertia, rne, accel, jacob0."""
    tree = fixed_base("roboticstoolbox", links(ours, file is None))
    with tempfile.TemporaryDirectory(prefix="mechanics-") as folder:
        path = Path(folder) / "scene.urdf"
        path.write_text(urdf(tree), encoding="utf-8")
        robot = _read(roboticstoolbox, str((file or path).resolve()))
    robot.gravity = ours.gravity
    owner = {link.name: link.v[0] for link in tree if link.v}
    place = {link.name: link.jindex for link in robot.links if link.isjoint}
    order = np.argsort([place[name] for name in owner])
    order = np.array([*owner.values()])[order]
    back = np.argsort(order)

    def inverse(q: Any, v: Any, a: Any) -> Any:
        return np.asarray(robot.rne(q[order], v[order], a[order])).ravel()[back]

    def mass_matrix(q: Any, v: Any) -> Any:
        return np.asarray(robot.inertia(q[order]))[np.ix_(back, back)]

    def forward(q: Any, v: Any, forces: Any) -> Any:
        return np.asarray(robot.accel(q[order], v[order], forces[order])).ravel()[back]

    def jacobian(link: Link) -> Any:
        def of(q: Any, v: Any) -> Any:
            found = np.zeros((6, len(order)))
            part = robot.jacob0(q[order], end=link.name)
            found[:, : part.shape[1]] = part
            return found[:, back]

        return of

    answers: dict[str, Any] = {
        "mass_matrix": mass_matrix,
        "bias": lambda q, v: inverse(q, v, np.zeros_like(v)),
        "inverse_dynamics": inverse,
        "forward_dynamics": forward,
    }
    if len({link.before for link in tree}) == len(tree):
        answers |= {f"jacobian {link.name}": jacobian(link) for link in tree}
    return Engine(
        f"roboticstoolbox {version('roboticstoolbox-python')}", with_passive(answers, tree)
    )


def _read(roboticstoolbox: Any, path: str) -> Any:
    """`Robot.URDF` is deprecated since there is this module."""
    if importlib.util.find_spec(READER) is None:
        return roboticstoolbox.Robot.URDF(path)
    parts, name, _ = import_module(READER).URDF_file(path)
    return roboticstoolbox.Robot(parts, name=name)

"""A tree as text that engines read: URDF, and MJCF."""

from typing import Any

import numpy as np

from mechanics.compare.change import Array
from mechanics.compare.tree import Link

STRAIGHT = 1e-9
"""Cosine of the pitch below which roll and yaw are one."""
PLANAR = (
    ("_TX", "slide", "1 0 0"), ("_TY", "slide", "0 1 0"), ("_RZ", "hinge", "0 0 1")
)  # fmt: skip
"""What MuJoCo makes of a planar joint of a URDF: ends of names, kinds and axes."""
UNIT = '<inertial pos="1 2 3" quat="1 2 3 4" mass="1" diaginertia="1 1 1"/>'
"""In nothing special, so that MuJoCo takes no short cut."""


def urdf(tree: tuple[Link, ...]) -> str:
    """The tree as URDF; a free link is the root, which a reader is told to leave free."""
    links_, joints = ['<link name="world"/>'], []
    for link in tree:
        entries = " ".join(
            f'i{"xyz"[i]}{"xyz"[k]}="{float(link.inertia[i, k])!r}"'
            for i in range(3)
            for k in range(i, 3)
        )
        links_.append(
            f'<link name="{link.name}"><inertial><origin xyz="{_text(link.centre)}" rpy="0 0 0"/>'
            f'<mass value="{link.mass!r}"/><inertia {entries}/></inertial></link>'
        )
        kind = {"pin": "continuous", "slide": "prismatic", "weld": "fixed", "free": "floating"}
        limit = '<limit lower="-100" upper="100" effort="1e9" velocity="1e9"/>'
        before = "world" if link.before < 0 else tree[link.before].name
        joints.append(
            f'<joint name="{link.joint}" type="{kind[link.kind]}"><parent link="{before}"/>'
            f'<child link="{link.name}"/><origin xyz="{_text(link.offset)}"'
            f' rpy="{_text(_angles(link.turn))}"/>'
            + (f'<axis xyz="{_text(link.axis)}"/>' if link.kind in ("pin", "slide") else "")
            + (limit if link.kind == "slide" else "")
            + "</joint>"
        )
    return '<robot name="scene">' + "".join((*links_, *joints)) + "</robot>"


def _text(values: Array) -> str:
    return " ".join(repr(float(value)) for value in values)


def _angles(turn: Array) -> Array:
    """Roll, pitch and yaw: R = Rz(yaw) Ry(pitch) Rx(roll)."""
    pitch = np.arctan2(-turn[2, 0], np.hypot(turn[2, 1], turn[2, 2]))
    if np.hypot(turn[2, 1], turn[2, 2]) < STRAIGHT:
        return np.array([0.0, pitch, np.arctan2(-turn[0, 1], turn[1, 1])])
    roll, yaw = np.arctan2(turn[2, 1], turn[2, 2]), np.arctan2(turn[1, 0], turn[0, 0])
    return np.array([roll, pitch, yaw])


def mjcf(tree: tuple[Link, ...]) -> str:
    """The tree as MJCF, each body with a unit inertia: the reader refuses many that are none."""

    def body(place: int) -> str:
        link = tree[place]
        numbers = " ".join(repr(float(e)) for e in link.axis)
        kinds = {"pin": f'type="hinge" axis="{numbers}"', "slide": f'type="slide" axis="{numbers}"'}
        kinds |= {kind: f'type="{kind}"' for kind in ("free", "ball")}
        joint = f'<joint name="{link.joint}" {kinds[link.kind]}/>' if link.kind in kinds else ""
        if link.kind == "planar":
            joint = "".join(
                f'<joint name="{link.joint}{end}" type="{kind}" axis="{axis}"/>'
                for end, kind, axis in PLANAR
            )
        inner = "".join(body(k) for k, other in enumerate(tree) if other.before == place)
        return f'<body name="{link.name}">{joint}{UNIT}{inner}</body>'

    roots = "".join(body(k) for k, link in enumerate(tree) if link.before < 0)
    return f'<mujoco><compiler angle="radian"/><worldbody>{roots}</worldbody></mujoco>'


def fill(mujoco: Any, model: Any, tree: tuple[Link, ...]) -> None:
    """The numbers of that model, where no reader rounds or balances them."""
    for link in tree:
        own = model.body(link.name).id
        moments, axes = np.linalg.eigh(link.inertia)
        axes[:, 2] *= np.sign(np.linalg.det(axes))
        model.body_pos[own] = link.offset
        mujoco.mju_mat2Quat(model.body_quat[own], link.turn.ravel())
        model.body_mass[own], model.body_inertia[own] = link.mass, moments
        model.body_ipos[own] = link.centre
        mujoco.mju_mat2Quat(model.body_iquat[own], axes.ravel())
    mujoco.mj_setConst(model, mujoco.MjData(model))
    for link in (link for link in tree if link.kind in ("pin", "slide")):
        joint = model.joint(link.joint)
        joint.stiffness, joint.qpos_spring, joint.damping = link.stiffness, link.rest, link.damping

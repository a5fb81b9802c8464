"""Public threads in which two engines disagreed: each made again on a small model, and named.

The other engine is plain NumPy that knows nothing of `mechanics`, with the mistake or convention of
the thread in it; what one thread printed stands here as it was printed. Where a thread ends without
an answer, the mistake is the one that its text suggests.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy_trees as other
import pytest
import small_trees

from mechanics.compare import compare
from mechanics.kernel import Verdict
from mechanics.scene import Scene
from systems import arm_puma560

Answers = Mapping[str, Callable[..., Any]]


@dataclass(frozen=True)
class Thread:
    """What was reported, on a model, and the cause."""

    title: str
    scene: Callable[[], Scene]
    answers: Callable[[], Answers]
    cause: str
    words: str
    options: Mapping[str, Any] = field(default_factory=dict)


def two() -> Scene:
    return small_trees.arm(2)


def taken(names: str, answers: Answers) -> Answers:
    return {name: answers[name] for name in names.split()}


def half_mass_matrix() -> Answers:
    arm = other.answers(other.arm_joints(2))
    half = {"mass_matrix": lambda q, v: np.triu(arm["mass_matrix"](q, v))}
    return half | {
        "inverse_dynamics": lambda q, v, a: half["mass_matrix"](q, v) @ a + arm["bias"](q, v)
    }


def local_force() -> Answers:
    joints = other.arm_joints(2)

    def answer(q: Any, v: Any, wrench: Any) -> Any:
        R = other.link_poses(joints, q)[-1][1]
        world = np.concatenate([R @ wrench[:3], R @ wrench[3:]])
        return other.jacobian(joints, q).T @ world

    return {"force on link2": answer}


def momentum_about_a_point_at_rest() -> Answers:
    joints = other.arm_joints(3)
    return {
        "momentum_matrix": lambda q, v: other.momentum_matrix(joints, q),
        "momentum_matrix_rate": lambda q, v: other.momentum_matrix_rate(joints, q, v, False),
    }


def local_velocity() -> Answers:
    joints = other.arm_joints(2)

    def answer(q: Any, v: Any) -> Any:
        R = other.link_poses(joints, q)[-1][1]
        speeds = other.jacobian(joints, q) @ v
        return np.concatenate([R.T @ speeds[:3], R.T @ speeds[3:]])

    return {"velocity link2": answer}


def damped_at_the_end(h: float = 0.001, b: float = 0.3) -> Answers:
    arm = other.answers(other.arm_joints(2), added=lambda q, v, a: b * v)

    def forward(q: Any, v: Any, f: Any) -> Any:
        whole = arm["mass_matrix"](q, v) + h * b * np.eye(2)
        return np.linalg.solve(whole, f - arm["bias"](q, v))

    return {"inverse_dynamics": arm["inverse_dynamics"], "forward_dynamics": forward}


def in_degrees() -> Answers:
    arm = other.answers(other.arm_joints(2))
    return {"inverse_dynamics": lambda q, v, a: arm["inverse_dynamics"](np.degrees(q), v, a)}


def changed(change: Callable[[Any], Any]) -> Answers:
    return taken(
        "mass_matrix inverse_dynamics",
        other.answers(other.with_inertia(other.arm_joints(2), change)),
    )


def scalar_last(quaternion: Any) -> Any:
    return other.turned(quaternion[[3, 0, 1, 2]])


PUMA = [(np.radians([45, 70, -100, 60, 25, -140]), np.zeros(6), np.zeros(6))]

THREADS = {
    "stack-of-tasks/pinocchio 1721": Thread(
        "rnea() against RBDL: the configuration of a floating base is ordered otherwise",
        small_trees.floating, lambda: other.floating_answers(scalar_last),
        "order of a quaternion", "(w, x, y, z) is taken for (x, y, z, w)",
    ),
    "stack-of-tasks/pinocchio 2027": Thread(
        "M a + nle against rnea: C++ fills the upper part of M alone",
        two, half_mass_matrix, "upper triangle only", "only the upper triangle",
    ),
    "stack-of-tasks/pinocchio 1916": Thread(
        "J^T f against rnea with external forces, which are those of the joint's own frame",
        two, local_force, "frame of an external force", "in the frame of the body",
    ),
    "stack-of-tasks/pinocchio 2093": Thread(
        "the rate of the centroidal momentum matrix: the velocity of the mass centre was left out",
        lambda: small_trees.arm(3), momentum_about_a_point_at_rest,
        "point of a momentum", "about a point at rest, where the mass centre is",
    ),
    "stack-of-tasks/pinocchio 449": Thread(
        "M ddq against tau - nle, ddq read after computeAllTerms, which does not compute it",
        two, lambda: {"forward_dynamics": lambda q, v, f: np.zeros(2)},
        "not computed", "forward_dynamics is left at zero",
    ),
    "google-deepmind/mujoco 1284": Thread(
        "M of a Panda in MuJoCo against libfranka: 0.1 kg m^2 of armature at each joint",
        two,
        lambda: taken("mass_matrix", other.answers(
            other.arm_joints(2), added=lambda q, v, a: 0.1 * a)),
        "armature", "0.1 kg m^2 at q1, 0.1 kg m^2 at q2",
    ),
    "openai/mujoco-py 796": Thread(
        "M in Pinocchio and MuJoCo: armature was not in Pinocchio's model",
        two,
        lambda: taken("mass_matrix bias inverse_dynamics", other.answers(
            other.arm_joints(2), added=lambda q, v, a: np.array([0.05, 0.02]) * a)),
        "armature", "0.05 kg m^2 at q1, 0.02 kg m^2 at q2",
    ),
    "cdsousa/SymPyBotics 33": Thread(
        "torques from a regressor, whose inertias are about the joints, against Newton and Euler",
        two, lambda: changed(lambda joint: joint.inertia - other.point_mass(joint)),
        "inertia about the wrong point", "about the joint, not about the mass centre: link1, link2",
    ),
    "stack-of-tasks/pinocchio 1800": Thread(
        "torques of a Jaco arm against rnea, whose angles were given in degrees",
        two, in_degrees, "degrees", "angles in degrees are taken for radians",
    ),
    "stack-of-tasks/pinocchio 446": Thread(
        "M in MuJoCo and Pinocchio differ as soon as the floating base is turned",
        small_trees.floating, lambda: other.floating_answers(local=True),
        "frame of a velocity", "the velocity of trunk is taken in its own frame",
    ),
    "stack-of-tasks/pinocchio 2531": Thread(
        "velocity of the mass centre against MuJoCo, whose qpos was given to Pinocchio",
        small_trees.floating,
        lambda: taken("mass_matrix", other.floating_answers(scalar_last)),
        "order of a quaternion", "(w, x, y, z) is taken for (x, y, z, w)",
    ),
    "stack-of-tasks/pinocchio 1759": Thread(
        "velocity of the end effector in Bullet and in Pinocchio",
        two, local_velocity, "frame of a velocity", "velocities are those in the frame of the body",
    ),
    "bulletphysics/bullet3 1980": Thread(
        "tracking by inverse dynamics fails: Bullet damps the joints",
        two,
        lambda: taken("forward_dynamics", other.answers(
            other.arm_joints(2), added=lambda q, v, a: 0.04 * v)),
        "joint damping", "0.04 N m s/rad at q1, 0.04 N m s/rad at q2",
    ),
    "dartsim/dart 1450": Thread(
        "forward dynamics, damped at the end of its step, against inverse dynamics",
        lambda: small_trees.arm(2, "0.3"), damped_at_the_end,
        "implicit integration", "an implicit step of 0.001 s",
    ),
    "Gepetto/example-robot-data 67": Thread(
        "PyBullet gives a link that has no inertia 1 kg",
        lambda: small_trees.arm(2, tool=True),
        lambda: taken("mass_matrix inverse_dynamics", other.answers(
            other.with_tool(other.arm_joints(2)))),
        "a link without inertia", "1 kg and 1 kg m^2: tool",
    ),
    "frankarobotics/franka_ros 160": Thread(
        "a controller's gravity is not that of the simulator",
        two, lambda: taken("bias", other.answers(
            other.arm_joints(2), gravity=np.array([0.0, 0.0, -9.8]))),
        "gravity", "another size: (0, 0, -9.8) in place of (0, 0, -9.81) m/s^2",
    ),
    "Rhoban/onshape-to-robot 85": Thread(
        "inertias of parts were turned the wrong way round",
        two, lambda: changed(lambda joint: joint.rotation.T @ joint.inertia @ joint.rotation),
        "inertia turned", "in the frame of the link before: link2",
    ),
    "petercorke/robotics-toolbox-python 134": Thread(
        "a payload of 0 kg changes the torques of a PUMA 560: it takes the last link's mass away",
        arm_puma560.scene,
        lambda: {"inverse_dynamics": lambda q, v, a: [0.000, 16.024, 4.381, 0.000, 0.000, 0.000]},
        "a body left out", "link6", {"states": PUMA, "rounding": 5e-4},
    ),
    "petercorke/robotics-toolbox-python 300": Thread(
        "products of inertia in the order xy, yz, zx or xy, zx, yz",
        two,
        lambda: changed(lambda joint: _products(joint.inertia)),
        "order or sign of the products of inertia", "yz and zx are exchanged",
    ),
}  # fmt: skip


def _products(inertia: Any) -> Any:
    found = inertia.copy()
    found[1, 2] = found[2, 1] = inertia[0, 2]
    found[0, 2] = found[2, 0] = inertia[1, 2]
    return found


@pytest.mark.sample(2)
@pytest.mark.parametrize("thread", THREADS)
def test_the_cause_of_a_public_disagreement_is_named(thread: str) -> None:
    row = THREADS[thread]
    options = {"states": 5} | dict(row.options)
    found = compare(row.scene(), row.answers(), **options)
    assert not found.agree and not found.unexplained
    (cause,) = found.causes
    assert cause.names == (row.cause,) and row.words in cause.words
    assert cause.finding.verdict is Verdict.SUPPORTED
    assert found.proof is not None and found.proof.shown


def test_the_numbers_that_were_printed_before_the_payload_are_those_of_the_scene() -> None:
    printed = {"inverse_dynamics": lambda q, v, a: [-0.000, 16.368, 4.595, -0.005, -0.004, 0.000]}
    assert compare(arm_puma560.scene(), printed, states=PUMA, rounding=5e-4).agree

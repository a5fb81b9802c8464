"""Of a scene that is too large to be written out, one joint is: it is the row of the whole."""

import numpy as np
import pytest
from sympy import sympify

from mechanics.kinematics import chain
from mechanics.mechanism import lower
from mechanics.program import Builder, interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.routes import kane
from mechanics.routes.steps.one_joint import equation, large_steps, last_joint
from mechanics.scene import Gravity
from systems import andrews, arm_puma560, arm_seven_joints, humanoid


def scene_of(module):
    made = module.scene()
    return getattr(made, "scene", made)


@pytest.mark.parametrize("module", [arm_puma560, arm_seven_joints])
def test_the_joint_in_full_is_its_row_of_kanes_equations(module) -> None:
    scene = scene_of(module)
    joint = last_joint(scene)
    mechanism = lower(scene, Builder())
    motions = chain.motions(mechanism)
    frames = [frame.name for frame in mechanism.frames]
    points = [point.name for point in mechanism.points]
    carrier = motions.frames[frames.index(joint.carrier.frame.name)]
    at = motions.points[points.index(joint.at.name)]
    place = scene.q.index(joint.coordinate)
    outputs = {
        "row": [kane.derive(mechanism).values[place]],
        "omega": list(carrier.omega),
        "alpha": list(carrier.alpha),
        "gain": list(at.acceleration),
    }
    random = np.random.default_rng(3)
    state = {name: float(random.uniform(0.3, 1.2)) for name in mechanism.builder.inputs}
    values = interpret(mechanism.builder.program(outputs), Arrays(), state, release=False)
    numbers = {key: np.array(value, dtype=float) for key, value in values.items()}

    def at_state(expression: object, table: dict[str, float] = state) -> float:
        plain = scene.plain(sympify(expression))
        return float(plain.evalf(subs={s: table[s.name] for s in plain.free_symbols}))

    own = joint.carrier.frame
    field = next(o.field for o in scene.loads if isinstance(o, Gravity)).to_matrix(scene.frame)
    to_carrier = np.array(own.dcm(scene.frame).applyfunc(at_state), dtype=float)
    gravity = np.array([at_state(e) for e in field])
    columns = {
        "Omega": to_carrier @ numbers["omega"],
        "Omega_dot": to_carrier @ numbers["alpha"],
        "A": to_carrier @ (numbers["gain"] - gravity),
    }
    table = dict(state)
    for name, column in columns.items():
        stem, _, rate = name.partition("_")
        for axis, value in zip("xyz", column, strict=True):
            table[f"{stem}_{axis}" + ("_dot" if rate else "")] = float(value)
    *lines, last = equation(scene, joint)
    for line in lines:
        table[line.left.name] = at_state(line.right, table)
    left, right = (at_state(side, table) for side in (last.left, last.right))
    assert abs(left - right) == pytest.approx(abs(numbers["row"][0]), rel=1e-9)
    assert abs(left - right) > 1e-6


@pytest.mark.parametrize(("module", "count"), [(humanoid, 2), (andrews, 1)])
def test_a_loop_has_its_structure_alone(module, count: int) -> None:
    steps = large_steps(scene_of(module))
    assert [step.title.split(":")[0] for step in steps] == ["Structure", "One joint in full"][
        :count
    ]

"""Of a scene that is too large to be written out, one joint is: every route ends in its row."""

import numpy as np
import pytest
from sympy import Add, sympify

from mechanics.kinematics import chain
from mechanics.kinematics.motion import body_motions
from mechanics.mechanism import lower
from mechanics.program import Builder, interpret
from mechanics.program.derivatives import gradient
from mechanics.program.numpy_domain import Arrays
from mechanics.routes import kane
from mechanics.routes.lagrange import kinetic_energy
from mechanics.routes.steps.one_joint import large_steps, last_joint
from mechanics.scene import Gravity
from systems import andrews, arm_puma560, arm_seven_joints, bicycle, humanoid, quadrotor

WITH_A_JOINT = [
    andrews,
    arm_puma560,
    *(pytest.param(m, marks=pytest.mark.campaign) for m in (arm_seven_joints, bicycle, humanoid)),
]


def scene_of(module):
    made = module.scene()
    return getattr(made, "scene", made)


def value(side: object) -> object:
    return Add(*(term.value for term in side)) if isinstance(side, tuple) else side


@pytest.mark.parametrize("module", WITH_A_JOINT)
def test_every_line_of_the_joint_in_full_is_true_of_the_whole_scene(module) -> None:
    """Kinematics, energies, partial velocities and the row, at one state of the whole."""
    scene = scene_of(module)
    mechanism = lower(scene, Builder())
    joint = last_joint(scene, mechanism)
    motions = chain.motions(mechanism)
    frames = [frame.name for frame in mechanism.frames]
    points = [point.name for point in mechanism.points]
    bodies = [body.name for body in mechanism.bodies]
    carrier = motions.frames[frames.index(joint.carrier.frame.name)]
    at = motions.points[points.index(joint.at.name)]
    own = body_motions(mechanism, motions)[bodies.index(joint.body.name)]
    place = scene.q.index(joint.coordinate)
    speed = mechanism.qd[place]
    energy = kinetic_energy(mechanism)
    outputs = {
        "row": [kane.derive(mechanism).values[place]],
        "omega": list(carrier.omega),
        "alpha": list(carrier.alpha),
        "gain": list(at.acceleration),
        "v": list(own.centre.velocity),
        "slopes": gradient([energy], [1], (speed, mechanism.q[place])),
        "dv": [gradient([x], [1], (speed,))[0] for x in own.centre.velocity],
    }
    random = np.random.default_rng(3)
    state = {name: float(random.uniform(0.3, 1.2)) for name in mechanism.builder.inputs}
    norm = sum(state[e.name] ** 2 for e in scene.quaternions) ** 0.5
    state |= {e.name: state[e.name] / norm for e in scene.quaternions}
    rates = {"rates": list(mechanism.q_rates)}
    moving = interpret(mechanism.builder.program(rates), Arrays(), state, release=False)
    state |= zip([rate.name for rate in scene.qd], map(float, moving["rates"]), strict=True)
    values = interpret(mechanism.builder.program(outputs), Arrays(), state, release=False)
    numbers = {key: np.array(entry, dtype=float) for key, entry in values.items()}

    def at_state(expression: object, table: dict[str, float] = state) -> float:
        plain = scene.plain(sympify(expression))
        return float(plain.evalf(subs={s: table[s.name] for s in plain.free_symbols}))

    def axes(frame):
        return np.array(frame.dcm(scene.frame).applyfunc(at_state), dtype=float)

    def along(vector, frame):
        return np.array([at_state(e) for e in vector.to_matrix(frame)])

    to_carrier, to_body = axes(joint.carrier.frame), axes(joint.body.frame)
    fields = [load.field for load in scene.loads if isinstance(load, Gravity)]
    gravity = sum((along(field, scene.frame) for field in fields), np.zeros(3))
    columns = {
        "Omega": to_carrier @ numbers["omega"],
        "Omega_dot": to_carrier @ numbers["alpha"],
        "A": to_carrier @ (numbers["gain"] - gravity),
        "v": to_body @ numbers["v"],
    }
    for contact in joint.contacts:
        forces = [r for r in scene.reactions if r.at is contact.at]
        signs = [1 if r.on == joint.body.name else -1 for r in forces]
        pushes = zip(signs, forces, strict=True)
        mine = [(s, r) for s, r in pushes if joint.body.name in (r.on, r.by)]
        name = contact.force[0].name[:-2]
        columns[name] = to_body @ sum(
            s * state[r.name] * along(r.along, scene.frame) for s, r in mine
        )
        columns["rho" + name[1:]] = to_body @ along(contact.at.pos_from(joint.at), scene.frame)
    table = dict(state)
    for name, column in columns.items():
        stem, _, rate = name.partition("_dot")
        end = "_dot" if name.endswith("_dot") else ""
        for axis, entry in zip("xyz", column, strict=True):
            table[f"{stem}_{axis}{end}"] = float(entry)
    steps = large_steps(scene, mechanism)
    size = abs(numbers["row"][0])
    assert size > 1e-6
    for lines in ([line for step in own for line in step.lines] for own in steps.values()):
        for line in lines[:-1]:
            if not isinstance(line.left, str) and line.left.is_Symbol:
                table[line.left.name] = at_state(line.right, table)
            elif not isinstance(line.left, str):  # the moments about the mass centre
                gap = at_state(value(line.left) - value(line.right), table)
                assert abs(gap) == pytest.approx(size, rel=1e-9)
        gap = at_state(value(lines[-1].left) - value(lines[-1].right), table)
        assert abs(gap) == pytest.approx(size, rel=1e-9)
    (lagrange,) = steps["lagrange"]
    by_rate, rate, by_coordinate, force, _ = lagrange.lines
    slopes = [at_state(value(line.right), table) for line in (by_rate, by_coordinate)]
    assert slopes == pytest.approx(numbers["slopes"], rel=1e-9)
    ends = [at_state(value(line.right), table) for line in (rate, by_coordinate, force)]
    assert abs(ends[0] - ends[1] - ends[2]) == pytest.approx(size, rel=1e-9)
    (kanes,) = steps["kane"]
    partial = [line for line in kanes.lines if r"\partial \vec v_" in str(line.left)]
    column = np.array(partial[0].right, dtype=object).ravel() if partial else [0, 0, 0]
    shown = [at_state(entry) for entry in column]
    assert shown == pytest.approx(to_body @ numbers["dv"], abs=1e-9)
    *_, active, inertia, _ = kanes.lines
    total = at_state(active.right + inertia.right, table)
    assert abs(total) == pytest.approx(size, rel=1e-9)


@pytest.mark.parametrize("module", [arm_puma560, andrews])
def test_every_route_ends_in_the_same_row(module) -> None:
    scene = scene_of(module)
    steps = large_steps(scene, lower(scene, Builder()))
    assert list(steps) == ["free_body", "moving_point", "kane", "lagrange"]
    rows = {(own[-1].lines[-1].left, own[-1].lines[-1].right) for own in steps.values()}
    assert len(rows) == 1


def test_without_a_hinge_the_structure_stands_alone() -> None:
    scene = scene_of(quadrotor)
    steps = large_steps(scene, lower(scene, Builder()))
    assert [step.title for own in steps.values() for step in own] == ["Structure"]

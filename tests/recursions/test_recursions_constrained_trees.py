"""Constraints composed along the bodies, in unknowns in which wheels and headings drop out."""

import numpy as np
import pytest

import mechanics
from mechanics.mechanism import lower
from mechanics.program import Builder
from mechanics.program.derivatives import gradient
from mechanics.program.interpret import interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.recursions.constrained_trees import forward_dynamics
from mechanics.recursions.constrained_trees.motion import forcing, matrix, motion
from mechanics.recursions.constrained_trees.tree import build_tree
from mechanics.recursions.joint_frames import joint_frames
from mechanics.recursions.pseudo_inertia import grouped, moments
from mechanics.routes import kane
from mechanics.routes.rows import acceleration_forms, remainder, substitute
from systems import bicycle, four_bar, rolling_disc, slider_crank


@pytest.fixture(scope="module")
def bicycle_model() -> mechanics.Model:
    return mechanics.compile(mechanics.derive(bicycle.scene(), "kane"), compiler=None)


@pytest.mark.campaign
def test_a_bicycle_takes_half_of_the_operations_of_its_rows_alone_elsewhere(bicycle_model) -> None:
    """Accelerations and five reactions; SymBRiM 0.1.0 counts 1,909 for three unsolved rows."""
    assert bicycle_model.program("forward_dynamics").operations <= 1031


@pytest.mark.parametrize(
    "system", [pytest.param(bicycle, marks=pytest.mark.campaign), four_bar], ids=["bicycle", "bar"]
)
def test_accelerations_satisfy_kanes_rows_and_the_constraints(system) -> None:
    """At states on the constraints or beside them."""
    mechanism = lower(system.scene(), Builder())
    build, route = mechanism.builder, kane.derive(mechanism)
    closing = acceleration_forms(mechanism)
    ways = forward_dynamics(mechanism, closing)
    assert ways
    for ud, mu in ways:
        unknowns = dict(zip(mechanism.ud, ud, strict=True))
        free = remainder(build, route.values, route.multipliers)
        rows = substitute(build, free, unknowns)
        pulls = gradient(closing, mu, mechanism.ud)
        nodes = [row - pull for row, pull in zip(rows, pulls, strict=True)]
        nodes += substitute(build, closing, unknowns)
        program = build.program({"rows": nodes, "sizes": [*ud, *mu]})
        rng = np.random.default_rng(0)
        found = interpret(program, Arrays(), {e: rng.uniform(0.4, 1.2) for e in program.inputs})
        size = 1 + max(abs(float(value)) for value in found["sizes"])
        assert max(abs(float(value)) for value in found["rows"]) < 1e-9 * size


def test_speeds_that_are_no_rates_are_left_to_others() -> None:
    mechanism = lower(rolling_disc.scene(), Builder())
    assert forward_dynamics(mechanism, acceleration_forms(mechanism)) == []


@pytest.mark.campaign
def test_the_wheels_of_a_bicycle_are_rotors_and_its_heading_drops_out() -> None:
    mechanism = joint_frames(lower(bicycle.scene(), Builder()))
    for masses in (moments, grouped):
        tree = build_tree(mechanism, masses(mechanism))
        assert tree is not None
        names = [mechanism.q[rotor.coordinate] for rotor in tree.rotors.values()]
        assert names == [mechanism.builder.input(name) for name in ("tR", "tF")]
        assert len(tree.slides) == 2
        flat = [entry for row in matrix(tree) for entry in row]
        program = mechanism.builder.program({"M": flat, "f": forcing(tree, motion(tree))})
        assert not {"x", "y", "yaw", "tR", "tF"} & {*program.inputs}


@pytest.mark.campaign
def test_a_tilted_steering_axis_is_one_turn() -> None:
    mechanism = lower(bicycle.scene(), Builder())
    turned = joint_frames(mechanism)
    names = [frame.name for frame in turned.frames]
    B, S = names.index("B"), names.index("S")
    assert turned.frames[B].parent == S and turned.frames[B].turn is None
    assert turned.frames[S].turn is not None
    assert joint_frames(turned) is turned


@pytest.mark.campaign
def test_a_bicycle_rolls_alike_at_every_heading(bicycle_model) -> None:
    """Lean, steer, pitch and wheels do not know where the bicycle heads; x and y turn with it."""
    model = bicycle_model
    values = {name: float(value) for text in bicycle.TYPICAL.values()
              for name, value in (entry.split() for entry in text.split(","))}  # fmt: skip
    p = [values[entry.name] for entry in model.quantities.p]
    q = {"x": 0.0, "y": 0.0, "lean": 0.2, "tR": 0.3, "pitch": 0.01, "steer": -0.4, "tF": 0.2}
    rates = {"yaw": 0.3, "lean": 0.5, "tR": -12.0, "pitch": 0.02, "steer": 1.1, "tF": -10.0}

    def found(yaw: float) -> np.ndarray:
        c, s = np.cos(yaw), np.sin(yaw)
        speeds = {**rates, "x": 3.6 * c, "y": 3.6 * s}
        state = [{**q, "yaw": yaw}[entry.name] for entry in model.quantities.q]
        u = [speeds[entry.name.removesuffix("_dot")] for entry in model.quantities.u]
        ud = dict(zip((e.name.removesuffix("_ddot") for e in model.quantities.ud),
                      model.forward_dynamics(state, u, p), strict=True))  # fmt: skip
        x, y = ud.pop("x"), ud.pop("y")
        return np.array([c * x + s * y, c * y - s * x, *ud.values()])

    straight = found(0.3)
    for heading in (0.0, 1.0, np.pi / 2, np.pi, -2.0, 7.0):
        np.testing.assert_allclose(found(heading), straight, atol=1e-12 * np.abs(straight).max())


@pytest.mark.campaign
def test_rows_with_dependent_speeds_put_in_have_these_forms_too() -> None:
    """Kane's three rows less two: the accelerations are the bodies', whatever the rows are."""
    equations = mechanics.derive(slider_crank.scene(), "kane")
    assert not equations.multipliers
    one, two = (
        mechanics.compile(equations, compiler=None, form=form) for form in ("composite", "fewest")
    )
    p = [1 + 0.1 * k for k in range(len(one.quantities.p))]
    states = [
        [0.3 + 0.2 * k for k in range(len(group))] for group in (one.quantities.q, one.quantities.u)
    ]
    inputs = [0.5] * len(one.quantities.inputs)
    found = [model.forward_dynamics(*states, p, inputs=inputs) for model in (one, two)]
    np.testing.assert_allclose(*found, rtol=1e-11)

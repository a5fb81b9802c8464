"""Four routes and the recursions give the same accelerations and torques on random trees."""

import numpy as np
import pytest
from hypothesis import Phase, given, seed, settings
from hypothesis import strategies as st

from benchmarks.space.deriving import ROUTES
from benchmarks.space.random_trees import build, numbers, state, trees
from benchmarks.space.scenes import Joint
from benchmarks.space.textbook import inverse_dynamics
from mechanics.checks.agreement import linear_system
from mechanics.mechanism import lower
from mechanics.program import Builder, interpret
from mechanics.program.numpy_domain import Arrays
from mechanics.program.residues import Residues
from mechanics.recursions import newton_euler
from mechanics.recursions.articulated_bodies import forward_dynamics
from mechanics.recursions.composite_bodies import mass_matrix
from mechanics.recursions.joints import joint_tree
from mechanics.recursions.pseudo_inertia import grouped
from mechanics.routes.rows import remainder

PHASES = (Phase.explicit, Phase.generate)


def assert_everything_agrees(joints: tuple[Joint, ...], seed: int) -> None:
    mechanism = lower(build(joints), Builder())
    b, filter_ = mechanism.builder, Residues(mechanism.builder)
    masses = grouped(mechanism)
    links = joint_tree(mechanism, masses)
    assert links is not None
    rows = newton_euler.rows(mechanism, masses)
    bias = remainder(b, rows, mechanism.ud)
    articulated = forward_dynamics(mechanism, links, bias)
    residues = filter_.values(articulated)
    matrix = mass_matrix(mechanism, links)
    composite = b.solve(matrix, [-entry for entry in bias], symmetric=True)
    assert filter_.values(composite) == residues
    for route in ROUTES:
        derived = linear_system(mechanism, route.derive(mechanism), filter_)
        assert filter_.values(derived.accelerations) == residues

    # Textbook's torques at numbers, and u' that belong to them: M u' + bias = 0 with tau as loads.
    tree, values = numbers(joints, seed)
    q, qd, qdd, at = state(len(joints), seed + 1)
    tau = inverse_dynamics(tree, q, qd, qdd, values["g"])
    sizes = inverse_dynamics(tree, q, qd, qdd, values["g"], sizes=True)
    flat = [entry for line in matrix for entry in line]
    program = b.program({"rows": rows, "matrix": flat, "bias": bias})
    found = interpret(program, Arrays(), values | at)
    bound = 64 * np.finfo(float).eps * sizes
    assert np.all(np.abs(np.array(found["rows"], dtype=float) - tau) <= bound)
    own = np.array(found["matrix"], dtype=float).reshape(len(joints), -1)
    assert np.all(np.abs(own @ qdd + np.array(found["bias"], dtype=float) - tau) <= bound)


@pytest.mark.campaign
@pytest.mark.sample(1)
@pytest.mark.parametrize("part", range(50))
def test_three_hundred_random_trees(part: int) -> None:
    @seed(part)
    @settings(max_examples=6, phases=PHASES)
    @given(trees(), st.integers(0, 2**32))
    def assert_six_agree(joints: tuple[Joint, ...], drawn: int) -> None:
        assert_everything_agrees(joints, drawn)

    assert_six_agree()

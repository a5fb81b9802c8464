"""Composite and articulated bodies say what Newton and Euler's rows say."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from whipple_bicycle import whipple_bicycle

from benchmarks.space import scenes
from benchmarks.space.counting import count
from benchmarks.space.random_trees import build, numbers, state, trees
from benchmarks.space.scenes import Joint
from benchmarks.space.textbook import inverse_dynamics
from mechanics import compile, derive
from mechanics.mechanism import Mechanism, lower
from mechanics.program import Builder, Node, interpret
from mechanics.program.forward import tangent
from mechanics.program.numpy_domain import Arrays
from mechanics.program.operations import Sign
from mechanics.program.residues import Residues
from mechanics.recursions import newton_euler
from mechanics.recursions.articulated_bodies import forward_dynamics
from mechanics.recursions.composite_bodies import mass_matrix
from mechanics.recursions.joints import joint_tree
from mechanics.recursions.local_equations import jacobian
from mechanics.recursions.pseudo_inertia import grouped, moments
from mechanics.routes.rows import coefficients, remainder
from systems import ALL, VARIANTS

PHASES = (Phase.explicit, Phase.generate)
"""Trees are small already, and shrinking builds hundreds of scenes."""
MOMENTS = (moments, grouped)
OTHER = {
    "rocker",
    "controlled rocker",
    "rolling disc",
    "four-bar linkage",
    "cart-pole with friction",
}
"""No trees of joints with one freedom each: other positions, constraints, friction."""


def assert_recursions_agree(mechanism: Mechanism, masses, *, derivatives: bool) -> None:
    build, filter_ = mechanism.builder, Residues(mechanism.builder)
    found = masses(mechanism)
    links = joint_tree(mechanism, found)
    assert links is not None
    rows = newton_euler.rows(mechanism, found)
    matrix = mass_matrix(mechanism, links)
    wanted = coefficients(rows, mechanism.ud)
    assert all(
        filter_.is_zero(a - b)
        for line, other in zip(matrix, wanted, strict=True)
        for a, b in zip(line, other, strict=True)
    )
    bias = remainder(build, rows, mechanism.ud)
    rates = forward_dynamics(mechanism, links, bias)
    solved = build.solve(matrix, [-entry for entry in bias], symmetric=True)
    assert all(filter_.is_zero(a - b) for a, b in zip(rates, solved, strict=True))
    if not derivatives:
        return
    # A parameter may turn the axis of a joint, a coordinate never does.
    angles = [build.input(name) for name in build.inputs if name.startswith("beta")]
    variables = [*mechanism.q, *mechanism.u, *angles]
    columns = zip(*jacobian(mechanism, links, variables), strict=True)
    for variable, column in zip(variables, columns, strict=True):
        wanted_column = tangent(rates, {variable: build.one})
        assert all(filter_.is_zero(a - b) for a, b in zip(column, wanted_column, strict=True))


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", [*ALL, *VARIANTS], ids=lambda system: system.name)
@pytest.mark.parametrize("masses", MOMENTS)
def test_every_system_that_is_a_tree_of_joints(system, masses) -> None:
    mechanism = lower(system.scene(), Builder())
    if joint_tree(mechanism, masses(mechanism)) is None:
        assert mechanism.name in OTHER
    else:
        assert mechanism.name not in OTHER
        assert_recursions_agree(mechanism, masses, derivatives=True)


@pytest.mark.campaign
@pytest.mark.parametrize("masses", MOMENTS)
def test_wheels_turn_about_their_centres_and_the_contact_is_on_no_link(masses) -> None:
    """No point lies on a wheel of a bicycle but its centre; a contact moves in the wheel."""
    mechanism = replace(lower(whipple_bicycle(), Builder()), constraints=())
    assert_recursions_agree(mechanism, masses, derivatives=False)


@pytest.mark.campaign
def test_a_bicycle_whose_friction_heads_with_it_takes_no_more_operations() -> None:
    """Its conditions of no slip stand in directions that move."""
    model = compile(derive(whipple_bicycle(), "kane"), compiler=None)
    assert model.program("forward_dynamics").operations <= 2012


@pytest.mark.campaign
@settings(max_examples=6, deadline=None, derandomize=True, phases=PHASES)
@given(trees(), st.integers(0, 2**32))
def test_random_trees(joints: tuple[Joint, ...], seed: int) -> None:
    mechanism = lower(build(joints), Builder())
    for masses in MOMENTS:
        assert_recursions_agree(mechanism, masses, derivatives=len(joints) < 5)
    # M u' with the textbook's inverse dynamics: without gravity and at rest.
    links, values = numbers(joints, seed)
    q, _, qdd, at = state(len(joints), seed + 1)
    none = np.zeros(len(joints))
    tau = inverse_dynamics(links, q, none, qdd, 0.0)
    sizes = inverse_dynamics(links, q, none, qdd, 0.0, sizes=True)
    for masses in MOMENTS:
        tree = joint_tree(mechanism, masses(mechanism))
        assert tree is not None
        flat = [entry for row in mass_matrix(mechanism, tree) for entry in row]
        program = mechanism.builder.program({"M": flat})
        (entries,) = interpret(program, Arrays(), values | at).values()
        matrix = np.array(entries, dtype=float).reshape(len(joints), -1)
        assert np.all(np.abs(matrix @ qdd - tau) <= 64 * np.finfo(float).eps * sizes)


def test_pivots_are_recorded_as_obligations() -> None:
    mechanism = lower(scenes.chain(2), Builder())
    found = moments(mechanism)
    links = joint_tree(mechanism, found)
    bias = remainder(mechanism.builder, newton_euler.rows(mechanism, found), mechanism.ud)
    before = set(mechanism.builder.obligations)
    forward_dynamics(mechanism, links, bias)
    new = set(mechanism.builder.obligations) - before
    assert len(new) == len(mechanism.u)
    assert {obligation.sign for obligation in new} == {Sign.NONZERO}


def operations(mechanism: Mechanism, nodes: list[Node]) -> int:
    program = mechanism.builder.program({"all": nodes})
    state = {f"q{i}{dots}" for i in range(11) for dots in ("", "_dot", "_ddot")}
    return count(program, {*program.inputs} - state).total


def test_counts_of_a_chain_of_ten() -> None:
    """Closed form of M: 382; derivatives of the recursion by CasADi: 5208."""
    mechanism = lower(scenes.chain(10), Builder())
    links = joint_tree(mechanism, moments(mechanism))
    matrix = mass_matrix(mechanism, links)
    assert operations(mechanism, [e for i, row in enumerate(matrix) for e in row[i:]]) <= 382
    entries = jacobian(mechanism, links, [*mechanism.q, *mechanism.u])
    assert operations(mechanism, [entry for row in entries for entry in row]) <= 4000

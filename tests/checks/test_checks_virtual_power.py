"""The principle of virtual power, read from SymPy's objects as they were declared."""

from collections.abc import Callable
from dataclasses import replace
from math import comb
from typing import Any

import pytest
from every_route import derive_with
from flint import arb
from sympy import Matrix, cos, pi, sin
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols, inertia

from mechanics import CrossCheck
from mechanics.checks.virtual_power import (
    check_powers,
    check_virtual_power,
    drawn_states,
    tried,
)
from mechanics.cli.crosscheck import exit_code
from mechanics.crosscheck import crosscheck
from mechanics.kernel import Finding, Verdict
from mechanics.routes.derivation import ROUTES, by_route
from mechanics.scene import (
    RigidBody,
    Scene,
    declaration,
    geometry,
    gravity,
    parameters,
    reaction,
    reaction_couple,
    spring,
    torque,
)
from mechanics.scene.loads import Spring, damper, torsion_spring
from mechanics.scene.potential import potential
from systems import ALL, VARIANTS, elastic_pendulum, four_bar, rolling_disc

m, L, k, c, g, A, B, C, D = parameters("m L k c g A B C D")
p, q, tau, y = dynamicsymbols("p q tau y")


def arm() -> Scene:
    """Two turning joints with a quarter turn between them, every kind of load, a moving base."""
    N, O = ReferenceFrame("N"), Point("O")
    base = O.locatenew("P", y * N.x)
    first = N.orientnew("A", "Axis", (p, N.z))
    fixed = first.orientnew("F", "Axis", (pi / 2, first.x))
    second = fixed.orientnew("B", "Axis", (q, fixed.z))
    one = base.locatenew("C1", L * first.x + L / 3 * first.z)
    elbow = base.locatenew("E", 2 * L * first.x)
    two = elbow.locatenew("C2", L * second.x + L / 5 * second.z)
    hinges = []
    for body, by, at, axis, across in (
        ("one", None, base, first, (first.x, first.y)),
        ("two", "one", elbow, second, (second.x, second.y)),
    ):
        for i, along in enumerate((axis.x, axis.y, axis.z)):
            hinges.append(reaction(f"R_{body}_{i}", at=at, on=body, by=by, along=along))
        for i, along in enumerate(across):
            hinges.append(reaction_couple(f"Q_{body}_{i}", on=body, by=by, along=along))
    return Scene(
        "arm", N, O, coordinates=(p, q), inputs=(tau, y),
        bodies=(
            RigidBody("one", one, first, m, inertia(first, A, B, C, D, D / 2, D / 3)),
            RigidBody("two", two, second, 2 * m, inertia(second, B, C, A, D, -D, D / 2)),
        ),
        loads=(
            gravity(-g * N.z), torque("motor", tau * second.z, on="two", by="one"),
            spring("k", O, two, k, length=L / 2), damper("c", one, two, c),
            torsion_spring("t", q, second.z, k * L**2, on="two", by="one"),
        ),
        reactions=tuple(hinges),
    )  # fmt: skip


def witnesses(scene: Scene) -> list[Finding]:
    derived, states = derive_with(scene), drawn_states(scene)
    findings = [*check_powers(scene, states, potential(scene))]
    return findings + [
        check_virtual_power(equations, states, derived["free_body"])
        for equations in derived.values()
    ]


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", (*ALL, *VARIANTS), ids=lambda system: system.name)
def test_every_route_satisfies_it_in_every_system(system: Any) -> None:
    found = witnesses(system.scene())
    assert len(found) >= len(ROUTES)
    assert {finding.verdict for finding in found} == {Verdict.SUPPORTED}


def test_an_arm_in_space_with_every_kind_of_load_on_a_moving_base() -> None:
    found = witnesses(arm())
    assert len(found) == len(ROUTES) + 2
    assert {finding.verdict for finding in found} == {Verdict.SUPPORTED}


def test_a_state_at_which_digits_are_lost_says_nothing_and_another_one_may() -> None:
    wide, exact = ("x", arb(0, 1), arb(0)), ("x", arb(2), arb(2))
    draws = drawn_states(elastic_pendulum.scene())[:3]
    rows = {draws[0].index: wide, draws[1].index: exact, draws[2].index: exact}
    assert tried("x", draws, lambda state: iter([rows[state.index]])).verdict is Verdict.SUPPORTED
    lost = tried("x", draws, lambda state: iter([exact, wide]))
    assert lost.verdict is Verdict.UNDECIDED
    assert "x: known too badly" in lost.evidence
    apart = ("y", arb(1), arb(2))
    wrong = tried("x", draws, lambda state: iter([wide, apart]))
    assert wrong.verdict is Verdict.REFUTED


@pytest.mark.campaign
def test_two_runs_say_the_same() -> None:
    one, two = witnesses(four_bar.scene()), witnesses(four_bar.scene())
    assert one == two


def turned_round(parent: ReferenceFrame, child: ReferenceFrame) -> Matrix:
    return Matrix(child.dcm(parent))


@pytest.mark.campaign
def test_a_wrong_rotation_that_all_routes_share_is_noticed_here(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """This is what the check is for: the routes agree with each other and are wrong."""
    monkeypatch.setattr(declaration, "relative_rotation", turned_round)
    monkeypatch.setattr("mechanics.mechanism.relative_rotation", turned_round)
    result = crosscheck(elastic_pendulum.scene(), CrossCheck(states=0))
    assert len(result.pairs) == comb(len(ROUTES), 2) + 2
    # SymPy's own methods read the frames themselves.
    alone = {("kane", "kane_sympy"), ("lagrange", "lagrange_sympy")}
    assert {pair for pair, finding in result.pairs.items() if not finding.shown} == alone
    wrong = [f for f in result.witnesses if f.verdict is Verdict.REFUTED]
    assert wrong
    assert not result.ok
    assert exit_code([result]) == 1
    assert {"x", "theta", "x_dot", "theta_dot", "L"} <= set(dict(wrong[0].witness.state))


@pytest.mark.sample(2)
@pytest.mark.parametrize("make", (elastic_pendulum.scene, rolling_disc.scene, four_bar.scene))
@pytest.mark.parametrize("name", [route.name for route in ROUTES])
def test_a_wrong_force_is_refuted_with_its_state(make: Callable[[], Scene], name: str) -> None:
    scene = make()
    equations = derive_with(scene, (name,))[name]
    pushed = equations.forcing + Matrix([1] + [0] * (equations.forcing.rows - 1))
    found = check_virtual_power(equations.with_matrices(forcing=pushed), drawn_states(scene))
    assert found.verdict is Verdict.REFUTED
    assert found.witness is not None
    assert {e.name for e in scene.q} <= set(dict(found.witness.state))


def test_accelerations_that_leave_the_constraints_are_refuted() -> None:
    scene = four_bar.scene()
    equations = derive_with(scene, ("kane",))["kane"]
    off = equations.constraint_bias + Matrix([1, 0])
    found = check_virtual_power(equations.with_matrices(constraint_bias=off), drawn_states(scene))
    assert found.verdict is Verdict.REFUTED
    assert found.evidence.startswith("closure along x")


def test_a_wrong_reaction_is_refuted_though_the_motion_is_right() -> None:
    scene = elastic_pendulum.scene()
    equations = by_route("free_body", scene)
    (first, value), *rest = equations.reactions
    wrong = replace(equations, reactions=((first, value + 1), *rest))
    assert check_virtual_power(equations, drawn_states(scene)).verdict is Verdict.SUPPORTED
    found = check_virtual_power(wrong, drawn_states(scene))
    assert found.verdict is Verdict.REFUTED
    assert "momentum of" in found.evidence


def test_a_potential_of_another_size_is_refuted() -> None:
    scene = elastic_pendulum.scene()
    (spring_load,) = (load for load in scene.loads if isinstance(load, Spring))
    wrong = potential(scene) + spring_load.stiffness * scene.q[0] ** 2 / 2
    findings = list(check_powers(scene, drawn_states(scene), wrong))
    assert [finding.verdict for finding in findings] == [Verdict.REFUTED, Verdict.SUPPORTED]


def test_states_of_a_loop_close_it() -> None:
    scene = four_bar.scene()
    for state in drawn_states(scene):
        table = {e: state.plain()[e.name].mid() for e in scene.q}
        table |= {e: state.parameter(e).mid() for e in scene.parameters}
        l1, l2, l3, d = four_bar.l1, four_bar.l2, four_bar.l3, four_bar.d
        q1, q2, q3 = scene.q
        closed = l1 * cos(q1) + l2 * cos(q2) + l3 * cos(q3) - d
        values = {symbol: float(value) for symbol, value in table.items()}
        assert abs(closed.subs(values)) < 1e-12
        assert abs((l1 * sin(q1) + l2 * sin(q2) + l3 * sin(q3)).subs(values)) < 1e-12


def test_the_functions_through_which_the_routes_read_a_scene_may_be_gone(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    scene = rolling_disc.scene()
    equations = derive_with(scene, ("free_body",))["free_body"]
    assert equations.reactions
    assert equations.system[0].rows
    for name in ("relative_rotation", "step_vector", "components", "frame_path", "point_path"):
        monkeypatch.delattr(geometry, name)
    for name in ("position", "rotation", "vector", "plain", "rates", "coordinate_rates"):
        monkeypatch.delattr(declaration.Declaration, name)
    for function in ("differentiate.motions", "chain.motions", "motion.body_motions"):
        monkeypatch.delattr(f"mechanics.kinematics.{function}")
    found = check_virtual_power(equations, drawn_states(scene))
    assert found.verdict is Verdict.SUPPORTED

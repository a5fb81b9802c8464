"""Checks of programs say REFUTED, with a state, as soon as one of two routes is changed."""

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

import pytest
from linkages import LINKAGES, lifted_bead, parallelogram, slider_crank
from serial_arms import serial_arm
from sympy import Expr, Rational, acos, atan2, pi
from sympy.physics.mechanics import Dyadic, Point, ReferenceFrame, dynamicsymbols

from mechanics.checks import laws, reactions
from mechanics.checks.admissible import check_admissible, check_scene
from mechanics.checks.agreement import (
    Derived,
    check_multipliers,
    compare,
    compare_pairs,
    linear_system,
    matched,
)
from mechanics.equations import Rows
from mechanics.errors import SceneError, SingularError
from mechanics.kernel import Finding, Verdict, enclose
from mechanics.mechanism import Mechanism, lower
from mechanics.program import Builder, Node
from mechanics.program.derivatives import gradient
from mechanics.program.residues import Residues
from mechanics.routes import free_body, kane, lagrange, moving_point
from mechanics.scene import RigidBody, Scene, gravity, parameters, reaction, reaction_couple
from systems import ALL, elastic_pendulum, four_bar, pendulum_chain, rod_pendulum, rolling_disc

ROUTES = (free_body, moving_point, kane, lagrange)


def derived(mechanism: Mechanism) -> dict[str, Derived]:
    filter_ = Residues(mechanism.builder)
    rows = [route.derive(mechanism) for route in ROUTES]
    return {one.route: linear_system(mechanism, one, filter_) for one in rows}


def changed(mechanism: Mechanism, rows: Rows, change: Callable[[Node], Node]) -> Derived:
    """The route with its first row changed."""
    other = replace(rows, route="other", values=(change(rows.values[0]), *rows.values[1:]))
    return linear_system(mechanism, other, Residues(mechanism.builder))


def assert_refuted(finding: Finding) -> None:
    assert finding.verdict is Verdict.REFUTED
    assert finding.witness is not None
    assert finding.witness.state


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", ALL, ids=lambda system: system.name)
def test_all_pairs_are_shown(system) -> None:
    routes = derived(lower(system.scene(), Builder()))
    pairs = compare_pairs(routes)
    assert len(pairs) == 6
    assert all(finding.shown for finding in pairs.values())
    # Nothing is its own reason, whichever side of it is named first.
    told = {f"{two} = {one}: accelerations": f.evidence for (one, two), f in pairs.items()}
    assert not any(finding.subject in finding.evidence for finding in pairs.values())
    assert not any(turned in evidence for turned, evidence in told.items())


CHANGES = {
    "a term more": lambda m: lambda row: row + m.u[0] * m.q[-1],
    "an acceleration more": lambda m: lambda row: row + m.ud[-1],
    "a constant more": lambda m: lambda row: row + 1,
}


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", CHANGES)
@pytest.mark.parametrize("make", [elastic_pendulum.scene, rolling_disc.scene])
def test_a_changed_row_is_refuted(name: str, make) -> None:
    mechanism = lower(make(), Builder())
    routes = derived(mechanism)
    other = changed(mechanism, routes["kane"].rows, CHANGES[name](mechanism))
    assert_refuted(compare(other, routes["kane"], Residues(mechanism.builder)))
    pairs = compare_pairs({**routes, "other": other})
    assert {names for names, finding in pairs.items() if not finding.shown} == {
        (route, "other") for route in routes
    }


def test_rows_are_matched_up_to_order_and_sign() -> None:
    mechanism = lower(elastic_pendulum.scene(), Builder())
    filter_ = Residues(mechanism.builder)
    rows = kane.derive(mechanism)
    turned = replace(rows, values=(-rows.values[1], rows.values[0]))
    assert matched(filter_, rows.values, turned.values) == [(1, 1), (0, -1)]
    twice = replace(rows, values=(rows.values[0], rows.values[0]))
    assert matched(filter_, rows.values, twice.values) is None


def test_rows_that_are_no_system_are_refused() -> None:
    mechanism = lower(elastic_pendulum.scene(), Builder())
    rows = kane.derive(mechanism)
    same = replace(rows, values=(rows.values[0], 2 * rows.values[0]))
    with pytest.raises(SingularError, match="rank 1 for 2 unknowns"):
        linear_system(mechanism, same, Residues(mechanism.builder))


def test_a_false_mass_matrix_and_energy_are_refuted() -> None:
    mechanism = lower(pendulum_chain.scene(2), Builder())
    rows = kane.derive(mechanism)
    assert laws.check_mass_matrix(mechanism, rows).shown
    assert laws.check_energy(mechanism, rows).shown
    heavier = replace(rows, values=(rows.values[0] + mechanism.ud[1], *rows.values[1:]))
    assert_refuted(laws.check_mass_matrix(mechanism, heavier))
    pulled = replace(rows, values=(rows.values[0] + mechanism.q[0], *rows.values[1:]))
    assert laws.check_mass_matrix(mechanism, pulled).shown
    assert_refuted(laws.check_energy(mechanism, pulled))


def test_a_false_reaction_is_refuted() -> None:
    mechanism = lower(elastic_pendulum.scene(), Builder())
    by_kane = linear_system(mechanism, kane.derive(mechanism), Residues(mechanism.builder))
    rows = free_body.derive(mechanism)
    assert reactions.check_reactions(rows, by_kane).shown
    wrong = replace(rows, reactions={**rows.reactions, "N": -rows.reactions["N"]})
    assert_refuted(reactions.check_reactions(wrong, by_kane))


def test_a_reaction_that_does_work_is_refuted() -> None:
    mechanism = check_scene(elastic_pendulum.scene())
    first, *others = mechanism.reactions
    along_rail = mechanism.reactions[2].along
    rail = tuple((frame, (column[1], column[0], column[2])) for frame, column in along_rail)
    wrong = replace(mechanism, reactions=(first, *others[:-1], replace(others[-1], along=rail)))
    findings = list(laws.check_ideal(wrong, Residues(wrong.builder)))
    assert [finding.shown for finding in findings] == [True, True, False]
    assert findings[-1].verdict is Verdict.REFUTED
    assert findings[-1].witness is not None and findings[-1].witness.left.startswith("1.0")


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", ALL, ids=lambda system: system.name)
def test_laws_hold(system) -> None:
    mechanism = check_scene(system.scene())
    findings = [
        laws.check_kinematics(mechanism),
        *laws.check_potentials(mechanism),
        *laws.check_dampers(mechanism),
        *laws.check_frictions(mechanism),
        *laws.check_ideal(mechanism, Residues(mechanism.builder)),
    ]
    assert len(findings) > len(mechanism.reactions)
    assert all(finding.shown for finding in findings)


def planted(mechanism: Mechanism, rows: Rows) -> Derived:
    """The route with the sign of gravity wrong in its first row."""
    g = mechanism.builder.input("g")
    (weight,) = gradient([rows.values[0]], [1], [g])
    return changed(mechanism, rows, lambda row: row - 2 * weight * g)


@pytest.mark.sample(4)
@pytest.mark.parametrize("name", [*LINKAGES, "four_bar"])
def test_a_planted_sign_is_refuted_where_the_constraints_hold(name: str) -> None:
    mechanism = check_scene({**LINKAGES, "four_bar": four_bar.scene}[name]())
    anywhere, _ = mechanism.filters
    by_kane, by_lagrange = (
        linear_system(mechanism, route.derive(mechanism), mechanism.filters[1])
        for route in (kane, lagrange)
    )
    right = compare(by_lagrange, by_kane, anywhere)
    assert right.shown, right
    other = planted(mechanism, by_lagrange.rows)
    finding = compare(other, by_kane, anywhere)
    assert_refuted(finding)
    assert finding.witness is not None
    values = {n: Fraction(v) for n, v in (*finding.witness.state, *finding.witness.solved)}
    closure = mechanism.closure
    off = mechanism.builder.program({"off": [*closure.configuration, *closure.rates]})
    assert all(abs(entry) < 1e-12 for entry in enclose(off, values, 200)["off"])


def test_what_cannot_be_closed_is_undecided() -> None:
    mechanism = check_scene(parallelogram(False, "coupler"))
    by_kane, by_lagrange = (
        linear_system(mechanism, route.derive(mechanism), mechanism.filters[1])
        for route in (kane, lagrange)
    )
    unknown = replace(mechanism, closure=replace(mechanism.closure, dependent=()))
    one, two = replace(by_kane, mechanism=unknown), replace(by_lagrange, mechanism=unknown)
    finding = compare(one, two, mechanism.filters[0])
    assert finding.verdict is Verdict.UNDECIDED
    assert "no exact point on them is known" in finding.evidence


def test_a_scene_that_cannot_be_closed_is_not_refused_but_undecided() -> None:
    """Off the closed loop a pin that is told at the slider does work on the rod."""
    mechanism = check_scene(slider_crank("slider"))
    closure = replace(mechanism.closure, dependent=(), values={})
    unknown = replace(mechanism, closure=closure)
    check_admissible(unknown)
    findings = {f.subject: f for f in laws.check_ideal(unknown, mechanism.filters[1])}
    assert findings["reaction Ox: no power"].shown
    assert findings["reaction Qx: no power"].verdict is Verdict.UNDECIDED
    assert "no exact point on them is known" in findings["reaction Qx: no power"].evidence


def test_a_false_multiplier_is_refuted() -> None:
    mechanism = check_scene(slider_crank("slider"))
    closed = mechanism.filters[1]
    by_kane = linear_system(mechanism, kane.derive(mechanism), closed)
    rows = lagrange.derive(mechanism)
    assert check_multipliers(by_kane, linear_system(mechanism, rows, closed)).shown
    weaker = replace(rows, values=(rows.values[0] + mechanism.u[0], *rows.values[1:]))
    assert_refuted(check_multipliers(by_kane, linear_system(mechanism, weaker, closed)))


def test_energy_of_a_lifted_rail_counts_the_work_of_its_reaction() -> None:
    mechanism = check_scene(lifted_bead())
    assert laws.is_driven(mechanism)
    closed = mechanism.filters[1]
    support = linear_system(mechanism, free_body.derive(mechanism), closed)
    assert laws.check_energy_balance(support, support).shown
    still = replace(mechanism, reactions=())
    idle = replace(support, mechanism=still)
    assert_refuted(laws.check_energy_balance(idle, idle))


W, A, L = parameters("u v l", "m m m", "0.2 0.3 0.4")


@pytest.mark.campaign
@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "turns",
    [
        (pi / 6, pi / 2), (pi / 6, pi / 6), (pi / 5, pi / 2), (pi / 3, acos(Rational(3, 5))),
        (atan2(W, A), pi / 2), (atan2(W, A), atan2(L, A)), (pi / 2, pi / 6 + atan2(W, A)),
    ],
)  # fmt: skip
def test_roots_in_fixed_turns_are_roots(turns: tuple[Expr, Expr]) -> None:
    """sin^2 + cos^2 = 1 of a turn by pi / 6: couples across the joints' axes do no work."""
    mechanism = check_scene(serial_arm(3, axes="z", fixed="x", turn=turns).scene)
    filter_ = Residues(mechanism.builder)
    assert all(finding.shown for finding in laws.check_ideal(mechanism, filter_))
    pairs = compare_pairs(derived(mechanism))
    assert len(pairs) == 6
    assert all(finding.shown for finding in pairs.values())


def test_each_load_with_a_potential_has_its_finding() -> None:
    mechanism = check_scene(elastic_pendulum.scene())
    subjects = [finding.subject for finding in laws.check_potentials(mechanism)]
    assert subjects == [f"load {name}: force = -gradient of potential" for name in ("gravity", "k")]
    # A motor has no potential.
    (weight,) = laws.check_potentials(check_scene(rod_pendulum.scene()))
    assert weight.subject.startswith("load gravity")


def screw(inertia: Expr | Dyadic) -> Scene:
    """A nut that turns about an upright axis and moves along it, out of every plane."""
    N, O = ReferenceFrame("N"), Point("O")
    z, angle = dynamicsymbols("z angle")
    m, g = parameters("m g")
    nut, centre = N.orientnew("A", "Axis", (angle, N.z)), O.locatenew("C", z * N.z)
    across = [reaction(f"R{axis}", at=centre, on="nut", by=None, along=axis) for axis in (N.x, N.y)]
    upright = [reaction_couple(f"Q{axis}", on="nut", by=None, along=axis) for axis in (N.x, N.y)]
    return Scene(
        "screw", N, O, coordinates=(z, angle), loads=(gravity(-g * N.z),),
        bodies=(RigidBody("nut", centre, nut, m, inertia),), reactions=(*across, *upright),
    )  # fmt: skip


def test_a_scalar_inertia_out_of_its_plane_is_refused_about_any_axis() -> None:
    with pytest.raises(SceneError, match="body nut: its inertia is a scalar, but the scene leaves"):
        check_scene(screw(parameters("J")[0]))

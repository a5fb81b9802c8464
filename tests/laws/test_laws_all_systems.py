"""Laws over all systems and routes, and what moving_point chooses."""

from itertools import combinations
from typing import Any

import pytest

import systems
from mechanics.checks import laws
from mechanics.checks.agreement import compare
from mechanics.checks.energy import check_energy
from mechanics.checks.friction import check_friction
from mechanics.checks.reactions import check_multipliers, check_reactions
from mechanics.crosscheck import ROUTES
from mechanics.exact import Finding
from mechanics.routes import kane
from mechanics.routes.kane_reactions import auxiliary_equations
from mechanics.scene.actions import frictions

SYSTEMS = [system.name for system in systems.ALL]
NAMES = [route.name for route in ROUTES]


def shown(finding: Finding) -> bool:
    assert finding.shown, finding
    return True


@pytest.mark.parametrize("system", SYSTEMS)
@pytest.mark.parametrize("pair", list(combinations(NAMES, 2)), ids="-".join)
def test_routes_agree(derived: Any, system: str, pair: tuple[str, str]) -> None:
    one, two = (derived(system)[name] for name in pair)
    assert shown(compare(one, two))
    assert shown(compare(two, one))


@pytest.mark.parametrize("system", SYSTEMS)
def test_kinematics_and_loads(derived: Any, system: str) -> None:
    scene = derived(system)["kane"].scene
    findings = [laws.check_kinematics(scene), *laws.check_potentials(scene)]
    findings += [*laws.check_dampers(scene), *laws.check_ideal(scene), *check_friction(scene)]
    assert all(shown(finding) for finding in findings)
    assert len(findings) > len(scene.reactions)


@pytest.mark.parametrize("system", SYSTEMS)
@pytest.mark.parametrize("route", NAMES)
def test_energy_grows_by_the_power_of_the_loads(derived: Any, system: str, route: str) -> None:
    routes = derived(system)
    assert shown(check_energy(routes[route], routes["free_body"]))


@pytest.mark.parametrize("system", SYSTEMS)
def test_the_mass_matrix_is_the_metric_of_the_kinetic_energy(derived: Any, system: str) -> None:
    conjugate = [e for e in derived(system).values() if e.conjugate]
    # Friction that depends on the accelerations stands beside M, and not symmetrically.
    assert bool(conjugate) != bool(frictions(derived(system)["kane"].scene))
    for equations in conjugate:
        assert shown(laws.check_mass_matrix(equations))


@pytest.mark.parametrize("system", SYSTEMS)
def test_reactions_by_two_ways(derived: Any, system: str) -> None:
    equations = derived(system)["free_body"]
    scene = equations.scene
    findings = check_reactions(equations, auxiliary_equations(scene))
    assert all(shown(finding) for finding in findings)
    kept = {name for constraint in scene.constraints for name in constraint.reactions}
    assert len(findings) == len(scene.reactions) - len(kept)
    assert {symbol.name for symbol, _ in equations.reactions} | kept == {
        reaction.name for reaction in scene.reactions
    }


@pytest.mark.parametrize("system", [s.name for s in systems.ALL if s.scene().constraints])
def test_multipliers_agree(derived: Any, system: str) -> None:
    routes = derived(system)
    reference = kane.derive_with_multipliers(routes["kane"].scene)
    for name in ("free_body", "moving_point", "lagrange"):
        assert shown(check_multipliers(reference, routes[name]))
        assert shown(compare(reference, routes[name]))
    for name in ("free_body", "moving_point"):
        assert routes[name].multipliers == reference.multipliers


CHOSEN = {
    "elastic_pendulum": ("whole system: linear momentum along N.x",
                         "pendulum: moment about B, axis N.z"),
    "rocker": ("whole system: moment about B, axis N.z",),
    "two_mass_chain": ("first: linear momentum along N.x", "second: linear momentum along N.x"),
    "pendulum_chain": ("whole system: linear momentum along N.x",
                       "link1 + link2 + link3: moment about P0, axis N.z",
                       "link2 + link3: moment about P1, axis N.z",
                       "link3: moment about P2, axis N.z"),
    "four_bar": ("whole system: moment about A, axis N.z",
                 "coupler + rocker: moment about end of the crank, axis N.z",
                 "rocker: moment about end of the coupler, axis N.z"),
}  # fmt: skip


@pytest.mark.parametrize("system", CHOSEN)
def test_free_bodies_and_moment_centres_are_those_of_the_textbooks(
    derived: Any, system: str
) -> None:
    assert derived(system)["moving_point"].chosen == CHOSEN[system]

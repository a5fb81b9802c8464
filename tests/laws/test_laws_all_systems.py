"""Laws over all systems and closed loops by all routes, and what moving_point chooses."""

from collections.abc import Callable
from functools import cache
from typing import Any

import pytest
from linkages import LINKAGES
from shared_scenes import CONSTRAINED

import systems
from mechanics.checks import laws, reactions
from mechanics.checks.admissible import check_scene
from mechanics.checks.agreement import check_multipliers, compare
from mechanics.crosscheck import ROUTES
from mechanics.crosscheck.programs import Programs, check_textbook, derive_rows
from mechanics.kernel import Finding
from mechanics.mechanism import name_of
from mechanics.scene import Scene

SYSTEMS = [system.name for system in systems.ALL]
"""Those that are all small enough to be written out."""
NAMES = [route.name for route in ROUTES]
SCENES: dict[str, Callable[[], Scene]] = {
    **{system.name: system.scene for system in systems.EVERY},
    **LINKAGES,
}
WITH_MULTIPLIERS = [name for name in SCENES if name in CONSTRAINED or name in LINKAGES]


@cache
def programs_of(name: str) -> Programs:
    return derive_rows(check_scene(SCENES[name]()), NAMES)


def shown(finding: Finding) -> bool:
    assert finding.shown, finding
    return True


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", SCENES)
def test_routes_agree_either_way(name: str) -> None:
    programs = programs_of(name)
    anywhere, _ = programs.mechanism.filters
    routes = programs.routes.values()
    for one in routes:
        assert all(shown(compare(one, two, anywhere)) for two in routes if two is not one)


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", SYSTEMS)
def test_programs_are_the_textbook_forms(derived: Any, system: str) -> None:
    findings = list(check_textbook(programs_of(system), derived(system)))
    assert len(findings) == len(NAMES)
    assert all(shown(finding) for finding in findings)


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", SCENES)
def test_kinematics_and_loads(name: str) -> None:
    programs = programs_of(name)
    mechanism = programs.mechanism
    findings = [
        laws.check_kinematics(mechanism),
        *laws.check_potentials(mechanism),
        *laws.check_dampers(mechanism),
        *laws.check_frictions(mechanism),
        *laws.check_ideal(mechanism, programs.filter_),
    ]
    assert all(shown(finding) for finding in findings)
    assert len(findings) > len(mechanism.reactions)


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", SCENES)
def test_energy_grows_by_the_power_of_the_loads(name: str) -> None:
    programs = programs_of(name)
    mechanism = programs.mechanism
    for derived in programs.routes.values():
        # With reactions, of every route; without them, of rows that are power-conjugate to u.
        assert shown(laws.check_energy_balance(derived, programs.route("free_body")))
        if derived.rows.conjugate and not laws.is_driven(mechanism):
            assert shown(laws.check_energy(mechanism, derived.rows))


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", SCENES)
def test_the_mass_matrix_is_the_metric_of_the_kinetic_energy(name: str) -> None:
    programs = programs_of(name)
    rows = [derived.rows for derived in programs.routes.values()]
    conjugate = [one for one in rows if one.conjugate]
    # Friction that depends on the accelerations stands beside M, and not symmetrically.
    assert bool(conjugate) != bool(programs.mechanism.frictions)
    assert all(shown(laws.check_mass_matrix(programs.mechanism, one)) for one in conjugate)


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", SCENES)
def test_reactions_by_two_ways(name: str) -> None:
    programs = programs_of(name)
    rows = programs.route("free_body").rows
    assert shown(reactions.check_reactions(rows, programs.route("kane")))
    kept = {name_of(multiplier) for multiplier in rows.multipliers}
    assert rows.reactions.keys() | kept == {r.name for r in programs.mechanism.reactions}
    assert not rows.reactions.keys() & kept


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", WITH_MULTIPLIERS)
def test_multipliers_agree(name: str) -> None:
    programs = programs_of(name)
    kane = programs.route("kane")
    assert shown(check_multipliers(kane, programs.route("lagrange")))
    for other in ("free_body", "moving_point"):
        # Compared with their accelerations: the unknowns are the same reactions.
        assert programs.route(other).unknowns == kane.unknowns


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

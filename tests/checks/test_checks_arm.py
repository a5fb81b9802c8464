"""Checks of an arm in space with every kind of load: what holds, and what is refused."""

from dataclasses import replace

import pytest

from benchmarks.faults.scenes import arm
from mechanics.checks.admissible import check_admissible
from mechanics.checks.laws import check_dampers, check_potentials
from mechanics.errors import SceneError
from mechanics.mechanism import Mechanism, lower
from mechanics.program import Builder


@pytest.fixture(scope="module")
def mechanism() -> Mechanism:
    return lower(arm(), Builder())


def test_an_arm_is_admissible_and_its_loads_have_their_power(mechanism: Mechanism) -> None:
    check_admissible(mechanism)
    findings = [*check_dampers(mechanism), *check_potentials(mechanism)]
    assert len(findings) == 4
    assert all(finding.shown for finding in findings)


def test_bodies_without_mass_are_refused(mechanism: Mechanism) -> None:
    zero = mechanism.builder.zero
    none = ((zero,) * 3,) * 3
    bodies = tuple(replace(body, mass=zero, inertia=none) for body in mechanism.bodies)
    with pytest.raises(SceneError, match="singular: nothing resists a change of q1_dot"):
        check_admissible(replace(mechanism, bodies=bodies, fields=()))


def test_a_scalar_inertia_in_space_is_refused(mechanism: Mechanism) -> None:
    bodies = tuple(replace(body, scalar=True) for body in mechanism.bodies)
    with pytest.raises(SceneError, match="its inertia is a scalar"):
        check_admissible(replace(mechanism, bodies=bodies))


def test_a_torsion_spring_counts_from_the_body_it_stands_on(mechanism: Mechanism) -> None:
    (load,) = mechanism.torsions
    for wrong in (replace(load, by=-1), replace(load, angle=-load.angle)):
        with pytest.raises(SceneError, match="is not how far"):
            check_admissible(replace(mechanism, torsions=(wrong,)))

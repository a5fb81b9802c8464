"""Generalized momenta over all systems.

sum p_i q_i' = 2 T        p_i = sum_j dT/du_j du_j/dq_i'        p_i' = d(T - V)/dq_i
"""

from typing import Any

import pytest
from shared_scenes import CONSERVATIVE
from sympy import Add
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols

import systems
from mechanics import Particle, Scene, parameters
from mechanics.checks.ledger import check_row
from mechanics.errors import InputError
from mechanics.kinematics.symbolic import Kinematics
from mechanics.routes.derivation import by_route
from mechanics.scene.momenta import momentum_symbols
from mechanics.scene.potential import potential
from mechanics.scene.published import published
from mechanics.scene.quantities import (
    EquationOfMotion,
    GeneralizedMomentum,
    Identity,
    KineticEnergy,
)

SYSTEMS = [system.name for system in systems.ALL]
FREE = [name for name in SYSTEMS if name in CONSERVATIVE]


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", SYSTEMS)
def test_momenta_times_rates_are_twice_the_kinetic_energy(derived: Any, name: str) -> None:
    scene = derived(name)["kane"].scene
    pairs = zip(momentum_symbols(scene), scene.qd, strict=True)
    half = Add(*(p * rate for p, rate in pairs)) / 2
    assert check_row(scene, published("T", KineticEnergy(), half, label="p q'/2")).shown
    wrong = published("T", KineticEnergy(), 2 * half, label="p q'")
    assert not check_row(scene, wrong).shown


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", SYSTEMS)
def test_each_is_the_slope_of_the_kinetic_energy(derived: Any, name: str) -> None:
    scene = derived(name)["kane"].scene
    energy = Kinematics(scene).kinetic_energy
    slopes = [energy.diff(u) for u in scene.u]
    for q, rate in zip(scene.q, scene.qd, strict=True):
        weights = [1 if u == rate else 0 for u in scene.u]
        if scene.speeds:
            weights = [scene.rates(definition).diff(rate) for _, definition in scene.speeds]
        total = Add(*(slope * weight for slope, weight in zip(slopes, weights, strict=True)))
        row = published("p", GeneralizedMomentum(q.name), total, label=q.name)
        assert check_row(scene, row).shown


@pytest.mark.parametrize("name", FREE)
def test_lagranges_equations_in_momenta(derived: Any, name: str) -> None:
    equations = derived(name)["lagrange"]
    scene = equations.scene
    lagrangian = equations.kinematics.kinetic_energy - potential(scene)
    for q in scene.q:
        p = dynamicsymbols(f"p_{q.name}")
        row = published("p'", EquationOfMotion(), p.diff(), lagrangian.diff(q), label=q.name)
        assert check_row(scene, row, equations).shown
        wrong = published("p'", EquationOfMotion(), p.diff(), -lagrangian.diff(q), label=q.name)
        assert check_row(scene, wrong, equations).shown is (lagrangian.diff(q) == 0)


def test_names_that_the_scene_uses_stay_its_own() -> None:
    x, y = dynamicsymbols("x y")
    p_x, m = parameters("p_x m")
    ground, origin = ReferenceFrame("N"), Point("O")
    place = origin.locatenew("P", x * ground.x + (y + p_x) * ground.y)
    scene = Scene("p", ground, origin, coordinates=(x, y), bodies=(Particle("bob", place, m),))
    assert [symbol.name for symbol in momentum_symbols(scene)] == ["p_y"]
    equations = by_route("lagrange", scene)
    row = published("1", Identity(), dynamicsymbols("p_y"), m * y.diff(), label="momentum")
    assert check_row(scene, row, equations).shown
    with pytest.raises(InputError, match="no momentum of 'x': the coordinates are y"):
        check_row(scene, published("2", GeneralizedMomentum("x"), m, label=""), equations)

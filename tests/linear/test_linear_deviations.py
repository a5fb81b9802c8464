"""Linear equations against the deviations of the exact ones."""

from dataclasses import replace
from functools import cache
from typing import Any

import pytest
from quaternions import ball_top
from steady_scenes import OMEGA, foucault, top
from sympy import Matrix, Symbol

from benchmarks.faults.deviations import check_linear
from benchmarks.faults.poles import check_speed_form, check_stability
from mechanics.checks.agreement import Derived, linear_system
from mechanics.equations import Equations
from mechanics.kernel import Verdict
from mechanics.linear import Linear, linearize, speed_form
from mechanics.mechanism import lower
from mechanics.program import Builder
from mechanics.routes.derivation import ROUTES, as_program
from systems import rolling_disc

SPEED = Symbol("v", positive=True)
MOTIONS: dict[str, tuple[Any, dict[str, Any]]] = {
    "disc": (
        rolling_disc.scene,
        {"at": {"lean": 0}, "speeds": {"u2": SPEED / rolling_disc.R}},
    ),
    "top": (lambda: top("xyz"), {"at": {"a": 0, "b": 0}, "speeds": {"c_dot": OMEGA}}),
    "table": (
        foucault,
        {"at": {"x": 0, "y": 0}, "inputs": {"psi": 0}, "speeds": {"psi_dot": OMEGA}},
    ),
    "hanging top": (ball_top, {"at": {"e0": 0, "e1": 1, "e2": 0, "e3": 0}}),
}


@cache
def derived(name: str, route: str) -> tuple[Equations, Derived]:
    scene = MOTIONS[name][0]()
    mechanism = lower(scene, Builder())
    (rows,) = (one.rows(mechanism) for one in ROUTES if one.name == route)
    system = linear_system(mechanism, rows, mechanism.filters[1])
    return as_program(scene, mechanism, rows), system


def linear(name: str, route: str = "lagrange") -> tuple[Linear, Derived]:
    equations, system = derived(name, route)
    return linearize(equations, **MOTIONS[name][1]), system


@pytest.mark.sample(1)
@pytest.mark.parametrize("route", [route.name for route in ROUTES])
@pytest.mark.parametrize("name", MOTIONS)
def test_linear_equations_are_those_of_deviations(name: str, route: str) -> None:
    rates = {"psi_dot": OMEGA} if name == "table" else {}
    assert check_linear(*linear(name, route), rates).verdict is Verdict.SUPPORTED


@pytest.mark.sample(1)
@pytest.mark.parametrize("part", ["mass", "damping", "stiffness"])
def test_a_wrong_entry_is_refuted(part: str) -> None:
    found, system = linear("disc")
    matrix = Matrix(getattr(found, part))
    matrix[0, 0] += 1
    wrong = found.with_matrices(found.inputs, **{part: matrix})
    assert check_linear(wrong, system).verdict is Verdict.REFUTED


@pytest.mark.campaign
def test_a_multiple_of_all_matrices_is_refuted_of_rows_that_are_conjugate() -> None:
    found, system = linear("disc")
    parts = {name: 2 * getattr(found, name) for name in ("mass", "damping", "stiffness")}
    doubled = found.with_matrices(found.inputs, **parts)
    assert check_linear(doubled, system).verdict is Verdict.SUPPORTED
    conjugate = replace(doubled, conjugate=True)
    assert check_linear(conjugate, system).verdict is Verdict.REFUTED


@pytest.mark.campaign
@pytest.mark.parametrize("name", ["disc", "top"])
def test_conditions_of_stability_are_those_of_the_poles(name: str) -> None:
    found, _ = linear(name)
    assert check_stability(found).verdict is Verdict.SUPPORTED
    turned = found.with_matrices(found.inputs, stiffness=-found.stiffness)
    assert check_stability(turned).verdict is Verdict.SUPPORTED


def test_the_form_in_v_has_the_poles_of_the_linear_equations() -> None:
    found, _ = linear("disc")
    assert check_speed_form(speed_form(found, "v"), "v").verdict is Verdict.SUPPORTED

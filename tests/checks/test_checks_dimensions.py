"""Dimensions of published rows: of every system consistent; what is not is named, term by term."""

import functools
from collections.abc import Mapping
from dataclasses import replace

import pytest
from sympy import Derivative, Symbol, sin
from sympy.physics.mechanics import dynamicsymbols

from mechanics.checks.dimensions import check_dimensions
from mechanics.compiled import compile
from mechanics.kernel import Verdict
from mechanics.routes.derivation import by_route
from mechanics.scene import Scene
from mechanics.scene.linear_quantities import InertiaAbout, operating_point
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion
from systems import ALL, elastic_pendulum

t = dynamicsymbols._t
x, theta = elastic_pendulum.x, elastic_pendulum.theta
M, m, L, k, g = (getattr(elastic_pendulum, name) for name in "MmLkg")


@functools.cache
def case(name: str) -> tuple[Scene, Mapping[Symbol, str]]:
    scene = next(system for system in ALL if system.name == name).scene()
    known = compile(by_route("free_body", scene), compiler=None).quantities
    groups = (known.q, known.u, known.ud, known.inputs, known.p, known.multipliers, known.reactions)
    return scene, {entry.symbol: entry.unit for group in groups for entry in group if entry.unit}


@pytest.mark.sample(2)
@pytest.mark.parametrize("system", ALL, ids=lambda system: system.name)
def test_published_rows_of_every_system_are_consistent(system) -> None:
    found = check_dimensions(*_arguments(system))
    assert [finding.verdict for finding in found] in ([Verdict.PROVED], [])
    assert found or system.name != "elastic_pendulum"


def _arguments(system):
    scene, units = case(system.name)
    return scene, system.published, units


TYPING_ERRORS = [
    (M * L * theta.diff(t, 2) + M * g * L * sin(theta), "L*M*theta_ddot", "kg*m*s^-2",
     "L*M*g*sin(theta)", "kg*m^2*s^-2"),
    ((M + m) * x.diff(t, 2) + k * x**2, "k*x^2", "kg*m*s^-2", "", ""),
    ((M + m + 1) * x.diff(t, 2) + k * x, "1", "", "M", "kg"),
    (M * g * sin(theta * L) + k * x, "L*theta in sin(L*theta)", "m, not 1", "", ""),
    (Derivative(M * x, t) + k * x, "k*x", "kg*m*s^-2", "M*x_dot", "kg*m*s^-1"),
]  # fmt: skip


@pytest.mark.parametrize("row", range(len(TYPING_ERRORS)))
def test_a_typing_error_is_named_with_both_dimensions(row: int) -> None:
    side, *words = TYPING_ERRORS[row]
    scene, units = case("elastic_pendulum")
    wrong = published("(9)", EquationOfMotion(), side, 0, label="mistyped")
    (finding,) = check_dimensions(scene, [wrong], units)
    assert finding.verdict is Verdict.REFUTED and finding.subject == "(9) mistyped: dimensions"
    said = finding.evidence.replace("**", "^")
    assert "has the unit" in said and "correct the row, or the unit of a parameter" in said
    assert all(word in said for word in words), said


def test_a_wrong_unit_of_a_parameter_is_found_where_it_is_used() -> None:
    scene, units = case("elastic_pendulum")
    wrong = {**units, next(s for s in units if s.name == "k"): "N*m"}
    rows = next(system for system in ALL if system.name == "elastic_pendulum").published
    found = check_dimensions(scene, rows, wrong)
    bad = [finding for finding in found if finding.verdict is Verdict.REFUTED]
    assert bad and all("k*x" in finding.evidence for finding in bad)
    assert all("kg*m^3*s^-2" in finding.evidence for finding in bad)


def test_where_nothing_is_known_nothing_is_said() -> None:
    scene, units = case("elastic_pendulum")
    row = published("(1)", EquationOfMotion(), k * x + m * g, 0, label="sum")
    some = {symbol: unit for symbol, unit in units.items() if symbol.name != "k"}
    (finding,) = check_dimensions(scene, [row], some)
    assert finding.verdict is Verdict.PROVED
    bare = replace(scene, loads=tuple(_with_number(load) for load in scene.loads))
    assert check_dimensions(bare, [row], units) == ()


def _with_number(load):
    """Gravity as a number, which has a unit that nothing tells."""
    return replace(load, field=load.field.subs(g, 9.81)) if hasattr(load, "field") else load


def test_a_symbol_without_a_unit_has_that_of_its_definition() -> None:
    scene, units = case("elastic_pendulum")
    I_C = elastic_pendulum.I_C
    bare = {symbol: unit for symbol, unit in units.items() if symbol != I_C}
    row = published("(1)", EquationOfMotion(), I_C * theta.diff(t, 2) + M * L, 0, label="sum")
    (finding,) = check_dimensions(scene, [row], bare)
    assert finding.verdict is Verdict.REFUTED
    assert "kg*m^2*s^-2" in finding.evidence.replace("**", "^")


def test_rows_about_linear_equations_are_left_out() -> None:
    scene, units = case("elastic_pendulum")
    row = published(
        "(1)",
        InertiaAbout(operating_point({"x": 0}), "pendulum", "C", "theta"),
        k + m,
        label="numbers may be lengths there",
    )
    assert check_dimensions(scene, [row], units) == ()

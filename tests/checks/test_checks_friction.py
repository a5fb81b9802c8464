"""The cart-pole with friction: what its sources print, right and wrong."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sympy import Symbol, sign

import mechanics
from mechanics.checks import laws
from mechanics.checks.agreement import Derived, compare, linear_system
from mechanics.checks.ledger import check_row
from mechanics.crosscheck import derive
from mechanics.equations import Equations
from mechanics.kernel import Verdict
from mechanics.mechanism import lower
from mechanics.program import Builder
from mechanics.routes import free_body, kane, lagrange, moving_point
from mechanics.scene import Scene
from mechanics.scene.published import published
from mechanics.scene.quantities import EquationOfMotion
from mechanics.symbolic import is_zero, slope
from systems import cartpole_friction as system


@pytest.fixture(scope="module")
def truth() -> Equations:
    return derive(system.scene(), "free_body")


@pytest.mark.parametrize("row", system.PUBLISHED, ids=lambda row: row.tag)
def test_florian_is_right_with_the_sine(truth: Equations, row: Any) -> None:
    assert check_row(truth.scene, row, truth).verdict is Verdict.PROVED


@pytest.mark.parametrize("row", (system.TRANSCRIBED, *system.CLASSIC), ids=lambda row: row.tag)
def test_without_the_sine_or_the_normal_force_it_is_wrong(truth: Equations, row: Any) -> None:
    finding = check_row(truth.scene, row, truth)
    assert finding.verdict is Verdict.REFUTED
    assert finding.witness is not None
    assert float(dict(finding.witness.solved)["N_c"]) > 0


def test_without_friction_all_of_them_are_right() -> None:
    """mu_c = 0: the mistakes are about friction only."""
    scene = system.scene()
    truth = derive(scene, "free_body")
    smooth = {Symbol(system.mu_c.name, positive=True): 0, system.mu_c: 0}
    for row in (system.TRANSCRIBED, *system.CLASSIC):
        sides = tuple(scene.plain(side).xreplace(smooth) for side in row.sides)
        matrices = {
            "mass": truth.mass.xreplace(smooth), "forcing": truth.forcing.xreplace(smooth)
        }  # fmt: skip
        still = replace(truth.with_matrices(**matrices), reactions=())
        smooth_row = replace(row, sides=sides)
        assert check_row(scene, smooth_row, still).verdict is Verdict.PROVED, row.tag


def test_a_row_about_a_reaction_asks_for_a_route_that_tells_it(truth: Equations) -> None:
    row = system.PUBLISHED[1]
    assert row.sides[1].has(system.N_c)
    for route in ("kane", "lagrange"):
        equations = derive(truth.scene, route)
        assert check_row(truth.scene, row, equations).verdict is Verdict.PROVED
    finding = check_row(truth.scene, row, derive(truth.scene, "moving_point"))
    assert finding.verdict is Verdict.UNDECIDED
    assert "moving_point does not give N_c: take those of free_body" in finding.evidence


def by(route: Any, scene: Scene, builder: Builder | None = None) -> Derived:
    mechanism = lower(scene, builder or Builder())
    return linear_system(mechanism, route.derive(mechanism), mechanism.filters[1])


def test_the_energy_that_friction_takes_out(truth: Equations) -> None:
    builder = Builder()
    support = by(free_body, truth.scene, builder)
    for route in (free_body, moving_point, kane, lagrange):
        finding = laws.check_energy_balance(by(route, truth.scene, builder), support)
        assert finding.verdict is Verdict.PROVED, finding
    (finding,) = laws.check_frictions(support.mechanism)
    assert finding.verdict is Verdict.PROVED


def test_energy_at_accelerations_of_less_friction_is_refuted(truth: Equations) -> None:
    builder, scene = Builder(), truth.scene
    support = by(free_body, scene, builder)
    half = replace(scene.loads[2], coefficient=system.mu_c / 2)
    wrong = by(kane, replace(scene, loads=(*scene.loads[:2], half, scene.loads[3])), builder)
    wrong = replace(wrong, mechanism=support.mechanism)
    assert laws.check_energy_balance(wrong, support).verdict is Verdict.REFUTED


def test_friction_the_wrong_way_is_refuted(truth: Equations) -> None:
    left, right = system.PUBLISHED[3].sides
    row = published("w", EquationOfMotion(), left, right.subs(system.mu_c, -system.mu_c), label="")
    assert check_row(truth.scene, row, truth).verdict is Verdict.REFUTED


def test_a_python_function_with_a_sign_is_proved(truth: Equations) -> None:
    def rates(x: float, x_dot: float, theta: float, theta_dot: float, F: float, p: Any) -> Any:
        m_c, m_p, l, g, mu_c, mu_p = p
        total, s = m_c + m_p, np.sign(x_dot)
        push = (-F - m_p * l * theta_dot**2 * (np.sin(theta) + mu_c * s * np.cos(theta))) / total
        above = g * np.sin(theta) + np.cos(theta) * (push + mu_c * g * s)
        reach = np.cos(theta) - mu_c * s * np.sin(theta)
        lever = 4 / 3 - m_p * np.cos(theta) / total * reach
        thetaacc = (above - mu_p * theta_dot / (m_p * l)) / (l * lever)
        N = total * g - m_p * l * (thetaacc * np.sin(theta) + theta_dot**2 * np.cos(theta))
        swing = m_p * l * (theta_dot**2 * np.sin(theta) - thetaacc * np.cos(theta))
        return np.array([x_dot, theta_dot, (F + swing - mu_c * N * s) / total, thetaacc])

    names = {"p": "m_c m_p l g mu_c mu_p"}
    found = mechanics.check(truth, rates, names=names)
    assert found.ok, [judged.finding for judged in found.judged]


C = """#include <math.h>
static double sgn(double v) {{ return {sign}; }}
void dynamics(double x, double theta, double x_dot, double theta_dot, double F, double m_c,
              double m_p, double l, double g, double mu_c, double mu_p, double ud[2]) {{
    double s = sgn(x_dot), total = m_c + m_p, w2 = theta_dot*theta_dot;
    double push = (-F - m_p*l*w2*(sin(theta) + mu_c*s*cos(theta)))/total + mu_c*g*s;
    double lever = 4.0/3.0 - m_p*cos(theta)/total*(cos(theta) - mu_c*s*sin(theta));
    double acc = (g*sin(theta) + cos(theta)*push - mu_p*theta_dot/(m_p*l))/(l*lever);
    double n = total*g - m_p*l*(acc*sin(theta) + w2*cos(theta));
    ud[0] = (F + m_p*l*(w2*sin(theta) - acc*cos(theta)) - mu_c*n*s)/total;
    ud[1] = acc;
}}
"""
SIGNS = {
    "(v > 0) - (v < 0)": True,
    "v > 0 ? 1.0 : (v < 0 ? -1.0 : 0.0)": True,
    "copysign(1.0, v)": True,
    "(v < 0) - (v > 0)": False,
    "v > 0": False,
}


@pytest.mark.sample(2)
@pytest.mark.parametrize("sign", SIGNS)
def test_signs_as_people_write_them_in_c(truth: Equations, tmp_path: Path, sign: str) -> None:
    file = tmp_path / "friction.c"
    file.write_text(C.format(sign=sign), encoding="utf-8")
    found = mechanics.check(truth, file, blame=False)
    assert [judged.finding.shown for judged in found.judged] == [SIGNS[sign]] * 2


def test_a_sign_by_division_has_no_value_at_rest(truth: Equations, tmp_path: Path) -> None:
    file = tmp_path / "friction.c"
    file.write_text(C.format(sign="v / fabs(v)"), encoding="utf-8")
    found = mechanics.check(truth, file, blame=False)
    assert [judged.finding.verdict for judged in found.judged] == [Verdict.UNDECIDED] * 2
    assert all("NaN at rest" in judged.finding.domain for judged in found.judged)


@pytest.mark.campaign
def test_friction_that_is_left_out_is_found(truth: Equations) -> None:
    """Routes that forget it, or half of it, differ from those that do not."""
    scene = truth.scene
    builder = Builder()
    right = by(free_body, scene, builder)
    anywhere, _ = right.mechanism.filters
    smooth = by(kane, replace(scene, loads=(*scene.loads[:2], scene.loads[3])), builder)
    assert compare(right, smooth, anywhere).verdict is Verdict.REFUTED
    other = replace(scene.loads[2], coefficient=system.mu_c / 2)
    half = by(lagrange, replace(scene, loads=(*scene.loads[:2], other, scene.loads[3])), builder)
    assert compare(right, half, anywhere).verdict is Verdict.REFUTED


def test_a_sign_is_constant_between_its_jumps() -> None:
    x, y = Symbol("x", real=True), Symbol("y", real=True)
    assert slope(y * sign(x), x) == 0
    assert slope(y * sign(x), y) == sign(x)
    assert slope(x**2 * sign(sign(x) * y), x) == 2 * x * sign(sign(x) * y)
    assert is_zero(slope(abs(x) * y, x) - y * sign(x))

"""Every integrator against the reference: error, order, counts, what it refuses and how it ends."""

import dataclasses
import functools
import importlib.util
import math
from collections.abc import Callable

import numpy as np
import pytest
from particles import pushed
from scipy.integrate import solve_ivp

from benchmarks.problems import pose
from mechanics.compiled.machine.native import find_compiler
from mechanics.compiled.model import Model, compile
from mechanics.compiled.tableaus import TABLEAUX
from mechanics.errors import InputError
from mechanics.routes.derivation import by_route
from mechanics.simulate.integrators import INTEGRATORS, Integrator, Outcome, Problem, Setting
from mechanics.simulate.integrators.rate import Rate
from mechanics.simulate.integrators.stiffness import rates_at_start
from mechanics.simulate.reference import Reference, reference
from systems import ALL

SYSTEMS = ("elastic_pendulum", "rocker", "two_mass_chain", "rolling_disc", "four_bar")
MEMBERS = {member.name: member for member in INTEGRATORS}
ORDERS = {
    "C RK4": 4, "C RK5": 5, "C RK8": 8, "C Gauss2": 2, "C Gauss6": 6, "CasADi RK4": 4,
    "CasADi Gauss6": 6,
}  # fmt: skip
# Steps at which the error is that of the method: above rounding, below saturation.
STEPS = {"C RK8": 0.1, "C Gauss2": 0.01}
DURATION = 0.5


@functools.cache
def model_with(name: str, compiler: str | None) -> Model:
    return compile(
        by_route("kane", {system.name: system.scene for system in ALL}[name]()), compiler=compiler
    )


@functools.cache
def posed(name: str, compiler: str | None = "auto") -> Problem:
    return pose(model_with(name, compiler), np.linspace(0, DURATION, 6))


@functools.cache
def referred(name: str) -> Reference:
    return reference(posed(name))


def solved(problem: Problem, setting: Setting) -> Outcome:
    member = MEMBERS[setting.integrator]
    if why := member.available():
        pytest.skip(why)
    assert member.suits(problem, setting) == ""
    return member.prepare(problem, setting)()


def fine(member: Integrator, tolerance: float = 1e-9, step: float = 1e-3) -> Setting:
    return Setting(member.name, tolerance) if member.adaptive else Setting(member.name, step=step)


def error(problem: str, outcome: Outcome) -> float:
    known = referred(problem)
    return float(np.max(known.errors(outcome.states) / known.scale))


@pytest.mark.sample(0)
@pytest.mark.parametrize("member", INTEGRATORS, ids=lambda member: member.name)
@pytest.mark.parametrize("system", SYSTEMS)
def test_every_integrator_follows_the_reference(system: str, member: Integrator) -> None:
    if find_compiler() is None and member.name.startswith("C Gauss"):
        pytest.skip("no C compiler here")
    outcome = solved(posed(system), fine(member))
    assert outcome.failure == "" and len(outcome.states) == 6 and outcome.evaluations > 0
    assert error(system, outcome) < (1e-3 if member.name == "C Gauss2" else 2e-5)
    assert np.array_equal(outcome.states[0], posed(system).start)


@pytest.mark.parametrize(("name", "order"), ORDERS.items())
def test_error_of_fixed_steps_falls_with_the_order(name: str, order: int) -> None:
    step = STEPS.get(name, 0.05)
    errors = [
        error("elastic_pendulum", solved(posed("elastic_pendulum"), Setting(name, step=h)))
        for h in (step, step / 2)
    ]
    assert math.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.75)


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "member", [m for m in INTEGRATORS if m.adaptive], ids=lambda member: member.name
)
def test_error_of_adaptive_methods_falls_with_the_tolerance(member: Integrator) -> None:
    errors = [
        error("elastic_pendulum", solved(posed("elastic_pendulum"), Setting(member.name, tol)))
        for tol in (1e-5, 1e-8, 1e-11)
    ]
    assert errors[0] > 10 * errors[1] > 100 * errors[2]
    assert errors[2] < 2e-8


@pytest.mark.parametrize("name", ["C RK4", "C RK8", "C Gauss6", "SciPy DOP853", "heyoka Taylor"])
def test_single_precision_has_errors_of_single_precision(name: str) -> None:
    member = MEMBERS[name]
    setting = dataclasses.replace(fine(member, 1e-6, 5e-3), arithmetic="single")
    assert 1e-9 < error("elastic_pendulum", solved(posed("elastic_pendulum"), setting)) < 1e-4


def test_evaluations_are_counted_as_they_are() -> None:
    problem = posed("elastic_pendulum")
    to_the_end = dataclasses.replace(problem, times=problem.times[[0, -1]])
    rate = Rate(to_the_end)
    own = solve_ivp(rate, (0, DURATION), problem.start, "DOP853", rtol=1e-8, atol=1e-8)
    found = solved(to_the_end, Setting("SciPy DOP853", 1e-8))
    assert found.evaluations == own.nfev == rate.evaluations
    for tableau in TABLEAUX:
        steps = solved(problem, Setting(f"C {tableau.name}", step=0.01)).evaluations
        assert steps == 50 * len(tableau.a)
    if problem.model.compiler is not None:
        assert solved(problem, Setting("CasADi RK4", step=0.01)).evaluations == 200
        virtual = solved(posed("elastic_pendulum", None), Setting("SUNDIALS CVODES", 1e-8))
        native = solved(problem, Setting("SUNDIALS CVODES", 1e-8))
        # On the virtual machine SUNDIALS tells its own count.
        assert (virtual.evaluations, virtual.jacobians) == (native.evaluations, native.jacobians)


@pytest.mark.parametrize("member", INTEGRATORS, ids=lambda member: member.name)
def test_without_a_compiler_it_works_or_says_so(member: Integrator) -> None:
    problem, setting = posed("two_mass_chain", None), fine(member)
    assert "virtual machine" in problem.model.backend
    if why := member.available() or member.suits(problem, setting):
        assert "compiler" in why or "installed" in why
        return
    outcome = member.prepare(problem, setting)()
    assert outcome.evaluations > 0 and error("two_mass_chain", outcome) < 1e-6


@pytest.mark.campaign
def test_constant_inputs_work_everywhere_and_functions_where_they_can() -> None:
    model, times = model_with("four_bar", "auto"), np.linspace(0, 0.2, 3)
    constant, moving = (pose(model, times, inputs={"tau": tau}) for tau in (0.3, lambda t: 0.3))
    expected = solved(constant, Setting("SciPy DOP853", 1e-11)).states
    for member in INTEGRATORS:
        if member.available():
            continue
        found = solved(constant, fine(member, 1e-10, 5e-4))
        assert np.allclose(found.states, expected, rtol=1e-4, atol=1e-4)
        why = member.suits(moving, fine(member))
        assert "tau" in why if member.family != "SciPy" else why == ""
    assert np.allclose(solved(moving, Setting("SciPy DOP853", 1e-11)).states, expected)


@pytest.mark.parametrize("member", INTEGRATORS, ids=lambda member: member.name)
def test_a_setting_without_tolerance_and_step_is_refused(member: Integrator) -> None:
    assert "found" in member.suits(posed("rocker"), Setting(member.name))


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "member", [m for m in INTEGRATORS if m.adaptive], ids=lambda member: member.name
)
def test_a_budget_ends_it_with_a_sentence(member: Integrator) -> None:
    problem = dataclasses.replace(posed("four_bar"), budget=60)
    outcome = (
        MEMBERS[member.name].available() or member.prepare(problem, Setting(member.name, 1e-11))()
    )
    if isinstance(outcome, str):
        pytest.skip(outcome)
    assert outcome.failure.startswith(member.name) and len(outcome.states) < 6
    assert "allow" in outcome.failure or "used up" in outcome.failure


def test_fixed_steps_beyond_the_budget_or_stability_are_refused() -> None:
    problem = dataclasses.replace(posed("rocker"), budget=100)
    assert "2e+03 evaluations are needed, 1e+02 allowed" in MEMBERS["C RK4"].suits(
        problem, Setting("C RK4", step=1e-3)
    )


def test_heyoka_says_how_to_install_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    assert "pip install 'mechanics[taylor]'" in MEMBERS["heyoka Taylor"].available()


@pytest.mark.parametrize("member", INTEGRATORS, ids=lambda member: member.name)
def test_a_start_that_is_not_finite_is_named(member: Integrator) -> None:
    problem = posed("elastic_pendulum")
    lost = dataclasses.replace(problem, start=np.array([0.0, math.nan, 0.0, 0.0]))
    assert member.suits(lost, fine(member)) == "theta is nan: a finite number is needed"
    fast = dataclasses.replace(problem, start=np.array([0.0, 1.0, 0.0, 1e200]))
    assert "is not finite at the start" in member.suits(fast, fine(member))


@pytest.mark.parametrize("times", [1.0, [0.0], [0.1, 1.0], [0.0, 1.0, 1.0], [[0.0, 1.0]]])
def test_times_have_to_increase_from_zero(times) -> None:
    with pytest.raises(InputError, match="give at least 2 numbers that increase from 0"):
        pose(model_with("rocker", "auto"), times)


@pytest.fixture(scope="module")
def stiff() -> Problem:
    """Springs of 1e10 N/m: a carriage of 1 kg trembles at 1e5 rad/s with a tenth of a nanometre."""
    return pose(
        model_with("elastic_pendulum", "auto"),
        np.linspace(0, 0.02, 3),
        initial={"x": 0.0, "theta": 1.0},
        parameters={"k": 1e10},
        budget=3000,
    )


@pytest.fixture(scope="module")
def stiff_reference(stiff: Problem) -> Reference:
    return reference(stiff)


@pytest.mark.campaign
def test_stiff_problems_are_refused_by_explicit_methods_and_solved_by_implicit(
    stiff, stiff_reference
) -> None:
    assert np.max(np.abs(rates_at_start(stiff))) > 1e5
    for name in ("SciPy RK45", "SciPy DOP853"):
        assert "stiff: the fastest motion has 1.06e+05 rad/s" in MEMBERS[name].suits(
            stiff, Setting(name, 1e-6)
        )
    for name in ("C RK4", "C RK8", "CasADi RK4"):
        assert "unstable with a step of 0.0005 s" in MEMBERS[name].suits(
            dataclasses.replace(stiff, budget=10**6), Setting(name, step=5e-4)
        )
    assert "iteration for the stages diverges" in MEMBERS["C Gauss6"].suits(
        stiff, Setting("C Gauss6", step=5e-4)
    )
    for name in ("SciPy Radau", "SUNDIALS IDAS"):
        outcome = solved(stiff, Setting(name, 1e-6))
        assert outcome.failure == "" and outcome.evaluations < 1000
        assert stiff_reference.errors(outcome.states)[-1, 1] < 1e-5


def test_explicit_methods_can_pay_for_a_stiff_problem(stiff, stiff_reference) -> None:
    rich = dataclasses.replace(stiff, budget=10**6)
    outcome = solved(rich, Setting("C RK8", step=1e-5))
    errors = stiff_reference.errors(outcome.states)
    assert np.max(errors / stiff_reference.scale) < 1e-3


def test_an_overflowing_motion_is_told(stiff) -> None:
    member = MEMBERS["C RK4"]
    outcome = member.prepare(stiff, Setting("C RK4", step=5e-4))()
    assert "the state is not finite" in outcome.failure and len(outcome.states) == 1


def test_an_iteration_that_does_not_converge_is_told(stiff) -> None:
    outcome = MEMBERS["C Gauss6"].prepare(stiff, Setting("C Gauss6", step=5e-4))()
    assert "does not converge" in outcome.failure and outcome.evaluations > 0


@pytest.mark.parametrize("step", [1e-3, 0.05])
def test_equations_of_a_step_that_are_not_solved_are_told_and_nothing_is_printed(
    capfd: pytest.CaptureFixture[str], step: float
) -> None:
    """A turn at 1000 rad/s: a thousandth of a second is a sixth of it, too long for Newton."""
    fast = dataclasses.replace(posed("elastic_pendulum"), start=np.array([0.3, 2.5, 0.0, 1000.0]))
    outcome = solved(fast, Setting("CasADi Gauss6", step=step))
    assert "CasADi Gauss6 stopped: the equations of a step before t = 0.1 s" in outcome.failure
    assert len(outcome.states) == 1
    printed = capfd.readouterr()
    assert printed.out == "" and printed.err == ""


@pytest.fixture(scope="module")
def in_time() -> Callable[[str | None], Problem]:
    """A point mass that is pushed with F cos(3 t), the time standing in the scene."""
    equations = by_route("kane", pushed())
    return lambda compiler: pose(compile(equations, compiler=compiler), [0.0, 0.7, 2.0])


@pytest.mark.parametrize("compiler", ["auto", None])
def test_time_in_the_equations_is_known_to_all(in_time, compiler: str | None) -> None:
    """x = F (1 - cos 3 t) / (9 m), x' = F sin(3 t) / (3 m)."""
    problem = in_time(compiler)
    t = problem.times
    expected = np.stack([5 * (1 - np.cos(3 * t)) / 18, 5 * np.sin(3 * t) / 6], axis=1)
    known = reference(problem)
    assert np.allclose(known.states, expected, rtol=0, atol=1e-15) and min(known.digits) > 30
    for member in INTEGRATORS:
        setting = fine(member)
        if member.available() or member.suits(problem, setting):
            continue
        outcome = member.prepare(problem, setting)()
        assert np.allclose(outcome.states, expected, rtol=0, atol=1e-5), member.name


@pytest.mark.parametrize("compiler", ["auto", None])
def test_steps_that_go_through_the_times(compiler: str | None) -> None:
    """Each state between two ends is one shorter step from the end before, and costs no other."""
    problem = posed("elastic_pendulum", compiler)
    through = dataclasses.replace(problem, through=True)
    # Steps that end at the times are the same ones.
    exact = Setting("C RK4", step=0.05)
    assert np.allclose(solved(problem, exact).states, solved(through, exact).states, atol=1e-15)
    # 0.08 s: ends at 0.08, 0.16, 0.24, ...; of the times 0.1, 0.2, ... only 0.4 is one.
    found = solved(through, Setting("C RK4", step=0.08))
    assert found.evaluations == 4 * 6
    ends = dataclasses.replace(problem, times=np.array([0.0, 0.08, 0.16]))
    last = solved(ends, Setting("C RK4", step=0.08)).states[-1]
    beside = dataclasses.replace(problem, start=last, times=np.array([0.0, 0.04]))
    expected = solved(beside, Setting("C RK4", step=0.04)).states[-1]
    assert np.allclose(found.states[2], expected, rtol=0, atol=1e-14)
    # A step longer than all of the times is taken in parts only.
    once = solved(through, Setting("C RK8", step=2.0))
    assert once.evaluations == 0 and error("elastic_pendulum", once) < 1e-2


def test_a_step_that_is_far_too_long_is_refused_in_words() -> None:
    problem = dataclasses.replace(posed("elastic_pendulum"), times=np.array([0.0, 1e13]))
    why = MEMBERS["C RK8"].suits(problem, Setting("C RK8", step=1e12))
    assert "unstable with a step of 1e+12 s" in why

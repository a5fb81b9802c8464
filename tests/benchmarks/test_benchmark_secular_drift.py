"""Long runs: what drifts and what stays bounded, as theory says it does."""

import math

import numpy as np
import pytest

from benchmarks.drift import Drift, drift
from benchmarks.problems import pose
from benchmarks.secular_drift import SAMPLES, long_runs, natural_period
from mechanics.compiled.machine.native import find_compiler
from mechanics.compiled.model import compile
from mechanics.errors import InputError
from mechanics.routes.derivation import by_route
from mechanics.simulate.integrators import Problem, Setting
from systems import ALL

pytestmark = pytest.mark.campaign

SCENES = {system.name: system.scene for system in ALL}
needs_compiler = pytest.mark.skipif(find_compiler() is None, reason="no C compiler here")


def posed(name: str, **given) -> Problem:
    return pose(compile(by_route("kane", SCENES[name]())), [0.0, 1.0], **given)


def test_natural_period_is_that_of_the_slowest_mode() -> None:
    """Two masses: 6 s^2 - 7 s + 1 = 0, slowest w^2 = 1/6."""
    assert natural_period(posed("two_mass_chain")) == pytest.approx(2 * np.pi * np.sqrt(6))
    with pytest.raises(InputError, match="no oscillation about q = 0: give the period"):
        natural_period(posed("rolling_disc"))


@needs_compiler
def test_gauss_stays_bounded_and_explicit_methods_drift_with_the_power_of_their_order() -> None:
    problem = posed("elastic_pendulum", initial={"x": 0.1, "theta": 0.5})
    period = natural_period(problem)
    settings = [
        Setting("C Gauss6", step=period / 50),
        Setting("C RK4", step=period / 100),
        Setting("C RK4", step=period / 200),
    ]
    gauss, rough, fine = long_runs(problem, settings, periods=2000, seconds=60.0)
    assert gauss.followed == 2000 and gauss.phase_words == gauss.phase.words
    assert not gauss.energy.secular and gauss.energy.largest < 1e-8
    assert gauss.phase.secular and gauss.phase.power == pytest.approx(1, abs=0.2)
    for run in (rough, fine):
        assert run.energy.secular and run.energy.power == pytest.approx(1, abs=0.2)
        assert run.energy.rate < 0 and run.phase.power == pytest.approx(2, abs=0.3)
        assert run.periods == run.wanted == 2000 and run.note == ""
    # Dissipation of order 4: h^5 a step, so 2^5 for half the step.
    assert math.log2(rough.energy.rate / fine.energy.rate) == pytest.approx(5, abs=0.3)


@needs_compiler
def test_momentum_is_watched_where_it_is_conserved() -> None:
    """Without springs nothing pulls along x."""
    free = posed(
        "elastic_pendulum", initial={"x": 0.0, "theta": 0.5, "x_dot": 0.1}, parameters={"k": 0.0}
    )
    (run,) = long_runs(free, [Setting("C RK4", step=0.01)], periods=200, seconds=60.0)
    assert [name for name, _ in run.momenta] == ["P_x"]
    assert 0 < run.momenta[0][1].largest < 1e-6
    held = posed("elastic_pendulum", initial={"x": 0.1, "theta": 0.5})
    (run,) = long_runs(held, [Setting("C RK4", step=0.01)], periods=50, seconds=60.0)
    assert run.momenta == ()


@needs_compiler
def test_what_would_take_too_long_is_cut_and_told() -> None:
    problem = posed("two_mass_chain")
    settings = [Setting("SciPy RK45", 1e-9), Setting("SciPy RK45"), Setting("C RK4", step=40.0)]
    slow, bad, wild = long_runs(problem, settings, periods=10_000, seconds=1e-6)
    assert slow.periods < 10_000 and "10000 would have taken too long" in slow.note
    assert f"an energy error of {slow.energy.after(10_000 / slow.periods):.1e}" in slow.note
    assert "SciPy takes tolerances" in bad.note and bad.periods == 0
    assert "unstable" in wild.failure
    with pytest.raises(InputError, match="integrator 'Euler': there are SciPy RK45, "):
        long_runs(problem, [Setting("Euler")], periods=10)


@pytest.mark.parametrize(
    ("error", "secular", "power"),
    [
        (lambda t: 1e-6 * np.sin(7 * t), False, math.nan),
        (lambda t: 1e-6 * np.sin(7 * t) + 1e-6 * t, True, 1.0),
        (lambda t: 1e-6 * np.sin(7 * t) + 1e-7 * t**2, True, 2.0),
    ],
)
def test_a_drift_is_told_from_an_oscillation(error, secular: bool, power: float) -> None:
    times = np.concatenate([np.linspace(start, start + 3, SAMPLES) for start in range(0, 1000, 80)])
    found = drift(times, error(times), SAMPLES)
    assert found.secular == secular
    assert found.power == pytest.approx(power, abs=0.1, nan_ok=True)
    assert ("secular" if secular else "bounded") in found.words


@needs_compiler
def test_a_phase_that_is_lost_is_not_followed() -> None:
    problem = posed("elastic_pendulum", initial={"x": 0.1, "theta": 0.5})
    (run,) = long_runs(problem, [Setting("C Gauss2", step=0.04)], periods=5000, seconds=60.0)
    assert not run.energy.secular and run.followed < 10
    assert run.phase_words.startswith("lost at once")


def test_words_of_a_drift() -> None:
    words = Drift(2e-3, -2e-6, 1.0, True).words
    assert words == "secular, -2.0e-06 a period, grows with t^1.0 to 2.0e-03"
    assert Drift(2e-3, -2e-6, math.nan, False).words == "bounded, at most 2.0e-03"
    assert Drift(2e-3, -2e-6, 2.0, True).after(10.0) == pytest.approx(0.2)
    assert Drift(2e-3, -2e-6, math.nan, False).after(10.0) == 2e-3

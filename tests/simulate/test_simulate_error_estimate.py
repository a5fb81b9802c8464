"""What a simulation says of its own error, held against runs of a much finer tolerance."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from mechanics.compiled.model import Model
from mechanics.simulate import Trajectory, simulate
from mechanics.simulate import run as runs
from systems import ALL

ModelOf = Callable[[str], Model]
FINEST = {"rtol": 3e-14, "atol": 1e-16, "estimate": False}
ROUNDING = 1e-12
SECONDS = {"pendulum_chain": 4.0, "four_bar": 2.0, "andrews": 0.03}
SHARE = 0.3
"""Evaluations that an estimate may add: 0.23 to 0.29, and less where the motion is lost before."""


def states(motion: Trajectory) -> np.ndarray:
    return np.column_stack([*motion.coordinates.values(), *motion.speeds.values()])


def true_error(motion: Trajectory, finest: Trajectory) -> float:
    """Relative to the largest magnitude of each coordinate or speed."""
    count = min(len(motion.times), len(finest.times))
    right = states(finest)[:count]
    scale = np.maximum(np.max(np.abs(right), axis=0), 1e-9)
    return float(np.max(np.abs(states(motion)[:count] - right) / scale))


@pytest.mark.sample(0)
@pytest.mark.parametrize("name", [system.name for system in ALL])
def test_it_is_of_the_size_of_the_error(name: str, model_of: ModelOf) -> None:
    model, seconds = model_of(name), SECONDS.get(name, 5.0)
    motion = simulate(model, seconds, samples=101)
    error = true_error(motion, simulate(model, seconds, samples=101, **FINEST))
    assert motion.error_estimate is not None
    assert error <= 10 * motion.error_estimate + ROUNDING
    assert motion.error_estimate <= 100 * error + ROUNDING


@pytest.mark.sample(2)
@pytest.mark.parametrize("method", ["RK45", "LSODA", "Radau", "BDF"])
@pytest.mark.parametrize("rtol", [1e-7, 1e-4])
def test_so_it_is_by_every_method(method: str, rtol: float, model_of: ModelOf) -> None:
    model = model_of("elastic_pendulum")
    motion = simulate(model, 10, method=method, rtol=rtol, atol=rtol / 100)
    error = true_error(motion, simulate(model, 10, **FINEST))
    assert error / 20 <= motion.error_estimate <= 50 * error


@pytest.mark.campaign
def test_where_a_motion_is_chaotic_it_says_from_when_nothing_is_right(model_of: ModelOf) -> None:
    model = model_of("double_pendulum")
    motion = simulate(model, 30)
    finest = simulate(model, 30, **FINEST)
    apart = np.max(np.abs(states(motion) - states(finest)), axis=1)
    assert motion.horizon is not None
    assert motion.error_estimate == 1.0
    assert np.max(apart[motion.times > motion.horizon]) > 1
    assert np.max(apart[motion.times < motion.horizon - 5 * motion.tenfold]) < 1e-3
    assert f"beyond t = {motion.horizon:.3g} s no digit is right" in motion.note


@pytest.mark.campaign
def test_four_digits_of_the_tolerance_gain_four_times_the_seconds_of_a_digit(
    model_of: ModelOf,
) -> None:
    """In the mean over starts: exponents differ along a chaotic motion, and between processors."""
    model, gains = model_of("double_pendulum"), []
    for angle in (2.0, 2.5, 2.9):
        coarse, fine = (
            simulate(model, 40, initial={"phi1": angle}, rtol=r, atol=r / 100)
            for r in (1e-7, 1e-11)
        )
        assert coarse.horizon < fine.horizon
        gains.append((fine.horizon - coarse.horizon) / (4 * fine.tenfold))
    assert np.mean(gains) == pytest.approx(1, abs=0.35)


@pytest.mark.campaign
def test_a_regular_motion_has_no_horizon(model_of: ModelOf) -> None:
    motion = simulate(model_of("two_mass_chain"), 2000, samples=2001)
    assert motion.tenfold is None
    assert motion.horizon is None
    assert motion.error_estimate < 1e-6


@pytest.mark.parametrize(
    "name", ["elastic_pendulum", "rocker", "two_mass_chain", "double_pendulum"]
)
def test_it_costs_three_tenths_at_most(name: str, model_of: ModelOf, monkeypatch: Any) -> None:
    begin, calls = runs.begin, [0]

    def counted(*args: Any) -> Any:
        found = begin(*args)
        rate = found.moving.rate

        def count(t: float, state: Any) -> Any:
            calls[0] += 1
            return rate(t, state)

        object.__setattr__(found.moving, "rate", count)
        return found

    monkeypatch.setattr(runs, "begin", counted)
    simulate(model_of(name), 10, estimate=False)
    alone, calls[0] = calls[0], 0
    simulate(model_of(name), 10)
    assert alone < calls[0] <= (1 + SHARE) * alone


def test_what_stays_zero_is_no_error(model_of: ModelOf) -> None:
    upright = {"lean": 0.0, "lean_dot": 0.0, "yaw": 0.0, "yaw_dot": 0.0, "spin_dot": 3.0}
    known = {name: 0.0 for name in ("u1", "u2")}
    model = model_of("rolling_disc")
    names = {entry.name for entry in (*model.quantities.q, *model.quantities.u)}
    start = {name: value for name, value in {**upright, **known}.items() if name in names}
    motion = simulate(model, 3, initial=start)
    assert motion.error_estimate < 1e-8


def test_it_can_be_left_out(model_of: ModelOf) -> None:
    motion = simulate(model_of("rod_pendulum"), 1, estimate=False)
    assert motion.error_estimate is None
    assert motion.accuracy == ""

"""The rocker under control: what it does at small amplitude is what its poles say.

f = -K theta:  lambda^2 = (M g/3 - K) (...)   real below the critical gain, imaginary above
"""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from mechanics import compile, derive, linearize, simulate
from mechanics.compiled import Model
from mechanics.linear.numeric import numeric_poles
from mechanics.scene import condition
from systems.rocker import K, controlled, theta

FINE = {"rtol": 1e-12, "atol": 1e-18}


@cache
def model() -> Model:
    """With the change of sign of theta as an event."""
    side = condition("side", theta > 0, "is on the other side")
    scene = replace(controlled(), conditions=(side,))
    return compile(derive(scene, "kane"))


@cache
def critical() -> float:
    known = model()
    values = dict(zip((e.name for e in known.quantities.p), known.typical, strict=True))
    return float(values["M"] * values["g"] / 3)


def pole(gain: float) -> complex:
    """The pole with the largest real part, or with a positive imaginary one."""
    linear = linearize(model().equations, {"theta": 0})
    found = numeric_poles(linear, {K: gain})
    return complex(max(found, key=lambda s: (round(s.real, 9), s.imag)))


@pytest.mark.parametrize("share", [0.0, 0.5, 0.99])
def test_below_the_critical_gain_it_grows_at_the_rate_of_the_pole(share: float) -> None:
    gain = share * critical()
    expected = pole(gain)
    assert expected.imag == 0 and expected.real > 0
    # Along the unstable direction, so that nothing else is in the motion.
    start = {"theta": 1e-7, "theta_dot": 1e-7 * expected.real}
    found = simulate(model(), 2.0 / expected.real, initial=start, parameters={"K": gain}, **FINE)
    angle = found.coordinates["theta"]
    rate = math.log(angle[-1] / angle[0]) / (found.times[-1] - found.times[0])
    assert rate == pytest.approx(expected.real, rel=1e-6)
    assert angle[-1] > 7 * angle[0]


@pytest.mark.parametrize("share", [1.01, 2.0, 10.0])
def test_above_it_it_swings_at_the_frequency_of_the_pole(share: float) -> None:
    gain = share * critical()
    expected = pole(gain)
    assert abs(expected.real) < 1e-6 * expected.imag
    duration = 4.6 * 2 * math.pi / expected.imag
    found = simulate(
        model(), duration, initial={"theta": 1e-6}, parameters={"K": gain}, beyond_domain=True,
        **FINE,
    )  # fmt: skip
    falling = [crossing.time for crossing in found.crossings if crossing.leaving]
    periods = np.diff(falling)
    assert len(periods) == 4
    assert 2 * math.pi / np.mean(periods) == pytest.approx(expected.imag, rel=1e-6)
    assert np.max(np.abs(found.coordinates["theta"])) < 1.001e-6


def test_at_the_critical_gain_it_neither_returns_nor_runs_away() -> None:
    # The poles of K = M g/3 are zero: theta stays while the cubic terms are small.
    found = simulate(model(), 1.0, initial={"theta": 1e-4}, parameters={"K": critical()}, **FINE)
    assert np.ptp(found.coordinates["theta"]) < 1e-9

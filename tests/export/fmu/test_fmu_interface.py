"""The interface of a unit: life, refusals and their words, states, derivatives."""

import ctypes
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from fmpy.fmi1 import FMICallException

from mechanics.compiled import Model
from mechanics.export.fmu.functions import functions
from systems import ALL

pytestmark = pytest.mark.campaign

SYSTEMS = [system.name for system in ALL]
Opener = Callable[..., Any]


def steps(unit: Any, count: int, h: float = 0.05, begin: int = 0) -> None:
    for i in range(begin, begin + count):
        unit.fmu.doStep(i * h, h)


def test_instances_do_not_know_each_other(opened: Opener) -> None:
    one, other, both = (opened("elastic_pendulum") for _ in range(3))
    one.initialised(theta=0.5)
    other.initialised(theta=-1.0, M=3.0)
    both.initialised(theta=0.5)
    for i in range(10):
        steps(one, 1, begin=i)
        steps(other, 1, begin=i)
    steps(both, 10)
    assert one.get("theta", "x") == both.get("theta", "x")
    assert other.get("M") == [3.0] and one.get("M") == [1.0]


def test_reset_brings_the_start_back(opened: Opener) -> None:
    unit = opened("elastic_pendulum").initialised(theta=0.5, M=3.0)
    steps(unit, 3)
    unit.fmu.reset()
    assert unit.get("theta", "M", "time") == opened("elastic_pendulum").get("theta", "M", "time")
    steps(unit.initialised(theta=0.5, M=3.0), 3)
    again = opened("elastic_pendulum").initialised(theta=0.5, M=3.0)
    steps(again, 3)
    assert unit.get("theta", "x", "x_ddot") == again.get("theta", "x", "x_ddot")


def test_a_state_is_kept_given_back_and_written(opened: Opener) -> None:
    unit = opened("elastic_pendulum").initialised(theta=0.5)
    steps(unit, 3)
    kept = unit.fmu.getFMUState()
    written = unit.fmu.serializeFMUState(kept)
    steps(unit, 4, begin=3)
    ahead = unit.get("theta", "x_dot")
    unit.fmu.setFMUState(kept)
    assert unit.get("time") == pytest.approx([0.15])
    steps(unit, 4, begin=3)
    assert unit.get("theta", "x_dot") == ahead
    other = opened("elastic_pendulum")
    read = other.fmu.deserializeFMUState(written)
    other.fmu.setFMUState(read)
    steps(other, 4, begin=3)
    assert other.get("theta", "x_dot") == ahead
    for instance, state in ((unit, kept), (other, read)):
        instance.fmu.freeFMUState(state)


def test_a_state_of_another_unit_is_refused(opened: Opener) -> None:
    one, other = opened("elastic_pendulum"), opened("rocker")
    state = one.fmu.getFMUState()
    written = one.fmu.serializeFMUState(state)
    one.fmu.freeFMUState(state)
    with pytest.raises(FMICallException):
        other.fmu.deserializeFMUState(written)
    assert "these bytes are no state of this unit" in other.log[-1][1]
    with pytest.raises(FMICallException):
        one.fmu.deserializeFMUState(written[:-1])


def test_another_token_is_refused(opened: Opener) -> None:
    unit = opened("elastic_pendulum").fmu
    said: list[str] = []
    unit.guid = "{0}"
    with pytest.raises(Exception, match="instantiate"):
        unit.instantiate(logMessage=lambda env, status, category, words: said.append(words))
    assert b"the instantiation token is not that of this unit" in said[0]


@pytest.mark.parametrize(
    ("act", "words"),
    [
        (lambda u: u.set(theta=float("nan")), "theta = nan: a finite number is needed"),
        (lambda u: u.set(M=-1.0), "M = -1 is negative: it is declared positive"),
        (lambda u: u.set(step_size=0.0), "step_size is zero: nothing would ever move"),
        (lambda u: u.set(x_ddot=1.0), "x_ddot (reference 13) cannot be set"),
        (lambda u: u.set(time=1.0), "time (reference 0) cannot be set"),
        (lambda u: u.fmu.setFloat64([99], [1.0]), "no variable (reference 99) cannot be set"),
        (lambda u: u.fmu.getFloat64([99]), "there is no variable with the reference 99"),
        (lambda u: u.fmu.getFloat64([1], 2), "1 references and 2 values"),
        (lambda u: u.fmu.getInt32([1]), "fmi3GetInt32: there are no variables of type Int32 here"),
        (lambda u: u.fmu.setBoolean([1], [True]), "there are no variables of type Boolean here"),
        (lambda u: u.fmu.getBinary([1]), "there are no variables of type Binary here"),
        (lambda u: u.fmu.getClock([1]), "fmi3GetClock: there are no clocks here"),
        (lambda u: u.fmu.enterConfigurationMode(), "there are no structural parameters here"),
        (lambda u: u.fmu.doStep(0.0, 0.1), "fmi3DoStep: not allowed in Instantiated"),
        (lambda u: u.fmu.exitInitializationMode(), "not allowed in Instantiated"),
        (lambda u: u.fmu.enterInitializationMode(startTime=float("inf")), "is no interval"),
        (lambda u: u.fmu.getDirectionalDerivative([12], [1], [1.0]), "not allowed in Instantiated"),
    ],
)
def test_what_is_wrong_is_named(opened: Opener, act: Callable[[Any], Any], words: str) -> None:
    unit = opened("elastic_pendulum")
    with pytest.raises(FMICallException):
        act(unit)
    status, said = unit.log[-1]
    assert status == 3 and words in said


@pytest.mark.parametrize(
    ("act", "words"),
    [
        (lambda u: u.set(theta=0.1), "theta cannot be set in this mode"),
        (lambda u: u.fmu.doStep(0.3, 0.1), "it begins at t = 0.3 s, and the unit is at 0 s"),
        (lambda u: u.fmu.doStep(0.0, 0.0), "a step of 0 s: a positive length is needed"),
        (lambda u: u.fmu.doStep(0.0, float("nan")), "a positive length is needed"),
        (lambda u: u.fmu.doStep(0.0, 1e30), "internal steps are needed: make step_size longer"),
        (lambda u: u.fmu.enterStepMode(), "there are no events in co-simulation here"),
        (lambda u: u.fmu.getOutputDerivatives([1], [1]), "none are provided"),
        (
            lambda u: u.fmu.getDirectionalDerivative([1], [13], [1.0]),
            "nothing can be derived by x_ddot (reference 13)",
        ),
        (lambda u: u.fmu.getDirectionalDerivative([99], [1], [1.0]), "no variable"),
        (lambda u: u.fmu.getDirectionalDerivative([12], [1, 2], [1.0]), "as many seeds"),
        (lambda u: u.fmu.getAdjointDerivative([12], [1], [1.0, 2.0]), "as many seeds"),
    ],
)
def test_what_is_wrong_in_step_mode_is_named(
    opened: Opener, act: Callable[[Any], Any], words: str
) -> None:
    unit = opened("elastic_pendulum").initialised(theta=0.5)
    before = unit.get("theta", "x", "time")
    with pytest.raises(FMICallException):
        act(unit)
    status, said = unit.log[-1]
    assert status == 3 and words in said
    assert unit.get("theta", "x", "time") == before


def test_parameters_may_change_between_steps_and_states_may_not(opened: Opener) -> None:
    unit = opened("elastic_pendulum").initialised()
    unit.set(g=1.6)
    steps(unit, 1)
    assert unit.get("g") == [1.6]
    unit.fmu.terminate()
    with pytest.raises(FMICallException):
        unit.set(g=9.81)
    assert "not allowed" in unit.log[-1][1] or "cannot be set in this mode" in unit.log[-1][1]


def test_functions_of_the_other_kind_are_refused(opened: Opener) -> None:
    unit = opened("elastic_pendulum", "ModelExchange").initialised()
    unit.fmu.updateDiscreteStates()
    unit.fmu.enterContinuousTimeMode()
    with pytest.raises(FMICallException):
        unit.fmu.getContinuousStateDerivatives((ctypes.c_double * 3)(), 3)
    assert "fmi3GetContinuousStateDerivatives: 4 values expected, 3 found" in unit.log[-1][1]
    with pytest.raises(FMICallException):
        unit.set(M=2.0)
    assert unit.fmu.getNumberOfContinuousStates() == 4
    assert unit.fmu.getNumberOfEventIndicators() == 0


def test_a_start_outside_of_the_domain_is_refused_with_its_reason(opened: Opener) -> None:
    unit = opened("rocker")
    unit.set(theta=2.0)
    unit.fmu.enterInitializationMode()
    with pytest.raises(FMICallException):
        unit.fmu.exitInitializationMode()
    words = [said for _, said in unit.log]
    assert "comes to the end of its half disc" in words[0]
    assert "starts outside of the domain" in words[-1]


def test_a_singular_configuration_is_named(opened: Opener) -> None:
    unit = opened("elastic_pendulum")
    unit.set(M=0.0, m=0.0)
    unit.fmu.enterInitializationMode()
    with pytest.raises(FMICallException):
        unit.fmu.exitInitializationMode()
    assert "a divisor is zero: the configuration is singular" in unit.log[-1][1]


@pytest.mark.sample(1)
@pytest.mark.parametrize("name", SYSTEMS)
def test_derivatives_are_those_of_the_graphs(
    opened: Opener, model_of: Callable[[str], Model], name: str
) -> None:
    """J v and v^T J against the whole of J from CasADi; and one is the transpose of the other."""
    unit = opened(name).initialised()
    graphs = functions(model_of(name)).graphs
    given = list(range(graphs["rates"].numel_in(0)))
    size = sum(graphs[part].numel_out(0) for part in ("rates", "outputs"))
    wanted = list(range(len(given), len(given) + size))
    point = unit.fmu.getFloat64(given)
    jacobian = np.vstack([
        np.array(graphs[part].factory("J", ["given"], ["jac:wanted:given"])(point))
        for part in ("rates", "outputs")
    ])  # fmt: skip
    random = np.random.default_rng(7)
    seed, weights = random.normal(size=len(given)), random.normal(size=size)
    forward = np.array(unit.fmu.getDirectionalDerivative(wanted, given, seed.tolist()))
    backward = np.array(unit.fmu.getAdjointDerivative(wanted, given, weights.tolist(), len(given)))
    sizes = np.abs(jacobian) @ np.abs(seed)
    assert np.all(np.abs(forward - jacobian @ seed) <= 1e-9 * (1 + sizes))
    sizes = np.abs(weights) @ np.abs(jacobian)
    assert np.all(np.abs(backward - weights @ jacobian) <= 1e-9 * (1 + sizes))
    assert weights @ forward == pytest.approx(backward @ seed, rel=1e-9)


def test_derivatives_are_limits_of_differences(opened: Opener) -> None:
    """Without the graphs: central differences of what the unit itself gives."""
    unit = opened("rocker").initialised(theta=0.2, theta_dot=0.3)
    wanted = ["theta_ddot", "N", "kinetic energy", "margin of rolling"]
    for known in ("f", "g", "M", "mu"):
        (value,), h = unit.get(known), 1e-4
        exact = unit.fmu.getDirectionalDerivative(
            [unit.references[w] for w in wanted], [unit.references[known]], [1.0]
        )
        sides = []
        for sign in (1, -1):
            unit.set(**{known: value + sign * h})
            sides.append(unit.get(*wanted))
        unit.set(**{known: value})
        slope = (np.array(sides[0]) - np.array(sides[1])) / (2 * h)
        np.testing.assert_allclose(slope, exact, rtol=1e-6, atol=1e-6)


def test_a_coordinate_as_an_unknown_is_its_own_derivative(opened: Opener) -> None:
    unit = opened("elastic_pendulum").initialised()
    at = [unit.references[name] for name in ("x", "theta", "x_ddot")]
    assert unit.fmu.getDirectionalDerivative(at[:2], [at[0]], [3.0]) == [3.0, 0.0]
    # x is on both sides: its own part, and what the acceleration takes from it.
    (slope,) = unit.fmu.getDirectionalDerivative(at[2:], [at[0]], [1.0])
    (both,) = unit.fmu.getAdjointDerivative([at[0], at[2]], [at[0]], [1.0, 1.0], 1)
    assert both == pytest.approx(1.0 + slope, rel=1e-12)

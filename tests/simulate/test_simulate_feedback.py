"""Inputs that follow the state: the same motion as a scene that has the control law inside."""

import numpy as np
import pytest

from mechanics.compiled.model import Model, compile
from mechanics.errors import InputError
from mechanics.routes.derivation import by_route
from mechanics.simulate import Ending, Feedback, simulate
from mechanics.simulate.integrators import Problem, Setting
from mechanics.simulate.integrators.scipy import MEMBERS
from mechanics.simulate.run import begin
from mechanics.trade.accurate import simulate as simulate_accurately
from systems import rocker

GAIN = 30.0


@pytest.fixture(scope="module")
def free() -> Model:
    return compile(by_route("lagrange", rocker.scene()))


@pytest.fixture(scope="module")
def controlled() -> Model:
    return compile(by_route("lagrange", rocker.controlled()))


def law(t: float, q: np.ndarray, u: np.ndarray) -> float:
    return -GAIN * q[0]


@pytest.mark.sample(1)
@pytest.mark.parametrize("method", ["DOP853", "Radau", "LSODA"])
def test_a_fed_back_input_is_the_law_inside_of_the_scene(
    free: Model, controlled: Model, method: str
) -> None:
    options = {"initial": {"theta": 0.05}, "samples": 41, "method": method, "rtol": 1e-10}
    inside = simulate(controlled, 1.0, parameters={"K": GAIN}, **options)
    outside = simulate(free, 1.0, inputs={"f": Feedback(law)}, **options)
    assert inside.ending is outside.ending is Ending.COMPLETE
    for name in ("theta", "theta_dot"):
        # Both are within the tolerance of one step times the steps of a motion that is stable.
        np.testing.assert_allclose(outside.columns[name], inside.columns[name], rtol=0, atol=1e-8)


def test_the_domain_is_watched_with_the_input_that_is_fed_back(
    free: Model, controlled: Model
) -> None:
    start = {"theta": 0.05, "theta_dot": 8.0}
    inside = simulate(controlled, 1.0, initial=start, parameters={"K": GAIN})
    outside = simulate(free, 1.0, initial=start, inputs={"f": Feedback(law)})
    assert inside.ending is outside.ending is Ending.LEFT_DOMAIN
    assert outside.crossings[0].sentence == inside.crossings[0].sentence
    assert outside.crossings[0].time == pytest.approx(inside.crossings[0].time, abs=1e-9)


def test_the_input_is_recorded_and_energy_is_not_conserved(free: Model) -> None:
    motion = simulate(free, 0.5, inputs={"f": Feedback(law)}, samples=11)
    np.testing.assert_array_equal(motion.inputs["f"], -GAIN * motion.coordinates["theta"])
    assert not motion.conservative


def test_time_and_speeds_reach_the_law(free: Model) -> None:
    seen: list[tuple[float, float, float]] = []

    def spy(t: float, q: np.ndarray, u: np.ndarray) -> float:
        seen.append((t, q[0], u[0]))
        return 0.0

    simulate(free, 0.1, initial={"theta": 0.2, "theta_dot": 0.3}, inputs={"f": Feedback(spy)})
    assert seen[0] == (0.0, 0.2, 0.3)
    assert 0.0 < max(t for t, *_ in seen) <= 0.1


def test_a_row_of_gains_gives_an_array_with_one_entry(free: Model) -> None:
    gains = np.array([[GAIN, 1.0]])
    motion = simulate(free, 0.2, inputs={"f": Feedback(lambda t, q, u: -gains @ [*q, *u])})
    assert motion.ending is Ending.COMPLETE


@pytest.mark.campaign
def test_an_accuracy_can_be_asked_for(free: Model) -> None:
    motion = simulate_accurately(
        free, 0.5, initial={"theta": 0.05}, inputs={"f": Feedback(law)}, accuracy=1e-6, samples=11
    )
    assert motion.error_estimate <= 1e-6
    exact = simulate(free, 0.5, initial={"theta": 0.05}, inputs={"f": Feedback(law)}, samples=11)
    np.testing.assert_allclose(
        motion.coordinates["theta"], exact.coordinates["theta"], rtol=0, atol=1e-6 * 0.05
    )


@pytest.mark.sample(2)
@pytest.mark.parametrize("member", MEMBERS, ids=lambda member: member.name)
def test_every_integrator_that_takes_functions_takes_feedback(free: Model, member) -> None:
    inputs = {"f": Feedback(law)}
    start = begin(free, {"theta": 0.05}, None, inputs)
    problem = Problem(free, start.p, inputs, start.state, np.linspace(0, 0.5, 6))
    found = member.prepare(problem, Setting(member.name, tolerance=1e-9))()
    exact = simulate(free, 0.5, initial={"theta": 0.05}, inputs=inputs, samples=6)
    np.testing.assert_allclose(found.states[:, 0], exact.coordinates["theta"], rtol=0, atol=1e-6)


@pytest.mark.parametrize("answer", ["much", None, [1.0, 2.0], []])
def test_a_law_that_gives_no_number_is_named(free: Model, answer: object) -> None:
    with pytest.raises(InputError, match=r"feedback: at t = 0 s the law gave .*: one number"):
        simulate(free, 0.1, inputs={"f": Feedback(lambda t, q, u: answer)})


def test_where_only_time_is_known_feedback_is_refused(free: Model) -> None:
    start = begin(free, {"theta": 0.05}, None, {"f": Feedback(law)})
    with pytest.raises(InputError, match=r"input f: it is fed back from the state"):
        start.signals(0.0)

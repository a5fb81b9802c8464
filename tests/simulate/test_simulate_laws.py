"""Laws that every simulated motion obeys; what a member may miss is its data."""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
import pytest

from mechanics.compiled.model import Model
from mechanics.simulate import Ending, Trajectory, simulate
from systems import ALL

ModelOf = Callable[[str], Model]
FINE = {"rtol": 1e-12, "atol": 1e-14}


@dataclass(frozen=True)
class Member:
    """A system, how long it is simulated, and how far its energy may drift."""

    name: str
    duration: float
    energy: float
    initial: dict[str, float] = field(default_factory=dict)


MEMBERS = (
    Member("elastic_pendulum", 10.0, 1e-11),
    Member("rocker", 5.0, 1e-11, {"theta": 0.4}),
    Member("two_mass_chain", 10.0, 1e-11),
    # Chaotic, with fast turns.
    Member("pendulum_chain", 4.0, 1e-10),
    Member("rolling_disc", 5.0, 1e-11),
    Member("four_bar", 2.0, 1e-11),
    Member("cartpole", 4.0, 1e-11),
    Member("acrobot", 2.0, 1e-10),
    Member("double_inverted_pendulum", 1.0, 1e-10),
    Member("rod_pendulum", 5.0, 1e-11),
    Member("double_pendulum", 2.0, 1e-10),
    # It rubs: it ends where it comes to rest, and loses what friction takes.
    Member("cartpole_friction", 0.05, 0.0),
)


def states(motion: Trajectory) -> dict[str, np.ndarray]:
    return {
        "q": np.column_stack(list(motion.coordinates.values())),
        "u": np.column_stack(list(motion.speeds.values())),
        "inputs": np.column_stack([*motion.inputs.values(), motion.times])[:, :-1],
    }


def test_every_system_is_a_member() -> None:
    assert {member.name for member in MEMBERS} == {system.name for system in ALL}


CONSERVATIVE = [member for member in MEMBERS if member.energy]


@pytest.mark.campaign
def test_what_rubs_loses_energy(model_of: ModelOf) -> None:
    for name in (member.name for member in MEMBERS if not member.energy):
        motion = simulate(model_of(name), 0.05, samples=21, **FINE)
        assert not motion.conservative
        assert np.all(np.diff(motion.total) < 0)


@pytest.mark.sample(2)
@pytest.mark.parametrize("member", CONSERVATIVE, ids=lambda member: member.name)
def test_energy_is_conserved(model_of: ModelOf, member: Member) -> None:
    # The law is one of the equations, and holds beyond the domain in which they are the system.
    motion = simulate(
        model_of(member.name),
        member.duration,
        initial=member.initial,
        samples=41,
        beyond_domain=True,
        **FINE,
    )
    assert motion.ending is Ending.COMPLETE
    assert motion.conservative
    # Not because nothing moves: energy goes to and fro.
    assert np.ptp(motion.kinetic) > 1e-3 * np.max(np.abs(motion.kinetic))
    assert motion.energy_drift < member.energy


@pytest.mark.sample(1)
@pytest.mark.parametrize("member", MEMBERS, ids=lambda member: member.name)
def test_rates_of_coordinates_are_their_derivatives(model_of: ModelOf, member: Member) -> None:
    model = model_of(member.name)
    motion = simulate(model, 0.02, initial=member.initial, samples=21, **FINE)
    at = states(motion)
    rates = model.coordinate_rates(at["q"], at["u"], inputs=at["inputs"])
    # Central difference of fourth order; the step is 1 ms.
    q, h = at["q"], motion.times[1]
    slope = (8 * (q[3:-1] - q[1:-3]) - (q[4:] - q[:-4])) / (12 * h)
    assert np.allclose(slope, rates[2:-2], rtol=0, atol=1e-6 * (1 + np.max(np.abs(rates))))


def test_momentum_along_the_rail_stays_without_springs(model_of: ModelOf) -> None:
    model = model_of("elastic_pendulum")
    motion = simulate(model, 5.0, parameters={"k": 0.0}, initial={"x_dot": 0.7}, **FINE)
    at = states(motion)
    momentum = model.evaluate("momenta", **at, p={"k": 0.0})["linear"]
    assert np.ptp(momentum[:, 0]) < 1e-10
    assert np.ptp(momentum[:, 1]) > 1.0


@pytest.mark.campaign
def test_momentum_along_the_rail_is_the_impulse(model_of: ModelOf) -> None:
    model = model_of("pendulum_chain")
    motion = simulate(model, 2.0, inputs={"F": np.cos}, samples=21, **FINE)
    momentum = model.evaluate("momenta", **states(motion), p=None)["linear"]
    assert not motion.conservative
    assert np.allclose(momentum[:, 0] - momentum[0, 0], np.sin(motion.times), rtol=0, atol=1e-10)


@pytest.mark.campaign
def test_energy_grows_by_the_work_of_a_constant_torque(model_of: ModelOf) -> None:
    motion = simulate(model_of("four_bar"), 1.0, inputs={"tau": 0.3}, samples=21, **FINE)
    turned = motion.coordinates["q1"] - motion.coordinates["q1"][0]
    assert not motion.conservative
    assert np.allclose(motion.total - motion.total[0], 0.3 * turned, rtol=0, atol=1e-9)


def test_time_runs_backwards(model_of: ModelOf) -> None:
    model = model_of("elastic_pendulum")
    there = simulate(model, 3.0, samples=2, **FINE)
    end = {name: column[-1] for name, column in there.coordinates.items()}
    end |= {name: -column[-1] for name, column in there.speeds.items()}
    back = simulate(model, 3.0, initial=end, samples=2, **FINE)
    for name in there.coordinates:
        assert abs(back.coordinates[name][-1] - there.coordinates[name][0]) < 1e-9

"""Constrained motion: consistent starts, branches, drift, singular configurations."""

from collections.abc import Callable

import numpy as np
import pytest

from mechanics.compiled.model import Model
from mechanics.compiled.quantities import typical_value
from mechanics.errors import InputError, SingularError
from mechanics.simulate import Ending, Trajectory, simulate
from mechanics.simulate.consistent import consistent_speeds
from mechanics.simulate.constraints import manifold
from mechanics.simulate.values import read_initial
from systems import bicycle

ModelOf = Callable[[str], Model]
PARALLELOGRAM = {"l1": 0.1, "l2": 0.3, "l3": 0.1, "d": 0.3}


@pytest.fixture(scope="module")
def linkage(model_of: ModelOf) -> Model:
    return model_of("four_bar")


def closure(motion: Trajectory) -> float:
    """Largest distance of the end of the rocker from its pivot."""
    p, q = motion.parameters, list(motion.coordinates.values())
    lengths = (p["l1"], p["l2"], p["l3"])
    x = sum(l * np.cos(angle) for l, angle in zip(lengths, q, strict=True)) - p["d"]
    y = sum(l * np.sin(angle) for l, angle in zip(lengths, q, strict=True))
    return float(np.max(np.hypot(x, y)))


@pytest.mark.campaign
def test_given_coordinate_is_kept_and_the_others_close_the_loop(linkage: Model) -> None:
    motion = simulate(linkage, 0.5, initial={"q1": 0.3})
    assert motion.coordinates["q1"][0] == 0.3
    assert closure(motion) < 1e-14
    q2, q3 = motion.coordinates["q2"][0], motion.coordinates["q3"][0]
    assert motion.branch == f"branch: q2 = {q2:.6g}, q3 = {q3:.6g} (of 2 found)"


def test_another_coordinate_can_be_the_independent_one(linkage: Model) -> None:
    motion = simulate(linkage, 0.1, initial={"q3": -1.5, "q3_dot": 2.0})
    assert motion.coordinates["q3"][0] == -1.5
    assert motion.speeds["q3_dot"][0] == 2.0
    assert "q1 = " in motion.branch
    assert closure(motion) < 1e-14


def test_both_branches_can_be_reached(linkage: Model) -> None:
    up = simulate(linkage, 0.1, initial={"q1": 1.0}).coordinates
    # The mirror image in the line from B to D: what the guess is near to is taken.
    down = simulate(linkage, 0.1, initial={"q1": 1.0, "q2": mirrored(up)}).coordinates
    assert abs(up["q2"][0] - down["q2"][0]) > 0.5
    assert abs(up["q3"][0] - down["q3"][0]) > 0.5


def mirrored(up: dict[str, np.ndarray]) -> float:
    """Direction of the coupler in the other assembly, by geometry."""
    bx, by = 0.28 - 0.1 * np.cos(1.0), -0.1 * np.sin(1.0)
    return float(2 * np.arctan2(by, bx) - up["q2"][0])


def test_speeds_satisfy_the_closure(linkage: Model) -> None:
    motion = simulate(linkage, 0.1, initial={"q1": 1.0, "q1_dot": 4.0})
    q1, q2, q3 = (column[0] for column in motion.coordinates.values())
    w1, w2, w3 = (column[0] for column in motion.speeds.values())
    # Velocity analysis of a four-bar linkage: the ratios of the angular velocities.
    assert w1 == 4.0
    assert w2 == pytest.approx(w1 * 0.1 * np.sin(q3 - q1) / (0.3 * np.sin(q2 - q3)), rel=1e-12)
    assert w3 == pytest.approx(w1 * 0.1 * np.sin(q1 - q2) / (0.25 * np.sin(q2 - q3)), rel=1e-12)


@pytest.mark.parametrize("method", ["DOP853", "RK45", "LSODA"])
def test_drift_is_reported_and_taken_out(linkage: Model, method: str) -> None:
    motion = simulate(linkage, 2.0, method=method, rtol=1e-6, atol=1e-8)
    assert set(motion.drift) == {
        "closure along x",
        "closure along y",
        "rate of closure along x",
        "rate of closure along y",
    }
    assert 1e-13 < max(motion.drift.values()) < 1e-3
    assert closure(motion) < 1e-13


def test_rolling_does_not_slip(model_of: ModelOf) -> None:
    motion = simulate(model_of("rolling_disc"), 5.0, rtol=1e-8, atol=1e-9)
    q, u, radius = motion.coordinates, motion.speeds, motion.parameters["R"]
    spin = u["u2"] - u["u3"] * np.tan(q["lean"])
    assert np.max(np.abs(u["u4"] - radius * spin * np.cos(q["yaw"]))) < 1e-13
    assert np.max(np.abs(u["u5"] - radius * spin * np.sin(q["yaw"]))) < 1e-13
    assert max(motion.drift.values()) > 1e-13
    assert motion.branch == ""


def test_parallelogram_stops_where_it_can_fold(linkage: Model) -> None:
    motion = simulate(
        linkage, 2.0, parameters=PARALLELOGRAM, initial={"q1": 1.0, "q1_dot": 10.0}, samples=2001
    )
    assert motion.ending is Ending.SINGULAR
    assert motion.reason.startswith("ended at t = 0.207")
    assert abs(motion.coordinates["q1"][-1] - np.pi) < 0.02
    assert motion.energy_drift < 1e-8


def test_folded_parallelogram_does_not_start(linkage: Model) -> None:
    with pytest.raises(SingularError, match=r"initial configuration is singular.*closure along x"):
        simulate(linkage, 1.0, parameters=PARALLELOGRAM, initial={"q1": 0.0, "q1_dot": 10.0})


def test_disc_that_falls_flat_stops(model_of: ModelOf) -> None:
    motion = simulate(model_of("rolling_disc"), 5.0, initial={"u2": 0.0, "u3": 0.0}, samples=5001)
    assert motion.ending is Ending.SINGULAR
    assert motion.coordinates["lean"][-1] == pytest.approx(np.pi / 2, abs=0.01)


def test_disc_that_nearly_falls_flat_comes_up_again(model_of: ModelOf) -> None:
    motion = simulate(model_of("rolling_disc"), 1.5, initial={"u2": 0.1, "u3": 0.01})
    lean = motion.coordinates["lean"]
    assert motion.ending is Ending.COMPLETE
    assert np.max(lean) > 1.5
    assert lean[-1] < 1.0


def test_links_that_cannot_meet_are_refused(linkage: Model) -> None:
    with pytest.raises(InputError, match=r"no configuration satisfies closure along x, .* q1 = 1"):
        simulate(linkage, 1.0, parameters={"d": 2.0})


def test_coordinates_that_miss_the_closure_are_refused(linkage: Model) -> None:
    with pytest.raises(InputError, match="give no more than 1"):
        simulate(linkage, 1.0, initial={"q1": 1.0, "q2": 0.2, "q3": 2.0})


def test_coordinates_that_close_by_themselves_are_taken(linkage: Model) -> None:
    first = simulate(linkage, 0.1, samples=2)
    given = {name: column[0] for name, column in first.coordinates.items()}
    again = simulate(linkage, 0.1, initial=given, samples=2)
    assert again.coordinates["q2"][-1] == pytest.approx(first.coordinates["q2"][-1], abs=1e-9)


def test_speeds_of_the_example_stay_where_the_others_can_follow() -> None:
    """Whatever the order in which speeds are named: a bicycle whose wheel turns moves."""
    scene = bicycle.scene()
    numbers = {p: typical_value(p, {}) for p in bicycle.bicycle_parameters().values()}
    moving, q = manifold(scene, numbers, {}), np.zeros(len(scene.q))
    names = [u.name for u in scene.u]

    def start(**given: float) -> dict[str, float]:
        u = consistent_speeds(moving, 0.0, q, read_initial(scene, given)[1])
        assert np.max(np.abs(moving.speed(0.0, q, u)[0])) < 1e-13
        return dict(zip(names, u.tolist(), strict=True))

    radius, turn = 0.3, scene.example["tR_dot"]
    assert start()["tR_dot"] == turn
    assert start()["x_dot"] == pytest.approx(-radius * turn)
    assert start(x_dot=6.0)["x_dot"] == 6.0
    assert start(x_dot=6.0)["tR_dot"] == pytest.approx(-6.0 / radius)


def test_speeds_that_contradict_the_closure_are_refused(linkage: Model) -> None:
    with pytest.raises(InputError, match=r"q1_dot, q2_dot contradict the constraints.* 1 free"):
        simulate(linkage, 1.0, initial={"q1_dot": 1.0, "q2_dot": 5.0})

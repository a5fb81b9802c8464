"""Bodies that a quaternion turns: functions as Newton and Euler say, motions through every pose."""

import numpy as np
import pytest
from quaternions import VALUES, ball_top, rolling_ball, sliding_top, thrown_body

from mechanics import compile, derive, simulate
from mechanics.compiled import Model
from mechanics.errors import InputError

m, g, l, A, C = (VALUES[name] for name in "mglAC")
I_POINT = np.diag([A + m * l**2, A + m * l**2, C])


@pytest.fixture(scope="module")
def top() -> Model:
    return compile(derive(ball_top(), "kane"))


def rotation(e: np.ndarray) -> np.ndarray:
    """Rodrigues' formula: exp of the vector whose length is the angle."""
    unit = e / np.linalg.norm(e)
    angle = 2 * np.arctan2(np.linalg.norm(unit[1:]), unit[0])
    x, y, z = unit[1:] / np.linalg.norm(unit[1:])
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * skew + (1 - np.cos(angle)) * skew @ skew


def states() -> list[tuple[np.ndarray, np.ndarray]]:
    random = np.random.default_rng(7)
    drawn = [(random.normal(size=4), random.normal(size=3)) for _ in range(20)]
    return [(e / np.linalg.norm(e), w) for e, w in drawn]


def torque(e: np.ndarray) -> np.ndarray:
    """Of the weight about the ball joint, in the body."""
    return np.cross([0, 0, l], rotation(e).T @ [0, 0, -m * g])


@pytest.mark.parametrize("route", ["kane", "free_body"])
def test_functions_of_the_top_are_those_of_newton_and_euler(route: str) -> None:
    model = compile(derive(ball_top(), route))
    for e, w in states():
        gyroscopic = np.cross(w, I_POINT @ w)
        expected = np.linalg.solve(I_POINT, torque(e) - gyroscopic)
        assert model.forward_dynamics(e, w) == pytest.approx(expected, abs=1e-12)
        applied = model.inverse_dynamics(e, w, [1, 2, 3])
        left = I_POINT @ [1, 2, 3] + gyroscopic - torque(e)
        assert applied == pytest.approx(left, abs=1e-12)
        energy = model.energy(e, w)
        assert energy["kinetic"] == pytest.approx(w @ I_POINT @ w / 2)
        assert energy["potential"] == pytest.approx(m * g * l * rotation(e)[2, 2], abs=1e-12)


def test_the_mass_matrix_of_the_top_is_constant(top: Model) -> None:
    for e, w in states():
        assert top.mass_matrix(e, w) == pytest.approx(I_POINT, abs=1e-12)


def test_rates_turn_the_body_with_its_angular_velocity(top: Model) -> None:
    """dR/dt = R [w]x, by a central difference."""
    for e, w in states():
        rate, h = top.coordinate_rates(e, w), 1e-6
        moved = (rotation(e + h * rate) - rotation(e - h * rate)) / (2 * h)
        skew = np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])
        assert moved == pytest.approx(rotation(e) @ skew, abs=1e-8)


def test_a_quaternion_and_its_multiple_are_one_orientation(top: Model) -> None:
    for e, w in states():
        assert top.forward_dynamics(-3 * e, w) == pytest.approx(top.forward_dynamics(e, w))


@pytest.mark.parametrize("start", [{"wz": 0, "wx": 9}, {"e0": 0, "e1": 1, "wy": 3}, {}])
def test_the_motion_goes_on_through_every_orientation(top: Model, start: dict) -> None:
    found = simulate(top, 4, initial=start, samples=200)
    norm = sum(found.coordinates[name] ** 2 for name in ("e0", "e1", "e2", "e3"))
    total = found.kinetic + found.potential
    assert found.times[-1] == 4
    assert norm == pytest.approx(np.ones(200), abs=1e-13)
    assert total == pytest.approx(np.full(200, total[0]), abs=1e-7)


@pytest.mark.campaign
def test_a_thrown_body_keeps_its_angular_momentum() -> None:
    model = compile(derive(thrown_body(), "kane"))
    found = simulate(model, 4, samples=100)
    inertia = np.diag([VALUES[name] for name in "ABC"])
    e, w = (
        np.array([column[name] for name in names]).T
        for column, names in (
            (found.coordinates, ("e0", "e1", "e2", "e3")),
            (found.speeds, ("wx", "wy", "wz")),
        )
    )
    spins = [rotation(one) @ inertia @ two for one, two in zip(e[1:], w[1:], strict=True)]
    assert spins == pytest.approx(np.tile(inertia @ w[0], (99, 1)), abs=1e-8)
    assert found.coordinates["x"] == pytest.approx(found.times)
    assert found.coordinates["z"] == pytest.approx(-g * found.times**2 / 2, abs=1e-8)


def test_a_top_starts_with_its_tip_on_the_ground_and_stays_there() -> None:
    found = simulate(compile(derive(sliding_top(), "kane")), 1, samples=50)
    e = np.array([found.coordinates[name] for name in ("e0", "e1", "e2", "e3")]).T
    heights = [l * rotation(one)[2, 2] for one in e]
    assert e[0] == pytest.approx(np.array([0.95, 0.3, 0, 0]) / np.hypot(0.95, 0.3))
    assert found.coordinates["z"] == pytest.approx(heights, abs=1e-12)
    total = found.kinetic + found.potential
    assert total == pytest.approx(np.full(50, total[0]), abs=1e-7)


def test_a_rolling_ball_keeps_its_angular_momentum_about_the_contact() -> None:
    """All forces pass through the contact, which moves along with the centre."""
    found = simulate(compile(derive(rolling_ball(), "kane")), 1, samples=50)
    e, w = (
        np.array([column[name] for name in names]).T
        for column, names in (
            (found.coordinates, ("e0", "e1", "e2", "e3")),
            (found.speeds, ("wx", "wy", "wz")),
        )
    )
    moments = []
    for one, two in zip(e[1:], w[1:], strict=True):
        turn = rotation(one)
        arm = np.array([0, 0, l])
        spin = turn @ np.diag([A, A, C]) @ two
        moments.append(spin + np.cross(arm, m * np.cross(turn @ two, arm)))
    assert moments == pytest.approx(np.tile(moments[0], (49, 1)), abs=1e-8)


def test_a_start_is_divided_by_its_norm_and_zero_is_refused(top: Model) -> None:
    found = simulate(top, 0.1, initial={"e0": 3, "e2": 4}, samples=2)
    first = [found.coordinates[name][0] for name in ("e0", "e1", "e2", "e3")]
    assert first == pytest.approx([0.6, 0, 0.8, 0])
    with pytest.raises(InputError, match="e0 e1 e2 e3: a quaternion of norm 0") as caught:
        simulate(top, 1, initial={"e0": 0})
    assert "\n" not in str(caught.value)

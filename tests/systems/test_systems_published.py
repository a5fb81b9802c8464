"""Systems that ship, beyond those that all laws are tried on: cross-checked as they stand."""

import numpy as np
import pytest

from mechanics import CrossCheck, check, compile, crosscheck, derive
from mechanics.cli.crosscheck import exit_code
from mechanics.errors import SceneError
from mechanics.kernel import Verdict
from systems import (
    ALL,
    EVERY,
    VARIANTS,
    arm_puma560,
    arm_seven_joints,
    atwood,
    four_bar_chain,
    humanoid,
)

OTHERS = [system for system in EVERY if system not in (*ALL, *VARIANTS)]


@pytest.mark.campaign
@pytest.mark.sample(2)
@pytest.mark.parametrize("system", OTHERS, ids=lambda system: system.name)
def test_every_system_is_shown_with_its_published_rows(system) -> None:
    result = crosscheck(system, CrossCheck(states=1000))
    assert len(result.published) == len(system.published)
    assert all(finding.shown for finding in result.pairs.values())
    assert exit_code([result]) == 0


def test_puma560_weighs_and_moves_as_published() -> None:
    """`gravload(qn)` and `inertia(qn)` of Corke's toolbox, motors and their gears added there."""
    model = compile(derive(arm_puma560.scene(), "kane"), compiler=None)
    rest = np.zeros(6)
    pose = np.array([0, np.pi / 4, np.pi, 0, np.pi / 4, 0])
    torques = model.inverse_dynamics(pose, rest, rest, inputs=rest)
    assert np.allclose(torques, [0, 31.6399, 6.0351, 0, 0.0283, 0], atol=5e-5)
    motors = np.array([200e-6, 200e-6, 200e-6, 33e-6, 33e-6, 33e-6])
    gears = np.array([-62.6111, 107.815, -53.7063, 76.0364, 71.923, 76.686])
    inertia = model.mass_matrix(pose, rest, inputs=rest) + np.diag(motors * gears**2)
    assert np.allclose(
        np.diag(inertia), [3.6594, 4.4137, 0.9378, 0.1925, 0.1713, 0.1941], atol=5e-5
    )
    assert np.allclose(inertia[0, 1:4], [-0.4044, 0.1006, -0.0025], atol=5e-5)
    assert np.allclose(inertia[1, 2:5], [0.3509, 0, 0.0024], atol=5e-5)


def test_puma560_weighs_and_moves_as_published_where_no_angle_is_special() -> None:
    """`gravload([1 2 3 4 5 6])` and the upper half of `inertia` there, less its diagonal."""
    model = compile(derive(arm_puma560.scene(), "kane"), compiler=None)
    rest, pose = np.zeros(6), np.arange(1.0, 7.0)
    torques = model.inverse_dynamics(pose, rest, rest, inputs=rest)
    assert np.allclose(torques, [0, -7.9683, 8.4581, -0.0197, 0.0027, 0], atol=5e-5)
    inertia = model.mass_matrix(pose, rest, inputs=rest)
    assert np.allclose(inertia[0, 1:], [-0.6550, -0.0363, 0.0001, 0.0010, 0], atol=5e-5)
    assert np.allclose(inertia[1, 2:], [0.2953, -0.0008, -0.0017, 0], atol=5e-5)
    assert np.allclose(inertia[2, 3:], [-0.0009, -0.0006, 0], atol=5e-5)


@pytest.mark.parametrize(("centre", "wrist"), [(0.019, 8.74), (-0.019, 8.44)])
def test_gravity_on_puma560_has_armstrongs_constants(centre: float, wrist: float) -> None:
    """g_2 = -g1 C2 - g3 S2 + g4 C23 + g2 S23 of Armstrong, Khatib and Burdick, 1986.

    q3 is theirs less pi, and what turns with q5 is taken out. Their mass centre of link 4 lies
    before the wrist, that of Corke's table beyond it.
    """
    model = compile(derive(arm_puma560.scene(), "kane"), compiler=None)
    p = model.typical.copy()
    p[[str(entry.symbol) for entry in model.quantities.p].index("ry4")] = centre
    rest, forms, torques = np.zeros(6), [], []
    for q2, q3 in [(0, 0), (0, 1), (1, 0), (1, 1), (2, -1)]:
        ends = [
            model.inverse_dynamics([0, q2, q3, 0, q5, 0], rest, rest, inputs=rest, p=p)[1]
            for q5 in (0, np.pi)
        ]
        forms.append([np.cos(q2), np.sin(q2), np.cos(q2 + q3), np.sin(q2 + q3)])
        torques.append(sum(ends) / 2)
    constants, left, *_ = np.linalg.lstsq(np.array(forms), np.array(torques))
    assert np.allclose(left, 0, atol=1e-20)
    half_units = np.array([0.05, 0.005, 0.0005, 0.005])
    assert (abs(constants - [37.2, -1.02, 0.249, -wrist]) <= half_units).all()


def test_an_arm_of_seven_joints_reaches_where_its_maker_says() -> None:
    """The pose called ready holds a hand of 0.1034 m at (0.307, 0, 0.487) m, turned down."""
    model = compile(derive(arm_seven_joints.scene(), "kane"), compiler=None)
    ready = np.array([0, -np.pi / 4, 0, -3 * np.pi / 4, 0, np.pi / 2, np.pi / 4])
    flange = np.array(model.flange(ready)).ravel()
    assert np.allclose(flange - [0, 0, 0.1034], [0.307, 0, 0.487], atol=5e-4)


@pytest.mark.parametrize("segments", [1, pytest.param(3, marks=pytest.mark.campaign)])
def test_a_humanoid_falls_as_one_body_whatever_its_limbs_are(segments: int) -> None:
    """Without torques and turning the joints stay as they are, and all of it falls with g."""
    model = compile(derive(humanoid.scene(segments), "kane"), compiler=None)
    n = 4 * segments
    q = np.concatenate([[0.1, 0.2, 1.0, 0.5, 0.5, -0.5, 0.5], np.linspace(-1, 1, n)])
    found = np.array(model.forward_dynamics(q, np.zeros(6 + n), inputs=np.zeros(n)))
    speeds = [str(entry.name) for entry in model.quantities.u]
    falls = np.array([-9.81 if name == "z_dot" else 0.0 for name in speeds])
    assert np.allclose(found, falls, atol=1e-11)


def test_a_humanoid_of_no_segments_is_refused() -> None:
    with pytest.raises(SceneError, match="one, two or three"):
        humanoid.scene(0)


def test_a_row_of_four_bars_swings_as_one_pendulum() -> None:
    """Cranks of equal length turn about their ends, couplers stay level and move on circles."""
    model = compile(derive(four_bar_chain.scene(3)), compiler=None)
    angle, rate, loops = 0.7, 1.3, 3
    q = np.array([0.0 if k % 2 else angle for k in range(2 * loops + 1)])
    u = np.array([0.0 if k % 2 else rate for k in range(2 * loops + 1)])
    weight = (loops + 1) / 2 + loops
    wanted = -9.81 * weight * np.cos(angle) / ((loops + 1) / 3 + loops)
    found = model.forward_dynamics(q, u)
    assert np.allclose(found[0::2], wanted, rtol=1e-12)
    assert np.allclose(found[1::2], 0, atol=1e-10)


def test_an_energy_under_constraints_may_be_written_in_other_coordinates() -> None:
    """By the ropes' lengths, as its source prints it: z = l1 - x, w = l2 - y."""
    right = "U = -m1*g*x - m2*g*(l1 - x + y) - m3*g*(l1 - x + l2 - y)"
    assert check(atwood.scene(), right).verdict is Verdict.PROVED
    assert check(atwood.scene(), right.replace("l2 - y", "y")).verdict is Verdict.REFUTED

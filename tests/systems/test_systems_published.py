"""Systems that ship, beyond those that all laws are tried on: cross-checked as they stand."""

import numpy as np
import pytest

from mechanics import CrossCheck, compile, crosscheck, derive
from mechanics.cli.crosschecking import exit_code
from systems import ALL, EVERY, VARIANTS, arm_puma560

OTHERS = [system for system in EVERY if system not in (*ALL, *VARIANTS)]


@pytest.mark.campaign
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

"""Andrews' squeezing mechanism: derived, shown and moved as its authors state it."""

import numpy as np
import pytest

from mechanics import compile, derive
from mechanics.checks.admissible import check_scene
from mechanics.checks.agreement import compare_pairs
from mechanics.crosscheck.programs import check_laws, derive_rows
from mechanics.simulate import simulate
from systems import andrews

ROUTES = ("free_body", "moving_point", "kane", "lagrange")


@pytest.mark.campaign
def test_all_routes_agree_on_it_and_all_laws_hold() -> None:
    mechanism = check_scene(andrews.scene())
    assert len(mechanism.closure.values) == 12
    programs = derive_rows(mechanism, ROUTES)
    pairs = compare_pairs(programs.routes)
    assert len(pairs) == 6
    assert all(finding.shown for finding in pairs.values())
    laws = list(check_laws(programs))
    assert len(laws) == 30
    assert all(finding.shown for finding in laws)


@pytest.mark.campaign
def test_it_moves_as_it_is_published() -> None:
    """Relative to the published values; a converged solution is nearer than these are."""
    model = compile(derive(andrews.scene()), compiler=None)
    ends = []
    for method, rtol in (("DOP853", 1e-12), ("DOP853", 1e-13), ("Radau", 1e-11)):
        motion = simulate(model, andrews.END, samples=2, method=method, rtol=rtol, atol=rtol / 100)
        assert list(motion.coordinates) == list(andrews.ANGLES)
        angles, rates = (
            np.array([values[-1] for values in columns.values()])
            for columns in (motion.coordinates, motion.speeds)
        )
        assert np.allclose(angles, list(andrews.ANGLES.values()), rtol=1e-9, atol=0)
        assert np.allclose(rates, list(andrews.RATES.values()), rtol=1e-7, atol=0)
        ends.append(np.concatenate([angles, rates]))
    assert np.allclose(ends[1:], ends[0], rtol=1e-10, atol=0)

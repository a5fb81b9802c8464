"""The motion does not depend on the route whose equations are integrated."""

import functools

import pytest

from mechanics.compiled.model import compile
from mechanics.routes.derivation import by_route
from mechanics.simulate import Trajectory, simulate
from systems import four_bar

ROUTES = ("free_body", "moving_point", "kane", "lagrange")
# A rocker that coupler and crank cannot pull round: it passes the dead points where they line up.
ROCKING = {"l1": 0.3, "l2": 0.1, "l3": 0.15, "d": 0.2}


@functools.cache
def rocking(route: str) -> Trajectory:
    model = compile(by_route(route, four_bar.scene()), compiler=None)
    return simulate(
        model, 1.0, parameters=ROCKING, initial={"q1": 0.3, "q1_dot": 0.0}, samples=11, rtol=1e-11
    )


@pytest.mark.sample(0)
@pytest.mark.parametrize("route", ["free_body", "moving_point", "lagrange"])
def test_linkage_moves_the_same_by_every_route(route: str) -> None:
    reference, motion = rocking("kane"), rocking(route)
    assert motion.branch == reference.branch
    assert motion.energy_drift < 1e-8
    for name, values in reference.coordinates.items():
        assert motion.coordinates[name] == pytest.approx(values, abs=1e-7)

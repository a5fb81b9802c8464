"""Trades measured once for all tests about them, with the methods that need nothing installed."""

from functools import partial

import pytest

from mechanics.cli.load import load
from mechanics.crosscheck import derive
from mechanics.simulate.integrators import INTEGRATORS
from mechanics.trade import Trade, trade
from mechanics.trade.case import Case

FEW = tuple(m for m in INTEGRATORS if m.name in ("SciPy DOP853", "C RK5", "C RK8", "heyoka Taylor"))


@pytest.fixture(scope="session")
def pendulum() -> Trade:
    """The pendulum on an elastic support over four seconds."""
    by = partial(derive, route="kane")
    equations = by(load("elastic_pendulum").scene())
    return trade(equations, 4.0, target=(1e-3, 1e-6, 1e-8, 1e-9), members=FEW, derive=by)


@pytest.fixture(scope="session")
def case() -> Case:
    """The same motion."""
    return Case(derive(load("elastic_pendulum").scene(), "kane"), 4.0)

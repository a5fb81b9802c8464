"""Accelerations that are no numbers are found, and said to be so, with a cause that is shown here.

A double pendulum of point masses: rows times masses and lengths leave single precision.
"""

import numpy as np
import pytest

from mechanics import derive
from mechanics.compiled import Model, residuals
from mechanics.compiled import compile as compile_model
from mechanics.compiled.finite import not_finite
from mechanics.kernel import Verdict
from systems.double_pendulum import l1, l2, m1, m2, scene

pytestmark = pytest.mark.campaign

STATES = 20_000


@pytest.fixture(scope="module")
def overflowing() -> Model:
    equations, factor = derive(scene(), "kane"), m1 * m2 * l1 * l2
    mass, forcing = equations.mass * factor, equations.forcing * factor
    scaled = equations.with_matrices(mass=mass, forcing=forcing)
    return compile_model(scaled, form="elimination")


def test_an_overflow_on_the_way_is_a_finding_that_says_where_and_why(overflowing: Model) -> None:
    (lost,) = not_finite([overflowing], states=STATES)
    assert lost.subject == "kane: accelerations, single"
    assert 0 < lost.lost < STATES / 50 and lost.states == STATES
    finding = lost.finding
    assert finding.verdict is Verdict.UNDECIDED
    assert "overflow" in finding.evidence and "3.4e+38" in finding.evidence
    # The state that is named is one, and another precision has numbers there.
    state = dict(lost.state)
    q, u = [state["phi1"], state["phi2"]], [state["phi1_dot"], state["phi2_dot"]]
    p = [state[entry.name] for entry in overflowing.quantities.p]
    single, double = (
        overflowing.evaluate("forward_dynamics", kind, q=[q], u=[u], inputs=[[]], p=[p])["ud"]
        for kind in (np.float32, np.float64)
    )
    assert not np.isfinite(single).all()
    assert np.isfinite(double).all() and np.abs(double).max() < 3.4e38


def test_the_form_that_is_chosen_survives() -> None:
    models = [compile_model(derive(scene(), r)) for r in ("free_body", "kane")]
    assert not_finite(models, states=STATES) == ()


def test_a_form_that_single_precision_cannot_follow_is_not_chosen(derived) -> None:
    equations = derived("pendulum_chain", "moving_point")
    assert not_finite([compile_model(equations, form="fewest")], states=STATES)
    assert not_finite([compile_model(equations)], states=STATES) == ()


def test_residuals_are_those_of_the_states_that_have_numbers(overflowing: Model) -> None:
    scene = overflowing.equations.scene
    rows = [("(1)", *(overflowing.equations.residual[0], 0 * m1))]
    (found,) = residuals([overflowing], rows, states=STATES, precisions=[np.float32])
    assert np.isfinite(found.max_eps) and found.max_eps > 0
    assert dict(found.worst).keys() >= {symbol.name for symbol in (*scene.q, *scene.ud)}
    assert found.confirmed < STATES / 50

"""The least model: amplitudes against the exact period of a pendulum, parts that may be dropped."""

from functools import partial

import numpy as np
import pytest
from particles import on_line
from particles import pendulum as rod
from sympy.physics.mechanics import dynamicsymbols

from mechanics.cli.load import load
from mechanics.crosscheck import derive
from mechanics.errors import InputError
from mechanics.scene import Scene, damper, parameters, spring
from mechanics.simulate.integrators import Setting
from mechanics.trade import Trade
from mechanics.trade.amplitude import amplitudes
from mechanics.trade.case import Case
from mechanics.trade.choice import LINEARIZED, Choice, Variant
from mechanics.trade.dropping import ENOUGH, dropped
from mechanics.trade.linearized import equilibria, is_linear

RK8 = Choice(Variant(), Setting("C RK8", step=0.02))
KANE = partial(derive, route="kane")


def oscillator(damping: str) -> Scene:
    """A mass on a spring with a damper."""
    x, (m, k, c) = dynamicsymbols("x"), parameters("m k c", typical=f"1 4 {damping}")
    return on_line(
        "oscillator", x, m, example={"x": 1.0},
        loads=lambda N, O, P: (spring("k", O, P, k, along=N.x), damper("c", O, P, c, along=N.x)),
    )  # fmt: skip


def test_amplitude_of_a_pendulum_is_what_its_period_says() -> None:
    case = Case(KANE(rod(example={"theta": 0.3})), 10.0)
    (stable,) = [e for e in equilibria(case.equations, {}, case.suggested[0]) if e.stable]
    (row,) = amplitudes(case, stable, RK8)
    # omega = omega_0 (1 - a^2 / 16): the phase is off by omega_0 T a^2 / 16, and the speed, by as
    # much of its largest value, at a maximum of the displacement.
    omega = np.sqrt(9.81)
    predicted = np.sqrt(16 * ENOUGH / (omega * 10.0))
    assert row.limit == pytest.approx(predicted, rel=0.1)
    assert "within 1 % up to" in row.words


def test_error_grows_with_the_square_of_the_amplitude() -> None:
    case = Case(KANE(rod(example={"theta": 0.3})), 10.0)
    (row,) = amplitudes(case, equilibria(case.equations, {}, case.suggested[0])[0], RK8)
    small = [(a, e) for a, e in row.curve if a < row.limit]
    slopes = np.diff(np.log([e for _, e in small])) / np.diff(np.log([a for a, _ in small]))
    assert np.allclose(slopes, 2.0, atol=0.05)


def test_linear_equations_are_enough_at_any_amplitude() -> None:
    case = Case(KANE(load("two_mass_chain").scene()), 10.0)
    assert is_linear(case.equations)
    rows = amplitudes(case, equilibria(case.equations, {}, case.suggested[0])[0], RK8)
    assert [row.limit for row in rows] == [np.inf, np.inf]
    assert not is_linear(KANE(load("elastic_pendulum").scene()))


def test_unstable_equilibrium_is_told_with_its_rate() -> None:
    case = Case(KANE(load("rocker").scene()), 10.0)
    at = next(e for e in equilibria(case.equations, {}, case.suggested[0]) if e.distance < 1)
    assert not at.stable
    M, R, g = (float(case.p(case.model())[case.model().entries["p"].index(n)]) for n in "MRg")
    inertia = float(case.p(case.model())[case.model().entries["p"].index("I_C")])
    # About the contact point: (I_C + M (3R/2)^2) theta'' = M g R/2 theta.
    expected = np.sqrt(M * g * R / 2 / (inertia + M * (1.5 * R) ** 2))
    assert at.growth == pytest.approx(expected, rel=1e-12)
    (row,) = amplitudes(case, at, Choice(Variant(), Setting("C RK8", step=0.03)))
    assert row.limit < 1e-15
    assert "grows e-fold" in row.words


def test_system_without_linear_model_is_refused_by_name() -> None:
    case = Case(KANE(load("rolling_disc").scene()), 1.0)
    with pytest.raises(InputError, match="rolling disc: it has constraints"):
        equilibria(case.equations, {}, case.suggested[0])


@pytest.mark.campaign
@pytest.mark.parametrize(("damping", "may"), [("0.0001", True), ("0.5", False)])
def test_damper_may_be_left_out_when_it_takes_little(damping: str, may: bool) -> None:
    case = Case(KANE(oscillator(damping)), 5.0)
    rows = {row.name: row for row in dropped(case, KANE, RK8)}
    row = rows["damper c"]
    assert (row.error <= ENOUGH) is may
    assert ("may be left out" in row.words.split(" below ")[0]) or not may
    if not may:
        # x' decays by exp(-c t / 2 m): 1 % at the last extreme before 5 s.
        assert row.share * float(damping) == pytest.approx(2 * ENOUGH / 5.0, rel=0.15)


@pytest.mark.campaign
def test_leaving_out_saves_operations(pendulum: Trade) -> None:
    assert pendulum.least is not None
    models = {f.name: f for f in pendulum.least.fidelities}
    whole = models["as declared"]
    assert models[LINEARIZED].operations < whole.operations
    assert models["gravity"].operations < whole.operations
    assert all(f.operations <= whole.operations for f in models.values())
    assert all(len(f.seconds) >= 3 for f in models.values())


@pytest.mark.campaign
def test_what_cannot_be_left_out_is_said_to_be() -> None:
    case = Case(KANE(load("rolling_disc").scene()), 1.0)
    rows = {r.name: r for r in dropped(case, KANE, Choice(Variant(), Setting("C RK8", step=0.05)))}
    assert rows["inertia of disc"].error == np.inf
    assert "cannot be left out" in rows["inertia of disc"].words

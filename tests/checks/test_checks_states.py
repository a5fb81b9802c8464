"""States that a check draws: as many as asked for, on the constraints and on the unit sphere."""

from quaternions import ball_top

from mechanics.checks.states import draw_states
from mechanics.checks.virtual_power import BITS
from mechanics.kernel.balls import precision
from systems import double_pendulum


def test_as_many_states_are_drawn_as_are_asked_for() -> None:
    for count in (1, 3):
        with precision(BITS):
            assert len(draw_states(double_pendulum.scene(), count)) == count


def test_quaternions_are_drawn_on_the_unit_sphere_and_stay_there() -> None:
    with precision(BITS):
        states = draw_states(ball_top(), 2)
        assert len(states) == 2
        for state in states:
            away = sum(e * e for e in state.q) - 1
            along = sum(e * rate for e, rate in zip(state.q, state.rates(state.u), strict=True))
            for residual in (away, along):
                assert residual.contains(0)
                assert residual.rad() < 1e-20
            assert any(not rate.contains(0) for rate in state.rates(state.u))

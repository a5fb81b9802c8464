"""What is measured: errors against the reference, evaluations, energy, a front."""

import json
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from mechanics.cli.load import load
from mechanics.crosscheck import derive
from mechanics.errors import InputError
from mechanics.simulate.integrators import Setting
from mechanics.trade import Trade, trade
from mechanics.trade.case import Case
from mechanics.trade.choice import Choice, Variant
from mechanics.trade.measure import prepared
from mechanics.trade.pareto import pareto
from mechanics.trade.record import to_record
from mechanics.trade.run import TARGETS, targets_of
from mechanics.trade.survey import LONGEST
from mechanics.trade.truth import from_states
from mechanics.trade.yardstick import with_informative_start, yardstick

TIGHT = Choice(Variant(), Setting("SciPy DOP853", tolerance=1e-12))


@pytest.mark.campaign
def test_errors_follow_from_the_reference(pendulum: Trade, case: Case) -> None:
    # As `trade` measures: fixed steps go on through the samples.
    through = replace(case, through=True)
    for m in pendulum.front:
        errors = pendulum.yardstick.truth.errors(prepared(through, m.choice)().states)
        assert m.error_end == errors[-1]
        assert m.error_largest == np.max(errors)


@pytest.mark.campaign
def test_reference_has_thirty_digits_and_says_how_it_is_known(pendulum: Trade) -> None:
    assert pendulum.yardstick.digits >= 30
    assert len(pendulum.yardstick.verified_by) >= 1
    assert all(len(text.replace("-", "").replace(".", "")) >= 30 for text in pendulum.yardstick.end)


@pytest.mark.campaign
def test_front_is_what_no_other_beats(pendulum: Trade) -> None:
    front = pendulum.front
    for m in front:
        others = [o for o in pendulum.measurements if o.choice.variant.careful]
        assert not [o for o in others if o.time < m.time and o.error_largest < m.error_largest]
    times = [m.time for m in front]
    assert times == sorted(times)
    assert len(front) >= 4


@pytest.mark.campaign
def test_pareto_of_known_points(pendulum: Trade) -> None:
    one = pendulum.measurements[0]
    points = [(1.0, 1e-3), (2.0, 1e-6), (3.0, 1e-4), (2.5, 1e-9)]
    made = [replace(one, seconds=(t,), error_largest=e) for t, e in points]
    assert pareto(made) == (0, 1, 3)
    made.append(replace(one, seconds=(2.2,), error_largest=0.999e-6))
    assert pareto(made) == (0, 1, 4, 3) and pareto(made, 0.01) == (0, 1, 3)


@pytest.mark.campaign
def test_no_two_choices_are_the_same_motion(pendulum: Trade) -> None:
    """Equal in integrator, precision, evaluations and error: only forms and settings may be."""
    found = [
        (m.choice.setting.integrator, m.choice.setting.arithmetic, m.evaluations, m.error_largest)
        for m in pendulum.measurements
        if m.choice.variant == Variant() and not m.failure and not m.choice.setting.tolerance
    ]
    assert len(found) == len(set(found)) > 10
    errors = [m.error_largest for m in pendulum.front]
    assert all(b < 0.99 * a for a, b in pairwise(errors))


@pytest.mark.campaign
def test_every_axis_is_measured(pendulum: Trade) -> None:
    choices = [m.choice for m in pendulum.measurements]
    assert {"SciPy DOP853", "C RK5", "C RK8"} <= {c.setting.integrator for c in choices}
    assert {c.setting.arithmetic for c in choices} == {"double", "single"}
    assert {c.variant.model for c in choices} == {"nonlinear", "linearized"}
    assert len({c.variant.form for c in choices}) >= 3
    if "C (" in pendulum.backend:
        assert any("-ffast-math" in c.variant.flags for c in choices)


@pytest.mark.campaign
def test_axes_are_varied_one_at_a_time(pendulum: Trade) -> None:
    plain = Variant()
    for m in pendulum.measurements:
        variant = m.choice.variant
        different = [
            variant.form != plain.form,
            variant.flags != plain.flags,
            variant.model != plain.model,
        ]
        assert sum(different) <= 1


@pytest.mark.campaign
def test_higher_order_pays_at_high_accuracy(pendulum: Trade) -> None:
    # Evaluations, not times: RK8 needs fewer than RK5 for the same error.
    def fewest(name: str) -> int:
        return min(
            m.evaluations
            for m in pendulum.measurements
            if m.choice.setting.integrator == name
            and m.choice.setting.arithmetic == "double"
            and m.error_largest <= 1e-9
        )

    assert fewest("C RK8") < fewest("C RK5")


@pytest.mark.campaign
def test_energy_drift_falls_with_the_error(pendulum: Trade) -> None:
    ladder = [
        m for m in pendulum.measurements
        if m.choice.setting.integrator == "SciPy DOP853" and m.choice.variant.plain
        and m.choice.setting.arithmetic == "double"
    ]  # fmt: skip
    assert all(m.energy_drift is not None for m in ladder)
    assert ladder[-1].energy_drift < 1e-6 * ladder[0].energy_drift


@pytest.mark.campaign
def test_times_are_repeated_and_their_spread_is_shown(pendulum: Trade) -> None:
    for m in pendulum.front:
        if m.time * pendulum.horizon < LONGEST:
            assert len(m.seconds) >= 3
        low, high = m.spread
        assert min(m.seconds) <= low <= m.time <= high <= max(m.seconds)


@pytest.mark.campaign
def test_record_holds_every_figure(pendulum: Trade) -> None:
    record = json.loads(json.dumps(to_record(pendulum), allow_nan=False))
    assert len(record["measurements"]) == len(pendulum.measurements)
    for entry, m in zip(record["measurements"], pendulum.measurements, strict=True):
        assert np.median(entry["seconds"]) == pytest.approx(m.time)
    errors = {e["choice"]["words"]: e["errors"] for e in record["states"]["errors"]}
    for pick in record["recommendations"]:
        assert max(errors[pick["choice"]["words"]]) <= pick["bound"] <= pick["target"]
    starts = np.array(record["states"]["starts"])
    assert np.array_equal(starts, pendulum.family.starts)


@pytest.mark.campaign
def test_fast_math_is_measured_but_never_picked(pendulum: Trade) -> None:
    assert all(m.choice.variant.careful for m in pendulum.front)
    assert not Variant(flags="-O3 -ffast-math").careful


def test_choice_says_what_it_is() -> None:
    from mechanics.simulate.integrators import Setting

    choice = Choice(Variant(form="primitive"), Setting("C RK8", step=0.01, arithmetic="single"))
    assert choice.words == "C RK8, step 0.01 s, single precision, form primitive"
    assert choice.with_amount(0.005).setting.step == 0.005


@pytest.mark.campaign
def test_chaotic_motion_is_compared_only_while_that_means_something() -> None:
    equations = derive(load("pendulum_chain(2)").scene(), "kane")
    wild = Case(equations, 60.0, {"q1": 0.1, "q2": -0.2, "q1_dot": 2.0, "q2_dot": -7.0})
    short, stick, notes = yardstick(wild, 12)
    assert short.horizon < 60.0
    assert short.horizon == pytest.approx(stick.meaningful_until)
    assert "errors are compared until" in notes[0]


@pytest.mark.parametrize(("horizon", "target"), [(0.0, None), (-1.0, None), (1.0, 2.0), (1.0, 0.0)])
def test_values_out_of_range_are_refused(horizon: float, target: float | None) -> None:
    equations = derive(load("two_mass_chain").scene(), "kane")
    with pytest.raises(InputError, match=r"horizon|target"):
        trade(equations, horizon, target=target)


def test_choices_are_measured_beside_a_motion_on_which_any_step_is_exact() -> None:
    """A gyroscope with a fixed axis turns steadily; beside that its axis nutates."""
    asked = Case(derive(load("gyroscope").scene(), "kane"), 1.0)
    moved, (note,) = with_informative_start(asked)
    assert "one step of order 4 is exact" in note
    away = np.abs(moved.start - asked.start)
    assert 0 < away.max() <= 0.1 * 400
    step = Choice(Variant(), Setting("C RK4", step=1.0))
    truth = from_states(prepared(moved, TIGHT)().states)
    assert np.max(truth.errors(prepared(moved, step)().states)) > 1e-3


@pytest.mark.campaign
def test_a_motion_that_comes_to_a_singular_configuration_is_refused() -> None:
    """Rods of one length that fall into one line; a reference would come ever closer to it."""
    with pytest.raises(InputError, match=r"ended at t = 0\.519.* singular.*shorter horizon"):
        trade(derive(load("four_bar_chain").scene(), "kane"), 2.0)


@pytest.mark.campaign
def test_what_should_be_zero_has_no_scale() -> None:
    """Couplers of a row of parallelograms stay level: what they turn is 1e-30 rad of rounding."""
    asked = Case(derive(load("four_bar_chain").scene(), "kane"), 0.3, compiler=None)
    case, stick, notes = yardstick(asked, 12)
    assert case.horizon == 0.3
    assert notes == ()
    assert stick.scale["q1"] == (1.0, "rad")
    assert stick.growth_factor < 100


@pytest.mark.campaign
def test_a_bicycle_that_rides_straight_is_measured_as_it_leans_and_steers() -> None:
    """Lean and steer of its example move by rounding alone; beside it both have a size."""
    asked = Case(derive(load("bicycle").scene(), "kane"), 1.0, compiler=None)
    moved, (note,) = with_informative_start(asked)
    assert "starts beside it" in note
    start = dict(zip(moved.names, moved.start.tolist(), strict=True))
    assert 0.01 < abs(start["lean"]) < 0.15
    assert abs(start["steer"]) < 0.15
    assert start["tR_dot"] == pytest.approx(-10, rel=0.1)
    assert np.max(moved.manifold.residual(0.0, moved.start)) < 1e-12


def test_start_of_other_motions_is_kept() -> None:
    asked = Case(derive(load("rod_pendulum").scene(), "kane"), 1.0)
    assert with_informative_start(asked) == (asked, ())


def test_targets_that_are_asked_for_replace_the_usual_ones() -> None:
    assert targets_of(None) == TARGETS
    assert targets_of(1e-4) == (1e-4,)
    assert targets_of([1e-8, 1e-4, 1e-8]) == (1e-4, 1e-8)

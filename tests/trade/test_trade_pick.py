"""The pick meets its target on initial states that it was not tuned on."""

from dataclasses import replace

import numpy as np
import pytest

from benchmarks.trade_picks import exhaustive
from mechanics.cli.load import load
from mechanics.cluster import workers
from mechanics.crosscheck import derive
from mechanics.simulate.integrators import Setting
from mechanics.simulate.reference import reference
from mechanics.trade import Trade
from mechanics.trade.case import Case
from mechanics.trade.choice import Choice, Variant
from mechanics.trade.family import family, solutions, truth_of
from mechanics.trade.measure import prepared
from mechanics.trade.recommend import recommend
from mechanics.trade.train import SAFETY, Trained, error_of, errors_of, tail_limit
from mechanics.trade.truth import Truth, from_reference, from_states
from mechanics.trade.workers import Workers, to_text

pytestmark = pytest.mark.campaign

OTHERS = 50
SEED = 4711


@pytest.fixture(scope="module")
def others(pendulum: Trade, case: Case) -> list[tuple[np.ndarray, Truth]]:
    """States of the family with another seed, each with a reference of many digits."""
    scale = pendulum.yardstick.truth.scale
    starts = family(case, scale, OTHERS, seed=SEED)
    return [(s, from_reference(reference(case.problem(start=s), 16))) for s in starts]


@pytest.mark.parametrize("target", [1e-3, 1e-6, 1e-9])
def test_pick_meets_its_target_on_states_it_was_not_tuned_on(
    pendulum: Trade, case: Case, others: list[tuple[np.ndarray, Truth]], target: float
) -> None:
    (pick,) = (each for each in pendulum.recommendations if each.target == target)
    assert pick.choice is not None
    errors = [error_of(case, pick.choice, start, truth) for start, truth in others]
    assert max(errors) <= target
    tuned = {tuple(start) for start in pendulum.family.starts}
    assert not tuned & {tuple(start) for start, _ in others}


def test_pick_is_shown_to_meet_its_target(pendulum: Trade) -> None:
    for pick in pendulum.recommendations:
        assert pick.choice is not None and pick.measurement is not None
        assert pick.measurement.error_largest <= pick.bound <= pick.target
        assert pick.choice.variant.careful
        (confirmed,) = [t for t in pendulum.trained if t.choice == pick.choice]
        assert len(confirmed.errors) == len(pendulum.family.starts) >= 300


def test_settings_are_solved_for_and_not_taken_from_a_ladder(pendulum: Trade) -> None:
    """The bound is near the target, but for steps, of which a whole number lies between samples."""
    for pick in (*pendulum.recommendations, *pendulum.embedded):
        assert pick.choice is not None and pick.bound <= pick.target
        if pick.choice.setting.tolerance is not None:
            assert pick.target <= 2 * pick.bound


def test_embedded_pick_has_the_fewest_operations_of_an_exhaustive_search(
    pendulum: Trade, case: Case
) -> None:
    """All numbers of steps of all methods in C, from few to many, until one meets the target."""
    around = pendulum.family
    for pick in pendulum.embedded:
        assert pick.choice is not None
        cost = pendulum.costs[pick.choice].operations
        best = exhaustive(case, around, pick.target)
        assert cost is not None and cost <= 1.2 * best


def test_call_is_told_apart_from_what_the_method_takes(pendulum: Trade) -> None:
    """A call and its steps together are the run; operations are those of the step's graph."""
    for pick in pendulum.recommendations:
        assert pick.choice is not None and pick.measurement is not None
        cost = pendulum.costs[pick.choice]
        if cost.call is not None and cost.step is not None:
            run = pick.measurement.time * pendulum.horizon
            assert cost.call + cost.steps * cost.step == pytest.approx(run, rel=2)
    for pick in pendulum.embedded:
        assert pick.choice is not None
        cost = pendulum.costs[pick.choice]
        assert cost.operations is not None and cost.memory is not None
        assert cost.operations > 4 * 22 * cost.steps / pendulum.horizon
        assert 4 * 4 < cost.memory < 10_000


def test_target_that_nothing_meets_is_said_so(pendulum: Trade) -> None:
    pick = recommend(1e-18, 4.0, None, pendulum.trained)
    assert pick.choice is None
    assert "no choice is shown to stay below it" in pick.reason


def test_noise_is_told(pendulum: Trade) -> None:
    one = pendulum.measurements[0]
    assert not replace(one, seconds=(1.0, 1.1, 1.2, 1.9)).noisy
    assert replace(one, seconds=(1.0, 1.0, 2.5, 2.6)).noisy


def test_bound_covers_what_was_seen_and_grows_with_the_spread(pendulum: Trade) -> None:
    choice = pendulum.trained[0].choice
    near = Trained(choice, 10.0 ** np.linspace(-9, -8.9, 24))
    assert near.bound == pytest.approx(SAFETY * 10**-8.9)
    wide = Trained(choice, 10.0 ** np.random.default_rng(1).normal(-9, 1, 300))
    assert wide.bound >= SAFETY * wide.largest
    assert Trained(choice, np.array([1e-9, np.inf, 1e-9])).bound == np.inf


@pytest.mark.parametrize("index", [0.2, 0.5, 1.0])
def test_tail_limit_covers_the_tail_of_a_pareto_distribution(index: float) -> None:
    random = np.random.default_rng(3)
    above = []
    for _ in range(200):
        errors = 1e-9 * random.uniform(size=300) ** -index
        limit = tail_limit(errors)
        # P(error > limit), exactly.
        above.append((limit / 1e-9) ** (-1 / index))
    assert np.mean(np.array(above) <= 1e-3) > 0.85


def test_states_are_like_the_example_and_not_the_example(pendulum: Trade, case: Case) -> None:
    around, scale = pendulum.family, pendulum.yardstick.truth.scale
    shares = np.abs(around.starts - case.start) / scale
    assert np.all(shares <= around.spread * (1 + 1e-12))
    assert np.all(np.max(shares, axis=0) > 0.9 * around.spread)


def test_states_of_a_constrained_scene_satisfy_the_constraints() -> None:
    from mechanics.cli.load import load
    from mechanics.crosscheck import derive

    disc = Case(derive(load("rolling_disc").scene(), "kane"), 1.0)
    for start in family(disc, np.ones(len(disc.start)), 5):
        assert np.all(np.abs(disc.manifold.residual(0.0, start)) < 1e-12)


def test_doubt_about_the_comparison_counts_as_an_error(pendulum: Trade, case: Case) -> None:
    truth = pendulum.family.truths[0]
    assert truth.doubt > 0
    first = pendulum.family.first
    assert error_of(case, first, pendulum.family.starts[0], truth) == truth.doubt
    assert prepared(case, first)().failure == ""


def test_what_is_known_for_a_part_of_the_time_tells_nothing_about_the_rest() -> None:
    states = np.arange(8.0).reshape(4, 2) + 1
    truth = from_states(states[:3])
    assert np.array_equal(truth.errors(states[:2]), np.zeros(2))
    assert np.array_equal(truth.errors(states), [0, 0, 0, np.inf])


def test_workers_find_the_same_errors() -> None:
    """To the last bit, whoever takes which state."""
    case = Case(derive(load("rod_pendulum").scene(), "kane"), 1.0, {"theta": 2.0}, through=True)
    first, second = (Choice(Variant(), Setting(f"C RK{k}", step=0.01)) for k in (8, 5))
    coarse = [Choice(Variant(), Setting("C RK4", step=h)) for h in (0.1, 0.2)]
    starts = family(case, np.ones(2), 12)
    known = solutions(case, starts, first, second)
    here = [errors_of(case, choice, starts, list(map(truth_of, known))) for choice in coarse]
    assert np.all(here[0] > 0) and np.all(here[0] < here[1])
    with workers(processes=2) as team:
        by_two = Workers(team, to_text(case))
        for (states, doubt), one in zip(
            by_two.solutions(starts, first, second), known, strict=True
        ):
            assert np.array_equal(states, one.states) and doubt == one.doubt
        assert np.array_equal(by_two.errors(starts, known, coarse, 12), here)
        assert np.array_equal(by_two.errors(starts, known, coarse, 1), [e[:1] for e in here])

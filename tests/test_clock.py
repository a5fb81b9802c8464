"""The stopwatch: work is done as often as asked, and times are those of the work."""

from time import sleep

from mechanics.clock import Stopwatch, side_by_side, timed


def test_work_takes_the_time_that_it_takes() -> None:
    watch = Stopwatch()
    found, seconds = timed(lambda: sleep(0.02) or "done")
    assert found == "done"
    assert 0.02 <= seconds <= watch.seconds


def test_runs_take_turns_between_the_fewest_and_the_most_rounds() -> None:
    order: list[str] = []
    runs = [lambda: order.append("a"), lambda: order.append("b")]
    assert [len(seconds) for seconds in side_by_side(runs, 10.0, (2, 5))] == [5, 5]
    assert order == ["a", "b"] * 5
    slow = side_by_side([lambda: sleep(0.01)], 0.0, (3, 100))
    assert len(slow[0]) == 3 and min(slow[0]) >= 0.01

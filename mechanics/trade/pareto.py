"""Measurements that no other beats."""

from collections.abc import Sequence

from mechanics.trade.measure import Measurement


def pareto(measurements: Sequence[Measurement], alike: float = 0.0) -> tuple[int, ...]:
    """Places of those that no other beats in both time and error, by rising time.

    Parameters
    ----------
    alike : float
        Share of an error by which a slower one has to be below it, to be more than the same.
    """
    order = sorted(range(len(measurements)), key=lambda i: measurements[i].time)
    best, front = float("inf"), []
    for i in order:
        if measurements[i].error_largest < best * (1 - alike):
            best = measurements[i].error_largest
            front.append(i)
    return tuple(front)

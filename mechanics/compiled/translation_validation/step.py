"""One step of the classical Runge-Kutta method, put together from the graph of the rates.

    k1 = f(y),  k2 = f(y + h/2 k1),  k3 = f(y + h/2 k2),  k4 = f(y + h k3)
    y(t + h) = y + h/6 (k1 + 2 k2 + 2 k3 + k4)

f is the graph of the rates (q', u'). Inputs are held, but for the time, which goes on.
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction

from mechanics.compiled.translation_validation.code import Code
from mechanics.program import Builder, Node

STAGES = ((Fraction(1, 2), 2), (Fraction(1, 2), 2), (Fraction(1), 1))
"""For k2, k3, k4: the share of the step, and the weight in the sum; k1 has weight 1."""


def composed(
    builder: Builder, rates: Code, time: int | None, given: Mapping[str, Sequence[Node]],
    cut: Callable[[list[Node]], list[Node]] = list,
) -> dict[str, list[Node]]:  # fmt: skip
    """The step of the rates.

    Parameters
    ----------
    rates : Code
        From q, u, inputs, p (and constants) to qd and ud.
    time : int or None
        Entry of the inputs that is the time.
    given : mapping of str to sequence of Node
        Its inputs, and h.
    cut : callable
        What takes the place of the slopes of a stage.
    """
    (h,) = given["h"]
    start, n = [*given["q"], *given["u"]], len(given["q"])
    total = slopes = cut(_slopes(builder, rates, given))
    for share, weight in STAGES:
        y = [at + h * (slope * share) for at, slope in zip(start, slopes, strict=True)]
        inputs = list(given["inputs"])
        if time is not None:
            inputs[time] = inputs[time] + h * share
        stage = {**given, "q": y[:n], "u": y[n:], "inputs": inputs}
        slopes = cut(_slopes(builder, rates, stage))
        total = [x + slope * weight for x, slope in zip(total, slopes, strict=True)]
    end = [at + h * slope * Fraction(1, 6) for at, slope in zip(start, total, strict=True)]
    return {"q_next": end[:n], "u_next": end[n:]}


def _slopes(builder: Builder, rates: Code, given: Mapping[str, Sequence[Node]]) -> list[Node]:
    found = rates.results(builder, given)
    return [*found["qd"], *found["ud"]]

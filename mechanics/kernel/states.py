"""States that are tried, people's first.

Simple numbers first, one input at a time, then all together, then scales from 2^-48 to 2^40 and
both sides of every constant. What is drawn is a function of a text, so the same statement is tried
at the same states, on every machine and in every run.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise

from flint import arb

from mechanics.kernel.draws import Draws

State = Mapping[str, Fraction | arb]
"""Values of inputs, by name."""

SIMPLE = tuple(map(Fraction, ["1", "-1", "1/2", "-1/2", "2", "-2", "3", "-3", "10", "-10"]))
DRAWN = 48
"""States at which all inputs are drawn together, half of them on all scales."""

LEAST_SCALE, LARGEST_SCALE = -48, 40


def candidates(
    text: str, names: Sequence[str], positive: Callable[[str], bool], reference: State,
    constants: Sequence[Fraction],
) -> Iterator[State]:  # fmt: skip
    """States that are worth a try, people's first.

    Parameters
    ----------
    text : str
        What the drawn numbers are a function of.
    names : sequence of str
        Inputs that matter; the others stay as in `reference`.
    positive : callable
        Whether the input of a name is positive.
    reference : mapping of str to Fraction
    constants : sequence of Fraction
        Numbers at whose both sides something may change; what lies between two is tried, too.
    """
    pool = list(SIMPLE)
    for constant in constants:
        step = max(abs(constant) / 8, Fraction(1, 1 << 30))
        pool += [constant, constant + step, constant - step, -constant]
    bounds = sorted({abs(constant) for constant in constants})
    pool += [side * (one + two) / 2 for one, two in pairwise(bounds) for side in (1, -1)]
    pool = list(dict.fromkeys(value for value in pool if value))
    for name in names:
        for value in pool:
            if value > 0 or not positive(name):
                yield {**reference, name: value}
    draws = Draws(text)
    for count in range(DRAWN):
        state = dict(reference)
        for name in names:
            value = pool[draws.below(len(pool))]
            if count % 2:
                scale = LEAST_SCALE + draws.below(LARGEST_SCALE - LEAST_SCALE + 1)
                value = Fraction(128 + draws.below(128), 128) * Fraction(2) ** scale
                value = value if draws.below(2) else -value
            state[name] = abs(value) if positive(name) else value
        yield state

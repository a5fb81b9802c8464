r"""Indices of time steps: they are dropped where all that moves is taken at one step.

\theta_k, u_k    ->    theta, u          \theta_k, u_{k-1}    are no names of one instant
"""

import re
from collections.abc import Iterable

from mechanics.claims.spelled_rates import bases, key

STEP = re.compile(
    r"_(?:\w*?(?P<moved>[A-Za-z](?:minus|plus)\w+?)|\d*(?P<at>[ijknt](?:[mp]\d+)?"
    r"|prev|previous|last|old|next|new|delayed))(?:_(?:d|dd|dot|ddot))?$"
)
"""The step at the end of a name; what was written as k - 1 says so."""


def step_of(name: str, meaning: str) -> str:
    """The step at which a name is taken that stands for a function of time; empty for none.

    Parameters
    ----------
    name : str
        The person's.
    meaning : str
        The scene's, without its rate.
    """
    whole = key(meaning)
    if key(name) == whole or any(base == whole for base, _ in bases(name)):
        return ""
    step = _step(name)
    return "" if whole.endswith(step) else step


def _step(name: str) -> str:
    part = STEP.search(name)
    return (part["moved"] or part["at"]) if part else ""


def at_different_steps(names: Iterable[tuple[str, str]]) -> set[str]:
    """Names taken at a step, where what moves is not taken at one step altogether.

    Parameters
    ----------
    names : iterable of (str, str)
        Of a person, with what they stand for in the scene.
    """
    steps = {name: step_of(name, meaning) for name, meaning in names}
    return {n for n, step in steps.items() if step} if len({*steps.values()}) > 1 else set()


def steps_told(names: Iterable[str]) -> str:
    """Names that are taken at different steps, in words; empty where there are none."""
    steps = {name: step for name in names if (step := _step(name))}
    return f"{', '.join(steps)} are taken at different steps" if len({*steps.values()}) > 1 else ""

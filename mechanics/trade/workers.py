"""Errors on many states by workers: each takes a share of the states of a family.

What travels is the scene as JSON with the numbers of the case; a worker derives the equations once,
and compiles the variants that it is asked for. Nothing is timed there: that stays in one process.
"""

import json
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from mechanics.cluster import Team, spread
from mechanics.routes.derivation import by_route
from mechanics.scene import Scene
from mechanics.scene.json.read import from_json
from mechanics.scene.json.write import to_json
from mechanics.trade.case import Case
from mechanics.trade.choice import Choice
from mechanics.trade.family import Solution, solutions, truth_of
from mechanics.trade.train import errors_of

Array = NDArray[np.float64]


def to_text(case: Case) -> str:
    """A case in JSON: what a worker makes it of again."""
    numbers = (dict(group) for group in (case.initial, case.parameters, case.inputs))
    return json.dumps([
        to_json(case.equations.scene), case.equations.route, case.horizon, *numbers,
        case.compiler is not None, case.grid, case.through,
    ])  # fmt: skip


@lru_cache(maxsize=4)
def _case(text: str) -> Case:
    scene, route, horizon, initial, parameters, inputs, compiled, grid, through = json.loads(text)
    made = from_json(scene)
    assert isinstance(made, Scene)
    return Case(
        by_route(route, made), horizon, initial, parameters, inputs,
        "auto" if compiled else None, None if grid is None else tuple(grid), through,
    )  # fmt: skip


@dataclass(frozen=True)
class Workers:
    """A team that has a case.

    Attributes
    ----------
    team : Team
    text : str
        By `to_text`.
    """

    team: Team
    text: str

    def solutions(self, starts: Array, first: Choice, second: Choice) -> list[Solution]:
        """As `mechanics.trade.family.solutions`."""
        shares = np.array_split(starts, self.team.size())
        found = spread(self.team, _solutions, shares, self.text, first, second)
        return [solution for share in found for solution in share]

    def errors(
        self, starts: Array, known: Sequence[Solution], choices: Sequence[Choice], count: int
    ) -> list[Array]:
        """Of each choice on the first `count` states, as `mechanics.trade.train.errors_of`."""
        parts = np.array_split(np.arange(count), min(count, self.team.size()))
        shares = [(choice, starts[part], [known[i] for i in part])
                  for choice in choices for part in parts]  # fmt: skip
        found = list(spread(self.team, _errors, shares, self.text))
        rows = range(0, len(found), len(parts))
        return [np.concatenate(found[i : i + len(parts)]) for i in rows]


def _solutions(starts: Array, text: str, first: Choice, second: Choice) -> list[Solution]:
    return solutions(_case(text), starts, first, second)


def _errors(share: tuple[Choice, Array, Sequence[Solution]], text: str) -> Array:
    choice, starts, known = share
    return errors_of(_case(text), choice, starts, [truth_of(solution) for solution in known])

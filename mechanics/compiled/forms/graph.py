"""Polynomials as they are written down: nodes, what they cost, and the graph they become.

    cost = operations + divisions, a function as many; then numbers that no double holds

A search changes one decision at a time and keeps what costs no more. It always takes the same path,
so the same equations give the same code.
"""

from collections.abc import Callable, Hashable, Iterable, Mapping
from dataclasses import dataclass
from random import Random
from typing import Any

import casadi as ca
from sympy import Expr

from mechanics.compiled.forms.coefficient import Coefficient
from mechanics.compiled.forms.horner import Nest
from mechanics.compiled.translate import Translator

FUNCTION = 20
"""What a sine costs, in operations."""

Decide = Callable[..., float]
"""From what is to be decided to a number in [0, 1)."""


@dataclass(frozen=True)
class Written:
    """Values as nodes of a nest, by name, and what computing all of them costs."""

    nest: Nest
    roots: Mapping[Any, int]
    cost: tuple[int, int]

    def graphs(self, translate: Translator) -> dict[Any, ca.SX]:
        """The graph of every value; a factor that is the name of a value stands for it."""
        nodes, keys = self.nest.nodes, self.nest.table.keys
        exact = translate.exact
        apply = exact.operations
        built: dict[int, Any] = {}

        def value(place: int) -> Any:
            if place not in built:
                built[place] = build(*nodes[place])
            return built[place]

        def build(operation: str, one: int, two: int) -> Any:
            if operation == "leaf":
                return leaf(keys[one])
            if operation == "-" and one == two:
                return apply["negate"](value(one))
            return apply[OPERATIONS[operation]](value(one), value(two))

        def leaf(key: Expr | Coefficient) -> Any:
            if isinstance(key, Coefficient):
                # A factor is chosen as one: x / 3 would be a division that others count.
                return exact.graph(exact.value(key.expr))
            return value(self.roots[key]) if key in self.roots else exact.value(translate(key))

        return {name: exact.graph(value(place)) for name, place in self.roots.items()}


OPERATIONS = {"+": "add", "-": "subtract", "*": "multiply", "/": "divide"}


def written(nest: Nest, roots: Mapping[Any, int]) -> Written:
    """Values with their cost."""
    return Written(nest, roots, cost(nest, roots.values()))


def cost(nest: Nest, roots: Iterable[int]) -> tuple[int, int]:
    """Operations, a division counted twice, a function as many; and how awkward the numbers are."""
    seen: set[int] = set()
    stack, total, awkward = list(roots), 0, 0
    while stack:
        place = stack.pop()
        if place in seen:
            continue
        seen.add(place)
        operation, one, two = nest.nodes[place]
        if operation == "leaf":
            key = nest.table.keys[one]
            if isinstance(key, Coefficient):
                awkward += key.awkward
            elif key.args:
                total += FUNCTION
        else:
            total += 2 if operation == "/" else 1
            stack += (one, two)
    return total, awkward


def search(write: Callable[[Decide], Written], seed: int, patience: int, most: int) -> Written:
    """The cheapest that is found from one start.

    Parameters
    ----------
    write : callable
        Writes the values down as it is decided.
    patience : int
        Trials without success after which the search ends.
    most : int
        Trials after which it ends anyway.
    """
    random = Random(seed)
    decisions: dict[Hashable, float] = {}

    def decide(*key: Hashable) -> float:
        if key not in decisions:
            decisions[key] = random.random()
        return decisions[key]

    best, idle = write(decide), 0
    for _ in range(most):
        if idle == patience or not decisions:
            break
        key = random.choice(tuple(decisions))
        before, decisions[key] = decisions[key], random.random()
        found = write(decide)
        idle = 0 if found.cost < best.cost else idle + 1
        if found.cost <= best.cost:
            best = found
        else:
            decisions[key] = before
    return best

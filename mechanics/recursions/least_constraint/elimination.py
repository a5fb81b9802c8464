"""The order in which unknowns are eliminated: leaves first, the cheapest step at a time.

An unknown may go when nothing is defined by it any more. What steps cost is counted before they are
taken, so where nothing is coupled nothing is multiplied.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from mechanics.errors import ExpressionError
from mechanics.program.builder import Node
from mechanics.recursions.least_constraint.affine import Affine, Unknown, is_one
from mechanics.recursions.least_constraint.gauss import Gauss, few, gather, minimise, put, turn

Rule = Callable[[str, int, int], tuple[int, ...]]
"""From the kind of a step, its cost and its age to what is least for the step to take next."""


def free_first(kind: str, cost: int, age: int) -> tuple[int, ...]:
    """Free unknowns before those that are defined, and what multiplies least."""
    return (kind not in ("swap", "minimise"), cost, age)


def outermost(kind: str, cost: int, age: int) -> tuple[int, ...]:
    """What was defined last: body by body, as the articulated-body algorithm does."""
    return (kind != "swap", age)


@dataclass(frozen=True)
class Solved:
    """``unknown = value / divisor``, in unknowns that are eliminated later."""

    unknown: Unknown
    value: Affine
    divisor: Node | None = None


def eliminated(
    g: Gauss,
    unknowns: Sequence[Unknown],
    nonzero: Callable[[Node], bool],
    rule: Rule,
    multipliers: Sequence[Unknown] = (),
) -> list[Solved]:
    """Eliminate every unknown, those that others are defined by after these.

    Parameters
    ----------
    g : Gauss
        Is used up.
    unknowns : sequence
        Free ones, and those that G defines, the latter in order.
    nonzero : callable
        Whether a node is known not to vanish.
    multipliers : sequence
        Those of the unknowns that have no square in G.
    """
    work = _Work(g, unknowns, nonzero, multipliers)
    solved: list[Solved] = []
    while work.left:
        steps = {rule(kind, cost, work.left[y]): (kind, y) for kind, cost, y in work.steps()}
        solved += work.take(*steps[min(steps)])
    return solved


def values(g: Gauss, solved: Sequence[Solved]) -> Callable[[Unknown], Node]:
    """What gives the value of an unknown, once those it depends on are known."""
    formulas = {entry.unknown: entry for entry in solved}
    formulas |= {unknown: Solved(unknown, value) for unknown, value in g.after.items()}
    found: dict[Unknown, Node] = {}
    entered: set[Unknown] = set()

    def value(wanted: Unknown) -> Node:
        # An explicit stack: a chain is deeper than Python's recursion goes.
        stack = [wanted]
        while stack:
            entry = formulas[stack[-1]]
            missing = [z for z in entry.value.coefficients if z not in found]
            if missing:
                if stack[-1] in entered:
                    raise ExpressionError(
                        f"acceleration {stack[-1]} is found from itself: choose another form"
                    )
                entered.add(stack[-1])
                stack += missing
            else:
                found[stack.pop()] = _evaluated(entry, found)
        return found[wanted]

    return value


def _evaluated(entry: Solved, found: dict[Unknown, Node]) -> Node:
    total = entry.value.constant
    for unknown, coefficient in entry.value.coefficients.items():
        total = total + coefficient * found[unknown]
    return total if entry.divisor is None else total / entry.divisor


class _Work:
    """What is left to eliminate."""

    def __init__(
        self,
        g: Gauss,
        unknowns: Sequence[Unknown],
        nonzero: Callable[[Node], bool],
        multipliers: Sequence[Unknown],
    ) -> None:
        self.g, self.nonzero, self.multipliers = g, nonzero, set(multipliers)
        # The age of an unknown: the last that was defined is the youngest.
        self.left = {unknown: age for age, unknown in enumerate(reversed(unknowns))}
        self.users: dict[Unknown, set[Unknown]] = {unknown: set() for unknown in unknowns}
        for name, value in g.definitions.items():
            for unknown in value.coefficients:
                self.users[unknown].add(name)

    def steps(self) -> Iterator[tuple[str, int, Unknown]]:
        """(kind, cost, unknown) of every step that may be taken."""
        for unknown in self.left:
            if unknown in self.g.definitions:
                if not self.users[unknown]:
                    yield from self._put_or_turn(unknown)
            elif unknown in self.multipliers:
                if self.multipliers.issuperset(self.g.row(unknown)):
                    yield "minimise", self._minimise_cost(unknown), unknown
            elif not self.users[unknown]:
                yield "minimise", self._minimise_cost(unknown), unknown
            elif self._may_swap(unknown):
                yield "swap", 0, unknown

    def take(self, kind: str, unknown: Unknown) -> list[Solved]:
        """Take one step."""
        if kind == "minimise":
            found = [Solved(unknown, minimise(self.g, unknown))]
        elif kind == "put":
            gather(self.g, unknown)
            found = [Solved(unknown, put(self.g, unknown, self._undefined(unknown)))]
        elif kind == "turn":
            by = self.g.turns[unknown]
            turn(self.g, by)
            found = [Solved(y, self._undefined(y)) for y in by.pair]
        else:
            found = [self._swapped(unknown)]
        for entry in found:
            del self.left[entry.unknown]
        return found

    def _undefined(self, unknown: Unknown) -> Affine:
        value = self.g.definitions.pop(unknown)
        for other in value.coefficients:
            self.users[other].discard(unknown)
        return value

    def _may_swap(self, unknown: Unknown) -> bool:
        if len(self.users[unknown]) != 1 or self.g.holds(unknown):
            return False
        (user,) = self.users[unknown]
        return self.nonzero(self.g.definitions[user].coefficients[unknown])

    def _swapped(self, unknown: Unknown) -> Solved:
        """``y = x z + rest`` becomes ``z = (y - rest) / x``, and y is free."""
        (user,) = self.users[unknown]
        value = self._undefined(user)
        x = value.coefficients[unknown]
        rest = {k: -entry for k, entry in value.coefficients.items() if k != unknown}
        solved = Affine({user: self.g.builder.one, **rest}, -value.constant)
        if unknown in self.g.linear:
            put(self.g, unknown, solved.times(1 / x))
        return Solved(unknown, solved, None if is_one(x) else x)

    def _put_or_turn(self, unknown: Unknown) -> Iterator[tuple[str, int, Unknown]]:
        by = self.g.turns.get(unknown)
        if by is not None and all(y in self.g.definitions and self.g.holds(y) for y in by.pair):
            if by.pair[0] == unknown and not self.users[by.pair[1]]:
                yield "turn", 10, unknown
        else:
            yield "put", self._put_cost(unknown), unknown

    def _put_cost(self, unknown: Unknown) -> int:
        value, row = self.g.definitions[unknown], self.g.row(unknown)
        k = sum(not is_one(x) for x in value.coefficients.values())
        own = int(unknown in row)
        n = len(row) - own
        held = len(self.g.holding(unknown))
        moved = 0 if value.constant.is_zero else n + own + held
        return k * n + own * k * (k + 3) // 2 + k * (unknown in self.g.linear) + moved

    def _minimise_cost(self, unknown: Unknown) -> int:
        squares = self.g.holding(unknown)
        others = {*self.g.row(unknown), *(i for s in squares for i in s.form.coefficients)}
        n, force = len(others) - 1, unknown in self.g.linear
        if few(self.g, unknown, squares):
            return (len(squares) - 1) * (3 + n) + n * force
        return sum(len(s.form.coefficients) for s in squares) + n + n * (n + 1) // 2 + n * force

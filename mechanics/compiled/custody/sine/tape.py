"""A value of the text as a list of operations, to be computed again and again in other domains."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from mechanics.compiled.custody.sine.walk import Domain, Function
from mechanics.program.c.parse import Source


class Step(NamedTuple):
    """One operation: the name of a method of `Domain`, the type, and what it takes."""

    how: str
    kind: str
    takes: tuple[Any, ...]


class Tape(Domain):
    """Writes down what is done; a value is its place in the list."""

    def __init__(self) -> None:
        self.steps: list[Step] = []

    def _step(self, how: str, kind: str, *takes: Any) -> int:
        self.steps.append(Step(how, kind, takes))
        return len(self.steps) - 1

    def given(self, name: str) -> int:
        """A value that is known by name when the tape is played."""
        return self._step("given", "", name)

    def number(self, kind: str, value: Fraction) -> int:
        """A literal."""
        return self._step("number", kind, value)

    def negative(self, kind: str, x: int) -> int:
        """-x."""
        return self._step("negative", kind, x)

    def sum(self, kind: str, x: int, y: int) -> int:
        """x + y."""
        return self._step("sum", kind, x, y)

    def product(self, kind: str, x: int, y: int) -> int:
        """x y."""
        return self._step("product", kind, x, y)

    def fused(self, kind: str, x: int, y: int, z: int) -> int:
        """x y + z."""
        return self._step("fused", kind, x, y, z)

    def cast(self, kind: str, old: str, x: int) -> int:
        """x in another type."""
        return self._step("cast", kind, old, x)


class Recorded(NamedTuple):
    """The steps to some values, and their places."""

    steps: tuple[Step, ...]
    places: tuple[int, ...]

    def play(self, domain: Domain, known: Mapping[str, Any]) -> list[Any]:
        """The values in a domain."""
        values: list[Any] = []
        for how, kind, takes in self.steps:
            if how == "given":
                values.append(known[takes[0]])
            elif how == "number":
                values.append(domain.number(kind, takes[0]))
            elif how == "cast":
                values.append(domain.cast(kind, takes[0], values[takes[1]]))
            else:
                values.append(getattr(domain, how)(kind, *(values[i] for i in takes)))
        return [values[place] for place in self.places]


def record(source: Source, name: str, known: Sequence[str], wanted: Sequence[str]) -> Recorded:
    """Write down how local variables of a function follow from others.

    Raises
    ------
    ExpressionError
        If they do not.
    """
    tape = Tape()
    function = Function(source, name, tape, {local: tape.given(local) for local in known})
    places = tuple(function[local] for local in wanted)
    return Recorded(tuple(tape.steps), places)

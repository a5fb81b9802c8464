"""A value of the text as a list of operations, to be computed again and again in other domains."""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from mechanics.compiled.translation_validation.sine.walk import Domain, Function
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

    def do(self, how: str, kind: str, *operands: Any) -> int:
        """One more step; a name that is known when the tape is played is ``"given"``."""
        self.steps.append(Step(how, kind, operands))
        return len(self.steps) - 1


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
                continue
            # A literal and the old type of a cast are no places.
            plain = {"number": 1, "cast": 1}.get(how, 0)
            operands = (*takes[:plain], *(values[i] for i in takes[plain:]))
            values.append(domain.do(how, kind, *operands))
        return [values[place] for place in self.places]


def record(source: Source, name: str, known: Sequence[str], wanted: Sequence[str]) -> Recorded:
    """Write down how local variables of a function follow from others.

    Raises
    ------
    ExpressionError
        If they do not.
    """
    tape = Tape()
    function = Function(source, name, tape, {local: tape.do("given", "", local) for local in known})
    places = tuple(function[local] for local in wanted)
    return Recorded(tuple(tape.steps), places)

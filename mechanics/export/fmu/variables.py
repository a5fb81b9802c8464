"""The variables of a unit, in the order of their value references.

time, q, u, inputs, parameters, step size | q', u', outputs, margins
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import count

from sympy import Symbol

from mechanics.compiled import Model
from mechanics.compiled.quantities import Quantity
from mechanics.export.fmu.functions import STEP_SIZE, Functions

# Units call it so; a scene's own time is t.
TIME = Quantity(Symbol("time"), "s", "time")


@dataclass(frozen=True)
class Variable:
    """One entry of modelDescription.xml.

    Attributes
    ----------
    reference : int
        Its value reference.
    causality, variability, initial : str
        In the words of the standard; `initial` is empty for inputs and time.
    start : float or None
        None for what is computed.
    positive : bool
        Whether it is declared positive.
    derivative : int or None
        Reference of the state whose rate it is.
    """

    reference: int
    name: str
    unit: str
    description: str
    causality: str
    variability: str
    initial: str
    start: float | None = None
    positive: bool = False
    derivative: int | None = None


@dataclass(frozen=True)
class Variables:
    """All variables, by what they are."""

    clock: Variable
    states: tuple[Variable, ...]
    inputs: tuple[Variable, ...]
    parameters: tuple[Variable, ...]
    rates: tuple[Variable, ...]
    outputs: tuple[Variable, ...]
    margins: tuple[Variable, ...]

    @property
    def given(self) -> tuple[Variable, ...]:
        """What functions of the unit take, in order."""
        return (self.clock, *self.states, *self.inputs, *self.parameters)

    @property
    def wanted(self) -> tuple[Variable, ...]:
        """What they give, in order."""
        return (*self.rates, *self.outputs, *self.margins)

    @property
    def every(self) -> tuple[Variable, ...]:
        """All, by their references."""
        return (*self.given, *self.wanted)


def variables(model: Model, known: Functions, start: Mapping[str, float], step: float) -> Variables:
    """The variables of a unit.

    Parameters
    ----------
    known : Functions
        Of the model.
    start : mapping of str to float
        By name, of every coordinate, speed, input and parameter.
    step : float
        Longest internal step of co-simulation, in s.
    """
    numbers, taken = count(), set[str]()
    quantities = model.quantities

    def made(
        entries: Iterable[Quantity],
        causality: str,
        variability: str,
        initial: str,
        values: Mapping[str, float] | None = None,
    ) -> Iterator[Variable]:
        for entry in entries:
            name = _free(entry.name, taken)
            value = None if values is None else values[entry.name]
            yield Variable(
                next(numbers), name, entry.unit, entry.meaning,
                causality, variability, initial, value, entry.positive,
            )  # fmt: skip

    (clock,) = made((TIME,), "independent", "continuous", "")
    states = tuple(made((*quantities.q, *quantities.u), "output", "continuous", "exact", start))
    inputs = tuple(made(known.inputs, "input", "continuous", "", start))
    own = made(known.p, "parameter", "tunable", "exact", start)
    of_the_unit = made((STEP_SIZE,), "parameter", "tunable", "exact", {STEP_SIZE.name: step})
    parameters = (*own, *of_the_unit)
    rates = tuple(_rates(model, states, numbers, taken))
    split = len(known.outputs) - len(model.equations.scene.conditions)
    rest = [
        tuple(made(group, "output", "continuous", "calculated"))
        for group in (known.outputs[:split], known.outputs[split:])
    ]
    return Variables(clock, states, inputs, parameters, rates, *rest)


def _rates(
    model: Model, states: Sequence[Variable], numbers: Iterator[int], taken: set[str]
) -> Iterator[Variable]:
    """der(q), which only the integrator needs, and u', which is an output."""
    n = len(model.quantities.q)
    for state in states[:n]:
        yield Variable(
            next(numbers), _free(f"der({state.name})", taken), f"{state.unit}/s", "",
            "local", "continuous", "calculated", derivative=state.reference,
        )  # fmt: skip
    for state, entry in zip(states[n:], model.quantities.ud, strict=True):
        yield Variable(
            next(numbers), _free(entry.name, taken), entry.unit, "acceleration",
            "output", "continuous", "calculated", derivative=state.reference,
        )  # fmt: skip


def _free(name: str, taken: set[str]) -> str:
    """The name, or the first of ``name 2``, ``name 3`` ... that is free; then it is taken."""
    names = (name if number == 1 else f"{name} {number}" for number in count(1))
    free = next(one for one in names if one not in taken)
    taken.add(free)
    return free

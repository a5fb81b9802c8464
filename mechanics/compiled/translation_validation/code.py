"""A graph as an exact routine: data that is written to a file and read back.

A constant of a node is a rational: the dyadic one that its double is, or the exact one that stands
for a number that no double holds, such as 1/3. What is not rational, such as pi, is an entry of the
input ``constants``, which is the last.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

import casadi as ca
from sympy import Expr, Rational

from mechanics.program import Builder, Node, Program
from mechanics.program.as_written import AsWritten
from mechanics.program.casadi_reader import read_routine
from mechanics.program.routine import Routine, Shapes, Sizes, nodes_of
from mechanics.program.sympy_reader import read

CONSTANTS = "constants"
EVERY = "every"
"""The output of a program that holds all its values."""


@dataclass(frozen=True)
class Code:
    """Straight-line code of one function.

    Attributes
    ----------
    routine : Routine
        Its last input are the constants.
    constants : tuple of Expr
        What the entries of the last input stand for.
    """

    routine: Routine
    constants: tuple[Expr, ...] = ()

    @property
    def name(self) -> str:
        """Of the function."""
        return self.routine.name

    @property
    def inputs(self) -> Sizes:
        """Name and number of entries of each input, without the constants."""
        return self.routine.inputs[:-1]

    @property
    def shapes(self) -> Shapes:
        """Of the outputs."""
        return self.routine.shapes

    @property
    def rationals(self) -> tuple[Fraction, ...]:
        """Constants of its nodes."""
        return tuple(c for _, _, c in self.routine.nodes if c is not None)

    def results(
        self,
        builder: Builder,
        given: Mapping[str, Sequence[Node]],
        rationals: Mapping[Fraction, Node] | None = None,
        constants: Sequence[Node] | None = None,
    ) -> dict[str, list[Node]]:
        """Nodes of every output by name.

        Parameters
        ----------
        builder : Builder
        given : mapping of str to sequence of Node
            Inputs by group.
        rationals : mapping of Fraction to Node, optional
            What stands for constants of its nodes; by default these do.
        constants : sequence of Node, optional
            What stands for the others.
        """
        last, _ = self.routine.inputs[-1]
        inputs = {**given, last: read(builder, self.constants) if constants is None else constants}
        flat = [number for numbers in self.routine.outputs for number in numbers]
        nodes = iter(nodes_of(builder, self.routine, inputs, flat, rationals))
        return {
            name: [next(nodes) for _ in numbers]
            for (name, _), numbers in zip(self.shapes, self.routine.outputs, strict=True)
        }


def code_of(function: ca.Function, constants: Sequence[Expr]) -> Code:
    """Exact code of a dense SX function whose last input are the constants.

    Raises
    ------
    ExpressionError
        If a constant is infinite or no number.
    """
    numbers = [Fraction(int(c.p), int(c.q)) if isinstance(c, Rational) else None for c in constants]
    left = tuple(c for c, number in zip(constants, numbers, strict=True) if number is None)
    return Code(read_routine(function, numbers), left)


def exact(found: Routine) -> Code:
    """A routine with the rationals that its doubles are."""
    return Code(replace(found, inputs=(*found.inputs, (CONSTANTS, 0))))


def as_written(found: Routine) -> Program:
    """What a text was printed from, every operation as it stands; all values, too."""
    builder = AsWritten()
    given = {name: entries(builder, name, size) for name, size in found.inputs}
    every = nodes_of(builder, found, given, range(len(found.nodes)))
    outputs = {
        name: [every[k] for k in numbers]
        for (name, _), numbers in zip(found.shapes, found.outputs, strict=True)
    }
    return builder.program({**outputs, EVERY: every})


def entries(builder: Builder, name: str, size: int) -> list[Node]:
    """The inputs that stand for an array."""
    return [builder.input(f"{name}[{k}]") for k in range(size)]

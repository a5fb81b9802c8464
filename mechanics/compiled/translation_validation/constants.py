"""Constants of a graph that a machine holds rounded, as unknowns of their own.

    981/100, 0x1.39eb851eb851fp+3   ->   one positive unknown        1/2, 0x1p-1   ->   1/2

A text holds the double nearest to an exact constant. Its graph at those doubles is what it should
compute; that is shown for every value of them, so no double has to be recognised. Constants of one
double are one unknown, and a double that is no constant of the graph is the number that it is: a
change of its last digit is seen.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from mechanics.compiled.translation_validation.code import Code
from mechanics.compiled.translation_validation.physics import Physics
from mechanics.program import Builder, Node
from mechanics.program.c.literal import rounded
from mechanics.program.casadi_printer import nearest


@dataclass(frozen=True)
class Rounded:
    """What numbers of a type stand for.

    Attributes
    ----------
    kind : str
        ``"double"`` or ``"float"``.
    unknowns : mapping of Fraction to Node
        By number of the type that a constant is rounded to, of both signs.
    """

    builder: Builder
    kind: str
    unknowns: Mapping[Fraction, Node]

    def node(self, double: Fraction) -> Node:
        """What a double stands for, once it is a number of the type."""
        number = rounded(double, self.kind)
        found = self.unknowns.get(number)
        return self.builder.constant(number) if found is None else found


def rounded_constants(physics: Physics, code: Code, kind: str) -> Rounded:
    """What the numbers of a text stand for, its graph being known.

    Parameters
    ----------
    physics : Physics
        Learns what numbers the unknowns are.
    code : Code
        The graph with exact constants.
    kind : str
        ``"double"`` or ``"float"``.
    """
    pairs = [(exact, Fraction(float(exact))) for exact in code.rationals]
    known = [(exact, rounded(double, kind)) for exact, double in pairs]
    numbers = {abs(number) for exact, number in known if exact != number}
    numbers |= {abs(rounded(Fraction(nearest(c)), kind)) for c in code.constants}
    unknowns: dict[Fraction, Node] = {}
    for number in sorted(numbers - {0}):
        node = physics.constant(number)
        unknowns |= {number: node, -number: -node}
    return Rounded(physics.builder, kind, unknowns)


def at_doubles(code: Code, known: Rounded) -> tuple[Mapping[Fraction, Node], list[Node]]:
    """What stands for the rationals of a graph, and for its other constants."""
    rationals = {exact: known.node(Fraction(float(exact))) for exact in code.rationals}
    return rationals, [known.node(Fraction(nearest(c))) for c in code.constants]

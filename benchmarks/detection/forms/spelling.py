"""What every notation needs: which symbols are rates of which, and products as numerator and
denominator.

theta_ddot -> ("theta", 2)        -3/2 M L^-1 g  ->  sign -, 3 M g over 2 L
"""

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from sympy import Symbol

from benchmarks.detection.tree import Tree, number, power
from mechanics.scene import Scene
from mechanics.scene.symbols import DOTS, name_of, plain_symbol


@dataclass(frozen=True)
class Written:
    """A statement in one form.

    Attributes
    ----------
    thing : str or object
        What `mechanics.check` is given.
    options : dict
        And with which of its options.
    text : str
        For people.
    place : int
        Which of the statements that are read it is.
    """

    thing: object
    options: dict[str, object]
    text: str
    place: int = 0


Labels = dict[Symbol, tuple[str, int]]
"""What a symbol is called, and how often that is differentiated."""


def labels(scene: Scene, names: Mapping[str, str]) -> Labels:
    """Labels of every symbol of a scene; `names` are those that the person calls otherwise."""
    functions = [*scene.coordinates, *(u for u, _ in scene.speeds), *scene.inputs]
    moving = {
        plain_symbol(f, order): (names.get(name_of(f), name_of(f)), order)
        for f in functions
        for order in range(len(DOTS))
    }
    still = {s: (names.get(s.name, s.name), 0) for s in scene.parameters}
    return still | moving


def plain_name(label: tuple[str, int]) -> str:
    """A label as one name: ``theta_ddot``."""
    return label[0] + DOTS[label[1]]


@dataclass(frozen=True)
class Quotient:
    """A product as people write it.

    Attributes
    ----------
    above, below : tuple of Tree
        Factors; numbers in front, 1 left out.
    """

    negative: bool
    above: tuple[Tree, ...]
    below: tuple[Tree, ...]


def quotient(tree: Tree) -> Quotient:
    """Numerator and denominator of a product or any other node."""
    above, below = [], []
    ratio = Fraction(1)
    for factor in tree.parts if tree.kind == "product" else (tree,):
        if factor.kind == "number":
            ratio *= factor.value
        elif factor.kind == "power" and factor.parts[1].value < 0:
            below.append(power(factor.parts[0], -factor.parts[1].value))
        else:
            above.append(factor)
    size = abs(ratio)
    if size.numerator != 1 or not above:
        above.insert(0, number(size.numerator))
    if size.denominator != 1:
        below.insert(0, number(size.denominator))
    return Quotient(ratio < 0, tuple(above), tuple(below))


def is_negative(term: Tree) -> bool:
    """Whether a term is written with a minus in front."""
    first = term.parts[0] if term.kind == "product" else term
    return first.kind == "number" and first.value < 0

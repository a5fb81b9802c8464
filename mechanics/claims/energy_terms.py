"""Letters of energies that are terms of an energy: U in L = T - U(theta).

They are no names of the scene in other letters, as u of a torque, and what stands in brackets
behind them is what they depend on.
"""

from collections.abc import Iterator, Sequence

from mechanics.claims.about import ENERGY_NAMES
from mechanics.claims.lines import Entry, Line
from mechanics.claims.names import Naming
from mechanics.claims.tree import Name, Node, Number, Product, Sum


def energy_terms(lines: Sequence[Entry], naming: Naming) -> frozenset[str]:
    """Names of energies that the scene does not have, where they are terms of an energy."""
    energies = [
        line for line in lines
        if isinstance(line, Line) and len(line.sides) > 1 and _is_energy(line.sides[0], naming)
    ]  # fmt: skip
    terms = (term for line in energies for side in line.sides[1:] for term in _terms(side))
    return frozenset(name.name for term in terms for name in _energies(term, naming))


def _is_energy(node: Node, naming: Naming) -> bool:
    return isinstance(node, Name) and node.name in ENERGY_NAMES and not naming.knows(node.name)


def _terms(side: Node) -> tuple[Node, ...]:
    return side.terms if isinstance(side, Sum) else (side,)


def _factors(term: Node) -> Iterator[Node]:
    if isinstance(term, Product):
        for factor in term.factors:
            yield from _factors(factor)
    elif not isinstance(term, Number):
        yield term


def _energies(term: Node, naming: Naming) -> Iterator[Name]:
    """The energy that a term is, with its sign, and coordinates behind it."""
    first, *rest = (*_factors(term), None)
    moving = naming.vocabulary.functions
    of = (isinstance(one, Name) and one.name in moving and not one.order for one in rest if one)
    if isinstance(first, Name) and _is_energy(first, naming) and all(of):
        yield first

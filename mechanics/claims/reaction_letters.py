"""Letters of the scene's reactions that a text has for something else.

X = -l/2 sin(theta)       a length, where X is a force of the scene
L = T - V                 the kinetic energy, where T is a tension
"""

from collections.abc import Iterator, Sequence

from mechanics.claims.about import ENERGY_NAMES
from mechanics.claims.dimension import dimension
from mechanics.claims.lines import Entry, Line
from mechanics.claims.names import Naming
from mechanics.claims.spelled_rates import key
from mechanics.claims.tree import Name, Product, Sum, constant, names
from mechanics.scene.unit_names import dimension_of_unit

FORCE, COUPLE = dimension_of_unit("N", ""), dimension_of_unit("N*m", "")
LAWS = ("Lagrangian", "Hamiltonian", "energy")


def other_letters(lines: Sequence[Entry], naming: Naming) -> frozenset[str]:
    """Keys of names that are reactions of the scene, and something else in a text.

    Parameters
    ----------
    lines : sequence of Entry
    naming : Naming
    """
    units = {
        key(one.name): COUPLE if one.at is None else FORCE
        for one in naming.vocabulary.scene.reactions
    }
    given = {key(name) for name in naming.given}
    found = set()
    for line in (one for one in lines if isinstance(one, Line) and len(one.sides) > 1):
        left, *others = line.sides
        if not isinstance(left, Name):
            continue
        if key(left.name) in units and not left.order:
            own = [dimension(naming, side) for side in others]
            if any(one not in (None, units[key(left.name)]) and any(one) for one in own):
                found.add(key(left.name))
        if ENERGY_NAMES.get(left.name) in LAWS and naming.lookup(left.name) is None:
            found |= {key(name) for side in others for name in _energies(side)} & units.keys()
    return frozenset(found - given)


def _energies(side: object) -> Iterator[str]:
    """Letters of energies whose sum or difference a side is: T - V."""
    terms = side.terms if isinstance(side, Sum) else ()
    for term in terms:
        signs = [constant(f) for f in term.factors[:-1]] if isinstance(term, Product) else []
        plain = names(term) if isinstance(term, Name) or signs == [-1] else []
        if len(plain) != 1 or plain[0].name not in ENERGY_NAMES:
            return
    yield from (name.name for term in terms for name in names(term))

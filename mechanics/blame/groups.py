"""Terms in groups, as people talk about them: each group's kind is derived from the scene.

M L/2 th'' cos th     coefficient of th''       2 k x         stiffness: k is that of a spring
M L/2 th'^2 sin th    products of speeds        M g sin th    gravity: g is of its field
"""

from collections.abc import Iterable
from dataclasses import dataclass

from sympy import Expr, Symbol, sympify

from mechanics.blame.terms import Monomial, Terms, symbols_in
from mechanics.scene import Gravity, RigidBody, Scene, Spring, TorsionSpring
from mechanics.scene.bodies import inertia_entries
from mechanics.scene.geometry import components
from mechanics.scene.loads import Coulomb, Damper, Load
from mechanics.scene.rates import TIME, rate_table
from mechanics.scene.symbols import plain_symbol

COEFFICIENT = "coefficient of "


@dataclass(frozen=True)
class Meanings:
    """What symbols of a scene mean in a term, the strongest first.

    Attributes
    ----------
    groups : tuple of (str, frozenset of Symbol)
        A term that holds one of the symbols belongs to the group.
    accelerations, speeds : tuple of Symbol
    """

    groups: tuple[tuple[str, frozenset[Symbol]], ...]
    accelerations: tuple[Symbol, ...]
    speeds: frozenset[Symbol]

    def group(self, monomial: Monomial) -> str:
        """The group of a term."""
        powers = dict(monomial)
        moved = [s for s in self.accelerations if s in powers]
        if len(moved) == 1 and powers[moved[0]] == 1:
            return f"{COEFFICIENT}{moved[0].name}"
        held = symbols_in(monomial)
        for name, symbols in self.groups:
            if held & symbols:
                return name
        if held & self.speeds:
            return "products of speeds"
        return "other terms"

    def grouped(self, terms: Terms) -> dict[str, Terms]:
        """Terms by group: accelerations first, in the scene's order, then as they are met.

        The symbol of an acceleration is left out of its coefficient.
        """
        names = [f"{COEFFICIENT}{symbol.name}" for symbol in self.accelerations]
        names += ["products of speeds", *(name for name, _ in self.groups), "other terms"]
        parts: dict[str, Terms] = {name: {} for name in dict.fromkeys(names)}
        for monomial, value in terms.items():
            name = self.group(monomial)
            bare = monomial
            if name.startswith(COEFFICIENT):
                bare = frozenset(pair for pair in monomial if pair[0] not in self.accelerations)
            parts[name][bare] = value
        return {name: part for name, part in parts.items() if part}


def second_rates(scene: Scene) -> tuple[Symbol, ...]:
    """q'' as plain symbols."""
    return tuple(plain_symbol(q, 2) for q in scene.coordinates)


def meanings(scene: Scene) -> Meanings:
    """What the parameters and inputs of a scene mean, from the loads that they stand in."""
    changing = {*scene.q, *scene.qd, *scene.u, *scene.ud, *second_rates(scene), TIME}
    given = frozenset(set(rate_table(scene)) - changing)
    geometry = _geometry(scene)
    by_kind: dict[str, set[Symbol]] = {}
    for load in scene.loads:
        own = _symbols(scene, load) - changing - given
        # A length that also stands in a stiffness says nothing about a term.
        by_kind.setdefault(_kind(scene, load), set()).update(own - geometry or own)
    reactions = frozenset(reaction.symbol for reaction in scene.reactions)
    order = ("stiffness", "damping", "gravity")
    named = [(name, by_kind[name]) for name in by_kind if name not in order]
    plain = [(name, by_kind[name]) for name in order if name in by_kind]
    groups = (("reactions", reactions), ("input", given), *named, *plain)
    return Meanings(
        tuple((name, frozenset(symbols)) for name, symbols in groups),
        tuple(dict.fromkeys((*scene.ud, *second_rates(scene)))),
        frozenset({*scene.u, *scene.qd}),
    )


def _kind(scene: Scene, load: Load) -> str:
    if isinstance(load, Gravity):
        return "gravity"
    if isinstance(load, Spring | TorsionSpring):
        return "stiffness"
    if isinstance(load, Damper):
        return "damping"
    if isinstance(load, Coulomb):
        return "friction"
    held = {s for entry in _entries(scene, load) for s in entry.free_symbols}
    return "damping" if held & {*scene.u, *scene.qd} else f"load {load.name}"


def _entries(scene: Scene, load: Load) -> Iterable[Expr]:
    """The expressions that say how strong a load is."""
    if isinstance(load, Gravity):
        return [scene.plain(entry) for _, column in components(load.field) for entry in column]
    if isinstance(load, Spring | TorsionSpring):
        return [scene.plain(load.stiffness)]
    if isinstance(load, Damper | Coulomb):
        return [scene.plain(load.coefficient)]
    return [scene.plain(entry) for _, column in components(load.vector) for entry in column]


def _symbols(scene: Scene, load: Load) -> set[Symbol]:
    return {symbol for entry in _entries(scene, load) for symbol in entry.free_symbols}


def _geometry(scene: Scene) -> set[Symbol]:
    """Symbols of places, masses and inertias."""
    found: set[Symbol] = set()
    for body in scene.bodies:
        entries = inertia_entries(body) if isinstance(body, RigidBody) else []
        for entry in (body.mass, *entries, *scene.position(body.centre)):
            found |= sympify(entry).free_symbols
    return found

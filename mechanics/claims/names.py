r"""Names of a person and names of the scene.

    \theta_1, theta1, theta_1    ->    q1        given by the person, or the best guess, reported

Two names are the same when they agree without underscores and braces. A name that the scene does
not have is matched where one choice only is left.
"""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from sympy import Expr, Symbol
from sympy.physics.vector import dynamicsymbols

from mechanics.claims.kinds import angular
from mechanics.claims.scaled_names import another_quantity
from mechanics.claims.spelled_rates import bases, key
from mechanics.claims.step_indices import steps_told
from mechanics.claims.tree import Call, Name, Node, Table, parts
from mechanics.errors import InputError
from mechanics.kinematics.symbolic import Kinematics
from mechanics.scene import Scene
from mechanics.scene.momenta import momentum_symbols, rate_symbol
from mechanics.scene.rates import TIME, coordinate_rate_table
from mechanics.scene.symbols import DOTS, by_name, plain_symbol
from mechanics.scene.unit_names import Dimension, dimension_of_unit
from mechanics.scene.units import ratios

LETTERS = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau"
    " upsilon phi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega"
)
GREEK = frozenset(LETTERS.split())


MOMENTUM = re.compile(r"(?:p|pi)_?(?P<of>\d+|[A-Za-z]+_?\d*)")
COORDINATES = ("q", "Theta")
"""What everybody calls the column of all coordinates."""

FIRST = (0, 1)
"""Numbers at which people begin to count."""


@dataclass(frozen=True)
class Match:
    """What a name of the person stands for.

    Attributes
    ----------
    name : str
        The person's.
    meaning : str
        The scene's.
    why : str
        ``"same name"``, ``"as given"``, or how it was guessed.
    """

    name: str
    meaning: str
    why: str

    @property
    def guessed(self) -> bool:
        """Whether it is neither given nor the same name."""
        return self.why not in ("same name", "as given")


@dataclass(frozen=True, eq=False)
class Vocabulary:
    """The names of a scene.

    Attributes
    ----------
    scene : Scene
    """

    scene: Scene

    @cached_property
    def functions(self) -> dict[str, Symbol]:
        """Coordinates, declared speeds and inputs by name, as plain symbols."""
        scene = self.scene
        speeds = tuple(u for u, _ in scene.speeds)
        return {
            plain_symbol(f).name: plain_symbol(f)
            for f in (*scene.coordinates, *speeds, *scene.inputs)
        }

    @cached_property
    def constants(self) -> dict[str, Symbol]:
        """Parameters, what definitions use, and reactions, by name."""
        found: set[Symbol] = set(self.scene.parameters)
        for symbol, value in self.scene.definitions.items():
            found |= {symbol, *value.free_symbols}
        found |= {reaction.symbol for reaction in self.scene.reactions}
        moving = {s for f in self.functions for s in self.rates(f)}
        return {symbol.name: symbol for symbol in sorted(found - moving, key=by_name)}

    @cached_property
    def dimensions(self) -> dict[str, Dimension | None]:
        """Dimensions of parameters as declared, and of coordinates: angles and lengths."""
        found = {s.name: dimension_of_unit(getattr(s, "unit", ""), s.name) for s in
                 self.scene.parameters}  # fmt: skip
        angles = {symbol.name for symbol in angular(self.scene) | ratios(self.scene)}
        for q in self.scene.q:
            found[q.name] = dimension_of_unit("1" if q.name in angles else "m", q.name)
        return found

    @cached_property
    def kinematics(self) -> Kinematics:
        """How the scene moves."""
        return Kinematics(self.scene)

    @cached_property
    def momenta(self) -> dict[str, Symbol]:
        """Generalized momenta by name, which no scene declares: p_phi1 belongs to phi1."""
        return {symbol.name: symbol for symbol in momentum_symbols(self.scene)}

    @cached_property
    def rate_table(self) -> dict[Symbol, Expr]:
        """The rate of everything that moves and has one: q and q', declared speeds, momenta."""
        scene = self.scene
        speeds = dict(zip(scene.u, scene.ud, strict=True)) if scene.speeds else {}
        momenta = {symbol: rate_symbol(symbol) for symbol in momentum_symbols(scene)}
        return coordinate_rate_table(scene) | speeds | momenta

    @cached_property
    def without_rate(self) -> frozenset[Symbol]:
        """What moves and has no rate here: accelerations, reactions, rates of momenta."""
        moving = {symbol for name in self.functions for symbol in self.rates(name)}
        moving |= {reaction.symbol for reaction in self.scene.reactions}
        moving |= {rate_symbol(symbol) for symbol in momentum_symbols(self.scene)}
        return frozenset(moving - self.rate_table.keys())

    @cached_property
    def reactions(self) -> frozenset[str]:
        """Names of the reactions."""
        return frozenset(reaction.name for reaction in self.scene.reactions)

    def rates(self, function: str) -> list[Symbol]:
        """A function of time and its derivatives, as plain symbols."""
        return [Symbol(function + dots, real=True) for dots in DOTS]

    @cached_property
    def by_key(self) -> dict[str, tuple[str, int]]:
        """Name of the scene and order of the derivative, for every key that is in use."""
        found: dict[str, tuple[str, int]] = {}
        for name in self.constants:
            found.setdefault(key(name), (name, 0))
        for name in self.functions:
            for order, dots in enumerate(DOTS):
                found.setdefault(key(name + dots), (name, order))
        return found

    def parameter(self, name: str) -> str:
        """The constant that a name of code stands for, ``G`` for g; empty where it is none."""
        if (exact := self.lookup(name)) is not None:
            return exact[0] if exact[0] in self.constants and exact[1] == 0 else ""
        alike = [one for one in self.constants if one.lower() == name.lower()]
        return alike[0] if len(alike) == 1 else ""

    def momentum(self, name: str) -> tuple[str, int] | None:
        """Momentum of a coordinate that a name may stand for, and the order of its derivative.

        It is no name of the scene: a text may call something else p_x.
        """
        known = {key(p + dots): (p, i) for p in self.momenta for i, dots in enumerate(DOTS[:2])}
        return known.get(key(name))

    def target(self, name: str) -> tuple[str, int] | None:
        """What a name stands for that was given or guessed."""
        return self.lookup(name) or self.momentum(name)

    def lookup(self, name: str) -> tuple[str, int] | None:
        """Scene's name and order that a person's name stands for, if it is the same name."""
        return self.by_key.get(key(name)) or self._rate(name)

    def _rate(self, name: str) -> tuple[str, int] | None:
        """``thetadd``, ``dtheta``, ``theta_dd``, ``D2x``: other ways to write a rate."""
        for base, order in bases(name):
            found = self.by_key.get(base)
            if found and found[0] in self.functions and found[1] == 0:
                return found[0], order
        return None


@dataclass(frozen=True, eq=False)
class Naming:
    """What every name of a person stands for.

    Attributes
    ----------
    vocabulary : Vocabulary
    given : mapping of str to str
        By the person: name to name of the scene, which may carry ``_dot``.
    guessed : tuple of Match
    applied : frozenset of str
        What the person defines as functions: f in ``f(x) = ...``.
    own : mapping of str to Node
        What the person defines, by name.
    unread : mapping of str to str
        Keys of names of which the text says what is not read, and where: they are not guessed.
    others : frozenset of str
        Keys of names of the scene that the text has for something else.
    """

    vocabulary: Vocabulary
    given: Mapping[str, str] = field(default_factory=dict)
    guessed: tuple[Match, ...] = ()
    applied: frozenset[str] = frozenset()
    own: Mapping[str, Node] = field(default_factory=dict)
    unread: Mapping[str, str] = field(default_factory=dict)
    others: frozenset[str] = frozenset()

    def __post_init__(self) -> None:
        for name, target in self.given.items():
            if target != "t" and self.vocabulary.target(target) is None:
                scene = self.vocabulary.scene
                known = ", ".join([*self.vocabulary.functions, *self.vocabulary.constants])
                raise InputError(
                    f"name {name}={target}: {scene.name} has no {target!r}: its names are {known}"
                )

    @cached_property
    def _given(self) -> dict[str, str]:
        # As a person may copy it from LaTeX: p_{\phi_1}.
        plain = str.maketrans("", "", "{}\\")
        return {key(name.translate(plain)): target for name, target in self.given.items()}

    @cached_property
    def _guessed(self) -> dict[str, str]:
        return {key(match.name): match.meaning for match in self.guessed}

    def lookup(self, name: str) -> tuple[str, int] | None:
        """Scene's name and order of the derivative, or None for a name that nothing explains."""
        for table in (self._given, self._guessed):
            if key(name) in table:
                return self.vocabulary.target(table[key(name)])
        if key(name) in self.others:
            return None
        exact = self.vocabulary.by_key.get(key(name))
        if exact and key(exact[0]) not in (self._given | self._guessed):
            return exact  # phi2_dot is no rate of phi
        # A name that the person gave away is no longer the scene's.
        return self._rate(name) or self.vocabulary.lookup(name)

    def _rate(self, name: str) -> tuple[str, int] | None:
        """A rate of a name that was given or guessed: th1dd, where th1 is phi1."""
        for base, order in bases(name):
            for table in (self._given, self._guessed):
                found = self.vocabulary.lookup(table[base]) if base in table else None
                if found and found[0] in self.vocabulary.functions and found[1] + order < len(DOTS):
                    return found[0], found[1] + order
        return None

    def knows(self, name: str) -> bool:
        """Whether a name stands for something."""
        return self.lookup(name) is not None

    def target(self, name: str) -> tuple[str, int] | None:
        """What a name stands for, or the momentum that it may be."""
        return self.lookup(name) or self.vocabulary.momentum(name)

    def unread_at(self, name: str) -> str:
        """Where something is said of a name, or of what it is a rate of, that is not read."""
        every = (key(name), *(base for base, _ in bases(name)))
        places = (self.unread[one] for one in every if one in self.unread)
        return next(places, "") if self.lookup(name) is None else ""

    def momentum(self, name: str) -> tuple[str, int] | None:
        """The momentum that a name may be: p_theta1, p_1, or that of a name that was matched."""
        found = self.vocabulary.momentum(name)
        part = MOMENTUM.fullmatch(name)
        if found is not None or part is None:
            return found
        momenta = [*self.vocabulary.momenta]
        if part["of"].isdigit():
            place = int(part["of"]) - 1
            return (momenta[place], 0) if 0 <= place < len(momenta) else None
        coordinate = self.lookup(part["of"])
        return None if coordinate is None else self.vocabulary.momentum(f"p_{coordinate[0]}")

    def is_function(self, name: str) -> bool | None:
        """Whether it is a function of time; None where it is unknown."""
        found = self.lookup(name)
        if found is None:
            return None
        return found[0] in self.vocabulary.functions or found[0] in self.vocabulary.momenta

    def symbol(self, name: str, order: int) -> Symbol | None:
        """The plain symbol of a name with so many dots.

        Raises
        ------
        KeyError
            When nothing determines a derivative of that order.
        """
        if name == "t" and order == 0 and not self.knows("t"):
            return TIME
        found = self.lookup(name)
        if found is None:
            return None
        base, more = found
        if base in self.vocabulary.constants:
            if order:
                raise KeyError(f"{name} is {base} of the scene, which has no rate")
            return self.vocabulary.constants[base]
        last = 2 if base in self.vocabulary.momenta else len(DOTS)
        if order + more >= last:
            raise KeyError(f"a derivative of order {order + more} of {base} is not known")
        return Symbol(base + DOTS[order + more], real=True)

    def matches(self, used: Iterable[str]) -> tuple[Match, ...]:
        """What the names stand for, once each, in order."""
        found: dict[str, Match] = {}
        for name in used:
            target = self.lookup(name)
            if name in found or target is None:
                continue
            meaning = target[0] + DOTS[target[1]]
            spelled = key(name) in self._given or key(name) in self._guessed
            why = "same name" if spelled or not self._rate(name) else "a rate of a name like it"
            for match in self.guessed:
                if key(match.name) == key(name):
                    why = match.why
            if key(name) in self._given:
                why = "as given"
            found[name] = Match(name, meaning, why)
        return tuple(found.values())

    @property
    def time(self) -> Expr:
        """Time as the scene writes it."""
        return dynamicsymbols._t


def column(naming: Naming, name: str) -> tuple[str, ...]:
    """What the entries of a column are called; empty for any other name.

    ``theta`` is the column of theta_1, theta_2, ... where the scene has no theta of its own.
    """
    if naming.knows(name):
        return ()
    if entries := _listed(naming, naming.own.get(name)):
        return entries
    for first in FIRST:
        numbered: list[str] = []
        while naming.is_function(entry := f"{name}_{first + len(numbered)}"):
            numbered.append(entry)
        if len(numbered) > 1:
            return tuple(numbered)
    coordinates = tuple(q.name for q in naming.vocabulary.scene.q)
    return coordinates if name in COORDINATES and len(coordinates) > 1 else ()


def _listed(naming: Naming, node: Node | None) -> tuple[str, ...]:
    """Coordinates or inputs that a column of the person's own is made of; empty for others."""
    table = parts(node)[0] if isinstance(node, Call) and node.function == "transpose" else node
    if not isinstance(table, Table) or 1 not in (len(table.rows), len(table.rows[0])):
        return ()
    cells = [cell for row in table.rows for cell in row]
    found = [c.name for c in cells if isinstance(c, Name) and not c.order]
    every = len(found) == len(cells) > 1 and all(map(naming.is_function, found))
    return tuple(found) if every else ()


def unexplained(scene: Scene, unknown: Sequence[str]) -> str:
    """Why a statement with names that nothing explains has no verdict."""
    told = [(name, another_quantity(name)) for name in dict.fromkeys(unknown)]
    if said := [f"{name} says '{word}'" for name, word in told if word]:
        return f"{', '.join(said)}, which no name of the scene does: define it by the scene's"
    if steps := steps_told(dict.fromkeys(unknown)):
        return f"{steps}: the scene's names are of one instant: say what they mean"
    missing = ", ".join(dict.fromkeys(unknown))
    vocabulary = Vocabulary(scene)
    known = ", ".join([*vocabulary.functions, *vocabulary.constants])
    return f"{missing}: the scene has no such name: say what it means; the names are {known}"

"""What a scene has that sentences speak of: names, nouns, loads, how angles are counted."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from sympy import Expr, Number, Rational, Symbol

from mechanics.claims.directions import Counted, counted
from mechanics.claims.kinds import angular
from mechanics.claims.names import Match
from mechanics.judge import phrases as p
from mechanics.scene import Gravity, Particle, RigidBody, Scene
from mechanics.scene.loads import Coulomb, Damper, Force, Spring, Torque, TorsionSpring
from mechanics.scene.units import rolled
from mechanics.symbolic import is_zero

RATIOS = (Rational(1), Rational(1, 2))
SMALL = 6
"""Of numbers that come from mechanics."""
WEIGHTS = ("m/s^2", "N/kg", "N", "N*m^2/kg^2", "m^3/s^2", "N*m^2", "J")
"""Units of what weighs."""


@dataclass(frozen=True)
class SceneFacts:
    """What a scene has that sentences speak of.

    Attributes
    ----------
    scene : Scene
    known : sequence of Match
        What names of the person were taken for.
    """

    scene: Scene
    known: Sequence[Match]

    @cached_property
    def parameters(self) -> dict[str, Symbol]:
        """Parameters by their names."""
        return {symbol.name: symbol for symbol in self.scene.parameters}

    @cached_property
    def inputs(self) -> frozenset[str]:
        """Names of inputs."""
        return frozenset(symbol.name for symbol in self.scene.input_symbols)

    @cached_property
    def coordinates(self) -> dict[str, Symbol]:
        """Coordinates by their names."""
        return {symbol.name: symbol for symbol in self.scene.q}

    @cached_property
    def symbols(self) -> frozenset[Symbol]:
        """Coordinates, inputs and parameters."""
        return frozenset((*self.scene.q, *self.scene.input_symbols, *self.scene.parameters))

    def own_name(self, name: str) -> str:
        """The scene's name for one of the person's."""
        meanings = {match.name: match.meaning for match in self.known}
        spelled = (name, name.replace("_", ""))
        own = (meanings.get(n, n) for n in spelled if n in meanings or n in self.names)
        return next(own, name)

    def own(self, said: re.Match[str]) -> str:
        """The scene's name of what a sentence is facts."""
        return self.own_name(re.sub("[{}]", "", said["name"]))

    def meaning(self, name: str) -> str:
        """What the scene says that a parameter is."""
        return getattr(self.parameters.get(name), "meaning", "")

    def unit(self, name: str) -> str:
        """Of a parameter, an input or an angle; empty where none is known."""
        if name in self.inputs:
            return self._unit_of_input(name)
        if name in {q.name for q in angular(self.scene)}:
            return "rad"
        return getattr(self.parameters.get(name), "unit", "")

    def _unit_of_input(self, name: str) -> str:
        """That of its loads, where these are the input itself in some direction."""
        loads = [load for load in self.loads if name in self.names_in(load)]
        beside = set[str]().union(*map(self.names_in, loads)) - {name}
        if len({*map(type, loads)}) != 1 or beside - {q.name for q in angular(self.scene)}:
            return ""
        return "N*m" if isinstance(loads[0], Torque) else "N"

    def is_sole(self, name: str) -> bool:
        """Whether no other parameter has the unit of one: nothing can be exchanged with it."""
        return [self.unit(one) for one in self.parameters].count(self.unit(name)) == 1

    @cached_property
    def angles(self) -> tuple[Counted, ...]:
        """How the scene counts its angles."""
        return counted(self.scene)

    @cached_property
    def names(self) -> frozenset[str]:
        """Of parameters, coordinates and inputs."""
        return frozenset((*self.parameters, *self.coordinates, *self.inputs))

    @cached_property
    def has(self) -> dict[str, bool | None]:
        """Whether there is friction, gravity, a spring; None where that is not known."""
        return {name: have(self) for name, have in HAVE.items()}

    @cached_property
    def words(self) -> frozenset[str]:
        """All that names of bodies and meanings of parameters are made of."""
        every = (*(b.name for b in self.scene.bodies), *map(self.meaning, self.parameters))
        return frozenset(word for words in every for word in re.findall("[a-z]+", words.lower()))

    def nouns(self, words: str) -> frozenset[str]:
        """The words that tell things apart; those for one thing are one."""
        plain_words = re.sub(r"'s\b", "", words.lower())
        found = {w for w in re.findall(r"[a-z]+", plain_words) if not p.SMALL.fullmatch(w)}
        return frozenset(map(self.alike, found))

    def alike(self, word: str) -> str:
        """The one word for a thing."""
        word = word.lower().removesuffix("s") if word.lower() not in self.words else word.lower()
        for some in p.ALIKE:
            if word in some and len(some & self.words) < 2:
                return min(some)
        return word

    def bodies(self, word: str) -> list[Particle | RigidBody]:
        """Bodies whose names hold a word."""
        own = self.alike(word)
        return [b for b in self.scene.bodies if own in self.nouns(b.name)]

    def is_called(self, name: str, words: str) -> bool:
        """Whether words call a symbol what it is, as far as they go, and nothing else."""
        said, mine = (self._content(text) for text in (words, self.meaning(name)))
        if name in self.inputs:
            kinds = [p.TURNING if turns else p.PUSHING for turns in self.turns(name)]
            return len(kinds) == 1 and {*said} <= kinds[0] | p.APPLIED and bool(kinds[0] & {*said})
        if name in self.coordinates:
            turned = any(angle.symbol.name == name for angle in self.angles)
            return len(said) == 1 and (said == ["angle"]) is turned and said[0] in p.PLACES
        if "gravit" in self.meaning(name):
            return {*said} <= p.GRAVITY
        return bool(said) and (said == mine[: len(said)] or {*said} == {*mine})

    def _content(self, words: str) -> list[str]:
        plain_words = re.sub(r"'s\b", "", words.lower())
        return [self.alike(w) for w in re.findall("[a-z]+", plain_words) if w not in p.ARTICLES]

    @cached_property
    def loads(self) -> list[Force | Torque]:
        """Loads that are written out."""
        return [load for load in self.scene.loads if isinstance(load, Force | Torque)]

    def names_in(self, load: Force | Torque) -> set[str]:
        """Names of a load's symbols."""
        return {s.name for s in self.scene.vector(load.vector, load.name).free_symbols}

    def turns(self, name: str) -> set[bool]:
        """Whether loads that hold an input are torques."""
        return {isinstance(load, Torque) for load in self.loads if name in self.names_in(load)}

    def moved_by(self, body: Particle | RigidBody) -> set[Symbol]:
        """Coordinates that place or turn a body."""
        place = list(self.scene.position(body.centre))
        turned = list(self.scene.rotation(body.frame)) if isinstance(body, RigidBody) else []
        every = set().union(*(entry.free_symbols for entry in (*place, *turned)))
        return every & {*self.scene.q}

    def moves(self, body: Particle | RigidBody) -> bool:
        """Whether coordinates place or turn a body."""
        return bool(self.moved_by(body))

    def ratio(self, name: str) -> Expr | None:
        """Distances from reactions to mass centres over a length; 1 if one of them is it."""
        scene, length = self.scene, self.parameters.get(name)
        if length is None or self.unit(name) != "m":
            return None
        points = [scene.origin, *(one.at for one in scene.reactions if one.at is not None)]
        ratios: list[Expr] = []
        for body in scene.bodies:
            for point in points:
                span = scene.position(body.centre) - scene.position(point)
                square = span.dot(span)
                ratios += [k for k in RATIOS if is_zero(square - (k * length) ** 2)]
        return (ratios and (Rational(1) if 1 in ratios else ratios[0])) or None

    def way(self, name: str) -> int:
        """1 where an angle or torque counts counterclockwise, a force to the right; -1; or 0."""
        scene = self.scene
        for angle in self.angles:
            if angle.symbol.name == name:
                return angle.sense if angle.fixed and angle.planar else 0
        if name in self.coordinates:
            return self._sideways(self.coordinates[name])
        symbol = next((s for s in scene.input_symbols if s.name == name), Symbol(name, real=True))
        vectors = [(isinstance(x, Torque), scene.vector(x.vector, x.name)) for x in self.loads]
        held = [(turns, vector) for turns, vector in vectors if symbol in vector.free_symbols]
        if len(held) != 1:
            return 0
        turns, vector = held[0]
        across, up, out = (one.diff(symbol) for one in vector)
        value = out if turns else across
        if not value.is_number or any(one != 0 for one in (across, up, out) if one is not value):
            return 0
        return 1 if value.is_positive else -1 if value.is_negative else 0

    def _sideways(self, symbol: Symbol) -> int:
        """1 where a coordinate moves bodies to the right and nowhere else, -1 to the left; or 0."""
        slopes = [self.scene.position(body.centre).diff(symbol) for body in self.scene.bodies]
        moved = [slope for slope in slopes if any(slope)]
        signs = {slope[0] for slope in moved if not (slope[1] or slope[2])}
        if len(signs) != 1 or len(moved) != len([s for s in moved if s[0] in signs]):
            return 0
        (sign,) = signs
        return 1 if sign.is_positive else -1 if sign.is_negative else 0

    @property
    def is_hinged_once(self) -> bool:
        """Whether it has one body and one angle, so that there is one place for a torque."""
        return len(self.scene.bodies) == 1 and len(self.angles) == 1

    def inclination(self, name: str) -> str:
        """Whether a parameter is an angle with the vertical or the horizontal; or empty.

        By how coordinates move bodies where it is zero.
        """
        scene, symbol = self.scene, self.parameters.get(name)
        fields = [scene.vector(x.field, x.name) for x in scene.loads if isinstance(x, Gravity)]
        if symbol is None or len(fields) != 1 or self.unit(name) != "rad":
            return ""
        slopes = [scene.position(b.centre).diff(q) for b in scene.bodies for q in scene.q]
        at_zero = [s.subs(symbol, 0) for s in slopes if s.has(symbol)]
        flat = {is_zero(s.dot(fields[0])) for s in at_zero}
        upright = {is_zero(s.dot(s) * fields[0].dot(fields[0]) - s.dot(fields[0]) ** 2)
                   for s in at_zero}  # fmt: skip
        return "horizontal" if flat == {True} else "vertical" if upright == {True} else ""

    def is_absolute(self, name: str) -> bool | None:
        """Whether a coordinate is counted from what is fixed: a body's place holds no other.

        None for what is no coordinate.
        """
        scene, symbol = self.scene, self.coordinates.get(name)
        if symbol is None:
            return None
        angles = {one.symbol: one.fixed for one in self.angles}
        if symbol in angles:
            return angles[symbol]
        others = {*scene.q} - {symbol}
        places = [list(scene.position(body.centre)) for body in scene.bodies]
        held = [set().union(*(e.free_symbols for e in place)) for place in places]
        return any(symbol in symbols and not symbols & others for symbols in held)


def _dissipates(facts: SceneFacts) -> bool | None:
    """Whether loads of a scene hold speeds; unknown where bodies roll."""
    scene = facts.scene
    speeds = {*scene.u, *scene.qd}
    words = [*map(facts.meaning, facts.parameters), *(r.name for r in scene.reactions)]
    if any(isinstance(x, Damper | Coulomb) for x in scene.loads):
        return True
    if any(re.search(p.FEATURES[0][1], one, re.IGNORECASE) for one in words):
        return True
    if any(scene.vector(x.vector, x.name).free_symbols & speeds for x in facts.loads):
        return True
    return None if rolled(scene) or scene.constraints else False


def _falls(facts: SceneFacts) -> bool | None:
    pulled = any(isinstance(load, Gravity) for load in facts.scene.loads)
    named = any("gravit" in facts.meaning(n) or n == "g" for n in facts.parameters)
    return pulled or named or (_of_places(facts) if _may_fall(facts) else False)


def _may_fall(facts: SceneFacts) -> bool:
    """Whether a load that is written out may be a weight: by a unit, or by a number like 9.81."""
    units = [facts.unit(name) for name in facts.parameters]
    vectors = [facts.scene.vector(x.vector, x.name) for x in facts.loads]
    numbers = {n for vector in vectors for entry in vector for n in entry.atoms(Number)}
    plain = all(n.is_Rational and abs(n.p) <= SMALL and n.q <= SMALL for n in numbers)
    return not (plain and all(units) and not {*units} & {*WEIGHTS})


def _springs(facts: SceneFacts) -> bool | None:
    sprung = any(isinstance(x, Spring | TorsionSpring) for x in facts.scene.loads)
    named = any(re.search("spring|stiff", facts.meaning(n)) for n in facts.parameters)
    return sprung or named or _of_places(facts)


def _of_places(facts: SceneFacts) -> bool | None:
    """Unknown where loads are written out that hold coordinates."""
    vectors = (facts.scene.vector(x.vector, x.name) for x in facts.loads)
    return None if any(v.free_symbols & {*facts.scene.q} for v in vectors) else False


HAVE = {"friction": _dissipates, "gravity": _falls, "springs": _springs}

"""What statements of code are run on: random numbers, arrays, functions."""

from collections.abc import Iterator, Mapping, MutableMapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from random import Random
from typing import Any

from sympy import Expr, Rational

from mechanics.claims.code.around.intermediate_form import Term
from mechanics.claims.kinds import turning
from mechanics.claims.names import Naming
from mechanics.errors import InputError
from mechanics.scene.symbols import DOTS


class NotFollowedError(Exception):
    """What is not followed."""


class Unknown:
    """A value that nothing here says."""


UNKNOWN = Unknown()
MOVING = Unknown()
"""What is made of the state, and not followed."""
OUTSIDE = Unknown()
"""A number from outside of the file, which is drawn, typed or read: any."""


ROUNDED = Unknown()
"""A number of integers, of which nothing says how it is rounded."""


class Literal(Fraction):
    """A number that is written out: it stands for any."""


class SeenEntries(MutableMapping[tuple[Any, ...], Any]):
    """Entries of another array from one place on: both are the same numbers."""

    def __init__(self, of: MutableMapping[tuple[Any, ...], Any], start: int, size: int) -> None:
        self.of, self.start, self.size = of, start, size

    def __getitem__(self, key: tuple[Any, ...]) -> Any:
        return self.of[self._there(key)]

    def __setitem__(self, key: tuple[Any, ...], value: Any) -> None:
        self.of[self._there(key)] = value

    def __delitem__(self, key: tuple[Any, ...]) -> None:
        del self.of[self._there(key)]

    def __iter__(self) -> Iterator[tuple[Any, ...]]:
        return (key for k in range(self.size) if self._there(key := (k,)) in self.of)

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def _there(self, key: tuple[Any, ...]) -> tuple[Any, ...]:
        if len(key) != 1 or not isinstance(key[0], int) or not 0 <= key[0] < self.size:
            raise KeyError(key)
        return (key[0] + self.start,)


@dataclass
class Table:
    """An array or a record, by places; entries that nobody has set are random.

    Attributes
    ----------
    name : str
    entries : dict of tuple to value
    size : int or None
        None where nothing says it.
    added : int
        Entries at its end that it did not have.
    """

    name: str = ""
    entries: MutableMapping[tuple[Any, ...], Any] = field(default_factory=dict)
    size: int | None = None
    added: int = 0


@dataclass(frozen=True)
class Handle:
    """A function without a name, or the judged one under another."""

    takes: tuple[str, ...]
    body: Term | None
    inside: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class FileFunction:
    """A function of the file.

    Attributes
    ----------
    takes, gives : tuple of str
        Names of arguments, and of what it returns where these have names.
    body : Term
    shared : frozenset of str
        Arguments that its caller sees changed.
    local : frozenset of str
        Names of its own, where the language says so.
    """

    takes: tuple[str, ...]
    gives: tuple[str, ...]
    body: Term
    shared: frozenset[str] = frozenset()
    local: frozenset[str] = frozenset()

    @cached_property
    def fills(self) -> frozenset[str]:
        """Roots of what it assigns that is not its own."""
        sets = frozenset(root_of(one.parts[0]) for one in self.body.all() if one.kind == "set")
        return sets - self.local

    def free(self) -> set[str]:
        """Names of what is around it that it uses."""
        return {n for n in self.body.names() if n not in self.takes and n not in self.fills}


@dataclass(frozen=True)
class JudgedFunction:
    """The judged function, as its callers see it.

    Attributes
    ----------
    name : str
    takes : tuple of str
    meanings : mapping of str to tuple of str
        What arguments are, in words of the scene.
    fills : tuple of str
        Arguments that it sets.
    around : mapping of str to str
        What names of the file are that it uses and does not take.
    gives : tuple of str
        Whose rates it gives, in order; empty where it gives something else.
    defaults : mapping of str to Fraction
        Numbers of arguments that a call may leave out.
    unused : frozenset of str
        Arguments that make no difference.
    time : str
        The argument that is the time, where that makes a difference.
    places : frozenset of str
        Arguments of which it takes entries by their places.
    single : bool
        Whether its numbers have single precision.
    """

    name: str
    takes: tuple[str, ...]
    meanings: Mapping[str, tuple[str, ...]]
    fills: tuple[str, ...]
    gives: tuple[str, ...]
    around: Mapping[str, str] = field(default_factory=dict)
    defaults: Mapping[str, Fraction] = field(default_factory=dict)
    unused: frozenset[str] = frozenset()
    time: str = ""
    places: frozenset[str] = frozenset()
    single: bool = False


@dataclass(frozen=True)
class Language:
    """How a language differs from the others.

    Attributes
    ----------
    name : str
    first : int
        The first index of an array.
    brackets : bool
        Whether y(1) may be an entry.
    pointers : bool
        Whether a call may change what it is given.
    integers : bool
        Whether a quotient of two integers is one: 1/6 is 0.
    shows : frozenset of str
        Calls that only show something.
    keeps : frozenset of str or None
        Calls that leave a result as it is; None where nothing says it.
    """

    name: str
    first: int = 0
    brackets: bool = False
    pointers: bool = False
    integers: bool = False
    shows: frozenset[str] = frozenset()
    keeps: frozenset[str] | None = None

    @property
    def copies(self) -> bool:
        """Whether z = y makes another array; else both are the same one."""
        return self.name in ("MATLAB", "C")

    @property
    def fills(self) -> bool:
        """Whether y += x gives the same array other entries."""
        return self.name == "Python"


@dataclass(frozen=True)
class SceneNames:
    """Names of the scene.

    Attributes
    ----------
    q, u : tuple of Symbol
        Coordinates and speeds.
    accelerations, inputs : frozenset of str
        Their words.
    parameters : mapping of str to Symbol
    naming : Naming, optional
        What names of a person are.
    """

    q: tuple[Expr, ...]
    u: tuple[Expr, ...]
    accelerations: frozenset[str] = frozenset()
    inputs: frozenset[str] = frozenset()
    parameters: Mapping[str, Expr] = field(default_factory=dict)
    naming: Naming | None = None

    def meaning(self, name: str) -> str:
        """The word of the scene that a name is, or the last part of it; empty for none."""
        if self.naming is None:
            return ""
        try:
            found = self.naming.lookup(name.rpartition(".")[2])
        except (InputError, KeyError):
            return ""
        return "" if found is None or found[0] == "t" else found[0] + DOTS[found[1]]

    @cached_property
    def symbols(self) -> dict[str, Expr]:
        """Of the state, by their words."""
        return {str(s): s for s in (*self.q, *self.u)}

    @cached_property
    def coordinates(self) -> tuple[str, ...]:
        """Words of the coordinates."""
        return tuple(map(str, self.q))

    @cached_property
    def speeds(self) -> tuple[str, ...]:
        """Words of the speeds."""
        return tuple(map(str, self.u))

    @cached_property
    def angles(self) -> frozenset[str]:
        """Words of coordinates that are the same a whole turn later."""
        scene = self.naming.vocabulary.scene if self.naming is not None else None
        return frozenset(map(str, turning(scene))) if scene is not None else frozenset()

    @property
    def state(self) -> tuple[str, ...]:
        """Words of coordinates and speeds."""
        return (*self.coordinates, *self.speeds)


def names_of(naming: Naming) -> SceneNames:
    """Names of the scene that somebody's names speak of."""
    scene = naming.vocabulary.scene
    inputs = frozenset(map(str, scene.input_symbols))
    rates = frozenset(map(str, scene.ud))
    return SceneNames(
        tuple(scene.q), tuple(scene.u), rates, inputs, {str(s): s for s in scene.parameters}, naming
    )


def number(*seed: object) -> Fraction:
    """A random number between 0 and 1, always the same for the same seed."""
    return Fraction(Random(repr(seed)).randint(1, 10**6), 1_000_003)


def root_of(target: Term) -> str:
    """The name of which something is a part; empty for none."""
    while target.kind in ("entry", "field", "call"):
        if target.kind == "call":
            return target.name
        target = target.parts[0]
    return target.name if target.kind == "name" else ""


def targets_of(term: Term) -> Iterator[Term]:
    """What an assignment sets, one by one."""
    yield from term.parts if term.kind == "list" else (term,)


def rational(value: Fraction) -> Rational:
    """The same number for SymPy."""
    return Rational(value.numerator, value.denominator)

"""What a run of statements needs and meets: functions, names, random numbers."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import Any

from sympy import Expr, Symbol

from mechanics.claims.code.around.intermediate_form import Term
from mechanics.claims.code.around.interpreter_values import (
    UNKNOWN,
    FileFunction,
    Handle,
    JudgedFunction,
    Language,
    SceneNames,
    Table,
    number,
    rational,
    root_of,
    targets_of,
)

Place = tuple[str, tuple[Any, ...]]
"""A name, and which entry of it."""
MOMENT, TIME = "moment", Symbol("moment")
"""Of a call."""
FAR = 1000
"""From here on, indices count steps of time."""


@dataclass
class Memory:
    """What has been met.

    Attributes
    ----------
    initial : dict of Fraction to (str, tuple)
        Where random numbers stand that nobody has set.
    called : list of dict of str to Fraction
        States at which the judged function was asked.
    misused : bool
        Whether a call had other arguments than the function takes.
    scalars : set of Fraction
        What may be the step of an integrator.
    vectors, rows, places : set of str
        Names of arrays, of arrays of such, and of what counts entries.
    sizes : dict of str to int
        Of arrays that are no whole state.
    turned : list of value
        What whole turns are taken from.
    called_in : set of str
        Names in the block.
    depth : int
        Of calls and inner loops around a line; a function has one at once, a loop has none.
    stepping : bool
        Whether a step is followed: the state then is any.
    count : int
        Of steps; other ones have other random numbers.
    advanced : tuple of (str, tuple)
        Where the state is that the last block advances.
    explained : set of str
        Functions that have been looked at.
    taken : frozenset of str
        Functions in which we are, that are handed the judged one.
    before : list of Term
        Lines before a loop that give a name what a function returns.
    made, problems : set of str
        Names that hold what the function returned, and what a solver solves.
    unpacked : list of list of str
        Names of entries of a result, in order.
    silent : set of str or None
        Functions that return nothing of what the judged one returned, once they are asked for.
    steps : dict of int to frozenset of str
        Which terms are steps of an integrator, and names of what these advance.
    """

    initial: dict[Fraction, Place] = field(default_factory=dict)
    called: list[dict[str, Fraction]] = field(default_factory=list)
    misused: bool = False
    scalars: set[Fraction] = field(default_factory=set)
    vectors: set[str] = field(default_factory=set)
    sizes: dict[str, int] = field(default_factory=dict)
    rows: set[str] = field(default_factory=set)
    places: set[str] = field(default_factory=set)
    turned: list[Any] = field(default_factory=list)
    called_in: set[str] = field(default_factory=set)
    depth: int = 0
    stepping: bool = False
    count: int = 0
    advanced: tuple[Place, ...] = ()
    explained: set[str] = field(default_factory=set)
    taken: frozenset[str] = frozenset()
    before: list[Term] = field(default_factory=list)
    made: set[str] = field(default_factory=set)
    problems: set[str] = field(default_factory=set)
    unpacked: list[list[str]] = field(default_factory=list)
    silent: set[str] | None = None
    steps: dict[int, frozenset[str]] = field(default_factory=dict)


@dataclass(frozen=True)
class Run:
    """What stands around judged functions.

    Attributes
    ----------
    judged : mapping of str to JudgedFunction
    own : mapping of str to FileFunction
        Other functions of the file.
    users : collection of str
        Those that call it, or call what does.
    words : SceneNames
    language : Language
    block : Term
        All lines that are looked at together.
    lists : mapping of str to Term
        Lists that names of other functions, and attributes, hold from where they are made on.
    memory : Memory
    """

    judged: Mapping[str, JudgedFunction]
    own: Mapping[str, FileFunction]
    users: Collection[str]
    words: SceneNames
    language: Language
    block: Term = field(default_factory=lambda: Term("block"))
    lists: Mapping[str, Term] = field(default_factory=dict)
    memory: Memory = field(default_factory=Memory)

    @cached_property
    def definitions(self) -> dict[str, tuple[Term, ...]]:
        """Assignments to a name, or to a part of it."""
        found: dict[str, tuple[Term, ...]] = {}
        for line in (t for t in self.block.all() if t.kind == "set"):
            for root in map(root_of, targets_of(line.parts[0])):
                found[root] = (*found.get(root, ()), line)
        return found

    @cached_property
    def pointers(self) -> dict[str, tuple[Term, ...]]:
        """What names of arrays are set to that are the same array: double *p = y, du = u."""
        every = [t for one in (self.block, *(f.body for f in self.own.values())) for t in one.all()]
        names = {t.name for t in every if t.kind == "type" and t.text.endswith(("*", "&"))}
        found: dict[str, tuple[Term, ...]] = {}
        for target, value in (t.parts for t in every if t.kind == "set" and not t.name):
            same = not self.language.copies and value.kind == "name" and value.text == value.name
            if target.kind == "name" and (same or target.name in names):
                found[target.name] = (*found.get(target.name, ()), value)
        return found


def begin(run: Run) -> None:
    """Forget what the last block met."""
    memory = run.memory
    memory.initial, memory.called, memory.misused = {}, [], False
    memory.scalars, memory.vectors, memory.rows, memory.places = set(), set(), set(), set()
    memory.called_in, memory.sizes, memory.depth, memory.turned = set(), {}, 0, []


def functions_in(run: Run, env: Mapping[str, Any]) -> set[str]:
    """Names of what runs the judged functions."""
    handles = {n for n, v in env.items() if isinstance(v, Handle)}
    return {*run.judged, *run.users, *handles}


def orders(run: Run) -> list[tuple[str, ...]]:
    """Usual orders of the entries of a state."""
    q, u = run.words.coordinates, run.words.speeds
    vectors = [m for judged in run.judged.values() for m in judged.meanings.values()
               if {*m} >= {*q, *u}]  # fmt: skip
    if vectors:
        return vectors
    pairs = tuple(w for pair in zip(q, u, strict=False) for w in pair)
    return [*dict.fromkeys(((*q, *u), pairs, (*u, *q)))]


def _called(run: Run) -> list[JudgedFunction]:
    """Judged functions that the block calls; all where it says none."""
    called = run.memory.called_in & run.judged.keys() or run.judged.keys()
    return [run.judged[name] for name in called]


def _taken_words(run: Run) -> set[str]:
    """Entries of the state that functions ask for which the block calls."""
    return {w for one in _called(run)
            for name, words in one.meanings.items() if name not in one.unused
            for w in words}  # fmt: skip


def is_driven(run: Run) -> bool:
    """Whether a judged function that is called takes the time, and uses it."""
    return any(one.time for one in _called(run))


def rate_of(run: Run, word: str) -> Expr:
    """The rate of an entry of the state, as a formula of the state."""
    symbols = run.words.symbols
    coordinates, speeds = run.words.coordinates, run.words.speeds
    if word in coordinates and len(coordinates) == len(speeds):
        return symbols[speeds[coordinates.index(word)]]
    taken = _taken_words(run)
    made: Expr = rational(number("rate", word))
    for other in run.words.state:
        if other in taken:
            made += rational(number("rate", word, other)) * symbols[other]
    if is_driven(run):
        made += rational(number("rate", word, MOMENT)) * TIME
    return made


def all_rates(run: Run, at: Mapping[str, Fraction]) -> dict[str, Fraction | None]:
    """Rates of the entries of a state, at a state."""
    symbols = run.words.symbols
    table = {symbols[w]: rational(v) for w, v in at.items() if w != MOMENT}
    table[TIME] = rational(at.get(MOMENT, Fraction(0)))
    found: dict[str, Fraction | None] = {}
    for word in run.words.state:
        value = rate_of(run, word).xreplace(table)
        found[word] = Fraction(int(value.p), int(value.q)) if value.is_Rational else None
    return found


def meaning_of(run: Run, name: str) -> str:
    """What a name is, by what the judged function calls so, else by the scene."""
    for judged in run.judged.values():
        if words := judged.meanings.get(name):
            return words[0] if len(words) == 1 else ""
    around = (judged.around.get(name, "") for judged in run.judged.values())
    return run.words.meaning(name) or next(filter(None, around), "")


def row_of(run: Run, values: Sequence[Any]) -> Table:
    """A vector of some values."""
    return Table("", {(k + run.language.first,): v for k, v in enumerate(values)}, len(values))


def entries_of(run: Run, value: Any) -> list[Any] | None:
    """Entries of a vector."""
    if isinstance(value, Fraction):
        return [value]
    if not isinstance(value, Table) or value.name == "parameters":
        return None
    size = value.size or len(run.words.state)
    return [entry_of(run, value, (k + run.language.first,)) for k in range(size)]


def entry_of(run: Run, table: Table, key: tuple[Any, ...]) -> Any:
    """An entry of an array; a random number where nobody has set it."""
    if key not in table.entries:
        if not table.name:
            return UNKNOWN
        word = meaning_of(run, key[-1]) if isinstance(key[-1], str) else ""
        if word and word not in run.words.state:
            return number("word", word)
        new = number(run.memory.count, table.name, key)
        new += sum(2 * (k - FAR) for k in key if isinstance(k, int) and k >= FAR)  # times grow
        table.entries[key] = new
        run.memory.initial[new] = (table.name, key)
    return table.entries[key]

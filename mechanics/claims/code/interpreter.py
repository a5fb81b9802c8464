"""Statements of another language, run on random numbers, with a random map for the judged function.

    y = y + h*rate(t, y, p)         every name that nothing gives a value has a random one,
                                    rate is a random affine map of the state

What is not followed is unknown, and what is made of it. An argument that is not what the function
takes at its place is a misuse.
"""

from collections.abc import Collection, Mapping, Sequence, Set
from dataclasses import replace
from fractions import Fraction
from typing import Any

from sympy import Expr

from mechanics.claims.code.integrators import NAMES as STEPS
from mechanics.claims.code.intermediate_form import Term
from mechanics.claims.code.interpreter_values import (
    UNKNOWN,
    FileFunction,
    Handle,
    JudgedFunction,
    Language,
    Literal,
    NotFollowedError,
    SceneNames,
    Table,
    Unknown,
    number,
    rational,
    root_of,
    targets_of,
)

FAR = 1000
"""From here on, indices count steps of time."""
TURNS = 12
"""Of a loop over entries."""
DEPTH = 6
"""Of calls."""
MADE = frozenset(
    ("zeros", "ones", "empty", "linspace", "arange", "full", "eye", "repmat", "fill", "similar")
)
"""Calls that make an array."""


TURNED = frozenset(("pi", "M_PI", "π"))


def _only_turns(term: Term) -> bool:
    """Whether a block only brings an angle back into one turn: th -= 2*pi."""
    sets = [one for one in term.all() if one.kind == "set"]
    return bool(sets) and all(map(_is_a_turn, sets))


def _is_a_turn(line: Term) -> bool:
    target, value = line.parts
    if not line.name and value.kind == "binary" and value.parts[0].text == target.text:
        line, value = Term("set", value.name), value.parts[1]
    factors = sorted(one.name.rpartition(".")[2] for one in value.parts)
    whole = len(factors) == 2 and factors[0] in ("2", "0") and factors[1] in TURNED
    tau = value.kind == "name" and value.name.rpartition(".")[2] == "tau"
    return line.name in ("+", "-") and (tau or (whole and value.name == "*"))


class Interpreter:
    """Runs what stands around a judged function.

    Parameters
    ----------
    judged : mapping of str to JudgedFunction
    own : mapping of str to FileFunction
        Other functions of the file.
    users : collection of str
        Those that call it, or call what does.
    words : SceneNames
    language : Language
    """

    stepping = False
    """Whether a step is followed: the state then is any."""

    def __init__(
        self, judged: Mapping[str, JudgedFunction], own: Mapping[str, FileFunction],
        users: Collection[str], words: SceneNames, language: Language,
    ) -> None:  # fmt: skip
        self.judged, self.own, self.users, self.words = judged, own, users, words
        self.language, self.first, self.brackets = language, language.first, language.brackets
        self.explained: set[str] = set()
        self.before: list[Term] = []
        self._count = 0
        self._start()

    def _start(self) -> None:
        self.initial: dict[Fraction, tuple[str, tuple[Any, ...]]] = {}
        self.called: list[dict[str, Fraction]] = []
        self.misused = False
        self.scalars: set[Fraction] = set()
        self.vectors: set[str] = set()
        self.rows: set[str] = set()
        self.places: set[str] = set()
        self.depth = 0
        self.called_in: set[str] = set()

    def _functions(self, env: Mapping[str, Any]) -> set[str]:
        handles = {n for n, v in env.items() if isinstance(v, Handle)}
        return {*self.judged, *self.users, *handles}

    def _handle(self, term: Term, env: dict[str, Any]) -> Any:
        if term.kind == "handle":
            return Handle(tuple(term.name.split()), term.parts[0], dict(env))
        return self._value(term, env)

    def _orders(self) -> list[tuple[str, ...]]:
        q, u = self.words.coordinates, self.words.speeds
        vectors = [m for judged in self.judged.values() for m in judged.meanings.values()
                   if {*m} >= {*q, *u}]  # fmt: skip
        if vectors:
            return vectors
        pairs = tuple(w for pair in zip(q, u, strict=False) for w in pair)
        return [*dict.fromkeys(((*q, *u), pairs, (*u, *q)))]

    def _taken_words(self) -> set[str]:
        """Entries of the state that functions ask for which the block calls."""
        called = self.called_in & self.judged.keys() or self.judged.keys()
        return {w for one in map(self.judged.__getitem__, called)
                for name, words in one.meanings.items() if name not in one.unused
                for w in words}  # fmt: skip

    def _rate(self, word: str) -> Expr:
        """The rate of an entry of the state, as a formula of the state."""
        symbols = self.words.symbols
        coordinates, speeds = self.words.coordinates, self.words.speeds
        if word in coordinates and len(coordinates) == len(speeds):
            return symbols[speeds[coordinates.index(word)]]
        taken = self._taken_words()
        made: Expr = rational(number("rate", word))
        for other in self.words.state:
            if other in taken:
                made += rational(number("rate", word, other)) * symbols[other]
        return made

    def _all_rates(self, at: Mapping[str, Fraction]) -> dict[str, Fraction | None]:
        symbols = self.words.symbols
        table = {symbols[w]: rational(v) for w, v in at.items()}
        found: dict[str, Fraction | None] = {}
        for word in self.words.state:
            value = self._rate(word).xreplace(table)
            found[word] = Fraction(int(value.p), int(value.q)) if value.is_Rational else None
        return found

    def _judged(self, call: Term, env: dict[str, Any]) -> Any:
        """A call of the judged function."""
        judged = self.judged[call.name]
        takes = judged.takes
        if len(call.parts) > len(takes):
            self.misused = True
            return UNKNOWN
        at: dict[str, Any] = {}
        entries: dict[str, list[tuple[int, Any]]] = {}
        out: list[Term] = []
        for name, part in zip(takes, call.parts, strict=False):
            if part.kind == "absent":
                continue
            if part.kind == "set":  # by its name: accel(x; l=1)
                self.misused = True
                continue
            if name in judged.fills:
                out.append(part)
                continue
            value = self._value(part, env)
            words = judged.meanings.get(name, ())
            if not self._accepted(judged, name, part, value):
                self.misused = True
            if len(words) == 1 and part.kind in ("entry", "call") and isinstance(value, Fraction):
                places = part.parts[1:] if part.kind == "entry" else part.parts
                if words[0] in self.words.state or part.kind == "entry":
                    keys = [self._value(p, env) for p in places]
                    entries.setdefault(root_of(part), []).append(
                        (takes.index(name), (words[0], keys))
                    )
            if len(words) > 1 and {*words} & {*self.words.state}:
                dense = self._dense(value)
                if dense is None:
                    at |= dict.fromkeys(words, UNKNOWN)
                else:
                    at |= dict(zip(words, dense, strict=False))
            elif len(words) == 1 and words[0] in self.words.state:
                at[words[0]] = value
        if self.is_another(call, ()):
            self.misused = True
        if not self.stepping and any(not self._ordered(one) for one in entries.values()):
            self.misused = True
        result: Any = UNKNOWN
        if all(isinstance(v, Fraction) for v in at.values()) and judged.gives:
            self.called.append({w: Fraction(v) for w, v in at.items()})
            needed = {w: at.get(w, number("missing", w)) for w in self.words.state}
            rates = self._all_rates(needed)
            values = [rates[w] if w in at or w not in self.words.coordinates else UNKNOWN
                      for w in judged.gives]  # fmt: skip
            if any(w in self.words.coordinates and self._speed_of(w) not in at
                   for w in judged.gives):  # fmt: skip
                values = [UNKNOWN if w in self.words.coordinates else v
                          for w, v in zip(judged.gives, values, strict=True)]  # fmt: skip
            result = values[0] if len(values) == 1 else Table(
                entries={(k + self.first,): v for k, v in enumerate(values)}, size=len(values)
            )  # fmt: skip
        elif self.stepping:
            self.misused = True
        for k, part in enumerate(out):
            value = result
            if len(out) > 1 and isinstance(result, Table):
                value = result.entries.get((k + self.first,), UNKNOWN)
            self._store(part, value, env)
        return result

    def is_another(self, call: Term, moving: Collection[str]) -> bool:
        """Whether a call of the judged function has something else for a parameter.

        Parameters
        ----------
        moving : collection of str
            Names that change around the call, beside those that the call has for the state.
        """
        still = self.words.parameters.keys() | self.words.inputs
        judged = self.judged[call.name]
        pairs = [*zip(judged.takes, call.parts, strict=False)]
        fixed = [(name, part) for name, part in pairs
                 if {*judged.meanings.get(name, ())} & still]  # fmt: skip
        others = {self._place_of(pair[1]) for pair in pairs if pair not in fixed}
        others = (others | {*moving}) - {""}
        return any(self._place_of(p) in others and self._place_of(p) != n for n, p in fixed)

    def _place_of(self, part: Term) -> str:
        """Where a value stands; the whole array for one of its entries."""
        if part.kind in ("entry", "call"):
            base = part.parts[0] if part.kind == "entry" else part
            return base.name if base.kind in ("name", "call") else base.text
        return part.text or part.name if part.kind in ("name", "field") else ""

    def _speed_of(self, word: str) -> str:
        q, u = self.words.coordinates, self.words.speeds
        return u[q.index(word)] if len(q) == len(u) else word

    def _ordered(self, entries: Sequence[tuple[int, tuple[str, list[Any]]]]) -> bool:
        """Whether entries of one array that are passed stand in one of the usual orders."""
        keys = [[k for k in key if isinstance(k, Fraction)] for _, (_, key) in entries]
        if any(len(key) != 1 for key in keys):
            return True
        places = {
            word: int(key[0]) - self.first
            for (_, (word, _)), key in zip(entries, keys, strict=True)
        }
        if all(word in self.words.state for word in places):
            return any(
                all(0 <= k < len(order) and order[k] == word for word, k in places.items())
                for order in self._orders()
            )
        numbers = [*places.values()]
        return numbers == sorted(numbers)

    def _meaning(self, name: str) -> str:
        """What a name is, by what the judged function calls so, else by the scene."""
        for judged in self.judged.values():
            if words := judged.meanings.get(name):
                return words[0] if len(words) == 1 else ""
        around = (judged.around.get(name, "") for judged in self.judged.values())
        return self.words.meaning(name) or next(filter(None, around), "")

    def _accepted(self, judged: JudgedFunction, name: str, part: Term, value: Any) -> bool:
        """Whether an argument is what the function takes at its place."""
        words = judged.meanings.get(name, ())
        if not words and name in judged.defaults:
            return bool(value == judged.defaults[name])
        own = part.name.rpartition(".")[2] if part.kind in ("name", "field") else ""
        if own != name and own in judged.takes and own:
            return False
        if isinstance(value, Table) and any(isinstance(k[0], str) for k in value.entries):
            pairs = ((self._meaning(str(k[0])), v) for k, v in value.entries.items())
            return all(self._fits(m, v, m) for m, v in pairs if m and m not in self.words.state)
        if not words:
            meaning = self._meaning(own) if own else ""
            same = own == name or meaning in ("", self._meaning(name))
            return same and not isinstance(value, Handle)
        if len(words) == 1 and words[0] in self.words.inputs and part.parts:
            if words[0] not in {self._meaning(one) for one in part.names()}:
                return True  # -K*y, what a controller makes
            if part.kind in ("minus", "binary"):
                return False
        made = part.kind in ("call", "binary", "minus", "other", "list")
        if isinstance(value, Unknown) and made and any(p.names() for p in part.parts):
            return False
        if len(words) > 1:
            if isinstance(value, Unknown):
                return True
            if not isinstance(value, Table):
                return False
            if {*words} & {*self.words.state}:
                named = part.parts if part.kind == "list" and len(part.parts) == len(words) else ()
                return value.name != "parameters" and all(
                    self._meaning(one.name) in ("", word)
                    for word, one in zip(words, named, strict=False)
                    if one.kind in ("name", "field")
                )
            if not value.entries:
                return True
            dense = [value.entries.get((k + self.first,), UNKNOWN) for k in range(len(words))]
            return (value.size or len(words)) == len(words) and all(
                self._fits(w, v, "") for w, v in zip(words, dense, strict=True)
            )
        (word,) = words
        meaning = self._meaning(own) if own else ""
        if meaning and meaning != word:
            return False
        if word in self.words.state:
            made = part.kind in ("minus", "binary") and not self.stepping
            if made and word in map(self._meaning, part.names()):
                return False  # accel(-th, w)
            return isinstance(value, Unknown) or (
                isinstance(value, Fraction)
                and (self.stepping or isinstance(value, Literal)
                     or part.kind in ("entry", "item", "field", "call", "name"))
            )  # fmt: skip
        if word in self.words.inputs and (meaning == word or self._is_made(word, own, value)):
            return True
        begun = isinstance(value, Fraction) and value in self.initial and not meaning
        given = part.kind in ("entry", "item", "name", "field")
        return self._fits(word, value, meaning) or (begun and given)

    def _is_made(self, word: str, name: str, value: Any) -> bool:
        """Whether a name without a meaning has what a controller makes."""
        if not name or self._meaning(name) or not isinstance(value, Fraction):
            return False
        share = value / number("word", word)
        return max(abs(share.numerator), share.denominator) > FAR

    def _fits(self, word: str, value: Any, meaning: str) -> bool:
        if isinstance(value, Literal):
            return self._possible(word, value)
        if isinstance(value, Unknown):
            return True
        return isinstance(value, Fraction) and value == number("word", word)

    def _possible(self, word: str, value: Fraction) -> bool:
        """Whether a number is one that the scene allows a parameter."""
        symbols = self.words.parameters
        if word not in symbols:
            return value >= 0 or word in self.words.inputs
        return not (
            (value <= 0 and symbols[word].is_positive)
            or (value < 0 and symbols[word].is_nonnegative)
        )

    def _vectors(self, block: Term, env: Mapping[str, Any], done: Set[str] = frozenset()) -> None:
        """Names that are arrays: those with entries, and those that are passed for one."""
        inner = {one.name for one in block.all() if one.kind == "call"} - done
        for name in sorted(inner & self.own.keys()):
            self._vectors(self.own[name].body, env, done | inner)
        for one in block.all():
            handle = env.get(one.name) if one.kind == "call" else None
            if isinstance(handle, Handle) and handle.body is not None and one.name in inner:
                self._vectors(handle.body, env, done | inner)
                self.called_in |= handle.body.names()
                for name, part in zip(handle.takes, one.parts, strict=False):
                    if name in self.vectors:
                        self._holds_vector(part)
        for one in block.all():
            if one.kind in ("entry", "field"):
                self.vectors.add(root_of(one))
            if one.kind == "call" and (known := self.judged.get(one.name)) is not None:
                for name, part in zip(known.takes, one.parts, strict=False):
                    if len(known.meanings.get(name, ())) > 1:
                        self._holds_vector(part)
            if one.kind == "call" and one.name in self.own:
                for name, part in zip(self.own[one.name].takes, one.parts, strict=False):
                    if name in self.vectors:
                        self._holds_vector(part)
            if one.kind == "call" and self.brackets and one.name not in self.own:
                self.vectors.add(one.name)
        for one in block.all():
            if one.kind == "set" and (
                one.parts[0].name in self.vectors or one.parts[0].kind == "list"
            ):
                self._holds_vector(one.parts[1])

    def _holds_vector(self, part: Term) -> None:
        """Take what a part names for an array, or for an array of such."""
        if part.kind == "name":
            self.vectors.add(part.name)
        elif part.kind == "entry" and len(part.parts) == 2 and part.parts[1].kind != "whole":
            self.rows.add(root_of(part))

    def _forget(self, block: Term, env: dict[str, Any], value: Any = None) -> None:
        """Take away what a block changes."""
        for one in block.all():
            roots: set[str] = set()
            if one.kind == "set":
                roots = {root_of(t) for t in targets_of(one.parts[0])}
            if one.kind == "call" and one.name == "append" and one.parts:
                roots = {root_of(one.parts[0])}
            if one.kind == "call" and (known := self.judged.get(one.name)) is not None:
                roots = {root_of(p) for n, p in zip(known.takes, one.parts, strict=False)
                         if n in known.fills}  # fmt: skip
            if one.kind == "call" and one.name in self.own:
                other = self.own[one.name]
                if not other.gives:
                    roots = {root_of(p) for n, p in zip(other.takes, one.parts, strict=False)
                             if n in other.shared}  # fmt: skip
                    roots |= other.fills & env.keys()
            for root in roots:
                if isinstance(env.get(root), Table):
                    self.vectors.add(root)
                if value is not None:
                    env[root] = value
                else:
                    env.pop(root, None)

    def _row(self, values: Sequence[Any]) -> Table:
        """A vector of some values."""
        return Table("", {(k + self.first,): v for k, v in enumerate(values)}, len(values))

    def _dense(self, value: Any) -> list[Any] | None:
        """Entries of a vector."""
        if isinstance(value, Fraction):
            return [value]
        if not isinstance(value, Table) or value.name == "parameters":
            return None
        size = value.size or len(self.words.state)
        return [self._entry(value, (k + self.first,)) for k in range(size)]

    def _entry(self, table: Table, key: tuple[Any, ...]) -> Any:
        if key not in table.entries:
            if not table.name:
                return UNKNOWN
            word = self._meaning(key[-1]) if isinstance(key[-1], str) else ""
            if word and word not in self.words.state:
                return number("word", word)
            new = number(self._count, table.name, key)
            new += sum(2 * (k - FAR) for k in key if isinstance(k, int) and k >= FAR)  # times grow
            table.entries[key] = new
            self.initial[new] = (table.name, key)
        return table.entries[key]

    def _read(self, root: str, key: tuple[Any, ...], env: dict[str, Any]) -> Any:
        if root not in env:
            base, _, last = root.rpartition(".")
            if isinstance(inner := env.get(base), Table) and (last,) in inner.entries:
                return self._read(base, (last, *key), env)  # p["g"] of a table
            word = self._meaning(root)
            if not key and (root in self.judged or root in self.own):
                return Handle((), None, {"": root})
            if key or root in self.vectors:
                env[root] = Table(root)
            elif root.rpartition(".")[2] in ("pi", "M_PI"):
                env[root] = Literal(355, 113)
            elif word and word not in self.words.state:
                env[root] = number("word", word)
            else:
                new = Fraction(FAR + 7) if root in self.places else number(self._count, root)
                env[root] = new
                self.initial[new] = (root, ())
        value = env[root]
        if not key:
            return value
        if not isinstance(value, Table):
            return UNKNOWN
        if any(isinstance(place, Unknown) for place in key):
            return UNKNOWN
        keys = self._keys(root, value, key)
        if keys is None:
            return self._entry(value, self._from_end(value, key))
        if key == (None,):
            return value
        return self._row([self._entry(value, one) for one in keys])

    def _keys(self, root: str, table: Table, key: tuple[Any, ...]) -> list[tuple[Any, ...]] | None:
        """Places of a row or a part of an array; None for a single one."""
        key = self._from_end(table, key)
        whole = [k for k, place in enumerate(key) if place is None or isinstance(place, range)]
        inner = (k for k in table.entries if len(k) == len(key) + 1 and k[:-1] == key)
        if not whole and (root in self.rows or any(isinstance(k[-1], int) for k in inner)):
            key, whole = (*key, None), [len(key)]
        if not whole:
            return None
        if len(whole) > 1:
            raise NotFollowedError
        size = table.size if table.size and len(key) == 1 else len(self.words.state)
        axis, places = whole[0], key[whole[0]]
        if places is None:
            places = range(self.first, self.first + size)
        elif places.stop == FAR:
            places = range(places.start, self.first + size)
        return [(*key[:axis], k, *key[axis + 1 :]) for k in places]

    def _from_end(self, table: Table, key: tuple[Any, ...]) -> tuple[Any, ...]:
        """A place that counts from the end: of a list of times, that is the present one."""
        if self.first or not any(isinstance(k, int) and k < 0 for k in key):
            return key
        end = table.size or FAR + 8 + table.added
        return tuple(k + end if isinstance(k, int) and k < 0 else k for k in key)

    def _path(self, term: Term, env: dict[str, Any]) -> tuple[str, tuple[Any, ...]]:
        if term.kind == "name":
            return term.name, ()
        if term.kind == "call":
            return term.name, tuple(self._place(p, env) for p in term.parts)
        if term.kind == "field":
            root, key = self._path(term.parts[0], env)
            return root, (*key, term.name)
        if term.kind in ("entry", "item"):
            root, key = self._path(term.parts[0], env)
            return root, (*key, *(self._place(p, env) for p in term.parts[1:]))
        raise NotFollowedError

    def _place(self, term: Term, env: dict[str, Any]) -> Any:
        if term.kind == "whole":
            return None
        if term.kind == "range":
            ends = [self._place(part, env) for part in term.parts]
            if not isinstance(ends[0], int) or not isinstance(ends[1], int | None):
                return UNKNOWN
            return range(ends[0], FAR if ends[1] is None else ends[1] + 1)
        value = self._value(term, env)
        if isinstance(value, Fraction) and value.denominator == 1:
            return int(value)
        return UNKNOWN

    def _store(self, target: Term, value: Any, env: dict[str, Any]) -> None:
        root, key = self._path(target, env)
        if not key:
            if isinstance(value, Table):
                self._dense(value) if value.name and not value.entries else None
                value = Table("" if value.name != "parameters" else value.name,
                              dict(value.entries), value.size)  # fmt: skip
            env[root] = value
            word = self._meaning(root)
            if word and isinstance(value, Literal) and not self.stepping:
                known = word in self.words.state or not self._possible(word, value)
                env[root] = Literal(value) if known else number("word", word)
            return
        table = env.get(root)
        if not isinstance(table, Table):
            table = env[root] = Table(root)
        if any(isinstance(place, Unknown) for place in key):
            env[root] = UNKNOWN
            return
        keys = self._keys(root, table, key)
        dense = self._dense(value) if isinstance(value, Table) else None
        if keys is None and dense is not None:
            key = self._from_end(table, key)
            keys = [(*key, k + self.first) for k in range(len(dense))]
        if keys is None:
            table.entries[self._from_end(table, key)] = value
            return
        if dense is None or len(dense) != len(keys):
            env[root] = UNKNOWN
            return
        table.entries.update(zip(keys, dense, strict=True))

    def _try(self, line: Term, env: dict[str, Any]) -> bool:
        """Run a line; whether it uses the function as it is."""
        self.misused = False
        try:
            self._run(line, env)
        except (NotFollowedError, RecursionError, ZeroDivisionError):
            self._forget(line, env, UNKNOWN)
        return not self.misused

    def _run(self, term: Term, env: dict[str, Any]) -> Any:
        """Run statements; what they return."""
        if term.kind in ("loop", "case") and _only_turns(term):
            return None
        match term.kind:
            case "block":
                for part in term.parts:
                    result = self._run(part, env)
                    if result is not None and part.kind in ("return", "block", "loop"):
                        return result
                return None
            case "return":
                return self._value(term.parts[0], env) if term.parts else UNKNOWN
            case "set":
                self._assign(term, env)
                return None
            case "loop":
                self._turns(term, env)
                return None
            case "case":
                if self.stepping and any(
                    (t.kind == "call" and t.name in self._functions(env))
                    or t.text.startswith("continue")
                    for t in term.all()
                ):
                    raise NotFollowedError
                self._forget(term, env, UNKNOWN)
                return None
            case "other":
                if term.names() and self.stepping:
                    self._poison(term, env)
                return None
            case _:
                self._value(term, env)
                return None

    def _poison(self, term: Term, env: dict[str, Any]) -> None:
        """Take what a call may change as unknown."""
        for name in term.names() & env.keys():
            if isinstance(env[name], Table):
                env[name] = UNKNOWN
        for part in (p for p in term.parts if p.text.startswith("&")):
            env[root_of(part)] = UNKNOWN

    def _assign(self, term: Term, env: dict[str, Any]) -> None:
        target, value = term.parts
        if target.kind == "list":
            self._several(target.parts, value, env)
            return
        if value.kind == "handle":
            env[root_of(target)] = self._handle(value, env)
            return
        made = self._value(value, env)
        if term.name:
            made = self._operation(term.name, self._value(target, env), made)
        self._store(target, made, env)

    def _several(self, targets: Sequence[Term], value: Term, env: dict[str, Any]) -> None:
        if value.kind == "list" and len(value.parts) == len(targets):  # a, b = b, a
            each = [self._value(part, env) for part in value.parts]
            for one, other in zip(targets, each, strict=True):
                self._store(one, other, env)
            return
        made = self._value(value, env)
        entries = self._dense(made) if isinstance(made, Table) else None
        for k, one in enumerate(targets):
            known = entries is not None and k < len(entries)
            self._store(one, entries[k] if known and entries is not None else UNKNOWN, env)

    def _turns(self, term: Term, env: dict[str, Any]) -> None:
        limits, body = term.parts
        ends = [self._value(one, env) for one in limits.parts]
        if len(ends) != 2 or not all(isinstance(e, Fraction) for e in ends) or not term.name:
            raise NotFollowedError
        first, last = (int(e) for e in ends)
        if last - first > TURNS:
            raise NotFollowedError
        for turn in range(first, last + 1):
            env[term.name] = Fraction(turn)
            self._run(body, env)

    def _value(self, term: Term, env: dict[str, Any]) -> Any:
        value = self._evaluated(term, env)
        if isinstance(value, Fraction) and self._may_be_a_step(term, value):
            self.scalars.add(Fraction(value))
        return value

    def _may_be_a_step(self, term: Term, value: Fraction) -> bool:
        match term.kind:
            case "name" | "field":
                counts = value.denominator == 1 and not isinstance(value, Literal)
                small = not isinstance(value, Literal) or value < 1 or term.name in STEPS
                return small and not counts and not self._meaning(term.name)
            case "number":
                return value < 1
            case "binary":
                return term.name == "-" and not isinstance(value, Literal)
        return False

    def _evaluated(self, term: Term, env: dict[str, Any]) -> Any:
        match term.kind:
            case "number":
                try:
                    return Literal(term.name)
                except ValueError:
                    return UNKNOWN
            case "name":
                return self._read(term.name, (), env)
            case "entry" | "field" | "item":
                try:
                    return self._read(*self._path(term, env), env)
                except NotFollowedError:
                    return UNKNOWN
            case "minus":
                return self._operation("*", Literal(-1), self._value(term.parts[0], env))
            case "binary":
                left, right = (self._value(part, env) for part in term.parts)
                if term.name == "/" and self.language.integers and self._whole(term.parts[0]):
                    return self._whole_quotient(term.parts[1], left, right)
                return self._operation(term.name, left, right)
            case "list":
                return self._list(term, env)
            case "handle":
                return self._handle(term, env)
            case "block":
                return self._run_last(term, env)
            case "call":
                return self._call(term, env)
            case "choice":
                for part in term.parts:
                    self._value(part, env)
        return UNKNOWN

    def _whole(self, term: Term) -> bool:
        """Whether a number is an integer as it is written."""
        return term.kind == "number" and term.name.isdigit()

    def _whole_quotient(self, divisor: Term, left: Any, right: Any) -> Any:
        """1/6 is 0 in C, and 1/n where n is an integer."""
        if self._whole(divisor) and right:
            return Literal(int(left) // int(right))
        if isinstance(right, Literal) and right.denominator == 1:
            return UNKNOWN
        return self._operation("/", left, right)

    def _run_last(self, term: Term, env: dict[str, Any]) -> Any:
        """The value of a block is what it returns, or that of its last line."""
        for part in term.parts[:-1]:
            self._run(part, env)
        last = term.parts[-1] if term.parts else Term("other")
        if last.kind == "return":
            return self._run(last, env)
        if last.kind == "set":
            self._run(last, env)
            return self._value(last.parts[0], env)
        return self._value(last, env)

    def _list(self, term: Term, env: dict[str, Any]) -> Any:
        if any(part.kind == "set" for part in term.parts):
            record = Table()
            for part in term.parts:
                inner = part.parts[0] if part.kind == "set" else part
                value = self._value(part.parts[1] if part.kind == "set" else part, env)
                record.entries[(inner.name,)] = value
            return record
        values: list[Any] = []
        for part in term.parts:
            value = self._value(part, env)
            values += (self._dense(value) or [UNKNOWN]) if isinstance(value, Table) else [value]
        return Table("", {(k + self.first,): v for k, v in enumerate(values)}, len(values))

    def _operation(self, sign: str, left: Any, right: Any) -> Any:
        if isinstance(left, Fraction) and isinstance(right, Fraction):
            literal = isinstance(left, Literal) and isinstance(right, Literal)
            kind = Literal if literal else Fraction
            match sign:
                case "+":
                    return kind(Fraction(left) + Fraction(right))
                case "-":
                    return kind(Fraction(left) - Fraction(right))
                case "*":
                    return kind(Fraction(left) * Fraction(right))
                case "/" if right:
                    return kind(Fraction(left) / Fraction(right))
                case "^" if right in (1, 2, 3):
                    return kind(Fraction(left) ** int(right))
            return UNKNOWN
        a, b = self._dense(left), self._dense(right)
        if a is None or b is None:
            return UNKNOWN
        if isinstance(left, Table) and isinstance(right, Table):
            if len(a) != len(b) or sign not in "+-":
                return UNKNOWN
            pairs = zip(a, b, strict=True)
        elif isinstance(left, Table) and sign in "*/":
            pairs = ((one, right) for one in a)  # type: ignore[assignment]
        elif isinstance(right, Table) and sign == "*":
            pairs = ((left, one) for one in b)  # type: ignore[assignment]
        else:
            return UNKNOWN
        made = [self._operation(sign, one, other) for one, other in pairs]
        return self._row(made)

    def _spread(self, term: Term, env: dict[str, Any]) -> Term:
        """A call with its arguments one by one: rate(t, y, *p)."""
        if not any(part.kind == "star" for part in term.parts):
            return term
        parts: list[Term] = []
        for part in term.parts:
            if part.kind != "star":
                parts.append(part)
                continue
            (inner,) = part.parts
            value = self._value(inner, env)
            if inner.kind == "list":
                parts += inner.parts
            elif isinstance(value, Table) and value.size:
                places = (Term("number", str(k + self.first)) for k in range(value.size))
                parts += (Term("item", "", (inner, place), inner.text) for place in places)
            else:
                break
        return replace(term, parts=tuple(parts))

    def _append(self, term: Term, env: dict[str, Any]) -> Any:
        """A value at the end of a list of times."""
        target, part = term.parts
        value, root = self._value(part, env), root_of(target)
        if target.kind == "name" and not isinstance(env.get(root), Table):
            env[root] = Table(root)
        if isinstance(table := env.get(root), Table) and target.kind == "name":
            table.size, table.added = None, table.added + 1
            place = Term("number", str(FAR + 7 + table.added))
            self._store(Term("entry", "", (target, place)), value, env)
        return UNKNOWN

    def _call(self, term: Term, env: dict[str, Any]) -> Any:
        term = self._spread(term, env)
        known = env.get(term.name)
        if isinstance(known, Handle):
            return self._of_handle(known, term, env)
        if term.name in self.judged:
            return self._judged(term, env)
        array = self.brackets and term.name in self.vectors and term.name not in self.own
        if term.parts and (isinstance(known, Table) or (array and known is None)):
            return self._read(*self._path(term, env), env)
        if term.name in self.own:
            return self._inlined(term, env)
        if term.name == "memcpy" and len(term.parts) == 3:
            self._store(term.parts[0], self._value(term.parts[1], env), env)
            return UNKNOWN
        if term.name == "append" and len(term.parts) == 2 and not self.first:
            return self._append(term, env)
        values = [self._value(part, env) for part in term.parts]
        if term.name == "len" and isinstance(values[0], Table):
            return Fraction(values[0].size or len(self.words.state))
        if self.language.pointers and term.name not in self.language.shows:
            self._poison(term, env)
        if values and all(isinstance(v, Literal) for v in values) and term.name not in MADE:
            return Literal(number("call", term.name, *values))
        if not values and self.stepping:  # micros()
            return 2 + number(self._count, term.name)
        return UNKNOWN

    def _of_handle(self, handle: Handle, term: Term, env: dict[str, Any]) -> Any:
        if handle.body is None:
            return self._named(handle.inside[""], term, env)
        inside = dict(handle.inside)
        inside |= {n: self._value(p, env) for n, p in zip(handle.takes, term.parts, strict=False)}
        return self._value(handle.body, inside)

    def _named(self, name: str, term: Term, env: dict[str, Any]) -> Any:
        other = replace(term, name=name)
        return self._judged(other, env) if name in self.judged else self._inlined(other, env)

    def _inlined(self, term: Term, env: dict[str, Any]) -> Any:
        if self.depth > DEPTH:
            raise NotFollowedError
        one = self.own[term.name]
        inside: dict[str, Any] = {}
        for name, part in zip(one.takes, term.parts, strict=False):
            if part.kind == "absent":
                continue
            value = self._value(part, env)
            if isinstance(value, Table) and self.first and one.gives:
                self._dense(value) if value.name and not value.entries else None
                value = Table("", dict(value.entries), value.size)
            inside[name] = value
        own = {*inside, *one.local}
        shared = {} if one.gives else {n: v for n, v in env.items() if n not in own}
        inside = {**shared, **inside}
        called = {n: root_of(p) for n, p in zip(one.takes, term.parts, strict=False) if root_of(p)}
        for name, other in called.items():  # state.w, where the caller says s.w
            inside |= {f"{name}.{n.removeprefix(f'{other}.')}": v for n, v in env.items()
                       if n.startswith(f"{other}.")}  # fmt: skip
        self.vectors |= {n for n, v in inside.items() if isinstance(v, Table)}
        self.depth += 1
        result = self._run(one.body, inside)
        self.depth -= 1
        for name in one.fills & shared.keys():
            env[name] = inside.get(name, UNKNOWN)
        for name, (base, dot, last) in ((n, n.partition(".")) for n in one.fills):
            if dot and name in inside:
                env[f"{called.get(base, base)}.{last}"] = inside[name]
        for name, part in zip(one.takes, term.parts, strict=False):
            if name in one.shared and not isinstance(inside.get(name), Table):
                self._store(part, inside[name], env)
        self.explained.add(term.name)
        if one.gives:
            given = [self._read(n, (), inside) for n in one.gives]
            return given[0] if len(given) == 1 else Table(
                "", {(k + self.first,): v for k, v in enumerate(given)}, len(given)
            )  # fmt: skip
        return UNKNOWN if result is None else result

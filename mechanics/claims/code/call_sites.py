"""Lines around a judged function that use it: what is known to be innocent, and what is not.

    ode45(@(t, y) rate(t, y, p), ...)           the function itself, handed to a solver
    k = rate(t, y, p)                           a plain call, its result as it is
    y = y + h*rate(t, y, p), in a loop          a step of an integrator that is known

All else is quoted.
"""

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from typing import Any

from mechanics.claims.code.integrator_steps import IntegratorSteps
from mechanics.claims.code.integrators import NAMES as STEPS
from mechanics.claims.code.intermediate_form import Term
from mechanics.claims.code.interpreter import FAR
from mechanics.claims.code.interpreter_values import (
    UNKNOWN,
    FileFunction,
    Handle,
    Literal,
    NotFollowedError,
    Table,
    number,
    root_of,
    targets_of,
)

SOLVERS = re.compile(r"ode|solve|problem|integrat|jacobian", re.IGNORECASE)
"""In the names of what takes a function by its name."""
TIMES = frozenset(("t", "time", "tt", "~", "_"))
MATLAB_OPTIONS = frozenset(
    ("reltol", "abstol", "maxstep", "initialstep", "minstep", "outputfcn", "outputsel", "stats",
     "refine", "events", "normcontrol", "bdf", "maxorder", "jacobian", "jpattern", "vectorized")
)  # fmt: skip
JULIA_OPTIONS = frozenset(
    ("reltol", "abstol", "saveat", "dt", "dtmax", "dtmin", "adaptive", "dense", "save_everystep",
     "save_start", "save_end", "save_on", "save_idxs", "maxiters", "tstops", "progress", "verbose",
     "callback", "u0", "tspan", "syms", "sensealg", "alg_hints", "force_dtmin")
)  # fmt: skip
"""Options of a solver that leave the law as it is; an event's function is looked at itself."""
UNFOLLOWED = frozenset(("setfield", "assignin", "evalin", "eval", "DiscreteProblem"))
STATE_FIRST = frozenset(("lsode", "lsoda", "dassl"))
MADE_AGAIN = frozenset(("remake", "init", "solve"))
STEPPED = frozenset(("step!", "solve!", "plot!", "lines!", "scatter!", "push!", "append!"))
"""Calls with ! that do not change what they are given, or as the solver does."""
TESTS = frozenset(("assert", "assert_", "test"))
"""Calls that compare."""


class CallSites(IntegratorSteps):
    """Tells which lines around a judged function are innocent.

    Attributes
    ----------
    made : set of str
        Names of the file that hold what the function returned.
    """

    def __init__(self, *parts: Any) -> None:
        super().__init__(*parts)
        self.parts = parts
        self.made: set[str] = set()
        self.problems: set[str] = set()
        self.unpacked: list[list[str]] = []

    def lines(self, block: Term, env: dict[str, Any]) -> list[str]:
        """Lines of a block that are not innocent; it is run in `env`.

        Parameters
        ----------
        block : Term
        env : dict of str to value
        """
        return self._lines(block, env, self.made)

    def concerns(self, line: Term, env: Mapping[str, Any]) -> bool:
        """Whether a line uses the judged function, or what it returned."""
        return bool(self._concerned(line, env, self.made))

    def _lines(
        self, block: Term, env: dict[str, Any], made: set[str], moving: frozenset[str] = frozenset()
    ) -> list[str]:
        """`made` are names that hold what the function returned, `moving` those of states."""
        found: list[str] = []
        for one in block.parts if block.kind == "block" else (block,):
            if one.kind in ("block", "case"):
                for part in one.parts if one.kind == "case" else (one,):
                    found += self._lines(part, env, made, moving)
                continue
            own = one.parts[0].name if one.kind == "set" else ""
            if own in self.judged and own not in self.own:
                continue  # the function without a name that is judged
            concerned = bool(self._concerned(one, env, made))
            if one.kind == "loop" and concerned:
                if not self.steps(one.parts[1], env, one.name):
                    self._forget(one, env)
                    self._vectors(one, env)
                    if one.name:
                        env[one.name] = Fraction(FAR + 7)
                    body = one.parts[1]
                    found += self._lines(body, env, made, moving | self._moving(body, env))
                self._forget(one, env, UNKNOWN)
                continue
            wrong = self._resets(one, env) or self._changes(one, moving)
            if concerned:
                wrong = wrong or not self._innocent(one, env, made)
            else:
                self._try(one, env)
            if wrong or self._is_another_number(one, env):
                found.append(one.text)
            if concerned:
                self.before += [one] if self.is_result(one) else []
                made |= self._filled(one)
                if one.kind == "set" and one.parts[0].kind == "list":
                    self.unpacked.append([root_of(t) for t in targets_of(one.parts[0])])
                if one.kind == "set" and self._holds(one, env):
                    made |= {root_of(t) for t in targets_of(one.parts[0])}
        return found

    def is_result(self, line: Term) -> bool:
        """Whether a line gives a name what the function returns: a = accel(theta, w)."""
        return (
            line.kind == "set"
            and not line.name
            and line.parts[0].kind == "name"
            and (line.parts[1].kind == "call" and line.parts[1].name in self.judged)
        )

    def function(self, one: FileFunction, around: Mapping[str, Any]) -> list[str]:
        """Lines of one of the other functions that are not innocent."""
        if self.steps(one.body, dict(around), "", one):
            return []
        self._start()
        self._vectors(one.body, around)
        env = {n: v for n, v in around.items() if n not in one.takes and n not in one.local}
        return self._lines(one.body, env, set(), self._states_around(one))

    def _states_around(self, function: FileFunction) -> frozenset[str]:
        """Names of the file that hold the state, and that a function has no own ones for."""
        declared = {root_of(t.parts[0]) for t in function.body.all()
                    if t.kind == "set" and not t.text.startswith(root_of(t.parts[0]))}  # fmt: skip
        states = {n for judged in self.judged.values() for n, word in judged.around.items()
                  if word in self.words.state}  # fmt: skip
        return frozenset(states - declared - {*function.takes})

    def changed(self, function: FileFunction, free: Collection[str]) -> list[str]:
        """Lines of a function that change a number of the file which the judged one uses.

        Parameters
        ----------
        function : FileFunction
        free : collection of str
            Names that the judged function uses, and that are none of its own.
        """
        found = []
        for one in (t for t in function.body.all() if t.kind == "set"):
            root = root_of(one.parts[0])
            if root not in free or self._meaning(root) not in self.words.parameters:
                continue
            value = one.parts[1]
            if one.name or value.kind != "number" or value.name.startswith("-"):
                found.append(one.text)
        return found

    def _moving(self, body: Term, env: dict[str, Any]) -> frozenset[str]:
        """Names of states that a loop, or what it calls, advances or asks the function about."""
        found: set[str] = set()
        for one in body.all():
            if one.kind == "call" and (judged := self.judged.get(one.name)) is not None:
                state = {n for n, m in judged.meanings.items() if {*m} & {*self.words.state}}
                pairs = zip(judged.takes, one.parts, strict=False)
                found |= {root_of(part) for name, part in pairs if name in state}
            if one.kind == "call" and one.name in self.users:
                pairs = zip(self.own[one.name].takes, one.parts, strict=False)
                found |= {root_of(p) for name, p in pairs if name in self.own[one.name].shared}
            if one.kind == "set" and one.parts[1].name in self.users:
                found |= {root_of(target) for target in targets_of(one.parts[0])}
            if one.kind == "loop" and self.steps(one.parts[1], env, one.name):
                found |= {root for root, _ in self.advanced}
        return frozenset(found - {""})

    def _changes(self, line: Term, moving: frozenset[str]) -> bool:
        """Whether a line makes a state, or a number that the function uses, into another."""
        if line.kind != "set":
            return False
        target, value = line.parts
        root = root_of(target)
        if value.kind == "call" and value.name in self.users:
            return False
        return root in moving and bool(line.name or root in value.names())

    def _resets(self, line: Term, env: dict[str, Any]) -> bool:
        """Whether a line gives a solver another law, another state, or impossible numbers."""
        if line.kind == "set":
            target, value = line.parts
            if value.kind == "call" and self._is_solver(value.name):
                self.problems |= {root_of(t) for t in targets_of(target)}
            fields = [t.name.lower() for t in target.all() if t.kind == "field"]
            if fields and (root_of(target) in self.problems or "mass" in fields):
                return True
            targets = [t.name for t in targets_of(target)]
            if value.kind == "call" and value.name.startswith("ode") and len(targets) > 1:
                return targets[1] in TIMES - {"~", "_"} and targets[0] not in TIMES
        if any(self._kicks(one) for one in line.all() if one.kind == "set"):
            return True
        methods = [(one, n) for one in line.all() if one.kind == "call" and self.language.pointers
                   for n in self.judged if one.name.endswith(f".{n}")]  # fmt: skip
        if any(self.misuses(replace(one, name=name), env) for one, name in methods):
            return True
        return any(
            self._alters(one, env) if one.kind == "call" else self._is_impossible(one, env)
            for part in ([line] if line.kind == "call" else line.parts)
            for one in part.all()
        )

    def _is_another_number(self, line: Term, env: dict[str, Any]) -> bool:
        """Whether a line makes a parameter another one, or another number than it was: g = -g."""
        if line.kind != "set" or (line.parts[1].kind == "call" and line.parts[1].name in self.own):
            return False
        words = {number("word", w): w for w in self.words.parameters.keys() | self.words.inputs}
        for target in targets_of(line.parts[0]):
            word, value = self._word(target), self._value(target, env)
            if not word or isinstance(value, Table | Literal):
                continue
            own = line.name or word in map(self._meaning, line.parts[1].names())
            if words.get(value, word) != word or (own and value not in words):
                return True
        return False

    def _word(self, one: Term) -> str:
        """Which parameter of the scene a name or a field is called."""
        word = self._meaning(one.name) if one.kind in ("name", "field") else ""
        return word if word in self.words.parameters else ""

    def _is_another_word(self, target: Term, value: Term) -> bool:
        word, other = self._word(target), self._word(value)
        return bool(word) and bool(other) and word != other

    def _kicks(self, line: Term) -> bool:
        """Whether it makes a field of an object, which holds the state, into another: a.w *= 2."""
        target, value = line.parts
        around = {judged.around.get(target.name, "") for judged in self.judged.values()}
        state = target.kind == "field" and not around.isdisjoint(self.words.state)
        return state and bool(line.name or target.name in value.names())

    def misuses(self, call: Term, env: dict[str, Any]) -> bool:
        """Whether a call of the judged function has other arguments than it takes.

        Parameters
        ----------
        call : Term
        env : dict of str to value
        """
        saved, self.misused = self.misused, False
        self._judged(call, env)
        found, self.misused = self.misused, saved
        return found

    def _is_solver(self, name: str) -> bool:
        return bool(SOLVERS.search(name)) or name in MADE_AGAIN

    def _alters(self, call: Term, env: dict[str, Any]) -> bool:
        """Whether a call sets options of a solver that are not known, or changes what it solves."""
        if call.name in UNFOLLOWED:
            return True
        if call.name in self.own:
            takes = self.own[call.name].takes
            pairs = zip(takes, call.parts, strict=False)
            if any(self._excludes(name, self._value(part, env)) for name, part in pairs):
                return True
        if call.name in ("odeset", "struct"):
            names = [p.text.strip("'\"") for p in call.parts[::2]]
            if call.name == "struct":
                values = [self._value(part, env) for part in call.parts[1::2]]
                words = [Term("name", name) for name in names]
                return any(map(self._excludes, names, values)) or any(
                    map(self._is_another_word, words, call.parts[1::2])
                )
            known = MATLAB_OPTIONS | {n.lower() for n in env}
            return any(name.lower() not in known for name in names)
        given = call.parts[0].name if call.parts and call.parts[0].kind == "name" else ""
        head = call.text.partition("(")[0].rpartition(".")[2].strip()
        if given in self.problems and head.endswith("!") and head not in STEPPED:
            return True
        if self.language.name != "Julia" or not self._is_solver(call.name):
            return False
        for one in (part for part in call.all() if part is not call and part.kind == "set"):
            name = one.parts[0].name
            if name == "p":
                if not self._is_parameter_list(one.parts[1], env):
                    return True
            elif name not in JULIA_OPTIONS and one in self._options(call):
                return True
        return False

    def _options(self, call: Term) -> list[Term]:
        """What a call gives by name, after a semicolon, too."""
        inner = [p for part in call.parts for p in (part.parts if part.kind in ("block", "other")
                                                    else (part,))]  # fmt: skip
        return [part for part in inner if part.kind == "set"]

    def _is_parameter_list(self, part: Term, env: dict[str, Any]) -> bool:
        for judged in self.judged.values():
            takes = judged.takes
            name = takes[-2] if takes[-1:] == ("t",) and len(takes) > 2 else ""
            if not self._accepted(judged, name, part, self._value(part, env)):
                return False
        return True

    def _is_impossible(self, one: Term, env: dict[str, Any]) -> bool:
        """Whether a field or an option is a number that its parameter cannot have."""
        if one.kind != "set" or one.parts[0].kind != "name":
            return False
        excluded = self._excludes(one.parts[0].name, self._value(one.parts[1], env))
        return excluded or self._is_another_word(*one.parts)

    def _excludes(self, name: str, value: Any) -> bool:
        word = self._meaning(name) if name.isidentifier() else ""
        return bool(word) and isinstance(value, Literal) and not self._possible(word, value)

    def _holds(self, line: Term, env: Mapping[str, Any]) -> bool:
        """Whether the value is what the function returns, no function and no solution."""
        value = line.parts[1]
        if value.kind == "call" and value.name in self._silent:
            return False
        return value.kind in ("call", "entry", "name") and not any(
            one.kind == "call" and self._by_name(one, env) for one in value.all()
        )

    def _filled(self, line: Term) -> set[str]:
        """What calls of the function in a line set."""
        return {
            root_of(part)
            for call in line.all() if call.kind == "call" and call.name in self.judged
            for name, part in zip(self.judged[call.name].takes, call.parts, strict=False)
            if name in self.judged[call.name].fills
        }  # fmt: skip

    def _concerned(self, line: Term, env: Mapping[str, Any], made: set[str]) -> set[str]:
        names = self._functions(env) | made - {""}
        names |= {t.name for t in line.all() if t.kind == "call" and self._by_name(t, env)}
        return line.names() & names

    def _by_name(self, call: Term, env: Mapping[str, Any]) -> list[int]:
        """Places of a call at which it takes the function itself."""
        functions = self._functions(env)
        return [
            k for k, part in enumerate(call.parts)
            if (part.kind == "handle" and part.names() & functions)
            or (part.kind == "name" and part.name in functions)
        ]  # fmt: skip

    def _innocent(self, line: Term, env: dict[str, Any], made: set[str]) -> bool:
        functions = self._functions(env)
        if any(not self._plain_handle(h, env) for h in line.all() if h.kind == "handle"):
            return False
        if self._computes(line, functions, made) or self._unseen(line, functions):
            return False
        for call in line.all():
            if call.kind != "call":
                continue
            handed = self._by_name(call, env)
            if handed and call.name in self.own and not self._taken(call, handed, env):
                return False
            solver = self.language.name != "Python" or self._is_solver(call.name)
            if handed and call.name not in self.own and solver and not self._solved(call, env):
                return False
            if call.name in self.users and not self._called_plainly(call, env):
                return False
        return self._try(line, env)

    def _unseen(self, line: Term, functions: set[str]) -> bool:
        """Whether the function is used where nothing is followed."""
        if line.kind == "other":
            return bool(line.names() & functions)
        return any(self._unseen(part, functions) for part in line.parts)

    def _called_plainly(self, call: Term, env: dict[str, Any]) -> bool:
        """Whether another function, which uses the judged one, is called with what it takes."""
        for name, part in zip(self.own[call.name].takes, call.parts, strict=False):
            if part.kind == "name" and part.name in self.own[call.name].takes:
                if part.name != name:
                    return False
            elif part.kind in ("minus", "binary"):
                value = self._value(part, env)
                if not isinstance(value, Literal) or (value <= 0 and name in STEPS):
                    return False
            elif part.kind == "other" and part.names():
                return False
        return True

    def _solved(self, call: Term, env: dict[str, Any]) -> bool:
        """Whether it hands the function to a solver, and parameters in their order."""
        if not SOLVERS.search(call.name) or not self._in_order(call, env):
            return False
        return all(
            self._accepted(judged, name, part, self._value(part, env))
            for judged in self.judged.values()
            for name, part in _beside(judged.takes, call)
        )

    def _in_order(self, call: Term, env: dict[str, Any]) -> bool:
        """Whether a solver calls what it is handed with time and state in their order."""
        late = call.name in STATE_FIRST
        ordered = self.brackets and (call.name.startswith("ode") or late)
        if not ordered and self.language.name != "Python":
            return True
        texts = [";" in part.text for part in call.parts[1:3] if part.kind == "list"]
        if not late and texts == [True, False]:
            return False  # the state for the span of time
        for part in (call.parts[k] for k in self._by_name(call, env)):
            handle = self._handle(part, env)
            if part.kind == "name" and (judged := self.judged.get(part.name)) is not None:
                moving = {n for n, m in judged.meanings.items() if {*m} & {*self.words.state}}
                if moving and moving.isdisjoint(judged.takes[not late : 2 - late]):
                    return False
            elif isinstance(handle, Handle) and handle.body is not None:
                one = Term("handle", " ".join(handle.takes), (handle.body,))
                if not self._plain_handle(one, {**env, **handle.inside}, late=late):
                    return False
        return True

    def _computes(self, line: Term, functions: set[str], made: set[str]) -> bool:
        """Whether something is made of what the function returned."""
        if line.kind == "handle" or (line.kind == "call" and line.name in TESTS):
            return False
        inner = line.parts
        keeps = self.language.keeps
        if line.kind == "call" and keeps is not None:
            inert = line.name in keeps or line.name in functions or line.name in self.own
            if not inert and self._results(line, functions, made):
                return True
        if line.kind in ("binary", "minus") and self._results(line, functions, made):
            return True
        if self._reorders(line, functions, made):
            return True
        if line.kind == "set":
            target, value = line.parts
            if line.name and (self._results(value, functions, made) or root_of(target) in made):
                return True
            if value.kind == "list" and keeps is None and self._results(value, functions, made):
                return True
            if value.kind == "call" and value.name in self.judged:
                given = {root_of(p) for p in value.parts}
                if {root_of(t) for t in targets_of(target)} & given - {""}:
                    return True
            if self._results(value, functions, made) and self._moved(target, value):
                return True
        return any(self._computes(part, functions, made) for part in inner)

    def _reorders(self, line: Term, functions: set[str], made: set[str]) -> bool:
        """Whether it has entries of a result in another order: [d[1], d[0]], d[[1, 0]], d[::-1]."""
        if line.kind == "other":
            return any(self._results(part, functions, made) for part in line.parts)
        if line.kind == "entry" and line.parts[1].kind == "list":
            numbers = [p.name for p in line.parts[1].parts if p.kind == "number"]
            return numbers != sorted(numbers) and self._results(line.parts[0], functions, made)
        if line.kind != "list":
            return False
        entries = [p for p in line.parts if p.kind == "entry" and p.parts[1].kind == "number"
                   and self._results(p.parts[0], functions, made)]  # fmt: skip
        places = [p.parts[1].name for p in entries]
        if places != sorted(places) and len({p.parts[0].text for p in entries}) == 1:
            return True
        names = [p.name for p in line.parts if p.kind == "name"]
        return any([n for n in one if n in names] != [n for n in names if n in one]
                   for one in self.unpacked)  # fmt: skip

    def _moved(self, target: Term, value: Term) -> bool:
        """Whether an entry becomes another one: y(1) = d(2)."""
        ones, others = (
            [p.name for p in (t.parts[1:] if t.kind == "entry" else t.parts) if p.kind == "number"]
            if t.kind == "entry" or (t.kind == "call" and self.brackets) else []
            for t in (target, value)
        )  # fmt: skip
        return bool(ones and others) and ones != others

    @cached_property
    def _silent(self) -> set[str]:
        """Functions that use the judged one and return nothing of what it returned."""
        found = {n for n in self.users if not self.own[n].shared and not self.own[n].gives}
        while new := {
            n for n in found if self._returns(self.own[n], {*self.judged, *self.users} - found)
        }:
            found -= new
        return found

    def _returns(self, one: FileFunction, functions: set[str]) -> bool:
        """Whether a function returns what some functions returned, and no state advanced by it."""
        other = self.again()
        blocks = [
            (one.body, one),
            *((t.parts[1], None) for t in one.body.all() if t.kind == "loop"),
        ]
        advanced = {root for block, whole in blocks if other.steps(block, {}, "", whole)
                    for root, _ in other.advanced}  # fmt: skip
        if advanced and other.steps(one.body, {}, "", one):
            return False
        made: set[str] = set()
        lines = [t for t in one.body.all() if t.kind == "set"]
        while new := {root_of(t) for line in lines if self._holding(line.parts[1], functions, made)
                      for t in targets_of(line.parts[0])} - made - advanced:  # fmt: skip
            made |= new
        return any(self._holding(t, functions, made) for t in one.body.all() if t.kind == "return")

    def again(self) -> "CallSites":
        """The same, where nothing has been looked at."""
        return CallSites(self.judged, self.own, self.users, self.words, self.language)

    def _results(self, value: Term, functions: set[str], made: set[str]) -> bool:
        return self._holding(value, functions - self._silent, made)

    def _holding(self, value: Term, functions: set[str], made: set[str]) -> bool:
        if value.kind == "handle":
            return False
        own = value.kind == "call" and value.name in functions
        return own or (value.kind in ("name", "call") and value.name in made) or any(
            self._holding(part, functions, made) for part in value.parts
        )  # fmt: skip

    def _taken(self, call: Term, handed: Sequence[int], env: dict[str, Any]) -> bool:
        """Whether a function of the file uses the one that it is handed innocently."""
        one = self.own[call.name]
        given = {
            name: self._handle(part, env)
            for k, (name, part) in enumerate(zip(one.takes, call.parts, strict=False))
            if k in handed
        }
        other = self.again()
        if not other.steps(one.body, dict(given), "", one):
            other = self.again()
            other._vectors(one.body, given)
            if other._lines(one.body, dict(given), set()):
                return False
        self.explained |= {call.name} | other.explained
        return True

    def _plain_handle(self, handle: Term, env: dict[str, Any], *, late: bool | None = None) -> bool:
        """Whether a function without a name is the judged one, or gives the rates made of it.

        Parameters
        ----------
        late : bool, optional
            Whether it is called with the time after the state; by its names where nothing says it.
        """
        takes = tuple(handle.name.split())
        inside = dict(env)
        places: dict[str, str] = {}
        if len(takes) == 1:
            places = {"state": takes[0]}
        elif len(takes) == 2 and self.language.name in ("MATLAB", "Python"):
            after = takes[1] in TIMES if late is None else late
            order = ("state", "time") if after else ("time", "state")
            places = dict(zip(order, takes, strict=True))
        elif len(takes) == 3 and self.language.name != "Python":
            places = dict(zip(("state", "parameters", "time"), takes, strict=True))
        elif len(takes) == 4 and self.language.name != "Python":
            places = dict(zip(("out", "state", "parameters", "time"), takes, strict=True))
        if "state" not in places:
            return self._renamed(handle, takes, env)
        saved = self.misused, self.initial, self.called, self.vectors
        self.misused, self.initial, self.called = False, {}, []
        size = len(self.words.state)
        state = Table(places["state"], size=size)
        for place, name in places.items():
            inside[name] = {"state": state, "time": Literal(number("time")), "out": Table(name),
                            "parameters": Table("parameters")}[place]  # fmt: skip
        try:
            result = self._value(handle.parts[0], inside)
            filled = inside.get(places.get("out", ""))
            fits = not self.misused and (
                self._rates_at(state, result, filled)
                if any(judged.gives for judged in self.judged.values())
                else handle.parts[0].kind == "call" and handle.parts[0].name in self.judged
            )  # fmt: skip
        except NotFollowedError:
            fits = False
        self.misused, self.initial, self.called, self.vectors = saved
        return fits

    def _renamed(self, handle: Term, takes: Sequence[str], env: dict[str, Any]) -> bool:
        """Whether a function without a name calls the judged one, with its own arguments."""
        body = handle.parts[0]
        while body.kind in ("block", "return") and len(body.parts) == 1:
            (body,) = body.parts
        if body.kind != "call" or body.name not in self.judged:
            return False
        return self._try(body, {n: v for n, v in env.items() if n not in takes})

    def _rates_at(self, state: Table, result: Any, filled: Any) -> bool:
        """Whether some values are the rates of a state, or what the function gives at it."""
        values = self._dense(filled if filled is not None else result)
        if values is None:
            return False
        entries = self._dense(state) or []
        for order in self._orders():
            at = dict(zip(order, entries, strict=False))
            rates = self._all_rates(at)
            if [*values] == [rates[w] for w in order]:
                return True
            if any(judged.gives and [*values] == [rates[w] for w in judged.gives]
                   for judged in self.judged.values()):  # fmt: skip
                return True
        return False


def _beside(takes: Sequence[str], call: Term) -> Iterator[tuple[str, Term]]:
    """What a solver is handed for the function, beside time and state."""
    if takes[-1:] == ("t",) and len(takes) > 2:
        still = call.name in ("NonlinearProblem", "SteadyStateProblem")  # these have no span
        yield from zip(takes[-2:-1], call.parts[3 - still : 4 - still], strict=False)
    else:
        yield from zip(takes[2:], call.parts[4:], strict=False)  # ode45(@f, span, start, o, m, l)

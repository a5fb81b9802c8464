"""Names of a block beside a judged function: the state, what it gives, and others of the same.

rate(t, y, k, m, l)         y is the state, k a result, m and l are parameters
double *p = y;              p is another name of y
"""

import re
from collections.abc import Iterator, Set
from dataclasses import dataclass
from functools import cached_property

from mechanics.claims.code.around.intermediate_form import SHARES, Term
from mechanics.claims.code.around.interpreter_values import FileFunction, root_of, targets_of
from mechanics.claims.code.around.run import Run
from mechanics.claims.code.around.solver_starts import is_solver

UNFOLLOWED = frozenset(("eval", "evalin", "assignin", "evalc"))
READS = frozenset(
    ("size", "length", "numel", "ndims", "begin", "end", "cbegin", "cend", "data", "c_str", "empty",
     "norm", "squaredNorm", "transpose", "dot", "sum", "rows", "cols", "capacity", "reserve",
     "print", "toString", "str", "x", "y", "z", "w", "segment", "head", "tail", "eval")
)  # fmt: skip
"""Methods that leave their object as it is."""
MACRO = re.compile(r"[A-Z][A-Z0-9_]+")
VIEWS = re.compile(r"view$|pointer$|unsafe_wrap$|^@views?\b|reinterpret$|^ref$|^begin$|^span$|^Map$"
                   r"|reshape$|vec$|tuples$|intervals$|eachrow$|eachcol$|eachindex$|selectdim$"
                   r"|Ref$|parent$|addressof$")  # fmt: skip
"""Calls whose result shares the entries of what they are given."""
DESTINATION = frozenset(("memcpy", "memmove"))
"""Calls that change only the first of what they are given."""
CHANGING = frozenset(
    ("swap", "fill", "fill_n", "transform", "for_each", "iter_swap", "sort", "reverse", "rotate",
     "memset", "scanf", "sscanf", "fscanf", "fread", "generate", "exchange", "set_u!", "bzero")
)  # fmt: skip
"""Calls that change what they are given."""
INNOCENT = frozenset(
    ("push", "append", "step", "solve", "init", "terminate", "savevalues", "add_tstop", "reinit",
     "savefig", "free", "delete", "realloc", "assert", "isnan", "isfinite", "isinf", "copy",
     "display", "plot", "emplace_back", "push_back", "exit", "static_assert", "snprintf",
     "fprintf", "printf", "puts", "fputs", "sprintf")
)  # fmt: skip
"""Calls that read what they are given."""


ADVANCES = frozenset(("step", "solve", "init", "reinit"))
"""Calls of Julia that advance what they are given, as its solver does."""


@dataclass(frozen=True)
class Around:
    """A block beside the judged function.

    Attributes
    ----------
    run : Run
    body : Term
    again : bool
        Whether others call it, so that it goes on from where its state was left.
    """

    run: Run
    body: Term
    again: bool = False

    @cached_property
    def types(self) -> dict[str, str]:
        """Types of names, as far as the block declares them; of two, the one that shares."""
        types = (one for one in self.body.all() if one.kind == "type")
        return {one.name: one.text for one in sorted(types, key=lambda t: t.text[-1] in "&*")}

    @cached_property
    def state(self) -> frozenset[str]:
        """Names of what the function, what uses it and solvers are asked about, and advance."""
        run, found = self.run, set[str]()
        for judged in run.judged.values():
            found |= {n for n, word in judged.around.items() if word in run.words.state}
        solvers = self._solvers
        for call in self._calls:
            owner, _, method = call.name.rpartition(".")
            if (asked := run.judged.get(method)) is not None:
                found |= {head_of(owner)}
                for name, part in zip(asked.takes, call.parts, strict=False):
                    if {*asked.meanings.get(name, ())} & {*run.words.state}:
                        found.add(base_of(part))
            elif call.name in run.users:
                user = run.own[call.name]
                found |= {base_of(part) for name, part in zip(user.takes, call.parts, strict=False)
                          if name in user.shared}  # fmt: skip
            elif run.language.pointers and self.holds_function(call):
                found |= {base_of(part) for part in call.parts
                          if base_of(part) not in solvers and part.kind == "name"
                          and self._is_array(base_of(part))}  # fmt: skip
        for line in self._sets:
            if line.parts[1].kind == "call" and line.parts[1].name == "init":
                found |= {base_of(t) for t in targets_of(line.parts[0])}
        for one in self.body.all():
            found |= run.memory.steps.get(id(one), frozenset())
        found |= self._carried(found)
        return frozenset(found - {"", *run.judged, *run.users, *run.words.parameters})

    def _carried(self, state: Set[str]) -> set[str]:
        """Names that lines which are no step make of themselves and of what the function gives."""
        lines = [*no_steps(self.run, self.body)]
        made, found = self._made(), {*state}
        while new := {
            base_of(t) for one in lines for t in targets_of(one.parts[0])
            if (one.name or base_of(t) in map(head_of, one.parts[1].names()))
            and (made | found) & {*map(head_of, one.parts[1].names())}
        } - found - {""}:  # fmt: skip
            found |= new
        return found

    def _made(self) -> set[str]:
        """The judged functions, and names that hold what they give."""
        judged = self.run.judged
        return {*judged} | {
            base_of(part) for call in self._calls if (one := judged.get(call.name)) is not None
            for name, part in zip(one.takes, call.parts, strict=False) if name in one.fills
        }  # fmt: skip

    @cached_property
    def moving(self) -> frozenset[str]:
        """Names of what is made of the state or of results."""
        found = self.state | self.aliases | self.results
        while new := {base_of(t) for one in self._sets for t in targets_of(one.parts[0])
                      if found & {*map(head_of, one.parts[1].names())}} - found - {""}:  # fmt: skip
            found |= new
        return found

    @cached_property
    def results(self) -> frozenset[str]:
        """Names of what the function gives."""
        judged = self.run.judged
        return frozenset({
            base_of(t) for one in self._sets
            if any(c.kind == "call" and c.name in judged for c in one.parts[1].all())
            for t in targets_of(one.parts[0])
        } | self._made() - judged.keys())  # fmt: skip

    @cached_property
    def others(self) -> frozenset[str]:
        """Names of results and of parameters that the function is handed."""
        run, found = self.run, set[str]()
        for call in self._calls:
            if call.name.rpartition(".")[2] in run.judged:
                found |= {base_of(part) for part in call.parts}
        for line in self._sets:
            if any(one.kind == "call" and one.name in run.judged for one in line.parts[1].all()):
                found |= {base_of(t) for t in targets_of(line.parts[0])}
            if base_of(line.parts[0]) in self.state:  # what a step is made of
                found |= {*map(head_of, line.parts[1].names())}
        return frozenset((found | self.handed) - {"", *run.judged, *run.users})

    @cached_property
    def handed(self) -> frozenset[str]:
        """Names of C that stand beside the function where it is handed on: {rate, NULL, 2, mu}."""
        if not self.run.language.pointers:
            return frozenset()
        groups = [one.parts for one in self.body.all() if one.kind in ("list", "call")
                  and any(part.kind == "name" and part.name in self.run.judged
                          for part in one.parts)]  # fmt: skip
        groups += [
            one.parts[1:]
            for one in self._sets
            if one.parts[0].kind == "field" and base_of(one.parts[0]) in self._holders
        ]
        found = {base_of(part) for group in groups for part in group}
        return frozenset(found & self.types.keys() - self.state - self._holders)

    @property
    def _holders(self) -> frozenset[str]:
        """Names of records of which a field is the function: sys.function = rate."""
        return self._solvers | {base_of(one.parts[0]) for one in self._sets
                                if one.parts[1].name in self.run.judged}  # fmt: skip

    @cached_property
    def parameters(self) -> frozenset[str]:
        """Names of numbers, and of arrays of such, that the function is handed."""
        pairs = ((name, part, judged) for call in self._calls
                 if (judged := self.run.judged.get(call.name)) is not None
                 for name, part in zip(judged.takes, call.parts, strict=False))  # fmt: skip
        return frozenset(
            base_of(part) for name, part, judged in pairs
            if {*judged.meanings.get(name, ())} & self.run.words.parameters.keys()
        ) - self.state - self.results - {""}  # fmt: skip

    @cached_property
    def aliases(self) -> frozenset[str]:
        """Other names of the same: pointers, references and views."""
        return self.others_of(self.state | self.others)

    def others_of(self, known: Set[str]) -> frozenset[str]:
        """Other names of some: pointers, references and views."""
        found, pairs = set[str](), [*self._shares]
        while new := {n for n, names in pairs if names & (known | found)} - found - known:
            found |= new
        return frozenset(found)

    @cached_property
    def _shares(self) -> tuple[tuple[str, frozenset[str]], ...]:
        """Names, and those whose entries they may share."""
        found = [(one.name, frozenset(one.parts[0].names())) for one in self.body.all()
                 if one.kind == "type" and one.parts]  # fmt: skip
        for line in self._sets:
            target, value = line.parts
            if self._is_shared(target, value):
                found += [(base_of(t), frozenset(map(head_of, value.names())))
                          for t in targets_of(target)]  # fmt: skip
        for loop in (t for t in self.body.all() if t.kind == "loop" and t.parts[0].parts):
            names = frozenset(loop.parts[0].names())
            if not self.run.language.pointers and any(map(VIEWS.search, names)):
                found += [(n, names) for n in re.findall(r"[^\W\d]\w*", loop.name)]
        return tuple(found)

    def _is_shared(self, target: Term, value: Term) -> bool:
        """Whether an assignment makes a name another one of the same entries."""
        language = self.run.language
        points = "&" in value.text or (value.kind == "name" and self._is_array(value.name))
        if target.kind != "name" and not (target.kind == "field" and points):
            return False
        if target.kind == "field":
            return language.pointers
        if language.pointers:
            shape = self.types.get(base_of(target), "")
            declared = "&" in shape or "*" in shape or SHARES.search(shape) is not None
            return declared or value.text.startswith("&") or any(
                one.text.startswith("&") or VIEWS.search(one.name.rpartition(".")[2])
                for one in value.all() if one.kind in ("name", "other", "entry", "field", "call")
            )  # fmt: skip
        if language.copies:
            return False
        views = any(VIEWS.search(one.name) for one in value.all() if one.kind == "call")
        return views or value.text.startswith("@view") or value.kind in ("field", "name")

    @cached_property
    def _calls(self) -> tuple[Term, ...]:
        return tuple(t for t in self.body.all() if t.kind == "call")

    @cached_property
    def _sets(self) -> tuple[Term, ...]:
        return tuple(t for t in self.body.all() if t.kind == "set")

    @cached_property
    def _solvers(self) -> frozenset[str]:
        """Names of the function, and of what holds it: a system, and what drives it."""
        held, found = {*self.run.judged}, {*self.run.judged}
        while new := {base_of(t) for line in self._sets if line.parts[1].names() & (held | found)
                      and line.parts[1].kind in ("list", "call", "name")
                      and not any(one.kind == "call" and one.name in held
                                  for one in line.parts[1].all())
                      for t in targets_of(line.parts[0])} - found - {""}:  # fmt: skip
            found |= new
        return frozenset(found)

    def _is_array(self, name: str) -> bool:
        return bool(re.search(r"[\[*]|vector|array|state|Vector", self.types.get(name, "")))

    def is_use(self, term: Term) -> bool:
        """Whether something asks the function, or advances the state by it."""
        asked = {*self.run.judged, *self.run.users}
        objects = self.state if not self.run.language.pointers else frozenset()
        return any(
            one.kind == "call" and (
                one.name.rpartition(".")[2] in asked
                or self.holds_function(one)
                or (not objects.isdisjoint(map(base_of, one.parts))
                    and (one.name in ADVANCES or not self.shows(one)))
                or (self.run.language.brackets and is_solver(one.name))
            )
            for one in term.all()
        )  # fmt: skip

    def advances(self, term: Term) -> bool:
        """Whether something leaves the state advanced."""
        run = self.run
        if any(id(one) in run.memory.steps for one in term.all()):
            return True
        around = any(w in run.words.state for j in run.judged.values() for w in j.around.values())
        return any(
            one.kind == "call" and (
                one.name in run.users or "." in one.name or around
                or self.holds_function(one)
            )
            for one in term.all() if self.is_use(one)
        )  # fmt: skip

    def shows(self, call: Term) -> bool:
        """Whether a call only reads what it is given."""
        last = call.name.rpartition(".")[2]
        return last in self.run.language.shows or last in INNOCENT or last in READS

    @cached_property
    def all_names(self) -> frozenset[str]:
        """Names of the state, results, parameters, and others of the same."""
        return self.state | self.others | self.aliases

    def is_changing_call(self, call: Term, alone: bool, followed: bool) -> bool:
        """Whether a call may change the state, and nothing here follows it.

        Parameters
        ----------
        alone : bool
            Whether nothing takes what it returns: it is there for what it changes.
        followed : bool
            Whether it stands in a step, in which functions of the file are followed.
        """
        run = self.run
        owner, _, last = call.name.rpartition(".")
        if last in UNFOLLOWED:
            return True
        if last in run.judged or call.name in run.users:
            return False
        if (one := run.own.get(last)) is not None:
            return not followed and self._changes(one, call, owner)
        if last in CHANGING or (is_bang(call) and not self.shows(call)):
            return any(head_of(n) in self.all_names for part in call.parts for n in part.names())
        if head_of(owner) in self.state | self.aliases:
            return last not in READS
        if self.shows(call):
            return False
        if last in self._lambdas:
            return self._lambdas[last]
        if not run.language.pointers or not alone:
            return MACRO.fullmatch(last) is not None and not self.all_names.isdisjoint(call.names())
        if self.holds_function(call):
            return any((f := run.own.get(part.name)) is not None and f.shared & f.fills
                       for part in call.parts
                       if part.name not in {*run.judged, *run.users})  # fmt: skip
        parts = call.parts[:1] if last in DESTINATION else call.parts
        return any(
            base_of(part) in self.state | self.aliases and part.kind in ("name", "entry", "field")
            for part in parts
        ) and not owner  # fmt: skip

    @cached_property
    def _lambdas(self) -> dict[str, bool]:
        """Functions without a name that the block gives one, and whether they set anything."""
        return {base_of(one.parts[0]): any(t.kind == "set" for t in one.parts[1].all())
                for one in self._sets if one.parts[1].kind == "handle"}  # fmt: skip

    def holds_function(self, call: Term) -> bool:
        """Whether a call is handed the function, or what holds it."""
        return any(part.kind != "call" and base_of(part) in self._solvers for part in call.parts)

    def _changes(self, one: FileFunction, call: Term, owner: str) -> bool:
        """Whether a function of the file, which does not use the judged one, changes the state."""
        pairs = zip(one.takes, call.parts, strict=False)
        given = any(name in one.shared & one.fills and base_of(part) in self.all_names
                    for name, part in pairs)  # fmt: skip
        around = {n for judged in self.run.judged.values() for n in judged.around}
        inside = {t.name for t in one.body.all() if t.kind == "type"} | {*one.takes}
        free = one.fills - inside
        whole = head_of(owner) in self.state and bool(free)
        return given or whole or not free.isdisjoint({*self.state} | around)


def base_of(term: Term) -> str:
    """The name of the object of which something is a part: rod of rod.theta, y of y.at(1)."""
    if term.kind == "other" and term.text.startswith("&") and len(term.parts) == 1:
        return base_of(term.parts[0])
    return head_of(root_of(term))


def is_bang(call: Term) -> bool:
    """Whether a call of Julia changes what it is given, as its name says."""
    return call.text.partition("(")[0].strip().endswith("!")


def no_steps(run: Run, block: Term) -> Iterator[Term]:
    """Assignments that are in no step of an integrator."""
    if id(block) in run.memory.steps:
        return
    if block.kind == "set":
        yield block
    for part in block.parts:
        yield from no_steps(run, part)


def head_of(name: str) -> str:
    """The object of which a name is a part: rod of rod.theta."""
    return re.split(r"[.\[(]", name, maxsplit=1)[0]

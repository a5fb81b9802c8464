"""Lines of a Python file around judged functions that say something of the motion.

w += -g/l*sin(th)*dt        in a loop, a comprehension or a method: a law of its own
th -= rate(t, y)*dt         no step of an integrator that is known
a = -accel(th)              a result that is changed
rate(w, th)                 a call with exchanged arguments, args=(l, g) of a solver, too
exec("...")                 a text that is run

Plain calls, what goes to a solver, numbers, parts of a solution, plots of it, and loops that are an
integrator with a judged function say nothing of their own.
"""

import ast
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import chain
from typing import Any

from sympy import Symbol

from mechanics.claims.code.around.call_sites import function_lines, is_result, lines_of
from mechanics.claims.code.around.handed_values import changed_by_other_names
from mechanics.claims.code.around.integrator_steps import is_step
from mechanics.claims.code.around.intermediate_form import Term
from mechanics.claims.code.around.interpreter import DRAWN
from mechanics.claims.code.around.interpreter_values import (
    FileFunction,
    JudgedFunction,
    Language,
    SceneNames,
    names_of,
)
from mechanics.claims.code.around.library_names import UNKNOWN, with_library_names
from mechanics.claims.code.around.python_arrays import rounding
from mechanics.claims.code.around.python_form import (
    DEFINED,
    STATE_FIRST,
    TIME_FIRST,
    PythonFile,
    arguments_of,
    block,
    defaults_of,
    expression,
    statement,
    word,
)
from mechanics.claims.code.around.python_functions import (
    TIMES,
    Defined,
    file_function,
    judged_function,
    passed_function,
    within,
    words_in,
)
from mechanics.claims.code.around.python_laws import (
    ARITHMETIC,
    Scope,
    assigned,
    laws,
    root_in,
    roots_in,
)
from mechanics.claims.code.around.python_records import named_tuples, taken_otherwise
from mechanics.claims.code.around.python_solvers import SOLVERS, told_more
from mechanics.claims.code.around.run import Run
from mechanics.claims.code.python.changed_numbers import MAKES
from mechanics.claims.code.python.closure_assignments import paired
from mechanics.claims.code.reachability import reachable
from mechanics.claims.names import Naming

LONGEST = 200
COLLECTED = frozenset(
    ("abs", "all", "any", "append", "array", "asarray", "allclose", "array_equal",
     "assert_allclose", "atleast_1d", "column_stack", "concatenate", "copy", "degrees", "dict",
     "display", "enumerate", "extend", "float", "format", "fill_between", "flatten", "hstack",
     "insert", "int", "isclose", "isfinite", "isnan", "join", "len", "list", "max", "min", "norm",
     "plot", "print", "rad2deg", "range", "ravel", "repr", "reshape", "round", "savetxt", "scatter",
     "semilogy", "set", "set_data", "squeeze", "stack", "str", "sum_of_squares", "tolist", "tuple",
     "vstack", "writerow", "yield", "zip", "eig", "eigvals", "matrix_rank", "det", "lqr", "ss",
     "approx", "shape", "quiver", "streamplot", "contour", "contourf", "fsolve", "root",
     *TIME_FIRST, *STATE_FIRST, "integrate")
)  # fmt: skip
"""Functions that leave what they are given as it is, compare, show or integrate it."""
HIDDEN = frozenset(("exec", "eval", "compile", "setattr", "globals", "locals", "__setattr__"))
"""Calls that do what no line says."""
INNER = frozenset(("modules", "patch", "__builtins__", "__class__", "__closure__", "__code__",
                   "__defaults__", "__dict__", "__globals__", "__kwdefaults__"))  # fmt: skip
"""Names through which lines change what a function or a module is."""
LINEAR = frozenset(("expm", "lsim", "lsim2", "StateSpace", "TransferFunction", "lfilter",
                    "forced_response", "initial_response"))  # fmt: skip
"""Calls that solve a law which is a matrix."""
KEEPING = frozenset(("cached_property", "lru_cache", "cache"))
"""What keeps the value of a function."""
INSIDE = frozenset(("copyto", "put", "place", "putmask", "iadd", "isub", "imul", "itruediv"))
"""Calls that change what they are given."""
WAVES = frozenset(("sin", "cos", "exp", "sinh", "cosh"))
PYTHON = Language("Python", keeps=COLLECTED)
ANY_STATE = SceneNames((Symbol("q"),), (Symbol("u"),))
"""Names where no scene is known."""


def lines_around(code: str, judged: Collection[str], naming: Naming) -> tuple[str, ...]:
    """Lines of a file outside of judged functions, and of what these call, that say something.

    Parameters
    ----------
    code : str
        The file.
    judged : collection of str
        Names of functions and methods.
    naming : Naming
        What arguments are.
    """
    text = [" ".join(line.split()) for line in code.splitlines()]
    tree = with_library_names(ast.parse(code), SOLVERS)
    file = _File(tree, code.splitlines(), reached(tree, judged), names_of(naming))
    found = {one.lineno - 1 for one in file.found(naming) if hasattr(one, "lineno")}
    called = [*file.called()]
    found |= {text.index(line) for line in called if line in text}
    lines = [text[k] for k in sorted(found)] + [line for line in called if line not in text]
    return tuple(dict.fromkeys(line[:LONGEST] for line in lines))


def reached(tree: ast.Module, judged: Collection[str]) -> set[str]:
    """Names of the file, and attributes, that what is judged speaks of."""
    parts: dict[str, set[str]] = {}
    for line in tree.body:
        if isinstance(line, ast.ClassDef):
            for part in line.body:
                if isinstance(part, DEFINED):
                    parts.setdefault(part.name, set()).update(words_in(part))
                    if part.name in judged and not _is_at_top(tree, part.name):
                        parts.setdefault(part.name, set()).update({line.name})
            parts.setdefault(line.name, set()).update(
                {"__init__", "__post_init__", "__new__", "__call__", *map(word, line.bases)}
            )
        elif isinstance(line, DEFINED):
            parts.setdefault(line.name, set()).update(words_in(line))
        elif isinstance(line, ast.Assign):
            for target in line.targets:
                if isinstance(target, ast.Name):
                    parts.setdefault(target.id, set()).update(words_in(line.value))
    return reachable(judged, parts)


def _is_at_top(tree: ast.Module, name: str) -> bool:
    return any(isinstance(line, DEFINED) and line.name == name for line in tree.body)


def integrators(tree: ast.Module) -> set[str]:
    """Names of functions of a file that advance a state with a function that they are given."""
    file = _File(tree, [], set(), ANY_STATE)
    return {
        one.name for one in file.outer
        if (passed := file.passed(one)) and (
            file.steps(passed, one, one.body)
            or any(file.steps(passed, one, n.body) for n in within(one.body)
                   if isinstance(n, ast.For | ast.While))
        )
    }  # fmt: skip


def _at_top(body: Sequence[ast.AST]) -> Iterator[Defined]:
    """Functions of a file, those under a condition too."""
    for one in body:
        if isinstance(one, DEFINED):
            yield one
        elif isinstance(one, ast.If | ast.Try | ast.With | ast.ExceptHandler):
            yield from _at_top([*ast.iter_child_nodes(one)])


def _attributes_of(methods: Collection[Defined]) -> frozenset[str]:
    """Attributes of their object that methods use, but for other methods: self.k."""
    every = [n for method in methods for n in ast.walk(method) if isinstance(n, ast.Attribute)]
    called = {id(n.func) for method in methods for n in ast.walk(method) if isinstance(n, ast.Call)}
    return frozenset(n.attr for n in every if word(n.value) == "self" and id(n) not in called)


@dataclass(frozen=True)
class _File:
    """A file, with the names that what is judged speaks of."""

    tree: ast.Module
    text: Sequence[str]
    own: Collection[str]
    names: SceneNames

    @cached_property
    def kinds(self) -> list[ast.ClassDef]:
        """Classes."""
        return [n for n in ast.walk(self.tree) if isinstance(n, ast.ClassDef)]

    @cached_property
    def nodes(self) -> dict[str, Defined]:
        """Judged functions and methods, and those that these call."""
        methods = {
            part.name: part
            for kind in self.tree.body if isinstance(kind, ast.ClassDef) and kind.name in self.own
            for part in kind.body
            if isinstance(part, DEFINED) and part.name in self.own and part.name not in MAKES
        }  # fmt: skip
        return {**methods, **{n.name: n for n in _at_top(self.tree.body) if n.name in self.own}}

    @cached_property
    def judged(self) -> dict[str, JudgedFunction]:
        """The same, by what they take and give."""
        return {name: judged_function(node, self.names) for name, node in self.nodes.items()}

    @cached_property
    def outer(self) -> list[Defined]:
        """Functions and methods that are neither judged nor called by what is."""
        return [*self._outer(self.tree.body)]

    def _outer(self, body: Sequence[ast.AST]) -> Iterator[Defined]:
        for one in body:
            if any(one is node for node in self.nodes.values()):
                continue
            if isinstance(one, DEFINED):
                yield one
            yield from self._outer([*ast.iter_child_nodes(one)])

    def _methods(self, name: str) -> dict[str, Defined]:
        return {kind.name: part for kind in self.kinds for part in kind.body
                if isinstance(part, DEFINED) and part.name == name}  # fmt: skip

    @cached_property
    def form(self) -> PythonFile:
        """What the form of its lines depends on."""
        functions = [n for n in ast.walk(self.tree) if isinstance(n, DEFINED)]
        takes = {n.name: arguments_of(n.args) for n in functions}
        takes |= {n: arguments_of(f.args) for n, f in self._methods("__init__").items()}
        called = dict.fromkeys(self._methods("__call__"), "__call__")
        called |= {
            n.targets[0].id: "__call__" for n in ast.walk(self.tree)
            if isinstance(n, ast.Assign) and isinstance(n.targets[0], ast.Name)
            and isinstance(n.value, ast.Call) and word(n.value.func) in called
        }  # fmt: skip
        started = (word(n.args[0]) for n in ast.walk(self.tree)
                   if isinstance(n, ast.Call) and word(n.func) == "ode" and n.args)  # fmt: skip
        handed = next((name for name in started if name in takes), "")
        records = named_tuples([*ast.walk(self.tree)])
        return PythonFile(takes, self.text, called, handed, self._lists(), records)

    def _lists(self) -> frozenset[str]:
        """Names that are nothing but lists."""
        made: dict[str, list[ast.expr]] = {}
        for line in (n for n in ast.walk(self.tree) if isinstance(n, ast.Assign)):
            for target in line.targets:
                if isinstance(target, ast.Name | ast.Attribute):
                    made.setdefault(word(target), []).append(line.value)
        taken = {n.arg for n in ast.walk(self.tree) if isinstance(n, ast.arg)}
        return frozenset(
            name for name, values in made.items()
            if name not in taken and all(map(_is_list, values))
        )  # fmt: skip

    @cached_property
    def functions(self) -> dict[str, FileFunction]:
        """Functions that are not judged; a class by what makes its objects."""
        others = {**{one.name: one for one in self.outer}, **self._methods("__init__")}
        others = {n: one for n, one in others.items() if n not in self.nodes}
        return {n: file_function(one, self.form) for n, one in others.items()}

    @cached_property
    def users(self) -> set[str]:
        """Functions that use a judged one, and what uses these."""
        parts = {name: one.body.names() for name, one in self.functions.items()}
        return {name for name in parts if reachable({name}, parts) & self.judged.keys()}

    def passed(self, function: Defined) -> dict[str, JudgedFunction]:
        """Functions that a function is given and calls."""
        inside = [*within(function.body)]
        around = [one for one in self.outer if any(n is function for n in ast.walk(one))]
        given = {n.arg for one in (function, *around) for n in ast.walk(one.args)
                 if isinstance(n, ast.arg)}  # fmt: skip
        called = {n.func.id for n in inside
                  if isinstance(n, ast.Call) and isinstance(n.func, ast.Name)}  # fmt: skip
        return {n: passed_function(n, inside, self.names) for n in sorted(given & called)}

    def run(self, judged: Mapping[str, JudgedFunction]) -> Run:
        """What stands around some functions."""
        return Run(judged, self.functions, self.users, self.names, PYTHON, self.block, self.made)

    @cached_property
    def made(self) -> dict[str, Term]:
        """Lists that attributes and names of functions hold, of those that get no other value."""
        values: dict[str, list[ast.AST]] = {}
        for line in assigned(ast.walk(self.tree)):
            for root in line.targets:
                values.setdefault(root, []).append(line.value)
        apart = {root for line in assigned(within(self.top)) for root in line.targets}
        apart |= {n.arg for n in ast.walk(self.tree) if isinstance(n, ast.arg)}
        lists = {
            name: expression(one, self.form) for name, (one, *more) in values.items()
            if isinstance(one, ast.expr) and not more and name not in apart
        }  # fmt: skip
        kinds = {kind.name for kind in self.kinds}
        objects = {name for name, (one, *_) in values.items()
                   if isinstance(one, ast.Call) and word(one.func) in kinds}  # fmt: skip
        return {
            f"{base}{dot}{last}": one
            for name, one in lists.items() if one.kind == "list" and name not in one.names()
            for owner, dot, last in (name.rpartition("."),)
            for base in ({owner} if owner != "self" else {owner, *objects})
        }  # fmt: skip

    @cached_property
    def block(self) -> Term:
        """Lines outside of functions and classes, in the intermediate form."""
        return block(self.top, self.form)

    @cached_property
    def top(self) -> list[ast.stmt]:
        """Lines outside of functions and classes."""
        lines = [s for s in self.tree.body if not isinstance(s, (*DEFINED, ast.ClassDef))]
        return [s for s in lines if not self._is_judged(s)]

    def _is_judged(self, line: ast.stmt) -> bool:
        """Whether a line gives a function without a name that is judged its name."""
        match line:
            case ast.Assign(targets=[ast.Name(id=name)], value=ast.Lambda()):
                return name in self.own
        return False

    @cached_property
    def known(self) -> tuple[dict[str, Any], list[str]]:
        """What names of the file are, and lines outside of functions that are not innocent."""
        known: dict[str, Any] = {}
        run = self.run(self.judged)
        attributes = [statement(one, self.form) for one in self._attributes()]
        lines = [*attributes, *self.block.parts]
        found = [text for one in lines for text in lines_of(run, one, known)]
        return known, found

    def _attributes(self) -> Iterator[ast.stmt]:
        """What classes give their attributes, as lines outside of them: P.m = 1."""
        for kind in self.tree.body:
            if isinstance(kind, ast.ClassDef):
                owner = ast.Name(kind.name, ast.Load())
                for one in (line for line in kind.body if isinstance(line, ast.Assign)):
                    for target, value in chain(*(paired(t, one.value) for t in one.targets)):
                        place = ast.Attribute(owner, root_in(target), ast.Store())
                        line = ast.copy_location(ast.Assign([place], value), one)
                        yield ast.fix_missing_locations(line)

    def called(self) -> Iterator[str]:
        """Lines that use what is judged otherwise than as it is."""
        known, found = self.known
        yield from found
        for body in (self.block, *(one.body for one in self.functions.values())):
            yield from changed_by_other_names(self.run(self.judged), body)
        for one in self.outer:
            run = self.run({**self.judged, **self.passed(one)})
            yield from lines_of(run, self._defaults(one), dict(known))
            yield from function_lines(run, file_function(one, self.form), known)

    def _defaults(self, function: Defined) -> Term:
        """What a function that uses a judged one has for arguments which a call leaves out."""
        uses = words_in(function) & {*self.judged, *self.users, *SOLVERS, *self.passed(function)}
        pairs = defaults_of(function.args) if uses else ()
        sets = tuple(
            Term("set", "", (Term("name", name), expression(value, self.form)))
            for name, value in pairs if self.names.meaning(name) not in self.names.state
        )  # fmt: skip
        return Term("call", "", sets, " ".join(self.text[function.lineno - 1].split()))

    def steps(
        self, judged: Mapping[str, JudgedFunction], around: Defined | None,
        body: Sequence[ast.stmt],
    ) -> set[str]:  # fmt: skip
        """What a block advances as an integrator does: of a function, or all of it."""
        run = self.run(judged)
        one = file_function(around, self.form) if around is not None else None
        before = [s for s in (self.top if around is None else around.body)
                  if isinstance(s, ast.Assign) and s not in body]  # fmt: skip
        run.memory.before = [
            *filter(partial(is_result, run), (statement(s, self.form) for s in before))
        ]
        loops = (n for n in ast.walk(self.tree) if isinstance(n, ast.For | ast.While))
        loop = next((statement(n, self.form) for n in loops if n.body is body), None)
        lines = loop or block(body, self.form)
        if lines.kind == "block" and loop is not None:  # while ... else
            lines = lines.parts[0]
        apart = {*one.takes, *one.local} if one is not None else set()
        known = {name: value for name, value in self.known[0].items() if name not in apart}
        whole = one if around is not None and body is around.body else None
        found = is_step(run, lines, known, whole)
        return {root for root, _ in run.memory.advanced} if found else set()

    # what is said without a judged function

    def found(self, naming: Naming) -> Iterator[ast.AST]:
        """What says something."""
        yield from (n for n in self.tree.body if isinstance(n, DEFINED) and n.name in self.own
                    and all(n is not one for one in self.nodes.values()))  # fmt: skip
        for judged in self.nodes.values():
            for tried in (n for n in ast.walk(judged) if isinstance(n, ast.Try)):
                yield from (n for n in tried.body if isinstance(n, ast.Import | ast.ImportFrom))
        yield from told_more(self.tree)
        yield from self._handed_to_unknown()
        yield from self._drawn_laws()
        yield from taken_otherwise(self.tree, self.names.meaning)
        handed = {name for one in self.outer for name in self.passed(one)}
        yield from rounding(self.tree, {*self.judged, *self.users, *handed})
        scopes: list[tuple[Sequence[ast.stmt], Defined | None]] = [(self.top, None)]
        scopes += [(one.body, one) for one in self.outer]
        scopes += [([s for s in c.body if not isinstance(s, DEFINED)], None) for c in self.kinds]
        inert = COLLECTED | self.form.takes.keys() | {kind.name for kind in self.kinds}
        moving = {n for one in self.judged.values() for n in one.meanings}
        for body, function in scopes:
            passed = self.passed(function) if function is not None else {}
            steps = partial(self.steps, {**self.judged, **passed}, function)
            scope = Scope(body, function, naming, moving, {*inert, *passed}, steps)
            yield from laws(scope)
            yield from self._said(scope)

    def _handed_to_unknown(self) -> Iterator[ast.AST]:
        """Calls of what only has the name of a solver, with what is judged."""
        for one in ast.walk(self.tree):
            if isinstance(one, ast.Call) and word(one.func) == UNKNOWN:
                given = [*one.args, *(k.value for k in one.keywords)]
                if any(words_in(part) & {*self.judged, *self.users} for part in given):
                    yield one

    def _drawn_laws(self) -> Iterator[ast.AST]:
        """Lines by which a parameter is another one whenever a law is asked, or in each step."""
        parts = {name: one.body.names() for name, one in self.functions.items()}
        drawn = DRAWN | {name for name in parts if reachable({name}, parts) & DRAWN}
        asking = {*self.judged, *self.users}
        laws = [
            (list[ast.AST]([one.body]), {*arguments_of(one.args)})
            for one in ast.walk(self.tree) if isinstance(one, ast.Lambda)
        ]  # fmt: skip
        laws += [([*one.body], {*arguments_of(one.args)}) for one in self.outer]
        for loop in ast.walk(self.tree):
            if isinstance(loop, ast.For | ast.While):
                lines = assigned([*within(loop.body)])
                laws.append(([*loop.body], {
                    name for line in lines if words_in(line.value) & asking
                    for name in line.targets & roots_in(line.value)
                }))  # fmt: skip
        for body, moving in laws:
            inside = [*within(body)]
            calls = [n for n in inside if isinstance(n, ast.Call) and word(n.func) in asking]
            if not any(words_in(part) & moving for call in calls for part in call.args):
                continue
            for line in assigned(inside):
                told = {*map(self.names.meaning, line.targets)} & {*self.names.parameters}
                if told and words_in(line.value) & drawn:
                    yield line.node
            yield from (call for call in calls if any(words_in(p) & drawn for p in call.args))

    def _said(self, scope: Scope) -> Iterator[ast.AST]:
        for one in scope.inside:
            match one:
                case ast.Call() if self._hides(one) or self._sets_attribute(one):
                    yield one
                case ast.Name(id=name) | ast.Attribute(attr=name) if name in INNER:
                    yield one
                case ast.Lambda() if not (words_in(one.body) & scope.inert) and _computes(one):
                    yield one
                case ast.Assign() if id(one) not in scope.right and self._is_motion(one):
                    yield one
                case ast.Assign(targets=targets) if self._changes_object(targets):
                    yield one
                case ast.AugAssign(target=target) if self._changes_object([target]):
                    yield one

    @cached_property
    def held(self) -> frozenset[str]:
        """Attributes that judged methods use."""
        return _attributes_of(self.nodes.values())

    @cached_property
    def kept_of(self) -> frozenset[str]:
        """Of what objects are when they compute a value that they keep: other ones do not follow.

        By ``cached_property`` or ``lru_cache``, or by what makes an object.
        """
        kinds = [kind for kind in self.kinds if kind.name in self.own]
        methods = [part for kind in kinds for part in kind.body if isinstance(part, DEFINED)]
        once = [m for m in methods if {n for d in m.decorator_list for n in words_in(d)} & KEEPING]
        found = set(_attributes_of(once))
        for maker in (m for m in methods if m.name in MAKES):
            for line in assigned([*within(maker.body)]):
                if any(isinstance(n, ast.BinOp) for n in ast.walk(line.value)):
                    found |= words_in(line.value)
        return frozenset(found)

    def _hides(self, node: ast.Call) -> bool:
        """Whether a call does what no line says, or solves a law of its own."""
        name = word(node.func)
        hides = name in HIDDEN | LINEAR | INSIDE or any(k.arg == "out" for k in node.keywords)
        return hides or name == "vars"

    def _sets_attribute(self, node: ast.Call) -> bool:
        """Whether a maker gets what a judged method uses and the scene has no name for."""
        maker = self._methods("__init__").get(word(node.func))
        if maker is None:
            return False
        names = arguments_of(maker.args)
        given = {k.arg for k in node.keywords if k.arg} | {*names[: len(node.args)]}
        kept = [
            line.value for line in assigned([*within(maker.body)])
            if any(name.rpartition(".")[2] in self.held for name in line.targets)
        ]  # fmt: skip
        used = {word(n) for value in kept for n in ast.walk(value)}
        return any(not self.names.meaning(name) for name in given & used)

    def _changes_object(self, targets: Sequence[ast.expr]) -> bool:
        """Whether an object gets what a judged method uses and the scene has no name for.

        Or that of which it keeps a value, which is stale then.
        """
        places = [p for one in targets for p in ast.walk(one) if isinstance(p, ast.Attribute)]
        return any(
            word(p.value) not in ("self", "cls")
            and (p.attr in self.kept_of
                 or (p.attr in self.held and not self.names.meaning(p.attr)))
            for p in places
        )  # fmt: skip

    def _is_motion(self, node: ast.Assign) -> bool:
        """Whether a line computes an acceleration, or a coordinate as a function of time."""
        inside = [*within([node.value])]
        if not any(isinstance(n, ast.BinOp) and roots_in(n) for n in inside):
            return False
        names = [n.id for t in node.targets for n in ast.walk(t) if isinstance(n, ast.Name)]
        orders = {self._order(name) for name in names} - {None}
        waves = (n for n in inside if isinstance(n, ast.Call) and word(n.func) in WAVES)
        return 2 in orders or (bool(orders) and any(roots_in(n) & TIMES for n in waves))

    def _order(self, name: str) -> int | None:
        """Which derivative of a coordinate a name is; None for what is neither that nor a speed."""
        meaning = self.names.meaning(name)
        if meaning in self.names.state:
            return int(meaning in self.names.speeds)
        return 2 if meaning in self.names.accelerations else None


def _is_list(node: ast.expr) -> bool:
    """Whether something is a list, and no array."""
    called = isinstance(node, ast.Call) and word(node.func) in ("list", "tolist")
    return called or isinstance(node, ast.List | ast.ListComp)


def _computes(node: ast.Lambda) -> bool:
    """Whether a function without a name does more than take a part of something."""
    for one in ast.walk(node.body):
        if isinstance(one, (*ARITHMETIC, ast.List, ast.Tuple)):
            return True
        if isinstance(one, ast.Call) and isinstance(one.func, ast.Attribute):
            if word(one.func.value) in ("np", "numpy", "math", "jnp", "operator"):
                return True
        elif isinstance(one, ast.Call) and word(one.func) not in COLLECTED:
            return True
    return False

"""Lines of a Python file around judged functions that say something of the motion.

w += -g/l*sin(th)*dt        in a loop, a comprehension or a method: a law of its own
th -= rate(t, y)*dt         no step of an integrator that is known
a = -accel(th)              a result that is changed
rate(w, th)                 a call with exchanged arguments, args=(l, g) of a solver, too
exec("...")                 a text that is run

Plain calls, what goes to a solver, numbers, parts of a solution, plots of it, and loops that are an
integrator with a judged function say nothing of their own. A whitelist for what is computed from a
turn of a loop to the next one, for what is done with a result, and for arguments of a call.
"""

import ast
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from mechanics.claims.code.changed_numbers import MAKES
from mechanics.claims.code.python_calls import (
    ARITHMETIC,
    DEFINED,
    STATE_FIRST,
    TIME_FIRST,
    TIMES,
    Calls,
    Defined,
    fixed_in,
    passed,
    word,
    word_of_truth,
    words_in,
)
from mechanics.claims.code.python_steps import Called, stepped, unwrapped_angle
from mechanics.claims.code.reachability import reachable
from mechanics.claims.names import Naming
from mechanics.scene.symbols import plain_symbol

LONGEST = 60
COMPREHENSIONS = (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)
COLLECTED = frozenset(
    ("abs", "all", "any", "append", "array", "asarray", "allclose", "array_equal",
     "assert_allclose", "atleast_1d", "column_stack", "concatenate", "copy", "degrees", "dict",
     "display", "enumerate", "extend", "float", "format", "fill_between", "flatten", "hstack",
     "insert", "int", "isclose", "isfinite", "isnan", "join", "len", "list", "max", "min", "norm",
     "plot", "print", "rad2deg", "range", "ravel", "repr", "reshape", "round", "savetxt", "scatter",
     "semilogy", "set", "set_data", "squeeze", "stack", "str", "sum_of_squares", "tolist", "tuple",
     "vstack", "writerow", "yield", "zip", "eig", "eigvals", "matrix_rank", "det", "lqr", "ss",
     "approx", "shape", "quiver", "streamplot", "contour", "contourf", "fsolve", "root")
)  # fmt: skip
"""Functions that leave what they are given as it is, compare or show it."""
HIDDEN = frozenset(("exec", "eval", "compile", "setattr", "globals", "locals", "__setattr__"))
"""Calls that do what no line says."""
LINEAR = frozenset(("expm", "lsim", "lsim2", "StateSpace", "TransferFunction", "lfilter",
                    "forced_response", "initial_response"))  # fmt: skip
"""Calls that solve a law which is a matrix."""
INSIDE = frozenset(("copyto", "put", "place", "putmask", "iadd", "isub", "imul", "itruediv"))
"""Calls that change what they are given."""
SOLVERS = frozenset((*TIME_FIRST, *STATE_FIRST, "integrate"))
"""Calls that integrate what they are given."""
WAVES = frozenset(("sin", "cos", "exp", "sinh", "cosh"))
COUNTS = frozenset(("t", "time", "ti", "t_now", "tt"))


@dataclass(frozen=True)
class _Line:
    """What gives names values.

    Attributes
    ----------
    node : ast.AST
        The statement, for its place.
    targets : frozenset of str
        Roots of the places.
    value : ast.AST
    """

    node: ast.AST
    targets: frozenset[str]
    value: ast.AST


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
    tree = ast.parse(code)
    own = reached(tree, judged)
    found = _File(tree, own, naming).found()
    text = code.splitlines()
    places = sorted({one.lineno for one in found if hasattr(one, "lineno")})
    return tuple(dict.fromkeys(" ".join(text[k - 1].split())[:LONGEST] for k in places))


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


def integrators(tree: ast.Module, size: int = 2) -> set[str]:
    """Names of functions of a file that advance a state with a function that they are given."""
    found = set()
    fixed = fixed_in(tree)
    for one in ast.walk(tree):
        if isinstance(one, DEFINED):
            inside = [*_within(one.body)]
            known = {name: passed(name, inside) for name in called_arguments(one)}
            loops = [n.body for n in inside if isinstance(n, ast.For | ast.While)]
            if known and (
                any(stepped(body, known, size, fixed) for body in loops)
                or returned_step(one, known, size, fixed)[1]
            ):
                found.add(one.name)
    return found


def called_arguments(function: Defined) -> set[str]:
    """Names of arguments of a function that it calls."""
    names = {a.arg for a in ast.walk(function.args) if isinstance(a, ast.arg)}
    return names & {n.func.id for n in _within(function.body) if isinstance(n, ast.Call)
                    and isinstance(n.func, ast.Name)}  # fmt: skip


def returned_step(
    function: Defined, known: Mapping[str, Called], size: int, fixed: Mapping[str, ast.expr]
) -> tuple[list[ast.stmt], set[str]]:
    """What a function advances that returns the next state, y + dt*f(t, y), and in which line."""
    body = function.body
    if not isinstance(body[-1], ast.Return) or body[-1].value is None:
        return [], set()
    names = [a.arg for a in function.args.args if a.arg not in known]
    value = body[-1].value
    count = len(value.elts) if isinstance(value, ast.Tuple | ast.List) else 1
    for first in range(len(names) - count + 1):
        chosen: list[ast.expr] = [ast.Name(n, ast.Store()) for n in names[first : first + count]]
        target = chosen[0] if count == 1 else ast.Tuple(chosen, ast.Store())
        step = ast.copy_location(ast.Assign([target], value), body[-1])
        if found := stepped([*body[:-1], step], known, size, fixed):
            return [step], found
    return [], set()


def _at_top(body: Iterable[ast.stmt]) -> Iterator[Defined]:
    """Functions of a file, those under a condition too."""
    for one in body:
        if isinstance(one, DEFINED):
            yield one
        elif isinstance(one, ast.If | ast.Try | ast.With):
            yield from _at_top(n for n in ast.iter_child_nodes(one) if isinstance(n, ast.stmt))
            for part in getattr(one, "handlers", ()):
                yield from _at_top(part.body)


def _methods(tree: ast.Module, own: Collection[str]) -> dict[str, Defined]:
    """Judged methods, and those that these call."""
    kinds = (n for n in tree.body if isinstance(n, ast.ClassDef) and n.name in own)
    return {
        part.name: part
        for kind in kinds for part in kind.body
        if isinstance(part, DEFINED) and part.name in own and part.name not in MAKES
    }  # fmt: skip


def attributes_of(methods: Sequence[Defined]) -> frozenset[str]:
    """Attributes of their object that methods use, but for other methods: self.k."""
    every = [n for method in methods for n in ast.walk(method) if isinstance(n, ast.Attribute)]
    called = {id(n.func) for method in methods for n in ast.walk(method) if isinstance(n, ast.Call)}
    return frozenset(n.attr for n in every if word(n.value) == "self" and id(n) not in called)


class _File:
    def __init__(self, tree: ast.Module, own: set[str], naming: Naming) -> None:
        self.tree, self.own, self.naming = tree, own, naming
        self.functions = {n.name: n for n in ast.walk(tree) if isinstance(n, DEFINED)}
        judged = {**_methods(tree, own), **{n.name: n for n in _at_top(tree.body) if n.name in own}}
        self.judged = {id(n) for n in judged.values()}
        self.gone = [n for n in tree.body if isinstance(n, DEFINED) and n.name in own
                     and id(n) not in self.judged]  # fmt: skip
        self.kinds = {n.name for n in ast.walk(tree) if isinstance(n, ast.ClassDef)}
        self.makers, self.callables = (
            {kind.name: part for kind in ast.walk(tree) if isinstance(kind, ast.ClassDef)
             for part in kind.body if isinstance(part, DEFINED) and part.name == name}
            for name in ("__init__", "__call__")
        )  # fmt: skip
        self.held = attributes_of([*judged.values()])
        self.calls = Calls(tree, judged, naming)
        scene = naming.vocabulary.scene
        self.size = len(scene.q) + len(scene.u)
        self.fixed = self.calls.fixed
        self.outer = [*self._outer(tree.body)]
        self.results = {*self.calls.functions}
        self.steps: dict[int, set[str]] = {}
        while new := {f.name for f in self.outer if self._gives_result(f)} - self.results:
            self.results |= new

    def _outer(self, body: Sequence[ast.AST]) -> Iterator[Defined]:
        """Functions and methods that are neither judged nor called by what is."""
        for one in body:
            if id(one) in self.judged:
                continue
            if isinstance(one, DEFINED):
                yield one
            yield from self._outer([*ast.iter_child_nodes(one)])

    def found(self) -> list[ast.AST]:
        """What says something."""
        found: list[ast.AST] = [*self.gone]
        top = [s for s in self.tree.body if not isinstance(s, (*DEFINED, ast.ClassDef))]
        top = [s for s in top if not self._is_judged(s)]
        scopes: list[tuple[Sequence[ast.stmt], Defined | None]] = [(top, None)]
        scopes += [(f.body, f) for f in self.outer]
        scopes += [([s for s in c.body if not isinstance(s, DEFINED)], None)
                   for c in ast.walk(self.tree) if isinstance(c, ast.ClassDef)]  # fmt: skip
        for body, function in scopes:
            found += _Scope(self, body, function).found()
        return found

    def called(self, node: ast.Call) -> Defined | None:
        """The function of the file that a call runs."""
        name = word(node.func)
        return self.makers.get(name) if name in self.kinds else self.functions.get(name)

    def handed(self, node: ast.expr) -> Defined | None:
        """The function of the file that something is: rate, model.rate, Model(...)."""
        if isinstance(node, ast.Call):
            return self.callables.get(word(node.func))
        return self.functions.get(word(node))

    def _is_judged(self, line: ast.stmt) -> bool:
        """Whether a line gives a function without a name that is judged its name."""
        match line:
            case ast.Assign(targets=[ast.Name(id=name)], value=ast.Lambda()):
                return name in self.own
        return False

    def _gives_result(self, function: Defined) -> bool:
        scope = _Scope(self, function.body, function)
        tainted = scope.tainted()
        returned = [n.value for n in scope.inside if isinstance(n, ast.Return) and n.value]
        return any(scope.holds(value, tainted) for value in returned)


@dataclass
class _Scope:
    file: _File
    body: Sequence[ast.stmt]
    function: Defined | None
    inside: list[ast.AST] = field(init=False)

    def __post_init__(self) -> None:
        self.inside = [*_within(self.body)]
        self.passed = called_arguments(self.function) if self.function is not None else set()
        self.shared = {n for g in self.inside if isinstance(g, ast.Global | ast.Nonlocal)
                       for n in g.names}  # fmt: skip
        self.known = dict(self.file.calls.functions)
        for name in self.passed:
            self.known[name] = passed(name, self.inside)
        self.right: set[int] = set()
        self.lines = [*_assigned(self.inside)]
        self.moving = self.file.calls.moved(self.inside)
        self.unpacked = [
            [*map(word, one.targets[0].elts)]
            for one in self.inside
            if isinstance(one, ast.Assign) and isinstance(one.targets[0], ast.Tuple)
            and isinstance(one.value, ast.Call) and word(one.value.func) in self.file.results
        ]  # fmt: skip

    def found(self) -> Iterator[ast.AST]:
        """What of the scope says something."""
        yield from self._laws()
        tainted = self.tainted()
        for one in self.inside:
            if isinstance(one, ast.Call):
                yield from self._call(one)
            elif isinstance(one, ast.Tuple | ast.List) and self.file.calls.exchanges(one):
                yield one
            elif isinstance(one, ast.Lambda):
                if not self._is_plain(one):
                    yield one
            elif isinstance(one, ast.Assign):
                if self._is_motion(one) or self._exchanges(one) or self._changes_object(one):
                    yield one
            elif isinstance(one, ast.AugAssign):
                if self._is_scaled(one) or self._changes_object(one):
                    yield one
            elif isinstance(one, ast.Dict) and self._has_excluded(one):
                yield one
        for one in self.inside:
            if isinstance(one, ast.Subscript | ast.List | ast.Tuple):
                if self._reorders(one, tainted):
                    yield one
            elif isinstance(one, ARITHMETIC) and id(one) not in self.right:
                if self._changes(one, tainted):
                    yield one
            elif isinstance(one, ast.Call) and id(one) not in self.right:
                inert = word(one.func) in COLLECTED | SOLVERS | self._own()
                if not inert and any(self.holds(a, tainted) for a in _arguments(one)):
                    yield one

    def _own(self) -> set[str]:
        return {*self.file.functions, *self.file.kinds, *self.passed}

    def _has_excluded(self, node: ast.Dict) -> bool:
        pairs = zip(node.keys, node.values, strict=True)
        return any(
            isinstance(k, ast.Constant) and isinstance(k.value, str)
            and self.file.calls.excluded(k.value, value)
            for k, value in pairs
        )  # fmt: skip

    # what goes from a turn to the next

    def _laws(self) -> Iterator[ast.AST]:
        """Lines by which a value becomes that of the next turn, or the next call."""
        for one in self.inside:
            if isinstance(one, ast.For | ast.While | ast.AsyncFor):
                yield from self._block(one.body, None)
            elif isinstance(one, COMPREHENSIONS):
                parts = [n for n in _within([one]) if isinstance(n, ast.NamedExpr)]
                body = [ast.copy_location(ast.Assign([n.target], n.value), n) for n in parts]
                yield from self._block(body, None)
        if self.function is not None and self.function.name not in MAKES:
            yield from self._block(self.function.body, self._persisting())
            yield from self._again()

    def _persisting(self) -> set[str]:
        """What of a function is still there when it is called again."""
        assert self.function is not None
        arguments = {a.arg for a in ast.walk(self.function.args) if isinstance(a, ast.arg)}
        found = {*self.shared}
        for one in self.inside:
            if isinstance(one, ast.Subscript | ast.Attribute) and isinstance(
                one.ctx, ast.Store | ast.Del
            ):
                root = _root(one)
                local = {t for line in self.lines for t in line.targets} - arguments
                if root not in local or "." in root:
                    found.add(root)
            elif isinstance(one, ast.AugAssign) and isinstance(one.target, ast.Name):
                found |= {one.target.id} & arguments
        return found

    def _block(self, body: Sequence[ast.stmt], persisting: set[str] | None) -> Iterator[ast.AST]:
        """Lines of what is done again and again that are a law, and none that is judged."""
        inside = [*_within(body)]
        lines = [*_assigned(inside)]
        groups = _circles(lines)
        steps = stepped(body, self.known, self.file.size, self.file.fixed)
        if self.function is not None and not steps and persisting is not None:
            steps = self._returned(body)
        for line in lines:
            circle = groups.get(min(line.targets, default=""), frozenset())
            if circle & steps or line.targets & steps:
                self.right |= {id(n) for n in (line.node, *_within([line.value]))}
        feeding = _feeding(lines, steps)
        for line in lines:
            if line.targets <= feeding:
                self.right |= {id(n) for n in (line.node, *_within([line.value]))}
        for line in lines:
            for name in line.targets:
                circle = groups.get(name, frozenset())
                if not circle or circle & steps:
                    continue
                if persisting is not None and not circle & persisting:
                    continue
                if not self._keeps(line, circle):
                    yield line.node

    def _returned(self, body: Sequence[ast.stmt]) -> set[str]:
        """What a function advances that returns the next state."""
        assert self.function is not None
        step, found = returned_step(self.function, self.known, self.file.size, self.file.fixed)
        if found:
            feeding = _feeding([*_assigned([*_within([*body[:-1], *step])])], found)
            self.right |= {id(n) for n in _within([body[-1]])}
            for line in self.lines:
                if line.targets <= feeding | found:
                    self.right |= {id(n) for n in (line.node, *_within([line.value]))}
        return found

    def _again(self) -> Iterator[ast.AST]:
        """Calls of a function by itself with other values: the turns of a loop."""
        assert self.function is not None
        names = [a.arg for a in self.function.args.args if a.arg not in ("self", "cls")]
        for one in self.inside:
            if isinstance(one, ast.Call) and word(one.func) == self.function.name:
                pairs = [*zip(names, one.args, strict=False)]
                pairs += [(k.arg, k.value) for k in one.keywords if k.arg]
                target = ast.Tuple([ast.Name(n, ast.Store()) for n, _ in pairs], ast.Store())
                value = ast.Tuple([v for _, v in pairs], ast.Load())
                step = ast.copy_location(ast.Assign([target], value), one)
                found = [*self._block([step], {*names})]
                if found and any(isinstance(n, ARITHMETIC) for n in ast.walk(value)):
                    rest = [v for n, v in pairs if n not in COUNTS and not _is_count(v)]
                    if any(isinstance(n, ARITHMETIC) for v in rest for n in ast.walk(v)):
                        yield one

    def _keeps(self, line: _Line, circle: frozenset[str]) -> bool:
        """Whether a line that depends on its own last value only counts, collects, or passes on."""
        match line.node:
            case ast.AugAssign(target=ast.Name() | ast.Attribute() as target, value=value):
                return self._counts(word(target), value)
            case ast.AugAssign():
                return False
            case ast.Assign(
                targets=[ast.Name(id=name)],
                value=ast.BinOp(left=ast.Name(id=same), op=ast.Add() | ast.Sub(), right=value),
            ) if name == same:
                return self._counts(name, value)
            case ast.Expr(value=ast.Call(func=ast.Attribute(attr="integrate"))):
                return True  # of a solver
        wraps = [n for n in _within([line.value]) if isinstance(n, ast.BinOp)
                 and unwrapped_angle(n) is not None]  # fmt: skip
        skipped = {id(n) for wrap in wraps for n in ast.walk(wrap)}
        return not any(
            _roots(one) & circle and not self._collects(one)
            for one in _within([line.value]) if id(one) not in skipped
        )  # fmt: skip

    def _collects(self, node: ast.AST) -> bool:
        """Whether an expression leaves what it is made of as it is."""
        if isinstance(node, ast.Call):
            known = word(node.func) in COLLECTED | SOLVERS | self._own()
            return known or not _roots_of(_arguments(node))
        return not isinstance(node, ast.BinOp | ast.UnaryOp)

    def _counts(self, name: str, value: ast.expr) -> bool:
        """Whether a name only counts turns, or time."""
        if name in self.file.calls.moving or self.file.naming.lookup(name) is not None:
            return False
        if isinstance(value, ast.Constant):
            return isinstance(value.value, int | str) or name in COUNTS
        if isinstance(value, ast.Name | ast.Attribute):
            return name in COUNTS
        return isinstance(value, ast.List | ast.Tuple | ast.JoinedStr)

    # what is done with a result

    def tainted(self) -> set[str]:
        """Names of results of judged functions."""
        found: set[str] = set()
        while True:
            new = {
                name for line in self.lines if self.holds(line.value, found)
                for name in line.targets
            } - self._states() - found  # fmt: skip
            if not new:
                return found
            found |= new

    def _states(self) -> set[str]:
        """What loops of the scope advance as integrators do."""
        found: set[str] = set()
        for one in self.inside:
            if isinstance(one, ast.For | ast.While):
                key = id(one)
                if key not in self.file.steps:
                    steps = stepped(one.body, self.known, self.file.size, self.file.fixed)
                    self.file.steps[key] = steps
                found |= self.file.steps[key]
        return found

    def holds(self, node: ast.AST, tainted: Collection[str]) -> bool:
        """Whether a value holds a result as it is."""
        if isinstance(node, ast.Lambda):
            return False
        if isinstance(node, ast.Call):
            name = word(node.func)
            if name in self.file.results or name in self.passed:
                return True
            if name in SOLVERS or name in ("len", "print", *self.file.functions):
                return False
            return any(self.holds(part, tainted) for part in _arguments(node)) or (
                isinstance(node.func, ast.Attribute) and self.holds(node.func.value, tainted)
            )
        if isinstance(node, ast.Name):
            return node.id in tainted
        if isinstance(node, ast.Attribute):
            return ast.unparse(node) in tainted
        if isinstance(node, ast.Subscript):
            return self.holds(node.value, tainted)
        return any(self.holds(part, tainted) for part in ast.iter_child_nodes(node))

    def _changes(self, node: ast.AST, tainted: Collection[str]) -> bool:
        """Whether arithmetic is done with a result."""
        if isinstance(node, ast.AugAssign):
            return self.holds(node.value, tainted) or _root(node.target) in tainted
        if isinstance(node, ast.BinOp):
            return self.holds(node.left, tainted) or self.holds(node.right, tainted)
        if isinstance(node, ast.UnaryOp) and not isinstance(node.op, ast.Not | ast.UAdd):
            return self.holds(node.operand, tainted)
        return False

    # calls, functions without a name, accelerations

    def _call(self, node: ast.Call) -> Iterator[ast.AST]:
        name = word(node.func)
        hides = name in HIDDEN | LINEAR | INSIDE or any(k.arg == "out" for k in node.keywords)
        wrong = self.file.calls.wrong(node, id(node) in self.right, self.moving)
        opens = name == "vars" or (name == "setattr" and bool(self.file.held))
        other = self._is_excluded(node) or self._is_reversed(node) or self._sets_attribute(node)
        if hides or opens or wrong or other:
            yield node

    def _sets_attribute(self, node: ast.Call) -> bool:
        """Whether a maker gets what a judged method uses and the scene has no name for."""
        maker = self.file.makers.get(word(node.func))
        if maker is None:
            return False
        names = [a.arg for a in maker.args.args if a.arg not in ("self", "cls")]
        given = {k.arg for k in node.keywords if k.arg} | {*names[: len(node.args)]}
        kept = [
            line.value for line in _assigned([*_within(maker.body)])
            if any(name.rpartition(".")[2] in self.file.held for name in line.targets)
        ]  # fmt: skip
        used = {word(n) for value in kept for n in ast.walk(value)}
        return any(self.file.naming.lookup(name) is None for name in given & used)

    def _changes_object(self, node: ast.Assign | ast.AugAssign) -> bool:
        """Whether an object gets what a judged method uses and the scene has no name for."""
        targets = node.targets if isinstance(node, ast.Assign) else [node.target]
        places = [p for target in targets for p in ast.walk(target) if isinstance(p, ast.Attribute)]
        return any(
            p.attr in self.file.held
            and word(p.value) not in ("self", "cls")
            and self.file.naming.lookup(p.attr) is None
            for p in places
        )

    def _is_excluded(self, node: ast.Call) -> bool:
        """Whether a call gives a parameter a number that it cannot have."""
        excluded = self.file.calls.excluded
        pairs = [(k.arg, k.value) for k in node.keywords if k.arg]
        if (function := self.file.called(node)) is not None:
            names = [a.arg for a in function.args.args if a.arg not in ("self", "cls")]
            pairs += zip(names, node.args, strict=False)
        return any(excluded(name, value) for name, value in pairs)

    def _is_reversed(self, node: ast.Call) -> bool:
        """Whether a solver is handed a function that takes the time for the state."""
        if word(node.func) not in (*TIME_FIRST, *STATE_FIRST) or not node.args:
            return False
        early = word(node.func) in TIME_FIRST or any(
            k.arg == "tfirst" and word_of_truth(k.value) for k in node.keywords
        )
        handed = node.args[0]
        if isinstance(handed, ast.Name):
            handed = self.file.fixed.get(handed.id, handed)
        function = handed if isinstance(handed, ast.Lambda) else self.file.handed(handed)
        return function is not None and self.file.calls.reversed_by(function, early)

    def _reorders(self, node: ast.AST, tainted: Collection[str]) -> bool:
        """Whether it has entries of a result in another order."""
        if isinstance(node, ast.Subscript):
            back = any(
                isinstance(n, ast.Slice) and isinstance(n.step, ast.UnaryOp)
                for n in ast.walk(node.slice)
            )
            chosen = isinstance(node.slice, ast.List) and _is_unsorted(node.slice.elts)
            return (back or chosen) and self.holds(node.value, tainted)
        if not isinstance(node, ast.List | ast.Tuple) or not isinstance(node.ctx, ast.Load):
            return False
        parts = [n for n in node.elts if isinstance(n, ast.Subscript)
                 and self.holds(n.value, tainted)]  # fmt: skip
        single = len({ast.unparse(n.value) for n in parts}) == 1
        if single and _is_unsorted([n.slice for n in parts]):
            return True
        labels = [*map(word, node.elts)]
        return any(
            [name for name in labels if name in line] != [name for name in line if name in labels]
            for line in self.unpacked
        )

    def _is_plain(self, node: ast.Lambda) -> bool:
        """Whether a function without a name calls one of the file, or takes a part of something."""
        body = node.body
        if self.file.calls.is_first_order(body):
            return True
        if isinstance(body, ast.Call) and word(body.func) in self._own():
            return True
        for one in ast.walk(body):
            if isinstance(one, (*ARITHMETIC, ast.List, ast.Tuple)):
                return False
            if isinstance(one, ast.Call) and isinstance(one.func, ast.Attribute):
                if word(one.func.value) in ("np", "numpy", "math", "jnp", "operator"):
                    return False
            elif isinstance(one, ast.Call) and word(one.func) not in COLLECTED | self._own():
                return False
        return True

    def _is_motion(self, node: ast.Assign) -> bool:
        """Whether a line computes an acceleration, or a coordinate as a function of time."""
        if id(node) in self.right:
            return False
        if not any(isinstance(n, ast.BinOp) and _roots(n) for n in _within([node.value])):
            return False
        names = [n.id for t in node.targets for n in ast.walk(t) if isinstance(n, ast.Name)]
        orders = {self._order(name) for name in names} - {None}
        waves = (n for n in _within([node.value]) if isinstance(n, ast.Call)
                 and word(n.func) in WAVES)  # fmt: skip
        return 2 in orders or (bool(orders) and any(_roots(n) & {*TIMES} for n in waves))

    def _exchanges(self, node: ast.Assign) -> bool:
        """Whether parameters of judged functions become one another, or are made of themselves."""
        lines = [*_assigned([node])]
        return any(
            self.file.calls.exchanged(name.rpartition(".")[2], line.value)
            for line in lines for name in line.targets if len(line.targets) == 1
        )  # fmt: skip

    def _is_scaled(self, node: ast.AugAssign) -> bool:
        counts = isinstance(node.value, ast.Constant) and node.value.value == 1
        return word(node.target) in self.file.calls.parameters and not counts

    def _order(self, name: str) -> int | None:
        found = self.file.naming.lookup(name)
        scene = self.file.naming.vocabulary.scene
        coordinates = {plain_symbol(q).name for q in scene.coordinates}
        speeds = {plain_symbol(u).name for u, _ in scene.speeds}
        if found is None or found[0] not in coordinates | speeds:
            return None
        return found[1] + (found[0] in speeds)


def _within(body: Iterable[ast.AST]) -> Iterator[ast.AST]:
    """All nodes, but those of functions and classes that are defined inside."""
    for one in body:
        yield one
        if not isinstance(one, (*DEFINED, ast.ClassDef)):
            yield from _within(ast.iter_child_nodes(one))


def _assigned(inside: Iterable[ast.AST]) -> Iterator[_Line]:
    for one in inside:
        match one:
            case ast.Assign(targets=targets, value=value):
                if len(targets) == 1 and isinstance(targets[0], ast.Tuple) and isinstance(
                    value, ast.Tuple) and len(value.elts) == len(targets[0].elts):  # fmt: skip
                    for target, part in zip(targets[0].elts, value.elts, strict=True):
                        yield _Line(one, frozenset(_stored(target)), part)
                else:
                    names = frozenset(n for t in targets for n in _stored(t))
                    yield _Line(one, names, value)
            case ast.AnnAssign(target=target, value=ast.expr() as value):
                yield _Line(one, frozenset(_stored(target)), value)
            case ast.AugAssign(target=target, value=value):
                both = ast.Tuple([ast.parse(ast.unparse(target), mode="eval").body, value])
                yield _Line(one, frozenset(_stored(target)), both)
            case ast.NamedExpr(target=target, value=value):
                yield _Line(one, frozenset(_stored(target)), value)
            case ast.For(target=target, iter=value) | ast.comprehension(target=target, iter=value):
                yield _Line(one, frozenset(_stored(target)), value)
            case ast.Expr(value=ast.Call(func=ast.Attribute(value=base)) as call):
                # Objects are changed by their methods.
                yield _Line(one, frozenset((_root(base),)) - {""}, ast.Tuple(_arguments(call)))


def _stored(target: ast.AST) -> Iterator[str]:
    if isinstance(target, ast.Tuple | ast.List):
        for part in target.elts:
            yield from _stored(part)
    elif isinstance(target, ast.Starred):
        yield from _stored(target.value)
    elif root := _root(target):
        yield root


def _root(node: ast.AST) -> str:
    """What a place is a part of: th of th[i+1], self.w of self.w[0]."""
    while isinstance(node, ast.Subscript | ast.Starred):
        node = node.value
    if isinstance(node, ast.Name):
        return node.id
    if isinstance(node, ast.Attribute):
        base = _root(node.value)
        return f"{base}.{node.attr}" if base else ""
    return ""


def _roots(node: ast.AST) -> set[str]:
    """What an expression reads."""
    if isinstance(node, ast.Attribute | ast.Name) and (root := _root(node)):
        return {root, *([root.rpartition(".")[0]] if "." in root else [])}
    return {name for part in ast.iter_child_nodes(node) for name in _roots(part)}


def _roots_of(nodes: Iterable[ast.AST]) -> set[str]:
    return {name for node in nodes for name in _roots(node)}


def _circles(lines: Sequence[_Line]) -> dict[str, frozenset[str]]:
    """Of each name those that it depends on and that depend on it; none for others."""
    ahead: dict[str, set[str]] = {}
    for line in lines:
        for name in line.targets:
            ahead.setdefault(name, set()).update(_roots(line.value))
    far = {name: reachable(reads, ahead) for name, reads in ahead.items()}
    return {
        name: frozenset({n for n in reached if name in far.get(n, ())})
        for name, reached in far.items() if name in reached
    }  # fmt: skip


def _feeding(lines: Sequence[_Line], names: Collection[str]) -> set[str]:
    """Names of which some are made, these among them."""
    found, before = {*names}, -1
    while len(found) != before:
        before = len(found)
        for line in lines:
            if line.targets & found:
                found |= _roots(line.value)
    return found


def _is_unsorted(places: Sequence[ast.expr]) -> bool:
    numbers = [p.value for p in places if isinstance(p, ast.Constant) and isinstance(p.value, int)]
    return numbers != sorted(numbers)


def _arguments(node: ast.Call) -> list[ast.expr]:
    return [*node.args, *(k.value for k in node.keywords)]


def _is_count(node: ast.AST) -> bool:
    match node:
        case ast.BinOp(left=ast.Name(), op=ast.Add() | ast.Sub(), right=ast.Constant(value=int())):
            return True
    return False

"""Loops of a Python file that compute a motion by a law of their own.

w += -g/l*sin(th)*dt        in a loop, a comprehension or a method
th, w = step(th, w)         of no function that is judged

A whitelist for what is computed from a turn of a loop to the next one. What an integrator advances
with a judged function is right.
"""

import ast
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from mechanics.claims.code.around.python_form import unwrapped_angle, word
from mechanics.claims.code.around.python_functions import Defined, within
from mechanics.claims.code.python.changed_numbers import MAKES
from mechanics.claims.code.reachability import reachable
from mechanics.claims.names import Naming

COMPREHENSIONS = (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)
ARITHMETIC = (ast.BinOp, ast.UnaryOp, ast.AugAssign)
COUNTS = frozenset(("t", "time", "ti", "t_now", "tt"))
Steps = Callable[[Sequence[ast.stmt]], set[str]]
"""What a block advances as an integrator does."""


@dataclass(frozen=True)
class Line:
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


@dataclass(frozen=True)
class Scope:
    """Lines of a function, or of the file outside of functions.

    Attributes
    ----------
    body : sequence of ast.stmt
    function : ast.FunctionDef or None
    naming : Naming
        What moves.
    moving : collection of str
        Names of arguments of judged functions that stand for coordinates, speeds and parameters.
    inert : set of str
        Calls that leave what they are given as it is, and functions of the file.
    steps : callable
    """

    body: Sequence[ast.stmt]
    function: Defined | None
    naming: Naming
    moving: Collection[str]
    inert: set[str]
    steps: Steps

    @cached_property
    def inside(self) -> list[ast.AST]:
        """All nodes."""
        return [*within(self.body)]

    @cached_property
    def lines(self) -> list[Line]:
        """What gives names values."""
        return [*assigned(self.inside)]

    @cached_property
    def turns(self) -> list[Sequence[ast.stmt]]:
        """What is done again and again: bodies of loops, and what a comprehension assigns."""
        loops: list[Sequence[ast.stmt]] = [
            n.body for n in self.inside if isinstance(n, ast.For | ast.While | ast.AsyncFor)
        ]
        inner = ([n for n in within([one]) if isinstance(n, ast.NamedExpr)]
                 for one in self.inside if isinstance(one, COMPREHENSIONS))  # fmt: skip
        return loops + [[ast.copy_location(ast.Assign([n.target], n.value), n) for n in parts]
                        for parts in inner if parts]  # fmt: skip

    @cached_property
    def right(self) -> set[int]:
        """Nodes of lines that advance a state as an integrator does, and of what these use."""
        whole = [self.function.body] if self.function is not None else []
        found: set[int] = set()
        for body in (*self.turns, *whole):
            lines = [*assigned(within(body))]
            steps, groups = self.steps(body), _circles(lines)
            feeding = _feeding(lines, steps)
            for line in lines:
                circle = {*line.targets}.union(*(groups.get(n, ()) for n in line.targets))
                if circle & steps or line.targets <= feeding:
                    found |= {id(n) for n in (line.node, *within([line.value]))}
        return found


def laws(scope: Scope) -> Iterator[ast.AST]:
    """Lines by which a value becomes that of the next turn, or the next call."""
    for body in scope.turns:
        yield from _block(scope, body, None)
    if scope.function is not None and scope.function.name not in MAKES:
        yield from _block(scope, scope.function.body, _persisting(scope))
        yield from _again(scope)


def _persisting(scope: Scope) -> set[str]:
    """What of a function is still there when it is called again."""
    assert scope.function is not None
    arguments = {a.arg for a in ast.walk(scope.function.args) if isinstance(a, ast.arg)}
    found = {n for g in scope.inside if isinstance(g, ast.Global | ast.Nonlocal) for n in g.names}
    for one in scope.inside:
        if isinstance(one, ast.Subscript | ast.Attribute) and isinstance(
            one.ctx, ast.Store | ast.Del
        ):
            root = root_in(one)
            local = {t for line in scope.lines for t in line.targets} - arguments
            if root not in local or "." in root:
                found.add(root)
        elif isinstance(one, ast.AugAssign) and isinstance(one.target, ast.Name):
            found |= {one.target.id} & arguments
    return found


def _block(
    scope: Scope, body: Sequence[ast.stmt], persisting: set[str] | None
) -> Iterator[ast.AST]:
    """Lines of what is done again and again that are a law, and none that is judged."""
    lines = [*assigned(within(body))]
    groups = _circles(lines)
    for line in (one for one in lines if id(one.node) not in scope.right):
        for circle in (groups.get(name, frozenset()) for name in line.targets):
            lasting = persisting is None or circle & persisting
            if circle and lasting and not _keeps(scope, line, circle):
                yield line.node


def _again(scope: Scope) -> Iterator[ast.AST]:
    """Calls of a function by itself with other values: the turns of a loop."""
    assert scope.function is not None
    names = [a.arg for a in scope.function.args.args if a.arg not in ("self", "cls")]
    for one in scope.inside:
        if isinstance(one, ast.Call) and word(one.func) == scope.function.name:
            pairs = [*zip(names, one.args, strict=False)]
            pairs += [(k.arg, k.value) for k in one.keywords if k.arg]
            target = ast.Tuple([ast.Name(n, ast.Store()) for n, _ in pairs], ast.Store())
            value = ast.Tuple([v for _, v in pairs], ast.Load())
            step = ast.copy_location(ast.Assign([target], value), one)
            found = [*_block(scope, [step], {*names})]
            if found and any(isinstance(n, ARITHMETIC) for n in ast.walk(value)):
                rest = [v for n, v in pairs if n not in COUNTS and not _is_count(v)]
                if any(isinstance(n, ARITHMETIC) for v in rest for n in ast.walk(v)):
                    yield one


def _keeps(scope: Scope, line: Line, circle: frozenset[str]) -> bool:
    """Whether a line that depends on its own last value only counts, collects, or passes on."""
    match line.node:
        case ast.AugAssign(target=ast.Name() | ast.Attribute() as target, value=value):
            return _counts(scope, word(target), value)
        case ast.AugAssign(
            target=ast.Subscript(value=ast.Name(id=name)), value=ast.Constant(value=int()) as one
        ):
            return _counts(scope, name, one)
        case ast.AugAssign():
            return False
        case ast.Assign(
            targets=[ast.Name(id=name)],
            value=ast.BinOp(left=ast.Name(id=same), op=ast.Add() | ast.Sub(), right=value),
        ) if name == same:
            return _counts(scope, name, value)
        case ast.Expr(value=ast.Call(func=ast.Attribute(attr="integrate"))):
            return True  # of a solver
    wraps = [n for n in within([line.value]) if isinstance(n, ast.BinOp)
             and unwrapped_angle(n) is not None]  # fmt: skip
    skipped = {id(n) for wrap in wraps for n in ast.walk(wrap)}
    return not any(
        roots_in(one) & circle and not _collects(scope, one)
        for one in within([line.value]) if id(one) not in skipped
    )  # fmt: skip


def _collects(scope: Scope, node: ast.AST) -> bool:
    """Whether an expression leaves what it is made of as it is."""
    if isinstance(node, ast.Call):
        known = word(node.func) in scope.inert
        return known or not _roots_of(_arguments(node))
    return not isinstance(node, ast.BinOp | ast.UnaryOp)


def _counts(scope: Scope, name: str, value: ast.expr) -> bool:
    """Whether a name only counts turns, or time."""
    if name in scope.moving or scope.naming.lookup(name) is not None:
        return False
    if isinstance(value, ast.Constant):
        return isinstance(value.value, int | str) or name in COUNTS
    if isinstance(value, ast.Name | ast.Attribute):
        return name in COUNTS
    return isinstance(value, ast.List | ast.Tuple | ast.JoinedStr)


def assigned(inside: Iterable[ast.AST]) -> Iterator[Line]:
    """What gives names values, line by line."""
    for one in inside:
        match one:
            case ast.Assign(targets=targets, value=value):
                if len(targets) == 1 and isinstance(targets[0], ast.Tuple) and isinstance(
                    value, ast.Tuple) and len(value.elts) == len(targets[0].elts):  # fmt: skip
                    for target, part in zip(targets[0].elts, value.elts, strict=True):
                        yield Line(one, frozenset(_stored(target)), part)
                else:
                    names = frozenset(n for t in targets for n in _stored(t))
                    yield Line(one, names, value)
            case ast.AnnAssign(target=target, value=ast.expr() as value):
                yield Line(one, frozenset(_stored(target)), value)
            case ast.AugAssign(target=target, value=value):
                both = ast.Tuple([ast.parse(ast.unparse(target), mode="eval").body, value])
                yield Line(one, frozenset(_stored(target)), both)
            case ast.NamedExpr(target=target, value=value):
                yield Line(one, frozenset(_stored(target)), value)
            case ast.For(target=target, iter=value) | ast.comprehension(target=target, iter=value):
                yield Line(one, frozenset(_stored(target)), value)
            case ast.Expr(value=ast.Call(func=ast.Attribute(value=base)) as call):
                # Objects are changed by their methods.
                yield Line(one, frozenset((root_in(base),)) - {""}, ast.Tuple(_arguments(call)))


def _stored(target: ast.AST) -> Iterator[str]:
    if isinstance(target, ast.Tuple | ast.List):
        for part in target.elts:
            yield from _stored(part)
    elif isinstance(target, ast.Starred):
        yield from _stored(target.value)
    elif root := root_in(target):
        yield root


def root_in(node: ast.AST) -> str:
    """What a place is a part of: th of th[i+1], self.w of self.w[0]."""
    match node:
        case ast.Name(id=name):
            return name
        case (ast.Attribute(value=inner, attr=part)
              | ast.Subscript(value=inner, slice=ast.Constant(value=str(part)))):  # fmt: skip
            base = root_in(inner)
            return f"{base}.{part}" if base else ""
        case ast.Subscript(value=inner) | ast.Starred(value=inner):
            return root_in(inner)
    return ""


def roots_in(node: ast.AST) -> set[str]:
    """What an expression reads."""
    if "." in (root := root_in(node)) or (root and not isinstance(node, ast.Subscript)):
        return {root, *([root.rpartition(".")[0]] if "." in root else [])}
    return {name for part in ast.iter_child_nodes(node) for name in roots_in(part)}


def _roots_of(nodes: Iterable[ast.AST]) -> set[str]:
    return {name for node in nodes for name in roots_in(node)}


def _circles(lines: Sequence[Line]) -> dict[str, frozenset[str]]:
    """Of each name those that it depends on and that depend on it; none for others."""
    ahead: dict[str, set[str]] = {}
    for line in lines:
        for name in line.targets:
            ahead.setdefault(name, set()).update(roots_in(line.value))
    far = {name: reachable(reads, ahead) for name, reads in ahead.items()}
    return {
        name: frozenset({n for n in reached if name in far.get(n, ())})
        for name, reached in far.items() if name in reached
    }  # fmt: skip


def _feeding(lines: Sequence[Line], names: Collection[str]) -> set[str]:
    """Names of which some are made, these among them."""
    found, before = {*names}, -1
    while len(found) != before:
        before = len(found)
        for line in lines:
            if line.targets & found:
                found |= roots_in(line.value)
    return found


def _arguments(node: ast.Call) -> list[ast.expr]:
    return [*node.args, *(k.value for k in node.keywords)]


def _is_count(node: ast.AST) -> bool:
    match node:
        case ast.BinOp(left=ast.Name(), op=ast.Add() | ast.Sub(), right=ast.Constant(value=int())):
            return True
    return False

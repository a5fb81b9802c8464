"""Functions of a Python file as the interpreter knows them: judged ones, and others.

def rate(t, y, m, l, g)     takes t, y and parameters, gives the rates of y
def rk4(f, t, y, h)         calls f, which is any rate of a state
"""

import ast
from collections.abc import Collection, Iterable, Iterator, Mapping
from fractions import Fraction

from mechanics.claims.code.around.interpreter_values import FileFunction, JudgedFunction, SceneNames
from mechanics.claims.code.around.python_form import (
    DEFINED,
    PythonFile,
    arguments_of,
    block,
    defaults_of,
    word,
)

Defined = ast.FunctionDef | ast.AsyncFunctionDef
TIMES = frozenset(("t", "time", "ti", "t0", "tn", "t_i", "t_n", "tk", "_t", "_"))


def words_in(node: ast.AST) -> set[str]:
    """Names and attributes in a tree."""
    return {*map(word, ast.walk(node))} - {""}


def within(body: Iterable[ast.AST]) -> Iterator[ast.AST]:
    """All nodes, but those of functions and classes that are defined inside."""
    for one in body:
        yield one
        if not isinstance(one, (*DEFINED, ast.ClassDef)):
            yield from within(ast.iter_child_nodes(one))


def judged_function(node: Defined, names: SceneNames) -> JudgedFunction:
    """A judged function, or one that it calls, by the names of its arguments.

    Parameters
    ----------
    node : ast.FunctionDef
    names : SceneNames
    """
    takes = tuple(arguments_of(node.args))
    columns = {m.name: tuple(m.meaning.split()) for m in names.naming.guessed if " " in m.meaning
               } if names.naming is not None else {}  # fmt: skip
    meanings = {n: columns.get(n) or _single(n, names) for n in takes}
    meanings = {n: words for n, words in meanings.items() if words}
    if not any({*words} & {*names.state} for words in meanings.values()):
        parted = _parted(node)
        meanings |= {n: names.state for n in takes if n in parted and n not in meanings}
    unused = frozenset({*takes} - {name for line in node.body for name in words_in(line)})
    gives, defaults = _gives(node, meanings, names), _defaults(node, meanings)
    time = next((n for n in takes if n in TIMES and n not in unused), "")
    return JudgedFunction(node.name, takes, meanings, (), gives, {}, defaults, unused, time)


def _single(name: str, names: SceneNames) -> tuple[str, ...]:
    meaning = "" if name in TIMES else names.meaning(name)
    known = {*names.state, *names.inputs, *names.parameters}
    return (meaning,) if meaning in known else ()


def _gives(
    node: Defined, meanings: Mapping[str, tuple[str, ...]], names: SceneNames
) -> tuple[str, ...]:
    """Whose rates a function gives, by how many entries it returns, and by what it takes."""
    asked = [w for words in meanings.values() for w in words if w in names.state]
    whole = [words for words in meanings.values() if {*words} >= {*names.state}]
    order = whole[0] if whole else tuple(asked) if {*asked} == {*names.state} else names.state
    last = [n.value for n in within(node.body) if isinstance(n, ast.Return) and n.value][-1:]
    returned = last[0] if last else None
    while isinstance(returned, ast.Call) and len(returned.args) == 1:
        returned = returned.args[0]
    size = len(returned.elts) if isinstance(returned, ast.List | ast.Tuple) else 0
    if not asked:
        return ()
    if size == len(names.state) or (not size and whole):
        return order
    return names.speeds if size in (0, len(names.speeds)) else ()


def _defaults(node: Defined, meanings: Collection[str]) -> dict[str, Fraction]:
    """Numbers that arguments without a meaning have where a call gives none."""
    return {
        name: Fraction(str(v.value))
        for name, v in defaults_of(node.args)
        if name not in meanings and isinstance(v, ast.Constant)
        and isinstance(v.value, int | float) and not isinstance(v.value, bool)
    }  # fmt: skip


def _parted(node: Defined) -> set[str]:
    """Names of a function of which parts are taken."""
    found = set()
    for one in ast.walk(node):
        match one:
            case ast.Subscript(value=ast.Name(id=name)):
                found.add(name)
            case ast.Assign(targets=[ast.Tuple()], value=ast.Name(id=name)):
                found.add(name)
    return found


def passed_function(name: str, inside: Iterable[ast.AST], names: SceneNames) -> JudgedFunction:
    """A function that is an argument of another one, by the first call of it: f(t, y)."""
    calls = (n for n in inside if isinstance(n, ast.Call) and word(n.func) == name)
    args = next((one.args for one in calls), [])
    states = [
        k for k, part in enumerate(args)
        if not isinstance(part, ast.Constant | ast.Starred) and words_in(part).isdisjoint(TIMES)
    ]  # fmt: skip
    takes = tuple(f"argument {k}" for k in range(len(args)))
    meanings = {f"argument {k}": names.state for k in states[:1]}
    return JudgedFunction(name, takes, meanings, (), names.state if meanings else ())


def file_function(node: Defined, file: PythonFile) -> FileFunction:
    """Another function, as its callers see it."""
    takes = tuple(arguments_of(node.args))
    inside = [*within(node.body)]
    outer = {n for g in inside if isinstance(g, ast.Global | ast.Nonlocal) for n in g.names}
    stored = {n.id for n in inside if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)}
    filled = {word(n.value) for n in inside if isinstance(n, ast.Subscript)
              and isinstance(n.ctx, ast.Store)}  # fmt: skip
    return FileFunction(
        takes, (), block(node.body, file), frozenset(filled & {*takes}), frozenset(stored - outer)
    )

"""Functions, methods and lambdas of a file that are neither judged nor called by what is judged.

class Sim: def rate(...)    async def f    yield    {"acc": lambda ...}    np.vectorize(lambda ...)

What only passes a function of the file on, as to a solver, and shows the result, claims nothing.
"""

import ast
from collections.abc import Iterator, Set

Function = ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda
DEFINED = (ast.FunctionDef, ast.AsyncFunctionDef)
ARITHMETIC = (ast.BinOp, ast.UnaryOp, ast.AugAssign)


def unjudged_functions(code: str, judged: Set[str]) -> Iterator[str]:
    """What is named as not judged, in words.

    Parameters
    ----------
    code : str
        The file.
    judged : set of str
        Names of functions and methods that are judged, or named elsewhere.
    """
    tree = ast.parse(code)
    reached = _reached(tree, judged)
    own = {n.name for n in ast.walk(tree) if isinstance(n, DEFINED)}
    for line in tree.body:
        yield from _in(line, reached, judged, own)


def passing(code: str) -> set[str]:
    """Names of functions that only pass functions of the file on, or show what they are given."""
    tree = ast.parse(code)
    own = {n.name for n in ast.walk(tree) if isinstance(n, DEFINED)}
    return {n.name for n in tree.body if isinstance(n, DEFINED) and _is_inert(n, own)}


def _in(node: ast.AST, reached: set[str], judged: Set[str], own: set[str]) -> Iterator[str]:
    match node:
        case ast.ClassDef(name=kind) if kind in judged:
            return
        case ast.ClassDef(name=kind, body=body):
            for part in body:
                if not isinstance(part, DEFINED):
                    yield from _in(part, reached, judged, own)
                elif not (kind in reached and part.name in reached) and not _is_inert(part, own):
                    yield f"the method {kind}.{part.name} in line {part.lineno}"
        case ast.FunctionDef() | ast.AsyncFunctionDef():
            if node.name not in reached and not _is_inert(node, own):
                yield f"the function {node.name} in line {node.lineno}"
        case ast.Assign(targets=[ast.Name(id=name)], value=ast.Lambda()) if name in reached:
            return
        case ast.Lambda():
            if not _passes(node, own):
                yield f"the function in line {node.lineno}"
        case _:
            for child in ast.iter_child_nodes(node):
                yield from _in(child, reached, judged, own)


def _reached(tree: ast.Module, judged: Set[str]) -> set[str]:
    """Names of the file, and attributes, that what is judged speaks of."""
    parts: dict[str, set[str]] = {}
    for line in tree.body:
        if isinstance(line, ast.ClassDef):
            for part in line.body:
                if isinstance(part, DEFINED):
                    parts.setdefault(part.name, set()).update(_words(part))
                    if part.name in judged and not _is_at_top(tree, part.name):
                        parts.setdefault(part.name, set()).update({line.name})
            parts.setdefault(line.name, set()).update(
                {"__init__", "__post_init__", "__new__", "__call__", *map(_name, line.bases)}
            )
        elif isinstance(line, DEFINED):
            parts.setdefault(line.name, set()).update(_words(line))
        elif isinstance(line, ast.Assign):
            for target in line.targets:
                if isinstance(target, ast.Name):
                    parts.setdefault(target.id, set()).update(_words(line.value))
    found, todo = {*judged}, [*judged]
    while todo:
        new = parts.get(todo.pop(), set()) - found
        found |= new
        todo += new
    return found


def _is_at_top(tree: ast.Module, name: str) -> bool:
    return any(isinstance(line, DEFINED) and line.name == name for line in tree.body)


def _words(node: ast.AST) -> set[str]:
    return {*map(_name, ast.walk(node))} - {""}


def _name(node: ast.AST) -> str:
    return getattr(node, "id", "") or getattr(node, "attr", "")


def _is_inert(node: Function, own: set[str]) -> bool:
    """Whether a function passes functions of the file on, or only shows what it is given."""
    inside = [*ast.walk(node)]
    strange = (ast.Yield, ast.YieldFrom, ast.Await)
    if isinstance(node, ast.AsyncFunctionDef) or any(isinstance(n, strange) for n in inside):
        return False
    if isinstance(node, ast.FunctionDef) and node.name in ("__init__", "__post_init__", "__repr__"):
        return True
    made = {
        _name(target)
        for n in inside if isinstance(n, ast.Assign) and _calls(n.value, own)
        for target in n.targets
    }  # fmt: skip
    for one in inside:
        if isinstance(one, ARITHMETIC) and (_calls(one, own) or _words(one) & (made - {""})):
            return False
    gives = any(isinstance(n, ast.Return) and n.value is not None for n in inside)
    fills = any(isinstance(n, ast.Subscript) and isinstance(n.ctx, ast.Store) for n in inside)
    return not (gives or fills) or bool(_words(node) & own)


def _calls(node: ast.AST, own: set[str]) -> bool:
    return any(isinstance(n, ast.Call) and _name(n.func) in own for n in ast.walk(node))


def _passes(node: ast.Lambda, own: set[str]) -> bool:
    """Whether a function without a name calls one of the file, or takes a part of something."""
    if isinstance(node.body, ast.Call):
        return _name(node.body.func) in own
    plain = (ast.Name, ast.Attribute, ast.Subscript, ast.Constant, ast.Load)
    return all(isinstance(n, plain) for n in ast.walk(node.body))

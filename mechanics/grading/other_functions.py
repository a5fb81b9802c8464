"""Functions, methods and lambdas of a file that are neither judged nor called by what is judged.

class Sim: def rate(...)    async def f    yield    {"acc": lambda ...}    np.vectorize(lambda ...)

What uses functions of the file is looked at line by line (`lines_around`); what only shows what it
is given, and an integrator that is given a function, claim nothing.
"""

import ast
from collections.abc import Iterator, Set

from mechanics.claims.code.around.python_form import DEFINED, word
from mechanics.claims.code.around.python_functions import Defined, words_in
from mechanics.claims.code.around.python_laws import ARITHMETIC
from mechanics.claims.code.around.python_lines import integrators, reached

PLAIN = (ast.Lambda, ast.arguments, ast.arg, ast.Name, ast.Attribute, ast.Subscript, ast.Constant,
         ast.Load)  # fmt: skip
"""What a function without a name has that takes a part of something."""


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
    near = reached(tree, judged) | integrators(tree)
    own = {n.name for n in ast.walk(tree) if isinstance(n, DEFINED)}
    for line in tree.body:
        yield from _in(line, near, judged, own)


def passing(code: str) -> set[str]:
    """Names of functions that only pass functions of the file on, or show what they are given."""
    tree = ast.parse(code)
    own = {n.name for n in ast.walk(tree) if isinstance(n, DEFINED)}
    functions = [n for n in tree.body if isinstance(n, DEFINED)]
    return {n.name for n in functions if _is_inert(n, own) and not _computes(n, own)}


def _in(node: ast.AST, near: set[str], judged: Set[str], own: set[str]) -> Iterator[str]:
    match node:
        case ast.ClassDef(name=kind) if kind in judged:
            return
        case ast.ClassDef(name=kind, body=body):
            for part in body:
                if not isinstance(part, DEFINED):
                    yield from _in(part, near, judged, own)
                elif not (kind in near and part.name in near) and not _is_inert(part, own):
                    yield f"the method {kind}.{part.name} in line {part.lineno}"
        case ast.FunctionDef() | ast.AsyncFunctionDef():
            if node.name not in near and not _is_inert(node, own):
                yield f"the function {node.name} in line {node.lineno}"
        case ast.Assign(targets=[ast.Name(id=name)], value=ast.Lambda()) if name in near:
            return
        case ast.Lambda():
            if not (words_in(node.body) & own or all(isinstance(n, PLAIN) for n in ast.walk(node))):
                yield f"the function in line {node.lineno}"
        case _:
            for child in ast.iter_child_nodes(node):
                yield from _in(child, near, judged, own)


def _is_inert(node: Defined, own: set[str]) -> bool:
    """Whether a function uses functions of the file, or only shows what it is given."""
    inside = [*ast.walk(node)]
    strange = (ast.Yield, ast.YieldFrom, ast.Await)
    if isinstance(node, ast.AsyncFunctionDef) or any(isinstance(n, strange) for n in inside):
        return False
    if node.name in ("__init__", "__post_init__", "__repr__"):
        return True
    gives = any(isinstance(n, ast.Return) and n.value is not None for n in inside)
    fills = any(isinstance(n, ast.Subscript) and isinstance(n.ctx, ast.Store) for n in inside)
    return not (gives or fills) or bool(words_in(node) & own)


def _computes(node: Defined, own: set[str]) -> bool:
    """Whether arithmetic is done with what functions of the file return."""
    inside = [*ast.walk(node)]
    made = {
        word(target)
        for n in inside if isinstance(n, ast.Assign) and _calls(n.value, own)
        for target in n.targets
    }  # fmt: skip
    return any(
        isinstance(one, ARITHMETIC) and (_calls(one, own) or bool(words_in(one) & (made - {""})))
        for one in inside
    )


def _calls(node: ast.AST, own: set[str]) -> bool:
    return any(isinstance(n, ast.Call) and word(n.func) in own for n in ast.walk(node))

"""Values of a script that are not there at its end, and formulas that were computed to numbers.

eq = Eq(...); eq = Eq(...)        eq2 = Eq(...); del eq2        the first of them is lost
acc = -3*g/(2*l)*np.sin(theta)    of arrays                     a formula that is numbers only
"""

import ast
from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np
from sympy import Basic
from sympy.matrices import MatrixBase

from mechanics.grading.script_formulas import is_name

KEEP = "assigned by the file"
"""The name of what learns of values that are lost: no name that a file can have."""
LOST = "it is overwritten or deleted later, and nothing uses it"
FUNCTIONS = frozenset(("sin", "cos", "tan", "sqrt", "hypot"))


def keeping(tree: ast.Module) -> ast.Module:
    """The file, telling what it assigns at its top level and loses before anything uses it."""
    for place, node in enumerate(tree.body):
        if not isinstance(node, ast.Assign):
            continue
        own = [t.id for t in node.targets if isinstance(t, ast.Name)]
        if lost := [name for name in own if _is_lost(name, tree.body[place + 1 :])]:
            arguments = [ast.Constant(f"{lost[0]} in line {node.lineno}"), node.value]
            node.value = ast.copy_location(
                ast.Call(ast.Name(KEEP, ast.Load()), arguments, []), node.value
            )
    return tree


def _is_lost(name: str, after: list[ast.stmt]) -> bool:
    """Whether a name is assigned again or deleted, and not used before."""
    for node in after:
        uses = [one for one in ast.walk(node) if isinstance(one, ast.Name) and one.id == name]
        if any(isinstance(one.ctx, ast.Load) for one in uses):
            return False
        if uses:
            return isinstance(node, ast.Assign | ast.AnnAssign | ast.Delete)
    return False


def keeper(found: dict[str, None]) -> Callable[[str, Any], Any]:
    """What is told of each, and keeps the words for those that are formulas."""

    def kept(words: str, value: Any) -> Any:
        if isinstance(value, Basic | MatrixBase) and not is_name(value):
            found[words] = None
        return value

    return kept


def numbers_of_formulas(code: str, names: Mapping[str, Any], used: set[str]) -> Iterator[str]:
    """Names of numbers that the file computes by a formula, and that nothing is judged by."""
    tree = ast.parse(code)
    for node in tree.body:
        if not isinstance(node, ast.Assign) or not any(map(_is_formula, ast.walk(node.value))):
            continue
        for target in node.targets:
            name = target.id if isinstance(target, ast.Name) else ""
            if name and name not in used and _is_number(names.get(name)):
                yield name


def _is_formula(node: ast.AST) -> bool:
    """Whether it is an operation on a sine, a cosine or a root."""
    return isinstance(node, ast.BinOp) and any(
        isinstance(one, ast.Call)
        and getattr(one.func, "attr", getattr(one.func, "id", "")) in FUNCTIONS
        for one in ast.walk(node)
    )


def _is_number(value: Any) -> bool:
    array = isinstance(value, np.ndarray) and value.dtype.kind in "fc"
    return array or isinstance(value, float | np.floating)

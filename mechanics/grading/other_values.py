"""What a file holds or shows besides its functions and formulas, and may say something with.

print(Eq(...))        Eq(...)        as a line of its own: shown, and judged as if it had a name
class A: eq = Eq(...)        f = lambdify(...)        casadi.Function        tex = "... = ..."

Numbers, symbols, modules, and objects of libraries say nothing. A whitelist: the rest is named.
"""

import ast
import functools
import re
import types
from collections.abc import Iterator, Mapping
from typing import Any

import casadi
import numpy as np
from sympy import Basic, Eq
from sympy.matrices import MatrixBase

from mechanics.grading.script_formulas import is_name

SHOW = "shown by the file"
"""The name of what learns of shown things: no name that a file can have."""
FORMULA = re.compile(r"=[^=].*\\[A-Za-z]|\\[A-Za-z].*=[^=]|''.*=[^=]|=[^=].*''", re.DOTALL)
"""What a string has that is an equation of motion rather than a label."""
WHY = "it is no function, number or equation of SymPy's"


class Showing(ast.NodeTransformer):
    """A file that tells what its lines show."""

    def visit_Expr(self, node: ast.Expr) -> ast.Expr:
        """A line that only shows something."""
        if isinstance(node.value, ast.Constant | ast.Yield | ast.YieldFrom | ast.Await):
            return node
        if isinstance(node.value, ast.Call):
            node.value.args = [
                part if isinstance(part, ast.Starred) else _told(part) for part in node.value.args
            ]
        node.value = _told(node.value)
        return node

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.FunctionDef:
        """What a function shows is not shown before it is called."""
        return node

    def visit_ClassDef(self, node: ast.ClassDef) -> ast.ClassDef:
        """Nor what a class does."""
        return node


def _told(part: ast.expr) -> ast.expr:
    return ast.copy_location(ast.Call(ast.Name(SHOW, ast.Load()), [part], []), part)


def equations_in(shown: list[Any]) -> list[Eq]:
    """Equations among things that were shown."""
    return [one for one in shown if isinstance(one, Eq)]


def unread_values(names: Mapping[str, Any], used: set[str]) -> Iterator[str]:
    """Names of a file for what may say something and is not read.

    Parameters
    ----------
    names : mapping of str to object
        Without those of libraries that it takes over.
    used : set of str
        Names that the function that is judged uses.
    """
    for name, value in names.items():
        if name in used or name.startswith("__"):
            continue
        own = type(value).__module__ == "submission"
        if _says(value, 0) or (own and callable(value) and "__call__" not in used):
            yield name


def _says(value: Any, depth: int) -> bool:
    """Whether a value that is neither a function of the file nor a formula may say something."""
    if isinstance(value, str):
        return FORMULA.search(value) is not None
    if isinstance(value, types.FunctionType):
        return value.__module__ is None  # SymPy has made it
    if isinstance(value, casadi.SX | casadi.MX):
        return not value.is_valid_input()
    if isinstance(value, functools.partial):
        return getattr(value.func, "__module__", "") != "submission"  # else its call is looked at
    if isinstance(value, casadi.Function | types.GeneratorType):
        return True
    if isinstance(value, np.ndarray):
        return value.dtype == object and any(map(_is_formula, value.flat))
    if isinstance(value, type):
        own = value.__module__ == "submission"
        return own and any(_is_formula(v) for v in vars(value).values())
    if type(value).__module__ == "submission" and depth == 0:
        held = vars(value).values() if hasattr(value, "__dict__") else ()
        return any(_is_formula(one) or _says(one, 1) for one in held)
    return False


def _is_formula(value: Any) -> bool:
    return isinstance(value, Basic | MatrixBase) and not is_name(value)

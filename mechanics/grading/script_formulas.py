"""What a script in SymPy's objects claims, where it has no function: its last formulas, as text.

    T = m*l**2*theta.diff(t)**2/2        energies by their names
    L = T - V
    EL = L.diff(theta.diff(t), t) - L.diff(theta)        what vanishes, by its name

A formula that another one uses is a part of that. A script with any other formula claims nothing
that is read: what it leaves unsaid might be wrong.
"""

import ast
import re
from collections.abc import Iterator, Mapping
from typing import Any

from sympy import Basic, Derivative, Eq, Expr, Symbol
from sympy.core.function import AppliedUndef, UndefinedFunction
from sympy.matrices import MatrixBase

from mechanics.claims.about import ENERGY_NAMES

VANISHES = re.compile(
    r"(?:eqs?|eqn|equations?|el|eom|euler|lagrange|residual|motion)(?![a-z])", re.I
)
"""What names of what is zero along the motion begin with."""
SHOWS = ("print", "display", "pprint", "init_printing", "latex")


def claims_of(code: str, names: Mapping[str, Any]) -> tuple[list[str], list[str]]:
    """Lines of text, one for each claim; and names of formulas that are neither claim nor part.

    Parameters
    ----------
    code : str
    names : mapping of str to object
        Of the script, after it was run.
    """
    used = _used(ast.parse(code))
    found: list[str] = []
    unread: list[str] = []
    for name, value in names.items():
        every = _formulas(value)
        if not every or (name in used and name not in ENERGY_NAMES):
            continue
        lines = [line for one in every for line in _claims(name, one)]
        if lines and all(map(_plain, every)):
            found += lines
        else:
            unread.append(name)
    return list(dict.fromkeys(found)), unread


def _used(tree: ast.Module) -> set[str]:
    """Names that something else is made of; what is only shown is not used."""
    shown = {id(part) for one in ast.walk(tree) if _shows(one) for part in ast.walk(one)}
    found: set[str] = set()
    for one in ast.walk(tree):
        if isinstance(one, ast.Assign | ast.AugAssign | ast.AnnAssign) and one.value is not None:
            targets = one.targets if isinstance(one, ast.Assign) else [one.target]
            own = {p.id for t in targets for p in ast.walk(t) if isinstance(p, ast.Name)}
            loaded = {p.id for p in ast.walk(one.value) if isinstance(p, ast.Name)}
            found |= loaded - own
        elif isinstance(one, ast.Call | ast.Return | ast.Lambda) and id(one) not in shown:
            args = one.args if isinstance(one, ast.Call) else [one]
            found |= {p.id for a in args for p in ast.walk(a) if isinstance(p, ast.Name)}
    return found


def _shows(node: ast.AST) -> bool:
    return isinstance(node, ast.Call) and getattr(node.func, "id", "") in SHOWS


def _formulas(value: Any) -> list[Any]:
    """The formulas of a value: no names, numbers, functions and rates."""
    if isinstance(value, dict):
        return [one for part in value.values() for one in _formulas(part)]
    if isinstance(value, list | tuple | set):
        return [one for part in value for one in _formulas(part)]
    if not isinstance(value, Basic | MatrixBase) or isinstance(value, UndefinedFunction):
        return []
    return [] if is_name(value) else [value]


def is_name(value: Any) -> bool:
    """Whether it is a symbol, a function of time, one of its rates, or a number."""
    if isinstance(value, Derivative):
        return is_name(value.expr)
    return isinstance(value, Symbol | AppliedUndef) or getattr(value, "is_number", False)


def _claims(name: str, value: Any) -> Iterator[str]:
    """What a formula that nothing uses says by its name."""
    if isinstance(value, Eq):
        yield f"{value.lhs} = {value.rhs}"
    elif isinstance(value, Expr) and name in ENERGY_NAMES:
        yield f"{name} = {value}"
    elif VANISHES.match(name):
        column = isinstance(value, MatrixBase) and 1 in value.shape
        entries = list(value) if column else [value] if isinstance(value, Expr) else []
        if any(d.derivative_count > 1 for entry in entries for d in entry.atoms(Derivative)):
            yield from (f"{entry} = 0" for entry in entries)


def _plain(value: Any) -> bool:
    """Whether it is made of SymPy's own classes only, which print what they are."""
    parts = list(value) if isinstance(value, MatrixBase) else [value]
    kinds = {type(node) for part in parts for node in _nodes(part)}
    own = (k for k in kinds if not issubclass(k, AppliedUndef))
    return all(k.__module__.partition(".")[0] == "sympy" for k in own)


def _nodes(value: Basic) -> Iterator[Basic]:
    yield value
    for part in value.args:
        yield from _nodes(part)

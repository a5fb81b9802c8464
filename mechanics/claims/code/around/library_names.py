"""Solvers of libraries by the names that they have there, whatever a file calls them.

from scipy.integrate import odeint as solve_ivp     solve_ivp(...)  ->  odeint(...)
import scipy.integrate as si; solve = si.odeint     solve(...)      ->  odeint(...)
from other import solve_ivp                         solve_ivp(...)  ->  unknown(...)
"""

import ast
import sys
from collections.abc import Collection, Iterable
from dataclasses import dataclass

from mechanics.claims.code.around.python_form import DEFINED, word

UNKNOWN = "unknown function"
"""What is called where nothing says what a name is."""
LIBRARIES = frozenset(("scipy", "numpy", "pandas", "jax"))


def with_library_names(tree: ast.Module, wanted: Collection[str]) -> ast.Module:
    """A file that calls some functions of libraries as these call them.

    Parameters
    ----------
    tree : ast.Module
        It is changed.
    wanted : collection of str
        Names in libraries.
    """
    return ast.fix_missing_locations(_Renamed(_bindings(ast.walk(tree)), wanted).visit(tree))


def is_library(module: str) -> bool:
    """Whether a module is of Python or one of those whose functions are known."""
    first = module.partition(".")[0]
    return first in LIBRARIES or first in sys.stdlib_module_names


@dataclass(frozen=True)
class _Bindings:
    """What names are bound to.

    Attributes
    ----------
    names : dict of str to set of str
        Other names, or `UNKNOWN`.
    own : set of str
        Functions, classes and arguments of the file.
    foreign : set of str
        Modules of which nothing is known; ``*`` where all names of one are imported.
    """

    names: dict[str, set[str]]
    own: set[str]
    foreign: set[str]

    def of(self, name: str, seen: frozenset[str] = frozenset()) -> str:
        """What a name is at last."""
        if name in self.own or name in seen:
            return name
        found = {one if one in (UNKNOWN, name) else self.of(one, seen | {name})
                 for one in self.names.get(name, {name})}  # fmt: skip
        return found.pop() if len(found) == 1 else UNKNOWN


def _bindings(nodes: Iterable[ast.AST]) -> _Bindings:
    found = _Bindings({}, set(), set())
    for one in nodes:
        pairs: list[tuple[str, str]] = []
        match one:
            case ast.ImportFrom(module=module, names=names, level=level):
                known = not level and is_library(module or "")
                pairs = [(a.asname or a.name, a.name if known else UNKNOWN) for a in names]
                found.foreign.update(a.asname or a.name for a in names if not known)
            case ast.Import(names=names):
                found.foreign.update(
                    (a.asname or a.name).partition(".")[0] for a in names if not is_library(a.name)
                )
            case ast.Assign(targets=targets, value=value):
                plain = isinstance(value, ast.Name | ast.Attribute)
                pairs = [(t.id, word(value) if plain else UNKNOWN)
                         for t in targets if isinstance(t, ast.Name)]  # fmt: skip
            case ast.ClassDef(name=name):
                found.own.add(name)
            case ast.arg(arg=name):
                found.own.add(name)
            case _ if isinstance(one, DEFINED):
                found.own.add(one.name)
        for name, value_name in pairs:
            found.names.setdefault(name, set()).add(value_name)
    return found


class _Renamed(ast.NodeTransformer):
    """Names in place of others."""

    def __init__(self, bindings: _Bindings, wanted: Collection[str]) -> None:
        self.bindings, self.wanted = bindings, wanted

    def visit_Name(self, node: ast.Name) -> ast.Name:
        made = self.bindings.of(node.id)
        if node.id in self.wanted and "*" in self.bindings.foreign and made == node.id:
            made = made if node.id in {*self.bindings.names, *self.bindings.own} else UNKNOWN
        if not isinstance(node.ctx, ast.Load) or not {node.id, made} & {*self.wanted}:
            return node
        return ast.copy_location(ast.Name(made, node.ctx), node)

    def visit_Attribute(self, node: ast.Attribute) -> ast.AST:
        self.generic_visit(node)
        foreign = isinstance(node.value, ast.Name) and node.value.id in self.bindings.foreign
        if foreign and node.attr in self.wanted:
            return ast.copy_location(ast.Name(UNKNOWN, ast.Load()), node)
        return node

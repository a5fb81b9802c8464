"""What a file makes of what a judged function of CasADi's returns, and says nothing else with.

    x, u, xdot = model()
    f = ca.Function("f", [x, u], [xdot])       the formulas of model once more

A whitelist: names that are bound once, so, and used nowhere else.
"""

import ast
from collections.abc import Collection, Iterator, Sequence
from random import Random
from types import FunctionType
from typing import Any

import casadi

from mechanics.claims.code.python.file_names import globals_of


def names_of_results(code: str, names: dict[str, Any], judged: Collection[str]) -> set[str]:
    """Names of a file for what a judged function returned, and functions that give it.

    Parameters
    ----------
    code : str
    names : dict of str to object
        Of the file, after it was run.
    judged : collection of str
    """
    tree = ast.parse(code)
    top = [node for line in tree.body if not isinstance(line, SCOPES) for node in _names(line)]
    calls = {line: _returned(line, judged) for line in tree.body}
    returned = {name for own in calls.values() for name in own}
    made = {line: _function(line, names, returned) for line in tree.body}
    plain = {node for line in tree.body if calls[line] or made[line] for node in _names(line)}
    own = [v for v in names.values() if getattr(v, "__module__", "") == "submission"]
    inside = set().union(*(used_in(one) for one in own))
    # A matrix of CasADi's may be changed by whatever else it is handed to.
    if returned & inside or any(node.id in returned and node not in plain for node in top):
        return set()
    if not all(_is_as_returned(line, own, names) for line, own in calls.items() if own):
        return set()
    set_once = [node.id for node in top if isinstance(node.ctx, ast.Store)]
    return {n for n in (*returned, *made.values()) if set_once.count(n) == 1}


def used_in(thing: Any) -> set[str]:
    """Names of the file that a function, or a method of a class, uses."""
    parts = (thing, *vars(thing).values()) if isinstance(thing, type) else (thing,)
    codes = [part.__code__ for part in parts if isinstance(part, FunctionType)]
    return set().union(*map(globals_of, codes))


SCOPES = (ast.FunctionDef, ast.AsyncFunctionDef)


def _is_as_returned(line: ast.stmt, own: Sequence[str], names: dict[str, Any]) -> bool:
    """Whether names have at the end what the function that they are of returns once more."""
    assert isinstance(line, ast.Assign)
    assert isinstance(line.value, ast.Call)
    values = [names.get(name) for name in own], [*names[_name(line.value.func)]()]
    return len({_numbers(each) for each in values}) == 1


def _numbers(values: Sequence[Any]) -> str:
    """What formulas are at a state, of symbols that stand beside them."""
    if not all(isinstance(one, casadi.MX | casadi.SX) for one in values):
        return f"no formulas, {id(values)}"
    symbols = [one for one in values if one.is_valid_input()]
    formulas = [one for one in values if not one.is_valid_input()]
    random = Random(1)
    state = [
        casadi.DM([random.uniform(0.5, 2) for _ in range(one.numel())]).reshape(one.shape)
        for one in symbols
    ]
    try:
        numbers = casadi.Function("own", symbols, formulas).call(state)
        return repr([one.full().tolist() for one in numbers])
    except RuntimeError:
        return f"of other symbols, {id(values)}"


def _name(node: ast.expr) -> str:
    return node.id if isinstance(node, ast.Name) else ""


def _names(line: ast.AST) -> Iterator[ast.Name]:
    return (node for node in ast.walk(line) if isinstance(node, ast.Name))


def _returned(line: ast.stmt, judged: Collection[str]) -> list[str]:
    """Names for what a judged function returns, which is called with nothing."""
    match line:
        case ast.Assign(
            targets=[ast.Tuple(elts=parts)],
            value=ast.Call(func=ast.Name(id=called), args=[], keywords=[]),
        ) if called in judged and all(map(_name, parts)):
            return [*map(_name, parts)]
    return []


def _function(line: ast.stmt, names: dict[str, Any], returned: set[str]) -> str:
    """The name of ``casadi.Function("f", [x, u], [xdot])`` of these names alone."""
    match line:
        case ast.Assign(
            targets=[ast.Name(id=name)],
            value=ast.Call(
                func=called,
                args=[ast.Constant(value=str()), ast.List(elts=given), ast.List(elts=made)],
                keywords=[],
            ),
        ) if {*map(_name, (*given, *made))} <= returned:
            match called:
                case ast.Attribute(value=ast.Name(id=module), attr="Function"):
                    plain = names.get(module) is casadi
                case ast.Name(id=own):
                    plain = names.get(own) is casadi.Function
                case _:
                    plain = False
            return name if plain and isinstance(names.get(name), casadi.Function) else ""
    return ""

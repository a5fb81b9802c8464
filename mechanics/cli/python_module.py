"""Equations of motion as a Python module that builds M, f, B, A and b with SymPy."""

import keyword
import re
from collections.abc import Iterable, Mapping

import sympy
from sympy import Expr, Symbol, sstr

from mechanics.equations import Equations
from mechanics.scene.symbols import by_name


def python_module(equations: Equations) -> str:
    """The text of the module: symbols, tuples of them in the order of the columns, matrices."""
    scene = equations.scene
    groups = {
        "coordinates": scene.q,
        "speeds": scene.u,
        "speed_rates": scene.ud,
        "inputs": scene.input_symbols,
        "parameters": scene.parameters,
        "multipliers": equations.multipliers,
    }
    matrices = {
        "matrix_M": equations.mass,
        "matrix_f": equations.forcing,
        "matrix_B": equations.reaction_matrix,
        "matrix_A": equations.constraint_matrix,
        "matrix_b": equations.constraint_bias,
    }
    known = dict.fromkeys(s for symbols in groups.values() for s in symbols)
    # Time, and derivatives of inputs, stand in the equations without being columns of them.
    other = {s for matrix in matrices.values() for s in matrix.free_symbols if s not in known}
    rest = sorted(other, key=by_name)
    names = _names([*known, *rest], {*groups, *matrices})
    title = " ".join(f"Equations of motion of {scene.name}, by {equations.route}.".split())
    lines = [f"# {title}", "", "from sympy import *", ""]
    lines += [_declared(symbol, names[symbol]) for symbol in (*known, *rest)]
    for group, symbols in groups.items():
        lines.append(f"{group} = ({''.join(names[symbol] + ', ' for symbol in symbols)})")
    for name, matrix in matrices.items():
        entries = ", ".join(_printed(entry, names) for entry in matrix)
        lines.append(f"{name} = Matrix({matrix.rows}, {matrix.cols}, [{entries}])")
    return "\n".join(lines)


def _declared(symbol: Symbol, name: str) -> str:
    sign = ", positive=True" if symbol.is_positive else ", real=True" if symbol.is_real else ""
    return f"{name} = Symbol({symbol.name!r}{sign})"


def _printed(entry: Expr, names: Mapping[Symbol, str]) -> str:
    renamed = {s: _named(s, names[s]) for s in entry.free_symbols}
    # S(1)/2 stays exact where 1/2 would be a float; exponents need no S.
    text = sstr(entry.xreplace(renamed), sympy_integers=True)
    return re.sub(r"\*\*S\((\d+)\)", r"**\1", text)


def _named(symbol: Symbol, name: str) -> Symbol:
    return symbol if symbol.name == name else Symbol(name, **symbol.assumptions0)


def _names(symbols: Iterable[Symbol], taken: set[str]) -> dict[Symbol, str]:
    """Python names: no keyword, nothing that SymPy exports, nothing used twice."""
    found: dict[Symbol, str] = {}
    for symbol in symbols:
        name = re.sub(r"\W", "_", symbol.name)
        name = name if name.isidentifier() else f"_{name}"
        while keyword.iskeyword(name) or hasattr(sympy, name) or name in taken:
            name += "_"
        taken.add(name)
        found[symbol] = name
    return found

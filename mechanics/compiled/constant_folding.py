"""Constant folding: what a graph computes of numbers alone is one number, and exact.

    (2 pi) x -> (2 pi) x,  one multiplication        (981/100 / 3) m -> (327/100) m

Numbers become doubles at the end, each once: what a machine is given is the nearest double to an
exact constant of the graph, and never a sum or quotient of such doubles.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import casadi as ca
from sympy import Expr

from mechanics.compiled.translate import Translator
from mechanics.program.casadi_printer import ExactGraphs
from mechanics.program.casadi_reader import read_routine, single_assignment
from mechanics.program.interpret import interpret

CONSTANTS = "constants"
"""The last input of a function with named constants."""

Exact = tuple[ca.Function, tuple[Expr, ...]]
"""A function whose last input are named constants, and what these stand for."""


def folded(function: ca.Function, constants: Sequence[Expr]) -> Exact:
    """A dense function without operations on numbers alone.

    Parameters
    ----------
    function : casadi.Function
        Its last input are the named constants.
    constants : sequence of Expr
        What these stand for.
    """
    if not _folds(function):
        return function, tuple(constants)
    names = [function.name_in(i) for i in range(function.n_in() - 1)]
    arrays = {name: ca.SX.sym(name, function.numel_in(i)) for i, name in enumerate(names)}
    translate = Translator({})
    values = {name: ca.vertsplit(array) for name, array in arrays.items()}
    outputs = at(function, {**values, function.name_in(len(names)): constants}, translate.exact)
    named = ca.vertcat(ca.SX(0, 1), *translate.constants.values())
    inputs = [*arrays.values(), named]
    graphs = ca.cse(list(outputs.values()))
    made = ca.Function(function.name(), inputs, graphs, [*arrays, CONSTANTS], list(outputs))
    return made, tuple(translate.constants)


def at(
    function: ca.Function, values: Mapping[str, Sequence[Any]], exact: ExactGraphs
) -> dict[str, ca.SX]:
    """Outputs of a dense function, numbers among its inputs put in exactly.

    Parameters
    ----------
    function : casadi.Function
    values : mapping of str to sequence
        By input, for each entry a scalar graph or a number of SymPy's.
    """
    code = read_routine(function)
    inputs = {
        f"{name}[{k}]": exact.value(entry)
        for name, entries in values.items()
        for k, entry in enumerate(entries)
    }
    found = interpret(code.program, exact, inputs, release=False)
    return {
        name: ca.reshape(ca.vertcat(ca.SX(0, 1), *map(exact.graph, found[name])), *shape)
        for name, shape in code.shapes
    }


def _folds(function: ca.Function) -> bool:
    """Whether an operation is on numbers alone."""
    last, numbers = function.n_in() - 1, set[int]()
    for k, (operation, operands, constant) in enumerate(single_assignment(function)[0]):
        if constant is not None or (operation == ca.OP_INPUT and operands[0] == last):
            numbers.add(k)
        elif operation != ca.OP_INPUT and all(i in numbers for i in operands):
            return True
    return False

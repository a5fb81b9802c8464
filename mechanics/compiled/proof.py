"""What was compiled is still the same mathematics: CasADi graphs against the derived equations.

In exact arithmetic: the graphs are walked instruction by instruction, at the values of parameters
that are fixed. The graphs are those that are bound and
evaluated, with pi and other numbers that no double holds still standing as symbols.
`mechanics.compiled.translation_validation` has the laws, and the rest of the chain down to the
machine code.
"""

from collections.abc import Sequence
from typing import Any

import casadi as ca

from mechanics.compiled.graphs import Graphs
from mechanics.compiled.model import Model
from mechanics.compiled.translation_validation.code import code_of
from mechanics.compiled.translation_validation.derived import Derived, derived
from mechanics.compiled.translation_validation.graph import STEP, prove_derived
from mechanics.kernel import Finding


def prove_compiled(
    model: Model, functions: Sequence[str] | None = None, **options: Any
) -> tuple[Finding, ...]:
    """Decide for each function of a model whether its graph is what was derived.

    Parameters
    ----------
    model : Model
    functions : sequence of str, optional
        Names of functions; by default all that the model has but the step of integration.
    **options
        As for `mechanics.symbolic.decide`.
    """
    names = [n for n in model.casadi if n != STEP] if functions is None else functions
    graphs = model.casadi
    once = derived(graphs)
    return tuple(prove_graph(name, graphs, known=once, **options) for name in names)


def prove_graph(
    name: str,
    graphs: Graphs,
    function: ca.Function | None = None,
    known: Derived | None = None,
    **options: Any,
) -> Finding:
    """Decide whether one graph is what was derived.

    Parameters
    ----------
    name : str
        What the function should be.
    graphs : Graphs
    function : casadi.Function, optional
        The graph to examine, with the inputs of ``graphs.exact(name)``; that one by default.
    known : Derived, optional
        What was derived, where the caller has it.

    Raises
    ------
    InputError
        If there is no such function.
    """
    own, constants = graphs.exact(name)
    rates = code_of(*graphs.exact_rates()) if name == STEP else None
    once = known or derived(graphs)
    return prove_derived(name, code_of(function or own, constants), once, rates, **options)

"""How far inside of its domain a model is, as a graph.

    margin_i(q, u, inputs, p) > 0        inside of condition i

Accelerations and reactions in a condition are those of the state, so that margins are functions of
it, of the inputs and of the parameters.
"""

from collections.abc import Callable, Mapping, Sequence

import casadi as ca
from sympy import Expr, Symbol

from mechanics.compiled.graphs import Graphs
from mechanics.compiled.model import Model
from mechanics.compiled.quantities import Quantity
from mechanics.compiled.translate import Translator
from mechanics.equations import Equations
from mechanics.program.casadi_printer import nearest
from mechanics.scene import Scene
from mechanics.scene.actions import frictions
from mechanics.scene.validity import plain_margin


def telling(model: Model, derive: Callable[[Scene], Equations]) -> Graphs:
    """Graphs that know the reactions which the conditions hold.

    Parameters
    ----------
    model : Model
        Whose own graphs are taken if they do.
    derive : callable
        A route that tells every reaction.
    """
    scene = model.equations.scene
    asked = {s for one in scene.conditions for s in plain_margin(scene, one).free_symbols}
    reactions = asked & {reaction.symbol for reaction in scene.reactions}
    if reactions <= {entry.symbol for entry in model.quantities.reactions}:
        return model.casadi
    return Graphs(derive(scene))


def margins(graphs: Graphs, state: Sequence[ca.SX], parameters: Mapping[Symbol, ca.SX]) -> ca.SX:
    """Margins of the conditions of a scene, a dense column, in the units of the conditions.

    Parameters
    ----------
    graphs : Graphs
        Of a route that tells the reactions which the conditions hold.
    state : sequence of casadi.SX
        Columns q, u and inputs, in their order.
    parameters : mapping of Symbol to casadi.SX
        Every parameter of the graphs and of the conditions.
    """
    known, (q, u, inputs) = graphs.quantities, state
    p = ca.vertcat(*(parameters[entry.symbol] for entry in known.p)) if known.p else ca.SX(0, 1)
    ud, multipliers = graphs["forward_dynamics"](q, u, inputs, p)
    groups: list[tuple[tuple[Quantity, ...], ca.SX]] = [
        (known.q, q), (known.u, u), (known.ud, ud), (known.inputs, inputs),
        (known.multipliers, multipliers),
    ]  # fmt: skip
    if known.reactions:
        groups.append((known.reactions, graphs["reactions"](q, u, inputs, p)))
    table = dict(parameters)
    for entries, column in groups:
        table |= {entry.symbol: column[i] for i, entry in enumerate(entries)}
    scene = graphs.equations.scene
    return bound_column(table, [plain_margin(scene, condition) for condition in scene.conditions])


def slidings(graphs: Graphs, state: Sequence[ca.SX], parameters: Mapping[Symbol, ca.SX]) -> ca.SX:
    """Sliding velocities of the frictions of a scene, a dense column, in m/s; see `margins`."""
    known, scene = graphs.quantities, graphs.equations.scene
    table = dict(parameters)
    for entries, column in zip((known.q, known.u, known.inputs), state, strict=True):
        table |= {entry.symbol: column[i] for i, entry in enumerate(entries)}
    return bound_column(table, [scene.plain(f.sliding, f.name) for f in frictions(scene)])


def bound_column(table: Mapping[Symbol, ca.SX], expressions: Sequence[Expr]) -> ca.SX:
    """Expressions as a dense column, with the nearest doubles in place of named constants."""
    translate = Translator(table)
    column = translate.column(list(expressions))
    if not translate.constants:
        return ca.densify(column)
    values = [ca.SX(nearest(number)) for number in translate.constants]
    names = ca.vertcat(*translate.constants.values())
    return ca.densify(ca.substitute(column, names, ca.vertcat(*values)))

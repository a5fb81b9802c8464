"""What a unit computes, as functions of one column of everything that is given.

    rates, outputs      (x', y) = g(v)           v = (time, q, u, inputs, parameters, step size)
    tangent             J d,   J = dg/dv         adjoint   d^T J

The graphs are those of the model, put together; J is CasADi's exact differentiation of them.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial

import casadi as ca
from sympy import Dummy, Symbol

from mechanics.compiled import Model
from mechanics.compiled.graphs import Graphs
from mechanics.compiled.margins import bound_column, margins, telling
from mechanics.compiled.quantities import DIGITS, Quantities, Quantity
from mechanics.routes.derivation import by_route
from mechanics.scene.rates import TIME
from mechanics.scene.validity import condition_parameters

CLOCK = Quantity(TIME, "s", "time")
# A dummy is no parameter of a scene, whatever that is called.
STEP_SIZE = Quantity(Dummy("step_size"), "s", "co-simulation: longest internal step", positive=True)


@dataclass(frozen=True, eq=False)
class Functions:
    """The functions of a unit, and what stands where in their arrays.

    Attributes
    ----------
    inputs, p : tuple of Quantity
        Inputs without time; parameters with those that only conditions use.
    outputs : tuple of Quantity
        What is wanted beside the rates of coordinates and speeds; margins last.
    graphs : mapping of str to casadi.Function
        ``rates``, ``outputs``, ``tangent`` and ``adjoint``.
    """

    inputs: tuple[Quantity, ...]
    p: tuple[Quantity, ...]
    outputs: tuple[Quantity, ...]
    graphs: Mapping[str, ca.Function]


def functions(model: Model) -> Functions:
    """The functions of a unit.

    Raises
    ------
    InputError
        If the model was asked for other functions than those of a motion.
    ExpressionError
        If a condition or constraint holds an operation that is not known.
    """
    scene, known = model.equations.scene, model.quantities
    graphs = conditional_graphs(model)
    sources = [known, graphs.quantities]
    inputs = _inputs(sources)
    p = (*known.p, *_own_parameters(model))
    given = (CLOCK, *known.q, *known.u, *inputs, *p, STEP_SIZE)
    v = ca.SX.sym("given", len(given))
    table = {entry.symbol: v[i] for i, entry in enumerate(given)}
    table |= {s: ca.SX(float(x.evalf(DIGITS))) for s, x in model.casadi.fixed.items()}
    wanted, outputs = _outputs(model, table)
    if scene.conditions:
        state = [_column(getattr(graphs.quantities, g), table) for g in ("q", "u", "inputs")]
        wanted.append(margins(graphs, state, table))
        outputs += [
            Quantity(Symbol(f"margin of {one.name}"), "", f"{one.text}, or it {one.otherwise}")
            for one in scene.conditions
        ]
    y = ca.vertcat(*wanted) if wanted else ca.SX(0, 1)
    return Functions(inputs, p, tuple(outputs), _graphs(v, _rates(model, table), y))


def conditional_graphs(model: Model) -> Graphs:
    """Graphs that tell what the conditions of the scene hold: the model's, or of another route."""
    if not model.equations.scene.conditions:
        return model.casadi
    return telling(model, partial(by_route, "free_body"))


def _graphs(v: ca.SX, rates: ca.SX, outputs: ca.SX) -> dict[str, ca.Function]:
    wanted = ca.vertcat(rates, outputs)
    forward, backward = ca.SX.sym("seed", v.numel()), ca.SX.sym("seed", wanted.numel())
    tangent = ca.jtimes(wanted, v, forward)
    adjoint = ca.jtimes(wanted, v, backward, True)
    return {
        "rates": _function("rates", {"given": v}, rates),
        "outputs": _function("outputs", {"given": v}, outputs),
        "tangent": _function("tangent", {"given": v, "seed": forward}, tangent),
        "adjoint": _function("adjoint", {"given": v, "seed": backward}, adjoint),
    }


def _function(name: str, arguments: Mapping[str, ca.SX], graph: ca.SX) -> ca.Function:
    dense = ca.cse([ca.densify(graph)])
    return ca.Function(name, list(arguments.values()), dense, list(arguments), ["wanted"])


def _inputs(sources: Sequence[Quantities]) -> tuple[Quantity, ...]:
    """Inputs, each once, without time, which is given first."""
    found = {e.symbol: e for known in reversed(sources) for e in known.inputs if e.symbol != TIME}
    order = dict.fromkeys(e.symbol for known in sources for e in known.inputs)
    return tuple(found[symbol] for symbol in order if symbol in found)


def _own_parameters(model: Model) -> tuple[Quantity, ...]:
    """Parameters that only conditions use."""
    taken = {entry.symbol for entry in model.quantities.p} | set(model.casadi.fixed)
    return tuple(
        Quantity(s, getattr(s, "unit", ""), getattr(s, "meaning", ""), bool(s.is_positive))
        for s in condition_parameters(model.equations.scene)
        if s not in taken
    )


def _column(entries: Sequence[Quantity], table: Mapping[Symbol, ca.SX]) -> ca.SX:
    return ca.vertcat(*(table[e.symbol] for e in entries)) if entries else ca.SX(0, 1)


def _state(model: Model, table: Mapping[Symbol, ca.SX]) -> list[ca.SX]:
    return [_column(getattr(model.quantities, g), table) for g in ("q", "u", "inputs", "p")]


def _rates(model: Model, table: Mapping[Symbol, ca.SX]) -> ca.SX:
    graphs, state = model.casadi, _state(model, table)
    accelerations, _ = graphs["forward_dynamics"](*state)
    return ca.vertcat(graphs["coordinate_rates"](*state), accelerations)


def _outputs(model: Model, table: Mapping[Symbol, ca.SX]) -> tuple[list[ca.SX], list[Quantity]]:
    """Reactions or multipliers, energies, outputs of the scene, how far off constraints it is."""
    scene, known, state = model.equations.scene, model.quantities, _state(model, table)
    graphs: list[ca.SX] = []
    entries: list[Quantity] = []
    if known.reactions:
        graphs.append(model.casadi["reactions"](*state))
        entries += [Quantity(e.symbol, e.unit, "reaction") for e in known.reactions]
    elif known.multipliers:
        graphs.append(model.casadi["forward_dynamics"](*state)[1])
        entries += [Quantity(e.symbol, e.unit, "multiplier") for e in known.multipliers]
    if "energy" in tuple(model.casadi):
        graphs += model.casadi["energy"](*state)
        entries += [Quantity(Symbol(f"{e} energy"), "J") for e in ("kinetic", "potential", "total")]
    for name, output in scene.outputs.items():
        if name in tuple(model.casadi):
            # Row by row, as the entries are named.
            graphs.append(ca.vec(model.casadi[name](*state).T))
            entries += [Quantity(Symbol(f"{name}{end}"), unit) for end, unit in output.entries]
    names = [c.name for c in scene.constraints] + [f"norm of {r.name}" for r in scene.rotations]
    if names:
        plain = [scene.plain(c.expression, c.name) for c in scene.constraints]
        graphs.append(bound_column(table, [*plain, *scene.norms]))
        entries += [
            Quantity(Symbol(f"residual of {name}"), "", "zero where the constraint holds")
            for name in names
        ]
    return graphs, entries

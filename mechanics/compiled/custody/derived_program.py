"""What was derived as a program: the left side of the first step of the chain for large scenes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sympy import Expr, Symbol

from mechanics.compiled.outputs import energies, every_reaction, momenta
from mechanics.compiled.quantities import Quantities
from mechanics.equations import ProgramEquations
from mechanics.mechanism import Mechanism
from mechanics.program import Program
from mechanics.program.builder import Node
from mechanics.routes import kane
from mechanics.routes.rows import acceleration_forms, coefficients, remainder, substitute
from mechanics.scene.rates import TIME

GROUPS = ("q", "u", "ud", "inputs", "p", "multipliers", "reactions", "h")


@dataclass(frozen=True, eq=False)
class DerivedProgram:
    """What was derived, before parameters are fixed.

    Attributes
    ----------
    scene, route : str
    symbols : mapping of str to tuple of Symbol
        By group, in the order of the arrays.
    fixed : mapping of Symbol to Expr
        Exact values of parameters that are no input.
    time : int or None
        Entry of the inputs that is the time.
    program : Program
        Outputs: ``rows`` of the route and ``conjugate`` ones (those of the route, too, where there
        is friction), ``constraints`` differentiated down to u', ``rates``, ``kinetic``,
        ``potential``, ``linear``, ``angular``, ``generalized`` and ``reactions``; u' and the
        multipliers are inputs.
    """

    scene: str
    route: str
    symbols: Mapping[str, tuple[Symbol, ...]]
    fixed: Mapping[Symbol, Expr]
    time: int | None
    program: Program


def derived_program(
    equations: ProgramEquations, known: Quantities, fixed: Mapping[Symbol, Expr]
) -> DerivedProgram:
    """What was derived, for all functions of a model."""
    mechanism, route = equations.mechanism, equations.route
    conjugate, rows = _conjugate(equations), equations.values
    if not _follows(equations, conjugate):
        # Where the route closes a loop otherwise, its rows hold on the constraints only.
        route, rows = "kane", conjugate
    outputs: dict[str, Sequence[Node]] = {
        "rows": rows,
        "conjugate": conjugate,
        "constraints": acceleration_forms(mechanism),
        "rates": mechanism.q_rates,
        **energies(mechanism),
        **momenta(mechanism),
    }
    del outputs["total"]
    if known.reactions:
        outputs["reactions"] = _reactions(mechanism)
    symbols = {g: tuple(e.symbol for e in getattr(known, g)) for g in GROUPS}
    times = [i for i, symbol in enumerate(symbols["inputs"]) if symbol == TIME]
    return DerivedProgram(
        equations.scene.name, route, symbols, fixed, times[0] if times else None,
        mechanism.builder.program(outputs),
    )  # fmt: skip


def _conjugate(equations: ProgramEquations) -> tuple[Node, ...]:
    """Rows conjugate to u in the multipliers of the route; those of the route under friction."""
    mechanism = equations.mechanism
    if mechanism.frictions or equations.route == "lagrange":
        return equations.values
    return kane.derive(mechanism).values


def _solved(
    mechanism: Mechanism, rows: Sequence[Node], multipliers: Sequence[Node]
) -> dict[Node, Node]:
    """u' and the multipliers as one operation on the state."""
    unknowns = (*mechanism.ud, *multipliers)
    every = [*rows, *acceleration_forms(mechanism)]
    right = [-entry for entry in remainder(mechanism.builder, every, unknowns)]
    values = mechanism.builder.solve(coefficients(every, unknowns), right)
    return dict(zip(unknowns, values, strict=True))


def _follows(equations: ProgramEquations, conjugate: tuple[Node, ...]) -> bool:
    """Whether rows of the route follow from others at all states, on the constraints or not."""
    mechanism = equations.mechanism
    if conjugate == equations.values or not mechanism.constraints:
        return True
    values = _solved(mechanism, conjugate, equations.multipliers)
    anywhere, _ = mechanism.filters
    return all(map(anywhere.is_zero, substitute(mechanism.builder, equations.values, values)))


def _reactions(mechanism: Mechanism) -> Sequence[Node]:
    """In q, u and u'; where there are constraints or friction, at the motion of Kane's rows."""
    nodes = every_reaction(mechanism)
    if not (mechanism.constraints or mechanism.frictions):
        return nodes
    own = kane.derive(mechanism)
    return substitute(
        mechanism.builder, nodes, _solved(mechanism, own.values, own.multipliers)
    )  # fmt: skip

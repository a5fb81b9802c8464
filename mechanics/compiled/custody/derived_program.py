"""What was derived as a program: the left side of the first step of the chain for large scenes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sympy import Expr, Symbol

from mechanics.compiled.outputs import energies, momenta
from mechanics.compiled.quantities import Quantities
from mechanics.equations import ProgramEquations
from mechanics.program import Program
from mechanics.program.builder import Node
from mechanics.routes import free_body, kane
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
        Outputs: ``rows`` of the route and ``conjugate`` ones, ``rates``, ``kinetic``,
        ``potential``, ``linear``, ``angular``, ``generalized`` and ``reactions``; u' is an input.
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
    mechanism = equations.mechanism
    outputs: dict[str, Sequence[Node]] = {
        "rows": equations.values,
        "conjugate": kane.derive(mechanism).values,
        "rates": mechanism.q_rates,
        **energies(mechanism),
        **momenta(mechanism),
    }
    del outputs["total"]
    if known.reactions:
        told = free_body.derive(mechanism).reactions
        outputs["reactions"] = [told[reaction.name] for reaction in mechanism.reactions]
    symbols = {g: tuple(e.symbol for e in getattr(known, g)) for g in GROUPS}
    times = [i for i, symbol in enumerate(symbols["inputs"]) if symbol == TIME]
    return DerivedProgram(
        equations.scene.name, equations.route, symbols, fixed, times[0] if times else None,
        mechanism.builder.program(outputs),
    )  # fmt: skip

"""Declared equilibria are equilibria: at rest nothing moves and nothing accelerates.

    N u + n = 0,    phi(q) = 0,    row(q, u, u' = 0, lambda) = 0 for some lambda              (1)

It is shown for all values of the parameters; where that fails, for their typical ones, at which the
equilibrium is a state of reference.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import sympy
from sympy import Expr

from mechanics.errors import SceneError
from mechanics.kernel import Finding, Statement, decide
from mechanics.mechanism import Mechanism, name_of, ranges
from mechanics.program.builder import Node
from mechanics.program.residues import Residues
from mechanics.program.sympy_reader import read
from mechanics.routes import kane
from mechanics.routes.rows import coefficients, substitute
from mechanics.scene import Scene


def exact(value: Any) -> Expr:
    """The number that was typed: a decimal is that decimal, not the double next to it."""
    given = sympy.sympify(value)
    return sympy.Rational(str(value)) if given.is_Float else given


def check_equilibria(scene: Scene, mechanism: Mechanism) -> None:
    """Refuse declared equilibria that are not shown to be some.

    Raises
    ------
    SceneError
        With the first of them.
    """
    if not scene.equilibria:
        return
    rows = kane.derive(mechanism)
    typical = {
        mechanism.builder.input(p.name): read(mechanism.builder, (p.exact,))[0]
        for p in scene.parameters
        if getattr(p, "typical", None) is not None
    }
    for declared in scene.equilibria:
        state = _state(mechanism, declared)
        vanish = [*mechanism.q_rates, *(c.expression for c in mechanism.constraints if c.holonomic)]
        words = ", ".join(f"{name} = {value}" for name, value in declared.items())
        for values in (state, {**state, **typical}):
            finding = _balanced(mechanism, vanish, rows.values, rows.multipliers, values, words)
            if finding.shown:
                break
        else:
            raise SceneError(
                f"{scene.name}: {words} is not shown to be an equilibrium ({finding.evidence}):"
                " correct it, or give numbers exactly"
            )


def _state(mechanism: Mechanism, declared: Mapping[str, Any]) -> dict[Node, Node]:
    """What is declared, and 0 for the rest of what moves."""
    builder = mechanism.builder
    still = [*mechanism.q, *mechanism.qd, *mechanism.u, *mechanism.ud]
    still += [node for node in mechanism.given_rates if name_of(node) != "t"]
    still += [node for node in mechanism.given_rates.values() if node.constant is None]
    state = dict.fromkeys(still, builder.zero)
    for name, value in declared.items():
        (state[builder.input(name)],) = read(builder, (exact(value),))
    return state


def _balanced(
    mechanism: Mechanism, vanish: Sequence[Node], rows: Sequence[Node],
    multipliers: Sequence[Node], state: Mapping[Node, Node], words: str,
) -> Finding:  # fmt: skip
    """Equation (1); the multipliers are those that some of the rows ask for."""
    builder = mechanism.builder
    slopes = coefficients(rows, multipliers)
    none = dict.fromkeys(multipliers, builder.zero)
    rest = substitute(builder, substitute(builder, rows, none), state)
    table = [substitute(builder, row, state) for row in slopes]
    filter_ = Residues(builder)
    kept = [i for i, _ in filter_.eliminate([filter_.values(r) for r in table], len(multipliers))]
    if multipliers and len(kept) == len(multipliers):
        pressing = builder.solve([table[i] for i in kept], [-rest[i] for i in kept])
        rest = tuple(
            r + sum((a * x for a, x in zip(row, pressing, strict=True)), builder.zero)
            for r, row in zip(rest, table, strict=True)
        )
    left = [*substitute(builder, vanish, state), *rest]
    program = builder.program({"left": left, "right": [0] * len(left)})
    return decide(Statement(f"equilibrium at {words}", program, ranges(mechanism)))

"""Reactions by two independent ways, and multipliers by every route that keeps them.

R_j(u', lambda) of procedure (i), put into Kane's equations of the auxiliary speeds, gives zero
B lambda of Lagrange = B R of Kane with the reactions as loads
lambda of the momentum routes = R of Kane, name by name
"""

from collections.abc import Sequence
from dataclasses import replace

from sympy import Expr, Symbol

from mechanics.checks.agreement import Pairs, product, proof_pays, solve
from mechanics.equations import Equations
from mechanics.exact import Arithmetic, Finding, decide
from mechanics.kinematics.manifold import settle


def check_reactions(
    equations: Equations, auxiliary: Sequence[tuple[Symbol, Expr]]
) -> tuple[Finding, ...]:
    """Each eliminated reaction satisfies the equation of its auxiliary speed.

    Parameters
    ----------
    equations : Equations
        Of a route that gives reactions.
    auxiliary : sequence of (Symbol, Expr)
        From Kane's auxiliary speeds.
    """
    if not auxiliary:
        return ()
    # One elimination serves all; only a doubt is looked into one by one.
    whole = _decide("all reactions", equations, [row for _, row in auxiliary])
    subjects = [
        f"reaction {symbol}: {equations.route} = auxiliary speeds" for symbol, _ in auxiliary
    ]
    if whole.shown:
        return tuple(replace(whole, subject=subject) for subject in subjects)
    return tuple(
        _decide(subject, equations, [row])
        for subject, (_, row) in zip(subjects, auxiliary, strict=True)
    )


def _decide(subject: str, equations: Equations, rows: Sequence[Expr]) -> Finding:
    def experiment(a: Arithmetic) -> Pairs:
        settle(equations.scene, a)
        for unknown, number in zip(equations.unknowns, solve(a, equations), strict=True):
            a.assign(unknown, number)
        for reaction, value in equations.reactions:
            a.assign(reaction, a.value(value))
        return [(a.value(row), a.rational(0)) for row in rows]

    return decide(subject, experiment, try_normal=proof_pays(equations.scene))


def check_multipliers(reference: Equations, other: Equations) -> Finding:
    """The reactions that maintain the constraints are the same, by name or as B lambda.

    Multipliers of Lagrange's method have a sign and a scale of their own; the generalized force
    B lambda has not, and both routes' rows are power-conjugate to u.
    """
    scene = reference.scene
    size = len(scene.u)

    def experiment(a: Arithmetic) -> Pairs:
        settle(scene, a)
        one, two = solve(a, reference)[size:], solve(a, other)[size:]
        if other.multipliers == reference.multipliers:
            return list(zip(one, two, strict=True))
        return [
            (
                product(a, reference.reaction_matrix[i, :], one),
                product(a, other.reaction_matrix[i, :], two),
            )
            for i in range(size)
        ]

    subject = f"{reference.route} = {other.route}: multipliers"
    return decide(subject, experiment, try_normal=proof_pays(scene))

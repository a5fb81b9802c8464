"""Where in the derivation the terms of a right equation come from.

    right = sum of pieces        a piece is named for a term that it holds with a factor not zero

What is claimed was added up: the pieces sum to the right equation, and that vanishes along the
motion. A right equation that is none of those that are known by their pieces is taken apart in a
field: c G = A gives the factors of the free-body equations in it.
"""

from collections.abc import Iterable

from sympy import Expr

from mechanics.blame.derivation import Derivation
from mechanics.blame.motion import QUICK
from mechanics.blame.pieces import Origin
from mechanics.blame.terms import Monomial, Terms
from mechanics.checks.ledger_compare import project_defined
from mechanics.errors import ExpressionError
from mechanics.kernel.ring import TooLarge
from mechanics.kernel.trial import Answer
from mechanics.symbolic import Arithmetic, Number, collect_linear
from mechanics.symbolic.decide import answer


def origins_of(
    pieces: Iterable[tuple[Origin, Terms]], monomials: Iterable[Monomial]
) -> tuple[str, ...]:
    """Words for the pieces that hold any of the terms."""
    wanted = set(monomials)
    return tuple(dict.fromkeys(origin.words for origin, terms in pieces if wanted & terms.keys()))


def origins_in_field(derivation: Derivation, right: Expr) -> dict[str, tuple[str, ...]]:
    """Words by group for a right equation, linear in accelerations and reactions.

    Returns
    -------
    dict of str to tuple of str
        Empty where the equation cannot be taken apart, or its pieces do not sum to it.
    """
    value = derivation.scene.plain(right)
    try:
        basis, parts = derivation.basis, derivation.parts
        target, _ = collect_linear(value, derivation.unknowns)
    except (ExpressionError, TooLarge):
        return {}
    if len(basis) != len(target):
        return {}
    found: dict[str, dict[str, None]] = {}

    def experiment(a: Arithmetic) -> list[tuple[Number, Number]]:
        project_defined(a, derivation.truth.kinematics)
        columns = [[a.value(row[j]) for row in basis] for j in range(len(basis))]
        factors = a.solve(columns, [a.value(entry) for entry in target])
        found.clear()
        whole = a.rational(0)
        for (group, words), held in parts.items():
            part = a.rational(0)
            for index, expression in held:
                part = part + factors[index] * a.value(expression)
            whole = whole + part
            if not a.is_zero(part):
                found.setdefault(group, {})[words] = None
        return [(whole, a.value(value))]

    if answer(experiment, QUICK) is not Answer.ZERO:
        return {}
    return {group: tuple(words) for group, words in found.items()}

"""Square roots that are quotients of polynomials: b sin t for b^2 (1 - cos^2 t), not |b sin t|.

sin^2 t + cos^2 t = 1 is used both ways, in turn: a square may show in one of them only.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx
from flint.utils.flint_exceptions import DomainError

from mechanics.kernel.angles import Form
from mechanics.program import Builder, Node
from mechanics.program.operations import COS, SIN


def square_root(builder: Builder, form: Form) -> Node | None:
    """One of the two quotients of polynomials whose square a form is, or None if none is seen.

    Parameters
    ----------
    builder : Builder
        Whose nodes the monomials of the form are made of.
    form : mapping of monomials to Fraction
    """
    partners = _partners(builder, {number for monomial in form for number, _ in monomial})
    numbers = sorted({n for monomial in form for n, _ in monomial} | set(partners.values()))
    if not numbers:
        return None
    ring = fmpq_mpoly_ctx.get([f"g{i}" for i in range(len(numbers))], "lex")
    gens = dict(zip(numbers, ring.gens(), strict=True))
    lowest = {n: min(dict(monomial).get(n, 0) for monomial in form) for n in numbers}
    # Twice the negative powers clear the denominator, and are a square.
    below = {n: -power for n, power in lowest.items() if power < 0}
    for kept in (COS, SIN):
        total = ring.constant(0)
        for monomial, factor in form.items():
            term = ring.constant(fmpq(factor.numerator, factor.denominator))
            powers = dict(monomial)
            for n in numbers:
                power = powers.get(n, 0) + 2 * below.get(n, 0)
                if n in partners and builder.operations[n] != kept:
                    term *= (1 - gens[partners[n]] ** 2) ** (power // 2)
                    power %= 2
                term *= gens[n] ** power
            total += term
        try:
            root = total.sqrt()
        except DomainError:
            continue
        above = _of_polynomial(builder, root, numbers)
        for n, power in below.items():
            above = above / Node(builder, n).power(power)
        return above
    return None


def _partners(builder: Builder, numbers: set[int]) -> dict[int, int]:
    """The sine of each angle whose cosine is there, and the other way round."""
    found: dict[int, int] = {}
    for n in numbers:
        code, angle = builder.operations[n], builder.operands[0][n]
        if code in (COS, SIN):
            other = builder.call("sin" if code == COS else "cos", Node(builder, angle)).number
            found |= {n: other, other: n}
    return found


def _of_polynomial(builder: Builder, polynomial: fmpq_mpoly, numbers: Sequence[int]) -> Node:
    total = builder.zero
    for powers, factor in polynomial.terms():
        term = builder.constant(Fraction(int(factor.p), int(factor.q)))
        for number, power in zip(numbers, powers, strict=True):
            term = term * Node(builder, number).power(int(power))
        total = total + term
    return total

"""Integers of a C text: polynomials in what is not known before it runs.

k * stride + i        entry k of lane i
"""

from dataclasses import dataclass

from mechanics.errors import ExpressionError

Monomial = tuple[str, ...]

LARGEST = 2**31 - 1
"""An int is trusted up to here only: beyond, C wraps or is undefined."""


@dataclass(frozen=True)
class Whole:
    """An integer: monomials of names, sorted, with integer factors."""

    terms: tuple[tuple[Monomial, int], ...] = ()

    @property
    def known(self) -> int | None:
        """The number that it is, if no name occurs."""
        if not self.terms:
            return 0
        return self.terms[0][1] if len(self.terms) == 1 and not self.terms[0][0] else None

    def __str__(self) -> str:
        words = ["*".join([*([] if k == 1 and m else [str(k)]), *m]) for m, k in self.terms]
        return " + ".join(words) or "0"


def whole(number: int) -> Whole:
    """A known integer.

    Raises
    ------
    ExpressionError
        If an int of C may not hold it.
    """
    if abs(number) > LARGEST:
        raise ExpressionError(f"the integer {number} does not fit into an int")
    return Whole((((), number),) if number else ())


def unknown(name: str) -> Whole:
    """An integer that is known at run time."""
    return Whole((((name,), 1),))


def _collected(terms: dict[Monomial, int]) -> Whole:
    result = Whole(tuple(sorted((m, k) for m, k in terms.items() if k)))
    if result.known is not None:
        whole(result.known)
    return result


def plus(left: Whole, right: Whole, sign: int = 1) -> Whole:
    """left + sign right."""
    terms = dict(left.terms)
    for monomial, factor in right.terms:
        terms[monomial] = terms.get(monomial, 0) + sign * factor
    return _collected(terms)


def times(left: Whole, right: Whole) -> Whole:
    """left right."""
    terms: dict[Monomial, int] = {}
    for one, factor in left.terms:
        for other, value in right.terms:
            monomial = tuple(sorted(one + other))
            terms[monomial] = terms.get(monomial, 0) + factor * value
    return _collected(terms)


def divided(left: Whole, right: Whole, remainder: bool) -> Whole:
    """left / right as C does it, towards zero, or what remains.

    Raises
    ------
    ExpressionError
        If one of them is not known, or the divisor is zero.
    """
    x, y = left.known, right.known
    if x is None or y is None or y == 0:
        raise ExpressionError(f"the integer division of {left} by {right} is not supported")
    quotient = abs(x) // abs(y) * (1 if (x < 0) == (y < 0) else -1)
    return whole(x - quotient * y if remainder else quotient)

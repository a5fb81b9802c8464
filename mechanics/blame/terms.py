"""An expression as terms: monomials in symbols, single sines and cosines, with rational factors.

    g sin(th) / l  ->  {(g, 1) (sin th, 1) (l, -1): 1}

Powers may be negative, and sin^2 is 1 - cos^2, so that equal expressions have equal terms. A sum in
a denominator is multiplied out first, as one would to compare by hand: what is returned is the
expression times that sum.
"""

from collections.abc import Collection, Iterable, Mapping
from fractions import Fraction

from flint import fmpq, fmpq_mpoly
from sympy import Add, Expr, Mul, Pow, Rational, Symbol, cos, sin

from mechanics.blame.angles import single_angles
from mechanics.symbolic.canonical_back import generator_expression
from mechanics.symbolic.canonical_back import terms as polynomial_terms
from mechanics.symbolic.canonical_poly import Reader, reader

Monomial = frozenset[tuple[Expr, int]]
Terms = dict[Monomial, Fraction]


def terms_of(
    expressions: Iterable[Expr], *, cleared: bool = False, moving: Collection[Symbol] = ()
) -> list[Terms]:
    """Terms of expressions.

    Parameters
    ----------
    expressions : iterable of Expr
        In plain symbols.
    cleared : bool
        True to multiply all of them by the sums and roots that stand in denominators of any.
    moving : collection of Symbol
        Where given, what all their coefficients have in common is divided out of one expression.

    Raises
    ------
    ExpressionError
        For what has no normal form.
    TooLarge
        For more than some ten thousand terms.
    """
    ring, polynomials = reader([single_angles(expression) for expression in expressions])
    if cleared:
        polynomials = _cleared(ring, polynomials)
    if moving and len(polynomials) == 1:
        polynomials = [_primitive(ring, polynomials[0], set(moving))]
    return [_terms(ring, polynomial) for polynomial in polynomials]


def _cleared(work: Reader, polynomials: list[fmpq_mpoly]) -> list[fmpq_mpoly]:
    """Multiplied by every sum and root that is divided by, the innermost last."""
    ring = work.ring
    for place in sorted(ring.keys):
        key = ring.keys[place]
        if not (isinstance(key, Pow) and key.exp.is_negative and not _plain(key)):
            continue
        highest = max((int(p.degrees()[place]) for p in polynomials), default=0)
        if highest == 0:
            continue
        base = work.read(1 / key)
        powers = [ring.power(base, count) for count in range(highest + 1)]
        polynomials = [_without(work, p, place, powers) for p in polynomials]
    return polynomials


def _without(
    work: Reader, polynomial: fmpq_mpoly, place: int, powers: list[fmpq_mpoly]
) -> fmpq_mpoly:
    """The polynomial times base^d, where the generator at a place is 1/base."""
    ring, highest = work.ring, len(powers) - 1
    by_power: dict[int, dict[tuple[int, ...], fmpq]] = {}
    for exponents, value in polynomial.terms():
        rest = tuple(0 if i == place else int(e) for i, e in enumerate(exponents))
        by_power.setdefault(int(exponents[place]), {})[rest] = value
    total = ring.constant(0)
    for power, part in by_power.items():
        total += ring.product(polynomial.context().from_dict(part), powers[highest - power])
    return ring.reduced(total)


def _primitive(work: Reader, polynomial: fmpq_mpoly, moving: set[Symbol]) -> fmpq_mpoly:
    """The polynomial without the sum that the coefficients of all products of `moving` share."""
    ring = work.ring
    places = [p for p, key in ring.keys.items() if key in moving]
    split: dict[tuple[int, ...], dict[tuple[int, ...], fmpq]] = {}
    for exponents, value in polynomial.terms():
        rest = tuple(0 if i in places else int(e) for i, e in enumerate(exponents))
        split.setdefault(tuple(int(exponents[p]) for p in places), {})[rest] = value
    common = ring.constant(0 if len(split) > 1 else 1)
    for part in split.values():
        common = common.gcd(polynomial.context().from_dict(part))
        if common.is_constant():
            return polynomial
    return polynomial if len(common) <= 1 else polynomial / common


def _plain(key: Pow) -> bool:
    """Whether 1/key is a symbol, sine or cosine, whose powers may be negative."""
    base = 1 / key
    return bool(base.is_Symbol or isinstance(base, sin | cos))


def _terms(work: Reader, polynomial: fmpq_mpoly) -> Terms:
    ring, found = work.ring, Terms()
    atoms: dict[int, tuple[Expr, int]] = {}
    for factors, value in polynomial_terms(ring.reduced(polynomial)):
        powers: dict[Expr, int] = {}
        for place, power in factors:
            if place not in atoms:
                key = generator_expression(ring, place)
                inverse = isinstance(key, Pow) and key.exp.is_negative
                atoms[place] = (1 / key, -1) if inverse else (key, 1)
            atom, sign = atoms[place]
            powers[atom] = powers.get(atom, 0) + sign * power
        monomial = frozenset((atom, power) for atom, power in powers.items() if power)
        found[monomial] = found.get(monomial, Fraction(0)) + Fraction(int(value.p), int(value.q))
    return {monomial: value for monomial, value in found.items() if value}


def product(terms: Terms, monomial: Monomial, factor: Fraction) -> Terms:
    """Terms times one term; sin^2 is 1 - cos^2 again."""
    if not monomial:
        return {one: value * factor for one, value in terms.items()}
    found = Terms()
    for one, value in terms.items():
        powers = dict(one)
        for atom, power in monomial:
            powers[atom] = powers.get(atom, 0) + power
        _add(found, powers, value * factor)
    return found


def _add(found: Terms, powers: dict[Expr, int], value: Fraction) -> None:
    for atom, power in powers.items():
        if isinstance(atom, sin) and power >= 2:
            less = {**powers, atom: power - 2}
            turned = cos(atom.args[0])
            _add(found, less, value)
            _add(found, {**less, turned: less.get(turned, 0) + 2}, -value)
            return
    monomial = frozenset((atom, power) for atom, power in powers.items() if power)
    total = found.get(monomial, Fraction(0)) + value
    if total:
        found[monomial] = total
    else:
        found.pop(monomial, None)


def difference(one: Mapping[Monomial, Fraction], two: Mapping[Monomial, Fraction]) -> Terms:
    """One less two."""
    found = Terms()
    for monomial in {**one, **two}:
        left = one.get(monomial, Fraction(0)) - two.get(monomial, Fraction(0))
        if left:
            found[monomial] = left
    return found


def total(parts: Iterable[Mapping[Monomial, Fraction]]) -> Terms:
    """Sum of terms."""
    found = Terms()
    for part in parts:
        for monomial, value in part.items():
            found[monomial] = found.get(monomial, Fraction(0)) + value
    return {monomial: value for monomial, value in found.items() if value}


def written(terms: Mapping[Monomial, Fraction]) -> Expr:
    """Terms as a SymPy sum."""
    return Add(
        *(
            Mul(Rational(value.numerator, value.denominator), *(Pow(a, n) for a, n in monomial))
            for monomial, value in terms.items()
        )
    )


def symbols_in(monomial: Monomial) -> set[Expr]:
    """Symbols that a term holds."""
    return set().union(*(atom.free_symbols for atom, _ in monomial)) if monomial else set()

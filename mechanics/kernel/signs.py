"""The sign of an expression at all states, from its form as a quotient of polynomials.

    terms       m x^2 + k > 0 for m, k > 0
    squares     a x^2 + b x + c > 0 where a > 0 and 4 a c - b^2 > 0
    Bernstein   p(c) > 0 on [-1, 1] where all its Bernstein coefficients are positive

The unknowns of the polynomials are the inputs, pi, and every operation that is no arithmetic, with
what is known of it: a root is not negative, a sine lies in [-1, 1]. Squares of sines, roots and
absolute values are written by what they are. A sign is the set of signs that are possible: what is
not shown leaves all three, never one too few.
"""

from collections.abc import Callable, Iterator, Sequence
from itertools import combinations
from math import comb
from typing import NamedTuple

from flint import fmpq, fmpq_mpoly

from mechanics.kernel.numbers import Numbers
from mechanics.kernel.ring import Ring, TooLarge, square_root
from mechanics.program import operations as op
from mechanics.program.builder import Builder
from mechanics.program.program import reachable

NEGATIVE, ZERO, POSITIVE = 1, 2, 4
"""Sets of signs are sums of these."""
ANY = NEGATIVE | ZERO | POSITIVE
NOT_NEGATIVE = ZERO | POSITIVE
NOT_POSITIVE = ZERO | NEGATIVE

MOST_TERMS = 3000
MOST_PRODUCTS = 40_000
MOST_FACTORED = 400
LARGEST_DEGREE = 80
DEEPEST = 6
MOST_CASES = 2
"""Absolute values that are taken apart, one within the other."""
MOST_PUT = 2
"""Constraints that are put in, one after the other."""
MOST_STEPS = 400
"""Polynomials that are looked at for one that is asked for."""
RAISED = (0, 2, 6)
"""By how much the degree of a Bernstein form is raised, one after the other."""


class Quotient(NamedTuple):
    """A quotient of polynomials."""

    above: fmpq_mpoly
    below: fmpq_mpoly


class Fact(NamedTuple):
    """A polynomial whose sign is known where a branch is taken, or a region was stated."""

    polynomial: fmpq_mpoly
    signs: int


Facts = Sequence[Fact]


def negated(signs: int) -> int:
    """Signs of -x."""
    return (signs & ZERO) | (signs >> 2 & 1) | (signs << 2 & 4)


def product(one: int, other: int) -> int:
    """Signs of x y."""
    found = ZERO if (one | other) & ZERO else 0
    if one & POSITIVE:
        found |= other & ~ZERO
    if one & NEGATIVE:
        found |= negated(other) & ~ZERO
    return found


def total(one: int, other: int) -> int:
    """Signs of x + y."""
    if (one | other) & (NEGATIVE | POSITIVE) == NEGATIVE | POSITIVE:
        return ANY
    # All on one side: the sum is zero where both are.
    return ((one | other) & ~ZERO) | (one & other & ZERO)


def power(signs: int, exponent: int) -> int:
    """Signs of x^n for n > 0."""
    if exponent % 2:
        return signs
    return (signs & ZERO) | (POSITIVE if signs & ~ZERO else 0)


class Forms:
    """Quotients of polynomials for nodes of a builder, and their signs.

    Parameters
    ----------
    roots : sequence of int
        Nodes that are asked for.
    positive : callable
        Whether the input of a name is positive.
    """

    def __init__(
        self, builder: Builder, roots: Sequence[int], positive: Callable[[str], bool]
    ) -> None:
        self.builder, self.positive = builder, positive
        needed = reachable(builder, roots)
        arithmetic = {op.CONSTANT, op.ADD, op.SUBTRACT, op.MULTIPLY, op.DIVIDE, op.NEGATE}
        # A sine needs its cosine, too.
        count = 1 + 2 * sum(builder.operations[n] not in arithmetic for n in needed)
        # Contexts are kept by their names: few sizes are few contexts.
        self.ring = Ring(1 << count.bit_length(), limited=False)
        self.one = self.ring.constant(1)
        self.signs = [ANY] * self.ring.capacity
        self.numbers = Numbers()
        self.bounded: set[int] = set()
        self.squares: dict[int, fmpq_mpoly] = {}
        self.absolute: dict[int, fmpq_mpoly] = {}
        self.angles: dict[int, int] = {}
        self._crossings: list[fmpq_mpoly] | None = None
        self.forms: dict[int, Quotient | None] = {}
        self.steps = 0
        for number in needed:
            self.forms[number] = self._form(number)

    # ------------------------------------------------------------------ forms

    def _atom(self, code: int, key: object, signs: int = ANY) -> Quotient:
        """The unknown for an operation on something."""
        place = self.ring.place((code, key))
        self.signs[place] = signs
        if code in (op.TANH, op.SIGN):
            self.bounded.add(place)
        return Quotient(self.ring.gen(place), self.one)

    def _square(self, square: fmpq_mpoly, signs: int) -> int:
        """The place of the unknown of a known square."""
        key = (op.SQRT, str(square))
        self.ring.root(key, 2, square)
        place = self.ring.place(key)
        self.squares[place] = square
        self.signs[place] &= signs
        return place

    def _form(self, number: int) -> Quotient | None:
        builder, (first, second, _) = self.builder, self.builder.operands
        code = builder.operations[number]
        if code == op.CONSTANT:
            return Quotient(self.ring.constant(builder.constants[first[number]]), self.one)
        if code == op.INPUT:
            name = builder.inputs[first[number]]
            return self._atom(op.INPUT, name, POSITIVE if self.positive(name) else ANY)
        if code == op.PI:
            self.numbers.pi(self.ring.place((op.PI, 0)))
            return self._atom(op.PI, 0, POSITIVE)
        if code in (op.ADD, op.SUBTRACT, op.MULTIPLY, op.DIVIDE):
            return self._arithmetic(code, self.forms[first[number]], self.forms[second[number]])
        inner = self.forms.get(first[number])
        if code == op.NEGATE:
            return None if inner is None else Quotient(-inner.above, inner.below)
        return self._opaque(number, code, inner)

    def _arithmetic(self, code: int, a: Quotient | None, b: Quotient | None) -> Quotient | None:
        """The form of an operation on two forms; None where it is too large."""
        if a is None or b is None or (code == op.DIVIDE and b.above == 0):
            return None
        try:
            if code == op.MULTIPLY:
                return Quotient(self._times(a.above, b.above), self._times(a.below, b.below))
            if code == op.DIVIDE:
                return Quotient(self._times(a.above, b.below), self._times(a.below, b.above))
            left, right, below = a.above, b.above, a.below
            if a.below != b.below:
                left, right = self._times(left, b.below), self._times(right, below)
                below = self._times(below, b.below)
        except TooLarge:
            return None
        total = left + right if code == op.ADD else left - right
        return Quotient(total, below) if len(total) <= MOST_TERMS else None

    def _times(self, a: fmpq_mpoly, b: fmpq_mpoly) -> fmpq_mpoly:
        """A product, with squares of sines, roots and absolute values written by what they are."""
        degree = a.total_degree() + b.total_degree()
        if len(a) * len(b) > MOST_PRODUCTS or degree > LARGEST_DEGREE:
            raise TooLarge(f"{len(a)} times {len(b)} terms, degree {degree}")
        found = self.ring.product(a, b)
        if len(found) > MOST_TERMS:
            raise TooLarge(f"{len(found)} terms")
        return found

    def _powers(self, polynomial: fmpq_mpoly, place: int) -> dict[int, fmpq_mpoly]:
        """Coefficients of the powers of one unknown."""
        parts: dict[int, dict[tuple[int, ...], fmpq]] = {}
        for powers, value in polynomial.to_dict().items():
            rest = (*powers[:place], 0, *powers[place + 1 :])
            parts.setdefault(int(powers[place]), {})[rest] = value
        return {k: polynomial.context().from_dict(part) for k, part in sorted(parts.items())}

    def _unknowns(self, polynomial: fmpq_mpoly) -> list[tuple[int, int]]:
        """Places and degrees of what a polynomial holds, in the order in which it was made."""
        degrees = list(enumerate(polynomial.degrees()))
        return [(place, degree) for place, degree in reversed(degrees) if degree]

    def _opaque(self, number: int, code: int, inner: Quotient | None) -> Quotient:
        if code in (op.SIN, op.COS, op.TAN):
            return self._circular(number, code, inner)
        if code in (op.SQRT, op.ABS):
            try:
                known = None if inner is None else (
                    self._root(inner) if code == op.SQRT else self._magnitude(inner)
                )  # fmt: skip
            except TooLarge:
                known = None
            return known or self._atom(code, self._key(number, inner), NOT_NEGATIVE)
        key = self._key(number, inner if op.OPERATIONS[code].arity == 1 else None)
        if code in (op.EXP, op.COSH):
            return self._atom(code, key, POSITIVE)
        if code == op.POWER:
            positive = inner is not None and self.sign_of(inner) == POSITIVE
            return self._atom(code, key, POSITIVE if positive else NOT_NEGATIVE)
        if op.OPERATIONS[code].boolean:
            return self._atom(code, key, NOT_NEGATIVE)
        if code == op.SELECT:
            sides = (self.forms[self.builder.operands[k][number]] for k in (1, 2))
            signs = [ANY if side is None else self.sign_of(side) for side in sides]
            return self._atom(code, key, signs[0] | signs[1])
        return self._atom(code, key)

    def _key(self, number: int, inner: Quotient | None) -> object:
        """What is the same for the same operand; a node whose operand is too large is its own."""
        return number if inner is None else (str(inner.above), str(inner.below))

    def _circular(self, number: int, code: int, inner: Quotient | None) -> Quotient:
        """Sine and cosine of what is the same but for its sign are the same but for its sign."""
        above, turned = (inner.above if inner else None), False
        # Of the same operand, whose form is too large.
        key: object = ("of", self.builder.operands[0][number])
        if inner is not None and above is not None:
            turned = len(above) > 0 and above.leading_coefficient() < 0
            above = -above if turned else above
            key = (str(above), str(inner.below))
        cosine, sine = self.ring.circle(key)
        c, s = self.ring.place(("cos", key)), self.ring.place(("sin", key))
        self.bounded |= {c, s}
        self.squares[s], self.angles[s] = 1 - cosine**2, c
        if inner is not None and above is not None and self.numbers.holds(above * inner.below):
            self.numbers.circular(s, c, above, inner.below)
        sine = -sine if turned else sine
        if code == op.TAN:
            return Quotient(sine, cosine)
        return Quotient(sine if code == op.SIN else cosine, self.one)

    def _root(self, inner: Quotient) -> Quotient | None:
        above, below = inner
        if (whole := square_root(above)) and (under := square_root(below)):
            return self._magnitude(Quotient(whole, under))
        if not below.is_one():
            if self.sign(below) != POSITIVE:
                return None
            above = self._times(above, below)
        signs = self.sign(above) & NOT_NEGATIVE
        place = self._square(above, signs or NOT_NEGATIVE)
        if signs == POSITIVE and self.numbers.holds(above):
            self.numbers.root(place, above)
        return Quotient(self.ring.gen(place), below)

    def _magnitude(self, inner: Quotient) -> Quotient | None:
        signs = self.sign_of(inner)
        if not signs & NEGATIVE:
            return inner
        if not signs & POSITIVE:
            return Quotient(-inner.above, inner.below)
        above, below = inner
        if not below.is_one():
            return None
        place = self._square(self._times(above, above), NOT_NEGATIVE)
        self.absolute[place] = above
        return Quotient(self.ring.gen(place), self.one)

    # ------------------------------------------------------------------ signs

    def sign_of(self, form: Quotient | None, facts: Facts = ()) -> int:
        """Signs of a quotient where it has a value."""
        if form is None:
            return ANY
        below = self.sign(form.below, facts) & ~ZERO
        return product(self.sign(form.above, facts), below)

    def sign(self, polynomial: fmpq_mpoly, facts: Facts = (), depth: int = 0) -> int:
        """Signs of a polynomial where facts hold, of the whole or of its factors."""
        direct = self._by_terms(polynomial)
        known = direct != ANY and not (facts and direct & ZERO)
        if known or not len(polynomial) or len(polynomial) > MOST_FACTORED:
            return direct
        self.steps = self.steps + 1 if depth else 0
        if depth > DEEPEST or self.steps > MOST_STEPS:
            return direct
        unit, factors = polynomial.factor()
        found = POSITIVE if unit > 0 else NEGATIVE
        for factor, exponent in factors:
            found = product(found, power(self._irreducible(factor, facts, depth), exponent))
        return found & direct & self._by_facts(polynomial, facts, DEEPEST)

    def difference(self, left: int, right: int) -> Quotient | None:
        """The form of one node less another; None where it is too large."""
        return self._arithmetic(op.SUBTRACT, self.forms[left], self.forms[right])

    def quotient(self, left: Quotient, right: Quotient) -> Quotient | None:
        """One form over another, without common factors; None where it is too large."""
        found = self._arithmetic(op.DIVIDE, left, right)
        if found is None:
            return None
        common = found.above.gcd(found.below)
        return Quotient(found.above / common, found.below / common)

    def factors(self, polynomial: fmpq_mpoly) -> list[fmpq_mpoly]:
        """Irreducible factors, without constants."""
        return [factor for factor, _ in polynomial.factor()[1]]

    def _by_terms(self, polynomial: fmpq_mpoly) -> int:
        found = ZERO
        for monomial, signs in self._terms(polynomial):
            for place, exponent in enumerate(monomial):
                if exponent:
                    signs = product(signs, power(self.signs[place], exponent))
            found = total(found, signs)
            if found == ANY:
                return ANY
        return found

    def _terms(self, polynomial: fmpq_mpoly) -> Iterator[tuple[tuple[int, ...], int]]:
        """Monomials, and the signs of their coefficients; numbers are part of these."""
        gathered: dict[tuple[int, ...], dict[tuple[int, ...], fmpq]] = {}
        for monomial, coefficient in polynomial.to_dict().items():
            if not self.numbers:
                yield monomial, POSITIVE if coefficient > 0 else NEGATIVE
                continue
            rest = tuple(0 if k in self.numbers else n for k, n in enumerate(monomial))
            own = tuple(n if k in self.numbers else 0 for k, n in enumerate(monomial))
            gathered.setdefault(rest, {})[own] = coefficient
        for rest, terms in gathered.items():
            sign = self.numbers.sign(terms)
            yield rest, ANY if sign is None else (NEGATIVE, ZERO, POSITIVE)[sign + 1]

    def _irreducible(self, factor: fmpq_mpoly, facts: Facts, depth: int) -> int:
        direct = self._by_terms(factor)
        if direct != ANY and not direct & ZERO:
            return direct
        if (known := direct & self._by_facts(factor, facts, depth)) != ANY:
            return known
        if (cases := self._by_cases(factor, facts, depth)) != ANY:
            return cases
        if (ratio := self._crossing(factor)) is not None:
            return NOT_NEGATIVE if ratio > 0 else NOT_POSITIVE
        for sense, polynomial in ((POSITIVE, factor), (NEGATIVE, -factor)):
            found = self._by_squares(polynomial, facts, depth)
            if found == ANY:
                found = self._bernstein(polynomial, facts, depth)
            if found != ANY:
                return found if sense == POSITIVE else negated(found)
        return ANY

    def _crossing(self, factor: fmpq_mpoly) -> fmpq | None:
        """c of c sin^2(a +- b) or c cos^2(a +- b), whose sines are written by their cosines."""
        if self._crossings is None:
            self._crossings, gen = [], self.ring.gen
            for one, other in combinations(self.angles.items(), 2):
                (s, c), (t, d) = (map(gen, places) for places in (one, other))
                for sense in (1, -1):
                    for root in (s * d + sense * c * t, c * d + sense * s * t):
                        self._crossings.append(self.ring.reduced(root**2))
        ratios = (_ratio(factor, square) for square in self._crossings)
        return next((ratio for ratio in ratios if ratio is not None), None)

    def sign_on(self, form: Quotient | None, zero: Sequence[fmpq_mpoly], facts: Facts = ()) -> int:
        """Signs of a quotient where polynomials are zero, which are put into it in turn."""
        direct = self.sign_of(form, facts)
        if form is None or not zero:
            return direct
        if direct != ANY:
            return direct & ~ZERO if self._no_root_is_zero(form, zero, facts) else direct
        below = self.sign(form.below, facts) & ~ZERO
        seen, level = {str(form.above)}, [(form.above, POSITIVE)]
        for _ in range(MOST_PUT):
            following = []
            for polynomial, sense in level:
                for other, turned in self._put(polynomial, zero):
                    if str(other) in seen or len(seen) > MOST_STEPS:
                        continue
                    seen.add(str(other))
                    signs = product(self.sign(other, facts), product(sense, turned))
                    if signs != ANY:
                        return product(signs, below)
                    following.append((other, product(sense, turned)))
            level = following
        return ANY

    def _no_root_is_zero(self, form: Quotient, zero: Sequence[fmpq_mpoly], facts: Facts) -> bool:
        """Whether every factor that may be zero is a root of what is not, on the constraints."""
        for factor in self.factors(form.above):
            if not self.sign(factor, facts) & ZERO:
                continue
            roots = (k for k in self.squares if _ratio(factor, self.ring.gen(k)) is not None)
            inside = next((self.squares[k] for k in roots), None)
            if inside is None:
                return False
            if self.sign_on(Quotient(inside, self.one), zero, facts) & ZERO:
                return False
        return True

    def _put(self, p: fmpq_mpoly, zero: Sequence[fmpq_mpoly]) -> Iterator[tuple[fmpq_mpoly, int]]:
        """Polynomials that are p times a power of what has a sign, where others are zero."""
        terms = p.to_dict()
        for h in zero:
            for place, degree in self._unknowns(h):
                if degree != 1:
                    continue
                held = self._in_sines(p, place) if place in self.angles else p
                most = held.degrees()[place]
                if not most:
                    continue
                parts = self._powers(h, place)
                slope, rest = parts[1], parts.get(0, self.ring.constant(0))
                signs = self.sign(slope)
                if signs & ZERO or signs == ANY:
                    continue
                found = self.ring.constant(0)
                for k, part in self._powers(held, place).items():
                    found += part * (-rest) ** k * slope ** (most - k)
                if len(found) <= MOST_FACTORED:
                    yield self.ring.reduced(found), power(signs, most) if most % 2 else POSITIVE
            for monomial, coefficient in h.to_dict().items():
                if monomial in terms:
                    yield p - h * (terms[monomial] / coefficient), POSITIVE

    def _in_sines(self, p: fmpq_mpoly, sine: int) -> fmpq_mpoly:
        """With squares of a cosine written by its sine, which are written the other way else."""
        found, cosine = self.ring.constant(0), self.angles[sine]
        for k, part in self._powers(p, cosine).items():
            rest = part * self.ring.gen(cosine) if k % 2 else part
            found += rest * (1 - self.ring.gen(sine) ** 2) ** (k // 2)
        return found

    def _by_facts(self, factor: fmpq_mpoly, facts: Facts, depth: int) -> int:
        """What is known: the fact itself, a fact and more, |x| > 0, x^2 > 0."""
        found = ANY
        for fact in facts:
            ratio = _ratio(factor, fact.polynomial)
            if ratio is not None:
                found &= fact.signs if ratio > 0 else negated(fact.signs)
            elif depth < 2 and fact.signs in (POSITIVE, NOT_NEGATIVE):
                for sense in (1, -1):
                    more = self.sign(sense * factor - fact.polynomial, (), depth + 2)
                    if not more & NEGATIVE:
                        signs = total(more, fact.signs)
                        found &= signs if sense > 0 else negated(signs)
                if len(factor) == 1:
                    square = self.ring.product(factor, factor)
                    more = self.sign(square - fact.polynomial, (), depth + 2)
                    if total(more, fact.signs) == POSITIVE:
                        found &= ~ZERO
        if facts and depth < 2:
            for place, inside in self.absolute.items():
                if _ratio(factor, inside) is not None and not (
                    self._by_facts(self.ring.gen(place), facts, depth + 1) & ZERO
                ):
                    found &= ~ZERO
        return found

    def _by_cases(self, factor: fmpq_mpoly, facts: Facts, depth: int) -> int:
        """|x| is x where x is not negative, and -x where it is not positive."""
        degrees = factor.degrees()
        held = next(((e, k) for k, e in self.absolute.items() if degrees[k]), None)
        if held is None or depth > MOST_CASES:
            return ANY
        inside, place = held
        found = 0
        for case in (inside, -inside):
            there = self.ring.reduced(self.ring.put(factor, place, case))
            found |= self.sign(there, (*facts, Fact(case, NOT_NEGATIVE)), depth + 1)
        return found

    def _by_squares(self, p: fmpq_mpoly, facts: Facts, depth: int) -> int:
        """a x^2 + b x + c, in any unknown whose square alone has a sign."""
        for place, degree in self._unknowns(p):
            if degree != 2 or self.signs[place] != ANY:
                continue
            parts = self._powers(p, place)
            a, b, c = (parts.get(k, self.ring.constant(0)) for k in (2, 1, 0))
            first = self.sign(a, facts, depth + 1)
            if first & NEGATIVE:
                continue
            rest = self.sign(4 * a * c - b * b, facts, depth + 1)
            if rest == POSITIVE:
                return POSITIVE
            if not rest & NEGATIVE and first == POSITIVE:
                return NOT_NEGATIVE
        return ANY

    def _bernstein(self, p: fmpq_mpoly, facts: Facts, depth: int) -> int:
        """p on [-1, 1] lies between the least and the largest of its Bernstein coefficients."""
        for place, degree in self._unknowns(p):
            if place not in self.bounded:
                continue
            # In t of x = 2 t - 1, then by the Bernstein polynomials of degree n.
            inner = self._powers(self.ring.put(p, place, 2 * self.ring.gen(place) - 1), place)
            for raised in RAISED:
                n = degree + raised
                found = 0
                # The outer ones are values of p: where these have no sign, none is shown.
                for i in (0, n, *range(1, n)):
                    parts = (
                        part * fmpq(comb(i, j), comb(n, j)) for j, part in inner.items() if j <= i
                    )
                    entry = sum(parts, self.ring.constant(0))
                    found |= self.sign(entry, facts, depth + 1)
                    if found & NEGATIVE:
                        break
                if not found & NEGATIVE:
                    return found
                if i in (0, n):
                    return ANY
            return ANY
        return ANY


def _ratio(one: fmpq_mpoly, other: fmpq_mpoly) -> fmpq | None:
    """c of one = c other; None where there is no such number."""
    if not len(one) or len(one) != len(other):
        return None
    a, b = one.leading_coefficient(), other.leading_coefficient()
    return a / b if one * b == other * a else None

"""Polynomials as nested products, every operation once.

    M s L w^2 + 3/2 M s g c - 4 k x     ->     M s (L w w + (3/2 c) g) - 4 k x

A factor that most terms share is taken out, with all that these terms have in common, and so on
inside (multivariate Horner); what one sum has but for a term of another is built from that one.
Which of two factors comes first is left to a `Choice`, and so is how a product is multiplied:
there is no rule that is best for all, so choices are tried (`mechanics.compiled.forms.fewest`).

Factors are places in a `Table`, and nodes are places in a list, because this is run hundreds of
times.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from sympy import Expr

from mechanics.compiled.forms.closed import Polynomial
from mechanics.compiled.forms.coefficient import Coefficient

Factors = tuple[int, ...]
"""Places in a table, in increasing order; a power is repeated."""

Term = tuple[int, int, Factors]
"""Sign, place of the coefficient, factors."""

Node = tuple[str, int, int]
"""Operation and operands, ``"-"`` with equal operands for a sign; ("leaf", place, 0)."""

Signed = tuple[int, int]
"""A sign and a node."""

ONE = 0
UNIT = Coefficient(Fraction(1))
ZERO = Coefficient(Fraction(0))


@dataclass
class Table:
    """Factors by place: symbols, functions and numbers; the first is 1."""

    keys: list[Expr | Coefficient] = field(default_factory=lambda: [UNIT])
    _places: dict[Expr | Coefficient, int] = field(default_factory=lambda: {UNIT: ONE})
    _negatives: dict[int, int] = field(default_factory=dict)

    def place(self, key: Expr | Coefficient) -> int:
        """The place of a factor, a new one if it has none."""
        if key not in self._places:
            self._places[key] = len(self.keys)
            self.keys.append(key)
        return self._places[key]

    def negative(self, place: int) -> int:
        """The place of minus a number."""
        if place not in self._negatives:
            self._negatives[place] = self.place(-self.keys[place])
        return self._negatives[place]

    def terms(self, polynomial: Polynomial) -> tuple[Term, ...]:
        """A polynomial as terms with positive coefficients."""
        return tuple(
            (_sign(value), self.place(abs(value)), tuple(sorted(map(self.place, parts))))
            for parts, value in polynomial
        )


@dataclass(frozen=True)
class Choice:
    """Everything that a rule would have to decide.

    Attributes
    ----------
    rank : callable
        Of a factor: the smaller, the sooner it is taken out and multiplied.
    negative : callable
        Whether a number is written with its sign, so that the sum around it has the other one.
    """

    rank: Callable[[int], float]
    negative: Callable[[int], bool]


@dataclass
class Nest:
    """Builds sums and products; equal ones are one node."""

    table: Table
    choice: Choice
    nodes: list[Node] = field(default_factory=list)
    _places: dict[Node, int] = field(default_factory=dict)
    _sums: list[tuple[dict[Factors, Signed], Signed]] = field(default_factory=list)
    _folded: dict[frozenset[Signed], int] = field(default_factory=dict)

    def node(self, operation: str, one: int, two: int = 0) -> int:
        """The one node of an operation or leaf."""
        key = (operation, two, one) if two < one and operation in "+*" else (operation, one, two)
        if key not in self._places:
            self._places[key] = len(self.nodes)
            self.nodes.append(key)
        return self._places[key]

    def quotient(
        self, above: Sequence[Term], below: Sequence[Term], factor: int, early: bool
    ) -> int:
        """``factor * above / below``; `early` divides common factors before a sum is multiplied."""
        if not above:
            return self.node("leaf", self.table.place(ZERO))
        number, parts, sign, inner = self._split(above)
        divisor, divisors, other, lower = self._split(below)
        numbers = [place for place in (number, factor) if place != ONE]
        if numbers and (sign * other < 0 or numbers[0] == self.table.place(-UNIT)):
            numbers[0], sign = self.table.negative(numbers[0]), -sign
        numbers = [place for place in numbers if place != ONE]
        factors = [*([divisor] * (divisor != ONE)), *divisors]
        if early and not lower and factors and parts:
            ratio = self.node("/", self.product(parts), self.product(factors))
            value = self.product(numbers, [ratio, *inner])
        else:
            value = self.product([*numbers, *parts], inner)
            if factors or lower:
                value = self.node("/", value, self.product(factors, lower))
        return value if sign * other > 0 else self.node("-", value, value)

    def _split(self, terms: Sequence[Term]) -> tuple[int, Factors, int, list[int]]:
        """Common coefficient and factors, and sign and node of a sum of what is left."""
        number, parts, rest = _common(self._signed(terms))
        if len(rest) == 1:
            return number, parts, rest[0][0], []
        sign, inner = self.total(rest)
        return number, parts, sign, [inner]

    def _signed(self, terms: Sequence[Term]) -> list[Term]:
        """Terms with the numbers that are chosen to be negative."""
        return [
            (-sign, self.table.negative(number), parts)
            if number != ONE and self.choice.negative(number)
            else (sign, number, parts)
            for sign, number, parts in terms
        ]

    def product(self, factors: Iterable[int], nodes: Sequence[int] = ()) -> int:
        """Multiply from the left in the order of rank, sums last."""
        ordered = sorted(factors, key=self.choice.rank)
        parts = [*(self.node("leaf", factor) for factor in ordered), *nodes]
        result = parts[0] if parts else self.node("leaf", ONE)
        for part in parts[1:]:
            result = self.node("*", result, part)
        return result

    def total(self, terms: Sequence[Term]) -> Signed:
        """A sum, up to its sign."""
        number, parts, rest = _common(terms)
        factors = _factors(number, parts)
        if len(rest) == 1:
            return rest[0][0], self.product(factors)
        if factors:
            sign, inner = self.total(rest)
            return sign, self.product(factors, [inner])
        return self._known(rest) or self._primitive(rest)

    def _primitive(self, terms: Sequence[Term]) -> Signed:
        """A sum whose terms have nothing in common."""
        items: list[Signed] = []
        rest = list(terms)
        while (shared := self._shared(rest)) is not None:
            inside = [term for term in rest if shared == term[1] or shared in term[2]]
            rest = [term for term in rest if not (shared == term[1] or shared in term[2])]
            items.append(self.total(inside))
        items += [self.total([term]) for term in rest]
        signed = self._fold(items)
        self._sums.append(({parts: (sign, number) for sign, number, parts in terms}, signed))
        return signed

    def _shared(self, terms: Sequence[Term]) -> int | None:
        """The factor that most terms have, of several the one of least rank."""
        counts: dict[int, int] = {}
        for _, number, parts in terms:
            for factor in {number, *parts} - {ONE}:
                counts[factor] = counts.get(factor, 0) + 1
        often = max(counts.values(), default=0)
        if often < 2:
            return None
        return min((f for f, n in counts.items() if n == often), key=self.choice.rank)

    def _known(self, terms: Sequence[Term]) -> Signed | None:
        """The sum as a sum that is there, plus what is left, where that costs less."""
        wanted = {parts: (sign, number) for sign, number, parts in terms}
        least, best = _cost(terms), None
        for known, (sign, node) in self._sums:
            # All of it has to be wanted: the value of an unknown that came in might need this.
            if not known.keys() <= wanted.keys():
                continue
            for way in (1, -1):
                left = self._without(wanted, known, way)
                cost = _cost(left) + (1 if left else 0)
                if cost < least:
                    least, best = cost, (left, (way * sign, node))
        if best is None:
            return None
        left, signed = best
        return self._fold([signed, self.total(left)]) if left else signed

    def _without(
        self, wanted: dict[Factors, Signed], known: dict[Factors, Signed], way: int
    ) -> list[Term]:
        """``wanted - way * known``."""
        keys, found = self.table.keys, []
        for parts in {**wanted, **known}:
            sign, number = wanted.get(parts, (0, ONE))
            other, taken = known.get(parts, (0, ONE))
            if (sign, number) == (way * other, taken):
                continue
            one, two = keys[number], keys[taken]
            if sign and other and one.powers != two.powers:
                return list(_as_terms(wanted))
            value = Coefficient(
                sign * one.ratio - way * other * two.ratio, one.powers if sign else two.powers
            )
            if value.ratio:
                found.append((_sign(value), self.table.place(abs(value)), parts))
        return found

    def _fold(self, items: Sequence[Signed]) -> Signed:
        """Add up; a positive item stands first, and the negative of a known sum is that sum."""
        positive = sorted(node for sign, node in items if sign > 0)
        negative = sorted(node for sign, node in items if sign < 0)
        sign = 1
        if not positive:
            positive, negative, sign = negative, [], -1
        flipped = frozenset([*((-1, n) for n in positive), *((1, n) for n in negative)])
        if flipped in self._folded:
            return -sign, self._folded[flipped]
        result = positive[0]
        for node in positive[1:]:
            result = self.node("+", result, node)
        for node in negative:
            result = self.node("-", result, node)
        self._folded[frozenset((-s, n) for s, n in flipped)] = result
        return sign, result


def _sign(value: Coefficient) -> int:
    return 1 if value.positive else -1


def _as_terms(polynomial: dict[Factors, Signed]) -> Iterable[Term]:
    return ((sign, number, parts) for parts, (sign, number) in polynomial.items())


def _factors(number: int, parts: Factors) -> Factors:
    return parts if number == ONE else (number, *parts)


def _common(terms: Sequence[Term]) -> tuple[int, Factors, list[Term]]:
    """What all terms have: their coefficient where it is the same, factors; and what is left."""
    number = terms[0][1] if all(term[1] == terms[0][1] for term in terms) else ONE
    shared = terms[0][2]
    for _, _, parts in terms[1:]:
        if not shared:
            break
        shared = _both(shared, parts)
    if number == ONE and not shared:
        return number, shared, list(terms)
    return (
        number,
        shared,
        [(s, ONE if number != ONE else c, _less(parts, shared)) for s, c, parts in terms],
    )


def _both(one: Factors, two: Factors) -> Factors:
    rest, found = list(two), []
    for factor in one:
        if factor in rest:
            rest.remove(factor)
            found.append(factor)
    return tuple(found)


def _less(parts: Factors, taken: Factors) -> Factors:
    rest = list(parts)
    for factor in taken:
        rest.remove(factor)
    return tuple(rest)


def _cost(terms: Sequence[Term]) -> int:
    """Operations of a sum, nothing shared."""
    each = (max(len(parts) + (number != ONE) - 1, 0) for _, number, parts in terms)
    return sum(each) + max(len(terms) - 1, 0)

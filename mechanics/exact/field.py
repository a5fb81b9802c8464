"""A random point of a finite field: zero there is zero everywhere, but for a computed chance.

A false statement left = right is a fraction E = N / D whose numerator is not the zero polynomial in
what is drawn: symbols and constants (lines), circle points (c, s) of base angles, values of opaque
functions (lines). Sampling misses that with a probability of at most

    P  <=  R (2 deg N / |S|  +  h / ((b - 1) |primes|))                                        (1)

First term, Schwartz and Zippel: lines are sampled from S, at least the (p - 1)/2 nonzero squares
(positive symbols), and N has at most deg zeros in each variable. On a circle a polynomial of degree
m in (c, s) is a Laurent polynomial z**-m ... z**m in z = c + i s, so it has at most 2 m zeros among
its points; splitting off the leading coefficient variable by variable gives 2 deg N / |S| in all.
Second term: if N is not zero over the rationals but zero mod p, then p divides all coefficients; an
integer below 2**h has at most h / (b - 1) prime divisors of b bits. (On circles the coefficients
are Gaussian integers, and a prime that is 3 mod 4 stays prime there.) R is the largest number of
points that may be drawn until one is admissible: the union bound over them.

Roots. w = x**(1/k) joins a new element to the field of fractions. If x is no k-th power there
(k prime), w has k conjugates, N is replaced by its norm, the product over the conjugates, and its
degree and height grow k times; W = (P Q**(k-1))**(1/k) for x = P / Q grows like a polynomial of
degree (deg P + (k-1) deg Q)/k along every ray, whatever the branch, so norms are covered by the same
rules. If x = y**k for odd k, then w = y, in the reals as in the field (where odd roots are unique).
If x = y**2, then w = +y or -y, in the reals by the sign of y and in the field by its quadratic
character, and these may differ: see `field_trial`, which tells the two cases apart.

Congruence. Opaque functions and angle atoms are looked up by the residues of their arguments; two
different arguments meet with a probability that is a degree over |S| again. These and the places
where an experiment branches on `is_zero` or `rank` are summed up in `Size`.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import isqrt, lcm, log2

import sympy

from mechanics.errors import ExpressionError
from mechanics.exact import field_linear
from mechanics.exact.arithmetic import Arithmetic, Term, as_fraction
from mechanics.exact.field_number import FieldNumber
from mechanics.exact.signals import DivisionHere, Inadmissible, Restart

Number = FieldNumber


@dataclass
class Memory:
    """What one statement has learnt over its runs; atoms and roots are counted in order.

    Attributes
    ----------
    denominators : dict
        For every angle (``"circle"``) or exponent atom: the common denominator of its factors.
    not_squares : set of int
        Square roots whose radicand was seen to be no square.
    opaque : dict
        Names of functions that are only known by congruence.
    """

    denominators: dict[tuple[str, int], int] = field(default_factory=dict)
    not_squares: set[int] = field(default_factory=set)
    opaque: dict[str, None] = field(default_factory=dict)


@dataclass
class Size:
    """Degree and log2 height of a product of numerators."""

    degree: float = 0.0
    height: float = 0.0

    def add(self, number: FieldNumber) -> None:
        """Count numerator and denominator of one more number."""
        self.degree += number.numerator + number.denominator
        self.height += 2 * number.height + 1


class FieldArithmetic(Arithmetic):
    """Arithmetic at one random point modulo one prime.

    Parameters
    ----------
    prime : int
        As `primes.draw_prime` gives it.
    source : random.Random
        Where the point comes from.
    memory : Memory
        Shared by the runs of one statement.
    real : bool
        False for a *probe*: positive symbols are drawn from the whole field and roots with either
        sign, so that radicands which are no squares show it.
    """

    def __init__(
        self, prime: int, source: random.Random, memory: Memory, real: bool = True
    ) -> None:
        super().__init__()
        self.prime, self._source, self._memory, self._real = prime, source, memory, real
        self._constants: dict[Fraction, FieldNumber] = {}
        self._ratios: dict[int, Fraction] = {}
        self._tokens: dict[tuple[int, int], int] = {}
        self._last_token = 0
        self._atoms: dict[tuple[object, ...], FieldNumber] = {}
        self._angles: dict[tuple[str, int], int] = {}
        self._bases: dict[tuple[str, int], tuple[int, int]] = {}
        self._roots: dict[tuple[int, int], FieldNumber] = {}
        self._lookups = 0
        self._looked_up = Size()
        self._side = Size()
        self.square_roots = 0
        self.log2_conjugates = 0.0

    # ------------------------------------------------------------------ tokens of denominators

    def new_token(self) -> int:
        """Return the token of a denominator not seen before."""
        self._last_token += 1
        return self._last_token

    def common_token(self, one: int, two: int) -> int:
        """Return the token of a product of denominators (of a power, for a negative `two`)."""
        key = (one, two) if two < one else (two, one)
        if key not in self._tokens:
            self._tokens[key] = self.new_token()
        return self._tokens[key]

    # ------------------------------------------------------------------ leaves

    def rational(self, number: int | Fraction) -> FieldNumber:
        """Return a rational modulo the prime."""
        ratio = as_fraction(number)
        if ratio not in self._constants:
            numerator, denominator = ratio.numerator, ratio.denominator
            if denominator % self.prime == 0:
                raise DivisionHere("the prime divides a denominator")
            residue = numerator * pow(denominator, -1, self.prime) % self.prime
            height = log2(max(abs(numerator), denominator))
            self._ratios[residue] = ratio
            self._constants[ratio] = FieldNumber(self, residue, 0, 0, height, 0)
        return self._constants[ratio]

    def _draw(self, positive: bool) -> FieldNumber:
        residue = self._source.randrange(1, self.prime)
        if positive and self._real:
            residue = residue * residue % self.prime
        return FieldNumber(self, residue, 1, 0, 0, 0)

    def symbol(self, symbol: sympy.Symbol) -> FieldNumber:
        """Draw a symbol: from the squares if it is positive, minus a square if negative."""
        if symbol.is_negative:
            return -self._draw(True)
        return self._draw(bool(symbol.is_nonnegative))

    def constant(self, constant: sympy.Expr) -> FieldNumber:
        """Draw pi, E, ... as a positive variable: what holds identically holds for its value."""
        return self._draw(True)

    # ------------------------------------------------------------------ angles and exponents

    def _sighted(self, number: FieldNumber) -> None:
        """Count an argument that is looked up by its residue."""
        self._lookups += 1
        self._looked_up.add(number)

    def _multiples(self, kind: str, terms: Sequence[Term]) -> dict[int, int]:
        """Return {atom: integer multiple of its base}; equal and opposite arguments are one atom.

        Raises
        ------
        Restart
            If an atom needs a finer base than this run has given it.
        """
        factors: dict[int, Fraction] = {}
        for factor, number in terms:
            residue = number.residue
            if residue == 0:
                self._sighted(number)
                continue
            if (kind, residue) in self._angles:
                atom = self._angles[kind, residue]
            elif (kind, self.prime - residue) in self._angles:
                atom, factor = self._angles[kind, self.prime - residue], -factor
            else:
                self._sighted(number)
                atom = self._angles[kind, residue] = len(self._angles)
            factors[atom] = factors.get(atom, Fraction(0)) + factor
        return {atom: self._multiple(kind, atom, factor) for atom, factor in factors.items()}

    def _multiple(self, kind: str, atom: int, factor: Fraction) -> int:
        common = self._memory.denominators.setdefault((kind, atom), 1)
        if common % factor.denominator:
            self._memory.denominators[kind, atom] = lcm(common, factor.denominator)
            raise Restart(f"base angle over {factor.denominator}")
        return int(factor * common)

    def circle(self, terms: Sequence[Term]) -> tuple[FieldNumber, FieldNumber]:
        """Add multiples of points of the unit circle; cos and sin have degree sum |m|."""
        c, s, degree, p = 1, 0, 0, self.prime
        for atom, multiple in self._multiples("circle", terms).items():
            x, y = self._power_of_base(atom, abs(multiple))
            if multiple < 0:
                y = -y
            c, s, degree = (c * x - s * y) % p, (s * x + c * y) % p, degree + abs(multiple)
        return FieldNumber(self, c, degree, 0, 1, 0), FieldNumber(self, s, degree, 0, 1, 0)

    def _power_of_base(self, atom: int, multiple: int) -> tuple[int, int]:
        """Return (c + i s)**multiple; (1 - t**2, 2 t) / (1 + t**2) reaches all points but one."""
        p = self.prime
        if ("base", atom) not in self._bases:
            t = self._source.randrange(p)
            scale = pow(1 + t * t, -1, p)
            self._bases["base", atom] = ((1 - t * t) * scale % p, 2 * t * scale % p)
        x, y = self._bases["base", atom]
        c, s = 1, 0
        while multiple:
            if multiple & 1:
                c, s = (c * x - s * y) % p, (s * x + c * y) % p
            x, y, multiple = (x * x - y * y) % p, 2 * x * y % p, multiple >> 1
        return c, s

    def exponential(self, terms: Sequence[Term]) -> FieldNumber:
        """Multiply powers of exp(base), each base a positive variable."""
        result = self.rational(1)
        for atom, multiple in self._multiples("exp", terms).items():
            result = result * self._atom(("exp", atom), positive=True) ** multiple
        return result

    # ------------------------------------------------------------------ roots

    def root_power(self, number: FieldNumber, exponent: Fraction) -> FieldNumber:
        """Return a rational power, root by prime root.

        Raises
        ------
        Inadmissible
            If the radicand is no square here: squares play the positive numbers.
        ExpressionError
            If the denominator of the exponent has a prime factor above 7.
        """
        degree, root = exponent.denominator, number
        for k in (2, 3, 5, 7):
            while degree % k == 0:
                root, degree = self._root(root, k), degree // k
        if degree != 1:
            raise ExpressionError(
                f"power {exponent}: roots of degree 2, 3, 5, 7 and their products only; rewrite it"
            )
        return root**exponent.numerator

    def _root(self, x: FieldNumber, k: int) -> FieldNumber:
        if x.residue == 0:
            self._side.add(x)
            return self.rational(0)
        key = (k, x.residue)
        if key not in self._roots:
            self._sighted(x)
            ratio = self._ratios.get(x.residue) if k == 2 and not x.numerator else None
            self._roots[key] = self._new_root(x, k) if ratio is None else self._surd(ratio)
        return self._roots[key]

    def _surd(self, ratio: Fraction) -> FieldNumber:
        """Return the root of a rational; those of 2, 3, 5 and 7 exist by the choice of the prime."""
        if ratio < 0:
            raise Inadmissible("a radicand is negative")
        rest, result = ratio.numerator * ratio.denominator, self.rational(1)
        for q in (2, 3, 5, 7):
            count = 0
            while rest % q == 0:
                rest, count = rest // q, count + 1
            result = result * q ** (count // 2)
            if count % 2:
                result = result * self._surd_of_prime(q)
        if isqrt(rest) ** 2 == rest:
            return result * isqrt(rest) / ratio.denominator
        return result * self._new_root(self.rational(rest), 2) / ratio.denominator

    def _surd_of_prime(self, q: int) -> FieldNumber:
        """Return the root of 2, 3, 5 or 7: joined before all others, so never of a square."""
        if ("surd", q) not in self._atoms:
            self.log2_conjugates += 1
            residue = pow(q, (self.prime + 1) // 4, self.prime)
            self._atoms["surd", q] = FieldNumber(self, residue, 0, 0, log2(q), 0)
        return self._atoms["surd", q]

    def _new_root(self, x: FieldNumber, k: int) -> FieldNumber:
        p = self.prime
        square = pow(x.residue, (p - 1) // 2, p) == 1
        if k == 2:
            self.square_roots += 1
            if not square:
                self._memory.not_squares.add(self.square_roots - 1)
        if not square and (k == 2 or self._real):
            raise Inadmissible("a radicand is negative")
        self.log2_conjugates += log2(k)
        # Squares form a group of odd order (p - 1)/2, prime to k: the k-th root in it is unique.
        residue = pow(x.residue, pow(k, -1, (p - 1) // 2), p)
        if not square or (not self._real and k == 2 and self._source.random() < 0.5):
            residue = p - residue
        degree = (x.numerator + (k - 1) * x.denominator) / k
        return FieldNumber(self, residue, degree, x.denominator, x.height, x.token)

    def require_positive(self, number: FieldNumber) -> None:
        """Ask for another point unless the residue is a nonzero square."""
        if self._real and pow(number.residue, (self.prime - 1) // 2, self.prime) != 1:
            raise Inadmissible("a quantity that must be positive is not")

    # ------------------------------------------------------------------ known by congruence only

    def _atom(self, key: tuple[object, ...], positive: bool = False) -> FieldNumber:
        if key not in self._atoms:
            self._atoms[key] = self._draw(positive)
        return self._atoms[key]

    def absolute(self, number: FieldNumber) -> FieldNumber:
        """Return a positive variable that |x| and |-x| share."""
        self._memory.opaque["absolute value"] = None
        self._sighted(number)
        return self._atom(("abs", min(number.residue, self.prime - number.residue)), positive=True)

    def sign(self, number: FieldNumber) -> FieldNumber:
        """Return |x| / x, so that x sign(x) = |x|."""
        return self.absolute(number) / number

    def indicator(self, relation: str, difference: FieldNumber) -> FieldNumber:
        """Return a variable; ``x < 0`` is the complement of ``-x <= 0``."""
        self._memory.opaque["comparison"] = None
        self._sighted(difference)
        residue = difference.residue
        if relation == "<=":
            return 1 - self._atom(("<", -residue % self.prime))
        if relation == "==":
            residue = min(residue, self.prime - residue)
        return self._atom((relation, residue))

    def select(self, condition: FieldNumber, yes: FieldNumber, no: FieldNumber) -> FieldNumber:
        """Return h yes + (1 - h) no: what holds for every h holds for 0 and 1."""
        return condition * yes + (1 - condition) * no

    def function(self, name: str, arguments: Sequence[FieldNumber]) -> FieldNumber:
        """Return a variable for each name and arguments."""
        self._memory.opaque[name] = None
        for argument in arguments:
            self._sighted(argument)
        return self._atom((name, *(argument.residue for argument in arguments)))

    # ------------------------------------------------------------------ linear algebra, bound

    def solve(
        self, rows: Sequence[Sequence[FieldNumber]], rhs: Sequence[FieldNumber]
    ) -> list[FieldNumber]:
        """Solve by elimination; the bounds are Cramer's."""
        return field_linear.solve(self, rows, rhs)

    def rank(self, rows: Sequence[Sequence[FieldNumber]]) -> int:
        """Return the rank; it is the rank at almost every point, but for a counted chance."""
        return field_linear.rank(self, rows)

    def is_zero(self, number: FieldNumber) -> bool:
        """Tell whether the residue is zero; an experiment that branches on it is counted."""
        number = self.rational(0) + number
        self._side.add(number)
        return number.residue == 0

    def count_branch(self, degree: float, height: float) -> None:
        """Count a place where the experiment branches on something that may vanish by chance."""
        self._side.degree += degree
        self._side.height += height

    def total_size(self, differences: Sequence[FieldNumber]) -> Size:
        """Return degree and height, summed over the statements and all side events, of (1)."""
        total = Size(self._side.degree, self._side.height)
        total.degree += self._lookups * self._looked_up.degree
        total.height += self._lookups * self._looked_up.height
        for number in differences:
            total.add(number)
        return total

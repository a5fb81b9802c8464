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

Congruence. Opaque functions, roots and angle atoms are looked up by the residues of their
arguments; two different arguments meet with a probability that is a degree over |S| again. These
and the places where an experiment branches on `is_zero` or `rank` are summed up beside deg N.
Roots: see `field_roots`.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction
from math import lcm, log2

import sympy

from mechanics.exact import field_linear, field_roots
from mechanics.exact.arithmetic import Arithmetic, Term, as_fraction
from mechanics.exact.field_number import FieldNumber
from mechanics.exact.field_size import Memory, Size
from mechanics.exact.signals import DivisionHere, Inadmissible, Restart


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
    signs : bool
        True to take |x| for x or -x, whichever is a square, and ``x < 0`` for "x is no square";
        False to take them for unknown functions. See `field_trial`.
    """

    def __init__(
        self, prime: int, source: random.Random, memory: Memory,
        real: bool = True, signs: bool = False,
    ) -> None:  # fmt: skip
        super().__init__()
        self.prime, self.source, self.memory, self.real = prime, source, memory, real
        self._signs = signs
        self.numbers = 0
        self.kinks: set[int] = set()
        self._constants: dict[Fraction, FieldNumber] = {}
        self.ratios: dict[int, Fraction] = {}
        self._tokens: dict[tuple[int, int], int] = {}
        self._last_token = 0
        self.atoms: dict[tuple[object, ...], FieldNumber] = {}
        self._angles: dict[tuple[str, int], int] = {}
        self._bases: dict[tuple[str, int], tuple[int, int]] = {}
        self.roots: dict[tuple[int, int], FieldNumber] = {}
        self._lookups = 0
        self._looked_up = Size()
        self.side = Size()
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
            self.ratios[residue] = ratio
            self._constants[ratio] = FieldNumber(self, residue, 0.0, 0.0, height, 0)
        return self._constants[ratio]

    def draw(self, positive: bool) -> FieldNumber:
        """Return a new variable."""
        residue = self.source.randrange(1, self.prime)
        if positive and self.real:
            residue = residue * residue % self.prime
        return FieldNumber(self, residue, 1.0, 0.0, 0.0, 0)

    def symbol(self, symbol: sympy.Symbol) -> FieldNumber:
        """Draw a symbol: from the squares if it is positive, minus a square if negative."""
        if symbol.is_negative:
            return -self.draw(True)
        return self.draw(bool(symbol.is_nonnegative))

    def constant(self, constant: sympy.Expr) -> FieldNumber:
        """Draw pi, E, ... as a positive variable: what holds identically holds for its value."""
        return self.draw(True)

    # ------------------------------------------------------------------ angles and exponents

    def sighted(self, number: FieldNumber) -> None:
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
                self.sighted(number)
                continue
            if (kind, residue) in self._angles:
                atom = self._angles[kind, residue]
            elif (kind, self.prime - residue) in self._angles:
                atom, factor = self._angles[kind, self.prime - residue], -factor
            else:
                self.sighted(number)
                atom = self._angles[kind, residue] = len(self._angles)
            factors[atom] = factors.get(atom, Fraction(0)) + factor
        return {atom: self._multiple(kind, atom, factor) for atom, factor in factors.items()}

    def _multiple(self, kind: str, atom: int, factor: Fraction) -> int:
        common = self.memory.denominators.setdefault((kind, atom), 1)
        if common % factor.denominator:
            self.memory.denominators[kind, atom] = lcm(common, factor.denominator)
            raise Restart(f"base angle over {factor.denominator}")
        return int(factor * common)

    def circle(self, terms: Sequence[Term]) -> tuple[FieldNumber, FieldNumber]:
        """Add multiples of points of the unit circle; cos and sin have degree sum |m|."""
        c, s, degree, p = 1, 0, 0.0, self.prime
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
            t = self.source.randrange(p)
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
            result = result * self.atom(("exp", atom), positive=True) ** multiple
        return result

    # ------------------------------------------------------------------ roots

    def root_power(self, number: FieldNumber, exponent: Fraction) -> FieldNumber:
        """Return a rational power; squares play the positive numbers."""
        return field_roots.power(self, number, exponent)

    def require_positive(self, number: FieldNumber) -> None:
        """Ask for another point unless the residue is a nonzero square."""
        if self.real and pow(number.residue, (self.prime - 1) // 2, self.prime) != 1:
            raise Inadmissible("a quantity that must be positive is not")

    # ------------------------------------------------------------------ known by congruence only

    def atom(self, key: tuple[object, ...], positive: bool = False) -> FieldNumber:
        """Return the variable of a key, drawn when it is first asked for."""
        if key not in self.atoms:
            self.atoms[key] = self.draw(positive)
        return self.atoms[key]

    def _is_negative(self, number: FieldNumber) -> bool:
        """Tell whether a residue is no square, and count it up to sign."""
        self.kinks.add(min(number.residue, self.prime - number.residue))
        return pow(number.residue, (self.prime - 1) // 2, self.prime) != 1

    def absolute(self, number: FieldNumber) -> FieldNumber:
        """Return a positive variable that |x| and |-x| share (or x or -x, by its character)."""
        self.memory.opaque["absolute value"] = None
        self.sighted(number)
        if self._signs:
            return -number if self._is_negative(number) else number
        return self.atom(("abs", min(number.residue, self.prime - number.residue)), positive=True)

    def sign(self, number: FieldNumber) -> FieldNumber:
        """Return |x| / x, so that x sign(x) = |x|."""
        return self.absolute(number) / number

    def indicator(self, relation: str, difference: FieldNumber) -> FieldNumber:
        """Return a variable; ``x < 0`` is the complement of ``-x <= 0``."""
        self.memory.opaque["comparison"] = None
        self.sighted(difference)
        if self._signs and relation != "==":
            return self.rational(int(self._is_negative(difference)))
        residue = difference.residue
        if relation == "<=":
            return 1 - self.atom(("<", -residue % self.prime))
        if relation == "==":
            residue = min(residue, self.prime - residue)
        return self.atom((relation, residue))

    def select(self, condition: FieldNumber, yes: FieldNumber, no: FieldNumber) -> FieldNumber:
        """Return h yes + (1 - h) no: what holds for every h holds for 0 and 1."""
        return condition * yes + (1 - condition) * no

    def function(self, name: str, arguments: Sequence[FieldNumber]) -> FieldNumber:
        """Return a variable for each name and arguments."""
        self.memory.opaque[name] = None
        for argument in arguments:
            self.sighted(argument)
        return self.atom((name, *(argument.residue for argument in arguments)))

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
        self.side.add(number)
        return number.residue == 0

    def count_branch(self, degree: float, height: float) -> None:
        """Count a place where the experiment branches on something that may vanish by chance."""
        self.side.degree += degree
        self.side.height += height

    def total_size(self, differences: Sequence[FieldNumber]) -> Size:
        """Return degree and height, summed over the statements and all side events, of (1)."""
        total = Size(self.side.degree, self.side.height)
        total.degree += self._lookups * self._looked_up.degree
        total.height += self._lookups * self._looked_up.height
        for number in differences:
            total.add(number)
        return total

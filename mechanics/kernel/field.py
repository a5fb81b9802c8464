"""The field: a program's values at one random point modulo one prime.

Inputs, circle points of base angles and values of functions that are known by congruence only are
drawn. Operations of arithmetic are those of the field. For the rest, with "square" for a nonzero
quadratic residue:

- sine and cosine are looked up by the residue of the base angle, equal and opposite angles are one;
  a rational multiple r pi is the point of order 2 / r that goes with the principal roots of 2, 3,
  5 and 7;
- x**(1/k) is the k-th root among the squares. They form a group of odd order (p - 1)/2, prime to 2,
  3, 5 and 7, so that sqrt(a b) = sqrt(a) sqrt(b) and sqrt(L**2) = L hold whenever a, b and L are
  squares, as they do for positive numbers. A radicand that is no square is a negative one: the
  point is drawn again;
- exp, log, arc functions, erf, floor: one variable for each argument;
- |x| and x < y: either variables that |x| and |-x| share, or, with `signs`, read off the quadratic
  character, squares playing the positive numbers. The second knows more and proves less: see
  `trial`.
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from math import gcd, isqrt, prod
from operator import add, neg, sub

from flint import fmpz_mod_ctx, fmpz_mod_mat, fmpz_mod_poly_ctx, fq_default, fq_default_ctx

from mechanics.errors import MechanicsError
from mechanics.kernel.draws import Draws
from mechanics.kernel.sizes import ROOTS, is_algebraic, prime_factors
from mechanics.kernel.statement import Range


class Inadmissible(MechanicsError, ArithmeticError):
    """This point is no admissible state: draw another one."""


class DivisionHere(Inadmissible):
    """A divisor or a determinant is zero at this point, or everywhere."""


ODD = ("asin", "atan", "asinh", "atanh", "erf")


class Residues:
    """The domain of residues modulo a prime, at one point.

    Parameters
    ----------
    prime : int
        As `primes.draw_prime` gives it for `modulus`.
    draws : Draws
        Where the point comes from.
    turns : sequence of Fraction
        Multiples of pi whose sine or cosine is taken.
    squares : bool
        False for a *probe*: inputs are drawn from the whole field whatever their range, and nothing
        is asked of odd roots, so that radicands which are no squares show it.
    signs : bool
        Whether |x| and comparisons are read off the quadratic character.

    Attributes
    ----------
    square_roots : int
        Number of different square roots that have been asked for.
    not_square : int or None
        The number of the one whose radicand was seen to be no square; all before it are squares.
    kinks : set of int
        What |x| and comparisons were taken of, up to sign.
    """

    def __init__(
        self, prime: int, modulus: int, draws: Draws, turns: Sequence[Fraction] = (),
        *, squares: bool = True, signs: bool = False,
    ) -> None:  # fmt: skip
        self.prime = p = prime
        self._draws, self._squares, self._signs = draws, squares, signs
        self.square_roots = 0
        self.not_square: int | None = None
        self.kinks: set[int] = set()
        self._ratios: dict[int, Fraction] = {}
        self._variables: dict[tuple[object, ...], int] = {}
        self._points: dict[int, tuple[int, int]] = {0: (1, 0)}
        self._roots: dict[tuple[int, int], int] = {}
        self._pi = self._drawn(positive=True)
        self.turn(turns, modulus)
        self.operations: Mapping[str, Callable[..., int]] = {
            "add": add, "subtract": sub, "negate": neg,
            "multiply": lambda x, y: x * y % p,
            "divide": self._quotient,
            "sin": lambda x: self._point(x)[1], "cos": lambda x: self._point(x)[0],
            "sqrt": lambda x: self._root(x % p, 2), "power": self._power, "exp": self._exponential,
            "log": lambda x: 0 if x % p == 1 else self._value("log", x),
            "acos": lambda x: self._value("acos", x), "acosh": lambda x: self._value("acosh", x),
            "floor": self._floor, "atan2": lambda y, x: self._value("atan2", y, x),
            "abs": lambda x: self._absolute(x % p), "sign": self._sign,
            "less": lambda x, y: self._less((x - y) % p),
            "not_greater": lambda x, y: 1 - self._less((y - x) % p),
            "equal": lambda x, y: self._equal((x - y) % p),
            "and": lambda x, y: x * y % p, "or": lambda x, y: (x + y - x * y) % p,
            "not": lambda x: 1 - x,
            "select": lambda c, x, y: (c * x + (1 - c) * y) % p,
            **{name: self._odd(name) for name in ODD},
        }  # fmt: skip

    # ------------------------------------------------------------------ leaves

    def _drawn(self, positive: bool = False) -> int:
        residue = 1 + self._draws.below(self.prime - 1)
        return residue * residue % self.prime if positive and self._squares else residue

    def input(self, known: Range) -> int:
        """An input of that range: a square if it is positive, minus a square if negative."""
        if known is Range.NEGATIVE:
            return -self._drawn(positive=True) % self.prime
        return self._drawn(positive=known is not Range.FREE)

    def constant(self, value: Fraction) -> int:
        """A rational."""
        if value.denominator % self.prime == 0:
            raise DivisionHere("the prime divides a denominator")
        residue = value.numerator * pow(value.denominator, -1, self.prime) % self.prime
        self._ratios[residue] = value
        return residue

    def pi(self) -> int:
        """A variable: what holds for every value holds for that of pi."""
        return self._pi

    # ------------------------------------------------------------------ arithmetic

    def _quotient(self, x: int, y: int) -> int:
        y %= self.prime
        if not y:
            raise DivisionHere("division by zero")
        return x * pow(y, -1, self.prime) % self.prime

    def solve(
        self, matrix: Sequence[Sequence[int]], right: Sequence[int], symmetric: bool
    ) -> list[int]:
        """x of a square system.

        Raises
        ------
        DivisionHere
            If the matrix is singular here.
        """
        p = self.prime
        context = fmpz_mod_ctx(p)
        left = fmpz_mod_mat([[entry % p for entry in row] for row in matrix], context)
        try:
            solution = left.solve(fmpz_mod_mat([[side % p] for side in right], context))
        except ZeroDivisionError as error:
            raise DivisionHere("singular matrix") from error
        return [int(entry) for entry in solution.entries()]

    # ------------------------------------------------------------------ angles

    def _point(self, x: int) -> tuple[int, int]:
        """(cos, sin); (1 - t**2, 2 t) / (1 + t**2) reaches all points of the circle but one."""
        p = self.prime
        x %= p
        if x not in self._points:
            t = self._draws.below(p)
            scale = pow(1 + t * t, -1, p)
            c, s = (1 - t * t) * scale % p, 2 * t * scale % p
            self._points[x], self._points[p - x] = (c, s), (c, p - s)
        return self._points[x]

    def turn(self, turns: Sequence[Fraction], modulus: int) -> None:
        """Register the points of multiples of pi that exist here; others are angles like any."""
        p = self.prime
        exact = [r for r in turns if modulus % (2 * r.denominator) == 0]
        if not exact:
            return
        root = _principal(_generator(modulus, p, self._draws), modulus, p)
        for r in exact:
            residue = r.numerator * pow(r.denominator, -1, p) * self._pi % p
            c, s = _coordinates(root ** int(r * modulus / 2))
            self._points[residue], self._points[p - residue] = (c, s), (c, -s % p)

    # ------------------------------------------------------------------ roots

    def _is_square(self, x: int) -> bool:
        return pow(x, (self.prime - 1) // 2, self.prime) == 1

    def _root(self, x: int, k: int) -> int:
        """The k-th root for k = 2, 3, 5 or 7; equal radicands have one root."""
        if x in (0, 1):
            return x
        ratio = self._ratios.get(x) if k == 2 else None
        return self._joined(x, k) if ratio is None else self._surd(ratio)

    def _joined(self, x: int, k: int) -> int:
        if (k, x) not in self._roots:
            self._roots[k, x] = self._new_root(x, k)
        return self._roots[k, x]

    def _new_root(self, x: int, k: int) -> int:
        p, half = self.prime, (self.prime - 1) // 2
        square = self._is_square(x)
        if k == 2:
            self.square_roots += 1
            if not square:
                self.not_square = self.square_roots - 1
        if not square and (k == 2 or self._squares):
            raise Inadmissible("a radicand is negative")
        root = pow(x, pow(k, -1, half), p)
        if pow(root, k, p) != x or (k == 2 and not self._squares and self._draws.bits(1)):
            return p - root
        return root

    def _surd(self, ratio: Fraction) -> int:
        """The square root of a rational; those of 2, 3, 5 and 7 exist by the choice of prime."""
        if ratio < 0:
            raise Inadmissible("a radicand is negative")
        p = self.prime
        rest, result = ratio.numerator * ratio.denominator, pow(ratio.denominator, -1, p)
        for q in ROOTS:
            while rest % (q * q) == 0:
                rest, result = rest // (q * q), result * q % p
            if rest % q == 0:
                rest, result = rest // q, result * pow(q, (p + 1) // 4, p) % p
        whole = isqrt(rest)
        if whole * whole == rest:
            return result * whole % p
        return result * self._joined(rest % p, 2) % p

    def _power(self, x: int, y: int) -> int:
        p = self.prime
        exponent = self._ratios.get(y % p)
        if exponent is None or not is_algebraic(exponent):
            return self._value("power", x, y)
        result = x % p
        for k in prime_factors(exponent.denominator):
            result = self._root(result, k)
        if exponent < 0 and not result:
            raise DivisionHere("division by zero")
        return pow(result, exponent.numerator, p)

    def positive(self, x: int) -> None:
        """Ask for another point unless x is a square.

        Raises
        ------
        Inadmissible
            If it is not.
        """
        if self._squares and not self._is_square(x % self.prime):
            raise Inadmissible("a quantity that must be positive is not")

    # ------------------------------------------------------------------ known by congruence only

    def _value(self, name: str, *operands: int, positive: bool = False) -> int:
        key = (name, *(operand % self.prime for operand in operands))
        if key not in self._variables:
            self._variables[key] = self._drawn(positive)
        return self._variables[key]

    def _exponential(self, x: int) -> int:
        return self._value("exp", x, positive=True) if x % self.prime else 1

    def _odd(self, name: str) -> Callable[[int], int]:
        """f(-x) = -f(x), f(0) = 0."""

        def function(x: int) -> int:
            x %= self.prime
            if not x:
                return 0
            if 2 * x > self.prime:
                return -self._value(name, self.prime - x) % self.prime
            return self._value(name, x)

        return function

    def _floor(self, x: int) -> int:
        ratio = self._ratios.get(x % self.prime)
        return self._value("floor", x) if ratio is None else self.constant(Fraction(ratio // 1))

    def _is_negative(self, x: int) -> bool:
        """Whether a residue is no square; counted up to sign."""
        self.kinks.add(min(x, self.prime - x))
        return not self._is_square(x)

    def _absolute(self, x: int) -> int:
        """A positive variable that |x| and |-x| share, or x or -x by its character."""
        if not x:
            return 0
        if self._signs:
            return self.prime - x if self._is_negative(x) else x
        return self._value("abs", min(x, self.prime - x), positive=True)

    def _sign(self, x: int) -> int:
        """|x| / x, so that x sign(x) = |x|."""
        x %= self.prime
        return self._quotient(self._absolute(x), x) if x else 0

    def _less(self, difference: int) -> int:
        """x < y, by x - y."""
        if not difference:
            return 0
        if self._signs:
            return int(self._is_negative(difference))
        return self._value("less", difference)

    def _equal(self, difference: int) -> int:
        if not difference:
            return 1
        return self._value("equal", min(difference, self.prime - difference))


# ---------------------------------------------------------------------- points of finite order


def _coordinates(point: fq_default) -> tuple[int, int]:
    """c and s of c + i s."""
    c, s = point.to_list()
    return int(c), int(s)


def _generator(order: int, p: int, draws: Draws) -> fq_default:
    """c + i s of a point of the circle of exactly that order, which divides p + 1."""
    plane = fq_default_ctx(modulus=fmpz_mod_poly_ctx(p)([1, 0, 1]))
    while True:
        t = draws.below(p)
        point = (plane([1, t]) / plane([1, -t])) ** ((p + 1) // order)
        if all(point ** (order // q) != 1 for q in prime_factors(order)):
            return point


def _principal(point: fq_default, order: int, p: int) -> fq_default:
    """The first power of it that agrees with the principal roots.

    sin(pi/2) = 1,  2 cos(pi/4) = sqrt 2,  2 cos(pi/6) = sqrt 3,  4 cos(pi/5) - 1 = sqrt 5,
    8 sin(pi/7) sin(2 pi/7) sin(3 pi/7) = sqrt 7.
    """
    half = (p - 1) // 2
    for k in range(1, order):
        if gcd(k, order) > 1:
            continue
        here = point**k
        cosines = [_coordinates(here ** (order // n))[0] for n in (8, 12, 10)]
        sines = [_coordinates(here ** (j * order // 14))[1] for j in (1, 2, 3)]
        roots = 2 * cosines[0], 2 * cosines[1], 4 * cosines[2] - 1, 8 * prod(sines)
        sine = _coordinates(here ** (order // 4))[1]
        if sine == 1 and all(pow(root, half, p) == 1 for root in roots):
            return here
    raise AssertionError(f"order {order}: no point agrees with the roots")  # Galois theory

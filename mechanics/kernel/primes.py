"""Random primes p = -1 (mod 840), so that the field behaves as much as possible like the reals.

With p = -1 (mod 8 * 3 * 5 * 7):

- p = 3 (mod 4): -1 is no square, so of the two roots of a square exactly one is itself a square,
  and that one plays the positive root; c**2 + s**2 = 1 is a cyclic group of p + 1 points;
- by quadratic reciprocity 2, 3, 5 and 7 are squares, as positive numbers should be;
- 3, 5 and 7 do not divide p - 1, so every residue has exactly one third, fifth and seventh root;
- p + 1 is a multiple of 840: every multiple of pi / 420 has its point of the circle. With
  p = -1 (mod 2 n) so has every multiple of pi / n.

How many such primes there are, which the error bound needs, is known explicitly. With
theta(x; q, a) the sum of the logarithms of the primes p <= x that are a modulo q, 3 <= q <= 10^5:

    |theta(x; q, a) - x / phi(q)| < x / (160 log x)        for x >= 8 10^9                   (1)

(Bennett, Martin, O'Bryant, Rechnitzer, "Explicit bounds for primes in arithmetic progressions",
Illinois J. Math. 62 (2018) 427-532, from the abstract).
"""

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import cache

from flint import fmpz

from mechanics.kernel.draws import Draws

MODULUS = 840
SIZES = (127, 255, 383, 521, 767, 1023, 1535, 2047, 3071)
LARGEST_MODULUS = 10_000
SHORTEST = 64

_SMALL = math.prod(q for q in range(11, 2000) if fmpz(q).is_prime())


def common_modulus(turns: Sequence[Fraction]) -> int:
    """The modulus of primes that have points for as many of the multiples of pi as can be."""
    modulus = MODULUS
    for turn in turns:
        wider = math.lcm(modulus, 2 * turn.denominator)
        if wider <= LARGEST_MODULUS:
            modulus = wider
    return modulus


def draw_prime(bits: int, modulus: int, draws: Draws) -> int:
    """A prime that is -1 modulo `modulus`, uniform among those of exactly `bits` bits.

    Drawing with equal chances and rejecting what is not prime leaves equal chances.

    Raises
    ------
    ValueError
        If `bits` is below 64, where (1) does not hold with a margin.
    """
    if bits < SHORTEST:
        raise ValueError(f"prime of {bits} bits asked for: the counting bound needs 64 or more")
    low, high = -(-(2 ** (bits - 1)) // modulus) + 1, 2**bits // modulus
    while True:
        candidate = (low + draws.below(high - low)) * modulus - 1
        if math.gcd(candidate, _SMALL) == 1 and fmpz(candidate).is_probable_prime():
            return candidate


@cache
def log2_count(bits: int, modulus: int = MODULUS) -> float:
    """A lower bound of log2 of the number of primes that `draw_prime` chooses from.

    From (1): theta(2**b) - theta(2**(b-1)), over the largest logarithm, b log 2.
    """
    upper, lower = bits * math.log(2), (bits - 1) * math.log(2)
    share = 0.5 / int(fmpz(modulus).euler_phi()) - 1 / (160 * upper) - 0.5 / (160 * lower)
    return bits + math.log2(share / upper)

"""Random primes p = -1 (mod 840), so that the field behaves as much as possible like the reals.

With p = -1 (mod 8 * 3 * 5 * 7):

- p = 3 (mod 4): -1 is no square, so of the two roots of a square exactly one is itself a square,
  and that one plays the positive root; c**2 + s**2 = 1 is a group of p + 1 points;
- by quadratic reciprocity 2, 3, 5 and 7 are squares, as positive numbers should be;
- 3, 5 and 7 do not divide p - 1, so every residue has exactly one third, fifth and seventh root.

How many such primes there are, which the error bound needs, is known explicitly: for every modulus
q <= 1200 and x >= 50 q**2

    1 < pi(x; q, a) phi(q) log(x) / x < 1 + 5 / (2 log x)                                   (1)

(Bennett, Martin, O'Bryant, Rechnitzer, "Explicit bounds for primes in arithmetic progressions",
Illinois J. Math. 62 (2018), the corollary on pi(x; q, a)).
"""

import math
import random
from functools import cache

from flint import fmpz

MODULUS = 840
TOTIENT = 192
SIZES = (127, 255, 383, 521, 767, 1023, 1535, 2047, 3071)

_SMALL = math.prod(q for q in range(11, 2000) if fmpz(q).is_prime())


def draw_prime(bits: int, source: random.Random) -> int:
    """Return a prime that is -1 modulo 840, uniform among those of exactly `bits` bits.

    Drawing with equal chances and rejecting what is not prime leaves equal chances.

    Raises
    ------
    ValueError
        If `bits` is below 64, where (1) does not hold with a margin.
    """
    if bits < 64:
        raise ValueError(f"prime of {bits} bits asked for: the counting bound needs 64 or more")
    low, high = -(-(2 ** (bits - 1)) // MODULUS) + 1, 2**bits // MODULUS
    while True:
        candidate = source.randrange(low, high) * MODULUS - 1
        if math.gcd(candidate, _SMALL) == 1 and fmpz(candidate).is_probable_prime():
            return candidate


def log2_count(bits: int) -> float:
    """Return a lower bound of log2 of the number of primes that `draw_prime` chooses from.

    From (1): pi(2**b) - pi(2**(b-1)) with the lower bound for the first, the upper for the second.
    """
    upper, lower = bits * math.log(2), (bits - 1) * math.log(2)
    share = 1 / upper - 0.5 / lower * (1 + 2.5 / lower)
    return bits + math.log2(share / TOTIENT)


@cache
def pooled_prime(bits: int, index: int) -> int:
    """Return prime number `index` of those that many statements share, the same in every run.

    Statements do not depend on the primes, so one prime can serve many of them: the bound of each
    statement holds on its own.
    """
    return draw_prime(bits, random.Random(f"prime {bits} {index}"))

"""Numbers that are drawn: from SHAKE-256 of a text, so the same ones in each run.

Whoever writes a statement cannot choose the points at which it is evaluated without finding a text
whose digest suits, and a second run, on another machine or under load, evaluates the same points.

FIPS PUB 202, SHA-3 Standard: Permutation-Based Hash and Extendable-Output Functions, NIST 2015.
"""

from hashlib import sha256, shake_256

VERSION = "kernel 1"
"""Part of every seed: a change of how points are drawn draws other points."""

BLOCK = 4096


class Draws:
    """A stream of uniform integers that is a function of a seed.

    Parameters
    ----------
    *seed : str
        Texts; their digests, not their concatenation, make the seed.
    """

    def __init__(self, *seed: str) -> None:
        parts = (VERSION, *seed)
        self.seed = b"".join(sha256(part.encode()).digest() for part in parts)
        self._block = b""
        self._used = 0
        self._count = 0

    def bits(self, count: int) -> int:
        """An integer of so many random bits."""
        size = (count + 7) // 8
        while len(self._block) - self._used < size:
            counter = self._count.to_bytes(8, "little")
            fresh = shake_256(self.seed + counter).digest(BLOCK)
            self._block, self._used = self._block[self._used :] + fresh, 0
            self._count += 1
        taken = self._block[self._used : self._used + size]
        self._used += size
        return int.from_bytes(taken, "little") >> (8 * size - count)

    def below(self, bound: int) -> int:
        """An integer from 0 to bound - 1, each with the same chance."""
        count = (bound - 1).bit_length()
        while True:
            drawn = self.bits(count) if count else 0
            if drawn < bound:
                return drawn

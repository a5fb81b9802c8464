"""The last lines: which of s, c, -s, -c is stored, by the last two bits of the shifted quotient.

    n mod 4      0     1     2     3
    sine         s     c    -s    -c
    cosine       c    -s    -c     s

If s is odd and c even in x, and n is odd, then so are the results, bit for bit: -n takes 1 to 3.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

from mechanics.compiled.translation_validation.sine.affine import BITS
from mechanics.compiled.translation_validation.sine.machine import Machine
from mechanics.compiled.translation_validation.sine.walk import Domain, Function
from mechanics.errors import ExpressionError
from mechanics.program.c.parse import Source

TABLE = (
    (("s", 1), ("c", 1)),
    (("c", 1), ("s", -1)),
    (("s", -1), ("c", -1)),
    (("c", -1), ("s", 1)),
)  # fmt: skip
"""What sine and cosine are, by n modulo 4: a name and a sign."""


class LowBits:
    """An integer of which only the last two bits are known."""

    def __init__(self, value: int) -> None:
        self._value = value % 4

    def __add__(self, other: int) -> LowBits:
        return LowBits(self._value + other)

    def __and__(self, mask: int) -> int:
        if not 0 <= mask < 4:
            raise ExpressionError(f"a quadrant is told by two bits: & {mask} takes others")
        return self._value & mask

    def __mod__(self, length: int) -> LowBits:
        return self

    def __bool__(self) -> bool:
        raise ExpressionError("a condition takes all bits of a quotient")


class Turned(NamedTuple):
    """s or c with a sign."""

    name: str
    sign: int


class Quadrant(Domain):
    """s and c, which may be stored and change their sign, and the shifted quotient, which is read.

    Parameters
    ----------
    turns : int
        n.
    """

    def __init__(self, turns: int) -> None:
        self._turns = turns

    def bits(self, kind: str, x: Any) -> Any:
        """The bits of the shifted quotient."""
        return LowBits(self._turns) if x == "shifted" else self._refused()

    def flipped(self, kind: str, x: Any, mask: int) -> Any:
        """The sign may be changed."""
        length = 64 if kind == "double" else 32
        if not isinstance(x, Turned) or mask not in (0, 1 << (length - 1)):
            return self._refused()
        return Turned(x.name, -x.sign if mask else x.sign)

    def _refused(self) -> Any:
        raise ExpressionError("the quadrant is not found by reading bits alone")


def check_quadrants(source: Source, name: str, kind: str, turns: int) -> None:
    """Look at the results for every quadrant.

    Parameters
    ----------
    turns : int
        Largest |n|.

    Raises
    ------
    ExpressionError
        If they are not those of the table.
    """
    shift = Fraction(Function(source, name, Machine(), {"x": 0.0})["shifted"])
    binade = Fraction(2) ** (BITS[kind] - 1)
    # Numbers from there to its double are integers, and their bits count them.
    if not binade <= shift - turns or not shift + turns < 2 * binade or shift % 4:
        raise ExpressionError("the last bits of the shifted quotient are not those of n")
    for n, expected in enumerate(TABLE):
        known = {"s": Turned("s", 1), "c": Turned("c", 1), "shifted": "shifted"}
        function = Function(source, name, Quadrant(n), known)
        found = tuple(function.stored(out).value for out in ("sine", "cosine"))
        if found != expected:
            raise ExpressionError(f"quadrant {n}: {found} found, {expected} expected")


class Parity(Domain):
    """``"odd"`` and ``"even"`` functions of x: rounding to nearest keeps them, bit for bit.

    A number is even. The sum of an odd value and a number is ``"shifted"``.
    """

    def number(self, kind: str, value: Fraction) -> str:
        """A literal."""
        return "even"

    def negative(self, kind: str, x: str) -> str:
        """-x."""
        return x

    def sum(self, kind: str, x: str, y: str) -> str:
        """x + y."""
        return x if x == y and x != "shifted" else "shifted"

    def product(self, kind: str, x: str, y: str) -> str:
        """x y."""
        if "shifted" in (x, y):
            return "shifted"
        return "even" if x == y else "odd"

    def fused(self, kind: str, x: str, y: str, z: str) -> str:
        """x y + z."""
        return self.sum(kind, self.product(kind, x, y), z)

    def cast(self, kind: str, old: str, x: str) -> str:
        """x in another type."""
        return x


def check_parity(source: Source, name: str) -> None:
    """Look whether s is odd and c even; n is odd, being next to an odd multiple of x.

    Ties of the quotient go to even integers, of n as of -n, because the shift is even.

    Raises
    ------
    ExpressionError
        If it is not so, or a zero does not keep its sign.
    """
    function = Function(source, name, Parity(), {"x": "odd", "n": "odd"})
    found = function["s"], function["c"]
    if found != ("odd", "even"):
        raise ExpressionError(f"s is {found[0]} and c {found[1]} in x")
    for zero in (0.0, -0.0):
        given = Function(source, name, Machine(), {"x": zero})
        sine, cosine = given.stored("sine").value, given.stored("cosine").value
        if (str(sine), cosine) != (str(zero), 1.0):
            raise ExpressionError(f"sine and cosine of {zero} are {sine} and {cosine}")

"""The inline sine as a machine computes it: IEEE 754, rounded to nearest, ties to even."""

import struct
from fractions import Fraction
from typing import Any

import numpy as np

from mechanics.compiled.translation_validation.sine.walk import Domain, Function
from mechanics.program.c.literal import rounded
from mechanics.program.c.parse import Source

_CODES = {"double": ("<d", "<Q"), "float": ("<f", "<I")}
_TYPES: dict[str, Any] = {"double": np.float64, "float": np.float32}


class Machine(Domain):
    """Floating numbers; singles are held as doubles."""

    def number(self, kind: str, value: Fraction) -> float:
        """A literal."""
        return float(value)

    def negative(self, kind: str, x: float) -> float:
        """-x."""
        return -x

    def sum(self, kind: str, x: float, y: float) -> float:
        """x + y, rounded."""
        return float(_TYPES[kind](x) + _TYPES[kind](y))

    def product(self, kind: str, x: float, y: float) -> float:
        """x y, rounded."""
        return float(_TYPES[kind](x) * _TYPES[kind](y))

    def fused(self, kind: str, x: float, y: float, z: float) -> float:
        """x y + z, rounded once."""
        exact = Fraction(x) * Fraction(y) + Fraction(z)
        # The sign of zero is that of the terms, which are each other's negatives or zeros.
        return float(rounded(exact, kind)) if exact else x * y + z

    def cast(self, kind: str, old: str, x: float) -> float:
        """x in another type."""
        return float(_TYPES[kind](x))

    def bits(self, kind: str, x: float) -> int:
        """The number read as an integer."""
        number, integer = _CODES[kind]
        return int(struct.unpack(integer, struct.pack(number, x))[0])

    def flipped(self, kind: str, x: float, mask: int) -> float:
        """The number with these bits changed."""
        number, integer = _CODES[kind]
        packed = struct.pack(integer, self.bits(kind, x) ^ mask)
        return float(struct.unpack(number, packed)[0])


def sincos(source: Source, name: str, x: float) -> tuple[float, float]:
    """Sine and cosine of x as the text computes them."""
    function = Function(source, name, Machine(), {"x": x})
    return function.stored("sine").value, function.stored("cosine").value

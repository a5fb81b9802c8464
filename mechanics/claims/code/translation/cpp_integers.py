"""Kinds of integers of C++: what each holds, and which one arithmetic is done in.

    uint8_t n = 259        0 to 255: refused by name        n - 256, a byte      done in ints

Where a size depends on the processor, the smaller one is taken; a char has the numbers that are
those of both signs. What is held is no more than a double holds exactly.
"""

import re
from typing import NamedTuple

from mechanics.claims.code.translation.python_page import EXACT

LITERAL = re.compile(r"[-+]?\d+([uUlL]*)")


class Kind(NamedTuple):
    """A kind of integers.

    Attributes
    ----------
    words : str
        As it is written.
    bits : int
        That numbers without a sign may use, or those with one.
    unsigned : bool
    """

    words: str
    bits: int
    unsigned: bool = False

    @property
    def limits(self) -> tuple[int, int]:
        """The least and the largest number."""
        if self.unsigned:
            return 0, min(2**self.bits - 1, EXACT)
        return max(-(2 ** (self.bits - 1)), -EXACT), min(2 ** (self.bits - 1) - 1, EXACT)


def kind_of(words: str, small: int) -> Kind:
    """The kind of integers that a type is, or holds.

    Parameters
    ----------
    words : str
        The type, one of integers.
    small : int
        Bits of an int.
    """
    inner = (words.partition("<")[2] or words).partition(",")[0].strip(" >&*")
    parts = {*re.findall(r"\w+", inner)} - {"const", "constexpr", "static", "std"}
    unsigned = bool(parts & {"unsigned", "byte", "word"}) or inner.split("::")[-1][:4] == "uint"
    sized = re.search(r"int(?:_fast|_least)?(8|16|32|64)_t", inner)
    if parts & {"bool", "boolean"}:
        return Kind(inner, 1, unsigned=True)
    if sized:
        return Kind(inner, int(sized[1]), unsigned)
    if parts & {"byte", "char"}:
        signed = {"signed", "unsigned", "byte"} & parts
        return Kind(inner, 8, unsigned) if signed else Kind(inner, 7, unsigned=True)
    if parts & {"short", "word"}:
        return Kind(inner, 16, unsigned)
    if "long" in parts:
        return Kind(inner, 64 if inner.count("long") > 1 else 32, unsigned)
    if parts & {"size_t"}:
        return Kind(inner, small, unsigned=True)
    if parts & {"int", "signed", "unsigned", "ptrdiff_t", "ssize_t"} or inner.endswith("i"):
        return Kind(inner, small, unsigned)
    return Kind(inner, 7, unsigned=True)


def kind_of_literal(text: str, small: int) -> Kind | None:
    """The kind of a literal; None for what is no integer."""
    match = LITERAL.fullmatch(text)
    if match is None:
        return None
    number = abs(int(text.rstrip("uUlL")))
    least = {0: small, 1: max(small, 32), 2: 64}[min(match[1].lower().count("l"), 2)]
    unsigned = "u" in match[1].lower()
    bits = next((b for b in (least, 32, 64) if b >= least and not number >> (b - 1 + unsigned)), 64)
    return Kind(text, bits, unsigned)


def promoted(kind: Kind, small: int) -> Kind:
    """What one number becomes in arithmetic."""
    return kind if kind.bits >= small - 1 else Kind("int", small)


def joined_kind(one: Kind, other: Kind, small: int) -> Kind:
    """What the arithmetic of two numbers is done in.

    Numbers with a sign beside others without one have the limits of both.
    """
    one, other = promoted(one, small), promoted(other, small)
    bits = max(one.bits, other.bits)
    if one.unsigned == other.unsigned:
        return Kind("int", bits, one.unsigned)
    return Kind("unsigned", bits - 1, unsigned=True)

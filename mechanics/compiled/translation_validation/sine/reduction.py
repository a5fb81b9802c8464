"""r - low = x - n pi/2 up to an error that is small beside it, even next to multiples of pi/2.

How near a floating number x, 2^e <= |x| < 2^(e+1), can come to one follows from the continued
fraction of a = (pi/2) 2^(bits - 1 - e): x is an integer times 2^(e + 1 - bits), and no n < q_(k+1)
brings n a nearer to an integer than the denominator q_k of the k-th convergent does.
"""

from dataclasses import dataclass
from fractions import Fraction

from mechanics.compiled.translation_validation.sine.affine import BITS, Affine, AffineForms, half_pi
from mechanics.compiled.translation_validation.sine.walk import Function
from mechanics.errors import ExpressionError
from mechanics.program.c.parse import Source


@dataclass(frozen=True)
class Reduced:
    """What is known of r and low for the numbers x between two powers of 2, n not zero.

    Attributes
    ----------
    turns : int
        Largest |n|.
    nearest, farthest : Fraction
        Bounds of |t| = |x - n pi/2|.
    low : Fraction
        Bound of |low|.
    error : Fraction
        Bound of |r - low - t| but for the last rounding of r.
    """

    turns: int
    nearest: Fraction
    farthest: Fraction
    low: Fraction
    error: Fraction


def quotient(source: Source, name: str, kind: str, largest: Fraction) -> tuple[Fraction, Fraction]:
    """a and d with |n - a x| <= d for the integer n of the text, |x| <= largest.

    Raises
    ------
    ExpressionError
        If n is not shown to be an integer that is near to a multiple of x.
    """
    forms = AffineForms(Fraction(0), largest)
    n = Function(source, name, forms, {"x": Affine(kind, a=Fraction(1))})["n"]
    if n.inexact or n.c or n.a <= 0 or n.grid is None or n.grid < 0:
        raise ExpressionError("n is not shown to be the integer next to a multiple of x")
    return n.a, n.error


def reduced(source: Source, name: str, kind: str, largest: Fraction) -> list[Reduced]:
    """What is known for every power of 2 up to the largest |x|.

    Raises
    ------
    ExpressionError
        If r - low is not shown to be x - n pi/2.
    """
    slope, distance = quotient(source, name, kind, largest)
    e, found = _floor_exponent((1 - distance) / slope), []
    while Fraction(2) ** e < largest:
        top = min(Fraction(2) ** (e + 1), largest)
        turns = int(slope * top + distance)
        high = half_pi()[1]
        farthest = top * max(abs(1 - slope * bound) for bound in half_pi()) + distance * high
        nearest = nearest_multiple(e, kind, turns)
        if nearest <= 0:
            raise ExpressionError("a number is not told from a multiple of pi/2")
        found.append(_one(source, name, kind, e, turns, nearest, farthest))
        e += 1
    return found


def _one(
    source: Source, name: str, kind: str, e: int, turns: int, nearest: Fraction, farthest: Fraction
) -> Reduced:
    forms = AffineForms(Fraction(turns), farthest)
    x = Affine(kind, a=Fraction(1), grid=e + 1 - BITS[kind])
    n = Affine(kind, b=Fraction(1), grid=0)
    function = Function(source, name, forms, {"x": x, "n": n})
    r, low = function["r"], forms.settled(function["low"])
    b = r.b - low.b
    if r.a - low.a != 1 or r.c or low.c:
        raise ExpressionError("r - low is not x less a multiple of n")
    rest = max(abs(b + bound) for bound in half_pi()) * turns
    size = forms.bound(low) + low.error
    return Reduced(turns, nearest, farthest, size, r.error + low.error + rest)


def _floor_exponent(number: Fraction) -> int:
    """The largest e with 2^e <= number."""
    e = number.numerator.bit_length() - number.denominator.bit_length()
    return e if Fraction(2) ** e <= number else e - 1


def nearest_multiple(e: int, kind: str, turns: int) -> Fraction:
    """A lower bound of |x - n pi/2| for x between 2^e and 2^(e+1), 0 < n <= turns."""
    unit = Fraction(2) ** (e + 1 - BITS[kind])
    low, high = (bound / unit for bound in half_pi())
    # Convergents of the two bounds agree as long as they are those of the number between them.
    p, q = (1, int(low)), (0, 1)
    x, y = low, high
    while q[1] <= turns:
        if int(x) != int(y):
            raise ExpressionError("pi is not known to enough digits")
        best = p[1], q[1]
        x, y = 1 / (x - int(x)), 1 / (y - int(y))
        p, q = (p[1], int(x) * p[1] + p[0]), (q[1], int(x) * q[1] + q[0])
    gap = min(abs(best[1] * low - best[0]), abs(best[1] * high - best[0]))
    return (gap - best[1] * (high - low)) * unit


def small(source: Source, name: str, kind: str, largest: Fraction) -> Fraction:
    """The largest |x| for which n may be zero; r is x then, and low is zero.

    Raises
    ------
    ExpressionError
        If they are not.
    """
    slope, distance = quotient(source, name, kind, largest)
    forms = AffineForms(Fraction(0), distance / slope)
    x, n = Affine(kind, a=Fraction(1)), Affine(kind)
    function = Function(source, name, forms, {"x": x, "n": n})
    r, low = function["r"], function["low"]
    if (r.a, r.b, r.c, r.error, r.inexact) != (1, 0, 0, 0, False) or forms.bound(low) or low.error:
        raise ExpressionError("r is not x where n is zero")
    return distance / slope

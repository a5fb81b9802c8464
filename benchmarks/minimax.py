"""Polynomials for sine and cosine on |r| <= pi/4 (a little more), in z = r^2:

    sin r = r - r^3 P(z)                 P minimises the relative error of the sine
    cos r = 1 - z / 2 + z^2 Q(z)         Q minimises the relative error of the cosine

by Remez' exchange with `DIGITS` bits. The coefficients that stand in `sine` are these, rounded to
the precision; run ``python -m benchmarks.minimax`` to see them again.
"""

from collections.abc import Callable, Sequence
from fractions import Fraction

import numpy as np
from flint import arb, arb_mat

from mechanics.kernel.balls import precision
from mechanics.program.c.literal import rounded as nearest

REACHES = {"double": "0.7855", "float": "0.83"}
"""Largest |r|: pi/4 = 0.785398... and what rounding of 2/pi adds, times the largest |x|."""
COUNTS = {"double": (6, 6), "float": (4, 3)}
"""Number of coefficients of P and of Q."""
PIECES = {"double": (33, 20, 32, 53), "float": (24, 24, 24)}
"""Bits of the pieces of pi/2. In double precision n has 20 bits, so that n times each of the first
three is exact without fused operations, and the first two end where x and 1 do."""

DIGITS = 400
GRID = 400


def sine_residue(r: arb) -> arb:
    """(r - sin r) / r^3."""
    return (r - r.sin()) / r**3


def cosine_residue(r: arb) -> arb:
    """(cos r - 1 + r^2 / 2) / r^4."""
    return (r.cos() - 1 + r**2 / 2) / r**4


def sine_weight(r: arb) -> arb:
    """What an error of P means for the sine, relative."""
    return r**3 / r.sin()


def cosine_weight(r: arb) -> arb:
    """What an error of Q means for the cosine, relative."""
    return r**4 / r.cos()


def remez(
    function: Callable[[arb], arb], weight: Callable[[arb], arb], count: int, reach: str
) -> list[arb]:
    """Coefficients of the polynomial in r^2 that minimises the largest weighted error.

    Parameters
    ----------
    function, weight : callable
        Of r in [0, reach].
    count : int
        Number of coefficients.
    reach : str
        Largest |r|.
    """
    # The weight vanishes at zero, where no error is seen: the grid starts above.
    top = arb(reach) ** 2
    grid = [top * (1 - arb.cos_pi(arb(k + 1) / GRID)) / 2 for k in range(GRID)]
    values, weights = ([f(z.sqrt()) for z in grid] for f in (function, weight))
    places = [round((k + 0.5) * GRID / (count + 1)) - 1 for k in range(count + 1)]
    while True:
        found = _levelled(grid, values, weights, places)
        errors = [
            float(w * (_horner(found, z) - f))
            for z, f, w in zip(grid, values, weights, strict=True)
        ]
        exchanged = _extrema(errors, count + 1)
        if exchanged == places:
            return found
        places = exchanged


def _horner(coefficients: Sequence[arb], z: arb) -> arb:
    total = arb(0)
    for coefficient in reversed(coefficients):
        total = total * z + coefficient
    return total


def _levelled(
    grid: Sequence[arb], values: Sequence[arb], weights: Sequence[arb], places: Sequence[int]
) -> list[arb]:
    """The polynomial whose weighted errors at the places are equal and alternate."""
    count = len(places) - 1
    rows = [
        [*(grid[k] ** j for j in range(count)), (-1) ** i / weights[k]]
        for i, k in enumerate(places)
    ]
    solution = arb_mat(rows).solve(arb_mat([[values[k]] for k in places]))
    return [entry.mid() for entry in solution.entries()][:count]


def _extrema(errors: Sequence[float], count: int) -> list[int]:
    """Places of the largest errors of alternating sign, one for each run of a sign."""
    best: list[int] = []
    for k, error in enumerate(errors):
        if best and (error > 0) == (errors[best[-1]] > 0):
            if abs(error) > abs(errors[best[-1]]):
                best[-1] = k
        else:
            best.append(k)
    while len(best) > count:
        best.pop(0 if abs(errors[best[0]]) < abs(errors[best[-1]]) else -1)
    return best


def pieces(kind: str) -> tuple[str, ...]:
    """pi/2 cut into numbers of so many bits each, from the top; the last one is rounded."""
    with precision(DIGITS):
        rest = _fraction(arb.pi() / 2)
    found: list[str] = []
    for size in PIECES[kind]:
        unit = Fraction(2) ** (int(np.frexp(float(rest))[1]) - size)
        last = len(found) == len(PIECES[kind]) - 1
        piece = round(rest / unit) * unit if last else rest // unit * unit
        found.append(_written(piece, kind))
        rest -= piece
    return tuple(found)


def _fraction(number: arb) -> Fraction:
    mantissa, exponent = (int(part) for part in number.mid().man_exp())
    return mantissa * Fraction(2) ** exponent


def _written(number: Fraction, kind: str) -> str:
    """The hexadecimal C literal, without suffix, of the nearest number of a precision."""
    mantissa, exponent = float(nearest(number, kind)).hex().split("p")
    return f"{mantissa.rstrip('0').rstrip('.')}p{exponent}"


def coefficients(kind: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """P and Q of a precision, ``"double"`` or ``"float"``."""
    p, q = COUNTS[kind]
    with precision(DIGITS):
        sine = remez(sine_residue, sine_weight, p, REACHES[kind])
        cosine = remez(cosine_residue, cosine_weight, q, REACHES[kind])
    first, second = (tuple(_written(_fraction(c), kind) for c in found) for found in (sine, cosine))
    return first, second


def main() -> None:
    """Print the numbers of `mechanics.compiled.c.sine`."""
    for kind in COUNTS:
        for numbers in (*coefficients(kind), pieces(kind)):
            print(kind, *numbers)


if __name__ == "__main__":
    main()

"""Polynomials for sine and cosine on |r| <= pi/4 (a little more), in z = r^2:

    sin r = r - r^3 P(z)                 P minimises the relative error of the sine
    cos r = 1 - z / 2 + z^2 Q(z)         Q minimises the relative error of the cosine

by Remez' exchange in 60 digits. The coefficients that stand in `sine` are these, rounded to the
precision; run ``python -m mechanics.compiled.c.minimax`` to see them again.
"""

from collections.abc import Callable, Sequence

import mpmath
import numpy as np
from mpmath import mp, mpf

REACHES = {"double": mpf("0.7855"), "float": mpf("0.83")}
"""Largest |r|: pi/4 = 0.785398... and what rounding of 2/pi adds, times the largest |x|."""
COUNTS = {"double": (6, 6), "float": (4, 3)}
"""Number of coefficients of P and of Q."""

DIGITS = 60
GRID = 400

PIECES = {"double": (33, 20, 32, 53), "float": (24, 24, 24)}
"""Bits of the pieces of pi/2. In double precision n has 20 bits, so that n times each of the first
three is exact without fused operations, and the first two end where x and 1 do."""


def sine_residue(z: mpf) -> mpf:
    """(r - sin r) / r^3."""
    if z < mpf("1e-6"):
        return mpf(1) / 6 - z / 120 + z**2 / 5040 - z**3 / 362880 + z**4 / 39916800
    r = mpmath.sqrt(z)
    return (r - mpmath.sin(r)) / r**3


def cosine_residue(z: mpf) -> mpf:
    """(cos r - 1 + z / 2) / z^2."""
    if z < mpf("1e-6"):
        return mpf(1) / 24 - z / 720 + z**2 / 40320 - z**3 / 3628800 + z**4 / 479001600
    return (mpmath.cos(mpmath.sqrt(z)) - 1 + z / 2) / z**2


def sine_weight(z: mpf) -> mpf:
    """What an error of P means for the sine, relative."""
    r = mpmath.sqrt(z)
    return z / (mpmath.sin(r) / r if r else mpf(1))


def cosine_weight(z: mpf) -> mpf:
    """What an error of Q means for the cosine, relative."""
    return z**2 / mpmath.cos(mpmath.sqrt(z))


def remez(
    function: Callable[[mpf], mpf], weight: Callable[[mpf], mpf], count: int, reach: mpf
) -> tuple[list[mpf], mpf]:
    """Coefficients of the polynomial that minimises the largest weighted error, and that error.

    Parameters
    ----------
    function, weight : callable
        Of z in [0, reach^2].
    count : int
        Number of coefficients.
    reach : mpf
        Largest |r|.
    """
    with mp.workdps(DIGITS):
        # The weight vanishes at zero, where no error is seen: the grid starts above.
        top = reach**2
        grid = [top * (1 - mpmath.cos(mp.pi * (k + 1) / GRID)) / 2 for k in range(GRID)]
        values = [function(z) for z in grid]
        weights = [weight(z) for z in grid]
        places = [round((k + 0.5) * GRID / (count + 1)) - 1 for k in range(count + 1)]
        for _ in range(30):
            coefficients, level = _levelled(grid, values, weights, places)
            errors = [
                w * (mpmath.polyval(coefficients[::-1], z) - f)
                for z, f, w in zip(grid, values, weights, strict=True)
            ]
            found = _extrema(errors, count + 1)
            if found == places:
                break
            places = found
        return coefficients, abs(level)


def _levelled(
    grid: Sequence[mpf], values: Sequence[mpf], weights: Sequence[mpf], places: Sequence[int]
) -> tuple[list[mpf], mpf]:
    """The polynomial whose weighted errors at the places are equal and alternate."""
    count = len(places) - 1
    rows = [
        [*(grid[k] ** j for j in range(count)), (-1) ** i / weights[k]]
        for i, k in enumerate(places)
    ]
    solution = mpmath.lu_solve(mpmath.matrix(rows), mpmath.matrix([values[k] for k in places]))
    return list(solution)[:count], solution[count]


def _extrema(errors: Sequence[mpf], count: int) -> list[int]:
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


def pieces(bits: Sequence[int]) -> list[mpf]:
    """pi/2 cut into numbers of so many bits each, from the top; the last one is rounded."""
    with mp.workdps(DIGITS):
        rest, found = mp.pi / 2, []
        for place, size in enumerate(bits):
            unit = mpf(2) ** (int(mpmath.floor(mpmath.log(rest, 2))) + 1 - size)
            last = place == len(bits) - 1
            found.append((mpmath.nint if last else mpmath.floor)(rest / unit) * unit)
            rest -= found[-1]
        return found


def rounded(number: mpf, kind: str) -> str:
    """The hexadecimal C literal, without suffix, of the nearest number of a precision."""
    value = float(number) if kind == "double" else float(np.float32(float(number)))
    mantissa, exponent = value.hex().split("p")
    return f"{mantissa.rstrip('0').rstrip('.')}p{exponent}"


def coefficients(kind: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """P and Q of a precision, ``"double"`` or ``"float"``."""
    p, _ = remez(sine_residue, sine_weight, COUNTS[kind][0], REACHES[kind])
    q, _ = remez(cosine_residue, cosine_weight, COUNTS[kind][1], REACHES[kind])
    return tuple(rounded(c, kind) for c in p), tuple(rounded(c, kind) for c in q)


def main() -> None:
    """Print the coefficients of `mechanics.compiled.c.sine`."""
    for kind in COUNTS:
        cut = [rounded(piece, kind) for piece in pieces(PIECES[kind])]
        for numbers in (*coefficients(kind), cut):
            print(kind, *numbers)


if __name__ == "__main__":
    main()

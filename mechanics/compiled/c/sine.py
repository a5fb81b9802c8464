"""Sine and cosine as C text that a compiler vectorises: no branch, no table, no library.

    n = nearest integer to x / (pi/2)          by adding and subtracting 1.5 * 2^52 (2^23)
    r = x - n pi/2                             pi/2 in pieces, so that all but one step is exact
    sin r = r - (r^3 P(r^2) + low)             low = n times the last piece of pi/2
    cos r = 1 - r^2 / 2 + r^4 Q(r^2)
    (sin x, cos x) = (sin r, cos r), (cos r, -sin r), (-sin r, -cos r), (-cos r, sin r)

for n = 0, 1, 2, 3 modulo 4, which are the last two bits of x / (pi/2) + 1.5 * 2^52.

Holds for |x| <= `LIMIT`; ``mechanics_far`` tells where it does not, infinities and not-a-numbers
included. A block of states that holds such an angle is given to the C library, lane by lane.

``mechanics_fma(x, y, z)`` is x y + z, fused where the machine can do that. In the reduction both
give the same value, because there the products are exact.
"""

from dataclasses import dataclass

LIMIT = 2.0**20
"""Largest |x|, in rad: 1,048,576."""


@dataclass(frozen=True)
class Numbers:
    """What differs between the precisions.

    Attributes
    ----------
    kind, suffix : str
        Type in C, and what its literals and functions end with.
    bits : int
        Of the unsigned integer that the type is read as.
    shift : str
        1.5 times the number from which on floating numbers are integers.
    turns : str
        2/pi.
    pieces : tuple of str
        Of pi/2.
    sine, cosine : tuple of str
        Coefficients of P and Q, from ``benchmarks/minimax.py``.
    """

    kind: str
    suffix: str
    bits: int
    shift: str
    turns: str
    pieces: tuple[str, ...]
    sine: tuple[str, ...]
    cosine: tuple[str, ...]


DOUBLE = Numbers(
    "double", "", 64, "0x1.8p52", "0x1.45f306dc9c883p-1",
    ("0x1.921fb544p+0", "0x1.0b46p-34", "0x1.1a62633p-54", "0x1.45c06e0e68948p-86"),
    (
        "0x1.5555555555548p-3", "-0x1.111111110f7c8p-7", "0x1.a01a019bfcd84p-13",
        "-0x1.71de3566d820dp-19", "0x1.ae5e59c61b5d6p-26", "-0x1.5d8f94e117d01p-33",
    ),
    (
        "0x1.555555555554bp-5", "-0x1.6c16c16c14f88p-10", "0x1.a01a019c83577p-16",
        "-0x1.27e4f7ea0cb6dp-22", "0x1.1ee9d7349a3p-29", "-0x1.8fa456057e64ap-37",
    ),
)  # fmt: skip
SINGLE = Numbers(
    "float", "f", 32, "0x1.8p23", "0x1.45f306p-1",
    ("0x1.921fb4p+0", "0x1.4442dp-24", "0x1.84698ap-48"),
    ("0x1.555556p-3", "-0x1.111106p-7", "0x1.a00ce4p-13", "-0x1.6c3b3cp-19"),
    ("0x1.555546p-5", "-0x1.6c098cp-10", "0x1.9930d4p-16"),
)  # fmt: skip
PRECISIONS = {numbers.kind: numbers for numbers in (DOUBLE, SINGLE)}


def sine_source(kind: str = "double") -> str:
    """C99 with ``mechanics_sincos``, ``mechanics_far`` and ``mechanics_fma``, or with an f behind.

    Parameters
    ----------
    kind : ``"double"`` or ``"float"``
    """
    at = PRECISIONS[kind]
    f = at.suffix
    return _TEXT.format(
        kind=kind,
        f=f,
        fused=_FUSED[kind],
        macro=f.upper(),
        bits=at.bits,
        top=at.bits - 2,
        limit=f"{LIMIT:.1f}{f}",
        shift=at.shift + f,
        turns=at.turns + f,
        reduction="\n".join(_reduction(at)),
        low=at.pieces[-1] + f,
        sine="\n".join(_horner("p", at.sine, at)),
        cosine="\n".join(_horner("q", at.cosine, at)),
    )


def _reduction(at: Numbers) -> list[str]:
    """r = x - n times every piece but the last."""
    names = ["x", *(f"r{i}" for i in range(1, len(at.pieces) - 1)), "r"]
    return [
        f"    const {at.kind} {new} = mechanics_fma{at.suffix}(-n, {piece}{at.suffix}, {old});"
        for old, new, piece in zip(names, names[1:], at.pieces, strict=False)
    ]


def _horner(name: str, coefficients: tuple[str, ...], at: Numbers) -> list[str]:
    """name0 = c0 + z (c1 + z (c2 + ...)), from the inside."""
    last = len(coefficients) - 1
    old, lines = coefficients[last] + at.suffix, []
    for k in range(last - 1, -1, -1):
        call = f"mechanics_fma{at.suffix}({old}, z, {coefficients[k]}{at.suffix})"
        old = f"{name}{k}"
        lines.append(f"    const {at.kind} {old} = {call};")
    return lines


# Without a fused operation the product of two floats is still exact as a double.
_FUSED = {
    "double": "x * y + z",
    "float": "(float)((double)x * (double)y + (double)z)",
}

_TEXT = """\
/* x y + z; rounded once where the machine can do that quickly. */
static inline {kind} mechanics_fma{f}({kind} x, {kind} y, {kind} z)
{{
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA) || defined(FP_FAST_FMA{macro})
    return fma{f}(x, y, z);
#else
    return {fused};
#endif
}}

static inline uint{bits}_t mechanics_bits{f}({kind} x)
{{
    union {{ {kind} number; uint{bits}_t bits; }} both;
    both.number = x;
    return both.bits;
}}

/* x with its sign changed where bit 1 of n is set. */
static inline {kind} mechanics_turned{f}({kind} x, uint{bits}_t n)
{{
    union {{ {kind} number; uint{bits}_t bits; }} both;
    both.number = x;
    both.bits ^= (n & 2u) << {top};
    return both.number;
}}

/* 1 where |x| is too large for mechanics_sincos{f}, infinite or no number. */
static inline uint{bits}_t mechanics_far{f}({kind} x)
{{
    return !(fabs{f}(x) <= {limit});
}}

/* Sine and cosine of x in rad, |x| <= {limit}. */
static inline void mechanics_sincos{f}({kind} x, {kind} *sine, {kind} *cosine)
{{
    const {kind} shifted = mechanics_fma{f}(x, {turns}, {shift});
    const {kind} n = shifted - {shift};
{reduction}
    const {kind} low = n * {low};
    const {kind} z = r * r;
{sine}
{cosine}
    const {kind} s = r - mechanics_fma{f}(r * z, p0, low);
    const {kind} c = mechanics_fma{f}(z, mechanics_fma{f}(z, q0, -0.5{f}), 1.0{f});
    const uint{bits}_t quadrant = mechanics_bits{f}(shifted);
    const {kind} odd = quadrant & 1u ? c : s;
    const {kind} even = quadrant & 1u ? s : c;
    *sine = mechanics_turned{f}(odd, quadrant);
    *cosine = mechanics_turned{f}(even, quadrant + 1u);
}}
"""

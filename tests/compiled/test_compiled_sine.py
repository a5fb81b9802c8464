"""The inline sine and cosine, compiled: against exact values, by every compiler, fused or not."""

import ctypes
import platform

import numpy as np
import pytest

from benchmarks.minimax import COUNTS, REACHES, coefficients, pieces
from mechanics.compiled.c.sine import LIMIT, PRECISIONS, sine_source
from mechanics.compiled.machine.library import load

HEAD = "#include <math.h>\n#include <stdint.h>\n#include <stddef.h>\n"
LOOP = """
void turns(size_t count, const {kind} *x, {kind} *s, {kind} *c, {kind} *far)
{{
    for (size_t i = 0; i < count; ++i) {{
        mechanics_sincos{f}(x[i], s + i, c + i);
        far[i] = ({kind})mechanics_far{f}(x[i]);
    }}
}}
"""
# Floats from `first` to `last`, `step` apart: the largest error in ulp of the larger value.
ALL = """
static double ulp(float found, double exact)
{
    int e;
    const double size = fmax(fabs(exact), fabs(found));
    frexp(size, &e);
    return fabs(found - exact) / ldexp(1.0, e - 24 > -149 ? e - 24 : -149);
}

double largest(uint32_t first, uint32_t last, uint32_t step)
{
    double most = 0.0;
    for (uint64_t i = first; i <= last; i += step) {
        union { uint32_t bits; float number; } x;
        float s, c;
        x.bits = (uint32_t)i;
        if (mechanics_farf(x.number))
            continue;
        mechanics_sincosf(x.number, &s, &c);
        most = fmax(most, fmax(ulp(s, sin(x.number)), ulp(c, cos(x.number))));
    }
    return most;
}
"""
WITHOUT = "-O2 -mno-fma" if platform.machine() in ("x86_64", "AMD64") else "-O2"
FUSED = {"fused": "-O2 -march=native", "not fused": WITHOUT}
MOST = 1.6


def turned(compiler: str, flags: str, kind: type, x: np.ndarray) -> tuple[np.ndarray, ...]:
    """Sines, cosines and whether they are far, by the compiled text."""
    name = "float" if kind is np.float32 else "double"
    text = HEAD + sine_source(name) + LOOP.format(kind=name, f="f" if name == "float" else "")
    given = np.ascontiguousarray(x, kind)
    found = [np.empty_like(given) for _ in range(3)]
    arrays = [ctypes.c_void_p(a.ctypes.data) for a in (given, *found)]
    load(text, compiler, flags).turns(ctypes.c_size_t(given.size), *arrays)
    return tuple(found)


def angles(kind: type) -> np.ndarray:
    """All sizes, multiples of pi/2 and their neighbours, and the limit."""
    random = np.random.default_rng(4)
    turn = np.longdouble(np.pi) / 2
    near = (random.integers(0, int(LIMIT / turn), 20_000) * turn).astype(kind)
    every = [
        random.uniform(-LIMIT, LIMIT, 20_000), random.uniform(-4, 4, 20_000), near,
        np.nextafter(near, kind(0)), np.nextafter(near, kind(np.inf)),
        np.ldexp(random.uniform(-1, 1, 5_000), -random.integers(0, 1074, 5_000)),
        [LIMIT, -LIMIT, 0.0, -0.0, np.finfo(kind).tiny, np.finfo(kind).smallest_subnormal],
    ]  # fmt: skip
    x = np.concatenate([np.asarray(part, kind) for part in every])
    return x[np.abs(x) <= LIMIT]


@pytest.mark.sample(2)
@pytest.mark.parametrize("flags", FUSED.values(), ids=FUSED)
@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_errors_are_as_proved(each: str, flags: str, kind: type) -> None:
    x = angles(kind)
    sines, cosines, far = turned(each, flags, kind, x)
    assert not far.any()
    wide = x.astype(np.longdouble)
    for found, true in ((sines, np.sin(wide)), (cosines, np.cos(wide))):
        size = np.maximum(np.abs(true).astype(kind), np.abs(found))
        ulps = np.abs(found - true) / np.spacing(size)
        assert ulps.max() <= MOST


@pytest.mark.sample(2)
@pytest.mark.parametrize("flags", FUSED.values(), ids=FUSED)
@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_odd_and_even_to_the_last_bit(each: str, flags: str, kind: type) -> None:
    x = angles(kind)
    there, back = (turned(each, flags, kind, sign * x) for sign in (1, -1))
    assert np.array_equal(there[0], -back[0])
    assert np.array_equal(np.signbit(there[0]), ~np.signbit(back[0]))
    assert np.array_equal(there[1], back[1])


@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_what_is_too_large_is_told(each: str, kind: type) -> None:
    limit, largest = kind(LIMIT), np.finfo(kind).max
    outside = [np.nextafter(limit, largest), 1e10, largest, np.inf, np.nan]
    x = np.array([*outside, *(-a for a in outside), limit, -limit, 0], kind)
    assert turned(each, "-O2", kind, x)[2].tolist() == [1] * 10 + [0] * 3


@pytest.mark.parametrize("flags", FUSED.values(), ids=FUSED)
def test_floats_from_one_end_to_the_other(compiler: str, flags: str) -> None:
    assert 0.5 < _largest(compiler, flags, 0.0, 1009) <= MOST


@pytest.mark.campaign
def test_every_float_that_is_not_tiny(compiler: str) -> None:
    # Below, the sine is the float itself, or its neighbour. Negative floats mirror the others.
    assert 1.4 < _largest(compiler, FUSED["fused"], 2.0**-12, 1) <= MOST


def _largest(compiler: str, flags: str, first: float, step: int) -> float:
    library = load(HEAD + sine_source("float") + ALL, compiler, flags)
    library.largest.restype = ctypes.c_double
    ends = np.array([first, LIMIT], np.float32).view(np.uint32)
    return library.largest(*(ctypes.c_uint32(int(end)) for end in ends), ctypes.c_uint32(step))


@pytest.mark.parametrize("kind", COUNTS)
def test_coefficients_are_computed_again(kind: str) -> None:
    at = PRECISIONS[kind]
    assert coefficients(kind) == (at.sine, at.cosine)


@pytest.mark.parametrize("kind", COUNTS)
def test_pieces_of_pi_are_computed_again(kind: str) -> None:
    assert pieces(kind) == PRECISIONS[kind].pieces


def test_polynomials_reach_as_far_as_reduced_angles() -> None:
    for kind, at in PRECISIONS.items():
        turns = float.fromhex(at.turns)
        reach = np.pi / 4 + abs(turns - 2 / np.pi) * LIMIT * np.pi / 2
        assert reach <= float(REACHES[kind]) < 1.01 * reach

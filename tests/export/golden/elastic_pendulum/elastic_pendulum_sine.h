/*
 * Sine and cosine that a compiler makes inline and vectorises; for the C files of this folder only.
 *
 * Valid up to 1048576 rad. mechanics_sin and mechanics_cos give no number beyond.
 */
#ifndef MECHANICS_elastic_pendulum_H_SINE
#define MECHANICS_elastic_pendulum_H_SINE

#include <math.h>
#include <stdint.h>

/* x y + z; rounded once where the machine can do that quickly. */
static inline double mechanics_fma(double x, double y, double z)
{
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA) || defined(FP_FAST_FMA)
    return fma(x, y, z);
#else
    return x * y + z;
#endif
}

static inline uint64_t mechanics_bits(double x)
{
    union { double number; uint64_t bits; } both;
    both.number = x;
    return both.bits;
}

/* x with its sign changed where bit 1 of n is set. */
static inline double mechanics_turned(double x, uint64_t n)
{
    union { double number; uint64_t bits; } both;
    both.number = x;
    both.bits ^= (n & 2u) << 62;
    return both.number;
}

/* 1 where |x| is too large for mechanics_sincos, infinite or no number. */
static inline uint64_t mechanics_far(double x)
{
    return !(fabs(x) <= 1048576.0);
}

/* Sine and cosine of x in rad, |x| <= 1048576.0. */
static inline void mechanics_sincos(double x, double *sine, double *cosine)
{
    const double shifted = mechanics_fma(x, 0x1.45f306dc9c883p-1, 0x1.8p52);
    const double n = shifted - 0x1.8p52;
    const double r1 = mechanics_fma(-n, 0x1.921fb544p+0, x);
    const double r2 = mechanics_fma(-n, 0x1.0b46p-34, r1);
    const double r = mechanics_fma(-n, 0x1.1a62633p-54, r2);
    const double low = n * 0x1.45c06e0e68948p-86;
    const double z = r * r;
    const double p4 = mechanics_fma(-0x1.5d8f94e117d01p-33, z, 0x1.ae5e59c61b5d6p-26);
    const double p3 = mechanics_fma(p4, z, -0x1.71de3566d820dp-19);
    const double p2 = mechanics_fma(p3, z, 0x1.a01a019bfcd84p-13);
    const double p1 = mechanics_fma(p2, z, -0x1.111111110f7c8p-7);
    const double p0 = mechanics_fma(p1, z, 0x1.5555555555548p-3);
    const double q4 = mechanics_fma(-0x1.8fa456057e64ap-37, z, 0x1.1ee9d7349a3p-29);
    const double q3 = mechanics_fma(q4, z, -0x1.27e4f7ea0cb6dp-22);
    const double q2 = mechanics_fma(q3, z, 0x1.a01a019c83577p-16);
    const double q1 = mechanics_fma(q2, z, -0x1.6c16c16c14f88p-10);
    const double q0 = mechanics_fma(q1, z, 0x1.555555555554bp-5);
    const double s = r - mechanics_fma(r * z, p0, low);
    const double c = mechanics_fma(z, mechanics_fma(z, q0, -0.5), 1.0);
    const uint64_t quadrant = mechanics_bits(shifted);
    const double odd = quadrant & 1u ? c : s;
    const double even = quadrant & 1u ? s : c;
    *sine = mechanics_turned(odd, quadrant);
    *cosine = mechanics_turned(even, quadrant + 1u);
}

static inline double mechanics_sin(double x)
{
    double sine, cosine;
    mechanics_sincos(x, &sine, &cosine);
    return mechanics_far(x) ? (double)NAN : sine;
}

static inline double mechanics_cos(double x)
{
    double sine, cosine;
    mechanics_sincos(x, &sine, &cosine);
    return mechanics_far(x) ? (double)NAN : cosine;
}

#endif /* MECHANICS_elastic_pendulum_H_SINE */

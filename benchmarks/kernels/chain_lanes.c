/*
 * Cart with one link and with five, many states at once, by hand: structure of arrays, entry k of
 * state i at [k * stride + i]; parameters are shared. Point masses m at the ends of massless links
 * of length l, angles from the upward vertical (the system and the names of pendulum_chain).
 *
 * A massless link transmits nothing but a force along itself. With its tension T_i and directions
 * n_i = (-sin q_i, cos q_i), the accelerations along the links give a tridiagonal system,
 *
 *   (1/m_1 + s_1^2/m_0) T_1 - c_12/m_1 T_2 = g c_1 - l_1 w_1^2 - s_1 F/m_0
 *   -c_ij/m_i T_i + (1/m_i + 1/m_j) T_j - c_jk/m_j T_k = -l_j w_j^2          i = j - 1, k = j + 1
 *
 * and those across the links the angular accelerations. Signs of T: m_i a_i = T_i n_i - ...
 *
 * Sine and cosine: x = k pi/2 + r, k pi/2 in three parts by fused multiply-add, minimax polynomials
 * of degree 13 and 14 in r (computed by Remez's algorithm with 60 digits), for |x| < 1e6.
 */
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

static inline uint64_t bits(double x)
{
    uint64_t b;
    memcpy(&b, &x, sizeof b);
    return b;
}

static inline double number(uint64_t b)
{
    double x;
    memcpy(&x, &b, sizeof x);
    return x;
}

static inline void sine_cosine(double x, double *sine, double *cosine)
{
    /* adding 1.5 * 2^52 rounds to an integer, which then stands in the low bits */
    const double shifted = fma(x, 0x1.45f306dc9c883p-1, 0x1.8p52);
    const uint64_t quadrant = bits(shifted);
    const double k = shifted - 0x1.8p52;
    double r = fma(k, -0x1.921fb54442d18p+0, x);
    r = fma(k, -0x1.1a62633145c07p-54, r);
    r = fma(k, 0x1.f1976b7ed8fbcp-110, r);
    const double z = r * r;
    double a = 0x1.5d93186ff0f53p-33;
    a = fma(a, z, -0x1.ae5e6689264f3p-26);
    a = fma(a, z, 0x1.71de357817eb6p-19);
    a = fma(a, z, -0x1.a01a019c1205ep-13);
    a = fma(a, z, 0x1.111111110f87ep-7);
    a = fma(a, z, -0x1.5555555555549p-3);
    const double s = fma(r * z, a, r);
    double b = -0x1.8faeb5d293ac4p-37;
    b = fma(b, z, 0x1.1ee9ec1896d4cp-29);
    b = fma(b, z, -0x1.27e4f80a3403ap-22);
    b = fma(b, z, 0x1.a01a019cb217ap-16);
    b = fma(b, z, -0x1.6c16c16c15181p-10);
    b = fma(b, z, 0x1.555555555554cp-5);
    const double c = fma(z * z, b, fma(z, -0.5, 1.0));
    const uint64_t swap = 0 - (quadrant & 1);
    const uint64_t bs = bits(s), bc = bits(c), change = (bs ^ bc) & swap;
    *sine = number((bs ^ change) ^ ((quadrant << 62) & 0x8000000000000000u));
    *cosine = number((bc ^ change) ^ (((quadrant + 1) << 62) & 0x8000000000000000u));
}

void chain_1_lanes(size_t count, size_t stride, const double *restrict q, const double *restrict u,
    const double *restrict inputs, const double *restrict p, double *restrict ud)
{
    /* p = g, l0, m0, m1 */
    const double g = p[0], l = p[1], m0 = p[2], m = p[3], per_l = 1.0 / l;
#pragma omp simd
    for (size_t i = 0; i < count; ++i) {
        double s, c;
        sine_cosine(q[stride + i], &s, &c);
        const double w = u[stride + i];
        const double a
            = fma(m * s, fma(-l, w * w, g * c), inputs[i]) / fma(m * s, s, m0);
        ud[i] = a;
        ud[stride + i] = fma(a, c, g * s) * per_l;
    }
}

void chain_5_lanes(size_t count, size_t stride, const double *restrict q, const double *restrict u,
    const double *restrict inputs, const double *restrict p, double *restrict ud)
{
    /* p = g, l0, ..., l4, m0, ..., m5; r are the reciprocals of the masses, e of the lengths */
    const double g = p[0];
    const double l1 = p[1], l2 = p[2], l3 = p[3], l4 = p[4], l5 = p[5];
    const double r0 = 1 / p[6], r1 = 1 / p[7], r2 = 1 / p[8], r3 = 1 / p[9], r4 = 1 / p[10];
    const double r5 = 1 / p[11];
    const double e1 = 1 / l1, e2 = 1 / l2, e3 = 1 / l3, e4 = 1 / l4, e5 = 1 / l5;
    const double r12 = r1 + r2, r23 = r2 + r3, r34 = r3 + r4, r45 = r4 + r5;
    const double r45_34 = r45 * r34, r44 = r4 * r4, r33 = r3 * r3, r22 = r2 * r2, r11 = r1 * r1;
#pragma omp simd
    for (size_t i = 0; i < count; ++i) {
        double s1, c1, s2, c2, s3, c3, s4, c4, s5, c5;
        sine_cosine(q[1 * stride + i], &s1, &c1);
        sine_cosine(q[2 * stride + i], &s2, &c2);
        sine_cosine(q[3 * stride + i], &s3, &c3);
        sine_cosine(q[4 * stride + i], &s4, &c4);
        sine_cosine(q[5 * stride + i], &s5, &c5);
        const double w1 = u[1 * stride + i], w2 = u[2 * stride + i], w3 = u[3 * stride + i];
        const double w4 = u[4 * stride + i], w5 = u[5 * stride + i], f = inputs[i] * r0;
        const double k12 = fma(c1, c2, s1 * s2), k23 = fma(c2, c3, s2 * s3);
        const double k34 = fma(c3, c4, s3 * s4), k45 = fma(c4, c5, s4 * s5);
        const double h1 = fma(g, c1, -fma(l1, w1 * w1, s1 * f));
        const double h2 = -l2 * (w2 * w2), h3 = -l3 * (w3 * w3), h4 = -l4 * (w4 * w4);
        const double h5 = -l5 * (w5 * w5);
        /* continuants D_j of the rows j to 5, and right sides G_j = D_(j+1) h_j + k r G_(j+1):
           one division instead of five */
        const double d5 = r45;
        const double d4 = fma(-r44, k45 * k45, r45_34);
        const double d3 = fma(r23, d4, -r33 * (k34 * k34) * d5);
        const double d2 = fma(r12, d3, -r22 * (k23 * k23) * d4);
        const double d1 = fma(fma(r0 * s1, s1, r1), d2, -r11 * (k12 * k12) * d3);
        const double b5 = k45 * r4, b4 = k34 * r3, b3 = k23 * r2, b2 = k12 * r1;
        const double g4 = fma(d5, h4, b5 * h5);
        const double g3 = fma(d4, h3, b4 * g4);
        const double g2 = fma(d3, h2, b3 * g3);
        const double g1 = fma(d2, h1, b2 * g2);
        const double d12 = d1 * d2, d34 = d3 * d4, d345 = d34 * d5, t = 1.0 / (d12 * d345);
        const double t12 = t * d12, t345 = t * d345;
        const double T1 = g1 * (t345 * d2);
        const double T2 = fma(b2 * d3, T1, g2) * (t345 * d1);
        const double T3 = fma(b3 * d4, T2, g3) * (t12 * (d4 * d5));
        const double T4 = fma(b4 * d5, T3, g4) * (t12 * (d3 * d5));
        const double T5 = fma(b5, T4, h5) * (t12 * d34);
        const double a = fma(T1 * r0, s1, f);
        const double x12 = fma(s2, c1, -c2 * s1) * r1, x23 = fma(s3, c2, -c3 * s2) * r2;
        const double x34 = fma(s4, c3, -c4 * s3) * r3, x45 = fma(s5, c4, -c5 * s4) * r4;
        ud[i] = a;
        ud[1 * stride + i] = fma(g, s1, fma(c1, a, -T2 * x12)) * e1;
        ud[2 * stride + i] = fma(T1, x12, -T3 * x23) * e2;
        ud[3 * stride + i] = fma(T2, x23, -T4 * x34) * e3;
        ud[4 * stride + i] = fma(T3, x34, -T5 * x45) * e4;
        ud[5 * stride + i] = T4 * x45 * e5;
    }
}

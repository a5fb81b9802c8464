/* pendulum on elastic support: many states at once. */

#include "elastic_pendulum_batch.h"
#include "elastic_pendulum_sine.h"

#include <math.h>

#if !defined(ELASTIC_PENDULUM_ALLOW_FAST_MATH) && (defined(__FAST_MATH__) || defined(_M_FP_FAST) || \
    defined(__ASSOCIATIVE_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__))
#error "fast-math takes the statuses and the inline sine away: ELASTIC_PENDULUM_ALLOW_FAST_MATH allows it"
#endif

static inline int elastic_pendulum_forward_dynamics_batch_lanes(size_t count, size_t stride,
    const double *restrict q, const double *restrict u, const double *restrict p,
    double *restrict ud)
{
    const double L = p[0];
    const double M = p[1];
    const double g = p[2];
    const double k = p[3];
    const double m = p[4];
    const double v1 = -0x1.5555555555555p-1 * L;
    const double v3 = 0x1.5555555555555p+1 * k;
    const double v5 = 0x1.5555555555555p+0 * (M + m);
    const double v9 = 1.0 / v1;
    uint64_t far = 0;
    uint64_t wild = 0;
#if defined(__clang__)
#pragma clang loop vectorize(assume_safety)
#elif defined(__GNUC__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double x = q[i];
        const double theta = q[1 * stride + i];
        const double theta_dot = u[1 * stride + i];
        double sin_theta, cos_theta;
        mechanics_sincos(theta, &sin_theta, &cos_theta);
        const double v2 = mechanics_fma(-theta_dot, theta_dot * v1, g * cos_theta);
        const double v4 = mechanics_fma(-x, v3, v2 * (M * sin_theta));
        const double v6 = mechanics_fma(-M, cos_theta * cos_theta, v5);
        const double v7 = v4 / v6;
        const double v8 = mechanics_fma(g, sin_theta, cos_theta * v7);
        ud[i] = v7;
        ud[1 * stride + i] = v8 * v9;
        const uint64_t beyond = mechanics_far(theta);
        far |= beyond;
        wild |= !beyond & !(fabs(v7 + (v8 * v9) + v6 + v1) <= 0x1.fffffffffffffp+1023);
    }
    return (far != 0) | (wild != 0) << 1;
}

/* The states whose angles are too large for the inline sine, by the C library. */
static int elastic_pendulum_forward_dynamics_batch_far(size_t count, size_t stride, const double *q,
    const double *u, const double *p, double *ud)
{
    int found = 0;
    for (size_t i = 0; i < count; ++i) {
        if (!(elastic_pendulum_forward_dynamics_batch_lanes(1, stride, q + i, u + i, p,
            ud + i) & 1))
            continue;
        double q_[2];
        double u_[2];
        double ud_[2];
        for (size_t k = 0; k < 2; ++k)
            q_[k] = q[k * stride + i];
        for (size_t k = 0; k < 2; ++k)
            u_[k] = u[k * stride + i];
        const int status = elastic_pendulum_forward_dynamics(q_, u_, p, ud_);
        for (size_t k = 0; k < 2; ++k)
            ud[k * stride + i] = ud_[k];
        found |= status != 0 ? 2 : 0;
    }
    return found;
}

int elastic_pendulum_forward_dynamics_batch(size_t count, size_t stride, const double *q,
    const double *u, const double *p, double *ud)
{
    int found = 0;
    for (size_t i = 0; i < count; i += 256) {
        const size_t lanes = count - i < 256 ? count - i : 256;
        const int flags = elastic_pendulum_forward_dynamics_batch_lanes(lanes, stride, q + i, u + i,
            p, ud + i);
        found |= flags;
        if (flags & 1)
            found |= elastic_pendulum_forward_dynamics_batch_far(lanes, stride, q + i, u + i, p,
                ud + i);
    }
    return found;
}

static inline int elastic_pendulum_energy_batch_lanes(size_t count, size_t stride,
    const double *restrict q, const double *restrict u, const double *restrict p,
    double *restrict kinetic, double *restrict potential, double *restrict total)
{
    const double L = p[0];
    const double M = p[1];
    const double g = p[2];
    const double k = p[3];
    const double m = p[4];
    const double v1 = M * (L * L) / 12.0;
    const double v2 = 0x1p-1 * L;
    uint64_t far = 0;
    uint64_t wild = 0;
#if defined(__clang__)
#pragma clang loop vectorize(assume_safety)
#elif defined(__GNUC__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double x = q[i];
        const double theta = q[1 * stride + i];
        const double x_dot = u[i];
        const double theta_dot = u[1 * stride + i];
        double sin_theta, cos_theta;
        mechanics_sincos(theta, &sin_theta, &cos_theta);
        const double v3 = theta_dot * (sin_theta * v2);
        const double v4 = v2 * cos_theta;
        const double v5 = mechanics_fma(theta_dot, v4, x_dot);
        const double v6 = mechanics_fma(v5, v5, v3 * v3);
        const double v7 = mechanics_fma(M, v6, m * (x_dot * x_dot));
        const double v8 = mechanics_fma(theta_dot, theta_dot * v1, v7);
        const double v9 = 0x1p-1 * v8;
        const double v10 = mechanics_fma(-M, g * v4, k * (x * x));
        kinetic[i] = v9;
        potential[i] = v10;
        total[i] = v9 + v10;
        const uint64_t beyond = mechanics_far(theta);
        far |= beyond;
        wild |= !beyond & !(fabs(v9 + v10 + (v9 + v10)) <= 0x1.fffffffffffffp+1023);
    }
    return (far != 0) | (wild != 0) << 1;
}

/* The states whose angles are too large for the inline sine, by the C library. */
static int elastic_pendulum_energy_batch_far(size_t count, size_t stride, const double *q,
    const double *u, const double *p, double *kinetic, double *potential, double *total)
{
    int found = 0;
    for (size_t i = 0; i < count; ++i) {
        if (!(elastic_pendulum_energy_batch_lanes(1, stride, q + i, u + i, p, kinetic + i,
            potential + i, total + i) & 1))
            continue;
        double q_[2];
        double u_[2];
        double kinetic_[1];
        double potential_[1];
        double total_[1];
        for (size_t k = 0; k < 2; ++k)
            q_[k] = q[k * stride + i];
        for (size_t k = 0; k < 2; ++k)
            u_[k] = u[k * stride + i];
        const int status = elastic_pendulum_energy(q_, u_, p, kinetic_, potential_, total_);
        for (size_t k = 0; k < 1; ++k)
            kinetic[k * stride + i] = kinetic_[k];
        for (size_t k = 0; k < 1; ++k)
            potential[k * stride + i] = potential_[k];
        for (size_t k = 0; k < 1; ++k)
            total[k * stride + i] = total_[k];
        found |= status != 0 ? 2 : 0;
    }
    return found;
}

int elastic_pendulum_energy_batch(size_t count, size_t stride, const double *q, const double *u,
    const double *p, double *kinetic, double *potential, double *total)
{
    int found = 0;
    for (size_t i = 0; i < count; i += 256) {
        const size_t lanes = count - i < 256 ? count - i : 256;
        const int flags = elastic_pendulum_energy_batch_lanes(lanes, stride, q + i, u + i, p,
            kinetic + i, potential + i, total + i);
        found |= flags;
        if (flags & 1)
            found |= elastic_pendulum_energy_batch_far(lanes, stride, q + i, u + i, p, kinetic + i,
                potential + i, total + i);
    }
    return found;
}

static inline int elastic_pendulum_coordinate_rates_batch_lanes(size_t count, size_t stride,
    const double *restrict q, const double *restrict u, const double *restrict p,
    double *restrict qd)
{
    (void)q;
    (void)p;
    uint64_t far = 0;
    uint64_t wild = 0;
#if defined(__clang__)
#pragma clang loop vectorize(assume_safety)
#elif defined(__GNUC__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double x_dot = u[i];
        const double theta_dot = u[1 * stride + i];
        qd[i] = x_dot;
        qd[1 * stride + i] = theta_dot;
        wild |= !(fabs(x_dot + theta_dot) <= 0x1.fffffffffffffp+1023);
    }
    return (far != 0) | (wild != 0) << 1;
}

/* The states whose angles are too large for the inline sine, by the C library. */
static int elastic_pendulum_coordinate_rates_batch_far(size_t count, size_t stride, const double *q,
    const double *u, const double *p, double *qd)
{
    int found = 0;
    for (size_t i = 0; i < count; ++i) {
        if (!(elastic_pendulum_coordinate_rates_batch_lanes(1, stride, q + i, u + i, p,
            qd + i) & 1))
            continue;
        double q_[2];
        double u_[2];
        double qd_[2];
        for (size_t k = 0; k < 2; ++k)
            q_[k] = q[k * stride + i];
        for (size_t k = 0; k < 2; ++k)
            u_[k] = u[k * stride + i];
        const int status = elastic_pendulum_coordinate_rates(q_, u_, p, qd_);
        for (size_t k = 0; k < 2; ++k)
            qd[k * stride + i] = qd_[k];
        found |= status != 0 ? 2 : 0;
    }
    return found;
}

int elastic_pendulum_coordinate_rates_batch(size_t count, size_t stride, const double *q,
    const double *u, const double *p, double *qd)
{
    int found = 0;
    for (size_t i = 0; i < count; i += 256) {
        const size_t lanes = count - i < 256 ? count - i : 256;
        const int flags = elastic_pendulum_coordinate_rates_batch_lanes(lanes, stride, q + i, u + i,
            p, qd + i);
        found |= flags;
        if (flags & 1)
            found |= elastic_pendulum_coordinate_rates_batch_far(lanes, stride, q + i, u + i, p,
                qd + i);
    }
    return found;
}

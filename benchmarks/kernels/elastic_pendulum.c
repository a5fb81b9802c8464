/*
 * Pendulum on an elastic support, by hand: forward dynamics with as few operations as we can find.
 *
 * The second equation times 2 / (M L) is c x'' + l theta'' = -g s with l = 2 L / 3; put into the
 * first, which is multiplied by 4 / 3:
 *
 *   x'' = (M s (l w^2 + g c) - 8/3 k x) / (4/3 (M + m) - M c^2)
 *   theta'' = (g s + c x'') / -l
 *
 * One reciprocal for both quotients would take two multiplications more.
 */
#include <math.h>

void elastic_pendulum(const double q[2], const double u[2], const double p[5], double ud[2])
{
    const double L = p[0], M = p[1], g = p[2], k = p[3], m = p[4];
    const double s = sin(q[1]), c = cos(q[1]), w = u[1];
    const double l = -2.0 / 3.0 * L;
    const double a = (M * s * (g * c - l * w * w) - 8.0 / 3.0 * k * q[0])
        / (4.0 / 3.0 * (M + m) - M * (c * c));
    ud[0] = a;
    ud[1] = (g * s + c * a) / l;
}

/* M = m = L = 1, k = 10, g = 9.81; the numerator and denominator above, times 3/2 */
void elastic_pendulum_fixed(const double q[2], const double u[2], double ud[2])
{
    const double s = sin(q[1]), c = cos(q[1]), w = u[1];
    const double c1 = -1.5 * c;
    const double a = (s * (w * w - 9.81 * c1) - 40.0 * q[0]) / (4.0 + c * c1);
    ud[0] = a;
    ud[1] = c1 * a - 14.715 * s;
}

/*
 * Cart with one link, by hand: a point mass m at the end of a massless link of length l, its angle
 * from the upward vertical (the system of pendulum_chain(1); p = g, l0, m0, m1).
 *
 * The link transmits nothing but a force along itself, so that
 *
 *   x'' = (F + m s (g c - l w^2)) / (m0 + m s^2)
 *   theta'' = (c x'' + g s) / l
 *
 * One reciprocal for both quotients would take two multiplications more.
 */
#include <math.h>

void cart_pole(const double q[2], const double u[2], const double inputs[1], const double p[4],
    double ud[2])
{
    const double g = p[0], l = p[1], m0 = p[2], m = p[3];
    const double s = sin(q[1]), c = cos(q[1]), w = u[1];
    const double ms = m * s;
    const double a = (inputs[0] + ms * (g * c - l * (w * w))) / (m0 + ms * s);
    ud[0] = a;
    ud[1] = (c * a + g * s) / l;
}

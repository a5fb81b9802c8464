/*
 * Rocker, by hand: forward dynamics with as few operations as we can find.
 *
 *   theta'' = R (M s (R w^2 + g) + f (2 + c)) / (2 (I_C + M R^2 (5/4 + c)))
 *
 * Divided through by R it would take a multiplication less and a division more: not faster.
 */
#include <math.h>

void rocker(const double q[1], const double u[1], const double inputs[1], const double p[4],
    double ud[1])
{
    const double I_C = p[0], M = p[1], R = p[2], g = p[3], f = inputs[0];
    const double s = sin(q[0]), c = cos(q[0]), w = u[0];
    ud[0] = 0.5 * R * (M * s * (R * w * w + g) + f * (2.0 + c)) / (I_C + M * R * R * (1.25 + c));
}

/* M = 1, I_C = 0.01, R = 0.1, g = 9.81; numerator and denominator times 200 */
void rocker_fixed(const double q[1], const double u[1], const double inputs[1], double ud[1])
{
    const double s = sin(q[0]), c = cos(q[0]), w = u[0];
    ud[0] = (s * (w * w + 98.1) + inputs[0] * (20.0 + 10.0 * c)) / (4.5 + 2.0 * c);
}

/*
 * Two masses 3 m and 2 m on two springs, by hand: forward dynamics with as few operations as we can
 * find.
 *
 *   d = x1 - x2,  r = k / m,  x1'' = -(x1 + d) r / 3,  x2'' = d r / 2
 */

void two_mass_chain(const double q[2], const double p[2], double ud[2])
{
    const double r = p[0] / p[1], d = q[0] - q[1];
    ud[0] = -1.0 / 3.0 * r * (q[0] + d);
    ud[1] = 0.5 * r * d;
}

/* k = m = 1 */
void two_mass_chain_fixed(const double q[2], double ud[2])
{
    const double d = q[0] - q[1];
    ud[0] = -1.0 / 3.0 * (q[0] + d);
    ud[1] = 0.5 * d;
}

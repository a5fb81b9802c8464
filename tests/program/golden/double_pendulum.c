#include <math.h>

void double_pendulum(
    const double q[2],
    const double u[2],
    const double p[5],
    double alpha[2])
{
    const double t6 = p[3] * (p[1] * p[2]);
    const double t9 = q[0] - q[1];
    const double t11 = t6 * sin(t9);
    const double t14 = p[1] + p[0];
    const double t20 = u[1] * u[1] * t11 + p[2] * (t14 * p[4]) * sin(q[0]);
    const double t22 = t14 * (p[2] * p[2]);
    const double t25 = t6 * cos(t9);
    const double t26 = t25 / t22;
    const double t34 = t11 * (u[0] * u[0]) - p[3] * (p[1] * p[4]) * sin(q[1]);
    const double t41 = (t34 + t26 * t20) / (p[3] * p[3] * p[1] - t25 * t26);
    alpha[0] = -(t20 / t22 + t26 * t41);
    alpha[1] = t41;
}

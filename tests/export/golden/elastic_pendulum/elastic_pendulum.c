/* pendulum on elastic support, derived by free_body */

#include "elastic_pendulum.h"

#include <math.h>

void elastic_pendulum_forward_dynamics(const double q[2], const double u[2], const double p[5],
    double ud[2])
{
    const double x = q[0];
    const double theta = q[1];
    const double theta_dot = u[1];
    const double L = p[0];
    const double M = p[1];
    const double g = p[2];
    const double k = p[3];
    const double m = p[4];
    const double cos_theta = cos(theta);
    const double v1 = -0x1.5555555555555p-1 * L;
    const double sin_theta = sin(theta);
    const double v2 = (cos_theta * g - theta_dot * (v1 * theta_dot)) * (sin_theta * M);
    const double v3 = x * (0x1.5555555555555p+1 * k);
    const double v4 = 0x1.5555555555555p+0 * (M + m) - M * (cos_theta * cos_theta);
    const double v5 = (v2 - v3) / v4;
    ud[0] = v5;
    ud[1] = (cos_theta * v5 + g * sin_theta) / v1;
}

void elastic_pendulum_mass_matrix(const double q[2], const double u[2], const double p[5],
    double mass_matrix[4])
{
    (void)u;
    const double theta = q[1];
    const double L = p[0];
    const double M = p[1];
    const double m = p[4];
    const double cos_theta = cos(theta);
    const double v1 = L * M * cos_theta / 2.0;
    mass_matrix[0] = M + m;
    mass_matrix[1] = v1;
    mass_matrix[2] = v1;
    mass_matrix[3] = L * L * M / 3.0;
}

void elastic_pendulum_forcing(const double q[2], const double u[2], const double p[5],
    double forcing[2])
{
    const double x = q[0];
    const double theta = q[1];
    const double theta_dot = u[1];
    const double L = p[0];
    const double M = p[1];
    const double g = p[2];
    const double k = p[3];
    const double sin_theta = sin(theta);
    forcing[0] = theta_dot * theta_dot * L * M * sin_theta / 2.0 - 2.0 * x * k;
    forcing[1] = -(L * M * g * sin_theta / 2.0);
}

void elastic_pendulum_residual(const double q[2], const double u[2], const double p[5],
    const double ud[2], double residual[2])
{
    const double x = q[0];
    const double theta = q[1];
    const double theta_dot = u[1];
    const double L = p[0];
    const double M = p[1];
    const double g = p[2];
    const double k = p[3];
    const double m = p[4];
    const double x_ddot = ud[0];
    const double theta_ddot = ud[1];
    const double v1 = L * M;
    const double cos_theta = cos(theta);
    const double v2 = v1 * cos_theta / 2.0;
    const double sin_theta = sin(theta);
    const double v3 = (M + m) * x_ddot + v2 * theta_ddot;
    const double v4 = theta_dot * theta_dot * L * M * sin_theta / 2.0 - 2.0 * x * k;
    const double v5 = v2 * x_ddot + L * L * M / 3.0 * theta_ddot;
    const double v6 = v1 * g * sin_theta / 2.0;
    residual[0] = v3 - v4;
    residual[1] = v5 + v6;
}

void elastic_pendulum_inverse_dynamics(const double q[2], const double u[2], const double p[5],
    const double ud[2], double forces[2])
{
    const double x = q[0];
    const double theta = q[1];
    const double theta_dot = u[1];
    const double L = p[0];
    const double M = p[1];
    const double g = p[2];
    const double k = p[3];
    const double m = p[4];
    const double x_ddot = ud[0];
    const double theta_ddot = ud[1];
    const double cos_theta = cos(theta);
    const double v1 = -0x1.5555555555555p-1 * L;
    const double sin_theta = sin(theta);
    const double v2 = (cos_theta * g - theta_dot * (v1 * theta_dot)) * (sin_theta * M);
    const double v3 = x * (0x1.5555555555555p+1 * k);
    const double v4 = 0x1.5555555555555p+0 * (M + m) - M * (cos_theta * cos_theta);
    const double v5 = (v2 - v3) / v4;
    const double v6 = x_ddot - v5;
    const double v7 = cos_theta * L;
    const double v8 = 0x1p-1 * (M * v7);
    const double v9 = theta_ddot - (cos_theta * v5 + g * sin_theta) / v1;
    const double v10 = 2.0 * (L * L);
    const double v11 = M * (0x1p-1 * v7 * v7 + 0x1p-2 * (sin_theta * sin_theta * v10));
    forces[0] = (m + M) * v6 + v8 * v9;
    forces[1] = v8 * v6 + (0x1p-1 * v11 + M * v10 / 24.0) * v9;
}

void elastic_pendulum_energy(const double q[2], const double u[2], const double p[5],
    double kinetic[1], double potential[1], double total[1])
{
    const double x = q[0];
    const double theta = q[1];
    const double x_dot = u[0];
    const double theta_dot = u[1];
    const double L = p[0];
    const double M = p[1];
    const double g = p[2];
    const double k = p[3];
    const double m = p[4];
    const double cos_theta = cos(theta);
    const double v1 = x_dot + theta_dot * L * cos_theta / 2.0;
    const double v2 = theta_dot * theta_dot * (L * L);
    const double sin_theta = sin(theta);
    const double v3 = x_dot * x_dot * m / 2.0;
    const double v4 = (v1 * v1 + v2 * (sin_theta * sin_theta) / 4.0) * M / 2.0;
    const double v5 = v3 + v4 + v2 * M / 24.0;
    const double v6 = x * x * k - L * M * g * cos_theta / 2.0;
    kinetic[0] = v5;
    potential[0] = v6;
    total[0] = v5 + v6;
}

void elastic_pendulum_momenta(const double q[2], const double u[2], const double p[5],
    double linear[3], double angular[3], double generalized[2])
{
    const double x = q[0];
    const double theta = q[1];
    const double x_dot = u[0];
    const double theta_dot = u[1];
    const double L = p[0];
    const double M = p[1];
    const double m = p[4];
    const double v1 = theta_dot * L;
    const double cos_theta = cos(theta);
    const double v2 = x_dot + v1 * cos_theta / 2.0;
    const double sin_theta = sin(theta);
    const double v3 = L * L;
    const double v4 = theta_dot * v3 * M / 12.0 + v2 * L * M * cos_theta / 2.0;
    const double v5 = theta_dot * (x + L * sin_theta / 2.0) * L * M * sin_theta / 2.0;
    const double v6 = 2.0 * v2;
    const double v7 = v3 * (2.0 * theta_dot);
    const double v8 = v6 * (0x1p-1 * (cos_theta * L));
    const double v9 = 0x1p-2 * (sin_theta * sin_theta * v7);
    linear[0] = x_dot * m + v2 * M;
    linear[1] = v1 * M * sin_theta / 2.0;
    linear[2] = 0.0;
    angular[0] = 0.0;
    angular[1] = 0.0;
    angular[2] = v4 + v5;
    generalized[0] = 0x1p-1 * (m * (2.0 * x_dot)) + 0x1p-1 * (M * v6);
    generalized[1] = 0x1p-1 * (M * (v8 + v9)) + M * v7 / 24.0;
}

void elastic_pendulum_coordinate_rates(const double q[2], const double u[2], const double p[5],
    double qd[2])
{
    (void)q;
    (void)p;
    const double x_dot = u[0];
    const double theta_dot = u[1];
    qd[0] = x_dot;
    qd[1] = theta_dot;
}

void elastic_pendulum_jacobians(const double q[2], const double u[2], const double p[5],
    double ud_q[4], double ud_u[4], double ud_p[10])
{
    const double x = q[0];
    const double theta = q[1];
    const double theta_dot = u[1];
    const double L = p[0];
    const double M = p[1];
    const double g = p[2];
    const double k = p[3];
    const double m = p[4];
    const double v1 = L * M;
    const double cos_theta = cos(theta);
    const double v2 = v1 * cos_theta / 2.0;
    const double v3 = L * L;
    const double v4 = v3 * M / 3.0;
    const double v5 = v2 / v4;
    const double v6 = M + m - v5 * v2;
    const double v7 = 2.0 * -k / v6;
    const double v8 = theta_dot * theta_dot;
    const double v9 = v8 * L;
    const double v10 = v9 * M;
    const double sin_theta = sin(theta);
    const double v11 = v1 * g;
    const double v12 = v11 * sin_theta / 2.0;
    const double v13 = 2.0 * x;
    const double v14 = (v10 * sin_theta / 2.0 - v13 * k + v5 * v12) / v6;
    const double v15 = (v12 + v2 * v14) / v4;
    const double v16 = 0x1p-1 * v15;
    const double v17 = 0x1p-1 * v14;
    const double v18 = sin_theta * (v1 * v17) + cos_theta * (-0x1p-1 * v11);
    const double v19 = cos_theta * (0x1p-1 * v10) - sin_theta * (v1 * v16) - v5 * v18;
    const double v20 = v19 / v6;
    const double v21 = 0x1p-1 * sin_theta;
    const double v22 = M * v21;
    const double v23 = 2.0 * theta_dot * (L * v22) / v6;
    const double v24 = cos_theta * v16;
    const double v25 = -0x1p-1 * sin_theta;
    const double v26 = g * v25;
    const double v27 = v15 / 3.0;
    const double v28 = cos_theta * v17;
    const double v29 = M * v26 + 2.0 * L * (M * v27) - M * v28;
    const double v30 = (v8 * v22 + M * v24 - v5 * v29) / v6;
    const double v31 = L * v26 + v3 * v27 - L * v28;
    const double v32 = (v9 * v21 - (v14 - L * v24) - v5 * v31) / v6;
    const double v33 = v1 * v25;
    const double v34 = v5 * v33 / v6;
    const double v35 = v13 / v6;
    const double v36 = v14 / v6;
    ud_q[0] = v7;
    ud_q[1] = -(v2 * v7 / v4);
    ud_q[2] = v20;
    ud_q[3] = (v18 - v2 * v20) / v4;
    ud_u[0] = 0.0;
    ud_u[1] = 0.0;
    ud_u[2] = v23;
    ud_u[3] = -(v2 * v23 / v4);
    ud_p[0] = v30;
    ud_p[1] = (v29 - v2 * v30) / v4;
    ud_p[2] = v32;
    ud_p[3] = (v31 - v2 * v32) / v4;
    ud_p[4] = -v34;
    ud_p[5] = (v33 + v2 * v34) / v4;
    ud_p[6] = -v35;
    ud_p[7] = v2 * v35 / v4;
    ud_p[8] = -v36;
    ud_p[9] = v2 * v36 / v4;
}

void elastic_pendulum_step(const double q[2], const double u[2], const double p[5],
    const double h[1], double q_next[2], double u_next[2])
{
    const double x = q[0];
    const double theta = q[1];
    const double x_dot = u[0];
    const double theta_dot = u[1];
    const double L = p[0];
    const double M = p[1];
    const double g = p[2];
    const double k = p[3];
    const double m = p[4];
    const double h_ = h[0];
    const double cos_theta = cos(theta);
    const double v1 = -0x1.5555555555555p-1 * L;
    const double sin_theta = sin(theta);
    const double v2 = 0x1.5555555555555p+1 * k;
    const double v3 = (cos_theta * g - theta_dot * (v1 * theta_dot)) * (sin_theta * M);
    const double v4 = 0x1.5555555555555p+0 * (M + m);
    const double v5 = (v3 - x * v2) / (v4 - M * (cos_theta * cos_theta));
    const double v6 = x_dot + h_ * (v5 / 2.0);
    const double v7 = theta + h_ * (theta_dot / 2.0);
    const double cos_v7 = cos(v7);
    const double v8 = (cos_theta * v5 + g * sin_theta) / v1;
    const double v9 = theta_dot + h_ * (v8 / 2.0);
    const double sin_v7 = sin(v7);
    const double v10 = (cos_v7 * g - v9 * (v1 * v9)) * (sin_v7 * M);
    const double v11 = (x + h_ * (x_dot / 2.0)) * v2;
    const double v12 = (v10 - v11) / (v4 - M * (cos_v7 * cos_v7));
    const double v13 = x_dot + h_ * (v12 / 2.0);
    const double v14 = theta + h_ * (v9 / 2.0);
    const double cos_v14 = cos(v14);
    const double v15 = (cos_v7 * v12 + g * sin_v7) / v1;
    const double v16 = theta_dot + h_ * (v15 / 2.0);
    const double sin_v14 = sin(v14);
    const double v17 = (cos_v14 * g - v16 * (v1 * v16)) * (sin_v14 * M);
    const double v18 = (x + h_ * (v6 / 2.0)) * v2;
    const double v19 = (v17 - v18) / (v4 - M * (cos_v14 * cos_v14));
    const double v20 = h_ * ((x_dot + 2.0 * v6 + 2.0 * v13 + (x_dot + h_ * v19)) / 6.0);
    const double v21 = (cos_v14 * v19 + g * sin_v14) / v1;
    const double v22 = theta_dot + h_ * v21;
    const double v23 = theta + h_ * v16;
    const double cos_v23 = cos(v23);
    const double sin_v23 = sin(v23);
    const double v24 = (cos_v23 * g - v22 * (v1 * v22)) * (sin_v23 * M);
    const double v25 = (x + h_ * v13) * v2;
    const double v26 = (v24 - v25) / (v4 - M * (cos_v23 * cos_v23));
    const double v27 = v8 + 2.0 * v15 + 2.0 * v21 + (cos_v23 * v26 + g * sin_v23) / v1;
    q_next[0] = x + v20;
    q_next[1] = theta + h_ * ((theta_dot + 2.0 * v9 + 2.0 * v16 + v22) / 6.0);
    u_next[0] = x_dot + h_ * ((v5 + 2.0 * v12 + 2.0 * v19 + v26) / 6.0);
    u_next[1] = theta_dot + h_ * (v27 / 6.0);
}

void elastic_pendulum_reactions(const double q[2], const double u[2], const double p[5],
    double reactions[3])
{
    const double x = q[0];
    const double theta = q[1];
    const double theta_dot = u[1];
    const double L = p[0];
    const double M = p[1];
    const double g = p[2];
    const double k = p[3];
    const double m = p[4];
    const double cos_theta = cos(theta);
    const double v1 = -0x1.5555555555555p-1 * L;
    const double sin_theta = sin(theta);
    const double v2 = (cos_theta * g - theta_dot * (v1 * theta_dot)) * (sin_theta * M);
    const double v3 = x * (0x1.5555555555555p+1 * k);
    const double v4 = 0x1.5555555555555p+0 * (M + m) - M * (cos_theta * cos_theta);
    const double v5 = (v2 - v3) / v4;
    const double v6 = (cos_theta * v5 + g * sin_theta) / v1 * L;
    const double v7 = theta_dot * theta_dot * L;
    const double v8 = (v6 * sin_theta / 2.0 + v7 * cos_theta / 2.0) * M + M * g;
    reactions[0] = -((v5 + v6 * cos_theta / 2.0 - v7 * sin_theta / 2.0) * M);
    reactions[1] = v8;
    reactions[2] = v8 + g * m;
}

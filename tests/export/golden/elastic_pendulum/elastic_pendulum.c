/* pendulum on elastic support, derived by free_body */

#include "elastic_pendulum.h"

#include <math.h>

#if !defined(ELASTIC_PENDULUM_ALLOW_FAST_MATH) && (defined(__FAST_MATH__) || defined(_M_FP_FAST) || \
    defined(__ASSOCIATIVE_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__))
#error "fast-math takes the statuses and the inline sine away: ELASTIC_PENDULUM_ALLOW_FAST_MATH allows it"
#endif

#ifdef ELASTIC_PENDULUM_INLINE_SINE
#include "elastic_pendulum_sine.h"
#define sin mechanics_sin
#define cos mechanics_cos
#endif

int elastic_pendulum_forward_dynamics(const double q[2], const double u[2], const double p[5],
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
    const double v2 = (g * cos_theta - theta_dot * (theta_dot * v1)) * (M * sin_theta);
    const double v3 = x * (0x1.5555555555555p+1 * k);
    const double v4 = 0x1.5555555555555p+0 * (M + m) - M * (cos_theta * cos_theta);
    const double v5 = (v2 - v3) / v4;
    const double v6 = (cos_theta * v5 + g * sin_theta) / v1;
    int status = ELASTIC_PENDULUM_OK;
    if (!(isfinite(v5) && isfinite(v6) && isfinite(v4) && isfinite(v1))) {
        if (!(isfinite(x) && isfinite(theta) && isfinite(theta_dot) && isfinite(L) && isfinite(M) &&
            isfinite(g) && isfinite(k) && isfinite(m)))
            status = ELASTIC_PENDULUM_BAD_INPUT;
        else
            status = v4 == 0 || v1 == 0 ? ELASTIC_PENDULUM_SINGULAR : ELASTIC_PENDULUM_OVERFLOW;
    }
    ud[0] = v5;
    ud[1] = v6;
    return status;
}

int elastic_pendulum_mass_matrix(const double q[2], const double u[2], const double p[5],
    double mass_matrix[4])
{
    (void)u;
    const double theta = q[1];
    const double L = p[0];
    const double M = p[1];
    const double m = p[4];
    const double v1 = M + m;
    const double cos_theta = cos(theta);
    const double v2 = L * M * cos_theta / 2.0;
    const double v3 = M * (L * L) / 3.0;
    int status = ELASTIC_PENDULUM_OK;
    if (!(isfinite(v1) && isfinite(v2) && isfinite(v3))) {
        if (!(isfinite(theta) && isfinite(L) && isfinite(M) && isfinite(m)))
            status = ELASTIC_PENDULUM_BAD_INPUT;
        else
            status = ELASTIC_PENDULUM_OVERFLOW;
    }
    mass_matrix[0] = v1;
    mass_matrix[1] = v2;
    mass_matrix[2] = v2;
    mass_matrix[3] = v3;
    return status;
}

int elastic_pendulum_forcing(const double q[2], const double u[2], const double p[5],
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
    const double v1 = M * (0x1p-1 * L);
    const double v2 = sin_theta * (theta_dot * theta_dot * v1) - x * (2.0 * k);
    const double v3 = -(v1 * (g * sin_theta));
    int status = ELASTIC_PENDULUM_OK;
    if (!(isfinite(v2) && isfinite(v3))) {
        if (!(isfinite(x) && isfinite(theta) && isfinite(theta_dot) && isfinite(L) && isfinite(M) &&
            isfinite(g) && isfinite(k)))
            status = ELASTIC_PENDULUM_BAD_INPUT;
        else
            status = ELASTIC_PENDULUM_OVERFLOW;
    }
    forcing[0] = v2;
    forcing[1] = v3;
    return status;
}

int elastic_pendulum_residual(const double q[2], const double u[2], const double p[5],
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
    const double v3 = M * (L * (theta_dot * theta_dot)) * sin_theta / 2.0;
    const double v4 = x_ddot * (M + m) + theta_ddot * v2 - (v3 - k * (2.0 * x));
    const double v5 = x_ddot * v2 + theta_ddot * (M * (L * L) / 3.0);
    const double v6 = sin_theta * (g * v1) / 2.0;
    const double v7 = v5 + v6;
    int status = ELASTIC_PENDULUM_OK;
    if (!(isfinite(v4) && isfinite(v7))) {
        if (!(isfinite(x) && isfinite(theta) && isfinite(theta_dot) && isfinite(L) && isfinite(M) &&
            isfinite(g) && isfinite(k) && isfinite(m) && isfinite(x_ddot) && isfinite(theta_ddot)))
            status = ELASTIC_PENDULUM_BAD_INPUT;
        else
            status = ELASTIC_PENDULUM_OVERFLOW;
    }
    residual[0] = v4;
    residual[1] = v7;
    return status;
}

int elastic_pendulum_inverse_dynamics(const double q[2], const double u[2], const double p[5],
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
    const double v1 = 0x1p-1 * L;
    const double v2 = M * v1;
    const double sin_theta = sin(theta);
    const double v3 = cos_theta * (theta_ddot * v2);
    const double v4 = sin_theta * (v2 * (theta_dot * theta_dot));
    const double v5 = v3 - v4 + (x * (2.0 * k) + x_ddot * (M + m));
    const double v6 = M * (L * L) / 24.0;
    const double v7 = theta_ddot * (v6 + (v6 + v1 * v2));
    const double v8 = v2 * (g * sin_theta + x_ddot * cos_theta);
    const double v9 = v7 + v8;
    int status = ELASTIC_PENDULUM_OK;
    if (!(isfinite(v5) && isfinite(v9))) {
        if (!(isfinite(x) && isfinite(theta) && isfinite(theta_dot) && isfinite(L) && isfinite(M) &&
            isfinite(g) && isfinite(k) && isfinite(m) && isfinite(x_ddot) && isfinite(theta_ddot)))
            status = ELASTIC_PENDULUM_BAD_INPUT;
        else
            status = ELASTIC_PENDULUM_OVERFLOW;
    }
    forces[0] = v5;
    forces[1] = v9;
    return status;
}

int elastic_pendulum_energy(const double q[2], const double u[2], const double p[5],
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
    const double sin_theta = sin(theta);
    const double v1 = 0x1p-1 * L;
    const double v2 = theta_dot * (sin_theta * v1);
    const double cos_theta = cos(theta);
    const double v3 = v1 * cos_theta;
    const double v4 = x_dot + theta_dot * v3;
    const double v5 = theta_dot * (theta_dot * (M * (L * L) / 12.0));
    const double v6 = m * (x_dot * x_dot) + M * (v2 * v2 + v4 * v4);
    const double v7 = 0x1p-1 * (v5 + v6);
    const double v8 = k * (x * x) - M * (g * v3);
    const double v9 = v7 + v8;
    int status = ELASTIC_PENDULUM_OK;
    if (!(isfinite(v7) && isfinite(v8) && isfinite(v9))) {
        if (!(isfinite(x) && isfinite(theta) && isfinite(x_dot) && isfinite(theta_dot) &&
            isfinite(L) && isfinite(M) && isfinite(g) && isfinite(k) && isfinite(m)))
            status = ELASTIC_PENDULUM_BAD_INPUT;
        else
            status = ELASTIC_PENDULUM_OVERFLOW;
    }
    kinetic[0] = v7;
    potential[0] = v8;
    total[0] = v9;
    return status;
}

int elastic_pendulum_momenta(const double q[2], const double u[2], const double p[5],
    double linear[3], double angular[3], double generalized[2])
{
    const double x = q[0];
    const double theta = q[1];
    const double x_dot = u[0];
    const double theta_dot = u[1];
    const double L = p[0];
    const double M = p[1];
    const double m = p[4];
    const double v1 = 0x1p-1 * L;
    const double cos_theta = cos(theta);
    const double v2 = v1 * cos_theta;
    const double v3 = M * (x_dot + theta_dot * v2);
    const double v4 = x_dot * m + v3;
    const double sin_theta = sin(theta);
    const double v5 = v1 * sin_theta;
    const double v6 = M * (theta_dot * v5);
    const double v7 = M * (L * L);
    const double v8 = v6 * (x + v5) + v2 * v3 + theta_dot * (v7 / 12.0);
    const double v9 = M * v1;
    const double v10 = cos_theta * v9;
    const double v11 = x_dot * (M + m) + theta_dot * v10;
    const double v12 = v7 / 24.0;
    const double v13 = x_dot * v10 + theta_dot * (v12 + (v12 + v1 * v9));
    int status = ELASTIC_PENDULUM_OK;
    if (!(isfinite(v4) && isfinite(v6) && isfinite(v8) && isfinite(v11) && isfinite(v13))) {
        if (!(isfinite(x) && isfinite(theta) && isfinite(x_dot) && isfinite(theta_dot) &&
            isfinite(L) && isfinite(M) && isfinite(m)))
            status = ELASTIC_PENDULUM_BAD_INPUT;
        else
            status = ELASTIC_PENDULUM_OVERFLOW;
    }
    linear[0] = v4;
    linear[1] = v6;
    linear[2] = 0.0;
    angular[0] = 0.0;
    angular[1] = 0.0;
    angular[2] = v8;
    generalized[0] = v11;
    generalized[1] = v13;
    return status;
}

int elastic_pendulum_coordinate_rates(const double q[2], const double u[2], const double p[5],
    double qd[2])
{
    (void)q;
    (void)p;
    const double x_dot = u[0];
    const double theta_dot = u[1];
    int status = ELASTIC_PENDULUM_OK;
    if (!(isfinite(x_dot) && isfinite(theta_dot))) {
        if (!(isfinite(x_dot) && isfinite(theta_dot)))
            status = ELASTIC_PENDULUM_BAD_INPUT;
        else
            status = ELASTIC_PENDULUM_OVERFLOW;
    }
    qd[0] = x_dot;
    qd[1] = theta_dot;
    return status;
}

int elastic_pendulum_jacobians(const double q[2], const double u[2], const double p[5],
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
    const double v4 = M * v3 / 3.0;
    const double v5 = 1.0 / v4;
    const double v6 = v2 * v5;
    const double v7 = M + m - v2 * v6;
    const double v8 = 1.0 / v7;
    const double v9 = 2.0 * -k * v8;
    const double v10 = -(v2 * v9 * v5);
    const double v11 = theta_dot * theta_dot;
    const double v12 = L * v11;
    const double v13 = M * v12;
    const double sin_theta = sin(theta);
    const double v14 = g * v1;
    const double v15 = sin_theta * v14 / 2.0;
    const double v16 = 2.0 * x;
    const double v17 = (v13 * sin_theta / 2.0 - k * v16 + v6 * v15) * v8;
    const double v18 = (v15 + v2 * v17) * v5;
    const double v19 = 0x1p-1 * v18;
    const double v20 = 0x1p-1 * v17;
    const double v21 = sin_theta * (v1 * v20) + cos_theta * (-0x1p-1 * v14);
    const double v22 = cos_theta * (0x1p-1 * v13) - sin_theta * (v1 * v19) - v6 * v21;
    const double v23 = v22 * v8;
    const double v24 = (v21 - v2 * v23) * v5;
    const double v25 = 0x1p-1 * sin_theta;
    const double v26 = M * v25;
    const double v27 = 2.0 * theta_dot * (L * v26) * v8;
    const double v28 = -(v2 * v27 * v5);
    const double v29 = cos_theta * v19;
    const double v30 = -0x1p-1 * sin_theta;
    const double v31 = g * v30;
    const double v32 = v18 / 3.0;
    const double v33 = cos_theta * v20;
    const double v34 = M * v31 + 2.0 * L * (M * v32) - M * v33;
    const double v35 = (v11 * v26 + M * v29 - v6 * v34) * v8;
    const double v36 = (v34 - v2 * v35) * v5;
    const double v37 = L * v31 + v3 * v32 - L * v33;
    const double v38 = (v12 * v25 - (v17 - L * v29) - v6 * v37) * v8;
    const double v39 = (v37 - v2 * v38) * v5;
    const double v40 = v1 * v30;
    const double v41 = v6 * v40 * v8;
    const double v42 = -v41;
    const double v43 = (v40 + v2 * v41) * v5;
    const double v44 = v16 * v8;
    const double v45 = -v44;
    const double v46 = v2 * v44 * v5;
    const double v47 = v17 * v8;
    const double v48 = -v47;
    const double v49 = v2 * v47 * v5;
    int status = ELASTIC_PENDULUM_OK;
    if (!(isfinite(v9) && isfinite(v10) && isfinite(v23) && isfinite(v24) && isfinite(v27) &&
        isfinite(v28) && isfinite(v35) && isfinite(v36) && isfinite(v38) && isfinite(v39) &&
        isfinite(v42) && isfinite(v43) && isfinite(v45) && isfinite(v46) && isfinite(v48) &&
        isfinite(v49) && isfinite(v4) && isfinite(v7))) {
        if (!(isfinite(x) && isfinite(theta) && isfinite(theta_dot) && isfinite(L) && isfinite(M) &&
            isfinite(g) && isfinite(k) && isfinite(m)))
            status = ELASTIC_PENDULUM_BAD_INPUT;
        else
            status = v4 == 0 || v7 == 0 ? ELASTIC_PENDULUM_SINGULAR : ELASTIC_PENDULUM_OVERFLOW;
    }
    ud_q[0] = v9;
    ud_q[1] = v10;
    ud_q[2] = v23;
    ud_q[3] = v24;
    ud_u[0] = 0.0;
    ud_u[1] = 0.0;
    ud_u[2] = v27;
    ud_u[3] = v28;
    ud_p[0] = v35;
    ud_p[1] = v36;
    ud_p[2] = v38;
    ud_p[3] = v39;
    ud_p[4] = v42;
    ud_p[5] = v43;
    ud_p[6] = v45;
    ud_p[7] = v46;
    ud_p[8] = v48;
    ud_p[9] = v49;
    return status;
}

int elastic_pendulum_step(const double q[2], const double u[2], const double p[5],
    const double h[1], double q_next[2], double u_next[2])
{
    const double L = p[0];
    const double v1 = -0x1.5555555555555p-1 * L;
    const double theta = q[1];
    const double cos_theta = cos(theta);
    const double sin_theta = sin(theta);
    const double k = p[3];
    const double v2 = 0x1.5555555555555p+1 * k;
    const double M = p[1];
    const double m = p[4];
    const double x_dot = u[0];
    const double theta_dot = u[1];
    const double x = q[0];
    const double v3 = 0x1.5555555555555p+0 * (M + m);
    const double v4 = 1.0 / v1;
    const double h_ = h[0];
    const double g = p[2];
    const double v5 = theta + h_ * (theta_dot / 2.0);
    const double cos_v5 = cos(v5);
    const double sin_v5 = sin(v5);
    const double v6 = v3 - M * (cos_theta * cos_theta);
    const double v7 = (g * cos_theta - theta_dot * (theta_dot * v1)) * (M * sin_theta);
    const double v8 = (v7 - x * v2) / v6;
    const double v9 = (cos_theta * v8 + g * sin_theta) * v4;
    const double v10 = x_dot + h_ * (v8 / 2.0);
    const double v11 = theta_dot + h_ * (v9 / 2.0);
    const double v12 = theta + h_ * (v11 / 2.0);
    const double cos_v12 = cos(v12);
    const double sin_v12 = sin(v12);
    const double v13 = v3 - M * (cos_v5 * cos_v5);
    const double v14 = (g * cos_v5 - v11 * (v1 * v11)) * (M * sin_v5);
    const double v15 = v2 * (x + h_ * (x_dot / 2.0));
    const double v16 = (v14 - v15) / v13;
    const double v17 = (cos_v5 * v16 + g * sin_v5) * v4;
    const double v18 = x_dot + h_ * (v16 / 2.0);
    const double v19 = theta_dot + h_ * (v17 / 2.0);
    const double v20 = theta + h_ * v19;
    const double cos_v20 = cos(v20);
    const double sin_v20 = sin(v20);
    const double v21 = v3 - M * (cos_v12 * cos_v12);
    const double v22 = (g * cos_v12 - v19 * (v1 * v19)) * (M * sin_v12);
    const double v23 = v2 * (x + h_ * (v10 / 2.0));
    const double v24 = (v22 - v23) / v21;
    const double v25 = (cos_v12 * v24 + g * sin_v12) * v4;
    const double v26 = theta_dot + h_ * v25;
    const double v27 = (x_dot + 2.0 * v10 + 2.0 * v18 + (x_dot + h_ * v24)) / 6.0;
    const double v28 = x + h_ * v27;
    const double v29 = theta + h_ * ((theta_dot + 2.0 * v11 + 2.0 * v19 + v26) / 6.0);
    const double v30 = v3 - M * (cos_v20 * cos_v20);
    const double v31 = (g * cos_v20 - v26 * (v1 * v26)) * (M * sin_v20);
    const double v32 = v2 * (x + h_ * v18);
    const double v33 = (v31 - v32) / v30;
    const double v34 = v9 + 2.0 * v17 + 2.0 * v25 + (cos_v20 * v33 + g * sin_v20) * v4;
    const double v35 = x_dot + h_ * ((v8 + 2.0 * v16 + 2.0 * v24 + v33) / 6.0);
    const double v36 = theta_dot + h_ * (v34 / 6.0);
    int status = ELASTIC_PENDULUM_OK;
    if (!(isfinite(v28) && isfinite(v29) && isfinite(v35) && isfinite(v36) && isfinite(v1) &&
        isfinite(v6) && isfinite(v13) && isfinite(v21) && isfinite(v30))) {
        if (!(isfinite(x) && isfinite(theta) && isfinite(x_dot) && isfinite(theta_dot) &&
            isfinite(L) && isfinite(M) && isfinite(g) && isfinite(k) && isfinite(m) &&
            isfinite(h_)))
            status = ELASTIC_PENDULUM_BAD_INPUT;
        else
            status = v1 == 0 || v6 == 0 || v13 == 0 || v21 == 0 || v30 == 0 ?
                ELASTIC_PENDULUM_SINGULAR : ELASTIC_PENDULUM_OVERFLOW;
    }
    q_next[0] = v28;
    q_next[1] = v29;
    u_next[0] = v35;
    u_next[1] = v36;
    return status;
}

int elastic_pendulum_reactions(const double q[2], const double u[2], const double p[5],
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
    const double v2 = (g * cos_theta - theta_dot * (theta_dot * v1)) * (M * sin_theta);
    const double v3 = x * (0x1.5555555555555p+1 * k);
    const double v4 = 0x1.5555555555555p+0 * (M + m) - M * (cos_theta * cos_theta);
    const double v5 = (v2 - v3) / v4;
    const double v6 = (cos_theta * v5 + g * sin_theta) / v1;
    const double v7 = theta_dot * theta_dot;
    const double v8 = -(M * (v5 + L * (cos_theta * v6 - sin_theta * v7) / 2.0));
    const double v9 = M * g;
    const double v10 = M * (L * (sin_theta * v6 + cos_theta * v7)) / 2.0;
    const double v11 = v9 + v10;
    const double v12 = v10 + (v9 + g * m);
    int status = ELASTIC_PENDULUM_OK;
    if (!(isfinite(v8) && isfinite(v11) && isfinite(v12) && isfinite(v4) && isfinite(v1))) {
        if (!(isfinite(x) && isfinite(theta) && isfinite(theta_dot) && isfinite(L) && isfinite(M) &&
            isfinite(g) && isfinite(k) && isfinite(m)))
            status = ELASTIC_PENDULUM_BAD_INPUT;
        else
            status = v4 == 0 || v1 == 0 ? ELASTIC_PENDULUM_SINGULAR : ELASTIC_PENDULUM_OVERFLOW;
    }
    reactions[0] = v8;
    reactions[1] = v11;
    reactions[2] = v12;
    return status;
}

int elastic_pendulum_prepare(const double p[5], double c[6])
{
    const double L = p[0];
    const double M = p[1];
    const double g = p[2];
    const double k = p[3];
    const double m = p[4];
    const double v1 = -0x1.5555555555555p-1 * L;
    const double v2 = 0x1.5555555555555p+1 * k;
    const double v3 = 0x1.5555555555555p+0 * (M + m);
    const double v4 = 1.0 / v1;
    int status = ELASTIC_PENDULUM_OK;
    if (!(isfinite(M) && isfinite(g) && isfinite(v1) && isfinite(v4) && isfinite(v2) &&
        isfinite(v3))) {
        if (!(isfinite(L) && isfinite(M) && isfinite(g) && isfinite(k) && isfinite(m)))
            status = ELASTIC_PENDULUM_BAD_INPUT;
        else
            status = v1 == 0 ? ELASTIC_PENDULUM_SINGULAR : ELASTIC_PENDULUM_OVERFLOW;
    }
    c[0] = M;
    c[1] = g;
    c[2] = v1;
    c[3] = v4;
    c[4] = v2;
    c[5] = v3;
    return status;
}

int elastic_pendulum_forward_dynamics_prepared(const double q[2], const double u[2],
    const double c[6], double ud[2])
{
    const double x = q[0];
    const double theta = q[1];
    const double theta_dot = u[1];
    const double M = c[0];
    const double g = c[1];
    const double c2 = c[2];
    const double c3 = c[3];
    const double c4 = c[4];
    const double c5 = c[5];
    const double cos_theta = cos(theta);
    const double sin_theta = sin(theta);
    const double v1 = (g * cos_theta - theta_dot * (theta_dot * c2)) * (M * sin_theta);
    const double v2 = c5 - M * (cos_theta * cos_theta);
    const double v3 = (v1 - x * c4) / v2;
    const double v4 = (cos_theta * v3 + g * sin_theta) * c3;
    int status = ELASTIC_PENDULUM_OK;
    if (!(isfinite(v3) && isfinite(v4) && isfinite(v2))) {
        if (!(isfinite(x) && isfinite(theta) && isfinite(theta_dot) && isfinite(M) && isfinite(g) &&
            isfinite(c2) && isfinite(c3) && isfinite(c4) && isfinite(c5)))
            status = ELASTIC_PENDULUM_BAD_INPUT;
        else
            status = v2 == 0 ? ELASTIC_PENDULUM_SINGULAR : ELASTIC_PENDULUM_OVERFLOW;
    }
    ud[0] = v3;
    ud[1] = v4;
    return status;
}

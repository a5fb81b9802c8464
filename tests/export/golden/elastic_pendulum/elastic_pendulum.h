/*
 * Equations of motion: pendulum on elastic support, derived by free_body.
 *
 * C99, no allocation, no global state: every function may be called from any thread. SI units.
 * Matrices are stored column by column. All inputs are read before the first output is written,
 * so an output may be the same array as an input of its size.
 *
 * Every function returns a status, and writes its outputs whatever it is. Nothing traps. The C
 * files refuse -ffast-math, which takes the check for infinity away; what is shown of them does not
 * hold with it. ELASTIC_PENDULUM_ALLOW_FAST_MATH compiles them all the same.
 *
 * Of the C library they call cos, sin. With the macro ELASTIC_PENDULUM_INLINE_SINE
 * defined, cos and sin are those of elastic_pendulum_sine.h instead: up to 1048576 rad, with
 * status 2 beyond, and an error of less than 2 units in the last place.
 * Quotients by one divisor share a division, 40 instead of 60, and are
 * products with the reciprocal: off by at most 1.5 units in the last place, not 0.5.
 */
#ifndef MECHANICS_elastic_pendulum_H
#define MECHANICS_elastic_pendulum_H

/* status
 *   0  every output is a number
 *   1  a divisor is zero: the mass matrix is singular, or too small to tell
 *   2  a value is beyond the largest number
 *   3  an input is infinite or no number
 */
#define ELASTIC_PENDULUM_OK 0
#define ELASTIC_PENDULUM_SINGULAR 1
#define ELASTIC_PENDULUM_OVERFLOW 2
#define ELASTIC_PENDULUM_BAD_INPUT 3

/* generalized coordinates q
 *   q[0]  x      m
 *   q[1]  theta  rad
 */
#define ELASTIC_PENDULUM_Q_SIZE 2

/* generalized speeds u
 *   u[0]  x_dot      m/s
 *   u[1]  theta_dot  rad/s
 */
#define ELASTIC_PENDULUM_U_SIZE 2

/* rates of the speeds, u'
 *   ud[0]  x_ddot      m/s^2
 *   ud[1]  theta_ddot  rad/s^2
 */
#define ELASTIC_PENDULUM_UD_SIZE 2

#define ELASTIC_PENDULUM_INPUTS_SIZE 0

/* parameters
 *   p[0]  L  m      length of the pendulum, typically 1
 *   p[1]  M  kg     mass of the pendulum, typically 1
 *   p[2]  g  m/s^2  acceleration of gravity, typically 9.81
 *   p[3]  k  N/m    stiffness of each of the two springs, typically 10
 *   p[4]  m  kg     mass of the carriage, typically 1
 */
#define ELASTIC_PENDULUM_P_SIZE 5

/* constants: what prepare makes of the parameters
 *   c[0]  M   kg     mass of the pendulum
 *   c[1]  g   m/s^2  acceleration of gravity
 *   c[2]  c2  -      made of parameters
 *   c[3]  c3  -      made of parameters
 *   c[4]  c4  -      made of parameters
 *   c[5]  c5  -      made of parameters
 */
#define ELASTIC_PENDULUM_C_SIZE 6

#define ELASTIC_PENDULUM_MULTIPLIERS_SIZE 0

/* reactions
 *   reactions[0]  T   N
 *   reactions[1]  N   N
 *   reactions[2]  N1  N
 */
#define ELASTIC_PENDULUM_REACTIONS_SIZE 3

/* time
 *   h[0]  h  s  length of the step
 */
#define ELASTIC_PENDULUM_H_SIZE 1

#ifdef __cplusplus
extern "C" {
#endif

/* Accelerations u' (and multipliers) from the state. */
int elastic_pendulum_forward_dynamics(const double q[2], const double u[2], const double p[5],
    double ud[2]);

/* M of the equations M u' = f + B lambda.
 *   mass_matrix[i + 2 * j]: row i, column j */
int elastic_pendulum_mass_matrix(const double q[2], const double u[2], const double p[5],
    double mass_matrix[4]);

/* Right side f of the equations M u' = f + B lambda.
 *   forcing[i]: row i of the equations */
int elastic_pendulum_forcing(const double q[2], const double u[2], const double p[5],
    double forcing[2]);

/* M u' - f - B lambda, and below it A u' - b of the constraints.
 *   residual[i]: row i of the equations */
int elastic_pendulum_residual(const double q[2], const double u[2], const double p[5],
    const double ud[2], double residual[2]);

/* Generalized forces, conjugate to u, which added to the loads give u'.
 *   forces[i]: forces[i] * u[i] is a power in W */
int elastic_pendulum_inverse_dynamics(const double q[2], const double u[2], const double p[5],
    const double ud[2], double forces[2]);

/* Kinetic, potential and total energy.
 *   kinetic[0]: in J
 *   potential[0]: in J
 *   total[0]: in J */
int elastic_pendulum_energy(const double q[2], const double u[2], const double p[5],
    double kinetic[1], double potential[1], double total[1]);

/* Momentum, angular momentum about the origin, and generalized momenta dT/du.
 *   linear[i]: component i in the inertial frame, in kg m/s
 *   angular[i]: component i in the inertial frame, in kg m^2/s
 *   generalized[i]: generalized[i] * u[i] is an energy in J */
int elastic_pendulum_momenta(const double q[2], const double u[2], const double p[5],
    double linear[3], double angular[3], double generalized[2]);

/* Rates of the coordinates: q' = N u + n.
 *   qd[i]: rate of q[i], in the unit of q[i] per s */
int elastic_pendulum_coordinate_rates(const double q[2], const double u[2], const double p[5],
    double qd[2]);

/* Derivatives of u' by q, u, inputs and p.
 *   ud_q[i + 2 * j]: derivative of ud[i] by q[j]
 *   ud_u[i + 2 * j]: derivative of ud[i] by u[j]
 *   ud_p[i + 2 * j]: derivative of ud[i] by p[j] */
int elastic_pendulum_jacobians(const double q[2], const double u[2], const double p[5],
    double ud_q[4], double ud_u[4], double ud_p[10]);

/* State at t + h by the classical Runge-Kutta method of order 4, inputs held over the
 * step: in place with q_next = q and u_next = u. */
int elastic_pendulum_step(const double q[2], const double u[2], const double p[5],
    const double h[1], double q_next[2], double u_next[2]);

/* The reactions listed above, from the state. */
int elastic_pendulum_reactions(const double q[2], const double u[2], const double p[5],
    double reactions[3]);

/* What the forward dynamics use of the parameters only: once for many states. */
int elastic_pendulum_prepare(const double p[5], double c[6]);

/* The same accelerations with what the function above makes of p: fewer operations.
 * Quotients by a parameter are products with its reciprocal: off by at most 1.5 units in
 * the last place each, instead of 0.5. */
int elastic_pendulum_forward_dynamics_prepared(const double q[2], const double u[2],
    const double c[6], double ud[2]);

#ifdef __cplusplus
}
#endif

#endif /* MECHANICS_elastic_pendulum_H */

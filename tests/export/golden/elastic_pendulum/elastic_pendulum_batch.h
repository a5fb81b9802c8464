/*
 * Functions of many states at once: pendulum on elastic support.
 *
 * Structure of arrays: entry k of state i is array[k * stride + i], with stride >= count. All
 * states share p. elastic_pendulum.h has the order and unit of every entry. Arrays need not be
 * aligned; an output must not overlap an input.
 *
 * Every function returns 0, or a sum of
 *   1  in some state an angle is beyond 1048576 rad, or no number: such states, and only
 *      they, are given to the scalar function, which has sine and cosine of the C library
 *   2  in some state a value is not finite: the status of the scalar function says why
 */
#ifndef MECHANICS_elastic_pendulum_H_BATCH
#define MECHANICS_elastic_pendulum_H_BATCH

#include "elastic_pendulum.h"

#include <stddef.h>

#define ELASTIC_PENDULUM_BATCH_FAR 1
#define ELASTIC_PENDULUM_BATCH_NOT_FINITE 2

#ifdef __cplusplus
extern "C" {
#endif

/* Accelerations u' (and multipliers) from the state. */
int elastic_pendulum_forward_dynamics_batch(size_t count, size_t stride, const double *q,
    const double *u, const double *p, double *ud);

/* Kinetic, potential and total energy.
 *   kinetic[0]: in J
 *   potential[0]: in J
 *   total[0]: in J */
int elastic_pendulum_energy_batch(size_t count, size_t stride, const double *q, const double *u,
    const double *p, double *kinetic, double *potential, double *total);

/* Rates of the coordinates: q' = N u + n.
 *   qd[i]: rate of q[i], in the unit of q[i] per s */
int elastic_pendulum_coordinate_rates_batch(size_t count, size_t stride, const double *q,
    const double *u, const double *p, double *qd);

#ifdef __cplusplus
}
#endif

#endif /* MECHANICS_elastic_pendulum_H_BATCH */

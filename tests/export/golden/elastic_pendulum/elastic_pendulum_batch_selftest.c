/*
 * Self-test of the functions of many states: pendulum on elastic support.
 *
 * State i has test vector i modulo their number; expected values and tolerances as in
 * elastic_pendulum_selftest.c. Prints what fails; exit code 0 or 1.
 */
#include "elastic_pendulum_batch.h"

#include <math.h>
#include <stdio.h>

enum { COUNT = 261, STRIDE = 263, MARK = 77 };

/* Entry k of state i from a table with one row a vector; without it, marks to be written over. */
static void spread(int size, int vectors, const double *table, double *array)
{
    for (int k = 0; k < size; ++k)
        for (int i = 0; i < STRIDE; ++i)
            array[k * STRIDE + i] = table ? table[i % vectors * size + k] : MARK;
}

static int check(const char *what, int size, int vectors, const double *got, const double *expected,
    const double *tolerance)
{
    int failures = 0;
    for (int k = 0; k < size; ++k) {
        for (int i = 0; i < STRIDE; ++i) {
            const double found = got[k * STRIDE + i];
            const int at = i % vectors * size + k;
            const double wanted = i < COUNT ? expected[at] : MARK;
            if (!(fabs(found - wanted) <= (i < COUNT ? tolerance[at] : 0))) {
                printf("%s, state %d, entry %d: %.17g found, %.17g expected\n", what, i, k,
                    (double)found, (double)wanted);
                ++failures;
            }
        }
    }
    return failures;
}

static int test_forward_dynamics(void)
{
    static const double q_in[5][2] = {
        {0x1.2fd40ep-3, 0x1.921fb4p+0},
        {-0x1.30bbeap-2, 0x1.1a896p-42},
        {-0x1.0049d2p+2, 0x1.921fb6p+0},
        {0x1.75bc38p+0, 0x1.10b18ap+1},
        {-0x1.3bed68p-3, 0x1.921fb6p+2},
    };
    static const double u_in[5][2] = {
        {-0x1.5c2216p-1, -0x1.3858aep-2},
        {0x1.3e05a6p-2, 0x1.f36a72p+0},
        {0x1.1d3fep-2, -0x1.0b9f4ap-3},
        {0x1.007a28p+1, -0x1.14058cp-3},
        {0x1.fe8c4cp-4, -0x1.0843bp-3},
    };
    static const double p_in[1][5] = {
        {0x1.7790bap+1, 0x1.691be4p+2, 0x1.145202p-2, 0x1.e71dfp+2, 0x1.bf465ep-2},
    };
    static const double ud_expected[5][2] = {
        {-0x1.f557d7a2b93p-3, -0x1.1a86ad7909cbbp-3},
        {0x1.39e082a224343p+1, -0x1.40ed1cf21c168p+0},
        {0x1.419f88f926155p+3, -0x1.1a869098851b1p-3},
        {-0x1.281f3cfcf4878p+2, -0x1.5f6440a6f643p+0},
        {0x1.4567fbe41329ep+0, -0x1.4cb6e03342feap-1},
    };
    static const double ud_tolerance[5][2] = {
        {0x1p-49, 0x1p-50},
        {0x1p-46, 0x1p-46},
        {0x1p-44, 0x1p-50},
        {0x1p-45, 0x1p-46},
        {0x1p-46, 0x1p-46},
    };
    static double q[2 * STRIDE + 1];
    static double u[2 * STRIDE + 1];
    static double ud[2 * STRIDE + 1];
    spread(2, 5, q_in[0], q + 1);
    spread(2, 5, u_in[0], u + 1);
    spread(2, 5, NULL, ud + 1);
    int failures = elastic_pendulum_forward_dynamics_batch(COUNT, STRIDE, q + 1, u + 1, p_in[0], ud
        + 1) != 0;
    failures += check("forward_dynamics_batch ud", 2, 5, ud + 1, ud_expected[0], ud_tolerance[0]);
    return failures;
}

static int test_energy(void)
{
    static const double q_in[5][2] = {
        {0x1.2fd40ep-3, 0x1.921fb4p+0},
        {-0x1.30bbeap-2, 0x1.1a896p-42},
        {-0x1.0049d2p+2, 0x1.921fb6p+0},
        {0x1.75bc38p+0, 0x1.10b18ap+1},
        {-0x1.3bed68p-3, 0x1.921fb6p+2},
    };
    static const double u_in[5][2] = {
        {-0x1.5c2216p-1, -0x1.3858aep-2},
        {0x1.3e05a6p-2, 0x1.f36a72p+0},
        {0x1.1d3fep-2, -0x1.0b9f4ap-3},
        {0x1.007a28p+1, -0x1.14058cp-3},
        {0x1.fe8c4cp-4, -0x1.0843bp-3},
    };
    static const double p_in[1][5] = {
        {0x1.7790bap+1, 0x1.691be4p+2, 0x1.145202p-2, 0x1.e71dfp+2, 0x1.bf465ep-2},
    };
    static const double kinetic_expected[5][1] = {
        {0x1.144a1e6d115aep+1},
        {0x1.20f3eabe47477p+5},
        {0x1.7f15b3c26f979p-2},
        {0x1.b1320ef5fbeb4p+3},
        {0x1.90788d16762c9p-5},
    };
    static const double kinetic_tolerance[5][1] = {
        {0x1p-46},
        {0x1p-43},
        {0x1p-49},
        {0x1p-44},
        {0x1p-51},
    };
    static const double potential_expected[5][1] = {
        {0x1.571140091d27bp-3},
        {-0x1.8f4228fe9d284p+0},
        {0x1.e83706c7bcf8fp+6},
        {0x1.1685c74cc95adp+4},
        {-0x1.06b98d475aae5p+1},
    };
    static const double potential_tolerance[5][1] = {
        {0x1p-51},
        {0x1p-48},
        {0x1p-42},
        {0x1p-44},
        {0x1p-46},
    };
    static const double total_expected[5][1] = {
        {0x1.29bb326da32d5p+1},
        {0x1.1479d976525e3p+5},
        {0x1.e9b61c7b7f688p+6},
        {0x1.ef1ecec7c7506p+4},
        {-0x1.0077ab1300d5ap+1},
    };
    static const double total_tolerance[5][1] = {
        {0x1p-46},
        {0x1p-43},
        {0x1p-42},
        {0x1p-43},
        {0x1p-46},
    };
    static double q[2 * STRIDE + 1];
    static double u[2 * STRIDE + 1];
    static double kinetic[1 * STRIDE + 1];
    static double potential[1 * STRIDE + 1];
    static double total[1 * STRIDE + 1];
    spread(2, 5, q_in[0], q + 1);
    spread(2, 5, u_in[0], u + 1);
    spread(1, 5, NULL, kinetic + 1);
    spread(1, 5, NULL, potential + 1);
    spread(1, 5, NULL, total + 1);
    int failures = elastic_pendulum_energy_batch(COUNT, STRIDE, q + 1, u + 1, p_in[0], kinetic + 1,
        potential + 1, total + 1) != 0;
    failures += check("energy_batch kinetic", 1, 5, kinetic + 1, kinetic_expected[0],
        kinetic_tolerance[0]);
    failures += check("energy_batch potential", 1, 5, potential + 1, potential_expected[0],
        potential_tolerance[0]);
    failures += check("energy_batch total", 1, 5, total + 1, total_expected[0], total_tolerance[0]);
    return failures;
}

static int test_coordinate_rates(void)
{
    static const double q_in[5][2] = {
        {0x1.2fd40ep-3, 0x1.921fb4p+0},
        {-0x1.30bbeap-2, 0x1.1a896p-42},
        {-0x1.0049d2p+2, 0x1.921fb6p+0},
        {0x1.75bc38p+0, 0x1.10b18ap+1},
        {-0x1.3bed68p-3, 0x1.921fb6p+2},
    };
    static const double u_in[5][2] = {
        {-0x1.5c2216p-1, -0x1.3858aep-2},
        {0x1.3e05a6p-2, 0x1.f36a72p+0},
        {0x1.1d3fep-2, -0x1.0b9f4ap-3},
        {0x1.007a28p+1, -0x1.14058cp-3},
        {0x1.fe8c4cp-4, -0x1.0843bp-3},
    };
    static const double p_in[1][5] = {
        {0x1.7790bap+1, 0x1.691be4p+2, 0x1.145202p-2, 0x1.e71dfp+2, 0x1.bf465ep-2},
    };
    static const double qd_expected[5][2] = {
        {-0x1.5c2216p-1, -0x1.3858aep-2},
        {0x1.3e05a6p-2, 0x1.f36a72p+0},
        {0x1.1d3fep-2, -0x1.0b9f4ap-3},
        {0x1.007a28p+1, -0x1.14058cp-3},
        {0x1.fe8c4cp-4, -0x1.0843bp-3},
    };
    static const double qd_tolerance[5][2] = {
        {0.0, 0.0},
        {0.0, 0.0},
        {0.0, 0.0},
        {0.0, 0.0},
        {0.0, 0.0},
    };
    static double q[2 * STRIDE + 1];
    static double u[2 * STRIDE + 1];
    static double qd[2 * STRIDE + 1];
    spread(2, 5, q_in[0], q + 1);
    spread(2, 5, u_in[0], u + 1);
    spread(2, 5, NULL, qd + 1);
    int failures = elastic_pendulum_coordinate_rates_batch(COUNT, STRIDE, q + 1, u + 1, p_in[0], qd
        + 1) != 0;
    failures += check("coordinate_rates_batch qd", 2, 5, qd + 1, qd_expected[0], qd_tolerance[0]);
    return failures;
}

int main(void)
{
    int failures = 0;
    failures += test_forward_dynamics();
    failures += test_energy();
    failures += test_coordinate_rates();
    printf("elastic_pendulum_batch: %d failures\n", failures);
    return failures > 0;
}

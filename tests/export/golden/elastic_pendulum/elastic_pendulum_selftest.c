/*
 * Self-test: pendulum on elastic support.
 *
 * Expected values are enclosed with 512 binary digits and rounded to the nearest double. The
 * tolerance is 4 times what the roundings of the operations can add up to in this precision,
 * rounded up to a power of two. Prints what fails; exit code 0 or 1.
 */
#include "elastic_pendulum.h"

#include <math.h>
#include <stdio.h>

static int check(const char *what, int state, int size, const double *got, const double *expected,
    const double *tolerance)
{
    int failures = 0;
    for (int i = 0; i < size; ++i) {
        if (!(fabs(got[i] - expected[i]) <= tolerance[i])) {
            printf("%s, state %d, entry %d: %.17g found, %.17g expected\n", what, state, i,
                (double)got[i], (double)expected[i]);
            ++failures;
        }
    }
    return failures;
}

static int check_status(const char *what, int state, int status)
{
    if (status != ELASTIC_PENDULUM_OK)
        printf("%s, state %d: status %d found, ELASTIC_PENDULUM_OK expected\n", what, state, status);
    return status != ELASTIC_PENDULUM_OK;
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
    static const double p_in[5][5] = {
        {0x1.7790bap+1, 0x1.691be4p+2, 0x1.145202p-2, 0x1.e71dfp+2, 0x1.bf465ep-2},
        {0x1.de6706p+2, 0x1.29f70cp+2, 0x1.7a15ecp-2, 0x1.fccddcp+0, 0x1.6aa744p+2},
        {0x1.244b22p+3, 0x1.4b4ddcp+1, 0x1.879996p+0, 0x1.0f999cp+3, 0x1.b65c5ep+1},
        {0x1.184f4ap-3, 0x1.9e7162p+0, 0x1.e22d02p-1, 0x1.cdaf4cp-1, 0x1.aa5f9cp-2},
        {0x1.45e6c4p-1, 0x1.0b6adap-3, 0x1.5e3fbp+0, 0x1.1daafap+0, 0x1.1615f4p+1},
    };
    static const double ud_expected[5][2] = {
        {-0x1.f557d7a2b93p-3, -0x1.1a86ad7909cbbp-3},
        {0x1.62b01e32deb58p-3, -0x1.1cb2aab4b88aap-5},
        {0x1.6ad4ce3df49c3p+3, -0x1.013b53eafc194p-2},
        {-0x1.db9d60d77943p+0, -0x1.38e3304195464p+4},
        {0x1.3fbcaf42b8e06p-3, -0x1.78bcbddd708afp-2},
    };
    static const double ud_tolerance[5][2] = {
        {0x1p-49, 0x1p-50},
        {0x1p-50, 0x1p-52},
        {0x1p-44, 0x1p-50},
        {0x1p-46, 0x1p-42},
        {0x1p-50, 0x1p-48},
    };
    int failures = 0, status;
    for (int i = 0; i < 5; ++i) {
        double ud[2];
        status = elastic_pendulum_forward_dynamics(q_in[i], u_in[i], p_in[i], ud);
        failures += check_status("forward_dynamics", i, status);
        failures += check("forward_dynamics", i, 2, ud, ud_expected[i], ud_tolerance[i]);
        double c[6];
        status = elastic_pendulum_prepare(p_in[i], c);
        failures += check_status("prepare", i, status);
        status = elastic_pendulum_forward_dynamics_prepared(q_in[i], u_in[i], c, ud);
        failures += check_status("forward_dynamics_prepared", i, status);
        failures += check("forward_dynamics_prepared", i, 2, ud, ud_expected[i], ud_tolerance[i]);
    }
    return failures;
}

static int test_mass_matrix(void)
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
    static const double p_in[5][5] = {
        {0x1.7790bap+1, 0x1.691be4p+2, 0x1.145202p-2, 0x1.e71dfp+2, 0x1.bf465ep-2},
        {0x1.de6706p+2, 0x1.29f70cp+2, 0x1.7a15ecp-2, 0x1.fccddcp+0, 0x1.6aa744p+2},
        {0x1.244b22p+3, 0x1.4b4ddcp+1, 0x1.879996p+0, 0x1.0f999cp+3, 0x1.b65c5ep+1},
        {0x1.184f4ap-3, 0x1.9e7162p+0, 0x1.e22d02p-1, 0x1.cdaf4cp-1, 0x1.aa5f9cp-2},
        {0x1.45e6c4p-1, 0x1.0b6adap-3, 0x1.5e3fbp+0, 0x1.1daafap+0, 0x1.1615f4p+1},
    };
    static const double mass_matrix_expected[5][4] = {
        {0x1.851049ep+2, 0x1.4f832bb64dd3p-21, 0x1.4f832bb64dd3p-21, 0x1.0310898fcc824p+4},
        {0x1.4a4f28p+3, 0x1.166998e4cf24p+4, 0x1.166998e4cf24p+4, 0x1.5adb79a97af15p+6},
        {0x1.80d51dp+2, -0x1.1568b43f3cf49p-21, -0x1.1568b43f3cf49p-21, 0x1.1fef46037a469p+6},
        {0x1.0484a48p+1, -0x1.e1cfda204715ap-5, -0x1.e1cfda204715ap-5, 0x1.4b42b97ac46bap-7},
        {0x1.26cca1ap+1, 0x1.546fb57faae24p-5, 0x1.546fb57faae24p-5, 0x1.20edcc491d169p-6},
    };
    static const double mass_matrix_tolerance[5][4] = {
        {0.0, 0x1p-55, 0x1p-55, 0x1p-46},
        {0.0, 0x1p-78, 0x1p-78, 0x1p-43},
        {0.0, 0x1p-54, 0x1p-54, 0x1p-43},
        {0.0, 0x1p-53, 0x1p-53, 0x1p-57},
        {0.0, 0x1p-54, 0x1p-54, 0x1p-55},
    };
    int failures = 0, status;
    for (int i = 0; i < 5; ++i) {
        double mass_matrix[4];
        status = elastic_pendulum_mass_matrix(q_in[i], u_in[i], p_in[i], mass_matrix);
        failures += check_status("mass_matrix", i, status);
        failures += check("mass_matrix", i, 4, mass_matrix, mass_matrix_expected[i],
            mass_matrix_tolerance[i]);
    }
    return failures;
}

static int test_forcing(void)
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
    static const double p_in[5][5] = {
        {0x1.7790bap+1, 0x1.691be4p+2, 0x1.145202p-2, 0x1.e71dfp+2, 0x1.bf465ep-2},
        {0x1.de6706p+2, 0x1.29f70cp+2, 0x1.7a15ecp-2, 0x1.fccddcp+0, 0x1.6aa744p+2},
        {0x1.244b22p+3, 0x1.4b4ddcp+1, 0x1.879996p+0, 0x1.0f999cp+3, 0x1.b65c5ep+1},
        {0x1.184f4ap-3, 0x1.9e7162p+0, 0x1.e22d02p-1, 0x1.cdaf4cp-1, 0x1.aa5f9cp-2},
        {0x1.45e6c4p-1, 0x1.0b6adap-3, 0x1.5e3fbp+0, 0x1.1daafap+0, 0x1.1615f4p+1},
    };
    static const double forcing_expected[5][2] = {
        {-0x1.7cf731dc8275fp+0, -0x1.1de8830599a7dp+1},
        {0x1.2ed4f85a01d1ap+0, -0x1.c5cf43a628154p-40},
        {0x1.10b6a0cc07dd2p+6, -0x1.2151f5f633276p+4},
        {-0x1.50ca0b215cc51p+1, -0x1.6a2c2b17db9d2p-4},
        {0x1.608a4cf6fba4cp-2, -0x1.559368fbac3f5p-27},
    };
    static const double forcing_tolerance[5][2] = {
        {0x1p-49, 0x1p-47},
        {0x1p-49, 0x1p-89},
        {0x1p-43, 0x1p-44},
        {0x1p-48, 0x1p-52},
        {0x1p-51, 0x1p-62},
    };
    int failures = 0, status;
    for (int i = 0; i < 5; ++i) {
        double forcing[2];
        status = elastic_pendulum_forcing(q_in[i], u_in[i], p_in[i], forcing);
        failures += check_status("forcing", i, status);
        failures += check("forcing", i, 2, forcing, forcing_expected[i], forcing_tolerance[i]);
    }
    return failures;
}

static int test_residual(void)
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
    static const double p_in[5][5] = {
        {0x1.7790bap+1, 0x1.691be4p+2, 0x1.145202p-2, 0x1.e71dfp+2, 0x1.bf465ep-2},
        {0x1.de6706p+2, 0x1.29f70cp+2, 0x1.7a15ecp-2, 0x1.fccddcp+0, 0x1.6aa744p+2},
        {0x1.244b22p+3, 0x1.4b4ddcp+1, 0x1.879996p+0, 0x1.0f999cp+3, 0x1.b65c5ep+1},
        {0x1.184f4ap-3, 0x1.9e7162p+0, 0x1.e22d02p-1, 0x1.cdaf4cp-1, 0x1.aa5f9cp-2},
        {0x1.45e6c4p-1, 0x1.0b6adap-3, 0x1.5e3fbp+0, 0x1.1daafap+0, 0x1.1615f4p+1},
    };
    static const double ud_in[5][2] = {
        {-0x1.092f3ep+3, -0x1.50e1eep+2},
        {0x1.81a19ep+2, 0x1.a4ab6cp+0},
        {-0x1.03c1f6p+3, -0x1.5663dcp+0},
        {-0x1.ad0788p-2, -0x1.b388cp+2},
        {0x1.2c423ep+2, -0x1.ee7ff4p+2},
    };
    static const double residual_expected[5][2] = {
        {-0x1.871df0db02342p+5, -0x1.4bfb14326396cp+6},
        {0x1.666d60ba5d9c3p+6, 0x1.eeae74dbac862p+7},
        {-0x1.d3f43804fa895p+6, -0x1.38c579eb50f6ep+6},
        {0x1.16dee7abc8e48p+1, 0x1.6aa2e06ae59b8p-5},
        {0x1.44795c467b0b5p+3, 0x1.e0f571fbf7eb4p-5},
    };
    static const double residual_tolerance[5][2] = {
        {0x1p-44, 0x1p-42},
        {0x1p-42, 0x1p-41},
        {0x1p-42, 0x1p-41},
        {0x1p-47, 0x1p-51},
        {0x1p-46, 0x1p-50},
    };
    int failures = 0, status;
    for (int i = 0; i < 5; ++i) {
        double residual[2];
        status = elastic_pendulum_residual(q_in[i], u_in[i], p_in[i], ud_in[i], residual);
        failures += check_status("residual", i, status);
        failures += check("residual", i, 2, residual, residual_expected[i], residual_tolerance[i]);
    }
    return failures;
}

static int test_inverse_dynamics(void)
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
    static const double p_in[5][5] = {
        {0x1.7790bap+1, 0x1.691be4p+2, 0x1.145202p-2, 0x1.e71dfp+2, 0x1.bf465ep-2},
        {0x1.de6706p+2, 0x1.29f70cp+2, 0x1.7a15ecp-2, 0x1.fccddcp+0, 0x1.6aa744p+2},
        {0x1.244b22p+3, 0x1.4b4ddcp+1, 0x1.879996p+0, 0x1.0f999cp+3, 0x1.b65c5ep+1},
        {0x1.184f4ap-3, 0x1.9e7162p+0, 0x1.e22d02p-1, 0x1.cdaf4cp-1, 0x1.aa5f9cp-2},
        {0x1.45e6c4p-1, 0x1.0b6adap-3, 0x1.5e3fbp+0, 0x1.1daafap+0, 0x1.1615f4p+1},
    };
    static const double ud_in[5][2] = {
        {-0x1.092f3ep+3, -0x1.50e1eep+2},
        {0x1.81a19ep+2, 0x1.a4ab6cp+0},
        {-0x1.03c1f6p+3, -0x1.5663dcp+0},
        {-0x1.ad0788p-2, -0x1.b388cp+2},
        {0x1.2c423ep+2, -0x1.ee7ff4p+2},
    };
    static const double forces_expected[5][2] = {
        {-0x1.871df0db02342p+5, -0x1.4bfb14326396cp+6},
        {0x1.666d60ba5d9c3p+6, 0x1.eeae74dbac862p+7},
        {-0x1.d3f43804fa895p+6, -0x1.38c579eb50f6ep+6},
        {0x1.16dee7abc8e48p+1, 0x1.6aa2e06ae59b8p-5},
        {0x1.44795c467b0b5p+3, 0x1.e0f571fbf7eb4p-5},
    };
    static const double forces_tolerance[5][2] = {
        {0x1p-44, 0x1p-42},
        {0x1p-43, 0x1p-40},
        {0x1p-43, 0x1p-41},
        {0x1p-48, 0x1p-50},
        {0x1p-46, 0x1p-50},
    };
    int failures = 0, status;
    for (int i = 0; i < 5; ++i) {
        double forces[2];
        status = elastic_pendulum_inverse_dynamics(q_in[i], u_in[i], p_in[i], ud_in[i], forces);
        failures += check_status("inverse_dynamics", i, status);
        failures += check("inverse_dynamics", i, 2, forces, forces_expected[i],
            forces_tolerance[i]);
    }
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
    static const double p_in[5][5] = {
        {0x1.7790bap+1, 0x1.691be4p+2, 0x1.145202p-2, 0x1.e71dfp+2, 0x1.bf465ep-2},
        {0x1.de6706p+2, 0x1.29f70cp+2, 0x1.7a15ecp-2, 0x1.fccddcp+0, 0x1.6aa744p+2},
        {0x1.244b22p+3, 0x1.4b4ddcp+1, 0x1.879996p+0, 0x1.0f999cp+3, 0x1.b65c5ep+1},
        {0x1.184f4ap-3, 0x1.9e7162p+0, 0x1.e22d02p-1, 0x1.cdaf4cp-1, 0x1.aa5f9cp-2},
        {0x1.45e6c4p-1, 0x1.0b6adap-3, 0x1.5e3fbp+0, 0x1.1daafap+0, 0x1.1615f4p+1},
    };
    static const double kinetic_expected[5][1] = {
        {0x1.144a1e6d115aep+1},
        {0x1.6018e36497d9ap+7},
        {0x1.b21ef6b7a5d28p-1},
        {0x1.06833bf790ee5p+2},
        {0x1.1c95879107dbep-6},
    };
    static const double kinetic_tolerance[5][1] = {
        {0x1p-46},
        {0x1p-40},
        {0x1p-47},
        {0x1p-45},
        {0x1p-54},
    };
    static const double potential_expected[5][1] = {
        {0x1.571140091d27bp-3},
        {-0x1.8febe98a6689cp+2},
        {0x1.103655e3053a7p+7},
        {0x1.fa2d8ebc8cf14p+0},
        {-0x1.f079bb6b3ebc5p-6},
    };
    static const double potential_tolerance[5][1] = {
        {0x1p-51},
        {0x1p-46},
        {0x1p-41},
        {0x1p-48},
        {0x1p-52},
    };
    static const double total_expected[5][1] = {
        {0x1.29bb326da32d5p+1},
        {0x1.5399841844a55p+7},
        {0x1.11e874d9bce04p+7},
        {0x1.850e9fa6b42aap+2},
        {-0x1.a7c867b46dc0fp-7},
    };
    static const double total_tolerance[5][1] = {
        {0x1p-46},
        {0x1p-40},
        {0x1p-41},
        {0x1p-45},
        {0x1p-52},
    };
    int failures = 0, status;
    for (int i = 0; i < 5; ++i) {
        double kinetic[1];
        double potential[1];
        double total[1];
        status = elastic_pendulum_energy(q_in[i], u_in[i], p_in[i], kinetic, potential, total);
        failures += check_status("energy", i, status);
        failures += check("energy kinetic", i, 1, kinetic, kinetic_expected[i],
            kinetic_tolerance[i]);
        failures += check("energy potential", i, 1, potential, potential_expected[i],
            potential_tolerance[i]);
        failures += check("energy total", i, 1, total, total_expected[i], total_tolerance[i]);
    }
    return failures;
}

static int test_momenta(void)
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
    static const double p_in[5][5] = {
        {0x1.7790bap+1, 0x1.691be4p+2, 0x1.145202p-2, 0x1.e71dfp+2, 0x1.bf465ep-2},
        {0x1.de6706p+2, 0x1.29f70cp+2, 0x1.7a15ecp-2, 0x1.fccddcp+0, 0x1.6aa744p+2},
        {0x1.244b22p+3, 0x1.4b4ddcp+1, 0x1.879996p+0, 0x1.0f999cp+3, 0x1.b65c5ep+1},
        {0x1.184f4ap-3, 0x1.9e7162p+0, 0x1.e22d02p-1, 0x1.cdaf4cp-1, 0x1.aa5f9cp-2},
        {0x1.45e6c4p-1, 0x1.0b6adap-3, 0x1.5e3fbp+0, 0x1.1daafap+0, 0x1.1615f4p+1},
    };
    static const double linear_expected[5][3] = {
        {-0x1.088af9cf8917dp+2, -0x1.432f325c32629p+1, 0.0},
        {0x1.29372633dc0a7p+5, 0x1.2bb855fbab15ap-37, 0.0},
        {0x1.accd47979d303p+0, -0x1.8b726c0ef52dap+0, 0.0},
        {0x1.0582d40d0ca2ap+2, -0x1.9ea6c9f067727p-7, 0.0},
        {0x1.2078e7db1de81p-2, -0x1.01b87a37eb6fep-30, 0.0},
    };
    static const double linear_tolerance[5][3] = {
        {0x1p-47, 0x1p-47, 0.0},
        {0x1p-44, 0x1p-85, 0.0},
        {0x1p-49, 0x1p-47, 0.0},
        {0x1p-46, 0x1p-54, 0.0},
        {0x1p-51, 0x1p-65, 0.0},
    };
    static const double angular_expected[5][3] = {
        {0.0, 0.0, -0x1.540ef049e1b45p+2},
        {0.0, 0.0, 0x1.5d23ee41e0f12p+7},
        {0.0, 0.0, -0x1.9c3df482f252dp+1},
        {0.0, 0.0, -0x1.19fad58cf82eap-3},
        {0.0, 0.0, 0x1.7caf7f6f758cep-9},
    };
    static const double angular_tolerance[5][3] = {
        {0.0, 0.0, 0x1p-45},
        {0.0, 0.0, 0x1p-40},
        {0.0, 0.0, 0x1p-45},
        {0.0, 0.0, 0x1p-50},
        {0.0, 0.0, 0x1p-55},
    };
    static const double generalized_expected[5][2] = {
        {-0x1.088af9cf8917dp+2, -0x1.3c15e7340b288p+2},
        {0x1.29372633dc0a7p+5, 0x1.5d23ee41e0f6bp+7},
        {0x1.accd47979d303p+0, -0x1.2d01b72a8d9fap+3},
        {0x1.0582d40d0ca2ap+2, -0x1.e84a6eec6e6efp-4},
        {0x1.2078e7db1de81p-2, 0x1.7caf7e31688ep-9},
    };
    static const double generalized_tolerance[5][2] = {
        {0x1p-47, 0x1p-46},
        {0x1p-44, 0x1p-40},
        {0x1p-49, 0x1p-44},
        {0x1p-47, 0x1p-51},
        {0x1p-51, 0x1p-55},
    };
    int failures = 0, status;
    for (int i = 0; i < 5; ++i) {
        double linear[3];
        double angular[3];
        double generalized[2];
        status = elastic_pendulum_momenta(q_in[i], u_in[i], p_in[i], linear, angular, generalized);
        failures += check_status("momenta", i, status);
        failures += check("momenta linear", i, 3, linear, linear_expected[i], linear_tolerance[i]);
        failures += check("momenta angular", i, 3, angular, angular_expected[i],
            angular_tolerance[i]);
        failures += check("momenta generalized", i, 2, generalized, generalized_expected[i],
            generalized_tolerance[i]);
    }
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
    static const double p_in[5][5] = {
        {0x1.7790bap+1, 0x1.691be4p+2, 0x1.145202p-2, 0x1.e71dfp+2, 0x1.bf465ep-2},
        {0x1.de6706p+2, 0x1.29f70cp+2, 0x1.7a15ecp-2, 0x1.fccddcp+0, 0x1.6aa744p+2},
        {0x1.244b22p+3, 0x1.4b4ddcp+1, 0x1.879996p+0, 0x1.0f999cp+3, 0x1.b65c5ep+1},
        {0x1.184f4ap-3, 0x1.9e7162p+0, 0x1.e22d02p-1, 0x1.cdaf4cp-1, 0x1.aa5f9cp-2},
        {0x1.45e6c4p-1, 0x1.0b6adap-3, 0x1.5e3fbp+0, 0x1.1daafap+0, 0x1.1615f4p+1},
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
    int failures = 0, status;
    for (int i = 0; i < 5; ++i) {
        double qd[2];
        status = elastic_pendulum_coordinate_rates(q_in[i], u_in[i], p_in[i], qd);
        failures += check_status("coordinate_rates", i, status);
        failures += check("coordinate_rates", i, 2, qd, qd_expected[i], qd_tolerance[i]);
    }
    return failures;
}

static int test_jacobians(void)
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
    static const double p_in[5][5] = {
        {0x1.7790bap+1, 0x1.691be4p+2, 0x1.145202p-2, 0x1.e71dfp+2, 0x1.bf465ep-2},
        {0x1.de6706p+2, 0x1.29f70cp+2, 0x1.7a15ecp-2, 0x1.fccddcp+0, 0x1.6aa744p+2},
        {0x1.244b22p+3, 0x1.4b4ddcp+1, 0x1.879996p+0, 0x1.0f999cp+3, 0x1.b65c5ep+1},
        {0x1.184f4ap-3, 0x1.9e7162p+0, 0x1.e22d02p-1, 0x1.cdaf4cp-1, 0x1.aa5f9cp-2},
        {0x1.45e6c4p-1, 0x1.0b6adap-3, 0x1.5e3fbp+0, 0x1.1daafap+0, 0x1.1615f4p+1},
    };
    static const double ud_q_expected[5][4] = {
        {-0x1.4084a2b164fffp+1, 0x1.9f19adcdbbfa9p-24, -0x1.80b3145d57086p-3,
            -0x1.004d21f560c72p-3},
        {-0x1.29f712d45ec77p-1, 0x1.de5613a03d45ap-4, 0x1.3c4b6bb7acc25p+3, -0x1.075d47bb2950fp+1},
        {-0x1.69599a579f136p+1, -0x1.5c23fe39da9ffp-26, -0x1.f9b1f25a7d7c8p-2,
            0x1.dcab3ba4fadccp+0},
        {-0x1.10aee95fcb199p+0, -0x1.8c9cbea445cd2p+2, -0x1.7e7f5bcb5d3b7p+0,
            -0x1.477fedf0dc54bp+4},
        {-0x1.031646aa22fa9p+0, 0x1.3146495a2ead9p+1, 0x1.f44f409ad76eap-5, -0x1.af1c10967476dp+1},
    };
    static const double ud_q_tolerance[5][4] = {
        {0x1p-48, 0x1p-57, 0x1p-49, 0x1p-49},
        {0x1p-49, 0x1p-50, 0x1p-44, 0x1p-45},
        {0x1p-48, 0x1p-59, 0x1p-47, 0x1p-45},
        {0x1p-48, 0x1p-44, 0x1p-45, 0x1p-41},
        {0x1p-48, 0x1p-46, 0x1p-50, 0x1p-45},
    };
    static const double ud_u_expected[5][4] = {
        {0.0, 0.0, -0x1.a94ddfd542c97p-1, 0x1.13676901a8d6bp-25},
        {0.0, 0.0, 0x1.5f0b12061bff7p-39, -0x1.19c5bc73867aep-41},
        {0.0, 0.0, -0x1.070f9ed75a011p-1, -0x1.fae3a68a9f153p-29},
        {0.0, 0.0, -0x1.e9ceefe30e2a7p-7, -0x1.64354b4faf2f8p-4},
        {0.0, 0.0, -0x1.d37afab2c6471p-31, 0x1.1368bde182858p-29},
    };
    static const double ud_u_tolerance[5][4] = {
        {0.0, 0.0, 0x1p-48, 0x1p-59},
        {0.0, 0.0, 0x1p-86, 0x1p-88},
        {0.0, 0.0, 0x1p-48, 0x1p-61},
        {0.0, 0.0, 0x1p-53, 0x1p-50},
        {0.0, 0.0, 0x1p-66, 0x1p-64},
    };
    static const double ud_p_expected[5][10] = {
        {0x1.61b674bed6d0ep-5, 0x1.81295f3e6907ap-5, 0x1.00e85ca2e508dp-4, -0x1.4cb80d8bac51ap-29,
            0x1.c3719713d71d8p-25, -0x1.05bfd85802426p-1, -0x1.8fd501847babp-5,
            0x1.02e8d966fcc98p-29, 0x1.49e0f902df33p-5, -0x1.ab3927b2beba3p-30},
        {0x1.6e76651f8341cp-42, 0x1.30b11e87f70f4p-8, -0x1.9f6c768b36792p-8, 0x1.4d72e15ac14aep-10,
            0x1.20df59ab1314dp-43, -0x1.56b80c686f65fp-44, 0x1.64ea71db2c0fp-4,
            -0x1.1e7c73ae37d97p-6, -0x1.9f6c768bcc6e8p-6, 0x1.4d72e15b39a8fp-8},
        {0x1.e1b6db6a116a7p-9, 0x1.c29567acbdbe7p-6, -0x1.df6884206c705p+0, -0x1.cde215ec79885p-27,
            -0x1.e4e04fa442327p-27, -0x1.5051cad84b209p-3, 0x1.54fa85f41c7abp+0,
            0x1.48838df1b60bp-27, -0x1.e2ba806a9ff92p+0, -0x1.d114ffd28829fp-27},
        {0x1.e250c2eb1c575p-8, 0x1.1dd68c56ec52dp+7, 0x1.5b4cefee0117bp-1, 0x1.f924416df7c92p+1,
            -0x1.4a5ebc184dc55p-2, -0x1.6543f8885b19bp+3, -0x1.b979d1de93432p+0,
            -0x1.410f11c879757p+3, 0x1.18e922400e00cp+0, 0x1.989433cd6b6dbp+2},
        {0x1.7b111cc3043e3p-34, 0x1.27eea7ac63ca2p-1, -0x1.21fc1a3ae48fp-6, 0x1.55ae336317307p-5,
            0x1.0acbd478fce11p-27, -0x1.ce0fdcd45479ap-22, 0x1.1e87ea391536dp-3,
            -0x1.519c63857e8d1p-2, -0x1.21fc720a3ca66p-4, 0x1.55ae9ad9d5ff7p-3},
    };
    static const double ud_p_tolerance[5][10] = {
        {0x1p-52, 0x1p-50, 0x1p-51, 0x1p-52, 0x1p-58, 0x1p-48, 0x1p-53, 0x1p-63, 0x1p-52, 0x1p-63},
        {0x1p-51, 0x1p-52, 0x1p-50, 0x1p-52, 0x1p-90, 0x1p-91, 0x1p-52, 0x1p-53, 0x1p-52, 0x1p-54},
        {0x1p-55, 0x1p-50, 0x1p-46, 0x1p-50, 0x1p-60, 0x1p-50, 0x1p-49, 0x1p-60, 0x1p-46, 0x1p-60},
        {0x1p-42, 0x1p-37, 0x1p-45, 0x1p-42, 0x1p-48, 0x1p-44, 0x1p-48, 0x1p-44, 0x1p-47, 0x1p-43},
        {0x1p-51, 0x1p-45, 0x1p-49, 0x1p-44, 0x1p-62, 0x1p-57, 0x1p-51, 0x1p-48, 0x1p-51, 0x1p-49},
    };
    int failures = 0, status;
    for (int i = 0; i < 5; ++i) {
        double ud_q[4];
        double ud_u[4];
        double ud_p[10];
        status = elastic_pendulum_jacobians(q_in[i], u_in[i], p_in[i], ud_q, ud_u, ud_p);
        failures += check_status("jacobians", i, status);
        failures += check("jacobians ud_q", i, 4, ud_q, ud_q_expected[i], ud_q_tolerance[i]);
        failures += check("jacobians ud_u", i, 4, ud_u, ud_u_expected[i], ud_u_tolerance[i]);
        failures += check("jacobians ud_p", i, 10, ud_p, ud_p_expected[i], ud_p_tolerance[i]);
    }
    return failures;
}

static int test_step(void)
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
    static const double p_in[5][5] = {
        {0x1.7790bap+1, 0x1.691be4p+2, 0x1.145202p-2, 0x1.e71dfp+2, 0x1.bf465ep-2},
        {0x1.de6706p+2, 0x1.29f70cp+2, 0x1.7a15ecp-2, 0x1.fccddcp+0, 0x1.6aa744p+2},
        {0x1.244b22p+3, 0x1.4b4ddcp+1, 0x1.879996p+0, 0x1.0f999cp+3, 0x1.b65c5ep+1},
        {0x1.184f4ap-3, 0x1.9e7162p+0, 0x1.e22d02p-1, 0x1.cdaf4cp-1, 0x1.aa5f9cp-2},
        {0x1.45e6c4p-1, 0x1.0b6adap-3, 0x1.5e3fbp+0, 0x1.1daafap+0, 0x1.1615f4p+1},
    };
    static const double h_in[5][1] = {
        {0x1.8461cp-5},
        {0x1.5a394ep-5},
        {0x1.32d794p-5},
        {0x1.4e9a38p-5},
        {0x1.516702p-5},
    };
    static const double q_next_expected[5][2] = {
        {0x1.daa087f0251fap-4, 0x1.8e61d8f5ddfbep+0},
        {-0x1.22e3bdc248537p-2, 0x1.51620a98ae7aap-4},
        {-0x1.fe395d423f6a4p+1, 0x1.90d33f7d190ebp+0},
        {0x1.8a499de9e528p+0, 0x1.0de6381f6e51fp+1},
        {-0x1.31253ef97703ap-3, 0x1.91c3aadd7e92dp+2},
    };
    static const double q_next_tolerance[5][2] = {
        {0x1p-53, 0x1p-49},
        {0x1p-51, 0x1p-51},
        {0x1p-48, 0x1p-49},
        {0x1p-49, 0x1p-48},
        {0x1p-52, 0x1p-47},
    };
    static const double u_next_expected[5][2] = {
        {-0x1.60fdd202eb557p-1, -0x1.3f028d08255c2p-2},
        {0x1.56e059e6173cbp-2, 0x1.f223487135a0cp+0},
        {0x1.67b76463b029ap-1, -0x1.1f3fcecef78b3p-3},
        {0x1.ed64d6214444bp+0, -0x1.dd758e20a8d6fp-1},
        {0x1.0c34b41913aeap-3, -0x1.25fd05e80b471p-3},
    };
    static const double u_next_tolerance[5][2] = {
        {0x1p-50, 0x1p-51},
        {0x1p-50, 0x1p-49},
        {0x1p-47, 0x1p-51},
        {0x1p-49, 0x1p-46},
        {0x1p-52, 0x1p-50},
    };
    int failures = 0, status;
    for (int i = 0; i < 5; ++i) {
        double q_next[2];
        double u_next[2];
        status = elastic_pendulum_step(q_in[i], u_in[i], p_in[i], h_in[i], q_next, u_next);
        failures += check_status("step", i, status);
        failures += check("step q_next", i, 2, q_next, q_next_expected[i], q_next_tolerance[i]);
        failures += check("step u_next", i, 2, u_next, u_next_expected[i], u_next_tolerance[i]);
    }
    return failures;
}

static int test_reactions(void)
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
    static const double p_in[5][5] = {
        {0x1.7790bap+1, 0x1.691be4p+2, 0x1.145202p-2, 0x1.e71dfp+2, 0x1.bf465ep-2},
        {0x1.de6706p+2, 0x1.29f70cp+2, 0x1.7a15ecp-2, 0x1.fccddcp+0, 0x1.6aa744p+2},
        {0x1.244b22p+3, 0x1.4b4ddcp+1, 0x1.879996p+0, 0x1.0f999cp+3, 0x1.b65c5ep+1},
        {0x1.184f4ap-3, 0x1.9e7162p+0, 0x1.e22d02p-1, 0x1.cdaf4cp-1, 0x1.aa5f9cp-2},
        {0x1.45e6c4p-1, 0x1.0b6adap-3, 0x1.5e3fbp+0, 0x1.1daafap+0, 0x1.1615f4p+1},
    };
    static const double reactions_expected[5][3] = {
        {0x1.13603e80b02bep+1, 0x1.85c5c8b7ccea2p-2, 0x1.fe77920ff7192p-2},
        {-0x1.9cd49b95d3da1p-3, 0x1.0fc54f82416e9p+6, 0x1.1823b7a40c895p+6},
        {-0x1.d254b3d3b55e2p+4, 0x1.facacea8d3e19p-1, 0x1.8ea062a541063p+2},
        {0x1.dbfa7a5dceef5p+0, -0x1.40050af918284p-2, 0x1.4611c7d1f5cefp-4},
        {-0x1.4dfeda0ed1e76p-8, 0x1.6f4962609aaffp-3, 0x1.936bc8542d6bp+1},
    };
    static const double reactions_tolerance[5][3] = {
        {0x1p-46, 0x1p-46, 0x1p-46},
        {0x1p-47, 0x1p-42, 0x1p-42},
        {0x1p-42, 0x1p-45, 0x1p-45},
        {0x1p-45, 0x1p-45, 0x1p-45},
        {0x1p-52, 0x1p-52, 0x1p-48},
    };
    int failures = 0, status;
    for (int i = 0; i < 5; ++i) {
        double reactions[3];
        status = elastic_pendulum_reactions(q_in[i], u_in[i], p_in[i], reactions);
        failures += check_status("reactions", i, status);
        failures += check("reactions", i, 3, reactions, reactions_expected[i],
            reactions_tolerance[i]);
    }
    return failures;
}

int main(void)
{
    int failures = 0;
    failures += test_forward_dynamics();
    failures += test_mass_matrix();
    failures += test_forcing();
    failures += test_residual();
    failures += test_inverse_dynamics();
    failures += test_energy();
    failures += test_momenta();
    failures += test_coordinate_rates();
    failures += test_jacobians();
    failures += test_step();
    failures += test_reactions();
    printf("elastic_pendulum: %d failures\n", failures);
    return failures > 0;
}

/*
 * Co-simulation: the unit integrates itself, by an explicit Runge-Kutta method with equal steps.
 *
 *     k_i = f(t + c_i h, x + h sum_j a_ij k_j)        x(t + h) = x + h sum_i b_i k_i
 *
 * A communication step is divided into the fewest equal parts that are no longer than the parameter
 * for the step. Inputs are held over a communication step; time is not. The coefficients stand in
 * tables.c.
 */
#include "fmu.h"

#include <math.h>

/* Shares of the communication step: how far the importer's clock may be off, and a rounding. */
static const double CLOCK = 1e-6, ROUNDING = 1e-12;
static const double MOST_STEPS = 1e9;

/* x + h sum_j weights_j k_j, into the states of `to`. */
static void combine(const double *given, double h, int count, const double *weights,
    double slopes[MODEL_STAGES][MODEL_STATES], double *to)
{
    for (int i = 0; i < MODEL_STATES; ++i) {
        double sum = 0;
        for (int j = 0; j < count; ++j)
            sum += weights[j] * slopes[j][i];
        to[FIRST_STATE + i] = given[FIRST_STATE + i] + h * sum;
    }
}

/* One step in place; the status of the model's functions. Time is left to the caller. */
static int advance(double *given, double h)
{
    double slopes[MODEL_STAGES][MODEL_STATES], tried[MODEL_GIVEN];
    for (int i = 0; i < MODEL_GIVEN; ++i)
        tried[i] = given[i];
    for (int i = 0; i < MODEL_STAGES; ++i) {
        tried[TIME] = given[TIME] + MODEL(share)[i] * h;
        combine(given, h, i, MODEL(stage)[i], slopes, tried);
        const int code = MODEL(rates)(tried, slopes[i]);
        if (code != MODEL_OK)
            return code;
    }
    combine(given, h, MODEL_STAGES, MODEL(weight), slopes, given);
    return MODEL_OK;
}

/* Integrate over a communication step. */
static fmi3Status integrate(Instance *own, double begin, double length)
{
    double *given = own->state.given;
    const double needed = length / given[STEP_SIZE];
    if (!(needed <= MOST_STEPS))
        return OWN(report)(own, fmi3Error, "fmi3DoStep: %g internal steps are needed: make %s"
            " longer", needed, OWN(name)(STEP_SIZE));
    const long count = needed > 1 ? (long)ceil(needed * (1 - ROUNDING)) : 1;
    const double h = length / (double)count;
    for (long i = 0; i < count; ++i) {
        given[TIME] = begin + (double)i * h;
        if (OWN(judge)(own, advance(given, h), given[TIME]) != fmi3OK)
            return fmi3Error;
    }
    given[TIME] = begin + length;
    return fmi3OK;
}

FMI3(DoStep)(fmi3Instance instance, fmi3Float64 begin, fmi3Float64 length, fmi3Boolean final,
    fmi3Boolean *event, fmi3Boolean *terminate, fmi3Boolean *early, fmi3Float64 *reached)
{
    Instance *own = instance;
    double wanted[MODEL_WANTED];
    (void)final;
    if (!OWN(allowed)(own, "fmi3DoStep", STEP))
        return fmi3Error;
    *event = *terminate = *early = false;
    *reached = own->state.given[TIME];
    if (!(isfinite(length) && length > 0))
        return OWN(report)(own, fmi3Error,
            "fmi3DoStep: a step of %g s: a positive length is needed", length);
    if (!(fabs(begin - own->state.given[TIME]) <= CLOCK * length))
        return OWN(report)(own, fmi3Error, "fmi3DoStep: it begins at t = %.9g s, and the unit is at"
            " %.9g s", begin, own->state.given[TIME]);
    const State before = own->state;
    if (integrate(own, begin, length) != fmi3OK
        || OWN(compute)(own, own->state.given, wanted) != fmi3OK) {
        own->state = before;
        return fmi3Error;
    }
    *terminate = OWN(outside)(own, wanted) && !MODEL_BEYOND;
    *reached = own->state.given[TIME];
    return fmi3OK;
}

FMI3(GetOutputDerivatives)(fmi3Instance instance, const fmi3ValueReference references[],
    size_t count, const fmi3Int32 orders[], fmi3Float64 values[], size_t size)
{
    (void)references;
    (void)orders;
    (void)values;
    if (!OWN(allowed)(instance, "fmi3GetOutputDerivatives", STEP))
        return fmi3Error;
    if (count == 0 && size == 0)
        return fmi3OK;
    return OWN(report)(instance, fmi3Error,
        "fmi3GetOutputDerivatives: none are provided, as maxOutputDerivativeOrder tells");
}

/*
 * Model exchange: the importer integrates x' = f(t, x, inputs, parameters).
 *
 * Its event indicators are the margins of the conditions of validity: positive inside of the domain
 * of the model. Where one ceases to hold, the unit asks to end the simulation and says why.
 */
#include "fmu.h"

#include <math.h>
#include <string.h>

static bool exchanged(const Instance *own, const char *function, unsigned modes)
{
    if (!OWN(allowed)(own, function, modes))
        return false;
    if (!own->co_simulation)
        return true;
    OWN(report)(own, fmi3Error, "%s: this is an instance for co-simulation", function);
    return false;
}

static bool sized(const Instance *own, const char *function, size_t expected, size_t found)
{
    if (expected == found)
        return true;
    OWN(report)(own, fmi3Error, "%s: %zu values expected, %zu found", function, expected, found);
    return false;
}

FMI3(EnterEventMode)(fmi3Instance instance)
{
    if (!exchanged(instance, "fmi3EnterEventMode", CONTINUOUS_TIME))
        return fmi3Error;
    ((Instance *)instance)->state.mode = EVENT;
    return fmi3OK;
}

FMI3(EnterContinuousTimeMode)(fmi3Instance instance)
{
    if (!exchanged(instance, "fmi3EnterContinuousTimeMode", EVENT))
        return fmi3Error;
    ((Instance *)instance)->state.mode = CONTINUOUS_TIME;
    return fmi3OK;
}

FMI3(UpdateDiscreteStates)(fmi3Instance instance, fmi3Boolean *again, fmi3Boolean *terminate,
    fmi3Boolean *nominals_changed, fmi3Boolean *states_changed, fmi3Boolean *time_event,
    fmi3Float64 *next_event)
{
    Instance *own = instance;
    double wanted[MODEL_WANTED];
    if (!exchanged(own, "fmi3UpdateDiscreteStates", EVENT))
        return fmi3Error;
    if (OWN(compute)(own, own->state.given, wanted) != fmi3OK)
        return fmi3Error;
    *terminate = OWN(outside)(own, wanted) && !MODEL_BEYOND;
    *again = *nominals_changed = *states_changed = *time_event = false;
    *next_event = INFINITY;
    return fmi3OK;
}

FMI3(CompletedIntegratorStep)(fmi3Instance instance, fmi3Boolean final, fmi3Boolean *event,
    fmi3Boolean *terminate)
{
    Instance *own = instance;
    double wanted[MODEL_WANTED];
    (void)final;
    if (!exchanged(own, "fmi3CompletedIntegratorStep", CONTINUOUS_TIME))
        return fmi3Error;
    if (OWN(compute)(own, own->state.given, wanted) != fmi3OK)
        return fmi3Error;
    *terminate = false;
    /* An importer that looks at the indicators at the ends of its steps only is told here. */
    *event = OWN(outside)(own, wanted) && !MODEL_BEYOND;
    return fmi3OK;
}

FMI3(SetTime)(fmi3Instance instance, fmi3Float64 time)
{
    Instance *own = instance;
    if (!exchanged(own, "fmi3SetTime", EVENT | CONTINUOUS_TIME))
        return fmi3Error;
    if (!isfinite(time))
        return OWN(report)(own, fmi3Error, "fmi3SetTime: %g is no time", time);
    own->state.given[TIME] = time;
    return fmi3OK;
}

FMI3(SetContinuousStates)(fmi3Instance instance, const fmi3Float64 states[], size_t count)
{
    Instance *own = instance;
    if (!exchanged(own, "fmi3SetContinuousStates", CONTINUOUS_TIME)
        || !sized(own, "fmi3SetContinuousStates", MODEL_STATES, count))
        return fmi3Error;
    /* An integrator may try a state that is none: its rates will tell. */
    memcpy(own->state.given + FIRST_STATE, states, MODEL_STATES * sizeof *states);
    return fmi3OK;
}

FMI3(GetContinuousStates)(fmi3Instance instance, fmi3Float64 states[], size_t count)
{
    Instance *own = instance;
    if (!exchanged(own, "fmi3GetContinuousStates", COMPUTABLE)
        || !sized(own, "fmi3GetContinuousStates", MODEL_STATES, count))
        return fmi3Error;
    memcpy(states, own->state.given + FIRST_STATE, MODEL_STATES * sizeof *states);
    return fmi3OK;
}

FMI3(GetContinuousStateDerivatives)(fmi3Instance instance, fmi3Float64 rates[], size_t count)
{
    Instance *own = instance;
    if (!exchanged(own, "fmi3GetContinuousStateDerivatives", COMPUTABLE)
        || !sized(own, "fmi3GetContinuousStateDerivatives", MODEL_STATES, count))
        return fmi3Error;
    return OWN(judge)(own, MODEL(rates)(own->state.given, rates), own->state.given[TIME]);
}

FMI3(GetEventIndicators)(fmi3Instance instance, fmi3Float64 indicators[], size_t count)
{
    Instance *own = instance;
    double wanted[MODEL_WANTED];
    if (!exchanged(own, "fmi3GetEventIndicators", COMPUTABLE)
        || !sized(own, "fmi3GetEventIndicators", MODEL_MARGINS, count))
        return fmi3Error;
    if (count && OWN(compute)(own, own->state.given, wanted) != fmi3OK)
        return fmi3Error;
    if (count)
        memcpy(indicators, wanted + MODEL_WANTED - count, count * sizeof *indicators);
    return fmi3OK;
}

FMI3(GetNominalsOfContinuousStates)(fmi3Instance instance, fmi3Float64 nominals[], size_t count)
{
    if (!exchanged(instance, "fmi3GetNominalsOfContinuousStates", ANY)
        || !sized(instance, "fmi3GetNominalsOfContinuousStates", MODEL_STATES, count))
        return fmi3Error;
    /* None is declared, so that each is one, says the standard. */
    for (size_t i = 0; i < count; ++i)
        nominals[i] = 1.0;
    return fmi3OK;
}

FMI3(GetNumberOfContinuousStates)(fmi3Instance instance, size_t *count)
{
    if (!exchanged(instance, "fmi3GetNumberOfContinuousStates", ANY))
        return fmi3Error;
    *count = MODEL_STATES;
    return fmi3OK;
}

FMI3(GetNumberOfEventIndicators)(fmi3Instance instance, size_t *count)
{
    if (!exchanged(instance, "fmi3GetNumberOfEventIndicators", ANY))
        return fmi3Error;
    *count = MODEL_MARGINS;
    return fmi3OK;
}

/* The life of an instance: made, initialised, reset, terminated, freed. */
#include "fmu.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

FMI3_EXPORT const char *FMI3_NAME(GetVersion)(void)
{
    return "3.0";
}

FMI3(SetDebugLogging)(fmi3Instance instance, fmi3Boolean on, size_t count,
    const fmi3String categories[])
{
    /* Errors and warnings are always logged, and there is nothing else to log. */
    (void)on;
    if (!OWN(allowed)(instance, "fmi3SetDebugLogging", ANY))
        return fmi3Error;
    for (size_t i = 0; i < count; ++i)
        if (strcmp(categories[i], "logStatusWarning") && strcmp(categories[i], "logStatusError"))
            return OWN(report)(instance, fmi3Error,
                "fmi3SetDebugLogging: there is no category %s", categories[i]);
    return fmi3OK;
}

static Instance *made(const char *token, bool co_simulation, fmi3InstanceEnvironment environment,
    fmi3LogMessageCallback log)
{
    const Instance start = {
        {{0}, INSTANTIATED, false}, co_simulation, environment, log
    };
    if (!token || strcmp(token, MODEL_TOKEN)) {
        OWN(report)(&start, fmi3Error,
            "the instantiation token is not that of this unit, " MODEL_TOKEN
            ": modelDescription.xml and library are of different exports");
        return NULL;
    }
    Instance *instance = malloc(sizeof *instance);
    if (!instance) {
        OWN(report)(&start, fmi3Error, "there is no memory for an instance");
        return NULL;
    }
    *instance = start;
    memcpy(instance->state.given, MODEL(start), sizeof instance->state.given);
    return instance;
}

FMI3_EXPORT fmi3Instance FMI3_NAME(InstantiateModelExchange)(fmi3String name, fmi3String token,
    fmi3String resources, fmi3Boolean visible, fmi3Boolean logging,
    fmi3InstanceEnvironment environment, fmi3LogMessageCallback log)
{
    (void)name;
    (void)resources;
    (void)visible;
    (void)logging;
    return made(token, false, environment, log);
}

FMI3_EXPORT fmi3Instance FMI3_NAME(InstantiateCoSimulation)(fmi3String name, fmi3String token,
    fmi3String resources, fmi3Boolean visible, fmi3Boolean logging, fmi3Boolean events,
    fmi3Boolean early, const fmi3ValueReference intermediate[], size_t count,
    fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
    fmi3IntermediateUpdateCallback update)
{
    (void)name;
    (void)resources;
    (void)visible;
    (void)logging;
    /* Whoever allows events and early returns has to do without them. */
    (void)events;
    (void)early;
    (void)intermediate;
    (void)count;
    (void)update;
    return made(token, true, environment, log);
}

FMI3_EXPORT void FMI3_NAME(FreeInstance)(fmi3Instance instance)
{
    free(instance);
}

FMI3(Reset)(fmi3Instance instance)
{
    Instance *own = instance;
    if (!OWN(allowed)(own, "fmi3Reset", ANY))
        return fmi3Error;
    own->state.mode = INSTANTIATED;
    own->state.left = false;
    memcpy(own->state.given, MODEL(start), sizeof own->state.given);
    return fmi3OK;
}

FMI3(EnterInitializationMode)(fmi3Instance instance, fmi3Boolean tolerance_defined,
    fmi3Float64 tolerance, fmi3Float64 start, fmi3Boolean stop_defined, fmi3Float64 stop)
{
    Instance *own = instance;
    /* The internal steps are fixed: what they may be is a parameter. */
    (void)tolerance_defined;
    (void)tolerance;
    if (!OWN(allowed)(own, "fmi3EnterInitializationMode", INSTANTIATED))
        return fmi3Error;
    if (!isfinite(start) || (stop_defined && !(stop >= start)))
        return OWN(report)(own, fmi3Error,
            "fmi3EnterInitializationMode: from t = %g s to %g s is no interval", start, stop);
    own->state.given[TIME] = start;
    own->state.mode = INITIALIZATION;
    return fmi3OK;
}

FMI3(ExitInitializationMode)(fmi3Instance instance)
{
    Instance *own = instance;
    double wanted[MODEL_WANTED];
    if (!OWN(allowed)(own, "fmi3ExitInitializationMode", INITIALIZATION))
        return fmi3Error;
    if (OWN(compute)(own, own->state.given, wanted) != fmi3OK)
        return fmi3Error;
    if (OWN(outside)(own, wanted) && !MODEL_BEYOND)
        return OWN(report)(own, fmi3Error,
            "the motion starts outside of the domain of the model: start from other values");
    own->state.mode = own->co_simulation ? STEP : EVENT;
    return fmi3OK;
}

FMI3(Terminate)(fmi3Instance instance)
{
    if (!OWN(allowed)(instance, "fmi3Terminate", INITIALIZED))
        return fmi3Error;
    ((Instance *)instance)->state.mode = TERMINATED;
    return fmi3OK;
}

/* What the other files share: reports, modes, computing what is wanted, the domain of the model. */
#include "fmu.h"

#include <stdarg.h>
#include <stdio.h>

enum { LONGEST_MESSAGE = 512 };

fmi3Status OWN(report)(const Instance *instance, fmi3Status status, const char *format, ...)
{
    static const char *const categories[] = {
        "", "logStatusWarning", "logStatusDiscard", "logStatusError", "logStatusFatal"
    };
    if (instance->log) {
        char message[LONGEST_MESSAGE];
        va_list arguments;
        va_start(arguments, format);
        vsnprintf(message, sizeof message, format, arguments);
        va_end(arguments);
        instance->log(instance->environment, status, categories[status], message);
    }
    return status;
}

static const char *mode_name(Mode mode)
{
    switch (mode) {
    case INSTANTIATED: return "Instantiated";
    case INITIALIZATION: return "Initialization Mode";
    case EVENT: return "Event Mode";
    case CONTINUOUS_TIME: return "Continuous-Time Mode";
    case STEP: return "Step Mode";
    case TERMINATED: return "Terminated";
    }
    return "an unknown mode";
}

bool OWN(allowed)(const Instance *instance, const char *function, unsigned modes)
{
    if (!instance)
        return false;
    if (instance->state.mode & modes)
        return true;
    OWN(report)(instance, fmi3Error, "%s: not allowed in %s", function,
        mode_name(instance->state.mode));
    return false;
}

fmi3Status OWN(judge)(const Instance *instance, int code, double time)
{
    static const char *const meanings[] = {
        "",
        "a divisor is zero: the configuration is singular",
        "a value is beyond the largest number",
        "a given value is infinite or no number"
    };
    if (code == MODEL_OK)
        return fmi3OK;
    return OWN(report)(instance, fmi3Error, "t = %.9g s: %s", time, meanings[code]);
}

fmi3Status OWN(compute)(const Instance *instance, const double *given, double *wanted)
{
    int code = MODEL(rates)(given, wanted);
#if MODEL_OUTPUTS > 0
    if (code == MODEL_OK)
        code = MODEL(outputs)(given, wanted + MODEL_STATES);
#endif
    return OWN(judge)(instance, code, given[TIME]);
}

bool OWN(outside)(Instance *instance, const double *wanted)
{
    bool broken = false;
#if MODEL_MARGINS > 0
    const double *margins = wanted + MODEL_WANTED - MODEL_MARGINS;
    for (int i = 0; i < MODEL_MARGINS; ++i) {
        if (margins[i] > 0 || (margins[i] == 0 && !MODEL(edge_is_outside)[i]))
            continue;
        if (!instance->state.left)
            OWN(report)(instance, fmi3Warning, "t = %.9g s: %s",
                instance->state.given[TIME], MODEL(otherwise)[i]);
        broken = true;
    }
    instance->state.left = broken;
#else
    (void)instance;
    (void)wanted;
#endif
    return broken;
}

const char *OWN(name)(fmi3ValueReference reference)
{
    return reference < MODEL_GIVEN + MODEL_WANTED ? MODEL(names)[reference] : "no variable";
}

/* Values by their references; what is wrong is named. */
#include "fmu.h"

#include <math.h>

FMI3(GetFloat64)(fmi3Instance instance, const fmi3ValueReference references[], size_t count,
    fmi3Float64 values[], size_t size)
{
    Instance *own = instance;
    double wanted[MODEL_WANTED];
    bool computed = false;
    if (!OWN(allowed)(own, "fmi3GetFloat64", ANY))
        return fmi3Error;
    if (size != count)
        return OWN(report)(own, fmi3Error,
            "fmi3GetFloat64: %zu references and %zu values: there are no arrays here", count, size);
    for (size_t i = 0; i < count; ++i) {
        const fmi3ValueReference at = references[i];
        if (at < MODEL_GIVEN) {
            values[i] = own->state.given[at];
        } else if (at < MODEL_GIVEN + MODEL_WANTED) {
            if (!computed && OWN(compute)(own, own->state.given, wanted) != fmi3OK)
                return fmi3Error;
            computed = true;
            values[i] = wanted[at - MODEL_GIVEN];
        } else {
            return OWN(report)(own, fmi3Error,
                "fmi3GetFloat64: there is no variable with the reference %u", (unsigned)at);
        }
    }
    return fmi3OK;
}

/* The modes in which a variable may be set; 0 for one that never may. */
static unsigned settable(fmi3ValueReference at)
{
    if (at == TIME || at >= MODEL_GIVEN)
        return 0;
    if (at < FIRST_INPUT)
        return INSTANTIATED | INITIALIZATION;
    if (at < FIRST_PARAMETER)
        return ANY & ~(unsigned)TERMINATED;
    return INSTANTIATED | INITIALIZATION | EVENT | STEP;
}

static fmi3Status checked(const Instance *own, fmi3ValueReference at, double value)
{
    const unsigned modes = settable(at);
    if (!modes)
        return OWN(report)(own, fmi3Error,
            "fmi3SetFloat64: %s (reference %u) cannot be set", OWN(name)(at), (unsigned)at);
    if (!(own->state.mode & modes))
        return OWN(report)(own, fmi3Error,
            "fmi3SetFloat64: %s cannot be set in this mode", OWN(name)(at));
    if (!isfinite(value))
        return OWN(report)(own, fmi3Error,
            "fmi3SetFloat64: %s = %g: a finite number is needed", OWN(name)(at), value);
    if (MODEL(positive)[at] && value < 0)
        return OWN(report)(own, fmi3Error,
            "fmi3SetFloat64: %s = %g is negative: it is declared positive", OWN(name)(at), value);
    if (at == STEP_SIZE && value == 0)
        return OWN(report)(own, fmi3Error,
            "fmi3SetFloat64: %s is zero: nothing would ever move", OWN(name)(at));
    return fmi3OK;
}

FMI3(SetFloat64)(fmi3Instance instance, const fmi3ValueReference references[], size_t count,
    const fmi3Float64 values[], size_t size)
{
    Instance *own = instance;
    if (!OWN(allowed)(own, "fmi3SetFloat64", ANY))
        return fmi3Error;
    if (size != count)
        return OWN(report)(own, fmi3Error,
            "fmi3SetFloat64: %zu references and %zu values: there are no arrays here", count, size);
    /* All or nothing: a value that is refused leaves the others as they were. */
    for (size_t i = 0; i < count; ++i)
        if (checked(own, references[i], values[i]) != fmi3OK)
            return fmi3Error;
    for (size_t i = 0; i < count; ++i)
        own->state.given[references[i]] = values[i];
    return fmi3OK;
}

/*
 * Directional and adjoint derivatives:
 *
 *     d wanted = J d given          d given^T = d wanted^T J
 *
 * J is never formed: the model has J v and v^T J as functions of their own, differentiated exactly.
 * A given variable may stand among the unknowns, too: a coordinate is an output, whose derivative
 * by itself is one.
 */
#include "fmu.h"

#include <string.h>

static fmi3Status checked(const Instance *own, const char *function,
    const fmi3ValueReference unknowns[], size_t unknown_count, const fmi3ValueReference knowns[],
    size_t known_count, bool sizes)
{
    if (!OWN(allowed)(own, function, COMPUTABLE))
        return fmi3Error;
    if (!sizes)
        return OWN(report)(own, fmi3Error, "%s: as many seeds and sensitivities as variables are"
            " needed: there are no arrays here", function);
    for (size_t i = 0; i < unknown_count; ++i)
        if (unknowns[i] >= MODEL_GIVEN + MODEL_WANTED)
            return OWN(report)(own, fmi3Error, "%s: there is no variable with the reference %u",
                function, (unsigned)unknowns[i]);
    for (size_t i = 0; i < known_count; ++i)
        if (knowns[i] >= MODEL_GIVEN)
            return OWN(report)(own, fmi3Error, "%s: nothing can be derived by %s (reference %u)",
                function, OWN(name)(knowns[i]), (unsigned)knowns[i]);
    return fmi3OK;
}

FMI3(GetDirectionalDerivative)(fmi3Instance instance, const fmi3ValueReference unknowns[],
    size_t unknown_count, const fmi3ValueReference knowns[], size_t known_count,
    const fmi3Float64 seed[], size_t seed_count, fmi3Float64 sensitivity[],
    size_t sensitivity_count)
{
    Instance *own = instance;
    double d_given[MODEL_GIVEN] = {0}, d_wanted[MODEL_WANTED];
    if (checked(own, "fmi3GetDirectionalDerivative", unknowns, unknown_count, knowns, known_count,
            seed_count == known_count && sensitivity_count == unknown_count) != fmi3OK)
        return fmi3Error;
    for (size_t i = 0; i < known_count; ++i)
        d_given[knowns[i]] += seed[i];
    const int code = MODEL(tangent)(own->state.given, d_given, d_wanted);
    if (OWN(judge)(own, code, own->state.given[TIME]) != fmi3OK)
        return fmi3Error;
    for (size_t i = 0; i < unknown_count; ++i) {
        const fmi3ValueReference at = unknowns[i];
        sensitivity[i] = at < MODEL_GIVEN ? d_given[at] : d_wanted[at - MODEL_GIVEN];
    }
    return fmi3OK;
}

FMI3(GetAdjointDerivative)(fmi3Instance instance, const fmi3ValueReference unknowns[],
    size_t unknown_count, const fmi3ValueReference knowns[], size_t known_count,
    const fmi3Float64 seed[], size_t seed_count, fmi3Float64 sensitivity[],
    size_t sensitivity_count)
{
    Instance *own = instance;
    double d_given[MODEL_GIVEN] = {0}, d_wanted[MODEL_WANTED] = {0}, through[MODEL_GIVEN];
    if (checked(own, "fmi3GetAdjointDerivative", unknowns, unknown_count, knowns, known_count,
            seed_count == unknown_count && sensitivity_count == known_count) != fmi3OK)
        return fmi3Error;
    for (size_t i = 0; i < unknown_count; ++i) {
        const fmi3ValueReference at = unknowns[i];
        if (at < MODEL_GIVEN)
            d_given[at] += seed[i];
        else
            d_wanted[at - MODEL_GIVEN] += seed[i];
    }
    const int code = MODEL(adjoint)(own->state.given, d_wanted, through);
    if (OWN(judge)(own, code, own->state.given[TIME]) != fmi3OK)
        return fmi3Error;
    for (size_t i = 0; i < known_count; ++i)
        sensitivity[i] = d_given[knowns[i]] + through[knowns[i]];
    return fmi3OK;
}

/*
 * The state of an instance: kept, given back, and written as bytes.
 *
 *     bytes = token, mode, whether it has left its domain, the given values
 *
 * The bytes are those of this machine. The token in front keeps a state from another export out.
 */
#include "fmu.h"

#include <stdlib.h>
#include <string.h>

enum { BYTES = sizeof MODEL_TOKEN + sizeof(State) };

FMI3(GetFMUState)(fmi3Instance instance, fmi3FMUState *state)
{
    Instance *own = instance;
    if (!OWN(allowed)(own, "fmi3GetFMUState", ANY))
        return fmi3Error;
    if (!*state && !(*state = malloc(sizeof(State))))
        return OWN(report)(own, fmi3Error, "fmi3GetFMUState: there is no memory");
    memcpy(*state, &own->state, sizeof(State));
    return fmi3OK;
}

FMI3(SetFMUState)(fmi3Instance instance, fmi3FMUState state)
{
    Instance *own = instance;
    if (!OWN(allowed)(own, "fmi3SetFMUState", ANY))
        return fmi3Error;
    if (!state)
        return OWN(report)(own, fmi3Error, "fmi3SetFMUState: there is no state");
    memcpy(&own->state, state, sizeof(State));
    return fmi3OK;
}

FMI3(FreeFMUState)(fmi3Instance instance, fmi3FMUState *state)
{
    if (!OWN(allowed)(instance, "fmi3FreeFMUState", ANY))
        return fmi3Error;
    free(*state);
    *state = NULL;
    return fmi3OK;
}

FMI3(SerializedFMUStateSize)(fmi3Instance instance, fmi3FMUState state, size_t *size)
{
    (void)state;
    if (!OWN(allowed)(instance, "fmi3SerializedFMUStateSize", ANY))
        return fmi3Error;
    *size = BYTES;
    return fmi3OK;
}

FMI3(SerializeFMUState)(fmi3Instance instance, fmi3FMUState state, fmi3Byte bytes[], size_t size)
{
    Instance *own = instance;
    if (!OWN(allowed)(own, "fmi3SerializeFMUState", ANY))
        return fmi3Error;
    if (!state || size != BYTES)
        return OWN(report)(own, fmi3Error, "fmi3SerializeFMUState: a state and room for %d bytes"
            " are needed, %zu bytes found", (int)BYTES, size);
    memcpy(bytes, MODEL_TOKEN, sizeof MODEL_TOKEN);
    memcpy(bytes + sizeof MODEL_TOKEN, state, sizeof(State));
    return fmi3OK;
}

FMI3(DeserializeFMUState)(fmi3Instance instance, const fmi3Byte bytes[], size_t size,
    fmi3FMUState *state)
{
    Instance *own = instance;
    if (!OWN(allowed)(own, "fmi3DeserializeFMUState", ANY))
        return fmi3Error;
    if (size != BYTES || memcmp(bytes, MODEL_TOKEN, sizeof MODEL_TOKEN))
        return OWN(report)(own, fmi3Error,
            "fmi3DeserializeFMUState: these bytes are no state of this unit, " MODEL_TOKEN);
    if (!*state && !(*state = malloc(sizeof(State))))
        return OWN(report)(own, fmi3Error, "fmi3DeserializeFMUState: there is no memory");
    memcpy(*state, bytes + sizeof MODEL_TOKEN, sizeof(State));
    return fmi3OK;
}

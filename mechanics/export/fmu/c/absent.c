/*
 * What the interface has and this unit has not: variables of other types, clocks, configuration,
 * scheduled execution. Whoever asks is told so.
 */
#include "fmu.h"

/* Nothing asked of nothing is fine; anything else names the function. */
static fmi3Status absent(fmi3Instance instance, const char *function, size_t asked,
    const char *what)
{
    if (!OWN(allowed)(instance, function, ANY))
        return fmi3Error;
    if (asked == 0)
        return fmi3OK;
    return OWN(report)(instance, fmi3Error, "%s: there are no %s here", function, what);
}

#define OTHER_TYPE(type)                                                                           \
    FMI3(Get##type)(fmi3Instance instance, const fmi3ValueReference references[], size_t count,    \
        fmi3##type values[], size_t size)                                                          \
    {                                                                                              \
        (void)references;                                                                          \
        (void)values;                                                                              \
        return absent(instance, "fmi3Get" #type, count + size, "variables of type " #type);        \
    }                                                                                              \
    FMI3(Set##type)(fmi3Instance instance, const fmi3ValueReference references[], size_t count,    \
        const fmi3##type values[], size_t size)                                                    \
    {                                                                                              \
        (void)references;                                                                          \
        (void)values;                                                                              \
        return absent(instance, "fmi3Set" #type, count + size, "variables of type " #type);        \
    }

OTHER_TYPE(Float32)
OTHER_TYPE(Int8)
OTHER_TYPE(UInt8)
OTHER_TYPE(Int16)
OTHER_TYPE(UInt16)
OTHER_TYPE(Int32)
OTHER_TYPE(UInt32)
OTHER_TYPE(Int64)
OTHER_TYPE(UInt64)
OTHER_TYPE(Boolean)
OTHER_TYPE(String)

FMI3(GetBinary)(fmi3Instance instance, const fmi3ValueReference references[], size_t count,
    size_t sizes[], fmi3Binary values[], size_t size)
{
    (void)references;
    (void)sizes;
    (void)values;
    return absent(instance, "fmi3GetBinary", count + size, "variables of type Binary");
}

FMI3(SetBinary)(fmi3Instance instance, const fmi3ValueReference references[], size_t count,
    const size_t sizes[], const fmi3Binary values[], size_t size)
{
    (void)references;
    (void)sizes;
    (void)values;
    return absent(instance, "fmi3SetBinary", count + size, "variables of type Binary");
}

/* Functions of clocks: two or three arrays beside the references, none of which is looked at. */
#define CLOCK(name, array)                                                                         \
    FMI3(name)(fmi3Instance instance, const fmi3ValueReference references[], size_t count,         \
        array first)                                                                               \
    {                                                                                              \
        (void)references;                                                                          \
        (void)first;                                                                               \
        return absent(instance, "fmi3" #name, count, "clocks");                                    \
    }
#define CLOCK_2(name, array, other)                                                                \
    FMI3(name)(fmi3Instance instance, const fmi3ValueReference references[], size_t count,         \
        array first, other second)                                                                 \
    {                                                                                              \
        (void)references;                                                                          \
        (void)first;                                                                               \
        (void)second;                                                                              \
        return absent(instance, "fmi3" #name, count, "clocks");                                    \
    }

CLOCK(GetClock, fmi3Clock *)
CLOCK(SetClock, const fmi3Clock *)
CLOCK(GetShiftDecimal, fmi3Float64 *)
CLOCK(SetShiftDecimal, const fmi3Float64 *)
CLOCK(SetIntervalDecimal, const fmi3Float64 *)
CLOCK_2(GetIntervalDecimal, fmi3Float64 *, fmi3IntervalQualifier *)
CLOCK_2(GetShiftFraction, fmi3UInt64 *, fmi3UInt64 *)
CLOCK_2(SetShiftFraction, const fmi3UInt64 *, const fmi3UInt64 *)
CLOCK_2(SetIntervalFraction, const fmi3UInt64 *, const fmi3UInt64 *)

FMI3(GetIntervalFraction)(fmi3Instance instance, const fmi3ValueReference references[],
    size_t count, fmi3UInt64 counters[], fmi3UInt64 resolutions[],
    fmi3IntervalQualifier qualifiers[])
{
    (void)references;
    (void)counters;
    (void)resolutions;
    (void)qualifiers;
    return absent(instance, "fmi3GetIntervalFraction", count, "clocks");
}

FMI3(ActivateModelPartition)(fmi3Instance instance, fmi3ValueReference clock, fmi3Float64 time)
{
    (void)clock;
    (void)time;
    return absent(instance, "fmi3ActivateModelPartition", 1, "model partitions");
}

FMI3_EXPORT fmi3Instance FMI3_NAME(InstantiateScheduledExecution)(fmi3String name,
    fmi3String token, fmi3String resources, fmi3Boolean visible, fmi3Boolean logging,
    fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
    fmi3ClockUpdateCallback update, fmi3LockPreemptionCallback lock,
    fmi3UnlockPreemptionCallback unlock)
{
    (void)name;
    (void)token;
    (void)resources;
    (void)visible;
    (void)logging;
    (void)update;
    (void)lock;
    (void)unlock;
    if (log)
        log(environment, fmi3Error, "logStatusError",
            "this unit is for model exchange and co-simulation, not for scheduled execution");
    return NULL;
}

FMI3(GetNumberOfVariableDependencies)(fmi3Instance instance, fmi3ValueReference reference,
    size_t *count)
{
    (void)reference;
    (void)count;
    return absent(instance, "fmi3GetNumberOfVariableDependencies", 1, "dependencies per element");
}

FMI3(GetVariableDependencies)(fmi3Instance instance, fmi3ValueReference dependent,
    size_t dependent_elements[], fmi3ValueReference independents[], size_t elements[],
    fmi3DependencyKind kinds[], size_t count)
{
    (void)dependent;
    (void)dependent_elements;
    (void)independents;
    (void)elements;
    (void)kinds;
    return absent(instance, "fmi3GetVariableDependencies", count, "dependencies per element");
}

FMI3(EnterConfigurationMode)(fmi3Instance instance)
{
    return absent(instance, "fmi3EnterConfigurationMode", 1, "structural parameters");
}

FMI3(ExitConfigurationMode)(fmi3Instance instance)
{
    return absent(instance, "fmi3ExitConfigurationMode", 1, "structural parameters");
}

FMI3(EvaluateDiscreteStates)(fmi3Instance instance)
{
    return absent(instance, "fmi3EvaluateDiscreteStates", 1, "discrete states");
}

FMI3(EnterStepMode)(fmi3Instance instance)
{
    return absent(instance, "fmi3EnterStepMode", 1, "events in co-simulation");
}

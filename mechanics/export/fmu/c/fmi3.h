/*
 * The part of the Functional Mock-up Interface 3.0 that this unit speaks: its types, and its
 * functions as macros of name and parameters. Declared here in our own words, from the names and
 * types that the standard fixes, so that the sources build without any other header.
 */
#ifndef FMI3_H
#define FMI3_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef void *fmi3Instance;
typedef void *fmi3InstanceEnvironment;
typedef void *fmi3FMUState;
typedef uint32_t fmi3ValueReference;

typedef float fmi3Float32;
typedef double fmi3Float64;
typedef int8_t fmi3Int8;
typedef uint8_t fmi3UInt8;
typedef int16_t fmi3Int16;
typedef uint16_t fmi3UInt16;
typedef int32_t fmi3Int32;
typedef uint32_t fmi3UInt32;
typedef int64_t fmi3Int64;
typedef uint64_t fmi3UInt64;
typedef bool fmi3Boolean;
typedef bool fmi3Clock;
typedef const char *fmi3String;
typedef uint8_t fmi3Byte;
typedef const fmi3Byte *fmi3Binary;

typedef enum { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal } fmi3Status;

typedef enum {
    fmi3Independent, fmi3Constant, fmi3Fixed, fmi3Tunable, fmi3Discrete, fmi3Dependent
} fmi3DependencyKind;

typedef enum {
    fmi3IntervalNotYetKnown, fmi3IntervalUnchanged, fmi3IntervalChanged
} fmi3IntervalQualifier;

typedef void (*fmi3LogMessageCallback)(fmi3InstanceEnvironment environment, fmi3Status status,
    fmi3String category, fmi3String message);
typedef void (*fmi3ClockUpdateCallback)(fmi3InstanceEnvironment environment);
typedef void (*fmi3IntermediateUpdateCallback)(fmi3InstanceEnvironment environment,
    fmi3Float64 time, fmi3Boolean setRequested, fmi3Boolean getAllowed, fmi3Boolean stepFinished,
    fmi3Boolean canReturnEarly, fmi3Boolean *returnEarly, fmi3Float64 *earlyReturnTime);
typedef void (*fmi3LockPreemptionCallback)(void);
typedef void (*fmi3UnlockPreemptionCallback)(void);

/*
 * A shared library exports the plain names; where units are linked statically, whoever compiles
 * defines FMI3_FUNCTION_PREFIX, which then begins every name.
 */
#define FMI3_PASTED(prefix, name) prefix##name
#define FMI3_PASTE(prefix, name) FMI3_PASTED(prefix, name)
#ifdef FMI3_FUNCTION_PREFIX
#define FMI3_NAME(name) FMI3_PASTE(FMI3_FUNCTION_PREFIX, fmi3##name)
#else
#define FMI3_NAME(name) fmi3##name
#endif

#ifndef FMI3_EXPORT
#if defined(_WIN32) || defined(__CYGWIN__)
#define FMI3_EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define FMI3_EXPORT __attribute__((visibility("default")))
#else
#define FMI3_EXPORT
#endif
#endif

/* Head of a function that returns a status: FMI3(Reset)(fmi3Instance instance) { ... } */
#define FMI3(name) FMI3_EXPORT fmi3Status FMI3_NAME(name)

#endif /* FMI3_H */

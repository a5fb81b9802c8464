/*
 * One instance of the unit: everything that is given, y = g(given) for everything that is wanted.
 *
 *     given  = time, states, inputs, parameters, step size     value references from 0
 *     wanted = rates of the states, outputs, margins           value references after those
 *
 * Nothing that is wanted is stored: it is computed when it is asked for.
 */
#ifndef FMU_H
#define FMU_H

#include "fmi3.h"
#include "tables.h"

/* Names that several files use, unique for each model that is linked into one program. */
#define OWN(name) MODEL(fmu_##name)

/* Places in `given`. */
enum {
    TIME = 0,
    FIRST_STATE = 1,
    FIRST_INPUT = FIRST_STATE + MODEL_STATES,
    FIRST_PARAMETER = FIRST_INPUT + MODEL_INPUTS,
    STEP_SIZE = MODEL_GIVEN - 1
};

/* Modes of the standard's state machine; one bit each, so that sets of them can be written. */
typedef enum {
    INSTANTIATED = 1, INITIALIZATION = 2, EVENT = 4, CONTINUOUS_TIME = 8, STEP = 16, TERMINATED = 32
} Mode;

#define INITIALIZED (EVENT | CONTINUOUS_TIME | STEP)
#define COMPUTABLE (INITIALIZATION | INITIALIZED | TERMINATED)
#define ANY (INSTANTIATED | COMPUTABLE)

/* What GetFMUState saves: all that changes after an instance is made. */
typedef struct {
    double given[MODEL_GIVEN];
    Mode mode;
    bool left;  /* the domain of the model, and said so */
} State;

typedef struct {
    State state;
    bool co_simulation;
    fmi3InstanceEnvironment environment;
    fmi3LogMessageCallback log;
} Instance;

/* Say what is wrong, in printf's words, through the importer's logger; returns the status. */
fmi3Status OWN(report)(const Instance *instance, fmi3Status status, const char *format, ...);

/* Whether a function may be called in the present mode; where not, it has been reported. */
bool OWN(allowed)(const Instance *instance, const char *function, unsigned modes);

/* All that is wanted, at the given values: fmi3OK, or fmi3Error and reported. */
fmi3Status OWN(compute)(const Instance *instance, const double *given, double *wanted);

/* Report a status of the model's functions: fmi3OK for MODEL_OK. */
fmi3Status OWN(judge)(const Instance *instance, int code, double time);

/* Whether a condition of validity does not hold at what was computed; says so the first time. */
bool OWN(outside)(Instance *instance, const double *wanted);

/* Name of the variable with a value reference. */
const char *OWN(name)(fmi3ValueReference reference);

#endif /* FMU_H */

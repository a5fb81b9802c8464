/*
 * Compiled functions as callables of Python that touch arrays directly: head.c, caller.c, bound.c,
 * states.c and module.c, compiled as one.
 *
 * A kernel is void (*)(const double *const *, double *const *): pointers to the inputs and outputs
 * that have entries, in order. The interpreter's lock is released while it runs.
 */
#define PY_SSIZE_T_CLEAN
#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#include <Python.h>
#include <structmember.h>
#include <numpy/arrayobject.h>
#include <math.h>

#define MOST 12
#define SCRATCH 256

typedef void (*Kernel)(const double *const *, double *const *);

"""C around a generated function: one call integrates over all wanted times.

steps(count, t, h, y, inputs, p)     takes steps in place; gives the number of evaluations of
                                     the right-hand side, negative where it gave up
"""

import ctypes
from collections.abc import Callable

import numpy as np

from mechanics.compiled.machine.native import affordable, load
from mechanics.compiled.right_hand_side import INNER, Compiled
from mechanics.program.routine import Routine
from mechanics.simulate.integrators.loop import NOT_FINITE, plan, stopped
from mechanics.simulate.integrators.problem import Outcome, Problem, Setting

HEAD = """\
static long long steps(long long count, @ t, @ h, @ *y, @ *inputs, const @ *p)
{
    (void)t; (void)inputs; (void)p;"""
RUN = """
long long mechanics_run(long long spans, const long long *count, const @ *t, const @ *h, @ *y,
    @ *inputs, const @ *p, @ *states, long long *spent)
{
    for (long long i = 0; i < spans; ++i) {
        const long long taken = steps(count[i], t[i], h[i], y, inputs, p);
        *spent += taken < 0 ? -taken : taken;
        if (taken < 0)
            return i;
        for (int n = 0; n < SIZE; ++n)
            states[i * SIZE + n] = y[n];
    }
    return spans;
}
"""


def compiled_march(
    name: str, problem: Problem, setting: Setting, code: Compiled, body: str, failure: str = ""
) -> Callable[[], Outcome]:
    """A call that integrates, from a program and the C of a loop over steps that calls it.

    Parameters
    ----------
    code : Compiled
        The function that the loop calls, written by `call_inner`.
    body : str
        Statements of ``steps``, with @ for the type of the numbers, SIZE for the number of entries
        of the state, and ``TIME(x);`` where the time among the inputs is set.
    failure : str
        What it means when that gave up.
    """
    kind, size = setting.kind, len(problem.start)
    library = _library(problem, kind, code, body)
    run = library.mechanics_run
    run.restype, run.argtypes = ctypes.c_longlong, [ctypes.c_longlong, *[ctypes.c_void_p] * 8]
    steps = plan(problem.times, setting.step or 0.0)
    spans = len(steps)
    count = np.array([count for count, _ in steps], dtype=np.int64)
    lengths, inputs = [h for _, h in steps], problem.signals(0.0)
    given = (problem.times[:-1], lengths, problem.start, inputs, problem.p)
    t, h, start, w, p = (np.array(array, dtype=kind) for array in given)

    def solve() -> Outcome:
        y, states = start.copy(), np.empty((spans, size), kind)
        spent = np.zeros(1, dtype=np.int64)
        arrays = (count, t, h, y, w, p, states, spent)
        done = int(run(spans, *(array.ctypes.data for array in arrays)))
        finite = np.all(np.isfinite(states[:done]), axis=1)
        reached = done if finite.all() else int(np.argmin(finite))
        words = ""
        if reached < spans:
            words = stopped(name, t[reached], failure if reached == done else NOT_FINITE)
        found = np.vstack([problem.start, states[:reached].astype(float)])
        return Outcome(found, int(spent[0]), words)

    return solve


def _library(
    problem: Problem, kind: type[np.floating], code: Compiled, body: str
) -> ctypes.CDLL:  # fmt: skip
    """The compiled loop; the same text is compiled once."""
    model, real = problem.model, "float" if kind is np.float32 else "double"
    timed = "t" in problem.varying
    time = f"inputs[{model.entries['inputs'].index('t')}] = (x)" if timed else "(void)(x)"
    text = "\n".join(
        [
            "#include <math.h>", "", f"#define TIME(x) {time}",
            f"enum {{ SIZE = {len(problem.start)} }};", "",
            code.inner(kind), HEAD, body, "}", RUN,
        ]
    )  # fmt: skip
    flags = affordable(model.flags, code.routine.operations)
    return load(text.replace("@", real), model.compiler or "", flags)


def call_inner(code: Routine, **arguments: str) -> str:
    """The call of the program with C expressions for its arrays; empty arrays are left out."""
    groups = [group for group, size in code.inputs if size]
    groups += [out for out, (rows, columns) in code.shapes if rows * columns]
    return f"{INNER}({', '.join(arguments[group] for group in groups)})"

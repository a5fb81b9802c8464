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
from mechanics.simulate.integrators.loop import NOT_FINITE, spans, stopped
from mechanics.simulate.integrators.problem import Outcome, Problem, Setting

HEAD = """\
static long long steps(long long count, @ t, @ h, @ *y, @ *inputs, const @ *p)
{
    (void)t; (void)inputs; (void)p;"""
RUN = """
long long mechanics_run(long long spans, const long long *count, const @ *t, const @ *h,
    const @ *rest, @ *y, @ *inputs, const @ *p, @ *states, long long *spent)
{
    for (long long i = 0; i < spans; ++i) {
        const long long taken = steps(count[i], t[i], h[i], y, inputs, p);
        *spent += taken < 0 ? -taken : taken;
        if (taken < 0)
            return i;
        @ *at = states + i * SIZE;
        for (int n = 0; n < SIZE; ++n)
            at[n] = y[n];
        if (rest[i] > 0 && steps(1, t[i] + (@)count[i] * h[i], rest[i], at, inputs, p) < 0)
            return i;
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
    run.restype, run.argtypes = ctypes.c_longlong, [ctypes.c_longlong, *[ctypes.c_void_p] * 9]
    steps = spans(problem, setting.step or 0.0)
    wanted = len(steps)
    count = np.array([span.count for span in steps], dtype=np.int64)
    columns = ([getattr(span, name) for span in steps] for name in ("begin", "step", "rest"))
    given = (*columns, problem.start, problem.signals(0.0), problem.p)
    t, h, rest, start, w, p = (np.array(array, dtype=kind) for array in given)

    def solve() -> Outcome:
        y, states = start.copy(), np.empty((wanted, size), kind)
        spent = np.zeros(1, dtype=np.int64)
        arrays = (count, t, h, rest, y, w, p, states, spent)
        done = int(run(wanted, *(array.ctypes.data for array in arrays)))
        finite = np.all(np.isfinite(states[:done]), axis=1)
        reached = done if finite.all() else int(np.argmin(finite))
        words = ""
        if reached < wanted:
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

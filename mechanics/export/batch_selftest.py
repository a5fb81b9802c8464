"""NAME_batch_selftest.c: every batch function at many states, against enclosed values.

The test vectors are those of `mechanics.export.vectors`, with parameters that all states share.
State i has vector i modulo their number, so neighbours differ; there are more states than fill a
block, the last vector is not full, and no array is aligned. What lies beside the states must stay.
"""

from collections.abc import Callable, Iterator, Sequence

from mechanics.compiled.c.batch import BLOCK
from mechanics.compiled.c.lanes import SHARED
from mechanics.compiled.c.status import wrapped
from mechanics.export.header import comment
from mechanics.export.precision import Part
from mechanics.export.selftest import table
from mechanics.export.vectors import Vector
from mechanics.program.routine import Routine

COUNT = BLOCK + 5
"""States: a whole block and a few."""
STRIDE = COUNT + 2

TOP = """\
/*
 * Self-test of the functions of many states: {scene}.
 *
 * State i has test vector i modulo their number; expected values and tolerances as in
 * {prefix}_selftest.c. Prints what fails; exit code 0 or 1.
 */
#include "{prefix}_batch.h"

#include <math.h>
#include <stdio.h>

enum {{ COUNT = {count}, STRIDE = {stride}, MARK = 77 }};

/* Entry k of state i from a table with one row a vector; without it, marks to be written over. */
static void spread(int size, int vectors, const {kind} *table, {kind} *array)
{{
    for (int k = 0; k < size; ++k)
        for (int i = 0; i < STRIDE; ++i)
            array[k * STRIDE + i] = table ? table[i % vectors * size + k] : MARK;
}}

static int check(const char *what, int size, int vectors, const {kind} *got, const {kind} *expected,
    const {kind} *tolerance)
{{
    int failures = 0;
    for (int k = 0; k < size; ++k) {{
        for (int i = 0; i < STRIDE; ++i) {{
            const {kind} found = got[k * STRIDE + i];
            const int at = i % vectors * size + k;
            const {kind} wanted = i < COUNT ? expected[at] : MARK;
            if (!({fabs}(found - wanted) <= (i < COUNT ? tolerance[at] : 0))) {{
                printf("%s, state %d, entry %d: {printed} found, {printed} expected\\n", what, i, k,
                    (double)found, (double)wanted);
                ++failures;
            }}
        }}
    }}
    return failures;
}}
"""


def batch_selftest(
    scene: str,
    part: Part,
    names: Sequence[str],
    program: Callable[[str], Routine],
    states: Callable[[str], Sequence[Vector]],
) -> str:
    """Text of the program; arguments as for `mechanics.export.selftest.selftest`."""
    top = TOP.format(
        scene=comment(scene), prefix=part.prefix, kind=part.kind,
        count=COUNT, stride=STRIDE, printed=part.printed,
        fabs=f"fabs{part.suffix}",
    )  # fmt: skip
    tests = []
    for name in names:
        tests.append("\n".join(_test(program(name), part, name, states(name))) + "\n")
    calls = [f"    failures += test_{name}();" for name in names]
    end = [
        "int main(void)", "{", "    int failures = 0;", *calls,
        f'    printf("{part.prefix}_batch: %d failures\\n", failures);',
        "    return failures > 0;", "}", "",
    ]  # fmt: skip
    return "\n".join([top, *tests, *end])


def _test(code: Routine, part: Part, name: str, states: Sequence[Vector]) -> Iterator[str]:
    count = len(states)
    given = [(i, group, size) for i, (group, size) in enumerate(code.inputs) if size]
    asked = [(i, out, rows * cols) for i, (out, (rows, cols)) in enumerate(code.shapes)]
    asked = [each for each in asked if each[2]]
    yield f"static int test_{name}(void)"
    yield "{"
    for i, group, _ in given:
        rows = [state.inputs[i] for state in states]
        yield from table(part.kind, f"{group}_in", rows[:1] if group in SHARED else rows)
    for i, out, _ in asked:
        yield from table(part.kind, f"{out}_expected", [state.expected[i] for state in states])
        yield from table(part.kind, f"{out}_tolerance", [state.tolerance[i] for state in states])
    moving = [(group, size) for _, group, size in given if group not in SHARED]
    # One more than is needed: the arrays begin at the second.
    for array, size in [*moving, *((out, size) for _, out, size in asked)]:
        yield f"    static {part.kind} {array}[{size} * STRIDE + 1];"
    for group, size in moving:
        yield f"    spread({size}, {count}, {group}_in[0], {group} + 1);"
    for _, out, size in asked:
        yield f"    spread({size}, {count}, NULL, {out} + 1);"
    arguments = [f"{group}_in[0]" if group in SHARED else f"{group} + 1" for _, group, _ in given]
    arguments += [f"{out} + 1" for _, out, _ in asked]
    call = f"{part.prefix}_{name}_batch(COUNT, STRIDE, {', '.join(arguments)})"
    yield from wrapped(f"int failures = {call} != 0;", "    ")
    for _, out, size in asked:
        what = f"{name}_batch {out}"
        tables = f"{out}_expected[0], {out}_tolerance[0]"
        text = f'failures += check("{what}", {size}, {count}, {out} + 1, {tables});'
        yield from wrapped(text, "    ")
    yield "    return failures;"
    yield "}"

"""The self-test: a C program that calls every function at a few states and compares.

Inputs, expected values and tolerances are hexadecimal floats, so no digit is lost in print. See
`mechanics.export.vectors` for where the values come from.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence

from mechanics.compiled.c.source import literal
from mechanics.compiled.c.status import wrapped
from mechanics.compiled.programs.hoist import CONSTANTS, PREPARE, PREPARED
from mechanics.compiled.programs.of_model import PARTS, WHOLE
from mechanics.export.header import comment
from mechanics.export.precision import Part
from mechanics.export.vectors import BITS, ROOM, Vector
from mechanics.program.routine import Routine

TOP = """\
/*
 * Self-test: {scene}.
 *
 * Expected values are enclosed with {bits} binary digits and rounded to the nearest {kind}. The
 * tolerance is {room} times what the roundings of the operations can add up to in this precision,
 * rounded up to a power of two. Prints what fails; exit code 0 or 1.
 */
#include "{prefix}.h"

#include <math.h>
#include <stdio.h>

static int check(const char *what, int state, int size, const {kind} *got, const {kind} *expected,
    const {kind} *tolerance)
{{
    int failures = 0;
    for (int i = 0; i < size; ++i) {{
        if (!({fabs}(got[i] - expected[i]) <= tolerance[i])) {{
            printf("%s, state %d, entry %d: {printed} found, {printed} expected\\n", what, state, i,
                (double)got[i], (double)expected[i]);
            ++failures;
        }}
    }}
    return failures;
}}

static int check_status(const char *what, int state, int status)
{{
    if (status != {ok})
        printf("%s, state %d: status %d found, {ok} expected\\n", what, state, status);
    return status != {ok};
}}
"""


def selftest(
    scene: str,
    part: Part,
    names: Sequence[str],
    program: Callable[[str], Routine],
    states: Callable[[str], Sequence[Vector]],
) -> str:
    """Text of the self-test program.

    Parameters
    ----------
    scene : str
        Its name.
    names : sequence of str
        Functions.
    program, states : callables
        Give the program of a function and its test vectors.
    """
    top = TOP.format(
        scene=comment(scene), bits=BITS[0], room=ROOM, prefix=part.prefix,
        ok=part.codes.ok, kind=part.kind, digits=part.digits, printed=part.printed,
        fabs=f"fabs{part.suffix}",
    )  # fmt: skip
    parts = [top]
    # The two parts of a function are called at its states, one after the other.
    wholes = [name for name in names if name not in PARTS]
    tested = wholes if len(wholes) == len(names) else dict.fromkeys([*wholes, WHOLE])
    for name in tested:
        parts.append("\n".join(_test(program, part, name, names, states(name))) + "\n")
    parts += ["int main(void)", "{", "    int failures = 0;"]
    parts += [f"    failures += test_{name}();" for name in tested]
    parts.append(f'    printf("{part.prefix}: %d failures\\n", failures);')
    return "\n".join([*parts, "    return failures > 0;", "}", ""])


def _test(
    program: Callable[[str], Routine], part: Part, name: str, names: Sequence[str],
    states: Sequence[Vector],
) -> Iterator[str]:  # fmt: skip
    code = program(name)
    sizes = [rows * cols for _, (rows, cols) in code.shapes]
    count = len(states)
    yield f"static int test_{name}(void)"
    yield "{"
    for i, (group, size) in enumerate(code.inputs):
        if size:
            yield from table(part.kind, f"{group}_in", [state.inputs[i] for state in states])
    for i, (out, _) in enumerate(code.shapes):
        if sizes[i]:
            yield from table(part.kind, f"{out}_expected", [state.expected[i] for state in states])
            yield from table(
                part.kind, f"{out}_tolerance", [state.tolerance[i] for state in states]
            )
    yield "    int failures = 0, status;"
    yield f"    for (int i = 0; i < {count}; ++i) {{"
    outs = [(out, size) for (out, _), size in zip(code.shapes, sizes, strict=True) if size]
    for out, size in outs:
        yield f"        {part.kind} {out}[{size}];"
    arguments = {group: f"{group}_in[i]" for group, size in code.inputs if size}
    if name in names:
        yield from _call(part, name, arguments, outs)
    if name == WHOLE and PREPARE in names:
        ((_, (size, _)),) = program(PREPARE).shapes
        yield f"        {part.kind} {CONSTANTS}[{size}];"
        yield from _call(part, PREPARE, {"p": arguments["p"]}, [(CONSTANTS, size)], False)
        yield from _call(part, f"{name}{PREPARED}", {**arguments, "p": CONSTANTS}, outs)
    yield "    }"
    yield "    return failures;"
    yield "}"


def _call(
    part: Part,
    name: str,
    arguments: Mapping[str, str],
    outs: Sequence[tuple[str, int]],
    known: bool = True,
) -> Iterator[str]:
    """Call a function and check its status, and its outputs where what to expect is known."""
    given = ", ".join([*arguments.values(), *(out for out, _ in outs)])
    yield from wrapped(f"status = {part.prefix}_{name}({given});", "        ")
    yield f'        failures += check_status("{name}", i, status);'
    for out, size in outs if known else ():
        what = name if len(outs) == 1 else f"{name} {out}"
        yield from wrapped(
            f'failures += check("{what}", i, {size}, {out}, {out}_expected[i],'
            f" {out}_tolerance[i]);",
            "        ",
        )


def table(kind: str, name: str, rows: Sequence[Sequence[float]]) -> Iterator[str]:
    """A table of numbers, one row a state."""
    yield f"    static const {kind} {name}[{len(rows)}][{len(rows[0])}] = {{"
    for row in rows:
        numbers = ", ".join(literal(value, kind) for value in row)
        yield from wrapped(f"{{{numbers}}},", "        ")
    yield "    };"

"""C99 that calls a batch function with arrays of any strides, block by block.

    entry k of state i = array[i * state + k * entry]

Where the states of every array are side by side and the entries of all equally far apart, the loop
runs over the arrays themselves. Otherwise a block of each is copied into a small local array, in
which they are, and the results are copied back: (batch, n) arrays are turned without a full copy.
"""

from collections.abc import Sequence

from mechanics.compiled.c.lanes import SHARED, wrapped
from mechanics.program.routine import Routine

LOCAL = 24_576
"""Bytes that the local arrays may have, about: half of a usual first cache."""
FEWEST, MOST = 16, 256
"""States in a block."""


def strided_source(code: Routine, kind: str, name: str, shared: Sequence[str] = SHARED) -> str:
    """Definition of ``int name_strided(...)``; the batch function ``name`` stands before.

    Its arrays are ``arg`` and ``res``, those without entries left out, and ``steps`` with the state
    and entry strides of one after the other, in numbers, not bytes; of shared ones the entries are
    next to each other.
    """
    given = [(group, size) for group, size in code.inputs if size]
    asked = [(out, rows * cols) for out, (rows, cols) in code.shapes if rows * cols]
    moving = [(i, group, size) for i, (group, size) in enumerate(given) if group not in shared]
    lanes = block(code, kind, shared)
    call = [f"arg[{i}]" if g in shared else f"{g}_" for i, (g, _) in enumerate(given)]
    call += [f"{out}_" for out, _ in asked]

    def copied(how: str, pointer: str, at: int, name: str, size: int) -> list[str]:
        first, steps = f"{pointer} + (ptrdiff_t)i * steps[{2 * at}]", f"steps + {2 * at}"
        return wrapped(f"mechanics_{how}(lanes, {lanes}, {size}, {first}, {steps}, {name}_);", _IN)

    return "\n".join([
        _COPIES.format(kind=kind),
        f"int {name}_strided(size_t count, const {kind} *const *arg, {kind} *const *res,",
        "    const ptrdiff_t *steps)",
        "{",
        *(f"    {kind} {group}_[{size * lanes}];" for _, group, size in moving),
        *(f"    {kind} {out}_[{size * lanes}];" for out, size in asked),
        *_side_by_side(code, name, shared),
        "    int found = 0;",
        f"    for (size_t i = 0; i < count; i += {lanes}) {{",
        f"        const size_t lanes = count - i < {lanes} ? count - i : {lanes};",
        *(line for i, g, size in moving for line in copied("gather", f"arg[{i}]", i, g, size)),
        *wrapped(f"found |= {name}(lanes, {lanes}, {', '.join(call)});", _IN),
        *(
            line
            for i, (out, size) in enumerate(asked)
            for line in copied("scatter", f"res[{i}]", len(given) + i, out, size)
        ),
        "    }",
        "    return found;",
        "}",
        "",
    ])  # fmt: skip


def _side_by_side(code: Routine, name: str, shared: Sequence[str]) -> list[str]:
    """C that calls the batch function with the arrays themselves where it can read them."""
    given = [(group, size) for group, size in code.inputs if size]
    asked = [(out, rows * cols) for out, (rows, cols) in code.shapes if rows * cols]
    moving = [(i, s) for i, (g, s) in enumerate((*given, *asked)) if g not in shared]
    apart = [i for i, size in moving if size > 1]
    stride = f"steps[{2 * apart[0] + 1}]" if apart else "1"
    tests = [f"steps[{2 * i}] == 1" for i, _ in moving]
    tests += [f"steps[{2 * i + 1}] == stride" for i in apart[1:]]
    every = [f"arg[{i}]" for i in range(len(given))] + [f"res[{i}]" for i in range(len(asked))]
    return [
        f"    const ptrdiff_t stride = {stride};",
        *wrapped(f"if (stride >= 0 && {' && '.join(tests)})", "    ", " "),
        *wrapped(f"return {name}(count, (size_t)stride, {', '.join(every)});", _IN),
    ]


def block(code: Routine, kind: str, shared: Sequence[str] = SHARED) -> int:
    """States in a block."""
    sizes = [size for group, size in code.inputs if group not in shared]
    sizes += [rows * cols for _, (rows, cols) in code.shapes]
    most = LOCAL // (max(sum(sizes), 1) * (4 if kind == "float" else 8))
    return max(FEWEST, min(MOST, most // FEWEST * FEWEST))


_IN = "        "
# With the strides of a contiguous array known to it, the compiler turns whole vectors.
_COPIES = """\
static inline void mechanics_gather(size_t count, size_t lanes, size_t size, const {kind} *from,
    const ptrdiff_t *steps, {kind} *restrict to)
{{
    if (steps[0] == (ptrdiff_t)size && steps[1] == 1) {{
        for (size_t i = 0; i < count; ++i)
            for (size_t k = 0; k < size; ++k)
                to[k * lanes + i] = from[i * size + k];
    }} else {{
        for (size_t k = 0; k < size; ++k)
            for (size_t i = 0; i < count; ++i)
                to[k * lanes + i] = from[(ptrdiff_t)i * steps[0] + (ptrdiff_t)k * steps[1]];
    }}
}}

static inline void mechanics_scatter(size_t count, size_t lanes, size_t size, {kind} *to,
    const ptrdiff_t *steps, const {kind} *restrict from)
{{
    if (steps[0] == (ptrdiff_t)size && steps[1] == 1) {{
        for (size_t i = 0; i < count; ++i)
            for (size_t k = 0; k < size; ++k)
                to[i * size + k] = from[k * lanes + i];
    }} else {{
        for (size_t k = 0; k < size; ++k)
            for (size_t i = 0; i < count; ++i)
                to[(ptrdiff_t)i * steps[0] + (ptrdiff_t)k * steps[1]] = from[k * lanes + i];
    }}
}}
"""

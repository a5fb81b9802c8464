"""NAME_batch.h and NAME_batch.c: functions of many states at once, which compilers vectorise.

    NAME_forward_dynamics_batch(count, stride, q, u, p, ud)      q[k * stride + i]: entry k, state i

The loops are those of `mechanics.compiled.c.batch`, with the sine and cosine of NAME_sine.h; the
scalar functions stand in where an angle is too large for these.
"""

from collections.abc import Sequence

from mechanics.compiled.c.batch import batch_source
from mechanics.compiled.c.lanes import FAR, SHARED, WILD, arguments, wrapped
from mechanics.compiled.c.sine import LIMIT
from mechanics.export.contents import Contents
from mechanics.export.functions import about
from mechanics.export.header import comment
from mechanics.export.precision import Part, careful

BATCHED = ("forward_dynamics", "coordinate_rates", "energy")
"""Functions that ensembles of motions need. Others are long, and compilers take long for them."""

TOP = """\
/*
 * Functions of many states at once: {scene}.
 *
 * Structure of arrays: entry k of state i is array[k * stride + i], with stride >= count. All
 * states share {shared}. {prefix}.h has the order and unit of every entry. Arrays need not be
 * aligned; an output must not overlap an input.
 *
 * Every function returns 0, or a sum of
 *   {far}  in some state an angle is beyond {limit} rad, or no number: such states, and only
 *      they, are given to the scalar function, which has sine and cosine of the C library
 *   {wild}  in some state a value is not finite: the status of the scalar function says why
 */
#ifndef {guard}_BATCH
#define {guard}_BATCH

#include "{prefix}.h"

#include <stddef.h>

#define {macro}_BATCH_FAR {far}
#define {macro}_BATCH_NOT_FINITE {wild}

#ifdef __cplusplus
extern "C" {{
#endif

{prototypes}
#ifdef __cplusplus
}}
#endif

#endif /* {guard}_BATCH */
"""


def batched(names: Sequence[str]) -> tuple[str, ...]:
    """Those of the functions that are written for many states, too."""
    return tuple(name for name in names if name in BATCHED)


def batch_header(contents: Contents, part: Part, names: Sequence[str]) -> str:
    """Text of the header."""
    prototypes = []
    for name in names:
        head = f"int {part.prefix}_{name}_batch({arguments(contents.programs[name], part.kind)});"
        prototypes.append("\n".join([about(contents.programs[name], name), *wrapped(head, ""), ""]))
    return TOP.format(
        scene=comment(contents.scene), prefix=part.prefix, macro=part.macro,
        guard=part.guard, prototypes="\n".join(prototypes), far=FAR, wild=WILD,
        limit=f"{LIMIT:.0f}", shared=" and ".join(SHARED),
    )  # fmt: skip


def batch_implementation(contents: Contents, part: Part, names: Sequence[str]) -> str:
    """The C file."""
    lines = [
        f"/* {comment(contents.scene)}: many states at once. */", "",
        f'#include "{part.prefix}_batch.h"', f'#include "{part.prefix}_sine.h"', "",
        "#include <math.h>", "", careful(part.macro).rstrip(),
    ]  # fmt: skip
    written = ["\n".join(lines) + "\n"]
    for name in names:
        own = f"{part.prefix}_{name}"
        code = contents.programs[name]
        written.append(
            batch_source(
                code, contents.names(name), part.kind, f"{own}_batch", scalar=own, checked=True
            )
        )
    return "\n".join(written)

"""NAME_sine.h: sine and cosine without a library, for the C files of the folder.

Functions of many states always use them. The others do where the macro NAME_INLINE_SINE is defined,
and then need nothing of the C library at all; an angle that is too large gives no number, which the
status tells.
"""

from mechanics.compiled.c.sine import LIMIT, sine_source
from mechanics.export.precision import Part

TEXT = """\
/*
 * Sine and cosine that a compiler makes inline and vectorises; for the C files of this folder only.
 *
 * Valid up to {limit} rad. mechanics_sin{f} and mechanics_cos{f} give no number beyond.
 */
#ifndef {guard}_SINE
#define {guard}_SINE

#include <math.h>
#include <stdint.h>

{source}
static inline {kind} mechanics_sin{f}({kind} x)
{{
    {kind} sine, cosine;
    mechanics_sincos{f}(x, &sine, &cosine);
    return mechanics_far{f}(x) ? ({kind})NAN : sine;
}}

static inline {kind} mechanics_cos{f}({kind} x)
{{
    {kind} sine, cosine;
    mechanics_sincos{f}(x, &sine, &cosine);
    return mechanics_far{f}(x) ? ({kind})NAN : cosine;
}}

#endif /* {guard}_SINE */
"""

CHOICE = """\
#ifdef {macro}_INLINE_SINE
#include "{prefix}_sine.h"
#define sin{f} mechanics_sin{f}
#define cos{f} mechanics_cos{f}
#endif
"""


def sine_header(part: Part) -> str:
    """Text of the header."""
    return TEXT.format(
        guard=part.guard, kind=part.kind, f=part.suffix, limit=f"{LIMIT:.0f}",
        source=sine_source(part.kind),
    )  # fmt: skip


def inline_choice(part: Part) -> str:
    """Lines of a C file that put it in place of the C library's where that is asked for."""
    return CHOICE.format(macro=part.macro, prefix=part.prefix, f=part.suffix)

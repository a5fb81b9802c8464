"""C99 from a program for a batch of states: the lanes of `lanes` in blocks.

The lanes function returns whether an angle was too large for the inline sine, or no number. The
batch function calls it for one block of states after the other, and gives the states that it could
not do to the scalar function, which has its sines from the C library. It returns what the lanes
and, where values are looked at, the scalar function have met: 0 where nothing of that kind has
happened.
"""

from collections.abc import Sequence

from mechanics.compiled.c.lanes import FAR, SHARED, WILD, arguments, lanes_source, wrapped
from mechanics.compiled.c.source import Entries
from mechanics.program.routine import Routine

BLOCK = 256
"""States in a block: few enough to stay in the first cache between two looks at them."""


def batch_source(
    code: Routine,
    entries: Entries,
    kind: str,
    name: str,
    *,
    scalar: str,
    shared: Sequence[str] = SHARED,
    checked: bool = False,
) -> str:
    """Definitions of ``name_lanes`` and of ``name``; `sine_source` and the scalar stand before.

    Parameters
    ----------
    entries : names of the entries of each input, for readable local variables
    kind : ``"double"`` or ``"float"``
    name : of the batch function
    scalar : name of the scalar function, with plain arrays; with `checked` it returns a status
    shared : inputs that all states have in common: ``p[k]``
    checked : whether to look for values that are not finite
    """
    lanes = lanes_source(code, entries, kind, name, shared, checked)
    return f"{lanes}\n{blocks_source(code, kind, name, scalar, shared, checked)}"


def blocks_source(
    code: Routine,
    kind: str,
    name: str,
    scalar: str,
    shared: Sequence[str] = SHARED,
    checked: bool = False,
) -> str:
    """Definition of ``int name(...)``: lanes in blocks, and what they could not do."""
    moving = [group for group, size in code.inputs if size and group not in shared]
    given = [(group, size) for group, size in code.inputs if size]
    asked = [(out, rows * cols) for out, (rows, cols) in code.shapes if rows * cols]
    every = [group for group, _ in given] + [out for out, _ in asked]

    def at(index: str) -> str:
        fixed = [group for group, _ in given if group not in moving]
        return ", ".join(g if g in fixed else f"{g} + {index}" for g in every)

    one = [group if group not in moving else f"{group}_" for group, _ in given]
    one += [f"{out}_" for out, _ in asked]
    return "\n".join([
        "/* The states whose angles are too large for the inline sine, by the C library. */",
        *wrapped(f"static {'int' if checked else 'void'} {name}_far({arguments(code, kind)})", ""),
        "{",
        *(["    int found = 0;"] if checked else []),
        "    for (size_t i = 0; i < count; ++i) {",
        *wrapped(f"if (!({name}_lanes(1, stride, {at('i')}) & {FAR}))", "        "),
        "            continue;",
        *(f"        {kind} {g}_[{size}];" for g, size in (*given, *asked) if g not in shared),
        *(x for g, size in given if g in moving for x in _copied(f"{g}_[k] = {g}[{_AT}]", size)),
        *wrapped(f"{'const int status = ' * checked}{scalar}({', '.join(one)});", "        "),
        *(x for g, size in asked for x in _copied(f"{g}[{_AT}] = {g}_[k]", size)),
        *([f"        found |= status != 0 ? {WILD} : 0;"] if checked else []),
        "    }",
        *(["    return found;"] if checked else []),
        "}",
        "",
        *wrapped(f"int {name}({arguments(code, kind)})", ""),
        "{",
        "    int found = 0;",
        f"    for (size_t i = 0; i < count; i += {BLOCK}) {{",
        f"        const size_t lanes = count - i < {BLOCK} ? count - i : {BLOCK};",
        *wrapped(f"const int flags = {name}_lanes(lanes, stride, {at('i')});", "        "),
        "        found |= flags;",
        f"        if (flags & {FAR})",
        *wrapped(
            f"{'found |= ' * checked}{name}_far(lanes, stride, {at('i')});", "            "
        ),
        "    }",
        "    return found;",
        "}",
        "",
    ])  # fmt: skip


_AT = "k * stride + i"


def _copied(assignment: str, size: int) -> list[str]:
    return [f"        for (size_t k = 0; k < {size}; ++k)", f"            {assignment};"]

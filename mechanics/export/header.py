"""The C header: sizes, the order and unit of every array entry, and the prototypes."""

from collections.abc import Iterator, Sequence

from mechanics.compiled.c.sine import LIMIT
from mechanics.compiled.c.source import signature
from mechanics.compiled.c.status import Codes
from mechanics.compiled.programs.of_model import PARTS
from mechanics.compiled.quantities import Quantity
from mechanics.export.contents import ARRAYS, Contents
from mechanics.export.functions import about
from mechanics.export.precision import Part
from mechanics.program.c_printer import CALLS


def header(contents: Contents, part: Part) -> str:
    """Text of the header."""
    guard = part.guard
    top = f"""\
/*
 * Equations of motion: {comment(contents.scene)}, derived by {comment(contents.route)}.
 *
 * C99, no allocation, no global state: every function may be called from any thread. SI units.
 * Matrices are stored column by column. All inputs are read before the first output is written,
 * so an output may be the same array as an input of its size.
 *
 * Every function returns a status, and writes its outputs whatever it is. Nothing traps. The C
 * files refuse -ffast-math, which takes the check for infinity away; what is shown of them does not
 * hold with it. {part.macro}_ALLOW_FAST_MATH compiles them all the same.
 *
{library_calls(contents, part)}{shared_divisors(contents)}{fixed_values(contents)} */
#ifndef {guard}
#define {guard}
"""
    sections = [top, statuses(part.codes)]
    for array, entries in contents.arrays.items():
        sections.append("\n".join(array_section(contents, part, array, entries)) + "\n")
    sections.append('#ifdef __cplusplus\nextern "C" {\n#endif\n')
    for name, code in contents.programs.items():
        prototype = signature(code, part.kind, f"{part.prefix}_{name}", "int")
        sections.append(f"{about(code, name)}\n{prototype};\n")
    sections.append(f"#ifdef __cplusplus\n}}\n#endif\n\n#endif /* {guard} */\n")
    return "\n".join(sections)


def library_calls(contents: Contents, part: Part) -> str:
    """Lines of a comment that say what the functions need of the C library."""
    called: set[str] = set()
    for code in contents.programs.values():
        for node in code.nodes:
            if node.operation in CALLS:
                called.add(CALLS[node.operation] + part.suffix)
    if not called:
        return " * Nothing of the C library is called.\n"
    lines = [f" * Of the C library they call {', '.join(sorted(called))}."]
    own = sorted({f"sin{part.suffix}", f"cos{part.suffix}"} & called)
    if own:
        lines[0] += f" With the macro {part.macro}_INLINE_SINE"
        lines += [
            f" * defined, {' and '.join(own)} are those of {part.prefix}_sine.h instead: up to"
            f" {LIMIT:.0f} rad, with",
            " * status 2 beyond, and an error of less than 2 units in the last place.",
        ]
    return "\n".join(lines) + "\n"


def shared_divisors(contents: Contents) -> str:
    """Lines of a comment that say what was done to quotients; empty where nothing was."""
    programs, before = contents.programs, contents.divisions
    after = sum(code.divisions for name, code in programs.items() if name not in PARTS)
    if after == before:
        return ""
    return (
        f" * Quotients by one divisor share a division, {after} instead of {before}, and are\n"
        " * products with the reciprocal: off by at most 1.5 units in the last place, not 0.5.\n"
    )


def statuses(names: Codes) -> str:
    """Their definitions."""
    meanings = (
        (names.ok, "every output is a number"),
        (names.singular, "a divisor is zero: the mass matrix is singular, or too small to tell"),
        (names.overflow, "a value is beyond the largest number"),
        (names.bad_input, "an input is infinite or no number"),
    )
    rows = [f" *   {number}  {text}" for number, (_, text) in enumerate(meanings)]
    lines = [f"#define {name} {number}" for number, (name, _) in enumerate(meanings)]
    return "\n".join(["/* status", *rows, " */", *lines, ""])


def fixed_values(contents: Contents) -> str:
    """Lines of a comment that say which parameters are numbers; empty where none are."""
    if not contents.fixed:
        return ""
    lines = [" *\n * Fixed when this was generated, and no entry of p:\n"]
    for name, value in sorted(contents.fixed.items()):
        lines.append(f" *   {comment(name)} = {comment(value)}\n")
    return "".join(lines)


def array_section(
    contents: Contents, part: Part, array: str, entries: Sequence[Quantity]
) -> Iterator[str]:
    """Size of an array, and a table of its entries."""
    if entries:
        yield f"/* {ARRAYS[array]}"
        width = max(len(comment(entry.name)) for entry in entries)
        units = max(len(comment(entry.unit) or "-") for entry in entries)
        for i, entry in enumerate(entries):
            words = f"{comment(entry.meaning)}{_typical(contents, array, i)}".strip(" ,")
            row = f" *   {array}[{i}]  {comment(entry.name):{width}}  "
            yield f"{row}{comment(entry.unit) or '-':{units}}  {words}".rstrip()
        yield " */"
    yield f"#define {part.macro}_{array.upper()}_SIZE {len(entries)}"


def _typical(contents: Contents, array: str, index: int) -> str:
    known = array == "p" and contents.typical
    return f", typically {contents.typical[index]:.6g}" if known else ""


def comment(text: str) -> str:
    """Text that is safe inside a C comment: on one line, and neither opening nor closing one."""
    line = " ".join(text.split())
    return line.replace("*/", "* /").replace("/*", "/ *").replace("\\", "/").replace("??", "? ?")

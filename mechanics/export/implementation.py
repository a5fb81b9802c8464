"""NAME.c, and all C files and headers of one precision."""

from collections.abc import Sequence

from mechanics.compiled.c.source import function_source, signature
from mechanics.export.batch import batch_header, batch_implementation
from mechanics.export.contents import Contents
from mechanics.export.header import comment, header
from mechanics.export.precision import Part, careful
from mechanics.export.sine import inline_choice, sine_header


def code_files(contents: Contents, part: Part, many: Sequence[str]) -> dict[str, str]:
    """C of one precision but for its self-tests, by name of file.

    Parameters
    ----------
    many : sequence of str
        Functions that are there for many states, too.
    """
    files = {
        f"{part.prefix}.h": header(contents, part),
        f"{part.prefix}.c": implementation(contents, part),
        f"{part.prefix}_sine.h": sine_header(part),
    }
    if many:
        files[f"{part.prefix}_batch.h"] = batch_header(contents, part, many)
        files[f"{part.prefix}_batch.c"] = batch_implementation(contents, part, many)
    return files


def implementation(contents: Contents, part: Part) -> str:
    """The C file."""
    scene = comment(f"{contents.scene}, derived by {contents.route}")
    written = [
        f"/* {scene} */", "", f'#include "{part.prefix}.h"', "", "#include <math.h>", "",
        careful(part.macro), inline_choice(part),
    ]  # fmt: skip
    for name, code in contents.programs.items():
        head = signature(code, part.kind, f"{part.prefix}_{name}", "int")
        written.append(function_source(code, contents.names(name), part.kind, head, part.codes))
    return "\n".join(written)

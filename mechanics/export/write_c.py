"""A model as a folder of C99: ``write_c(model, folder)``.

    NAME.h             sizes, order and units of every array, one prototype a function
    NAME.c             the functions: plain arguments, no allocation, no global state
    NAME_selftest.c    a program that checks them against enclosed values, exit code 0 or 1
    CMakeLists.txt     a static library, and the self-test for ctest
    manifest.json      what was generated from what: hash of each file, operation counts, versions

The same printer makes the code that `mechanics.compiled` runs.
"""

from collections.abc import Sequence
from pathlib import Path

from mechanics.compiled import Model
from mechanics.compiled.c.names import identifier
from mechanics.compiled.c.source import function_source, signature
from mechanics.errors import InputError
from mechanics.export.header import codes, comment, header
from mechanics.export.manifest import manifest
from mechanics.export.selftest import selftest


def write_c(
    model: Model,
    folder: str | Path,
    *,
    name: str | None = None,
    functions: Sequence[str] | None = None,
) -> tuple[Path, ...]:
    """Write a model as C.

    Parameters
    ----------
    model : Model
    folder : str or Path
        Made if it does not exist; files of the same names are overwritten.
    name : str, optional
        Prefix of files and functions; by default the name of the scene.
    functions : sequence of str, optional
        Names of functions of the model; by default all.

    Returns
    -------
    tuple of Path
        The files written.

    Raises
    ------
    InputError
        If the folder is a file, the name is no C identifier, or there is no such function.
    SingularError
        If a function has no finite value at any of the states of the self-test.
    """
    prefix = identifier(model.equations.scene.name) if name is None else name
    if identifier(prefix) != prefix:
        raise InputError(
            f"name {prefix!r} is no C identifier that is free: {identifier(prefix)!r} would be one"
        )
    names = tuple(model.casadi) if functions is None else tuple(functions)
    target = Path(folder)
    if target.exists() and not target.is_dir():
        raise InputError(f"{target} is a file: name a folder to write the C files into")
    files = {
        f"{prefix}.h": header(model, prefix, names),
        f"{prefix}.c": implementation(model, prefix, names),
        f"{prefix}_selftest.c": selftest(model, prefix, names),
        "CMakeLists.txt": cmake(prefix),
    }
    files["manifest.json"] = manifest(model, prefix, names, files)
    target.mkdir(parents=True, exist_ok=True)
    for file, text in files.items():
        # The same bytes everywhere, whatever the machine takes for an end of line.
        (target / file).write_bytes(text.encode("utf-8"))
    return tuple(target / file for file in files)


def implementation(model: Model, prefix: str, names: Sequence[str]) -> str:
    """The C file."""
    scene = comment(f"{model.equations.scene.name}, derived by {model.equations.route}")
    parts = [f"/* {scene} */", "", f'#include "{prefix}.h"', "", "#include <math.h>", ""]
    for name in names:
        code = model.program(name)
        head = signature(code, name=f"{prefix}_{name}", result="int")
        parts.append(function_source(code, model.entries, head=head, codes=codes(prefix)))
    return "\n".join(parts)


CMAKE = """\
cmake_minimum_required(VERSION 3.13)
project(@ C)

add_library(@ STATIC @.c @.h)
target_include_directories(@ PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
set_target_properties(@ PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
if(CMAKE_C_COMPILER_ID MATCHES "GNU|Clang")
  # No fused operations: results are the same on every machine.
  target_compile_options(@ PRIVATE -Wall -Wextra -pedantic -ffp-contract=off)
endif()
if(UNIX)
  target_link_libraries(@ PUBLIC m)
endif()

enable_testing()
add_executable(@_selftest @_selftest.c)
set_target_properties(@_selftest PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
target_link_libraries(@_selftest PRIVATE @)
add_test(NAME @_selftest COMMAND @_selftest)
"""


def cmake(prefix: str) -> str:
    """The build file."""
    return CMAKE.replace("@", prefix)

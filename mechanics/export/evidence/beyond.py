"""What stands beside the files of a manifest: whether a compiler or a build system may read it.

The folder is on the path of includes, before the headers of the system: a math.h in it is read in
place of theirs, a cmath when C++ is compiled, a header in a folder bits, too. Python reads a module
beside the loader, or its compiled form. What nothing reads, notes or a folder of objects, changes
nothing about what was shown.
"""

import os
from pathlib import Path

SOURCES = (
    ".c", ".h", ".s", ".cc", ".cpp", ".cxx", ".hpp", ".hh", ".hxx", ".inc", ".inl", ".tcc",
    ".cmake", ".in", ".py", ".pth", ".so", ".gch", ".pch",
)  # fmt: skip
"""Ends of names that compilers, CMake, or Python beside the loader, look for."""
SCRIPTS = ("cmakelists.txt", "cmakepresets.json", "cmakeuserpresets.json", "toolchain.txt")
INSIDE = (".h", ".hpp", ".hh", ".hxx", ".inc", ".tcc", ".gch", ".pch", ".py")
"""The same in folders, where a build leaves files of its own."""
SYSTEM = ("asm", "asm-generic", "backward", "bits", "debug", "experimental", "ext", "gnu", "linux",
          "machine", "parallel", "pstl", "sys", "tr1")  # fmt: skip
"""Folders that headers of a system include from."""


def is_source(name: str) -> bool:
    """Whether a file of this name may be read by a build or by Python."""
    low = name.lower()
    # Headers of C++ have no end.
    plain = "." not in low
    return plain or low.endswith(SOURCES) or low in SCRIPTS


def may_be_read(entry: Path) -> bool:
    """Whether a build may read what stands there.

    Raises
    ------
    OSError
        If a folder cannot be looked into.
    """
    if not entry.is_dir():
        return is_source(entry.name)
    if entry.name.lower() in SYSTEM or entry.name == "__pycache__":
        return True
    # A link of a folder into itself is not followed.
    return any(
        name.lower().endswith(INSIDE)
        for _, _, names in os.walk(entry, onerror=_raised)
        for name in names
    )


def _raised(error: OSError) -> None:
    raise error

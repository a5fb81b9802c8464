"""How the folder is built and found: CMakeLists.txt, and the template of a pkg-config file.

cmake -S DIR -B build && cmake --build build && ctest --test-dir build && cmake --install build

find_package(NAME)  ->  NAME::NAME           pkg-config --cflags --libs NAME
"""

import re
from collections.abc import Sequence
from importlib.metadata import PackageNotFoundError, version
from importlib.resources import files

from mechanics.export.header import comment
from mechanics.export.precision import Part, choices


def build_files(scene: str, name: str, parts: Sequence[Part], batch: bool) -> dict[str, str]:
    """Text by name of file.

    Parameters
    ----------
    scene, name : str
        Names of the scene and of the library.
    parts : sequence of Part
        The precisions that are written.
    batch : bool
        Whether there are functions of many states.
    """
    words = {
        "TITLE": title(scene),
        "NAME": name,
        "MACRO": name.upper(),
        "VERSION": package_version(),
        "PARTS": "\n".join(_variables(name, part, batch) for part in parts),
        "PRECISION": choices(parts)[-1],
        "CHOICES": ", ".join(choices(parts)),
    }
    files = {
        "CMakeLists.txt": _filled("CMakeLists.txt", words),
        f"{name}.pc.in": _filled("package.pc.in", words),
    }
    return files | ({"vectorised.cmake": _filled("vectorised.cmake", words)} if batch else {})


def title(scene: str) -> str:
    """One line of plain characters that says what was generated."""
    text = comment(f"Equations of motion: {scene}")
    return re.sub(r"[^\w ,.:()-]", "_", text, flags=re.ASCII)


def package_version() -> str:
    """Version of the generator, as numbers with dots."""
    try:
        found = re.match(r"\d+(\.\d+){0,3}", version("mechanics"))
    except PackageNotFoundError:
        # A source tree that is used without being installed.
        found = None
    return found[0] if found else "0"


def _variables(name: str, part: Part, batch: bool) -> str:
    """CMake variables that hold the files of a part, without their ends."""
    many = f"{part.prefix}_batch" if batch else '""'
    own = f"{name}_{part.precision}"
    return f"set({own} {part.prefix})\nset({own}_batch {many})"


def _filled(template: str, words: dict[str, str]) -> str:
    """A template with @WORD@ replaced; what is not known stays, for CMake to replace."""
    text = files("mechanics.export").joinpath("templates", template).read_text(encoding="utf-8")
    return re.sub(r"@(\w+)@", lambda found: words.get(found[1], found[0]), text)

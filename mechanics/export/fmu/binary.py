"""The library of a unit for this machine: which platform it is, and how it is compiled."""

import platform
import sys
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from mechanics.compiled.machine.process import run, write_source
from mechanics.errors import CompilerError, InputError

OPTIONS = ("-std=c99", "-fPIC", "-fvisibility=hidden", "-ffp-contract=off",
           "-fno-math-errno")  # fmt: skip

MACHINES = {
    "x86_64": "x86_64", "amd64": "x86_64",
    "aarch64": "aarch64", "arm64": "aarch64",
    "i386": "x86", "i686": "x86", "x86": "x86",
}  # fmt: skip
SYSTEMS = {
    "Linux": ("linux", ".so"),
    "Windows": ("windows", ".dll"),
    "Darwin": ("darwin", ".dylib"),
}


@dataclass(frozen=True)
class Platform:
    """A platform in the words of FMI 3.0.

    Attributes
    ----------
    tuple : str
        ``"x86_64-linux"``.
    suffix : str
        Of shared libraries.
    """

    tuple: str
    suffix: str


def this_platform(machine: str | None = None, system: str | None = None) -> Platform:
    """The platform that this process runs on.

    Raises
    ------
    InputError
        If the standard, or this program, has no name for it.
    """
    machine, system = machine or platform.machine(), system or platform.system()
    if machine.lower() not in MACHINES or system not in SYSTEMS:
        raise InputError(
            f"platform {machine} {system}: FMI 3.0 units are compiled for"
            f" {', '.join(sorted(set(MACHINES.values())))} with {', '.join(SYSTEMS)}: write the"
            " sources only, with compiler=None, and compile them where they are used"
        )
    architecture, (name, suffix) = MACHINES[machine.lower()], SYSTEMS[system]
    if architecture == "x86_64" and sys.maxsize <= 2**32:
        architecture = "x86"
    return Platform(f"{architecture}-{name}", suffix)


def compiled_library(sources: Mapping[str, str], compiler: str, flags: str) -> bytes:
    """The shared library that a compiler makes of C files.

    Parameters
    ----------
    sources : mapping of str to str
        Text by file name.
    flags : str
        Settings after `OPTIONS`, such as ``"-O2"``.

    Raises
    ------
    CompilerError
        If the compiler refuses the code or cannot be run; the message carries its words.
    """
    with tempfile.TemporaryDirectory(prefix="mechanics-") as folder:
        for name, text in sources.items():
            write_source(Path(folder) / name, text)
        files = [f"{folder}/{name}" for name in sorted(sources) if name.endswith(".c")]
        command = [compiler, *OPTIONS, *flags.split(), "-shared", *files, "-o", f"{folder}/unit"]
        done = run([*command, "-lm"], Path(folder))
        if done.returncode != 0:
            words = (done.stderr or done.stdout).strip() or f"exit code {done.returncode}"
            raise CompilerError(
                f"C compiler {compiler} refused the unit: {words}\nset CC to another compiler, or"
                " pass compiler=None to write the sources only"
            )
        return (Path(folder) / "unit").read_bytes()

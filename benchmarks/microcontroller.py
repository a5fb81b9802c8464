"""What the single-precision functions of a model take on a Cortex-M4F, and that they are right.

Run ``python -m benchmarks.microcontroller [SYSTEM...]`` in the project's root. It writes the folder
that ``mechanics codegen --precision single`` writes, builds it for an STM32F405 with Debian's
gcc-arm-none-eabi and newlib, runs the self-test in QEMU, and prints for every function

    operations, bytes of its code in flash, bytes with all that it calls; bytes of its frame on the
    stack as the compiler counts it, and of all the stack that a call used in QEMU

once with sine and cosine of newlib, and once with those of the folder, which are inline.
"""

import argparse
import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from mechanics.cli.load import load
from mechanics.compiled import Model, compile
from mechanics.compiled.programs.hoist import PREPARE
from mechanics.crosscheck import derive
from mechanics.errors import CompilerError
from mechanics.export import write_c

EMBEDDED = Path(__file__).parent / "embedded"
TOOLS = {
    "arm-none-eabi-gcc": "gcc-arm-none-eabi libnewlib-arm-none-eabi",
    "qemu-system-arm": "qemu-system-arm",
    "cmake": "cmake",
    "make": "make",
}
"""Commands that are needed, and Debian's packages that have them."""

NAME = "kernel"
PREFIX = f"{NAME}_single"
STRICT = "-Werror;-Wall;-Wextra;-Wconversion;-Wdouble-promotion"
MEASURE = """\
/* How deep the stack gets in a call: what lies below it is painted before and looked at after. The
 * sine of a large angle takes more than that of a small one. */
#include "{prefix}.h"

#include <stdint.h>
#include <stdio.h>

enum {{ WORDS = 4096 }};
static const uint32_t paint = 0xA5A5A5A5u;
static const float angles[] = {{0.25f, 2.5f, 1e3f, 1e8f, 1e30f}};

{functions}
int main(void)
{{
{calls}    return 0;
}}
"""
FUNCTION = """\
__attribute__((noinline)) static int measured_{name}(void)
{{
{arrays}    volatile uint32_t *stack;
    __asm volatile("mov %0, sp" : "=r"(stack));
    int deepest = 0;
    for (unsigned k = 0; k < sizeof angles / sizeof *angles; ++k) {{
        for (unsigned i = 0; i < sizeof q / sizeof *q; ++i)
            q[i] = angles[k];
        for (int i = 1; i <= WORDS; ++i)
            stack[-i] = paint;
        (void){prefix}_{name}({arguments});
        int reached = WORDS;
        while (reached > deepest && stack[-reached] == paint)
            --reached;
        deepest = reached;
    }}
    return deepest * (int)sizeof *stack;
}}
"""


@dataclass(frozen=True)
class Taken:
    """What one function takes; sizes in bytes."""

    name: str
    operations: int
    flash: int
    flash_with_calls: int
    frame: int
    stack: int


@dataclass(frozen=True)
class Measured:
    """The functions of a model, and what its self-test says."""

    functions: tuple[Taken, ...]
    selftest: str


def missing_tools() -> list[str]:
    """Debian's packages that have to be installed first."""
    return [package for command, package in TOOLS.items() if shutil.which(command) is None]


def measured(model: Model, folder: Path, inline: bool = False) -> Measured:
    """Build for the microcontroller, test and measure.

    Parameters
    ----------
    folder : Path
        Of files that are made on the way.
    inline : bool
        Whether sine and cosine are those of the folder, not newlib's.

    Raises
    ------
    CompilerError
        If a tool is missing, the compiler refuses the code, or the self-test fails.
    """
    if packages := missing_tools():
        raise CompilerError(f"no cross compiler or emulator: install {' '.join(packages)}")
    code, build = folder / "c", folder / "build"
    write_c(model, code, name=NAME, precision="single", batch=False, prove=False)
    toolchain = f"-DCMAKE_TOOLCHAIN_FILE={EMBEDDED / 'cortex_m4f.cmake'}"
    options = [f"-D{NAME.upper()}_FLAGS={STRICT}", f"-D{NAME.upper()}_INLINE_SINE={inline}"]
    _run(["cmake", "-S", str(code), "-B", str(build), toolchain, *options])
    _run(["cmake", "--build", str(build)])
    said = _run(["ctest", "--test-dir", str(build), "--output-on-failure", "-V", "--timeout", "60"])
    verdict = re.search(rf"{PREFIX}: \d+ failures", said)
    if verdict is None:
        raise CompilerError(f"the self-test did not run to its end: {said}")
    (objects,) = build.rglob(f"{PREFIX}.c.obj")
    return Measured(tuple(_taken(model, folder, objects)), verdict[0])


def _taken(model: Model, folder: Path, objects: Path) -> Iterator[Taken]:
    sections = re.findall(
        rf"\.text\.{PREFIX}_(\w+) +(\d+)", _run(["arm-none-eabi-size", "-A", str(objects)])
    )
    own = {name: int(size) for name, size in sections}
    frames = objects.with_suffix(".su").read_text(encoding="utf-8")
    stack = _stack(model, folder, objects)
    for name in measured_names(model):
        frame = re.search(rf":{PREFIX}_{name}\t(\d+)\tstatic", frames)
        if frame is None:
            raise CompilerError(f"{name}: the compiler does not tell the size of its frame")
        reached = _reached(f"{PREFIX}_{name}", folder, objects)
        operations = model.program(name).operations
        yield Taken(name, operations, own[name], reached, int(frame[1]), stack[name])


def _reached(function: str, folder: Path, objects: Path) -> int:
    """Bytes in flash of a function and of all that it calls: nothing else is linked."""
    target = folder / function
    options = ["-nostartfiles", "-Wl,--gc-sections", f"-Wl,-e,{function}"]
    _run([*_compiler(), *options, str(objects), "-lm", "-o", str(target)])
    text, data = _run(["arm-none-eabi-size", str(target)]).splitlines()[1].split()[:2]
    return int(text) + int(data)


def _stack(model: Model, folder: Path, objects: Path) -> dict[str, int]:
    """Bytes of stack that a call of each function uses, all calls in it included."""
    program, source = folder / "measure", folder / "measure.c"
    names = measured_names(model)
    source.write_text(
        MEASURE.format(
            prefix=PREFIX,
            functions="\n".join(_measuring(model, name) for name in names),
            calls="".join(f'    printf("{n} %d\\n", measured_{n}());\n' for n in names),
        ),
        encoding="ascii",
    )
    _run([*linker(source, objects), f"-I{folder / 'c'}", "-o", str(program)])
    lines = _run([*emulator(), str(program)]).splitlines()
    return {name: int(size) for name, size in map(str.split, lines)}


def _measuring(model: Model, name: str) -> str:
    code, arrays, arguments = model.program(name), [], []
    for group, size in code.inputs:
        values = model.typical if group == "p" else [0.25] * size
        if size:
            numbers = ", ".join(f"{float(value)!r}f" for value in values)
            arrays.append(f"    static float {group}[] = {{{numbers}}};\n")
            arguments.append(group)
    for out, (rows, cols) in code.shapes:
        if rows * cols:
            arrays.append(f"    static float {out}[{rows * cols}];\n")
            arguments.append(out)
    return FUNCTION.format(
        name=name, prefix=PREFIX, arrays="".join(arrays), arguments=", ".join(arguments)
    )


def linker(*sources: Path) -> list[str]:
    """The command that makes a program for the board, but for its name."""
    linked = ["--specs=rdimon.specs", "-nostartfiles", "-T", str(EMBEDDED / "stm32f405.ld")]
    return [*_compiler(), *linked, str(EMBEDDED / "startup.c"), *map(str, sources), "-lm"]


def emulator() -> list[str]:
    """The command that runs a program, but for its name."""
    return _toolchain(r"set\(CMAKE_CROSSCOMPILING_EMULATOR (.*?)\)").split()


def _compiler() -> list[str]:
    """The compiler with the flags of the machine."""
    return ["arm-none-eabi-gcc", *_toolchain(r'CMAKE_C_FLAGS_INIT "([^"]*)"').split(), "-O2"]


def _toolchain(pattern: str) -> str:
    """What the toolchain file says."""
    text = (EMBEDDED / "cortex_m4f.cmake").read_text(encoding="utf-8")
    found = re.search(pattern, text, re.DOTALL)
    if found is None:
        raise CompilerError(f"cortex_m4f.cmake has no {pattern}")
    return found[1]


def _run(command: Sequence[str]) -> str:
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)
    if done.returncode != 0:
        raise CompilerError(f"{command[0]} failed:\n{done.stdout}{done.stderr}")
    return done.stdout


def measured_names(model: Model) -> tuple[str, ...]:
    """Functions of the state."""
    return tuple(name for name in model.programs.written() if name != PREPARE)


def rows(system: str, found: Measured) -> Iterator[str]:
    """Lines of a Markdown table."""
    for at in found.functions:
        numbers = (at.operations, at.flash, at.flash_with_calls, at.frame, at.stack)
        yield f"| {system} | `{at.name}` | {' | '.join(map(str, numbers))} |"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description="Sizes on a Cortex-M4F.")
    parser.add_argument("systems", nargs="*", default=["elastic_pendulum", "rocker"])
    systems = parser.parse_args().systems
    verdicts = []
    for inline, title in enumerate(("sine and cosine of newlib", "inline sine and cosine")):
        print(f"| {title} | function | operations | flash | with what it calls | frame | stack |")
        print("|---|---|---|---|---|---|---|")
        for system in systems:
            model = compile(derive(load(system).scene(), "free_body"), compiler=None)
            with tempfile.TemporaryDirectory(prefix="mechanics-") as folder:
                found = measured(model, Path(folder), bool(inline))
            print("\n".join(rows(system, found)))
            said = found.selftest.partition(": ")[2]
            verdicts.append(f"self-test of {system} in QEMU, {title}: {said}")
        print()
    print(*verdicts, sep="\n")


if __name__ == "__main__":
    main()

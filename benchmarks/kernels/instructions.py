"""Instructions of one pass of the vector loop of a batch kernel, as the compiler writes it.

    python -m benchmarks.kernels.instructions

The loop is the one with most instructions on the widest registers that holds no other. A load is an
instruction that reads memory, a store one that writes it; those of the stack are spills. Where
llvm-mca is installed, its cycles for a pass too: as results wait for each other, and by the busiest
part of a Skylake with AVX-512 alone.
"""

import re
import shutil
import subprocess
import tempfile
from collections import Counter
from pathlib import Path

import numpy as np

from benchmarks.c_kernels import FOLDER
from benchmarks.kernels.case import model
from mechanics.compiled.machine.batch import library_source
from mechanics.compiled.machine.library import find_compiler
from mechanics.compiled.machine.vectorised import settings
from mechanics.errors import CompilerError

LABEL = re.compile(r"^(\.L\w+|\w+):")
JUMP = re.compile(r"^\s+j\w+\s+(\.L\w+)")
NAMES = ("instructions", "divisions", "multiply, add", "loads", "stores", "spilled")
CYCLES, PASSES = ("cycles, chained", "cycles, throughput"), 100
ARITHMETIC = re.compile(r"v(fn?m|mul|add|sub)\w*pd")


def vector_loop(text: str, compiler: str, flags: str) -> list[str]:
    """Instructions of the loop with the most of them on the widest registers."""
    with tempfile.TemporaryDirectory(prefix="mechanics-") as folder:
        source, out = Path(folder) / "code.c", Path(folder) / "code.s"
        source.write_text(text, encoding="ascii")
        command = [compiler, *flags.split(), "-fPIC", "-S", str(source), "-o", str(out)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode:
            raise CompilerError(f"{compiler} failed: {done.stderr.strip()}")
        lines = out.read_text(encoding="utf-8").splitlines()
    labels = {found[1]: i for i, line in enumerate(lines) if (found := LABEL.match(line))}
    loops = [(labels[found[1]], i) for i, line in enumerate(lines)
             if (found := JUMP.match(line)) and labels.get(found[1], i) < i]  # fmt: skip
    inner = [(a, b) for a, b in loops if not any(a <= c and d < b for c, d in loops)]
    bodies = [[x.strip() for x in lines[a : b + 1] if x.startswith("\t") and x[1] != "."]
              for a, b in inner]  # fmt: skip
    widest = next(name for name in ("zmm", "ymm", "xmm") if any(name in x for x in lines))
    return max(bodies, key=lambda body: sum(widest in x for x in body))


def counted(loop: list[str]) -> Counter[str]:
    """Instructions by what they do."""
    found: Counter[str] = Counter()
    for line in loop:
        name, _, operands = line.partition("\t")
        found["instructions"] += 1
        found["divisions"] += name.startswith("vdiv")
        found["multiply, add"] += bool(ARITHMETIC.match(name))
        if "(" in operands and not name.startswith("lea"):
            # In AT&T's order the destination is the last operand.
            written = operands.rstrip().endswith(")")
            found["stores" if written and name.startswith("vmov") else "loads"] += 1
            found["spilled"] += "(%rsp)" in operands or "(%rbp)" in operands
    return found


def cycles(loop: list[str]) -> tuple[str, str]:
    """A pass by llvm-mca, with and without waiting for results; empty where it is not installed."""
    if shutil.which("llvm-mca") is None:
        return "", ""
    text = "\n".join(line for line in loop if not line.startswith("j")) + "\n"
    command = ["llvm-mca", "-mcpu=skylake-avx512", f"-iterations={PASSES}"]
    told = subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout
    found = dict(re.findall(r"^(Total Cycles|Block RThroughput): +(\S+)", told, re.MULTILINE))
    return f"{int(found['Total Cycles']) / PASSES:.0f}", f"{float(found['Block RThroughput']):.0f}"


def main() -> None:
    """Print a row for each kernel."""
    compiler = find_compiler()
    if compiler is None:
        raise CompilerError("no C compiler: set CC to one")
    flags = f"{settings(compiler)} -fopenmp-simd"
    print(f"{compiler} {flags}\n")
    heads = ("kernel", *NAMES, *CYCLES)
    print(f"| {' | '.join(heads)} |\n{'|---' * len(heads)}|")
    for links in (1, 5):
        chain = model(links)
        code = chain.program("forward_dynamics")
        by_hand = (FOLDER / "chain_lanes.c").read_text(encoding="utf-8")
        other = "chain_5_lanes" if links == 1 else "chain_1_lanes"
        kernels = {
            "generated": library_source(code, chain.entries, np.float64),
            # The other function is no loop that counts.
            "by hand": by_hand.replace(f"void {other}", f"static inline void {other}"),
        }
        for name, text in kernels.items():
            loop = vector_loop(text, compiler, flags)
            found = counted(loop)
            cells = " | ".join([*(str(found[key]) for key in NAMES), *cycles(loop)])
            print(f"| {links} links, {name} | {cells} |", flush=True)


if __name__ == "__main__":
    main()

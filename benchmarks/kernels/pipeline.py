"""From nothing to proved C: `mechanics codegen elastic_pendulum` in a process of its own.

The command derives, generates, proves the text, compiles it with every compiler that is found and
measures the binaries; all of that is in its evidence.
"""

import subprocess
import sys
import tempfile
from statistics import median
from time import perf_counter

COMMAND = """
import sys
from time import perf_counter
from mechanics.cli import main
start = perf_counter()
try:
    main()
finally:
    print(perf_counter() - start, file=sys.stderr)
"""


def seconds(rounds: int) -> tuple[float, float]:
    """Median wall time of the work, and of the whole process with the interpreter's start."""
    work, whole = [], []
    for _ in range(rounds):
        with tempfile.TemporaryDirectory(prefix="mechanics-") as folder:
            words = ["codegen", "elastic_pendulum", "-o", f"{folder}/c"]
            start = perf_counter()
            done = subprocess.run(
                [sys.executable, "-c", COMMAND, *words], check=True, capture_output=True, text=True
            )
            whole.append(perf_counter() - start)
            work.append(float(done.stderr.split()[-1]))
    return median(work), median(whole)

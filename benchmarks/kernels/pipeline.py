"""From nothing to proved C: `mechanics codegen elastic_pendulum`, the interpreter's start included.

The command derives, generates, proves the text, compiles it with every compiler that is found and
measures the binaries; all of that is in its evidence.
"""

import subprocess
import sys
import tempfile
from statistics import median
from time import perf_counter

COMMAND = "from mechanics.cli import main; main()"


def seconds(rounds: int) -> float:
    """Median wall time of the command, each time into a new folder."""
    found = []
    for _ in range(rounds):
        with tempfile.TemporaryDirectory(prefix="mechanics-") as folder:
            words = ["codegen", "elastic_pendulum", "-o", f"{folder}/c"]
            start = perf_counter()
            subprocess.run([sys.executable, "-c", COMMAND, *words], check=True, capture_output=True)
            found.append(perf_counter() - start)
    return median(found)

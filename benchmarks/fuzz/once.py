"""One input in a process of its own: ``python -m benchmarks.fuzz.once latex FILE``.

Time and memory are those of the readers alone, without the fuzzer's instruments.
"""

import json
import sys
from dataclasses import asdict
from pathlib import Path

from benchmarks.fuzz import law
from mechanics.judge.check import derived
from systems import elastic_pendulum


def main() -> None:
    """Print the outcome as JSON; exit code 1 where the law is broken."""
    notation, file = sys.argv[1:]
    truth = derived(elastic_pendulum.scene())
    # What is loaded and remembered at the first use is not the input's.
    law.outcome(truth, "latex", rb"\ddot{x} = \frac{L}{2} \sin\theta")
    found = law.outcome(truth, notation, Path(file).read_bytes())
    words = found.broken or law.over(found)
    print(json.dumps({**asdict(found), "breaks": words}))
    raise SystemExit(1 if words else 0)


if __name__ == "__main__":
    main()

"""``python -m benchmarks.fuzz --minutes 30``: every notation for its share of the time.

Prints executions, coverage, what became of the inputs and what breaks the law; each finding is
measured once more in a process of its own. Exit code 1 where one is left, with the
file of its input: it belongs into the corpus, with a word on what it is.
"""

import argparse
import json
import re
import subprocess
import sys
import tempfile
import time
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

from benchmarks.fuzz import corpus

ROUND = 600.0
"""Seconds of a process: what caches gather in it is given back."""

STATUS = re.compile(rb"#(\d+)\s.*?cov: (\d+) ft: (\d+) corp: (\d+)")


@dataclass
class Tally:
    """What became of a notation."""

    executions: int = 0
    seconds: float = 0.0
    coverage: int = 0
    features: int = 0
    kinds: Counter[str] = field(default_factory=Counter)
    findings: dict[str, str] = field(default_factory=dict)


def main() -> None:
    """Parse the options, run, print."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.fuzz", description=__doc__)
    parser.add_argument("--minutes", type=float, default=3.0, help="in all")
    parser.add_argument("--notation", nargs="+", choices=corpus.NOTATIONS,
                        default=list(corpus.NOTATIONS))  # fmt: skip
    parser.add_argument("--work", type=Path, help="folder for what is found; a new one by default")
    options = parser.parse_args()
    work = options.work or Path(tempfile.mkdtemp(prefix="fuzz_"))
    tallies = {name: Tally() for name in options.notation}
    share = options.minutes * 60 / len(tallies)
    for name, tally in tallies.items():
        folder = work / name
        (folder / "corpus").mkdir(parents=True, exist_ok=True)
        _seed(name, folder / "corpus")
        while (left := share - tally.seconds) > 1:
            _round(name, folder, min(ROUND, left), tally)
        _show(name, tally)
    print(f"in {work}")
    raise SystemExit(1 if any(tally.findings for tally in tallies.values()) else 0)


def _seed(notation: str, folder: Path) -> None:
    for number, entry in enumerate(corpus.load(notation)):
        (folder / f"seed_{number}").write_bytes(entry.data)


def _round(notation: str, folder: Path, seconds: float, tally: Tally) -> None:
    """One process of the fuzzer, and its findings measured once more."""
    for name in ("found.jsonl", "state.json", "now"):
        (folder / name).unlink(missing_ok=True)
    start = time.monotonic()
    command = [
        sys.executable, "-m", "benchmarks.fuzz.target", notation, str(folder),
        str(folder / "corpus"), f"-max_total_time={seconds:.0f}", "-max_len=4096", "-timeout=600",
        "-rss_limit_mb=0", "-print_final_stats=0", "-reload=0", f"-artifact_prefix={folder}/",
    ]  # fmt: skip
    done = subprocess.run(command, capture_output=True, check=False)
    tally.seconds += time.monotonic() - start
    status = STATUS.findall(done.stderr)
    if not (status or (folder / "now").exists()):
        raise SystemExit(done.stderr.decode(errors="replace")[-2000:])
    # A process that ends among its seeds has no status yet: its input is measured like any other.
    count, coverage, features, _ = (int(x) for x in (status or [(0, 0, 0, 0)])[-1])
    tally.executions += count
    tally.coverage, tally.features = max(tally.coverage, coverage), max(tally.features, features)
    state = folder / "state.json"
    if state.exists():
        tally.kinds.update(json.loads(state.read_text(encoding="utf-8")))
    found = folder / "found.jsonl"
    if found.exists():
        for line in found.read_text(encoding="utf-8").splitlines():
            entry = json.loads(line)
            data = entry["input"].encode("utf-8", "surrogateescape")
            _confirm(notation, folder, entry["why"], data, tally)
    if done.returncode:
        log = folder / f"died_{len(tally.findings)}.log"
        log.write_bytes(done.stderr[-20_000:])
        _confirm(notation, folder, "the process ended", (folder / "now").read_bytes(), tally)


def _confirm(notation: str, folder: Path, why: str, data: bytes, tally: Tally) -> None:
    """Measure a finding without instruments; what is none then is left out."""
    file = folder / f"finding_{len(list(folder.glob('finding_*')))}"
    file.write_bytes(data)
    command = [sys.executable, "-m", "benchmarks.fuzz.once", notation, str(file)]
    try:
        done = subprocess.run(command, capture_output=True, check=False, timeout=300)
    except subprocess.TimeoutExpired:
        tally.findings[str(file)] = f"{why}: over 300 s"
        return
    if done.returncode == 0:
        file.unlink()
        return
    words = json.loads(done.stdout)["breaks"] if done.stdout else done.stderr.decode()[-200:]
    tally.findings[str(file)] = words


def _show(notation: str, tally: Tally) -> None:
    kinds = ", ".join(f"{name} {count}" for name, count in tally.kinds.most_common())
    rate = tally.executions / max(tally.seconds, 1e-9)
    print(
        f"{notation:6} {tally.executions} executions in {tally.seconds / 60:.1f} min"
        f" ({rate:.0f}/s), {tally.coverage} edges, {tally.features} features; {kinds}"
    )
    for file, words in tally.findings.items():
        print(f"  FINDING {words}: {file}")
    print(f"  {len(tally.findings)} findings", flush=True)


if __name__ == "__main__":
    main()

"""Figures of the corpus, then what falls short.

python -m benchmarks.corpus [--sealed] [--only NAME] [--processes N]
"""

import argparse
from collections.abc import Iterator, Sequence
from statistics import median

from benchmarks.corpus.load import cases, sealed
from benchmarks.corpus.trial import Trial, tried_all
from benchmarks.workers import add_options, spread_alone, team

SHOWN = ("PROVED", "CERTIFIED")


def main() -> None:
    """Parse the options, judge, print; exit code 1 where a verdict is false."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.corpus", description=__doc__)
    parser.add_argument("--sealed", action="store_true", help="the part that was set aside")
    parser.add_argument("--only", default="", help="cases whose names hold this")
    parser.add_argument("--quiet", action="store_true", help="figures only")
    add_options(parser)
    options = parser.parse_args()
    trials, again = [], []
    parts: dict[str, list[str]] = {}
    for case in sealed() if options.sealed else cases():
        if options.only in case.name:
            parts.setdefault(case.source, []).append(case.name)
    with team(options) as some:
        for one, more in spread_alone(some, tried_all, parts.values(), options.sealed):
            trials += one
            again += more
    print("\n".join(figures(trials, again)))
    if not options.quiet:
        print()
        for trial in trials:
            if words := short(trial):
                print(f"{trial.case.name}: {words}: {trial.words[:160]}")
    raise SystemExit(1 if any(map(false, trials)) else 0)


def false(trial: Trial) -> bool:
    """Whether a wrong statement is PROVED, or a right one REFUTED."""
    return trial.verdict == "REFUTED" if trial.case.right else trial.verdict in SHOWN


def short(trial: Trial) -> str:
    """In which way an answer falls short; empty where it does not."""
    if false(trial):
        return "FALSE " + ("REFUTED" if trial.case.right else trial.verdict)
    if trial.case.right:
        return "" if trial.verdict in SHOWN else f"right, {trial.verdict}"
    if trial.verdict != "REFUTED":
        return f"wrong, {trial.verdict}"
    return "" if trial.named == 1 else f"mistake named at place {trial.named}"


def figures(trials: Sequence[Trial], again: Sequence[Trial]) -> Iterator[str]:
    """The table of figures and aims."""
    right = [t for t in trials if t.case.right]
    wrong = [t for t in trials if not t.case.right]
    single = [t for t in again if len(t.case.options) == 1]  # it may be given several times
    helped = [t for t in single if t.case.right and t.verdict in SHOWN]
    shown = [t for t in right if t.verdict in SHOWN]
    sources = len({t.case.source for t in trials})
    yield f"{len(trials)} statements of {sources} sources: {len(right)} right, {len(wrong)} wrong"
    yield f"| wrong, PROVED | {sum(map(false, wrong))} | 0 |"
    yield f"| right, REFUTED | {sum(map(false, right))} | 0 |"
    refuted = [t for t in wrong if t.verdict == "REFUTED"]
    yield f"| wrong, REFUTED without an option | {_share(refuted, wrong)} | 95 % |"
    maybe = [t for t in wrong if t.verdict == "UNDECIDED" and "right if" in t.words]
    yield f"| wrong, answered 'right if' | {_share(maybe, wrong)} | at most 3 % |"
    yield f"| right, PROVED or CERTIFIED without an option | {_share(shown, right)} | 85 % |"
    more = [t for t in helped if t.case not in [s.case for s in shown]]
    yield f"| ... with at most one option | {_share([*shown, *more], right)} | 97 % |"
    first = [t for t in wrong if t.named == 1]
    yield f"| the true mistake named first | {_share(first, wrong)} | 85 % |"
    within = [t for t in wrong if t.named]
    yield f"| ... within three | {_share(within, wrong)} | 95 % |"
    if trials:
        yield f"| a whole answer, median, s | {median(t.seconds for t in trials):.2f} | 0.5 |"


def _share(some: Sequence[Trial], of: Sequence[Trial]) -> str:
    return f"{100 * len(some) / len(of):.1f} % ({len(some)} of {len(of)})" if of else "-"


if __name__ == "__main__":
    main()

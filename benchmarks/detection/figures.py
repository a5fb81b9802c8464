"""Shares, times, and the lists of what went wrong."""

from collections.abc import Callable, Iterator, Sequence
from statistics import median

from benchmarks.detection.trial import Result

Key = Callable[[Result], Sequence[str]]


def _share(some: Sequence[Result], good: Callable[[Result], bool]) -> str:
    """A share with its counts."""
    count = sum(map(good, some))
    return f"{100 * count / len(some):.2f} % ({count} of {len(some)})" if some else "-"


def percentile(values: Sequence[float], level: float) -> float:
    """The value that so large a share does not exceed."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(level * len(ordered)))]


def times(seconds: Sequence[float]) -> str:
    """Median, 95th percentile and worst in ms."""
    if not seconds:
        return "-"
    parts = (median(seconds), percentile(seconds, 0.95), max(seconds))
    return " / ".join(f"{1e3 * part:.0f}" for part in parts)


def refuted(result: Result) -> bool:
    """Whether a wrong statement was found out."""
    return result.verdict == "REFUTED"


def shown(result: Result) -> bool:
    """Whether a right statement was shown to be right."""
    return result.verdict in ("PROVED", "CERTIFIED")


def falsely(result: Result) -> bool:
    """Whether a right statement, or one beside it, was refuted."""
    return result.verdict.startswith("REFUTED")


def told(result: Result) -> bool:
    """Whether another convention was found out and named."""
    return refuted(result) and bool(result.right_if)


def mended(result: Result) -> bool:
    """Whether the first repair undoes the mistakes."""
    return result.undone is not None and result.undone.success


def exactly(result: Result) -> bool:
    """Whether it gives the statement that the mistakes were made in."""
    return result.undone is not None and result.undone.how == "exactly"


def repaired(result: Result) -> bool:
    """Whether there is a repair."""
    return result.undone is not None and result.undone.repairs > 0


def again(result: Result) -> bool:
    """Whether the text of the first repair is right when it is read again."""
    return result.undone is not None and result.undone.again in ("PROVED", "CERTIFIED")


def supported(result: Result) -> bool:
    """Whether a right function that can only be called was found to be so, as far as that goes."""
    return result.verdict == "SUPPORTED"


WHOLE = (("k", "wrong SymPy models REFUTED", refuted), ("b", "wrong black boxes REFUTED", refuted),
         ("s", "right black boxes SUPPORTED", supported))  # fmt: skip


def summary(results: Sequence[Result]) -> Iterator[str]:
    """The figures against their goals, as Markdown."""
    wrong = [r for r in results if r.name[0] == "m"]
    right = [r for r in results if r.name[0] == "r"]
    other = [r for r in results if r.name[0] == "c"]
    blamed = [r for r in wrong if r.undone is not None]
    yield "| figure | found | goal |"
    yield "|---|---|---|"
    yield f"| wrong mutants REFUTED | {_share(wrong, refuted)} | 100 % |"
    yield f"| right rewritings falsely REFUTED | {_share(right, falsely)} | 0 |"
    yield f"| right rewritings PROVED or CERTIFIED | {_share(right, shown)} | |"
    yield f"| undeclared convention: REFUTED, 'right if ...' | {_share(other, told)} | |"
    for kind, words, good in WHOLE:
        if some := [r for r in results if r.name[0] == kind]:
            yield f"| {words} | {_share(some, good)} | 100 % |"
    for count, words, goal in ((1, "single", "99 %"), (2, "double", "90 %")):
        some = [r for r in blamed if len(r.kinds) == count]
        yield f"| {words} mistakes undone by the first edit | {_share(some, mended)} | {goal} |"
        yield f"| ... exactly | {_share(some, exactly)} | |"
    several = [r for r in blamed if len(r.kinds) > 2]
    if several:
        yield f"| more mistakes undone by the first edits | {_share(several, mended)} | |"
        yield f"| ... exactly | {_share(several, exactly)} | |"
        yield f"| ... with a proved repair | {_share(several, repaired)} | |"
    typed = [r for r in blamed if r.undone and r.undone.again]
    yield f"| text of the first edit, read again: right | {_share(typed, again)} | 100 % |"
    judged = [r.seconds for r in (*wrong, *right, *other)]
    yield f"| verdict, ms: median / 95 % / worst | {times(judged)} | 50 |"
    spent = [r.undone.seconds for r in blamed if r.undone]
    yield f"| blame, ms: median / 95 % / worst | {times(spent)} | 1000 |"
    yield ""
    drawn = [proved for r in wrong for proved in r.equivalent]
    yield f"Drawn besides, and right: {len(drawn)} mutants, {sum(drawn)} by the normal form,"
    yield f"{len(drawn) - sum(drawn)} by numbers of 256 bits alone."


def tables(results: Sequence[Result]) -> Iterator[str]:
    """By kind, by form and by system."""
    groups: tuple[tuple[str, Key], ...] = (
        ("mistake", lambda r: r.kinds), ("form", lambda r: (r.form,)),
        ("system", lambda r: (r.system,)), ("statement", lambda r: (r.about,)),
    )  # fmt: skip
    wrong = [r for r in results if r.name[0] == "m"]
    for title, key in groups:
        yield f"\n| {title} | mutants | REFUTED | single undone | double undone | verdict, ms |"
        yield "|---|---|---|---|---|---|"
        for name in sorted({name for r in wrong for name in key(r)}):
            some = [r for r in wrong if name in key(r)]
            yield f"| {name} | {len(some)} | {_percent(some, refuted)} | {_undone(some, 1)} | " + (
                f"{_undone(some, 2)} | {times([r.seconds for r in some])} |"
            )
    right = [r for r in results if r.name[0] == "r"]
    yield "\n| rewriting | statements | falsely REFUTED | PROVED or CERTIFIED | verdict ms |"
    yield "|---|---|---|---|---|"
    for name in sorted({name for r in right for name in r.kinds}):
        some = [r for r in right if name in r.kinds]
        yield (
            f"| {name} | {len(some)} | {sum(map(falsely, some))} | {_percent(some, shown)}"
            f" | {times([r.seconds for r in some])} |"
        )


def _percent(some: Sequence[Result], good: Callable[[Result], bool]) -> str:
    return f"{100 * sum(map(good, some)) / len(some):.2f} %" if some else "-"


def _undone(some: Sequence[Result], count: int) -> str:
    looked = [r for r in some if r.undone is not None and len(r.kinds) == count]
    return f"{_percent(looked, mended)} of {len(looked)}"


def missed(result: Result) -> str:
    """Why a case counts as a miss; empty where it does not."""
    if result.name[0] == "m" and not refuted(result):
        return f"wrong, but {result.verdict}"
    if result.name[0] == "r" and not shown(result):
        return f"right, but {result.verdict}"
    if result.name[0] == "c" and not told(result):
        return f"other convention, but {result.verdict} without 'right if'"
    for kind, words, good in WHOLE:
        if result.name[0] == kind and not good(result):
            return f"not among {words}, but {result.verdict}"
    if result.undone is not None and not result.undone.success:
        return f"blame: {result.undone.how}"
    if result.undone is not None and result.undone.again and not again(result):
        return f"blame: its text, read again, is {result.undone.again}"
    return ""


def line(result: Result, length: int = 160) -> str:
    """A case in one line."""
    text = " ".join(result.text.split())
    text = text if len(text) <= length else text[: length - 3] + "..."
    made = f" <{'; '.join(result.made)}>" if result.made else ""
    edits = f" [{'; '.join(result.undone.edits)}]" if result.undone else ""
    why = f" ({result.words})" if result.verdict != "REFUTED" else ""
    return (
        f"{result.name} {result.system}, {result.row}, {result.form}, {' + '.join(result.kinds)}:"
        f" {missed(result)}{why}{made}{edits}: {text}"
    )

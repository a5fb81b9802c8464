"""What became of faults, in Markdown: by fault, and by scene."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from benchmarks.faults.fault import Fault
from benchmarks.faults.plan import Plan


@dataclass(frozen=True)
class Trial:
    """What one fault did.

    Attributes
    ----------
    noticed, unnoticed, harmless : tuple of str
        Scenes in which it was planted, by what became of it; harmless where no number changed.
    by : str
        Who noticed it first.
    """

    fault: Fault
    noticed: tuple[str, ...]
    unnoticed: tuple[str, ...]
    harmless: tuple[str, ...]
    by: str


def summary(trials: Sequence[Trial], plans: Sequence[Plan] = ()) -> str:
    """Share noticed, and lists of what was not, or not planted and why, in Markdown."""
    at_work = [trial for trial in trials if trial.noticed or trial.unnoticed]
    pairs = sum(len(trial.noticed) + len(trial.unnoticed) for trial in at_work)
    seen = sum(len(trial.noticed) for trial in at_work)
    whole = sum(not trial.unnoticed for trial in at_work)
    lines = [
        f"{len(trials)} faults, of which {len(at_work)} change a number; noticed wherever they do:"
        f" {whole} of {len(at_work)}; by scene: {seen} of {pairs}.",
        "",
        "| first noticed by | faults |",
        "| --- | --- |",
    ]
    makers = Counter(_who(trial.by) for trial in at_work if trial.by)
    lines += [f"| {who} | {count} |" for who, count in makers.most_common()]
    reached = {fault.what for plan in plans for fault in plan.reached}
    idle = [t for t in trials if t not in at_work]
    absent = [t.fault.what for t in idle if not t.harmless]
    for title, rows in (
        (
            "Unnoticed",
            [f"{t.fault.what}: {', '.join(t.unnoticed)}" for t in at_work if t.unnoticed],
        ),
        ("No number changes", [t.fault.what for t in idle if t.harmless]),
        ("Not planted, for the budget leaves them out", [w for w in absent if w in reached]),
        ("Not planted, for no scene calls their code", [w for w in absent if w not in reached]),
    ):
        if rows:
            lines += ["", f"{title}:", *(f"- {row}" for row in rows)]
    return "\n".join(lines)


def _who(words: str) -> str:
    """The check without its route, or the exception."""
    for known in ("virtual power", "declared", "Error", "no end"):
        if known in words:
            return {"declared": "powers of the declared loads", "Error": "refused"}.get(
                known, known
            )
    return words.rpartition(":")[0] or words


def scenes_table(trials: Sequence[Trial], plans: Sequence[Plan]) -> str:
    """What was planted in each scene, and what became of it."""
    lines = [
        "| scene | calls without a fault, millions | faults in code that it calls | planted"
        " | change a number | noticed |",
        "| --- | --- | --- | --- | --- | --- |",
    ]
    noticed = Counter(name for trial in trials for name in trial.noticed)
    changed = noticed + Counter(name for trial in trials for name in trial.unnoticed)
    lines += [
        f"| {p.scene} | {p.calls / 1e6:.1f} | {len(p.reached)} | {len(p.planted)}"
        f" | {changed[p.scene]} | {noticed[p.scene]} |"
        for p in plans
    ]
    left = [(p.scene, len(p.reached) - len(p.planted)) for p in plans]
    words = ", ".join(f"{scene} ({count})" for scene, count in left if count)
    if words:
        lines += ["", f"Left out, for the trials would take more calls than the budget: {words}."]
    return "\n".join(lines)

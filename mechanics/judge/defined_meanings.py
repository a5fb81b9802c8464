"""Statements that use a name whose definition is not what the name means.

p_theta = m l^2/4 theta'    REFUTED        4/3 p_theta' = ...    right as defined, UNDECIDED
"""

from collections.abc import Sequence
from dataclasses import replace

from mechanics.claims.assemble import used_names
from mechanics.claims.spelled_rates import key
from mechanics.kernel import undecided
from mechanics.report.answer.judged import Judged


def as_meant(entries: Sequence[Judged]) -> tuple[Judged, ...]:
    """The entries; one that uses what is defined otherwise than it means is not shown."""
    shown = [e.finding.shown and not e.open for e in entries]
    pairs = zip(entries, shown, strict=True)
    bad = {key(e.statement.defines): e.statement.defines for e, right in pairs if not right}
    bad.pop("", None)
    return tuple(map(lambda entry: _with(entry, bad), entries)) if bad else tuple(entries)


def _with(entry: Judged, bad: dict[str, str]) -> Judged:
    used = used_names(entry.statement.written) & bad.keys()
    if not used or not entry.finding.shown or entry.statement.defines:
        return entry
    names = ", ".join(bad[one] for one in sorted(used))
    words = f"it is right with {names} as defined, which is not what that means"
    return replace(entry, finding=undecided(entry.finding.subject, words))

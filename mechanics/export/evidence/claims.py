"""What a manifest claims: made again from scene and graphs, and from what was shown just now.

A value that differs is refuted: operation counts, units, an order of entries. So is a verdict that
is better than the one that was found again, or a bound of error that is lower.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from mechanics.kernel import Finding, Verdict, refuted, same, undecided

STRENGTH = (
    Verdict.REFUTED, Verdict.UNDECIDED, Verdict.SUPPORTED, Verdict.CERTIFIED, Verdict.PROVED,
)  # fmt: skip
"""The better the later."""
LONGEST = 60
"""Characters of a value that are repeated."""
SLACK = 1 + 1e-6
"""Bounds are told as doubles."""

Steps = Sequence[tuple[str, Sequence[Finding]]]


def prove_claims(
    stored: Mapping[str, Any], again: Mapping[str, Any], physics: bool
) -> Iterator[Finding]:
    """Decide about what a manifest says of the functions.

    Parameters
    ----------
    stored : mapping
        The manifest.
    again : mapping
        What it should say, see `mechanics.export.manifest.described`.
    physics : bool
        Whether the scene was derived again; what is said of entries is taken from the manifest
        otherwise.
    """
    agree = True
    for key, right in again.items():
        for path, left, wanted in _different(key, stored.get(key), right):
            agree = False
            subject = f"manifest.json: {path}"
            if left is None or wanted is None:
                words = "it is not there" if left is None else "neither scene nor graphs have it"
                yield undecided(subject, f"refused: {words}")
            else:
                source = "scene and graphs give" if physics else "graphs give"
                words = f"{str(left)[:LONGEST]} stands there, {source} {str(wanted)[:LONGEST]}"
                yield refuted(subject, words, repr(left), repr(wanted))
    if agree:
        words = "functions, counts and entries are those of scene and graphs"
        yield same("manifest.json", {key: stored[key] for key in again}, dict(again), words)


def _different(path: str, left: Any, right: Any) -> Iterator[tuple[str, Any, Any]]:
    """Paths at which two values differ, and the values; None where one has none."""
    if isinstance(left, dict) and isinstance(right, dict):
        for key in dict.fromkeys((*left, *right)):
            yield from _different(f"{path}.{key}", left.get(key), right.get(key))
        if list(left) != list(right) and left.keys() == right.keys():
            yield f"{path}: order", ", ".join(left), ", ".join(right)
    elif isinstance(left, list) and isinstance(right, list):
        for place in range(max(len(left), len(right))):
            ends = (each[place] if place < len(each) else None for each in (left, right))
            yield from _different(f"{path}[{place}]", *ends)
    elif left != right or type(left) is not type(right):
        yield path, left, right


def prove_stored(
    stored: Mapping[str, Any], steps: Steps, elsewhere: str
) -> tuple[list[Finding], int]:
    """Decide about the verdicts that a manifest holds.

    Parameters
    ----------
    stored : mapping
        Its chain.
    steps : sequence of (str, findings)
        What was found again.
    elsewhere : str
        Title of the step whose findings are about compilers, which are other ones elsewhere.

    Returns
    -------
    list of Finding
    int
        Number of stored findings about compilers that were not asked again.
    """
    known = {finding.subject: finding for _, findings in steps for finding in findings}
    found: list[Finding] = []
    compilers, held = 0, list[tuple[str, str]]()
    for step in stored.get("steps", ()):
        for record in step["findings"]:
            subject, verdict = str(record["subject"]), Verdict[str(record["verdict"])]
            if subject in known:
                weaker = min(verdict, known[subject].verdict, key=STRENGTH.index)
                held.append((verdict.name, weaker.name))
                found += _compared(known[subject], verdict, record.get("error_bound"))
            elif step["step"] == elsewhere:
                compilers += 1
            elif verdict not in (Verdict.REFUTED, Verdict.UNDECIDED):
                words = f"refused: {verdict.name} stands there, and no step decides about it"
                found.append(undecided(f"manifest.json: {subject}", words))
    if held and not found:
        words = f"{len(held)} verdicts are none better than those found again"
        stands, weaker_ones = zip(*held, strict=True)
        found.append(same("manifest.json: chain", stands, weaker_ones, words))
    return found, compilers


def _compared(again: Finding, verdict: Verdict, bound: Any) -> Iterator[Finding]:
    subject = f"manifest.json: {again.subject}"
    words = f"{verdict.name} stands there, it is {again.verdict.name}"
    if STRENGTH.index(verdict) > STRENGTH.index(again.verdict):
        yield refuted(subject, words, verdict.name, again.verdict.name)
    elif verdict is Verdict.REFUTED and again.verdict is not Verdict.REFUTED:
        yield undecided(subject, f"refused: {words}, and what is REFUTED is not written")
    elif verdict is again.verdict and again.error_bound is not None:
        lower = not isinstance(bound, float) or bound * SLACK < again.error_bound
        told = f"{bound} stands there as a bound of error, it is {again.error_bound:.3g}"
        ends = str(bound), str(again.error_bound)
        yield from [refuted(subject, told, *ends)] if lower else []

"""Verdicts, bounds and durations in words and signs; a verdict is never shown by colour alone."""

from collections import Counter
from collections.abc import Iterable
from math import floor, log2

from markupsafe import Markup

from mechanics.kernel import Finding, Verdict
from mechanics.report.result import SystemResult

SIGNS = {
    Verdict.PROVED: "✓",
    Verdict.CERTIFIED: "✓",
    Verdict.SUPPORTED: "≈",
    Verdict.REFUTED: "✗",
    Verdict.UNDECIDED: "?",
}

LEGEND = {
    Verdict.PROVED: (
        "correct for all states and values",
        "both sides have the same normal form; a rounded number is within half a unit of its last"
        " digit",
    ),
    Verdict.CERTIFIED: (
        "correct, with the error probability that is shown",
        "both sides are equal at random points of a finite field",
    ),
    Verdict.SUPPORTED: (
        "correct at the states that were tried",
        "supported by numbers only; nothing is proved",
    ),
    Verdict.REFUTED: (
        "wrong",
        "at the state that is shown the two sides differ by more than rounding explains: their"
        " enclosures are disjoint",
    ),
    Verdict.UNDECIDED: (
        "neither proved nor refuted",
        "the reason is given with it",
    ),
}
"""What each verdict means, and how it is known."""


def chip(verdict: Verdict) -> Markup:
    """A verdict as a sign and a word."""
    word = verdict.name.lower()
    return Markup(
        '<span class="chip {}" title="{}"><span aria-hidden="true">{}</span> {}</span>'
    ).format(word, verdict.value, SIGNS[verdict], word)


def bound(finding: Finding) -> Markup:
    """The chance that a certified statement is false all the same, as a power of two."""
    if finding.error_bound is None:
        return Markup("")
    if finding.error_bound <= 0:
        return Markup('<span class="bound"><span>error</span> &lt; 2<sup>\u22121022</sup></span>')
    # Rounded upwards, so that what is printed is a bound, too.
    power = -floor(-log2(finding.error_bound))
    return Markup('<span class="bound"><span>error</span> &lt; 2<sup>{}</sup></span>').format(
        str(power).replace("-", "\u2212")
    )


def duration(seconds: float) -> str:
    """A duration with two digits."""
    if seconds < 0.9995:
        return f"{1000 * seconds:.2g} ms" if seconds < 0.0995 else f"{1000 * seconds:.0f} ms"
    return f"{seconds:.1f} s"


def ratio(value: float | None) -> str:
    """A residual ratio with two decimals, or as a power of ten where it is large."""
    if value is None:
        return ""
    return f"{value:.2f}" if value < 1000 else f"{value:.1e}"


def count(number: int, noun: str) -> str:
    """A number with its noun."""
    return f"{number:,} {noun}{'' if number == 1 else 's'}".replace(",", "\u202f")


def tally(verdicts: Iterable[Verdict]) -> list[tuple[Verdict, int]]:
    """How often each verdict occurs, the worst last."""
    found = Counter(verdicts)
    return [(verdict, found[verdict]) for verdict in Verdict if found[verdict]]


def all_findings(result: SystemResult) -> list[Finding]:
    """Findings and published rows of a system."""
    return [*result.findings, *(row.finding for row in result.published)]

"""What a verdict means, in words for somebody who knows mechanics and not this program.

REFUTED     at this state the left side is 2.6 and the right side 1.3: they differ
CERTIFIED   equal at random points of a finite field; the chance of a wrong verdict is below 2^-90
"""

import re
from math import ceil, log2

from mechanics.kernel import Finding, Verdict

SEEMING = re.compile(
    r"not zero in a field of \d+ bits, but none of the real states tried tells the sides apart"
    r" \((?P<why>.*)\)"
)
OPAQUE = re.compile(r"known by congruence only: (?P<names>[^()]*)")


def meaning(finding: Finding) -> tuple[str, str]:
    """What was found in plain words, and how it is known in the words of the arithmetic."""
    evidence = finding.evidence
    if finding.verdict is Verdict.CERTIFIED and finding.error_bound is not None:
        power = ceil(log2(finding.error_bound)) if finding.error_bound > 0 else -1000
        plain = (
            "equal at random points of a finite field; the chance of a wrong verdict is below"
            f" 2^{power}"
        )
        return plain, evidence.replace(f"; chance of error below 2^{power}", "")
    seeming = SEEMING.search(evidence)
    if finding.verdict is Verdict.UNDECIDED and seeming:
        opaque = OPAQUE.search(seeming["why"])
        because = f", because it holds {opaque['names']}" if opaque else ""
        seems = "the two sides seem to differ, but none of the states tried shows that they do"
        return f"{seems}{because}", evidence
    return evidence, ""


def headline(finding: Finding, verdict: Verdict) -> str:
    """The verdict, and where it holds: ``PROVED except where cos(theta) = 0``.

    Parameters
    ----------
    finding : Finding
    verdict : Verdict
        Of the statement: another reading of what the finding refutes may be right.
    """
    if verdict is not finding.verdict:
        return verdict.name
    if not finding.domain or finding.undefined:
        return finding.verdict.name
    if not finding.shown:
        return finding.domain
    between = " " if finding.domain.startswith("except") else ", "
    return f"{finding.verdict.name}{between}{finding.domain}"


def difference(sides: tuple[str, str], values: tuple[str, str]) -> str:
    """The two values at a witness as a sentence."""
    one, two = values
    if sides == ("left", "right"):
        return f"at this state the left side is {one} and the right side {two}: they differ"
    return f"at this state {one} is {sides[0]} and {two} {sides[1]}: they differ"

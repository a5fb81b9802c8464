"""The kernel: the only maker of verdicts.

Statement --> decide --> Finding
"""

from mechanics.kernel.balls import enclose
from mechanics.kernel.decide import decide, follows, undecided
from mechanics.kernel.finding import Finding, Verdict, Witness
from mechanics.kernel.statement import Range, Statement

__all__ = [
    "Finding",
    "Range",
    "Statement",
    "Verdict",
    "Witness",
    "decide",
    "enclose",
    "follows",
    "undecided",
]

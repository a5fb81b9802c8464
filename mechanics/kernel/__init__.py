"""The kernel: the only maker of verdicts.

Statement --> decide --> Finding
"""

from mechanics.kernel.balls import enclose
from mechanics.kernel.decide import decide
from mechanics.kernel.finding import (
    Finding,
    Verdict,
    Witness,
    enclosed,
    follows,
    refuted,
    same,
    supported,
    undecided,
)
from mechanics.kernel.statement import Range, Statement

__all__ = [
    "Finding",
    "Range",
    "Statement",
    "Verdict",
    "Witness",
    "decide",
    "enclose",
    "enclosed",
    "follows",
    "refuted",
    "same",
    "supported",
    "undecided",
]

"""The kernel: the only maker of verdicts.

Statement --> decide --> Finding

A verdict runs this folder, 5,200 lines of which 3,400 are code, and of `program` the builder, the
programs, their interpreter and the table of operations: 1,400 lines, 1,000 of them code. The aim
was 4,000 lines. Deciding equality takes 3,400 lines here, being defined 1,400 (signs, states,
cases, gaps), constraints 350. What could still be one is the arithmetic of quotients: `quotients`
keeps denominators in factors, for the normal form, `signs` keeps them whole, to factor them.
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

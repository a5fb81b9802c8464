"""The kernel: the only maker of verdicts.

Statement --> decide --> Finding

A verdict runs 3,999 lines of code, that of `program` counted too, of 6,389: the rest are
docstrings, comments and blanks. A test keeps them from growing beyond 4,000:

    statements, findings, decisions, errors     statement, finding, decide, canaries         615
    the field and its error bound               trial, sizes, field, primes, draws         1,063
    sines and roots, rewritten                  angles, squares                              511
    the normal form                             ring, quotients, radicals, normal            740
    balls and witnesses                         balls, witness                               364
    points on constraints                       constraints                                  424
    where it is defined                         definedness, signs, numbers, conjugates,
                                                states                                     1,323
    the language                                program: its builder, programs, table of
                                                operations, interpreter                    1,277

Equality takes 2,680 lines, constraints 420, being defined 1,320, the language 1,280. One way to
show equality would be enough, and each of the three knows what the others do not: the field takes
statements of any size, the normal form needs no chance, balls refute. The normal form and signs
share a ring; their fractions are two: `quotients` keeps denominators in factors and looks for no
common divisor, which pays for equality; `signs` multiplies them out and gives up node by node,
since it has to factor what it asks the sign of.
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

"""The kernel: the only maker of verdicts.

Statement --> decide --> Finding

The aim was that a verdict runs at most 4,000 lines, what it runs of `program` counted too. It runs
7,023; a test keeps them from growing:

    statements, findings, decisions, errors     statement, finding, decide, canaries         638
    the field and its error bound               trial, sizes, field, primes, draws         1,106
    sines and roots, rewritten                  angles, squares                            616
    the normal form                             ring, quotients, radicals, normal            756
    balls and witnesses                         balls, witness                               343
    points on constraints                       constraints, independence                    472
    where it is defined                         definedness, signs, numbers, conjugates,
                                                states                                     1,466
    the language                                program: its builder, programs, table of
                                                operations, interpreter, derivatives       1,571

Equality takes 2,800 lines, constraints 500, being defined 1,500, the language 1,600. One way to
show equality would be enough, and each of the three knows what the others do not: the field takes
statements of any size, the normal form needs no chance, balls refute. What could still be one is
the arithmetic of quotients: `quotients` keeps denominators in factors and looks for no common
divisor, which pays for equality; `signs` multiplies them out and gives up node by node, since it
has to factor what it asks the sign of.
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

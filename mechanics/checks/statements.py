"""Statements about nodes of a mechanism, for the kernel to decide."""

from collections.abc import Mapping, Sequence

from mechanics.closure import Closure
from mechanics.kernel import Finding, Statement, decide, follows
from mechanics.kernel.statement import RATES, ZERO
from mechanics.mechanism import Mechanism, ranges
from mechanics.program.builder import Node

LARGEST_PROOF = 1500
"""Operations up to which a normal form is tried: beyond, it outgrows its limit anyway."""

Shown = Mapping[str, Sequence[Node]]


def equal(
    subject: str,
    mechanism: Mechanism,
    left: Sequence[Node],
    right: Sequence[Node | int],
    shown: Shown | None = None,
    closure: Closure | None = None,
) -> Finding:
    """Whether nodes of a mechanism are equal, entry by entry, wherever its constraints hold.

    What is equal at all states is so on every component; what is not is looked at on that of the
    scene's example.

    Parameters
    ----------
    subject : str
        In words.
    left, right : sequences of equal length
    shown : mapping of str to sequence of Node, optional
        What else a witness shows: accelerations, reactions.
    closure : Closure, optional
        Some of the constraints, where these suffice.
    """
    outputs: dict[str, Sequence[Node | int]] = {"left": left, "right": right, **(shown or {})}
    pays = mechanism.builder.program(outputs).count <= LARGEST_PROOF
    closure = closure or mechanism.closure
    if closure:
        outputs |= {ZERO: closure.configuration, RATES: closure.rates}
    program = mechanism.builder.program(outputs)
    statement = Statement(subject, program, ranges(mechanism), closure.start, closure.dependent)
    return decide(statement, try_normal=pays)


def each_or_all(
    whole: str,
    subjects: Sequence[str],
    mechanism: Mechanism,
    sides: Sequence[tuple[Sequence[Node], Sequence[Node | int]]],
) -> list[Finding]:
    """Statements decided together where all of them hold, one by one where there is a doubt."""
    if not subjects:
        return []
    left = [entry for one, _ in sides for entry in one]
    right = [entry for _, other in sides for entry in other]
    together = equal(whole, mechanism, left, right)
    if together.shown:
        return [follows(subject, [together]) for subject in subjects]
    return [
        equal(subject, mechanism, one, other)
        for subject, (one, other) in zip(subjects, sides, strict=True)
    ]

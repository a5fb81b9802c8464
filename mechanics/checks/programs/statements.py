"""Statements about nodes of a mechanism, for the kernel to decide."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from mechanics.kernel import Finding, Range, Statement, decide
from mechanics.mechanism import Mechanism
from mechanics.program.builder import Node

Shown = Mapping[str, Sequence[Node]]


def equal(
    subject: str,
    mechanism: Mechanism,
    left: Sequence[Node],
    right: Sequence[Node | int],
    shown: Shown | None = None,
) -> Finding:
    """Whether nodes of a mechanism are equal, entry by entry.

    Parameters
    ----------
    subject : str
        In words.
    left, right : sequences of equal length
    shown : mapping of str to sequence of Node, optional
        What else a witness shows: accelerations, reactions.
    """
    outputs: dict[str, Sequence[Node | int]] = {"left": left, "right": right, **(shown or {})}
    program = mechanism.builder.program(outputs)
    return decide(Statement(subject, program, ranges(mechanism)))


def ranges(mechanism: Mechanism) -> dict[str, Range]:
    """What the scene declares of the inputs, as the kernel takes it."""
    words = {"positive": Range.POSITIVE, "nonnegative": Range.NONNEGATIVE}
    return {name: words[sign] for name, sign in mechanism.signs.items()}

"""Constraints that were forgotten: every coordinate treated as free.

M u' = f        in place of        M u' = f + A^T lambda,  A u' = b
"""

from collections.abc import Iterator

from mechanics.blame.mistakes.fault_model import Fault, Right
from mechanics.blame.pieces import Kind


def faults(right: Right) -> Iterator[Fault]:
    """Without the constraints and without what maintains them."""
    scene = right.scene
    if right.free or not scene.constraints:
        return
    names = ", ".join(constraint.name for constraint in scene.constraints)
    rows = tuple(
        tuple(part for part in row if part[1].origin.kind is not Kind.REACTION)
        for row in right.rows
    )
    yield Fault(
        f"coordinates treated as free that {names} ties together", rows, scene.ud, held=False
    )

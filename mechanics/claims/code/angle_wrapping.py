"""Steps that bring an angle back into one turn: the angle is the same.

theta + dt*omega,  then  wrapToPi(theta)  or  (theta + pi) % (2*pi) - pi      theta + dt*omega
"""

from dataclasses import replace

from sympy import Add, Expr, Symbol, floor, pi

from mechanics.claims.code.integrators import STEP
from mechanics.claims.code.trace.tracing import Outputs
from mechanics.claims.kinds import turning
from mechanics.scene import Scene

NOTE = "brought back into one turn: read as the same angle"


def with_unwrapped_angles(scene: Scene, outputs: Outputs) -> Outputs:
    """The outputs of a step, where an angle in one turn is the angle itself."""
    entries = outputs.entries
    if not any(entry.has(floor) for entry in entries):
        return outputs
    angles = turning(scene)
    if len(entries) != len(scene.q) + len(scene.u):
        return outputs
    unwrapped = {e: angle for e in entries if (angle := _unwrapped(e, angles)) is not None}
    if not unwrapped:
        return outputs
    values = tuple(
        value.applyfunc(lambda entry: unwrapped.get(entry, entry)) for value in outputs.values
    )
    names = ", ".join(sorted(str(angle.subs(STEP, 0)) for angle in unwrapped.values()))
    return replace(outputs, values=values, notes=(*outputs.notes, f"{names} {NOTE}"))


def _unwrapped(entry: Expr, angles: frozenset[Symbol]) -> Expr | None:
    """The entry without whole turns, 2 pi floor(...), where it is an angle before the step."""
    turns = [part for part in Add.make_args(entry) if _is_turns(part)]
    angle = entry - Add(*turns)
    return angle if turns and angle.subs(STEP, 0) in angles else None


def _is_turns(part: Expr) -> bool:
    number, factors = part.as_independent(floor, as_Add=False)
    return isinstance(factors, floor) and bool((number / (2 * pi)).is_integer)

"""What may be left out: parameters, entries, couplings, summands, products of speeds."""

from collections.abc import Collection, Sequence

from mechanics.program import Program
from mechanics.program import operations as op
from mechanics.reduce.edits import Edit, Kind


def candidates(
    program: Program, speeds: Collection[str], numbers: Collection[str], couplings: Sequence[int]
) -> tuple[Edit, ...]:
    """Edits of a program, each of one node.

    Parameters
    ----------
    speeds : collection of str
        Inputs of which products are Coriolis and centrifugal terms.
    numbers : collection of str
        Parameters.
    couplings : sequence of int
        Nodes that are entries of the mass matrix beside its diagonal.
    """
    found: list[Edit] = []
    whole = {*program.roots, *couplings}
    moving = bytearray(len(program))
    fast = bytearray(len(program))
    for number, code in enumerate(program.operations):
        operands = program.operands_of(number)
        if code == op.INPUT:
            # An output that is an input costs nothing.
            name = program.inputs[program.operands[0][number]]
            moving[number], fast[number] = name not in numbers, name in speeds
            if name in numbers:
                found.append(Edit(number, Kind.ZERO))
            continue
        moving[number] = any(moving[k] for k in operands)
        fast[number] = any(fast[k] for k in operands)
        if not moving[number]:
            continue
        if number in whole or (code == op.MULTIPLY and all(fast[k] for k in operands)):
            found.append(Edit(number, Kind.ZERO))
        if code in (op.ADD, op.SUBTRACT):
            found += [Edit(number, Kind.FIRST), Edit(number, Kind.SECOND)]
        elif code == op.SIN:
            found.append(Edit(number, Kind.ANGLE))
        elif code == op.COS:
            found.append(Edit(number, Kind.ONE))
    return tuple(found)
